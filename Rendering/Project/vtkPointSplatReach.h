// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// How far splats reach, by whatever they are drawn.
#ifndef vtkPointSplatReach_h
#define vtkPointSplatReach_h

namespace vtkPointSplatReach
{
/// Radii of the disks that tell where the surface is: such that cover their neighbours' Voronoi
/// cells in the tangent plane leave cracks where the surface bends and is seen at a flat angle.
constexpr float Disk = 1.15f;
/// Pixels, the least that a disk measures across: on planes that are seen edge-on no pixel falls
/// between disks ...
constexpr float Coverage = 0.1f;
/// ... but splats with a silhouette on them are not widened: a tenth of a pixel about each centre
/// costs bodies of a few hundred pixels 7 dB against their mesh.
constexpr float CoverageDot = 1e-3f;
/// Pixels, of the prefilter. Guennebaud, section 4.1, has the square root of two; the Gaussian of
/// sigma 0.6 is then as wide as a pixel is, which blurs more than the pixels of a supersampled
/// picture do.
constexpr float Prefilter = 0.8f;
}

#endif
