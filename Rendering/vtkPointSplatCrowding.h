// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// How much of the surfaces lies so near to other surfaces that sorting splats by runs of neighbours
// (vtkPointSplatSorted.h) takes these for those: what the error of sorted transparency hangs on.
//
// 1. Space is divided into cubes whose side is 1.25 spacings. Of these some are drawn by lot, the same
//    each time, so that they have some 40,000 points; all others are passed over.
// 2. A cube is crowded if it has points of several clouds; or of one cloud a point that is more than
//    half a spacing off the plane of another, or faces the other way.
// 3. The share is that of the points drawn that lie in crowded cubes.
//
// Surfaces two spacings apart have a share of 0, one spacing apart about 0.4, half a spacing 0.8. It
// takes one pass over all points. Noise of half a spacing counts as crowded, and so do normals that
// contradict each other: sorting errs there, too.
#ifndef vtkPointSplatCrowding_h
#define vtkPointSplatCrowding_h

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

class vtkPointSplatCrowding
{
public:
  /// Splats as vtkPointSplatCloud packs them.
  struct Cloud
  {
    const std::vector<uint32_t>* Splats;
    size_t Words;        // a splat
    glm::dmat4 ToWorld;  // from the coordinates that the words have
  };

  /**
   * The share, 0 to 1, of clouds whose points are so far apart (world units). 1 where the spacing
   * is none.
   */
  static double Share(const std::vector<Cloud>& clouds, double spacing);
};

#endif
