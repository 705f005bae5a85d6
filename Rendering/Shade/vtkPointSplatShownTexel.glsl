// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which of a layer's texels are presented.

uniform int OnlySlot; // of the cloud that is; -1: of all

bool isShown(uvec4 texel)
{
  return !isEmpty(texel) && (OnlySlot < 0 || int(tagOfTexel(texel) >> 1) == OnlySlot);
}
