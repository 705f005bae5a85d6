// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLevelLines
 * @brief   the clip lines of splats that stand for others (vtkPointSplatHierarchy.h), from these'
 *
 * 1. Each line of a splat below is a point of the edge, the nearest one, and the direction across it,
 *    out of the face. Both are brought into the plane of the splat above. What leaves this plane says
 *    nothing of where that splat ends: other faces of a part that was folded about an edge do.
 * 2. Directions alike are one edge of the splat above: their mean, as far out as the farthest of the
 *    points. There are up to two, the nearest ones.
 * 3. An edge is none if some of the splats below lie beyond it, as where two faces that meet at an
 *    obtuse angle have become one splat, at reflex corners and at the end of a slit. There the splat
 *    is whole.
 */
#ifndef vtkPointSplatLevelLines_h
#define vtkPointSplatLevelLines_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplattingABI.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatLevelLines
{
public:
  /// A splat below: where it is, and its lines n / d as vtkPointSplatEstimation.h has them; 0: none.
  struct Splat
  {
    double Position[3];
    double Lines[6];
  };
  /// The splat above.
  struct Disk
  {
    double Position[3];
    double Normal[3]; // unit length
    double Radius;
  };

  /// Sets the lines of the splat that stands for those below. Those that are not finite are none.
  static void Find(const std::vector<Splat>& below, const Disk& above, double lines[6]);
};

VTK_ABI_NAMESPACE_END
#endif
