// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What of a surface is another process', by planes in view coordinates: where one is negative.
uniform vec4 RegionPlanes[6];
uniform int RegionPlaneCount;
