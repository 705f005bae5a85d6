// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How bright a mean of unit normals is, by its length, which tells whether they agree: where a
// patch of normals that point outward meets one that points inward they cancel, and a mesh of
// these points is dark.

// The mean of unit normals that stand 53 degrees off it: any crease keeps its light.
const float FullAgreement = 0.6;

float agreementOf(float meanLength)
{
  return clamp(meanLength / FullAgreement, 0.0, 1.0);
}
