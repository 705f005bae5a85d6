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
  }

  /**
   * How far the point on a crossed edge, from a corner along an axis, is from the outline's
   * centroid. With disks that reach there, those of the outline's points cover all between them.
   */
  double GetReach(int corner, int axis) const
  {
    const Edge start = { corner, axis };
    Edge edge = start;
    int across = (axis + 1) % 3; // the axis that stands on the next face
    double first[3], here[3], sum[3] = { 0, 0, 0 }, length = 0;
    this->GetPoint(start, first);
    std::copy(first, first + 3, here);
    for (int step = 0; step < 12; ++step)
    {
      this->Follow(edge, across);
      double next[3], squared = 0;
      this->GetPoint(edge, next);
      for (int c = 0; c < 3; ++c)
      {
        squared += (next[c] - here[c]) * (next[c] - here[c]);
      }
      // By lengths, since several points may all but coincide.
      const double side = std::sqrt(squared);
      length += side;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += side * (0.5 * (here[c] + next[c]) - first[c]);
        here[c] = next[c];
      }
      if (edge.Corner == start.Corner && edge.Axis == start.Axis)
      {
        break;
      }
    }
    return length > 0 ? std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / length : 0;
  }

private:
  /// From a corner further along an axis.
  struct Edge
  {
    int Corner;
    int Axis;
  };

  bool IsAbove(int corner) const { return this->Values[corner] >= 0; }

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
  void Follow(Edge& edge, int& across) const
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
};

VTK_ABI_NAMESPACE_END
#endif
