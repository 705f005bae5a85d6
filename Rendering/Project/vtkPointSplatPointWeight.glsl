// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The weight of a point among others of its pixel. Points are spread evenly over the surface,
// pixels over its image: by the image's measure points seen at a flat angle would weigh as much
// less as their facing is, and at silhouettes they would else darken the mean; but where the
// surface is rough, a mesh's normals are interpolated from the points as they are. The root of the
// facing serves both.
float pointWeight(Splat q)
{
  return sqrt(min(q.facing, 1.0));
}
