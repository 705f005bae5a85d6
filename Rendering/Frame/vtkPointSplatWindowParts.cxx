// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatWindowParts.h"

#include <algorithm>
#include <cmath>

namespace
{
/// What parts show of a side of the window, where their images may have so many pixels.
int Step(int room, int window)
{
  constexpr int border = vtkPointSplatWindowParts::Border;
  if (room >= window)
  {
    return window;
  }
  const int most = std::max(
    room / border * border - 2 * border, vtkPointSplatWindowParts::LeastShown);
  const int count = (window + most - 1) / most;
  return ((window + count - 1) / count + border - 1) / border * border;
}
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatWindowPart> vtkPointSplatWindowParts::Divide(
  const glm::ivec2& window, vtkIdType bytesPerPixel, vtkIdType mostBytes)
{
  const vtkIdType pixels = mostBytes / bytesPerPixel;
  if (mostBytes == 0 || static_cast<vtkIdType>(window.x) * window.y <= pixels)
  {
    return { { glm::ivec2(0), window, { 0, 0, window.x - 1, window.y - 1 } } };
  }
  // Squares with their borders, wider where the window is lower than that.
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(pixels)));
  const glm::ivec2 step(Step(static_cast<int>(std::min<vtkIdType>(
                               pixels / std::max(std::min(side, window.y), 1), window.x)),
                          window.x),
    Step(side, window.y));
  std::vector<vtkPointSplatWindowPart> parts;
  for (int y = 0; y < window.y; y += step.y)
  {
    for (int x = 0; x < window.x; x += step.x)
    {
      const glm::ivec2 low(x, y);
      const glm::ivec2 high = glm::min(low + step, window);
      vtkPointSplatWindowPart part;
      part.First = glm::max(low - Border, glm::ivec2(0));
      part.Size = glm::min(high + Border, window) - part.First;
      part.Shown = glm::ivec4(low - part.First, high - part.First - 1);
      parts.push_back(part);
    }
  }
  return parts;
}
