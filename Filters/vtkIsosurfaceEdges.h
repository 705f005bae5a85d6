// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceEdges
 * @brief   a point on each edge of the grid that an isosurface crosses
 *
 * Internal; see the stages in vtkIsosurfacePoints.
 */
#ifndef vtkIsosurfaceEdges_h
#define vtkIsosurfaceEdges_h

#include "vtkIsosurfaceExtraction.h"
#include "vtkIsosurfaceField.h"
#include "vtkIsosurfaceOutline.h"
#include "vtkPointSplatBatches.h"
#include "vtkSMPThreadLocal.h"

VTK_ABI_NAMESPACE_BEGIN

template <typename T>
class vtkIsosurfaceEdges : public vtkIsosurfaceExtraction
{
public:
  vtkIsosurfaceEdges(
    const vtkIsosurfaceGrid& grid, const T* values, const std::vector<double>& isovalues)
    : Field(grid, values, isovalues)
    , Slices(grid.Dimensions[2])
  {
  }

  bool Find(
    vtkAlgorithm* self, double from, double to, std::vector<vtkIdType>& counts) override
  {
    vtkSMPThreadLocal<Scratch> scratches;
    auto sweep = [&](vtkIdType begin, vtkIdType end) {
      this->Sweep(begin, end, scratches.Local());
    };
    const vtkIdType slices = this->Field.Grid.Dimensions[2];
    if (!vtkPointSplatBatches::For(self, slices, 8, from, to, sweep))
    {
      return false;
    }
    counts.assign(this->Field.Isovalues.size(), 0);
    for (Slice& slice : this->Slices)
    {
      slice.First = counts;
      for (std::size_t v = 0; v < counts.size(); ++v)
      {
        counts[v] += slice.Counts[v];
      }
    }
    return true;
  }

  bool Write(
    vtkAlgorithm* self, double from, double to, const std::vector<Target>& targets) const override
  {
    auto write = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType k = begin; k < end; ++k)
      {
        std::vector<vtkIdType> next = this->Slices[k].First;
        for (const Edge& edge : this->Slices[k].Edges)
        {
          this->WritePoint(edge, k, targets[edge.Isovalue], next[edge.Isovalue]++);
        }
      }
    };
    return vtkPointSplatBatches::For(
      self, this->Field.Grid.Dimensions[2], 1, from, to, write);
  }

private:
  using Class = typename vtkIsosurfaceField<T>::Class;

  /// From sample (I, J, slice) one step along an axis.
  struct Edge
  {
    std::uint32_t I, J;
    std::uint8_t Axis;
    Class Isovalue;
  };
  struct Slice
  {
    std::vector<Edge> Edges;
    std::vector<vtkIdType> Counts, First; // for each isovalue
  };
  struct Scratch
  {
    std::vector<Class> Classes[2];
    std::vector<T> Row;
  };

  void Sweep(vtkIdType begin, vtkIdType end, Scratch& scratch)
  {
    const vtkIdType* n = this->Field.Grid.Dimensions;
    const vtkIdType stride = this->Field.GetClassStride();
    std::vector<Class>*here = &scratch.Classes[0], *above = &scratch.Classes[1];
    this->Field.Classify(begin, *here, scratch.Row);
    for (vtkIdType k = begin; k < end; ++k)
    {
      if (k + 1 < n[2])
      {
        this->Field.Classify(k + 1, *above, scratch.Row);
      }
      Slice& slice = this->Slices[k];
      slice.Counts.assign(this->Field.Isovalues.size(), 0);
      for (vtkIdType j = 0; j < n[1]; ++j)
      {
        // Beyond the last row or slice a row is compared with itself.
        const Class* row = here->data() + stride * j;
        this->SweepRow(
          row, j + 1 < n[1] ? row + stride : row, k + 1 < n[2] ? above->data() + stride * j : row,
          j, k, slice);
      }
      std::swap(here, above);
    }
  }

  /// Compares a row with itself one further on, the next row and the next slice, by words.
  void SweepRow(const Class* row, const Class* nextRow, const Class* nextSlice, vtkIdType j,
    vtkIdType k, Slice& slice) const
  {
    const vtkIdType n = this->Field.Grid.Dimensions[0];
    const Class* others[3] = { row + 1, nextRow, nextSlice };
    for (vtkIdType i = 0; i < n; i += 8)
    {
      std::uint64_t word, x, y, z;
      std::memcpy(&word, row + i, 8);
      std::memcpy(&x, others[0] + i, 8);
      std::memcpy(&y, others[1] + i, 8);
      std::memcpy(&z, others[2] + i, 8);
      if (((word ^ x) | (word ^ y) | (word ^ z)) == 0)
      {
        continue;
      }
      for (vtkIdType l = i; l < std::min(i + 8, n); ++l)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          if (row[l] != others[axis][l])
          {
            this->AddEdge(l, j, k, axis, std::minmax(row[l], others[axis][l]), slice);
          }
        }
      }
    }
  }

  void AddEdge(vtkIdType i, vtkIdType j, vtkIdType k, int axis,
    std::pair<Class, Class> classes, Slice& slice) const
  {
    const vtkIsosurfaceGrid& grid = this->Field.Grid;
    const vtkIdType end[3] = { i + (axis == 0), j + (axis == 1), k + (axis == 2) };
    if (!this->Field.IsUsable(i, j, k) || !this->Field.IsUsable(end[0], end[1], end[2]))
    {
      return;
    }
    if (grid.CellGhosts)
    {
      // The four cells around the edge.
      const vtkIdType u[3] = { axis == 0 ? 0 : 1, axis == 0 ? 1 : 0, 0 };
      const vtkIdType v[3] = { 0, axis == 2 ? 1 : 0, axis == 2 ? 0 : 1 };
      if (!grid.HasCell(i, j, k) && !grid.HasCell(i - u[0], j - u[1], k - u[2]) &&
        !grid.HasCell(i - v[0], j - v[1], k - v[2]) &&
        !grid.HasCell(i - u[0] - v[0], j - u[1] - v[1], k - u[2] - v[2]))
      {
        return;
      }
    }
    for (Class v = classes.first; v < classes.second; ++v)
    {
      slice.Edges.push_back({ static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
        static_cast<std::uint8_t>(axis), v });
      ++slice.Counts[v];
    }
  }

  void WritePoint(const Edge& edge, vtkIdType k, const Target& target, vtkIdType id) const
  {
    const int axis = edge.Axis;
    const vtkIdType from[3] = { edge.I, edge.J, k };
    const vtkIdType to[3] = { from[0] + (axis == 0), from[1] + (axis == 1), from[2] + (axis == 2) };
    const double s0 = this->Field.Get(from[0], from[1], from[2]);
    const double s1 = this->Field.Get(to[0], to[1], to[2]);
    // Halves, since differences of doubles may overflow.
    const double t =
      (0.5 * this->Field.Isovalues[edge.Isovalue] - 0.5 * s0) / (0.5 * s1 - 0.5 * s0);
    double index[3] = { static_cast<double>(from[0]), static_cast<double>(from[1]),
      static_cast<double>(from[2]) };
    index[axis] += t;
    double g0[3], g1[3];
    vtkIsosurfaceSplat splat;
    this->Field.GetGradient(from, g0);
    this->Field.GetGradient(to, g1);
    for (int c = 0; c < 3; ++c)
    {
      g0[c] += t * (g1[c] - g0[c]);
    }
    this->Field.Grid.GetWorld(index, splat.Position);
    if (!this->Field.Grid.GetNormal(g0, splat.Normal))
    {
      // A sheet one sample thick has the same value on both sides; the edge knows better.
      double along[3] = { 0, 0, 0 };
      along[axis] = s1 > s0 ? 1 : -1;
      this->Field.Grid.GetNormal(along, splat.Normal);
    }
    if (target.HasSizes())
    {
      splat.Radius = this->GetRadius(from, axis, this->Field.Isovalues[edge.Isovalue]);
      double h0[6], h1[6];
      this->Field.GetHessian(from, h0);
      this->Field.GetHessian(to, h1);
      for (int c = 0; c < 6; ++c)
      {
        h0[c] += t * (h1[c] - h0[c]);
      }
      this->Field.Grid.Bend(g0, h0, splat);
    }
    target.Put(id, splat);
  }

  /// The radius with which disks cover the outlines in the four cells around an edge.
  double GetRadius(const vtkIdType from[3], int axis, double isovalue) const
  {
    const double* h = this->Field.Grid.Spacing;
    const double least = std::min({ h[0], h[1], h[2] });
    double reach = 0;
    bool found = false;
    for (int side = 0; side < 4; ++side)
    {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      vtkIdType origin[3] = { from[0], from[1], from[2] };
      origin[u] -= side & 1;
      origin[v] -= side >> 1;
      double values[8];
      if (this->GetCell(origin, isovalue, values))
      {
        const vtkIsosurfaceOutline outline(values, h);
        reach = std::max(reach, outline.GetReach((side & 1) << u | (side >> 1) << v, axis));
        found = true;
      }
    }
    // With no cell around, all that is known is that the surface ends before the next samples.
    return found ? std::max(reach, LeastReach * least) : 0.5 * least;
  }

  /// A cell's samples less the isovalue; false where one of them is not to be used.
  bool GetCell(const vtkIdType origin[3], double isovalue, double values[8]) const
  {
    for (int c = 0; c < 3; ++c)
    {
      if (origin[c] < 0 || origin[c] + 1 >= this->Field.Grid.Dimensions[c])
      {
        return false;
      }
    }
    const vtkIsosurfaceGrid& grid = this->Field.Grid;
    const T* first = this->Field.GetPointer(origin[0], origin[1], origin[2]);
    for (int corner = 0; corner < 8; ++corner)
    {
      const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
      values[corner] = static_cast<double>(
                         first[i * grid.Strides[0] + j * grid.Strides[1] + k * grid.Strides[2]]) -
        isovalue;
      if (!std::isfinite(values[corner]) ||
        grid.IsHidden(origin[0] + i, origin[1] + j, origin[2] + k))
      {
        return false;
      }
    }
    return true;
  }

  /// In sample spacings, where all points around lie at one place.
  static constexpr double LeastReach = 1e-3;

  vtkIsosurfaceField<T> Field;
  std::vector<Slice> Slices;
};

VTK_ABI_NAMESPACE_END
#endif
