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

#include "vtkIsosurfaceDivision.h"
#include "vtkIsosurfaceExtraction.h"
#include "vtkIsosurfaceField.h"
#include "vtkIsosurfaceInterpolant.h"
#include "vtkIsosurfaceThinning.h"
#include "vtkPointSplatBatches.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

/// What is kept of a volume's slabs, whatever the scalars' type.
struct vtkIsosurfaceSlabs
{
  struct Slab
  {
    std::vector<vtkIsosurfaceThinning> Surfaces; // one for each isovalue
    std::vector<vtkIdType> First;
  };
  struct Scratch
  {
    std::vector<vtkIsosurfaceClass> Classes[2];
    std::vector<std::vector<vtkIsosurfaceThinning::Sample>> Candidates; // for each isovalue
    vtkIsosurfaceDivision::Scratch Division;
  };
};

template <typename T>
class vtkIsosurfaceSamples : public vtkIsosurfaceExtraction
{
public:
  /// The least spacing of points for which voxels are divided far enough, in voxels.
  static constexpr double FinestSpacing = 2.5 / 64;

  vtkIsosurfaceSamples(const vtkIsosurfaceGrid& grid, const T* values,
    const std::vector<double>& isovalues, double spacing)
    : Field(grid, values, isovalues)
    , Division(grid.Spacing, spacing)
    , Distance(vtkIsosurfaceDivision::DistancePerSpacing * spacing)
  {
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
  using Class = vtkIsosurfaceClass;
  using Sample = vtkIsosurfaceThinning::Sample;
  using Slab = vtkIsosurfaceSlabs::Slab;
  using Scratch = vtkIsosurfaceSlabs::Scratch;

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
    this->Field.Classify(begin, *here);
    for (vtkIdType k = begin; k < end; ++k)
    {
      this->Field.Classify(k + 1, *above);
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
      vtkIsosurfaceDivision::Cell cell;
      cell.Index[0] = i;
      cell.Index[1] = j;
      cell.Index[2] = k;
      for (int corner = 0; corner < 8; ++corner)
      {
        cell.Corners[corner] = corners[corner] - this->Field.Isovalues[v];
      }
      this->Division.Divide(cell, scratch.Division, scratch.Candidates[v]);
    }
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
          grid.Bend(grid.GetSlope(gradient, splat.Normal), hessian, splat);
        }
        targets[v].Put(id++, splat);
      }
    }
  }

  /// No candidate is farther than the distance from a point, but what is between candidates.
  static constexpr double RadiusPerDistance = 1.1;

  vtkIsosurfaceField<T> Field;
  vtkIsosurfaceDivision Division;
  double Distance;
  vtkIdType Thickness; // of a slab, in cells
  std::vector<Slab> Slabs;
};

VTK_ABI_NAMESPACE_END
#endif
