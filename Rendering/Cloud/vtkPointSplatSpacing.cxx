// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSpacing.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr double PointsPerCell = 10.0;
constexpr double CellsPerFilledCell = 1.5;
constexpr int MostCells = 256;
constexpr int CellsPerBlock = 4;
constexpr double SparserShare = 0.1;
constexpr double MeanPerSparse = 1.4;
constexpr double LeastPointsPerCell = 0.2;

struct CellBlock
{
  vtkIdType Points = 0;
  vtkIdType Filled = 0;
  double GetPointsPerCell() const { return static_cast<double>(this->Points) / this->Filled; }
};

size_t Cube(int n)
{
  return static_cast<size_t>(n) * static_cast<size_t>(n) * static_cast<size_t>(n);
}
}

//------------------------------------------------------------------------------
double vtkPointSplatSpacing::Estimate(const std::vector<uint32_t>& splats, size_t words,
  size_t count, const std::array<double, 3>& low, double size)
{
  const int cells = std::clamp(
    static_cast<int>(std::sqrt(static_cast<double>(count) / PointsPerCell)), 1, MostCells);
  const double cell = size / cells;
  if (!(cell > 0.0) || !std::isfinite(cell))
  {
    return 0.0;
  }
  const int side = (cells + CellsPerBlock - 1) / CellsPerBlock;
  std::vector<unsigned char> occupied(Cube(cells), 0);
  std::vector<CellBlock> blocks(Cube(side));
  vtkIdType filled = 0;
  for (size_t i = 0; i < count; ++i)
  {
    float p[3];
    std::memcpy(p, splats.data() + words * i, sizeof(p));
    size_t at = 0;
    size_t of = 0;
    for (size_t k = 0; k < 3; ++k)
    {
      const int c = std::clamp(static_cast<int>((p[k] - low[k]) / cell), 0, cells - 1);
      at = at * static_cast<size_t>(cells) + static_cast<size_t>(c);
      of = of * static_cast<size_t>(side) + static_cast<size_t>(c / CellsPerBlock);
    }
    ++blocks[of].Points;
    if (!occupied[at])
    {
      occupied[at] = 1;
      ++blocks[of].Filled;
      ++filled;
    }
  }
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [](const CellBlock& block) { return block.Filled == 0; }),
    blocks.end());
  std::sort(blocks.begin(), blocks.end(), [](const CellBlock& a, const CellBlock& b) {
    return a.GetPointsPerCell() < b.GetPointsPerCell();
  });
  vtkIdType sparser = 0;
  size_t quantile = 0;
  while (
    quantile + 1 < blocks.size() && sparser + blocks[quantile].Filled < SparserShare * filled)
  {
    sparser += blocks[quantile++].Filled;
  }
  const double found = blocks[quantile].GetPointsPerCell();
  double sparse = found;
  for (int i = 0; i < 30; ++i)
  {
    sparse = std::max(LeastPointsPerCell, found * (1.0 - std::exp(-sparse)));
  }
  const double mean = static_cast<double>(count) / static_cast<double>(filled);
  return cell / std::sqrt(CellsPerFilledCell * std::min(mean, MeanPerSparse * sparse));
}
