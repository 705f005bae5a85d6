// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatColoring.h"

#include "vtkMath.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Index = vtkPointSplatOverlap::Index;

constexpr int Uncolored = -1;
// Weights are counted in this unit, as whole numbers: sums then do not depend on the order of
// a row's edges, which depends on the threads.
constexpr double Unit = 1.0 / 1048576.0;
// Moves come to an end by themselves, since each lowers the weight; the last of many sweeps
// gain nothing that could be seen.
constexpr int MostSweeps = 32;

/// What each of K colours would cost a node.
void Costs(const vtkPointSplatOverlap& graph, const std::vector<float>& weights,
  const std::vector<int>& colors, Index i, std::vector<double>& costs)
{
  std::fill(costs.begin(), costs.end(), 0.0);
  const std::size_t row = graph.GetOffset(i);
  const std::size_t degree = graph.GetDegree(i);
  const Index* neighbors = graph.begin(i);
  for (std::size_t e = 0; e < degree; ++e)
  {
    const int color = colors[neighbors[e]];
    if (color != Uncolored)
    {
      costs[color] += std::floor(weights[row + e] / Unit);
    }
  }
}

double Optimize(const vtkPointSplatOverlap& graph, const std::vector<float>& weights, int K,
  std::vector<int>& colors)
{
  std::vector<double> costs(K);
  bool moved = true;
  for (int sweep = 0; sweep < MostSweeps && moved; ++sweep)
  {
    moved = false;
    for (Index i = 0; i < graph.GetNumberOfSplats(); ++i)
    {
      Costs(graph, weights, colors, i, costs);
      const int best =
        static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin());
      if (costs[best] < costs[colors[i]])
      {
        colors[i] = best;
        moved = true;
      }
    }
  }
  return vtkPointSplatColoring::WeightWithin(graph, weights, colors);
}
}

//------------------------------------------------------------------------------
int vtkPointSplatColoring::LargestFirst(
  const vtkPointSplatOverlap& graph, std::vector<int>& colors)
{
  const Index count = graph.GetNumberOfSplats();
  colors.assign(count, Uncolored);
  // Sorted by counting: the first place for each degree, then one after the other.
  std::size_t largest = 0;
  for (Index i = 0; i < count; ++i)
  {
    largest = std::max(largest, graph.GetDegree(i));
  }
  std::vector<Index> place(largest + 2, 0);
  for (Index i = 0; i < count; ++i)
  {
    ++place[largest - graph.GetDegree(i) + 1];
  }
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<Index> order(count);
  for (Index i = 0; i < count; ++i)
  {
    order[place[largest - graph.GetDegree(i)]++] = i;
  }

  std::vector<Index> takenBy(largest + 2, count); // the node that last found a colour taken
  int used = 0;
  for (const Index i : order)
  {
    for (const Index* j = graph.begin(i); j != graph.end(i); ++j)
    {
      if (colors[*j] != Uncolored)
      {
        takenBy[colors[*j]] = i;
      }
    }
    int color = 0;
    while (takenBy[color] == i)
    {
      ++color;
    }
    colors[i] = color;
    used = std::max(used, color + 1);
  }
  return used;
}

//------------------------------------------------------------------------------
std::vector<float> vtkPointSplatColoring::OverlapAreas(
  const vtkPointSplatOverlap& graph, const double* positions, const double* radii)
{
  std::vector<float> weights(2 * graph.GetNumberOfEdges());
  // In units of a typical splat's area: sums of them are then well within exact integers.
  double mean = 0;
  for (Index i = 0; i < graph.GetNumberOfSplats(); ++i)
  {
    mean += radii[i] * radii[i];
  }
  mean *= vtkMath::Pi() / std::max<Index>(graph.GetNumberOfSplats(), 1);
  vtkPointSplatThreads::For(0, graph.GetNumberOfSplats(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType v = begin; v < end; ++v)
    {
      const Index i = static_cast<Index>(v);
      std::size_t at = graph.GetOffset(i);
      for (const Index* j = graph.begin(i); j != graph.end(i); ++j, ++at)
      {
        const double* p = positions + 3 * std::size_t(i);
        const double* q = positions + 3 * std::size_t(*j);
        const double d = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
        // The smaller one first, so that both rows hold the same number.
        const double r = std::min(radii[i], radii[*j]);
        const double R = std::max(radii[i], radii[*j]);
        double area = 0;
        if (d <= R - r)
        {
          area = vtkMath::Pi() * r * r;
        }
        else if (d < R + r)
        {
          const double a = std::clamp((d * d + r * r - R * R) / (2 * d * r), -1.0, 1.0);
          const double b = std::clamp((d * d + R * R - r * r) / (2 * d * R), -1.0, 1.0);
          const double kite = (-d + r + R) * (d + r - R) * (d - r + R) * (d + r + R);
          area =
            r * r * std::acos(a) + R * R * std::acos(b) - 0.5 * std::sqrt(std::max(kite, 0.0));
        }
        weights[at] = static_cast<float>(std::max(area, 0.0) / mean);
      }
    }
  });
  return weights;
}

//------------------------------------------------------------------------------
double vtkPointSplatColoring::WeightWithin(const vtkPointSplatOverlap& graph,
  const std::vector<float>& weights, const std::vector<int>& colors)
{
  double sum = 0;
  for (Index i = 0; i < graph.GetNumberOfSplats(); ++i)
  {
    std::size_t at = graph.GetOffset(i);
    for (const Index* j = graph.begin(i); j != graph.end(i); ++j, ++at)
    {
      if (*j > i && colors[i] == colors[*j])
      {
        sum += std::floor(weights[at] / Unit);
      }
    }
  }
  return Unit * sum;
}

//------------------------------------------------------------------------------
std::vector<int> vtkPointSplatColoring::CutDown(const vtkPointSplatOverlap& graph,
  const std::vector<float>& weights, const std::vector<int>& largestFirst, int K)
{
  std::vector<int> colors = largestFirst;
  for (int& color : colors)
  {
    color = color < K ? color : Uncolored;
  }
  std::vector<double> costs(K);
  for (Index i = 0; i < graph.GetNumberOfSplats(); ++i)
  {
    if (colors[i] == Uncolored)
    {
      Costs(graph, weights, colors, i, costs);
      colors[i] = static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin());
    }
  }
  return colors;
}

//------------------------------------------------------------------------------
double vtkPointSplatColoring::Weighted(const vtkPointSplatOverlap& graph,
  const std::vector<float>& weights, const std::vector<int>& largestFirst, int K,
  std::vector<int>& colors)
{
  const Index count = graph.GetNumberOfSplats();
  std::vector<float> total(count, 0.0f);
  for (Index i = 0; i < count; ++i)
  {
    // Sorted first: the row's order, and with it the rounding, depends on the threads.
    std::vector<float> row(weights.begin() + graph.GetOffset(i),
      weights.begin() + graph.GetOffset(i) + graph.GetDegree(i));
    std::sort(row.begin(), row.end());
    total[i] = std::accumulate(row.begin(), row.end(), 0.0f);
  }
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return total[a] > total[b]; });

  std::vector<int> greedy(count, Uncolored);
  std::vector<double> costs(K);
  for (const Index i : order)
  {
    Costs(graph, weights, greedy, i, costs);
    greedy[i] = static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  }
  const double left = Optimize(graph, weights, K, greedy);

  colors = vtkPointSplatColoring::CutDown(graph, weights, largestFirst, K);
  const double cutLeft = Optimize(graph, weights, K, colors);
  if (left < cutLeft)
  {
    colors = std::move(greedy);
  }
  return std::min(left, cutLeft);
}

VTK_ABI_NAMESPACE_END
