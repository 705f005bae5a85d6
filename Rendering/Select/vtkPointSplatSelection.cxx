// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSelection.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// What shaders may err by when they evaluate a linear function, relative to the sum of the
// magnitudes of its terms: some dozens of roundings to single precision.
constexpr double RelativeError = 1e-5;
// Splats are widened by the prefilter, and rounded to whole pixels.
constexpr double PixelMargin = 4.0;
// Parts of a window are not smaller than this.
constexpr int LeastPart = 32;

/**
 * What is seen lies where Normal . p + Offset is positive, p a point's homogeneous coordinates.
 */
struct HalfSpace
{
  glm::dvec4 Normal;
  double Offset;
  glm::dvec4 ErrorNormal; // what the shaders' error is proportional to
  double ErrorOffset;
};

HalfSpace Make(const glm::dvec4& normal, double offset = 0.0)
{
  return { normal, offset, glm::abs(normal), std::abs(offset) };
}

/// Where sign * (x - at) >= 0 in the image; row: view coordinates to x w.
HalfSpace Side(const glm::vec4& row, const glm::vec4& rowW, double at, double sign)
{
  const glm::dvec4 x(row);
  const glm::dvec4 w(rowW);
  return { sign * (x - at * w), 0.0, glm::abs(x) + std::abs(at) * glm::abs(w), 0.0 };
}

std::vector<HalfSpace> MakeHalfSpaces(const vtkPointSplatView& view, const vtkPointSplatItem& item)
{
  // Of points that are projected as pixels no margin: as projectPoint() in vtkPointSplatPoint.glsl.
  const double margin = item.IsPoints ? 0.0 : PixelMargin;
  std::vector<HalfSpace> all = { Make({ 0.0, 0.0, -1.0, 0.0 }, -view.Near),
    Make({ 0.0, 0.0, 1.0, 0.0 }, view.Far), Make(glm::dvec4(view.PixelW)),
    Side(view.PixelX, view.PixelW, item.Window.x - margin, 1.0),
    Side(view.PixelX, view.PixelW, item.Window.z + 1.0 + margin, -1.0),
    Side(view.PixelY, view.PixelW, item.Window.y - margin, 1.0),
    Side(view.PixelY, view.PixelW, item.Window.w + 1.0 + margin, -1.0) };
  for (const glm::dvec4& plane : item.GetClipPlanesVC(view))
  {
    all.push_back(Make(plane));
  }
  const glm::dmat4 fromVC = glm::transpose(item.GetMCVC(view));
  glm::dmat4 errorFromVC;
  for (int k = 0; k < 4; ++k)
  {
    errorFromVC[k] = glm::abs(fromVC[k]);
  }
  for (HalfSpace& half : all)
  {
    half.Normal = fromVC * half.Normal;
    half.ErrorNormal = RelativeError * (errorFromVC * half.ErrorNormal);
    half.ErrorOffset *= RelativeError;
  }
  return all;
}

/// Whether nothing of splats in a box is in a half space; reach: of radii. What is not a number
/// leaves no box out.
bool IsOutside(const HalfSpace& half, const vtkPointSplatBlocks::Box& box, double reach,
  double usualRadius)
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
  most += reach * std::max<double>(box.Radius, usualRadius) * glm::length(glm::dvec3(half.Normal));
  return most < -error;
}

void Divide(const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  const glm::ivec4& window, vtkIdType capacity, std::vector<vtkPointSplatPart>& parts)
{
  vtkPointSplatPart part{ window, {} };
  vtkIdType count = 0;
  for (const vtkPointSplatItem& item : items)
  {
    part.Items.push_back(item);
    vtkPointSplatItem& own = part.Items.back();
    own.Window = glm::ivec4(glm::max(glm::ivec2(window), glm::ivec2(own.Window)),
      glm::min(glm::ivec2(window.z, window.w), glm::ivec2(own.Window.z, own.Window.w)));
    if (own.IsInView())
    {
      own.Blocks = vtkPointSplatSelection::Blocks(view, own);
      count += own.GetNumberOfInvocations();
    }
  }
  const glm::ivec2 size(window.z - window.x + 1, window.w - window.y + 1);
  if (count <= capacity || std::max(size.x, size.y) <= LeastPart)
  {
    parts.push_back(std::move(part));
    return;
  }
  // In the middle, at a multiple of all tiles' sizes.
  const int side = size.x >= size.y ? 0 : 1;
  const int middle = (window[side] + size[side] / 2) / LeastPart * LeastPart;
  const int cut = std::max(middle, window[side] + 1);
  glm::ivec4 first = window;
  glm::ivec4 second = window;
  first[side + 2] = cut - 1;
  second[side] = cut;
  Divide(view, items, first, capacity, parts);
  Divide(view, items, second, capacity, parts);
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const std::vector<uint32_t>> vtkPointSplatSelection::Blocks(
  const vtkPointSplatView& view, const vtkPointSplatItem& item)
{
  const std::vector<HalfSpace> halves = MakeHalfSpaces(view, item);
  const std::vector<vtkPointSplatBlocks::Box>& boxes = item.Cloud->GetBlocks().GetBoxes();
  // A splat that bends rises at its rim by half the squared support, in radii, at most.
  const double support = item.Kernel.Support;
  const double reach = item.IsPoints
    ? 0.0
    : std::hypot(support, 0.5 * support * support) * item.RadiusScale * item.GetStrideScale() *
      item.CoveringScale;
  std::vector<unsigned char> seen(boxes.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(boxes.size()), 256, [&](vtkIdType begin, vtkIdType end) {
    for (size_t block = static_cast<size_t>(begin); block < static_cast<size_t>(end); ++block)
    {
      seen[block] = std::none_of(halves.begin(), halves.end(),
        [&](const HalfSpace& half) {
          return IsOutside(half, boxes[block], reach, item.UsualRadius);
        });
    }
  });
  auto list = std::make_shared<std::vector<uint32_t>>();
  for (size_t block = 0; block < boxes.size(); ++block)
  {
    if (seen[block])
    {
      list->push_back(static_cast<uint32_t>(block));
    }
  }
  return list->size() == boxes.size() ? nullptr : list;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatPart> vtkPointSplatSelection::Divide(
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  const glm::ivec4& window, vtkIdType capacity)
{
  std::vector<vtkPointSplatPart> parts;
  ::Divide(view, items, window, capacity, parts);
  return parts;
}
