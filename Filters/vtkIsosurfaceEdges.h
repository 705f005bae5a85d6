// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceEdges
 * @brief   a point on each edge of the grid that an isosurface crosses, and in cells where it bends
 *
 * Internal; see the stages in vtkIsosurfacePoints. Find() sweeps the slices for crossed edges; where sizes
 * are wanted it then goes through each cell's outlines once, which tell their points how far to reach,
 * and those that are bent are kept for Write(). Slices are done in parallel: the edges of one are
 * reached from the cells on either side, by different threads, so that each side has its own array.
 */
#ifndef vtkIsosurfaceEdges_h
#define vtkIsosurfaceEdges_h

#include "vtkIsosurfaceExtraction.h"
#include "vtkIsosurfaceField.h"
#include "vtkIsosurfaceFill.h"
#include "vtkIsosurfaceOutline.h"
#include "vtkPointSplatBatches.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

/// What is kept of a volume's slices, whatever the scalars' type.
struct vtkIsosurfaceEdgeLists
{
  /// From sample (I, J, slice) one step along an axis.
  struct Edge
  {
    std::uint32_t I, J;
    std::uint8_t Axis;
    vtkIsosurfaceClass Isovalue;

    bool operator<(const Edge& other) const
    {
      return std::tie(this->J, this->I, this->Axis, this->Isovalue) <
        std::tie(other.J, other.I, other.Axis, other.Isovalue);
    }
  };
  /// An outline that is bent, in the cell whose first sample is (I, J, slice), by its first edge.
  struct Bent
  {
    std::uint32_t I, J;
    vtkIsosurfaceClass Isovalue;
    std::uint8_t Corner, Axis;
    vtkIsosurfaceFill Fill;
  };
  struct Slice
  {
    std::vector<Edge> Edges;                 // sorted
    std::vector<std::size_t> Rows;           // the first of each row
    std::vector<float> Normals;              // of edges, for FillGaps
    std::vector<float> Reaches[2];           // of edges, into the cells before this slice, and behind; 0: none
    std::vector<Bent> Bents;                 // in the cells behind
    std::vector<vtkIdType> First, FirstFill; // for each isovalue
  };
  /// Where the isosurface crosses an edge.
  struct Crossing
  {
    double Along; // the edge, 0 to 1
    double Gradient[3];
    double Normal[3];
  };
  struct Scratch
  {
    std::vector<vtkIsosurfaceClass> Classes[2];
    std::vector<bool> Visited; // of each isovalue, the cells of a slice
  };
};

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
    auto prepare = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType k = begin; k < end; ++k)
      {
        this->Prepare(k);
      }
    };
    auto measure = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType k = begin; k < end; ++k)
      {
        this->MeasureOutlines(k, scratches.Local().Visited);
      }
    };
    const vtkIdType slices = this->Field.Grid.Dimensions[2];
    const double third = this->Sizes ? (to - from) / 3 : to - from;
    if (!vtkPointSplatBatches::For(self, slices, 8, from, from + third, sweep))
    {
      return false;
    }
    if (this->Sizes &&
      (!vtkPointSplatBatches::For(self, slices, 1, from + third, to - third, prepare) ||
        !vtkPointSplatBatches::For(self, slices, 1, to - third, to, measure)))
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
  using Class = vtkIsosurfaceClass;
  using Edge = vtkIsosurfaceEdgeLists::Edge;
  using Bent = vtkIsosurfaceEdgeLists::Bent;
  using Slice = vtkIsosurfaceEdgeLists::Slice;
  using Crossing = vtkIsosurfaceEdgeLists::Crossing;
  using Scratch = vtkIsosurfaceEdgeLists::Scratch;

  void Sweep(vtkIdType begin, vtkIdType end, Scratch& scratch)
  {
    const vtkIdType* n = this->Field.Grid.Dimensions;
    const vtkIdType stride = this->Field.GetClassStride();
    std::vector<Class>*here = &scratch.Classes[0], *above = &scratch.Classes[1];
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

  Crossing GetCrossing(const vtkIdType from[3], int axis, double isovalue) const
  {
    const vtkIdType to[3] = { from[0] + (axis == 0), from[1] + (axis == 1), from[2] + (axis == 2) };
    const double s0 = this->Field.Get(from[0], from[1], from[2]);
    const double s1 = this->Field.Get(to[0], to[1], to[2]);
    Crossing crossing;
    // Halves, since differences of doubles may overflow.
    crossing.Along = (0.5 * isovalue - 0.5 * s0) / (0.5 * s1 - 0.5 * s0);
    double* g0 = crossing.Gradient;
    double g1[3];
    this->Field.GetGradient(from, g0);
    this->Field.GetGradient(to, g1);
    for (int c = 0; c < 3; ++c)
    {
      g0[c] += crossing.Along * (g1[c] - g0[c]);
    }
    if (!this->Field.Grid.GetNormal(g0, crossing.Normal))
    {
      // A sheet one sample thick has the same value on both sides; the edge knows better.
      double along[3] = { 0, 0, 0 };
      along[axis] = s1 > s0 ? 1 : -1;
      this->Field.Grid.GetNormal(along, crossing.Normal);
    }
    return crossing;
  }

  void WritePoint(vtkIdType k, std::size_t i, const Target& target, vtkIdType id) const
  {
    const Edge& edge = this->Slices[k].Edges[i];
    const int axis = edge.Axis;
    const vtkIdType from[3] = { edge.I, edge.J, k };
    const vtkIdType to[3] = { from[0] + (axis == 0), from[1] + (axis == 1), from[2] + (axis == 2) };
    const Crossing crossing =
      this->GetCrossing(from, axis, this->Field.Isovalues[edge.Isovalue]);
    double index[3] = { static_cast<double>(from[0]), static_cast<double>(from[1]),
      static_cast<double>(from[2]) };
    index[axis] += crossing.Along;
    vtkIsosurfaceSplat splat;
    this->Field.Grid.GetWorld(index, splat.Position);
    std::copy_n(crossing.Normal, 3, splat.Normal);
    if (target.HasSizes())
    {
      splat.Radius = this->GetRadius(k, i);
      double h0[6], h1[6];
      this->Field.GetHessian(from, h0);
      this->Field.GetHessian(to, h1);
      for (int c = 0; c < 6; ++c)
      {
        h0[c] += crossing.Along * (h1[c] - h0[c]);
      }
      this->Field.Grid.Bend(crossing.Gradient, h0, splat);
    }
    target.Put(id, splat);
  }

  /// What MeasureOutlines() reads and writes of a slice's edges.
  void Prepare(vtkIdType k)
  {
    Slice& slice = this->Slices[k];
    for (std::vector<float>& reaches : slice.Reaches)
    {
      reaches.assign(slice.Edges.size(), 0.0f);
    }
    if (!this->FillGaps)
    {
      return;
    }
    slice.Normals.reserve(3 * slice.Edges.size());
    for (const Edge& edge : slice.Edges)
    {
      const vtkIdType from[3] = { edge.I, edge.J, k };
      const Crossing crossing =
        this->GetCrossing(from, edge.Axis, this->Field.Isovalues[edge.Isovalue]);
      slice.Normals.insert(slice.Normals.end(), crossing.Normal, crossing.Normal + 3);
    }
  }

  /// Of the cells between a slice and the next one. Each outline has an edge that begins in that slice.
  void MeasureOutlines(vtkIdType k, std::vector<bool>& visited)
  {
    const vtkIdType* n = this->Field.Grid.Dimensions;
    const Slice& slice = this->Slices[k];
    if (slice.Edges.empty())
    {
      return;
    }
    visited.assign(n[0] * n[1] * this->Field.Isovalues.size(), false);
    for (const Edge& edge : slice.Edges)
    {
      const std::array<vtkIdType, 2> last = { edge.I, edge.J };
      for (vtkIdType j = last[1] - (edge.Axis != 1); j <= last[1]; ++j)
      {
        for (vtkIdType i = last[0] - (edge.Axis != 0); i <= last[0]; ++i)
        {
          if (i < 0 || j < 0)
          {
            continue;
          }
          auto&& isVisited = visited[n[0] * (n[1] * edge.Isovalue + j) + i];
          if (!isVisited)
          {
            isVisited = true;
            this->MeasureOutlines({ i, j, k }, edge.Isovalue);
          }
        }
      }
    }
  }

  /// Of a cell.
  void MeasureOutlines(const std::array<vtkIdType, 3>& origin, Class isovalue)
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
          this->Measure(origin, isovalue, outline);
        }
      }
    }
  }

  /// An outline: how far its points' disks reach, and whether it gets a fill point.
  void Measure(
    const std::array<vtkIdType, 3>& origin, Class isovalue, vtkIsosurfaceOutline& outline)
  {
    const int count = outline.GetCount();
    std::size_t ids[vtkIsosurfaceOutline::Most];
    for (int i = 0; i < count; ++i)
    {
      ids[i] = this->FindEdge(origin, isovalue, outline.GetEdge(i));
    }
    outline.FindPoints();
    const bool bent = this->FillGaps && this->AddBent(origin, isovalue, outline, ids);
    const double* h = this->Field.Grid.Spacing;
    const double least = LeastReach * std::min({ h[0], h[1], h[2] });
    for (int i = 0; i < count; ++i)
    {
      const int above = outline.GetEdge(i).Corner >> 2;
      std::vector<float>& reaches = this->Slices[origin[2] + above].Reaches[above ? 0 : 1];
      if (ids[i] < reaches.size())
      {
        const double reach = (bent ? BentShare : PlainShare) * outline.GetReach(i);
        reaches[ids[i]] =
          std::max(reaches[ids[i]], static_cast<float>(std::max(reach, least)));
      }
    }
  }

  /// An edge of a cell among those of its slice; the number of these where it is none of them.
  std::size_t FindEdge(const std::array<vtkIdType, 3>& origin, Class isovalue,
    const vtkIsosurfaceOutline::Edge& edge) const
  {
    const Slice& slice = this->Slices[origin[2] + (edge.Corner >> 2)];
    const vtkIdType row = origin[1] + (edge.Corner >> 1 & 1);
    const Edge wanted = { static_cast<std::uint32_t>(origin[0] + (edge.Corner & 1)),
      static_cast<std::uint32_t>(row), static_cast<std::uint8_t>(edge.Axis), isovalue };
    const auto end = slice.Edges.begin() + slice.Rows[row + 1];
    const auto found = std::lower_bound(slice.Edges.begin() + slice.Rows[row], end, wanted);
    return found != end && !(wanted < *found) ? found - slice.Edges.begin() : slice.Edges.size();
  }

  /// Returns whether the outline is bent. ids: of its edges.
  bool AddBent(const std::array<vtkIdType, 3>& origin, Class isovalue,
    const vtkIsosurfaceOutline& outline, const std::size_t* ids)
  {
    if (!this->Field.Grid.HasCell(origin[0], origin[1], origin[2]))
    {
      return false;
    }
    double offsets[vtkIsosurfaceOutline::Most][3], normals[vtkIsosurfaceOutline::Most][3];
    for (int i = 0; i < outline.GetCount(); ++i)
    {
      const Slice& slice = this->Slices[origin[2] + (outline.GetEdge(i).Corner >> 2)];
      // Large integers that doubles round may lie on the other side of the isovalue here.
      if (ids[i] == slice.Edges.size())
      {
        return false;
      }
      std::copy_n(slice.Normals.begin() + 3 * ids[i], 3, normals[i]);
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
  // From Testing/Accuracy/fit_constants.py:
  /// The radius of a fill point, by its distance to the outline's farthest point; and those of points, by
  /// their distance to the centroid of an outline that has a fill point there, and of another.
  static constexpr double FillShare = 0.8;
  static constexpr double BentShare = 0.65;
  static constexpr double PlainShare = 0.87;

  vtkIsosurfaceField<T> Field;
  bool Sizes;
  bool FillGaps;
  std::vector<Slice> Slices;
};

VTK_ABI_NAMESPACE_END
#endif
