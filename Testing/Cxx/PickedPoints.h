// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a hardware selection of points finds in each pixel of a window.
#ifndef PickedPoints_h
#define PickedPoints_h

#include "SplatScene.h"

#include "vtkHardwareSelector.h"

namespace SplatScene
{
struct PickedPoint
{
  unsigned int Block = 0; // its composite index
  vtkIdType Point = -1;   // none
  bool operator!=(const PickedPoint& other) const
  {
    return this->Block != other.Block || this->Point != other.Point;
  }
};

/// Row by row; empty if the selection fails.
inline std::vector<PickedPoint> PickPoints(Window& window)
{
  const int* size = window.Win->GetSize();
  const unsigned int width = static_cast<unsigned int>(size[0]);
  const unsigned int height = static_cast<unsigned int>(size[1]);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(window.Renderer);
  selector->SetArea(0, 0, width - 1, height - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  std::vector<PickedPoint> picked;
  if (!selector->CaptureBuffers())
  {
    return picked;
  }
  for (unsigned int y = 0; y < height; ++y)
  {
    for (unsigned int x = 0; x < width; ++x)
    {
      const unsigned int pixel[2] = { x, y };
      const auto hit = selector->GetPixelInformation(pixel);
      picked.push_back(hit.Valid ? PickedPoint{ hit.CompositeID, hit.AttributeID } : PickedPoint());
    }
  }
  return picked;
}

/// How far from the pixels that show them the picked points lie, at most, and how many there are.
inline double FarthestPicked(Window& window, vtkPolyData* data, int& picked)
{
  const int width = window.Win->GetSize()[0];
  const std::vector<PickedPoint> all = PickPoints(window);
  double farthest = 0.0;
  picked = 0;
  for (size_t i = 0; i < all.size(); ++i)
  {
    if (all[i].Point < 0)
    {
      continue;
    }
    ++picked;
    double p[3];
    data->GetPoint(all[i].Point, p);
    window.Renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    window.Renderer->WorldToDisplay();
    double at[3];
    window.Renderer->GetDisplayPoint(at);
    const int pixel = static_cast<int>(i);
    farthest = std::max(
      farthest, std::hypot(at[0] - pixel % width - 0.5, at[1] - pixel / width - 0.5));
  }
  return farthest;
}
}

#endif
