// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceOutline
 * @brief   the polygon in which an isosurface crosses a cell's faces
 *
 * Internal to vtkIsosurfaceEdges. The outline is followed from a crossed edge through one face
 * after the other, until it is closed. Where all four edges of a face are crossed, the face's
 * bilinear interpolant tells which belong together (Nielson, Hamann 1991, The asymptotic
 * decider). Corners are numbered by bits: 1 is further along x, 2 along y, 4 along z.
 */
#ifndef vtkIsosurfaceOutline_h
#define vtkIsosurfaceOutline_h

#include "vtkPointSplattingABI.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceOutline
{
public:
  /// The cell's samples less the isovalue, and the lengths of its sides.
  vtkIsosurfaceOutline(const double values[8], const double spacing[3])
    : Values(values)
    , Spacing(spacing)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Above |= (values[corner] >= 0 ? 1 : 0) << corner;
    }
  }

  static constexpr int Most = 12; // edges of a cell

  /// From a corner further along an axis.
  struct Edge
  {
    int Corner;
    int Axis;

    bool operator==(const Edge& other) const
    {
      return this->Corner == other.Corner && this->Axis == other.Axis;
    }
  };

  /// Follows the outline through a crossed edge.
  void Follow(const Edge& start)
  {
    Edge here = start;
    int across = (start.Axis + 1) % 3; // the axis that stands on the next face
    this->Count = 0;
    do
    {
      this->Edges[this->Count++] = here;
      this->Step(here, across);
    } while (!(here == start) && this->Count < Most);
  }

  bool IsCrossed(const Edge& edge) const
  {
    return this->IsAbove(edge.Corner) != this->IsAbove(edge.Corner | 1 << edge.Axis);
  }

  /// Finds the points on an outline's edges, and their centroid.
  void FindPoints()
  {
    double sum[3] = { 0, 0, 0 }, length = 0;
    this->GetPoint(this->Edges[0], this->Points[0]);
    for (int i = 0; i < this->Count; ++i)
    {
      const double* here = this->Points[i];
      double* next = this->Points[i + 1];
      this->GetPoint(this->Edges[i + 1 < this->Count ? i + 1 : 0], next);
      // By lengths, since several points may all but coincide.
      const double side = Distance(here, next);
      length += side;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += side * (0.5 * (here[c] + next[c]) - this->Points[0][c]);
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      const double offset = sum[c] / length;
      this->Centroid[c] = this->Points[0][c] + (std::isfinite(offset) ? offset : 0.0);
    }
  }

  int GetCount() const { return this->Count; }
  const Edge& GetEdge(int i) const { return this->Edges[i]; }
  /// From the cell's first corner, in the unit of the sides.
  const double* GetCentroid() const { return this->Centroid; }
  const double* GetPoint(int i) const { return this->Points[i]; }
  /// How far a point is from the centroid. With disks that reach there, those of the outline's points
  /// cover all between them.
  double GetReach(int i) const { return Distance(this->Points[i], this->Centroid); }

private:
  static double Distance(const double a[3], const double b[3])
  {
    double squared = 0;
    for (int c = 0; c < 3; ++c)
    {
      squared += (a[c] - b[c]) * (a[c] - b[c]);
    }
    return std::sqrt(squared);
  }

  bool IsAbove(int corner) const { return (this->Above >> corner & 1) != 0; }

  void GetPoint(const Edge& edge, double x[3]) const
  {
    for (int c = 0; c < 3; ++c)
    {
      x[c] = edge.Corner >> c & 1 ? this->Spacing[c] : 0;
    }
    const double a = this->Values[edge.Corner], b = this->Values[edge.Corner | 1 << edge.Axis];
    // Halves, since differences of doubles may overflow.
    x[edge.Axis] = this->Spacing[edge.Axis] * (0.5 * a / (0.5 * a - 0.5 * b));
  }

  /// Goes on to the edge through which the outline leaves a face, and to the face beyond it.
  void Step(Edge& edge, int& across) const
  {
    const int along = edge.Axis, aside = 3 - along - across;
    const int a = edge.Corner, b = a | 1 << along;
    const int besideA = a ^ 1 << aside, besideB = b ^ 1 << aside;
    const bool atA = this->IsAbove(a) != this->IsAbove(besideA);
    const bool atB = this->IsAbove(b) != this->IsAbove(besideB);
    if (!atA && !atB)
    {
      edge.Corner = besideA;
      across = aside;
      return;
    }
    bool byA = atA;
    if (atA && atB)
    {
      // The saddle's value is on one side: its two corners are connected, the others cut off.
      const double* v = this->Values;
      const double scale = std::max(
        { std::abs(v[a]), std::abs(v[b]), std::abs(v[besideA]), std::abs(v[besideB]) });
      const double saddle =
        v[a] / scale * (v[besideB] / scale) - v[besideA] / scale * (v[b] / scale);
      const bool connectsA = this->IsAbove(a) ? saddle >= 0 : saddle > 0;
      byA = !connectsA;
    }
    edge.Corner = (byA ? a : b) & ~(1 << aside);
    edge.Axis = aside;
    across = along;
  }

  const double* Values;
  const double* Spacing;
  int Above = 0; // a bit for each corner
  int Count = 0;
  Edge Edges[Most];
  double Points[Most + 1][3]; // the last is the first again
  double Centroid[3];
};

VTK_ABI_NAMESPACE_END
#endif
