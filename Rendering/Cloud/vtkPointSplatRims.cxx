// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRims.h"

#include "vtkMath.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace
{
using Block = vtkPointSplatRims::Block;

constexpr int Directions = 8;
// Radii: how far a next point is searched; and what share of that it must be ahead, more than the
// sine of half the angle between two directions, so that those along a rim are none.
constexpr double SearchRadii = 5.0;
constexpr double Ahead = 0.5;

struct Search
{
  const std::vector<std::array<float, 3>>& Places; // in the blocks' order
  const std::vector<Block>& Blocks;

  /// Whether a block has a point within the radius, and far enough in the direction.
  bool Has(const Block& block, const std::array<float, 3>& from, const double direction[3],
    double radius) const
  {
    const double reach = radius + (block.Level > 0 ? block.Radius : 0.0f);
    double squares = 0.0;
    double most = reach - radius;
    for (size_t k = 0; k < 3; ++k)
    {
      const double off = std::max({ 0.0f, block.Low[k] - from[k], from[k] - block.High[k] });
      squares += off * off;
      most += direction[k] * ((direction[k] > 0.0 ? block.High[k] : block.Low[k]) - from[k]);
    }
    if (squares > reach * reach || most < Ahead * radius)
    {
      return false;
    }
    for (uint32_t child = 0; block.Level > 0 && child < block.ChildCount; ++child)
    {
      if (this->Has(this->Blocks[block.FirstChild + child], from, direction, radius))
      {
        return true;
      }
    }
    for (uint32_t i = block.First; block.Level == 0 && i < block.First + block.Count; ++i)
    {
      const std::array<float, 3>& p = this->Places[i];
      const double x[3] = { double(p[0]) - from[0], double(p[1]) - from[1],
        double(p[2]) - from[2] };
      if (vtkMath::Dot(x, direction) >= Ahead * radius && vtkMath::Dot(x, x) <= radius * radius)
      {
        return true;
      }
    }
    return false;
  }

  bool IsRim(const Block& block, size_t roots) const
  {
    const double axis[3] = { block.Cone[0], block.Cone[1], block.Cone[2] };
    double across[2][3];
    vtkMath::Perpendiculars(axis, across[0], across[1], 0.0);
    const double radius = SearchRadii * block.MeanRadius;
    for (int d = 0; d < Directions; ++d)
    {
      const double angle = 2.0 * vtkMath::Pi() * d / Directions;
      double direction[3];
      for (int k = 0; k < 3; ++k)
      {
        direction[k] = std::cos(angle) * across[0][k] + std::sin(angle) * across[1][k];
      }
      std::array<float, 3> last{};
      double farthest = -VTK_DOUBLE_MAX;
      for (uint32_t i = block.First; i < block.First + block.Count; ++i)
      {
        const std::array<float, 3>& p = this->Places[i];
        const double along = p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2];
        if (along > farthest)
        {
          farthest = along;
          last = p;
        }
      }
      bool goesOn = false;
      for (size_t root = 0; root < roots && !goesOn; ++root)
      {
        goesOn = this->Has(this->Blocks[root], last, direction, radius);
      }
      if (!goesOn)
      {
        return true;
      }
    }
    return false;
  }
};
}

//------------------------------------------------------------------------------
std::vector<bool> vtkPointSplatRims::Find(
  const Points& points, const std::vector<Block>& blocks, size_t roots)
{
  std::vector<std::array<float, 3>> places(points.Order.size());
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(places.size()), [&](vtkIdType begin, vtkIdType end) {
    for (size_t i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
    {
      std::memcpy(places[i].data(), points.Splats + points.Words * points.Order[i],
        sizeof(places[i]));
    }
  });
  const Search search{ places, blocks };
  std::vector<unsigned char> found(blocks.size(), 0); // a byte each, for threads
  vtkPointSplatThreads::For(
    0, static_cast<vtkIdType>(found.size()), 64, [&](vtkIdType begin, vtkIdType end) {
      for (size_t b = static_cast<size_t>(begin); b < static_cast<size_t>(end); ++b)
      {
        found[b] = blocks[b].Level == 0 && search.IsRim(blocks[b], roots) ? 1 : 0;
      }
    });
  vtkPointSplatHierarchy::JoinUpward(
    blocks, [&found](size_t block, size_t child) { found[block] |= found[child]; });
  return std::vector<bool>(found.begin(), found.end());
}
