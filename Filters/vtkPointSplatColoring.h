// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatColoring.h
 * @brief colours the graph of overlapping splats: internal to vtkPointSplatGrouping
 *
 * - LargestFirst: nodes by non-increasing degree, each with the least colour that no neighbour
 *   has (Zhang, Pajarola 2006, Single-Pass Point Rendering, section 4.1). Of equal degrees the
 *   lower index comes first.
 * - Weighted: K colours whatever the graph, such that little weight is left on edges whose ends
 *   share a colour (Zhang, Pajarola 2006, GPU-Accelerated Transparent Point-Based Rendering,
 *   section 2). Greedy initialisation gives each node, heaviest first, the colour that costs
 *   least; largest-first's colours, those past K replaced greedily, are a second start.
 *   Optimisation moves single nodes to the colour that costs least and so only ever lowers the
 *   weight. The better of the two ends is the result.
 */
#ifndef vtkPointSplatColoring_h
#define vtkPointSplatColoring_h

#include "vtkPointSplatOverlap.h"

VTK_ABI_NAMESPACE_BEGIN

namespace vtkPointSplatColoring
{
/// A colour for each splat; returns how many there are.
int LargestFirst(const vtkPointSplatOverlap& graph, std::vector<int>& colors);

/// The area that two splats, taken as coplanar disks, share: the weight of each entry of
/// the graph's rows.
std::vector<float> OverlapAreas(
  const vtkPointSplatOverlap& graph, const double* positions, const double* radii);

/// Weight of the edges whose ends have the same colour.
double WeightWithin(const vtkPointSplatOverlap& graph, const std::vector<float>& weights,
  const std::vector<int>& colors);

/// largestFirst with no more than K colours: nodes past them take, in order, what costs least.
std::vector<int> CutDown(const vtkPointSplatOverlap& graph, const std::vector<float>& weights,
  const std::vector<int>& largestFirst, int K);

/// At most K colours; returns the weight that is left within them.
double Weighted(const vtkPointSplatOverlap& graph, const std::vector<float>& weights,
  const std::vector<int>& largestFirst, int K, std::vector<int>& colors);
}

VTK_ABI_NAMESPACE_END
#endif
