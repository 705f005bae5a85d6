// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceSamples
 * @brief   points on isosurfaces at a wanted distance from each other
 *
 * Internal; see the stages in vtkIsosurfacePoints.
 */
#ifndef vtkIsosurfaceSamples_h
#define vtkIsosurfaceSamples_h

#include "vtkIsosurfaceExtraction.h"
#include "vtkIsosurfaceField.h"
#include "vtkIsosurfaceInterpolant.h"
#include "vtkIsosurfaceThinning.h"
#include "vtkPointSplatBatches.h"
#include "vtkSMPThreadLocal.h"

VTK_ABI_NAMESPACE_BEGIN

template <typename T>
class vtkIsosurfaceSamples : public vtkIsosurfaceExtraction
{
public:
  /// The least spacing of points for which voxels are divided far enough, in voxels.
  static constexpr double FinestSpacing = 2.5 / 64;

  vtkIsosurfaceSamples(const vtkIsosurfaceGrid& grid, const T* values,
    const std::vector<double>& isovalues, double spacing)
    : Field(grid, values, isovalues)
    , Distance(DistancePerSpacing * spacing)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Divisions[c] = static_cast<int>(
        std::max(std::ceil(CandidatesPerSpacing * grid.Spacing[c] / spacing), 1.0));
    }
    // A slab must keep those beside it farther apart than points keep each other.
    const double cells = static_cast<double>(grid.Dimensions[2] - 1);
    this->Thickness =
      static_cast<vtkIdType>(std::min(std::ceil(3 * this->Distance / grid.Spacing[2]), cells));
    this->Slabs.resize((grid.Dimensions[2] - 1 + this->Thickness - 1) / this->Thickness);
    for (Slab& slab : this->Slabs)
    {
      slab.Surfaces.assign(isovalues.size(), vtkIsosurfaceThinning(this->Distance));
    }
  }

  bool Find(
    vtkAlgorithm* self, double from, double to, std::vector<vtkIdType>& counts) override
  {
    vtkSMPThreadLocal<Scratch> scratches;
    const vtkIdType slabs = static_cast<vtkIdType>(this->Slabs.size());
    for (vtkIdType turn = 0; turn < 2; ++turn)
    {
      auto fill = [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType s = begin; s < end; ++s)
        {
          this->FillSlab(2 * s + turn, scratches.Local());
        }
      };
      const double middle = 0.5 * (from + to);
      if (!vtkPointSplatBatches::For(self, (slabs + 1 - turn) / 2, 1, turn ? middle : from,
            turn ? to : middle, fill))
      {
        return false;
      }
    }
    counts.assign(this->Field.Isovalues.size(), 0);
    for (Slab& slab : this->Slabs)
    {
      slab.First = counts;
      for (std::size_t v = 0; v < counts.size(); ++v)
      {
        counts[v] += static_cast<vtkIdType>(slab.Surfaces[v].GetSamples().size());
      }
    }
    return true;
  }

  bool Write(
    vtkAlgorithm* self, double from, double to, const std::vector<Target>& targets) const override
  {
    auto write = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType s = begin; s < end; ++s)
      {
        this->WriteSlab(this->Slabs[s], targets);
      }
    };
    return vtkPointSplatBatches::For(
      self, static_cast<vtkIdType>(this->Slabs.size()), 1, from, to, write);
  }

private:
  using Class = typename vtkIsosurfaceField<T>::Class;
  using Sample = vtkIsosurfaceThinning::Sample;

  /// Points keep this part of the wanted spacing as their least distance.
  static constexpr double DistancePerSpacing = 0.8;
  /// And are chosen from candidates that are denser by this factor.
  static constexpr double CandidatesPerSpacing = 2.5;

  struct Slab
  {
    std::vector<vtkIsosurfaceThinning> Surfaces; // one for each isovalue
    std::vector<vtkIdType> First;
  };
  struct Scratch
  {
    std::vector<Class> Classes[2];
    std::vector<T> Row;
    std::vector<std::vector<Sample>> Candidates; // for each isovalue
    std::vector<double> Layers[2];
  };
  struct Cell
  {
    vtkIdType Index[3];
    double Corners[8]; // less the isovalue
  };

  void FillSlab(vtkIdType s, Scratch& scratch)
  {
    scratch.Candidates.resize(this->Field.Isovalues.size());
    for (std::vector<Sample>& candidates : scratch.Candidates)
    {
      candidates.clear();
    }
    const vtkIdType* n = this->Field.Grid.Dimensions;
    const vtkIdType begin = s * this->Thickness;
    const vtkIdType end = std::min(begin + this->Thickness, n[2] - 1);
    std::vector<Class>*here = &scratch.Classes[0], *above = &scratch.Classes[1];
    this->Field.Classify(begin, *here, scratch.Row);
    for (vtkIdType k = begin; k < end; ++k)
    {
      this->Field.Classify(k + 1, *above, scratch.Row);
      for (vtkIdType j = 0; j + 1 < n[1]; ++j)
      {
        this->SweepRow(j, k, here->data(), above->data(), scratch);
      }
      std::swap(here, above);
    }
    for (std::size_t v = 0; v < scratch.Candidates.size(); ++v)
    {
      vtkIsosurfaceThinning& surface = this->Slabs[s].Surfaces[v];
      // In the second turn those beside it stand already.
      const vtkIsosurfaceThinning* before = s % 2 ? &this->Slabs[s - 1].Surfaces[v] : nullptr;
      const vtkIsosurfaceThinning* after = s % 2 && s + 1 < vtkIdType(this->Slabs.size())
        ? &this->Slabs[s + 1].Surfaces[v]
        : nullptr;
      vtkIsosurfaceThinning::Shuffle(scratch.Candidates[v]);
      for (const Sample& candidate : scratch.Candidates[v])
      {
        if (!surface.HasNear(candidate) && !(before && before->HasNear(candidate)) &&
          !(after && after->HasNear(candidate)))
        {
          surface.Add(candidate);
        }
      }
    }
  }

  /// Finds the crossed cells of a row, eight at a time.
  void SweepRow(vtkIdType j, vtkIdType k, const Class* here, const Class* above, Scratch& scratch)
    const
  {
    const vtkIdType cells = this->Field.Grid.Dimensions[0] - 1;
    const vtkIdType stride = this->Field.GetClassStride();
    const Class* rows[4] = { here + stride * j, here + stride * (j + 1), above + stride * j,
      above + stride * (j + 1) };
    for (vtkIdType i = 0; i < cells; i += 8)
    {
      std::uint64_t first, difference = 0;
      std::memcpy(&first, rows[0] + i, 8);
      for (const Class* row : rows)
      {
        std::uint64_t left, right;
        std::memcpy(&left, row + i, 8);
        std::memcpy(&right, row + i + 1, 8);
        difference |= (first ^ left) | (first ^ right);
      }
      if (difference == 0)
      {
        continue;
      }
      for (vtkIdType l = i; l < std::min(i + 8, cells); ++l)
      {
        Class low = rows[0][l], high = low;
        for (const Class* row : rows)
        {
          low = std::min({ low, row[l], row[l + 1] });
          high = std::max({ high, row[l], row[l + 1] });
        }
        if (low < high)
        {
          this->AddCell(l, j, k, low, high, scratch);
        }
      }
    }
  }

  void AddCell(
    vtkIdType i, vtkIdType j, vtkIdType k, Class low, Class high, Scratch& scratch) const
  {
    if (!this->Field.Grid.HasCell(i, j, k))
    {
      return;
    }
    double corners[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      const vtkIdType x = i + (corner & 1), y = j + (corner >> 1 & 1), z = k + (corner >> 2);
      if (!this->Field.IsUsable(x, y, z))
      {
        return;
      }
      corners[corner] = this->Field.Get(x, y, z);
    }
    for (Class v = low; v < high; ++v)
    {
      Cell cell;
      cell.Index[0] = i;
      cell.Index[1] = j;
      cell.Index[2] = k;
      for (int corner = 0; corner < 8; ++corner)
      {
        cell.Corners[corner] = corners[corner] - this->Field.Isovalues[v];
      }
      this->Divide(cell, scratch.Layers, scratch.Candidates[v]);
    }
  }

  /// The crossings of the sub-cells' edges, layer by layer.
  void Divide(const Cell& cell, std::vector<double> layers[2], std::vector<Sample>& samples) const
  {
    const int* m = this->Divisions;
    const std::size_t row = m[0] + 1;
    for (int c = 0; c <= m[2]; ++c)
    {
      std::vector<double>& layer = layers[c % 2];
      const std::vector<double>& below = layers[1 - c % 2];
      layer.resize(row * (m[1] + 1));
      for (int b = 0; b <= m[1]; ++b)
      {
        const double y = double(b) / m[1], z = double(c) / m[2];
        const double* s = cell.Corners;
        const double left =
          (1 - z) * ((1 - y) * s[0] + y * s[2]) + z * ((1 - y) * s[4] + y * s[6]);
        const double right =
          (1 - z) * ((1 - y) * s[1] + y * s[3]) + z * ((1 - y) * s[5] + y * s[7]);
        for (int a = 0; a <= m[0]; ++a)
        {
          const double x = double(a) / m[0];
          const double value = (1 - x) * left + x * right;
          layer[row * b + a] = value;
          // Along an axis the interpolant is linear: these crossings lie on it.
          const double others[3] = { a > 0 ? layer[row * b + a - 1] : value,
            b > 0 ? layer[row * (b - 1) + a] : value, c > 0 ? below[row * b + a] : value };
          for (int axis = 0; axis < 3; ++axis)
          {
            if ((value >= 0) != (others[axis] >= 0))
            {
              double at[3] = { x, y, z };
              at[axis] -= value / (value - others[axis]) / m[axis];
              this->AddSample(cell, at, samples);
            }
          }
        }
      }
    }
  }

  void AddSample(const Cell& cell, const double at[3], std::vector<Sample>& samples) const
  {
    const double* s = cell.Corners;
    const double x = at[0], y = at[1], z = at[2];
    const double gradient[3] = {
      (1 - z) * ((1 - y) * (s[1] - s[0]) + y * (s[3] - s[2])) +
        z * ((1 - y) * (s[5] - s[4]) + y * (s[7] - s[6])),
      (1 - z) * ((1 - x) * (s[2] - s[0]) + x * (s[3] - s[1])) +
        z * ((1 - x) * (s[6] - s[4]) + x * (s[7] - s[5])),
      (1 - y) * ((1 - x) * (s[4] - s[0]) + x * (s[5] - s[1])) +
        y * ((1 - x) * (s[6] - s[2]) + x * (s[7] - s[3]))
    };
    const double largest =
      std::max({ std::abs(gradient[0]), std::abs(gradient[1]), std::abs(gradient[2]) });
    Sample sample;
    for (int c = 0; c < 3; ++c)
    {
      sample.Position[c] = (cell.Index[c] + at[c]) * this->Field.Grid.Spacing[c];
      sample.Side[c] = largest > 0
        ? static_cast<float>(gradient[c] / largest / this->Field.Grid.Spacing[c] *
            this->Field.Grid.Spacing[0])
        : 0.0f;
    }
    samples.push_back(sample);
  }

  void WriteSlab(const Slab& slab, const std::vector<Target>& targets) const
  {
    const vtkIsosurfaceInterpolant<T> interpolant(this->Field);
    const vtkIsosurfaceGrid& grid = this->Field.Grid;
    for (std::size_t v = 0; v < targets.size(); ++v)
    {
      vtkIdType id = slab.First[v];
      for (const Sample& sample : slab.Surfaces[v].GetSamples())
      {
        double index[3], gradient[3];
        vtkIsosurfaceSplat splat;
        for (int c = 0; c < 3; ++c)
        {
          index[c] = sample.Position[c] / grid.Spacing[c];
        }
        interpolant.Place(this->Field.Isovalues[v], index, gradient);
        if (!grid.GetNormal(gradient, splat.Normal))
        {
          double side[3];
          for (int c = 0; c < 3; ++c)
          {
            side[c] = sample.Side[c] * grid.Spacing[c];
          }
          if (!grid.GetNormal(side, splat.Normal))
          {
            splat.Normal[0] = splat.Normal[1] = 0;
            splat.Normal[2] = 1;
          }
        }
        grid.GetWorld(index, splat.Position);
        if (targets[v].HasSizes())
        {
          double hessian[6];
          interpolant.InterpolateHessian(index, hessian);
          splat.Radius = RadiusPerDistance * this->Distance;
          grid.Bend(gradient, hessian, splat);
        }
        targets[v].Put(id++, splat);
      }
    }
  }

  /// No candidate is farther than the distance from a point, but what is between candidates.
  static constexpr double RadiusPerDistance = 1.1;

  vtkIsosurfaceField<T> Field;
  double Distance;
  int Divisions[3];
  vtkIdType Thickness; // of a slab, in cells
  std::vector<Slab> Slabs;
};

VTK_ABI_NAMESPACE_END
#endif
