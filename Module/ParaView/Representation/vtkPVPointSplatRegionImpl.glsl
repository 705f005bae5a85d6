// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
  vec4 regionPoint = vec4(pointOfPixel(at, -(NearDistance + depth)), 1.0);
  for (int i = 0; i < RegionPlaneCount; ++i)
  {
    if (dot(RegionPlanes[i], regionPoint) < 0.0)
    {
      discard;
    }
  }
