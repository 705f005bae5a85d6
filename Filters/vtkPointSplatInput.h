// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatInput.h
 * @brief what filters of points take of an input: which points are usable, and unit normals
 */
#ifndef vtkPointSplatInput_h
#define vtkPointSplatInput_h

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatThreads.h"
#include "vtkPointSplattingABI.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkPointSplatInput
{
/// Floats hold no more, and nothing real is farther out.
inline constexpr double LargestCoordinate = 1e37;
/// Coordinates tell points apart that are this part of their spacing, or of a voxel, from one another.
inline constexpr double Resolution = 1e-3;

struct MarkFiniteWorker
{
  template <typename Array>
  void operator()(Array* points, std::vector<unsigned char>& used) const
  {
    const auto range = vtk::DataArrayTupleRange<3>(points);
    vtkPointSplatThreads::For(0, range.size(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const auto x = range[id];
        // NaN compares false.
        used[id] = std::abs(static_cast<double>(x[0])) <= LargestCoordinate &&
          std::abs(static_cast<double>(x[1])) <= LargestCoordinate &&
          std::abs(static_cast<double>(x[2])) <= LargestCoordinate;
      }
    });
  }
};

struct ReadNormalsWorker
{
  template <typename Array>
  void operator()(Array* given, float* normals) const
  {
    const auto range = vtk::DataArrayTupleRange<3>(given);
    vtkPointSplatThreads::For(0, range.size(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const auto n = range[id];
        const double x = n[0], y = n[1], z = n[2];
        const double largest = std::max({ std::abs(x), std::abs(y), std::abs(z) });
        // Scaled first, since squares may overflow or underflow.
        const double a = x / largest, b = y / largest, c = z / largest;
        const double inverse = 1 / std::sqrt(a * a + b * b + c * c);
        const bool good = largest > 0 && std::isfinite(inverse) && std::isfinite(largest);
        normals[3 * id] = good ? static_cast<float>(a * inverse) : 0.0f;
        normals[3 * id + 1] = good ? static_cast<float>(b * inverse) : 0.0f;
        normals[3 * id + 2] = good ? static_cast<float>(c * inverse) : 0.0f;
      }
    });
  }
};

struct ReadPositionsWorker
{
  template <typename Array>
  void operator()(Array* points, std::vector<double>& positions) const
  {
    const auto range = vtk::DataArrayTupleRange<3>(points);
    vtkPointSplatThreads::For(0, range.size(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const auto x = range[id];
        for (int c = 0; c < 3; ++c)
        {
          positions[3 * id + c] = static_cast<double>(x[c]);
        }
      }
    });
  }
};

template <typename Worker, typename... Args>
void Dispatch(vtkDataArray* array, Args&&... args)
{
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        array, Worker{}, args...))
  {
    Worker{}(array, args...);
  }
}

/// Marks the points by 1 whose coordinates are finite, and the others by 0. used: a byte a point.
inline void MarkFinite(vtkDataArray* points, std::vector<unsigned char>& used)
{
  Dispatch<MarkFiniteWorker>(points, used);
}

/// How many points take no part, and why.
struct LeftOut
{
  vtkIdType NotFinite = 0;
  vtkIdType Hidden = 0;
};

/// The ghost array, a byte a point, or null.
inline const unsigned char* GetGhosts(vtkPointSet* input)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    input->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && ghosts->GetNumberOfTuples() == input->GetNumberOfPoints() &&
      ghosts->GetNumberOfComponents() == 1
    ? ghosts->GetPointer(0)
    : nullptr;
}

/// Whether a point is another process'. ghosts: as from GetGhosts().
inline bool IsDuplicate(const unsigned char* ghosts, vtkIdType id)
{
  return ghosts && (ghosts[id] & vtkDataSetAttributes::DUPLICATEPOINT);
}

/**
 * Marks the points that take part by 1: not those whose coordinates are not finite, nor hidden
 * ones.
 */
inline LeftOut MarkUsable(vtkPointSet* input, std::vector<unsigned char>& used)
{
  used.resize(input->GetNumberOfPoints());
  MarkFinite(input->GetPoints()->GetData(), used);
  LeftOut left;
  left.NotFinite = std::count(used.begin(), used.end(), 0);
  const unsigned char* ghost = GetGhosts(input);
  for (std::size_t id = 0; ghost && id < used.size(); ++id)
  {
    if (used[id] && (ghost[id] & vtkDataSetAttributes::HIDDENPOINT))
    {
      used[id] = 0;
      ++left.Hidden;
    }
  }
  return left;
}

/// The coordinates, 3 a point.
inline std::vector<double> ReadPositions(vtkDataArray* points)
{
  std::vector<double> positions(3 * static_cast<std::size_t>(points->GetNumberOfTuples()));
  Dispatch<ReadPositionsWorker>(points, positions);
  return positions;
}

/// Of what ReadNormals() makes of a normal that cannot be used, and of planes' normals where there are none.
inline bool IsZero(const float n[3])
{
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

/// Unit normals, 3 floats a point, or zero where there is none to be had.
inline void ReadNormals(vtkDataArray* given, float* normals)
{
  Dispatch<ReadNormalsWorker>(given, normals);
}
}

VTK_ABI_NAMESPACE_END
#endif
