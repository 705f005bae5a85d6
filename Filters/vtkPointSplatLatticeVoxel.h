// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeVoxel
 * @brief   the points on a voxel's edges and at its corners, and the side of a surface that its corners are on
 *
 * An internal helper of vtkPointSplatLattice. Corners and edges are numbered as in vtkPointSplatLatticeCases.
 */
#ifndef vtkPointSplatLatticeVoxel_h
#define vtkPointSplatLatticeVoxel_h

#include "vtkPointSplatLatticeCases.h"
#include "vtkPointSplatLatticeSides.h"

#include <algorithm>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

struct vtkPointSplatLatticeVoxel
{
  static constexpr vtkIdType None = -1;

  std::int64_t Index = 0; // row by row
  vtkIdType Cut[12];
  vtkIdType At[8]; // by bits
  int Side[8];     // 1 inside, -1 outside, 0 where that is not known yet
  bool Any = false;

  vtkPointSplatLatticeVoxel()
  {
    std::fill_n(this->Cut, 12, None);
    std::fill_n(this->At, 8, None);
    std::fill_n(this->Side, 8, 0);
  }

  void AddCut(int lower, int axis, vtkIdType id)
  {
    this->Any = true;
    this->Cut[vtkPointSplatLatticeCases::EdgesOf[lower][axis]] = id;
  }
  void AddAt(int corner, vtkIdType id)
  {
    this->Any = true;
    this->At[corner] = id;
  }

  /// Carries a corner's side on, and adds to part, by bits, where to; returns false where that contradicts another one.
  bool Spread(int start, int& part)
  {
    int corners[8] = { start };
    int count = 1;
    this->Side[start] = 1;
    for (int k = 0; k < count; ++k)
    {
      const int corner = corners[k];
      part |= 1 << corner;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int other = corner ^ (1 << axis);
        const bool cut = this->Cut[vtkPointSplatLatticeCases::EdgesOf[corner][axis]] != None;
        if (!cut && (this->At[corner] != None || this->At[other] != None))
        {
          continue; // it may be cut at its end
        }
        const int side = cut ? -this->Side[corner] : this->Side[corner];
        if (this->Side[other] == 0)
        {
          this->Side[other] = side;
          corners[count++] = other;
        }
        else if (this->Side[other] != side)
        {
          return false;
        }
      }
    }
    return true;
  }

  /// By how much normals agree with the sides of some corners.
  float GetAgreement(int part, const float* normals, const float distances[3]) const
  {
    float sum = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int axis = 0; axis < 3 && (part & (1 << corner)); ++axis)
      {
        const int bit = 1 << axis;
        const vtkIdType cut = this->Cut[vtkPointSplatLatticeCases::EdgesOf[corner][axis]];
        const vtkIdType point = cut != None ? cut : this->At[corner ^ bit];
        if (point != None)
        {
          // As steep as it is from sample to sample.
          const float outward = ((corner & bit) ? 1 : -1) * normals[3 * point + axis] * distances[axis];
          sum -= outward * this->Side[corner];
        }
      }
    }
    return sum;
  }

  /// Finds parts that know their sides from one another; returns false where these contradict one another.
  bool FindParts(const float* normals, const float distances[3], std::vector<vtkPointSplatLatticeSides::Part>& parts)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      int corners = 0;
      if (this->Side[corner] != 0)
      {
        continue;
      }
      if (!this->Spread(corner, corners))
      {
        return false;
      }
      if (corners != 1 << corner || this->At[corner] == None)
      {
        int inside = 0;
        for (int other = 0; other < 8; ++other)
        {
          inside |= (corners & (1 << other)) && this->Side[other] > 0 ? 1 << other : 0;
        }
        parts.push_back({ this->Index, static_cast<unsigned char>(corners), static_cast<unsigned char>(inside),
          this->GetAgreement(corners, normals, distances) });
      }
    }
    return true;
  }

  /// Takes over the sides of parts. A sample that is the isovalue is inside, where nothing else is said.
  void SetSides(const vtkPointSplatLatticeSides::Range& parts)
  {
    std::fill_n(this->Side, 8, 1);
    for (const vtkPointSplatLatticeSides::Part& part : parts)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const int bit = 1 << corner;
        this->Side[corner] = (part.Corners & bit) && !(part.Inside & bit) ? -1 : this->Side[corner];
      }
    }
  }

  vtkIdType GetPoint(int e) const
  {
    const int a = vtkPointSplatLatticeCases::EdgeEnds[e], b = a | (1 << vtkPointSplatLatticeCases::EdgeAxes[e]);
    const int inside = this->Side[a] > 0 ? a : b, outside = this->Side[a] > 0 ? b : a;
    return this->Cut[e] != None ? this->Cut[e]
      : this->At[inside] != None ? this->At[inside]
                                 : this->At[outside];
  }

  void AddTriangles(std::vector<vtkIdType>& corners) const
  {
    int inside = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      inside |= this->Side[corner] > 0 ? 1 << corner : 0;
    }
    vtkPointSplatLatticeCases::VisitTriangles(inside, [&](const int edges[3]) {
      const vtkIdType a = this->GetPoint(edges[0]), b = this->GetPoint(edges[1]), c = this->GetPoint(edges[2]);
      if (a != b && b != c && c != a)
      {
        corners.insert(corners.end(), { a, b, c });
      }
    });
  }
};

VTK_ABI_NAMESPACE_END
#endif
