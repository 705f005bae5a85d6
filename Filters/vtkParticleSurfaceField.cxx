// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleSurfaceField.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

void vtkParticleSurfaceField::SetLeaf(const Leaf& leaf, const std::vector<Kernel>& kernels)
{
  this->Cell = leaf.Cell;
  this->Kernels.clear();
  for (const std::uint32_t k : leaf.Kernels)
  {
    const Kernel& kernel = kernels[k];
    Local local;
    for (int c = 0; c < 3; ++c)
    {
      local.Center[c] = static_cast<float>(kernel.Center[c] - leaf.Origin[c]);
      local.Extent[c] = kernel.Extent[c];
    }
    std::copy_n(kernel.Metric, 6, local.Metric);
    local.Amplitude = kernel.Amplitude;
    local.Id = kernel.Id;
    this->Kernels.push_back(local);
  }
  for (Part& part : this->Parts)
  {
    part.Listed = false;
  }
}

const std::vector<float>& vtkParticleSurfaceField::EvaluateNodes()
{
  this->Nodes.assign(static_cast<std::size_t>(NodesPerSide) * NodesPerSide * NodesPerSide, 0.0f);
  for (const Local& kernel : this->Kernels)
  {
    this->AddToNodes(kernel);
  }
  return this->Nodes;
}

void vtkParticleSurfaceField::AddToNodes(const Local& kernel)
{
  const float cell = static_cast<float>(this->Cell);
  auto first = [cell](float x) {
    return static_cast<int>(std::ceil(std::clamp(x / cell, 0.0f, float(NodesPerSide))));
  };
  auto last = [cell](float x) {
    return static_cast<int>(std::floor(std::clamp(x / cell, -1.0f, float(NodesPerSide - 1))));
  };
  const float* m = kernel.Metric;
  const float* x = kernel.Center;
  const int high[2] = { last(x[1] + kernel.Extent[1]), last(x[2] + kernel.Extent[2]) };
  for (int k = first(x[2] - kernel.Extent[2]); k <= high[1]; ++k)
  {
    const float dz = k * cell - x[2];
    for (int j = first(x[1] - kernel.Extent[1]); j <= high[0]; ++j)
    {
      // Along a row q is a square function, less than 1 between its roots.
      const float dy = j * cell - x[1];
      const float b = m[3] * dy + m[5] * dz;
      const float c = m[1] * dy * dy + m[2] * dz * dz + 2 * m[4] * dy * dz;
      const float discriminant = b * b - m[0] * (c - 1);
      if (!(discriminant > 0))
      {
        continue;
      }
      const float half = std::sqrt(discriminant) / m[0], middle = x[0] - b / m[0];
      const int begin = first(middle - half), end = last(middle + half);
      float* row =
        this->Nodes.data() + NodesPerSide * (j + static_cast<std::size_t>(NodesPerSide) * k);
      for (int i = begin; i <= end; ++i)
      {
        const float dx = i * cell - x[0];
        const float t = std::max(1 - (m[0] * dx * dx + 2 * b * dx + c), 0.0f);
        row[i] += kernel.Amplitude * t * t * t;
      }
    }
  }
}

const std::vector<vtkParticleSurfaceField::Local>& vtkParticleSurfaceField::GetKernelsAt(
  const double x[3])
{
  const double side = vtkParticleSurfaceTree::CellsPerSide / PartsPerSide * this->Cell;
  int at[3];
  for (int c = 0; c < 3; ++c)
  {
    at[c] = static_cast<int>(std::clamp(x[c] / side, 0.0, PartsPerSide - 0.5));
  }
  Part& part = this->Parts[at[0] + PartsPerSide * (at[1] + PartsPerSide * at[2])];
  if (!part.Listed)
  {
    part.Listed = true;
    part.Kernels.clear();
    for (const Local& kernel : this->Kernels)
    {
      bool near = true;
      for (int c = 0; c < 3 && near; ++c)
      {
        // Positions outside of the leaf belong to the parts at its border.
        const double reach = kernel.Extent[c] + this->Cell;
        near = kernel.Center[c] + reach > at[c] * side && kernel.Center[c] - reach < (at[c] + 1) * side;
      }
      if (near)
      {
        part.Kernels.push_back(kernel);
      }
    }
  }
  return part.Kernels;
}

void vtkParticleSurfaceField::Evaluate(const double x[3], Value& value)
{
  const float p[3] = { static_cast<float>(x[0]), static_cast<float>(x[1]),
    static_cast<float>(x[2]) };
  float sum = 0, gx = 0, gy = 0, gz = 0;
  for (const Local& kernel : this->GetKernelsAt(x))
  {
    const float* m = kernel.Metric;
    const float d[3] = { p[0] - kernel.Center[0], p[1] - kernel.Center[1],
      p[2] - kernel.Center[2] };
    const float y[3] = { m[0] * d[0] + m[3] * d[1] + m[5] * d[2],
      m[3] * d[0] + m[1] * d[1] + m[4] * d[2], m[5] * d[0] + m[4] * d[1] + m[2] * d[2] };
    const float t = 1 - (d[0] * y[0] + d[1] * y[1] + d[2] * y[2]);
    if (t > 0)
    {
      const float slope = kernel.Amplitude * t * t;
      sum += slope * t;
      gx -= 6 * slope * y[0];
      gy -= 6 * slope * y[1];
      gz -= 6 * slope * y[2];
    }
  }
  value.Sum = sum;
  value.Gradient[0] = gx;
  value.Gradient[1] = gy;
  value.Gradient[2] = gz;
}

void vtkParticleSurfaceField::EvaluateSecond(const double x[3], Value& value)
{
  value = Value();
  for (const Local& kernel : this->GetKernelsAt(x))
  {
    const float* m = kernel.Metric;
    const double d[3] = { x[0] - kernel.Center[0], x[1] - kernel.Center[1],
      x[2] - kernel.Center[2] };
    const double y[3] = { m[0] * d[0] + m[3] * d[1] + m[5] * d[2],
      m[3] * d[0] + m[1] * d[1] + m[4] * d[2], m[5] * d[0] + m[4] * d[1] + m[2] * d[2] };
    const double t = 1 - (d[0] * y[0] + d[1] * y[1] + d[2] * y[2]);
    if (t > 0)
    {
      const double slope = kernel.Amplitude * t * t, bend = 24 * kernel.Amplitude * t;
      const double products[6] = { y[0] * y[0], y[1] * y[1], y[2] * y[2], y[0] * y[1],
        y[1] * y[2], y[0] * y[2] };
      value.Sum += slope * t;
      for (int c = 0; c < 3; ++c)
      {
        value.Gradient[c] -= 6 * slope * y[c];
      }
      for (int k = 0; k < 6; ++k)
      {
        value.Hessian[k] += bend * products[k] - 6 * slope * m[k];
      }
    }
  }
}

void vtkParticleSurfaceField::GetShares(const double x[3], std::vector<Share>& shares)
{
  shares.clear();
  double sum = 0;
  for (const Local& kernel : this->GetKernelsAt(x))
  {
    const float* m = kernel.Metric;
    const double d[3] = { x[0] - kernel.Center[0], x[1] - kernel.Center[1],
      x[2] - kernel.Center[2] };
    const double t = 1 -
      (m[0] * d[0] * d[0] + m[1] * d[1] * d[1] + m[2] * d[2] * d[2] +
        2 * (m[3] * d[0] * d[1] + m[4] * d[1] * d[2] + m[5] * d[0] * d[2]));
    if (t > 0)
    {
      shares.push_back({ kernel.Id, kernel.Amplitude * t * t * t });
      sum += shares.back().Weight;
    }
  }
  for (Share& share : shares)
  {
    share.Weight /= sum;
  }
}

VTK_ABI_NAMESPACE_END
