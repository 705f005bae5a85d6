// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceEdgeLists
 * @brief   the edges of a volume's grid that isosurfaces cross, and which of them are a cell's
 *
 * Internal to vtkIsosurfaceEdges: what does not depend on the scalars' type. Each slice of samples has
 * a list of the edges that begin in it, in the order in which they are found: by rows, in these by
 * samples, then by axes, then by isovalues. So the edges of a row of cells, which are in four rows of
 * two slices, are come by when the four are gone through side by side.
 */
#ifndef vtkIsosurfaceEdgeLists_h
#define vtkIsosurfaceEdgeLists_h

#include "vtkIsosurfaceField.h"
#include "vtkIsosurfaceFill.h"
#include "vtkIsosurfaceOutline.h"
#include "vtkPointSplattingABI.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

struct vtkIsosurfaceEdgeLists
{
  using Class = vtkIsosurfaceClass;

  /// From sample (I, J, slice) one step along an axis.
  struct Edge
  {
    std::uint32_t I, J;
    std::uint8_t Axis;
    Class Isovalue;
  };
  /// Where the isosurface crosses an edge.
  struct Crossing
  {
    double Along;    // the edge, 0 to 1
    double Slope;    // of the field, along the normal, per world unit; with the normal's sign
    float Normal[3]; // unit length
  };
  /// An outline that is bent, in the cell whose first sample is (I, J, slice), by its first edge.
  struct Bent
  {
    std::uint32_t I, J;
    Class Isovalue;
    std::uint8_t Corner, Axis;
    vtkIsosurfaceFill Fill;
  };
  struct Slice
  {
    std::vector<Edge> Edges;
    std::vector<std::size_t> Rows; // the first of each row, and the end
    std::vector<Crossing> Crossings;
    std::vector<float> Reaches[2]; // of edges, into the cells before this slice, and behind; 0: none
    std::vector<Bent> Bents;       // in the cells behind
    std::vector<vtkIdType> First, FirstFill; // for each isovalue
  };

  /// The edges of a cell, by their numbers in their slices' lists.
  class Cell
  {
  public:
    /// In the order of the lists.
    void Add(int corner, const Edge& edge, std::size_t id)
    {
      if ((corner >> edge.Axis & 1) != 0)
      {
        return; // of the next cell
      }
      const int at = 3 * corner + edge.Axis;
      if (this->Counts[at] == 0)
      {
        this->Firsts[at] = edge.Isovalue;
        this->Ids[at] = id;
      }
      ++this->Counts[at];
      this->Least = std::min(this->Least, edge.Isovalue);
      this->Most = std::max(this->Most, edge.Isovalue);
      this->Lower = this->Lower || corner < 4;
    }

    /// An edge's number, if it is in the list.
    std::optional<std::size_t> Find(const vtkIsosurfaceOutline::Edge& edge, Class isovalue) const
    {
      const int at = 3 * edge.Corner + edge.Axis;
      const int further = this->Counts[at] > 0 ? isovalue - this->Firsts[at] : -1;
      return further >= 0 && further < this->Counts[at]
        ? std::optional<std::size_t>(this->Ids[at] + static_cast<std::size_t>(further))
        : std::nullopt;
    }

    /// Whether there are edges that begin in the first of the two slices, as each outline has.
    bool HasLower() const { return this->Lower; }
    /// The isovalues by which it is crossed are among these.
    Class GetLeast() const { return this->Least; }
    Class GetMost() const { return this->Most; }

  private:
    // An edge is in the list once for each of some isovalues that follow one another: how many, and
    // where there are any the first and its number. Of corner and axis.
    Class Counts[24] = {};
    Class Firsts[24];
    std::size_t Ids[24];
    Class Least = 255, Most = 0;
    bool Lower = false;
  };

  /// Calls visit(i, cell) for the cells (i, j) between two slices that have edges, in this order.
  template <typename Visitor>
  static void VisitRow(const Slice& here, const Slice& above, vtkIdType j, const Visitor& visit)
  {
    Row rows[4]; // as the corners that are not further along x: 1 is further along y, 2 along z
    for (int r = 0; r < 4; ++r)
    {
      const Slice& slice = r & 2 ? above : here;
      rows[r] = { slice.Edges.data() + slice.Rows[j + (r & 1)],
        slice.Edges.data() + slice.Rows[j + (r & 1) + 1], slice.Edges.data() };
    }
    Row next[2] = { rows[0], rows[1] };
    vtkIdType begin = 0; // the cells before are done
    while (!next[0].IsEmpty() || !next[1].IsEmpty())
    {
      // A sample's edges are the cells' before it and behind it.
      const vtkIdType i = std::min(next[0].GetSample(), next[1].GetSample());
      for (vtkIdType c = std::max(begin, i - 1); c <= i; ++c)
      {
        Cell cell;
        for (int r = 0; r < 4; ++r)
        {
          rows[r].SkipTo(c);
          for (const Edge* e = rows[r].At; e != rows[r].End && e->I <= c + 1; ++e)
          {
            cell.Add(static_cast<int>(e->I - c) | r << 1, *e, e - rows[r].List);
          }
        }
        if (cell.HasLower())
        {
          visit(c, cell);
        }
      }
      begin = i + 1;
      next[0].SkipTo(begin);
      next[1].SkipTo(begin);
    }
  }

private:
  struct Row
  {
    const Edge *At, *End, *List;

    bool IsEmpty() const { return this->At == this->End; }
    vtkIdType GetSample() const { return this->IsEmpty() ? VTK_ID_MAX : this->At->I; }
    void SkipTo(vtkIdType i)
    {
      while (!this->IsEmpty() && this->At->I < i)
      {
        ++this->At;
      }
    }
  };
};

VTK_ABI_NAMESPACE_END
#endif
