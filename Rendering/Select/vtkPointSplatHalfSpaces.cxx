// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatHalfSpaces.h"

#include <algorithm>
#include <cmath>

namespace
{
// What shaders may err by when they evaluate a linear function, relative to the sum of the
// magnitudes of its terms: some dozens of roundings to single precision.
constexpr double RelativeError = 1e-5;
// Splats are widened by the prefilter, and rounded to whole pixels.
constexpr double PixelMargin = 4.0;
}

//------------------------------------------------------------------------------
vtkPointSplatHalfSpaces::HalfSpace vtkPointSplatHalfSpaces::Make(
  const glm::dvec4& normal, double offset)
{
  return { normal, offset, glm::abs(normal), std::abs(offset), 0.0 };
}

//------------------------------------------------------------------------------
/// Where sign * (x - at) >= 0 in the image; row: view coordinates to x w.
vtkPointSplatHalfSpaces::HalfSpace vtkPointSplatHalfSpaces::Side(
  const glm::vec4& row, const glm::vec4& rowW, double at, double sign)
{
  const glm::dvec4 x(row);
  const glm::dvec4 w(rowW);
  return { sign * (x - at * w), 0.0, glm::abs(x) + std::abs(at) * glm::abs(w), 0.0, 0.0 };
}

//------------------------------------------------------------------------------
vtkPointSplatHalfSpaces::vtkPointSplatHalfSpaces(
  const vtkPointSplatView& view, const vtkPointSplatItem& item)
  : UsualRadius(item.UsualRadius)
{
  // A splat that bends rises at its rim by half the squared support, in radii, at most.
  const double support = item.Kernel.Support;
  this->Reach = item.IsPoints
    ? 0.0
    : std::hypot(support, 0.5 * support * support) * item.RadiusScale * item.GetStrideScale() *
      item.CoveringScale;
  // Of points that are projected as pixels no margin: as projectPoint() in vtkPointSplatPoint.glsl.
  const double margin = item.IsPoints ? 0.0 : PixelMargin;
  this->All = { Make({ 0.0, 0.0, -1.0, 0.0 }, -view.Near), Make({ 0.0, 0.0, 1.0, 0.0 }, view.Far),
    Make(glm::dvec4(view.PixelW)), Side(view.PixelX, view.PixelW, item.Window.x - margin, 1.0),
    Side(view.PixelX, view.PixelW, item.Window.z + 1.0 + margin, -1.0),
    Side(view.PixelY, view.PixelW, item.Window.y - margin, 1.0),
    Side(view.PixelY, view.PixelW, item.Window.w + 1.0 + margin, -1.0) };
  for (const glm::dvec4& plane : item.GetClipPlanesVC(view))
  {
    this->All.push_back(Make(plane));
  }
  const glm::dmat4 fromVC = glm::transpose(item.GetMCVC(view));
  glm::dmat4 errorFromVC;
  for (int k = 0; k < 4; ++k)
  {
    errorFromVC[k] = glm::abs(fromVC[k]);
  }
  for (HalfSpace& half : this->All)
  {
    half.Normal = fromVC * half.Normal;
    half.ErrorNormal = RelativeError * (errorFromVC * half.ErrorNormal);
    half.ErrorOffset *= RelativeError;
    half.Steepness = glm::length(glm::dvec3(half.Normal));
  }
  // What holds for the whole cloud need not be asked of each of its boxes.
  const std::array<double, 6>& bounds = item.Cloud->GetBounds();
  const std::array<double, 3>& origin = item.Cloud->GetOrigin();
  this->All.erase(std::remove_if(this->All.begin(), this->All.end(),
                    [&](const HalfSpace& half) {
                      double least = half.Normal.w + half.Offset;
                      for (int k = 0; k < 3; ++k)
                      {
                        const size_t axis = static_cast<size_t>(k);
                        const size_t end = 2 * axis + (half.Normal[k] > 0.0 ? 0 : 1);
                        least += half.Normal[k] * (bounds[end] - origin[axis]);
                      }
                      return least >= 0.0;
                    }),
    this->All.end());
}

//------------------------------------------------------------------------------
bool vtkPointSplatHalfSpaces::IsOutside(
  const HalfSpace& half, const vtkPointSplatBlocks::Box& box) const
{
  double most = half.Normal.w + half.Offset;
  double error = half.ErrorNormal.w + half.ErrorOffset;
  for (int k = 0; k < 3; ++k)
  {
    const double a = box.Low[static_cast<size_t>(k)];
    const double b = box.High[static_cast<size_t>(k)];
    most += half.Normal[k] * (half.Normal[k] > 0.0 ? b : a);
    error += half.ErrorNormal[k] * std::max(std::abs(a), std::abs(b));
  }
  most += this->Reach * std::max<double>(box.Radius, this->UsualRadius) * half.Steepness;
  return most < -error;
}

//------------------------------------------------------------------------------
bool vtkPointSplatHalfSpaces::IsOutside(const vtkPointSplatBlocks::Box& box) const
{
  return std::any_of(this->All.begin(), this->All.end(),
    [&](const HalfSpace& half) { return this->IsOutside(half, box); });
}
