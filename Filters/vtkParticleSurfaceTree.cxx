// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleSurfaceTree.h"

#include "vtkPointSplatBatches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

vtkParticleSurfaceTree::Node vtkParticleSurfaceTree::MakeRoot(const std::vector<Kernel>& kernels)
{
  double low[3], high[3];
  std::fill_n(low, 3, VTK_DOUBLE_MAX);
  std::fill_n(high, 3, -VTK_DOUBLE_MAX);
  for (const Kernel& kernel : kernels)
  {
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], kernel.Center[c] - kernel.Extent[c]);
      high[c] = std::max(high[c], kernel.Center[c] + kernel.Extent[c]);
    }
  }
  double size = 0;
  for (int c = 0; c < 3; ++c)
  {
    this->Origin[c] = low[c];
    size = std::max(size, high[c] - low[c]);
  }
  Node root;
  std::fill_n(root.Index, 3, 0);
  root.Level = std::ilogb(size / (CellsPerSide * this->Cell)) + 1;
  root.Kernels.resize(kernels.size());
  std::iota(root.Kernels.begin(), root.Kernels.end(), 0u);
  return root;
}

bool vtkParticleSurfaceTree::IsFine(
  const Node& node, const std::vector<Kernel>& kernels) const
{
  float least = std::numeric_limits<float>::max();
  for (const std::uint32_t k : node.Kernels)
  {
    least = std::min(least, kernels[k].Spacing);
  }
  // Sides are halved: the nearest to what is wanted, by ratio.
  const double side = std::ldexp(this->Cell, node.Level);
  return side <= std::sqrt(2.0) * CellPerSpacing * least;
}

void vtkParticleSurfaceTree::Split(
  const Node& node, const std::vector<Kernel>& kernels, std::vector<Node>& parts) const
{
  // Points are moved onto the surface by less than a cell, and all kernels must be known there.
  const double cell = std::ldexp(this->Cell, node.Level - 1);
  const double side = CellsPerSide * cell;
  Node children[8];
  for (int part = 0; part < 8; ++part)
  {
    children[part].Level = node.Level - 1;
    for (int c = 0; c < 3; ++c)
    {
      children[part].Index[c] = 2 * node.Index[c] + (part >> c & 1);
    }
  }
  for (const std::uint32_t k : node.Kernels)
  {
    const Kernel& kernel = kernels[k];
    unsigned int lowAndHigh[3];
    for (int c = 0; c < 3; ++c)
    {
      const double middle = this->Origin[c] + (2 * node.Index[c] + 1) * side;
      const double x = kernel.Center[c] - middle, reach = kernel.Extent[c] + cell;
      lowAndHigh[c] = (x - reach < 0 && x + reach > -side ? 1u : 0u) |
        (x + reach > 0 && x - reach < side ? 2u : 0u);
    }
    for (int part = 0; part < 8; ++part)
    {
      if ((lowAndHigh[0] >> (part & 1) & 1u) && (lowAndHigh[1] >> (part >> 1 & 1) & 1u) &&
        (lowAndHigh[2] >> (part >> 2) & 1u))
      {
        children[part].Kernels.push_back(k);
      }
    }
  }
  for (Node& child : children)
  {
    if (!child.Kernels.empty())
    {
      child.Kernels.shrink_to_fit();
      parts.push_back(std::move(child));
    }
  }
}

bool vtkParticleSurfaceTree::Build(vtkAlgorithm* self, double from, double to,
  const std::vector<Kernel>& kernels, double spacing)
{
  this->Leaves.clear();
  if (kernels.empty())
  {
    return true;
  }
  this->Cell = CellPerSpacing * spacing;
  std::vector<Node> nodes(1);
  nodes[0] = this->MakeRoot(kernels);
  const int levels = std::max(nodes[0].Level, 1);
  for (int done = 0; !nodes.empty(); ++done)
  {
    std::vector<std::vector<Node>> parts(nodes.size());
    std::vector<unsigned char> fine(nodes.size());
    auto split = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType n = begin; n < end; ++n)
      {
        fine[n] = this->IsFine(nodes[n], kernels);
        if (!fine[n])
        {
          this->Split(nodes[n], kernels, parts[n]);
          std::vector<std::uint32_t>().swap(nodes[n].Kernels);
        }
      }
    };
    // Where sizes differ there are more levels, at whose number one can only guess.
    const double at = from + (to - from) * std::min(done, levels) / (levels + 1);
    const double next = from + (to - from) * std::min(done + 1, levels) / (levels + 1);
    if (!vtkPointSplatBatches::For(
          self, static_cast<vtkIdType>(nodes.size()), 1, at, next, split))
    {
      return false;
    }
    std::vector<Node> finer;
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      if (fine[n])
      {
        Leaf leaf;
        leaf.Cell = std::ldexp(this->Cell, nodes[n].Level);
        leaf.Turn = 0;
        for (int c = 0; c < 3; ++c)
        {
          leaf.Origin[c] = this->Origin[c] + nodes[n].Index[c] * leaf.GetSide();
          leaf.Turn |= static_cast<int>(nodes[n].Index[c] & 1) << c;
        }
        leaf.Kernels = std::move(nodes[n].Kernels);
        this->Leaves.push_back(std::move(leaf));
      }
      for (Node& part : parts[n])
      {
        finer.push_back(std::move(part));
      }
    }
    nodes.swap(finer);
  }
  std::stable_sort(this->Leaves.begin(), this->Leaves.end(), [](const Leaf& a, const Leaf& b) {
    return std::tie(a.Cell, a.Turn) < std::tie(b.Cell, b.Turn);
  });
  return true;
}

VTK_ABI_NAMESPACE_END
