// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Large windows are drawn part by part: the images are those of one part, and no larger than they may
// be.
//
// Parts meet without a gap. The images of each reach beyond what it shows by a border, since outlines
// are smoothed, and holes filled, by what the pixels beside them show; and they begin at multiples of
// it, so that tiles and coarser images are where they are in the whole window. Where VTK peels translucent
// geometry the window is drawn whole.
#ifndef vtkPointSplatWindowParts_h
#define vtkPointSplatWindowParts_h

#include <glm/glm.hpp>

#include "vtkType.h"

#include <vector>

/**
 * Pixels of the window.
 */
struct vtkPointSplatWindowPart
{
  glm::ivec2 First{ 0, 0 }; // of its images
  glm::ivec2 Size{ 0, 0 };  // of its images
  glm::ivec4 Shown{ 0 };    // of them: first x, y, last x, y

  bool operator==(const vtkPointSplatWindowPart& other) const
  {
    return this->First == other.First && this->Size == other.Size && this->Shown == other.Shown;
  }
};

class vtkPointSplatWindowParts
{
public:
  static constexpr int Border = 64;
  static constexpr int LeastShown = 256;

  /**
   * One, which is the window, where its images fit in so many bytes (0: there is no bound); else equal
   * ones that fit, if they can: each shows at least LeastShown x LeastShown pixels.
   */
  static std::vector<vtkPointSplatWindowPart> Divide(
    const glm::ivec2& window, vtkIdType bytesPerPixel, vtkIdType mostBytes);
};

#endif
