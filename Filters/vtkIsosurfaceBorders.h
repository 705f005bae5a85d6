// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceBorders
 * @brief   lines that clip an isosurface's splats where the volume ends
 *
 * Internal to vtkIsosurfacePoints. The isosurface ends at the volume's faces, and splats that reach past one are clipped
 * by the line in which it cuts their plane (`SplatClip`): of a point at the index coordinate i along an axis, and
 * an offset w in its plane, the face at i = 0 keeps what has -g . w / i <= 1, with g the gradient of i in
 * world coordinates; the one at the other end likewise. Where more than two faces are near it is the two nearest.
 */
#ifndef vtkIsosurfaceBorders_h
#define vtkIsosurfaceBorders_h

#include "vtkIsosurfaceField.h"
#include "vtkIsosurfaceOutput.h"
#include "vtkPointSplattingABI.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceBorders
{
public:
  /// ends: whether the whole volume, and not only a piece of it, ends there; low and high of each axis.
  vtkIsosurfaceBorders(const vtkIsosurfaceGrid& grid, const std::array<bool, 6>& ends);

  /// Gives an output with sizes its lines, if any of its splats has some.
  void Clip(vtkIsosurfaceOutput& output) const;

private:
  bool FindLines(const double x[3], const float n[3], double reach, float clip[6]) const;

  double Gradients[3][4]; // index coordinates of world ones
  double Steepest[3];     // index coordinates per world unit, across the planes
  double Last[3];         // index coordinate
  std::array<bool, 6> Ends;
};

VTK_ABI_NAMESPACE_END
#endif
