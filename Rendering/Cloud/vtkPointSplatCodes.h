// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The codes in which a cloud's buffers hold splats' shapes (vtkPointSplatCloud.h).
#ifndef vtkPointSplatCodes_h
#define vtkPointSplatCodes_h

#include <cstdint>

namespace vtkPointSplatCodes
{
///@{
/// The word of a splat's bend, as in vtkPointSplatProjection.glsl: three numbers, in steps of their largest value; and a
/// mark of bodies that face the viewer.
constexpr uint32_t BendMask = 0x3fffffffu;
constexpr float BendSteps = 511.0f;
constexpr uint32_t BodyBit = 0x40000000u;
/// ... and of splats whose curvature is given and is none: these are of flat faces.
constexpr uint32_t FlatBit = 0x80000000u;
///@}

/// A number as a float.
uint32_t Bits(double value);

///@{
/// A unit vector as two coordinates on an octahedron, 16 bits each; see decodeNormal() in
/// vtkPointSplatOctahedron.glsl.
uint32_t CodeNormal(const double n[3]);
void DecodeNormal(uint32_t code, double n[3]);
///@}

/// The tangents of circular splats in a plane, as vtkPointSplatProjection.glsl has them.
void TangentsOf(uint32_t planeCode, double s[3], double t[3]);
/// The axes of a splat of a cloud, as long as its radii. circular: it has one radius.
void AxesOf(const uint32_t* splat, bool circular, double s[3], double t[3]);

/**
 * The matrix K of vtkPointSplatProjection.glsl, the second fundamental form times the radius in the
 * basis of the splat's tangents, for a paraboloid that meets the osculating circles at the kernel's
 * rim: elements 11, 12 and 22, 10 bits each. Eigenvalues are held within the largest that can be
 * coded. curvature: the form as a tensor XX, YY, ZZ, XY, YZ, XZ.
 */
uint32_t CodeBend(uint32_t planeCode, const double curvature[6], double radius);

/**
 * A clip line (vtkPointSplatArrays.h) in terms of a splat's axes, or none where it is not finite.
 */
void CodeLine(const double c[3], const double s[3], const double t[3], uint32_t line[2]);
}

#endif
