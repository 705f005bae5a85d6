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
    local.Deep = kernel.Deep;
    local.Id = kernel.Id;
    this->Kernels.push_back(local);
  }
  for (Part& part : this->Parts)
  {
    part.Listed = false;
  }
}

void vtkParticleSurfaceField::EvaluateNodes()
{
  this->Nodes.assign(static_cast<std::size_t>(NodesPerSide) * NodesPerSide * NodesPerSide, 0.0f);
  this->MarkRows();
  for (const Local& kernel : this->Kernels)
  {
    this->AddToNodes(kernel);
  }
}

/// Deep inside the fluid nobody asks for the sum.
void vtkParticleSurfaceField::MarkRows()
{
  for (auto& rows : this->NearRows)
  {
    std::fill_n(rows, PartsPerSide, false);
  }
  const double side = PartSide * this->Cell;
  auto find = [side](double x) {
    return static_cast<int>(std::floor(std::clamp(x / side, -1.0, double(PartsPerSide))));
  };
  for (const Local& kernel : this->Kernels)
  {
    if (kernel.Deep)
    {
      continue;
    }
    const int begin[2] = { std::max(find(kernel.Center[1] - kernel.Extent[1]), 0),
      std::max(find(kernel.Center[2] - kernel.Extent[2]), 0) };
    const int end[2] = { std::min(find(kernel.Center[1] + kernel.Extent[1]), PartsPerSide - 1),
      std::min(find(kernel.Center[2] + kernel.Extent[2]), PartsPerSide - 1) };
    for (int j = begin[0]; j <= end[0]; ++j)
    {
      std::fill(&this->NearRows[j][begin[1]], &this->NearRows[j][begin[1]] +
          std::max(end[1] - begin[1] + 1, 0), true);
    }
  }
  for (int j = 0; j < NodesPerSide; ++j)
  {
    for (int k = 0; k < NodesPerSide; ++k)
    {
      // A row of nodes is an edge of four rows of cells.
      bool near = false;
      for (int cell = 0; cell < 4; ++cell)
      {
        const int row[2] = { j - (cell & 1), k - (cell >> 1) };
        near = near ||
          (row[0] >= 0 && row[1] >= 0 && row[0] < NodesPerSide - 1 && row[1] < NodesPerSide - 1 &&
            this->IsNear(row[0], row[1]));
      }
      this->Rows[k][j] = near;
    }
  }
}

void vtkParticleSurfaceField::AddToNodes(const Local& kernel)
{
  // In cells.
  const float cell = static_cast<float>(this->Cell), inverse = 1 / cell;
  const float x = kernel.Center[0] * inverse, y = kernel.Center[1] * inverse,
              z = kernel.Center[2] * inverse;
  float m[6];
  for (int i = 0; i < 6; ++i)
  {
    m[i] = kernel.Metric[i] * cell * cell;
  }
  auto first = [](float at) {
    return static_cast<int>(std::clamp(at, -1.0f, float(NodesPerSide - 1)) + 1);
  };
  auto last = [](float at) {
    return static_cast<int>(std::clamp(at + 1, 0.0f, float(NodesPerSide))) - 1;
  };
  const float extent[2] = { kernel.Extent[1] * inverse, kernel.Extent[2] * inverse };
  const int begin[2] = { first(y - extent[0]), first(z - extent[1]) };
  const int end[2] = { last(y + extent[0]), last(z + extent[1]) };
  const float inverse0 = 1 / m[0];
  for (int k = begin[1]; k <= end[1]; ++k)
  {
    const float dz = k - z;
    for (int j = begin[0]; j <= end[0]; ++j)
    {
      // Along a row q is a square function, less than 1 between its roots.
      const float dy = j - y;
      const float b = m[3] * dy + m[5] * dz;
      const float c = m[1] * dy * dy + m[2] * dz * dz + 2 * m[4] * dy * dz - 1;
      const float discriminant = b * b - m[0] * c;
      if (!(discriminant > 0) || !this->Rows[k][j])
      {
        continue;
      }
      const float half = std::sqrt(discriminant) * inverse0, middle = x - b * inverse0;
      const int from = first(middle - half), to = last(middle + half);
      float* row =
        this->Nodes.data() + NodesPerSide * (j + static_cast<std::size_t>(NodesPerSide) * k);
      for (int i = from; i <= to; ++i)
      {
        const float dx = i - x;
        const float t = std::max(-(m[0] * dx * dx + 2 * b * dx + c), 0.0f);
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
        near = kernel.Center[c] + reach > at[c] * side &&
          kernel.Center[c] - reach < (at[c] + 1) * side;
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
