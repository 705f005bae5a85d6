// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Half spaces of which none that an item's splats can be seen in may be wholly behind them: of the
// near and the far plane, the sides of the item's window, clipping planes; in the coordinates of
// the cloud's buffers.
#ifndef vtkPointSplatHalfSpaces_h
#define vtkPointSplatHalfSpaces_h

#include "vtkPointSplatItem.h"

#include <vector>

class vtkPointSplatHalfSpaces
{
public:
  vtkPointSplatHalfSpaces(const vtkPointSplatView& view, const vtkPointSplatItem& item);

  /// Whether nothing of splats with centres in this box and up to this radius can be seen. What is
  /// not a number leaves no box out.
  bool IsOutside(const vtkPointSplatBlocks::Box& box) const;

private:
  /**
   * What is seen lies where Normal . p + Offset is positive, p a point's homogeneous coordinates.
   */
  struct HalfSpace
  {
    glm::dvec4 Normal;
    double Offset;
    glm::dvec4 ErrorNormal; // what the shaders' error is proportional to
    double ErrorOffset;
    double Steepness; // the length of the normal
  };
  static HalfSpace Make(const glm::dvec4& normal, double offset = 0.0);
  static HalfSpace Side(const glm::vec4& row, const glm::vec4& rowW, double at, double sign);
  bool IsOutside(const HalfSpace& half, const vtkPointSplatBlocks::Box& box) const;

  std::vector<HalfSpace> All; // but for those before which the whole cloud lies
  double Reach; // of radii
  double UsualRadius;
};

#endif
