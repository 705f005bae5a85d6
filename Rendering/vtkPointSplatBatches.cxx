// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBatches.h"

#include "vtkPointSplatStages.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
// What shaders may err by when they evaluate a linear function, relative to the sum of the
// magnitudes of its terms: some dozens of roundings to single precision.
constexpr double RelativeError = 1e-5;

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
  // As projectPoint() in vtkPointSplatPoint.glsl has them, in view coordinates.
  std::vector<HalfSpace> all = { Make({ 0.0, 0.0, -1.0, 0.0 }, -view.Near),
    Make({ 0.0, 0.0, 1.0, 0.0 }, view.Far), Make(glm::dvec4(view.PixelW)),
    Side(view.PixelX, view.PixelW, item.Window.x, 1.0),
    Side(view.PixelX, view.PixelW, item.Window.z + 1.0, -1.0),
    Side(view.PixelY, view.PixelW, item.Window.y, 1.0),
    Side(view.PixelY, view.PixelW, item.Window.w + 1.0, -1.0) };
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

/// Whether nothing of a box is in a half space. What is not a number leaves no box out.
bool IsOutside(
  const HalfSpace& half, const std::array<float, 3>& low, const std::array<float, 3>& high)
{
  double most = half.Normal.w + half.Offset;
  double error = half.ErrorNormal.w + half.ErrorOffset;
  for (int k = 0; k < 3; ++k)
  {
    const double a = low[static_cast<size_t>(k)];
    const double b = high[static_cast<size_t>(k)];
    most += half.Normal[k] * (half.Normal[k] > 0.0 ? b : a);
    error += half.ErrorNormal[k] * std::max(std::abs(a), std::abs(b));
  }
  return most < -error;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatBatches::Make(const std::vector<uint32_t>& splats, size_t words, vtkIdType count,
  const std::vector<uint32_t>& order)
{
  this->Count = count;
  const vtkIdType batches = (count + Size - 1) / Size;
  this->Boxes.resize(static_cast<size_t>(batches));
  vtkSMPTools::For(0, batches, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType batch = begin; batch < end; ++batch)
    {
      Box box{ { { VTK_FLOAT_MAX, VTK_FLOAT_MAX, VTK_FLOAT_MAX } },
        { { -VTK_FLOAT_MAX, -VTK_FLOAT_MAX, -VTK_FLOAT_MAX } } };
      for (vtkIdType i = batch * Size; i < std::min(count, (batch + 1) * Size); ++i)
      {
        const size_t at = static_cast<size_t>(i);
        float p[3];
        std::memcpy(p, splats.data() + words * (order.empty() ? at : order[at]), sizeof(p));
        for (size_t k = 0; k < 3; ++k)
        {
          box.Low[k] = std::min(box.Low[k], p[k]);
          box.High[k] = std::max(box.High[k], p[k]);
        }
      }
      this->Boxes[static_cast<size_t>(batch)] = box;
    }
  });
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkPointSplatBatches::List> vtkPointSplatBatches::Select(
  const vtkPointSplatView& view, const vtkPointSplatItem& item) const
{
  const std::vector<HalfSpace> halves = MakeHalfSpaces(view, item);
  const size_t batches = this->Boxes.size();
  std::vector<unsigned char> seen(batches);
  vtkSMPTools::For(0, static_cast<vtkIdType>(batches), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType batch = begin; batch < end; ++batch)
    {
      const Box& box = this->Boxes[static_cast<size_t>(batch)];
      seen[static_cast<size_t>(batch)] =
        std::none_of(halves.begin(), halves.end(),
          [&box](const HalfSpace& half) { return IsOutside(half, box.Low, box.High); })
        ? 1
        : 0;
    }
  });
  auto list = std::make_shared<List>();
  for (size_t batch = 0; batch < batches; ++batch)
  {
    if (seen[batch])
    {
      list->push_back(static_cast<uint32_t>(batch));
    }
  }
  return list->size() == batches ? nullptr : list;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatBatches::CountPoints(const List* list) const
{
  if (!list)
  {
    return this->Count;
  }
  if (list->empty())
  {
    return 0;
  }
  const vtkIdType whole = static_cast<vtkIdType>(list->size() - 1) * Size;
  return whole + std::min(Size, this->Count - static_cast<vtkIdType>(list->back()) * Size);
}
