// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceEdges
 * @brief   a point on each edge of the grid that an isosurface crosses, and in cells where it bends
 *
 * Internal; see the stages in vtkIsosurfacePoints. Find() sweeps the slices for crossed edges, and finds
 * where these are crossed; where sizes are wanted it then goes through each cell's outlines once, which
 * tell their points how far to reach, and those that are bent are kept for Write(). Slices are done in
 * parallel: the edges of one are reached from the cells on either side, by different threads, so that
 * each side has its own array.
 */
#ifndef vtkIsosurfaceEdges_h
#define vtkIsosurfaceEdges_h

#include "vtkIsosurfaceEdgeLists.h"
#include "vtkIsosurfaceExtraction.h"
#include "vtkPointSplatBatches.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>

VTK_ABI_NAMESPACE_BEGIN

template <typename T>
class vtkIsosurfaceEdges : public vtkIsosurfaceExtraction
{
public:
  /// sizes, fillGaps: whether points get their sizes, and whether there are fill points as well.
  vtkIsosurfaceEdges(const vtkIsosurfaceGrid& grid, const T* values,
    const std::vector<double>& isovalues, bool sizes, bool fillGaps)
    : Field(grid, values, isovalues)
    , Sizes(sizes)
    , FillGaps(sizes && fillGaps)
    , Least(LeastReach * std::min({ grid.Spacing[0], grid.Spacing[1], grid.Spacing[2] }))
    , Slices(grid.Dimensions[2])
  {
  }

  bool Find(
    vtkAlgorithm* self, double from, double to, std::vector<vtkIdType>& counts) override
  {
    vtkSMPThreadLocal<Classes> classes;
    auto sweep = [&](vtkIdType begin, vtkIdType end) {
      this->Sweep(begin, end, classes.Local());
      for (vtkIdType k = begin; k < end; ++k)
      {
        this->Cross(k);
      }
    };
    auto measure = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType k = begin; k < end; ++k)
      {
        this->MeasureOutlines(k);
      }
    };
    const vtkIdType slices = this->Field.Grid.Dimensions[2];
    const double swept = this->Sizes ? 0.5 * (from + to) : to;
    if (!vtkPointSplatBatches::For(self, slices, 8, from, swept, sweep) ||
      (this->Sizes && !vtkPointSplatBatches::For(self, slices - 1, 1, swept, to, measure)))
    {
      return false;
    }
    counts.assign(this->Field.Isovalues.size(), 0);
    for (Slice& slice : this->Slices)
    {
      slice.First = counts;
      for (const Edge& edge : slice.Edges)
      {
        ++counts[edge.Isovalue];
      }
    }
    for (Slice& slice : this->Slices)
    {
      slice.FirstFill = counts;
      for (const Bent& bent : slice.Bents)
      {
        ++counts[bent.Isovalue];
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
        const Slice& slice = this->Slices[k];
        std::vector<vtkIdType> next = slice.First;
        for (std::size_t i = 0; i < slice.Edges.size(); ++i)
        {
          const Class v = slice.Edges[i].Isovalue;
          this->WritePoint(k, i, targets[v], next[v]++);
        }
        next = slice.FirstFill;
        for (const Bent& bent : slice.Bents)
        {
          this->WriteFill(bent, k, targets[bent.Isovalue], next[bent.Isovalue]++);
        }
      }
    };
    return vtkPointSplatBatches::For(
      self, this->Field.Grid.Dimensions[2], 1, from, to, write);
  }

private:
  using Lists = vtkIsosurfaceEdgeLists;
  using Class = Lists::Class;
  using Edge = Lists::Edge;
  using Crossing = Lists::Crossing;
  using Bent = Lists::Bent;
  using Slice = Lists::Slice;
  using Cell = Lists::Cell;
  using Origin = std::array<vtkIdType, 3>; // of a cell, its first sample
  using Classes = std::array<std::vector<Class>, 2>; // of a slice and the next one

  void Sweep(vtkIdType begin, vtkIdType end, Classes& classes)
  {
    const vtkIdType* n = this->Field.Grid.Dimensions;
    const vtkIdType stride = this->Field.GetClassStride();
    std::vector<Class>*here = &classes[0], *above = &classes[1];
    this->Field.Classify(begin, *here);
    for (vtkIdType k = begin; k < end; ++k)
    {
      if (k + 1 < n[2])
      {
        this->Field.Classify(k + 1, *above);
      }
      Slice& slice = this->Slices[k];
      for (vtkIdType j = 0; j < n[1]; ++j)
      {
        // Beyond the last row or slice a row is compared with itself.
        const Class* row = here->data() + stride * j;
        slice.Rows.push_back(slice.Edges.size());
        this->SweepRow(
          row, j + 1 < n[1] ? row + stride : row, k + 1 < n[2] ? above->data() + stride * j : row,
          j, k, slice);
      }
      slice.Rows.push_back(slice.Edges.size());
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
    }
  }

  /// Finds where the edges of a slice are crossed.
  void Cross(vtkIdType k)
  {
    Slice& slice = this->Slices[k];
    slice.Crossings.reserve(slice.Edges.size());
    for (const Edge& edge : slice.Edges)
    {
      slice.Crossings.push_back(this->GetCrossing(edge, k));
    }
    if (this->Sizes)
    {
      for (std::vector<float>& reaches : slice.Reaches)
      {
        reaches.assign(slice.Edges.size(), 0.0f);
      }
    }
  }

  Crossing GetCrossing(const Edge& edge, vtkIdType k) const
  {
    const int axis = edge.Axis;
    const vtkIdType from[3] = { edge.I, edge.J, k };
    const vtkIdType to[3] = { from[0] + (axis == 0), from[1] + (axis == 1), from[2] + (axis == 2) };
    const double s0 = this->Field.Get(from[0], from[1], from[2]);
    const double s1 = this->Field.Get(to[0], to[1], to[2]);
    const double isovalue = this->Field.Isovalues[edge.Isovalue];
    Crossing crossing;
    // Halves, since differences of doubles may overflow.
    crossing.Along = (0.5 * isovalue - 0.5 * s0) / (0.5 * s1 - 0.5 * s0);
    double g0[3], g1[3], normal[3];
    this->Field.GetGradient(from, g0);
    this->Field.GetGradient(to, g1);
    for (int c = 0; c < 3; ++c)
    {
      g0[c] += crossing.Along * (g1[c] - g0[c]);
    }
    if (!this->Field.Grid.GetNormal(g0, normal))
    {
      // A sheet one sample thick has the same value on both sides; the edge knows better.
      double along[3] = { 0, 0, 0 };
      along[axis] = s1 > s0 ? 1 : -1;
      this->Field.Grid.GetNormal(along, normal);
    }
    crossing.Slope = this->Field.Grid.GetSlope(g0, normal);
    std::copy_n(normal, 3, crossing.Normal);
    return crossing;
  }

  void WritePoint(vtkIdType k, std::size_t i, const Target& target, vtkIdType id) const
  {
    const Edge& edge = this->Slices[k].Edges[i];
    const Crossing& crossing = this->Slices[k].Crossings[i];
    const int axis = edge.Axis;
    const vtkIdType from[3] = { edge.I, edge.J, k };
    double index[3] = { static_cast<double>(from[0]), static_cast<double>(from[1]),
      static_cast<double>(from[2]) };
    index[axis] += crossing.Along;
    vtkIsosurfaceSplat splat;
    this->Field.Grid.GetWorld(index, splat.Position);
    std::copy_n(crossing.Normal, 3, splat.Normal);
    if (target.HasSizes())
    {
      splat.Radius = this->GetRadius(k, i);
      const vtkIdType to[3] = { from[0] + (axis == 0), from[1] + (axis == 1),
        from[2] + (axis == 2) };
      double h0[6], h1[6];
      this->Field.GetHessian(from, h0);
      this->Field.GetHessian(to, h1);
      for (int c = 0; c < 6; ++c)
      {
        h0[c] += crossing.Along * (h1[c] - h0[c]);
      }
      this->Field.Grid.Bend(crossing.Slope, h0, splat);
    }
    target.Put(id, splat);
  }

  /// Of the cells between a slice and the next one.
  void MeasureOutlines(vtkIdType k)
  {
    const vtkIdType* n = this->Field.Grid.Dimensions;
    for (vtkIdType j = 0; j + 1 < n[1]; ++j)
    {
      Lists::VisitRow(this->Slices[k], this->Slices[k + 1], j, [&](vtkIdType i, const Cell& cell) {
        for (int v = cell.GetLeast(); v <= cell.GetMost(); ++v)
        {
          this->MeasureOutlines({ i, j, k }, cell, static_cast<Class>(v));
        }
      });
    }
  }

  /// Of a cell.
  void MeasureOutlines(const Origin& origin, const Cell& cell, Class isovalue)
  {
    double values[8];
    if (!this->GetCell(origin.data(), this->Field.Isovalues[isovalue], values))
    {
      return;
    }
    vtkIsosurfaceOutline outline(values, this->Field.Grid.Spacing);
    unsigned int followed = 0; // edges
    const auto bitOf = [](const vtkIsosurfaceOutline::Edge& edge) {
      return 1u << (3 * edge.Corner + edge.Axis);
    };
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const vtkIsosurfaceOutline::Edge start = { corner, axis };
        if ((corner >> axis & 1) == 0 && outline.IsCrossed(start) && !(followed & bitOf(start)))
        {
          outline.Follow(start);
          for (int i = 0; i < outline.GetCount(); ++i)
          {
            followed |= bitOf(outline.GetEdge(i));
          }
          this->Measure(origin, cell, isovalue, outline);
        }
      }
    }
  }

  /// An outline: how far its points' disks reach, and whether it gets a fill point.
  void Measure(
    const Origin& origin, const Cell& cell, Class isovalue, vtkIsosurfaceOutline& outline)
  {
    const int count = outline.GetCount();
    std::optional<std::size_t> ids[vtkIsosurfaceOutline::Most];
    // Large integers that doubles round may lie on the other side of the isovalue here.
    bool complete = true;
    for (int i = 0; i < count; ++i)
    {
      ids[i] = cell.Find(outline.GetEdge(i), isovalue);
      complete = complete && ids[i];
    }
    outline.FindPoints();
    const bool bent = this->FillGaps && complete && this->AddBent(origin, isovalue, outline, ids);
    for (int i = 0; i < count; ++i)
    {
      if (ids[i])
      {
        const int above = outline.GetEdge(i).Corner >> 2;
        float& reach = this->Slices[origin[2] + above].Reaches[above ? 0 : 1][*ids[i]];
        const double wanted = (bent ? BentShare : PlainShare) * outline.GetReach(i);
        reach = std::max(reach, static_cast<float>(std::max(wanted, this->Least)));
      }
    }
  }

  /// Returns whether the outline is bent. ids: of its edges.
  bool AddBent(const Origin& origin, Class isovalue, const vtkIsosurfaceOutline& outline,
    const std::optional<std::size_t>* ids)
  {
    if (!this->Field.Grid.HasCell(origin[0], origin[1], origin[2]))
    {
      return false;
    }
    double offsets[vtkIsosurfaceOutline::Most][3], normals[vtkIsosurfaceOutline::Most][3];
    for (int i = 0; i < outline.GetCount(); ++i)
    {
      const Slice& slice = this->Slices[origin[2] + (outline.GetEdge(i).Corner >> 2)];
      std::copy_n(slice.Crossings[*ids[i]].Normal, 3, normals[i]);
    }
    if (!vtkIsosurfaceFill::IsBent(outline.GetCount(), normals))
    {
      return false;
    }
    for (int i = 0; i < outline.GetCount(); ++i)
    {
      this->GetOffset(outline, i, offsets[i]);
    }
    const vtkIsosurfaceOutline::Edge& start = outline.GetEdge(0);
    Bent bent = { static_cast<std::uint32_t>(origin[0]), static_cast<std::uint32_t>(origin[1]),
      isovalue, static_cast<std::uint8_t>(start.Corner), static_cast<std::uint8_t>(start.Axis), {} };
    if (!bent.Fill.Fit(outline.GetCount(), offsets, normals))
    {
      return false;
    }
    this->Slices[origin[2]].Bents.push_back(bent);
    return true;
  }

  /// From the centroid of an outline to one of its points, world units.
  void GetOffset(const vtkIsosurfaceOutline& outline, int i, double offset[3]) const
  {
    const vtkIsosurfaceGrid& grid = this->Field.Grid;
    for (int r = 0; r < 3; ++r)
    {
      offset[r] = 0;
      for (int c = 0; c < 3; ++c)
      {
        offset[r] += grid.ToWorld[r][c] / grid.Spacing[c] *
          (outline.GetPoint(i)[c] - outline.GetCentroid()[c]);
      }
    }
  }

  void WriteFill(const Bent& bent, vtkIdType k, const Target& target, vtkIdType id) const
  {
    const vtkIdType origin[3] = { bent.I, bent.J, k };
    const double isovalue = this->Field.Isovalues[bent.Isovalue];
    double values[8];
    this->GetCell(origin, isovalue, values);
    vtkIsosurfaceOutline outline(values, this->Field.Grid.Spacing);
    outline.Follow({ bent.Corner, bent.Axis });
    outline.FindPoints();
    vtkIsosurfaceSplat splat;
    double index[3];
    for (int c = 0; c < 3; ++c)
    {
      index[c] = origin[c] + outline.GetCentroid()[c] / this->Field.Grid.Spacing[c];
    }
    this->Field.Grid.GetWorld(index, splat.Position);
    splat.Radius = 0;
    for (int i = 0; i < outline.GetCount(); ++i)
    {
      splat.Radius = std::max(splat.Radius, FillShare * outline.GetReach(i));
    }
    bent.Fill.Apply(splat);
    target.Put(id, splat);
  }

  /// The radius with which disks cover the outlines in the four cells around an edge.
  double GetRadius(vtkIdType k, std::size_t edge) const
  {
    const std::vector<float>* reaches = this->Slices[k].Reaches;
    const double reach = std::max(reaches[0][edge], reaches[1][edge]);
    const double* h = this->Field.Grid.Spacing;
    // With no cell around, all that is known is that the surface ends before the next samples.
    return reach > 0 ? reach : 0.5 * std::min({ h[0], h[1], h[2] });
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
      const T value = first[i * grid.Strides[0] + j * grid.Strides[1] + k * grid.Strides[2]];
      values[corner] = static_cast<double>(value) - isovalue;
      if ((std::is_floating_point<T>::value && !std::isfinite(values[corner])) ||
        grid.IsHidden(origin[0] + i, origin[1] + j, origin[2] + k))
      {
        return false;
      }
    }
    return true;
  }

  /// In sample spacings, where all points around lie at one place.
  static constexpr double LeastReach = 1e-3;
  // From Testing/Accuracy/fit_constants.py:
  /// The radius of a fill point, by its distance to the outline's farthest point; and those of points, by
  /// their distance to the centroid of an outline that has a fill point there, and of another.
  static constexpr double FillShare = 0.8;
  static constexpr double BentShare = 0.65;
  static constexpr double PlainShare = 0.87;

  vtkIsosurfaceField<T> Field;
  bool Sizes;
  bool FillGaps;
  double Least; // reach, world units
  std::vector<Slice> Slices;
};

VTK_ABI_NAMESPACE_END
#endif
