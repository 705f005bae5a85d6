// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMirrored
 * @brief   the members of a point's face and what they look like in mirrors at its lines
 *
 * An internal helper of vtkPointSplatCreases; see stage 4 there.
 */
#ifndef vtkPointSplatMirrored_h
#define vtkPointSplatMirrored_h

#include "vtkMath.h"
#include "vtkPointSplatCrease.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatMirrored
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

  static constexpr int Capacity = vtkPointSplatNeighbors::MaximumNumberOfNeighbors;
  float Normals[3 * (Capacity + 1)]; // 3 a slot: the centre's, and those of the neighbours

  /// Adds the points on the lines whose normals are averages: they have a part on this face. Not those that are so
  /// dense, on another face, that their splats end before half of the way to the centre: that is the centre's to cover.
  void AddMeeting(const Neighborhood& around, const vtkPointSplatFaces& faces, const float n[3],
    const vtkPointSplatCrease& crease, float spacing)
  {
    for (int i = 0; i < around.Count; ++i)
    {
      const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
      if (faces.IsSound(around.Slots[i]) || std::abs(vtkMath::Dot(n, x)) > OffFace * spacing)
      {
        continue;
      }
      for (int l = 0; l < crease.Count; ++l)
      {
        const vtkPointSplatCrease::Line& line = crease.Lines[l];
        if (line.Distance <= LargestWay * faces.Spacings[around.Slots[i]] &&
          vtkPointSplatCrease::IsOn(line, x, spacing))
        {
          this->Add(x, n);
          break;
        }
      }
    }
  }

  /// Adds the points that are off the face but before all lines, as past an edge too shallow to be a line. Their disks cover the
  /// ways to them, up to a third or so, since they lie in other planes. Returns whether there are any.
  bool AddNext(const Neighborhood& around, const vtkPointSplatFaces& faces, const float n[3],
    const vtkPointSplatFace& face, const vtkPointSplatCrease& crease)
  {
    const auto* member = face.Members.Members;
    const auto* last = member + face.Members.Count;
    const int before = this->Count;
    for (int i = 0; i < around.Count; ++i)
    {
      if (member != last && *member == i)
      {
        ++member;
        continue;
      }
      const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
      const float height = vtkMath::Dot(n, x);
      if (faces.IsSound(around.Slots[i]) && height * height < NextSlope * NextSlope * around.SquaredDistance[i] &&
        std::all_of(crease.Lines, crease.Lines + crease.Count,
          [&](const vtkPointSplatCrease::Line& line) {
            return vtkMath::Dot(line.Direction, x) < line.Distance &&
              !vtkPointSplatCrease::IsOn(line, x, face.Members.Spacing);
          }))
      {
        const float farther[3] = { NextWay * x[0], NextWay * x[1], NextWay * x[2] };
        this->Add(farther, n);
      }
    }
    return this->Count > before;
  }

  /// Adds the members and all images.
  void AddFace(const Neighborhood& around, const float* normals, const float n[3],
    const vtkPointSplatFace& face, const vtkPointSplatCrease& crease)
  {
    const float zero[3] = { 0, 0, 0 };
    for (int l = 0; l < crease.Count; ++l)
    {
      this->AddImage(zero, n, crease, l);
    }
    for (int k = 0; k < face.Members.Count; ++k)
    {
      const int i = face.Members.Members[k];
      const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
      const float* m = normals + std::size_t(3) * around.Slots[i];
      this->Add(x, m);
      for (int l = 0; l < crease.Count; ++l)
      {
        this->AddImage(x, m, crease, l);
      }
    }
  }

  /// All that were added, as the neighbours of a slot 0, whose normal is n; Normals has theirs.
  Neighborhood Get(const float n[3])
  {
    std::stable_sort(this->Points, this->Points + this->Count,
      [](const Point& a, const Point& b) { return a.Squared < b.Squared; });
    std::copy(n, n + 3, this->Normals);
    for (int i = 0; i < this->Count; ++i)
    {
      const Point& point = this->Points[i];
      this->Slots[i] = i + 1;
      this->X[i] = point.X[0];
      this->Y[i] = point.X[1];
      this->Z[i] = point.X[2];
      this->Squared[i] = point.Squared;
      std::copy(point.Normal, point.Normal + 3, this->Normals + 3 * (i + 1));
    }
    return { 0, this->Count, this->Slots, this->X, this->Y, this->Z, this->Squared };
  }

private:
  /// How far, in spacings, a point on an edge may be off a face that meets there.
  static constexpr float OffFace = 0.15f;
  /// How far from the centre, in its own spacings, a point on an edge may be: splats reach as far as their spacing.
  static constexpr float LargestWay = 2.0f;
  /// How steep the way to a point past a shallow edge is at most, and how much farther off it counts (Testing/Accuracy/fit_constants.py).
  static constexpr float NextSlope = 0.6f;
  static constexpr float NextWay = 1.4f;

  struct Point
  {
    float X[3], Normal[3];
    float Squared;
  };
  Point Points[Capacity];
  int Count = 0;

  Slot Slots[Capacity];
  float X[Capacity], Y[Capacity], Z[Capacity], Squared[Capacity];

  void Add(const float x[3], const float n[3])
  {
    const float squared = vtkMath::Dot(x, x);
    if (this->Count < Capacity && squared > 0)
    {
      this->Points[this->Count++] = { { x[0], x[1], x[2] }, { n[0], n[1], n[2] }, squared };
    }
  }

  void AddImage(const float x[3], const float n[3], const vtkPointSplatCrease& crease, int line)
  {
    const vtkPointSplatCrease::Line& at = crease.Lines[line];
    const float far = vtkMath::Dot(at.Direction, x) - at.Distance;
    const float part = vtkMath::Dot(at.Direction, n);
    float y[3], m[3];
    for (int c = 0; c < 3; ++c)
    {
      y[c] = x[c] - 2 * far * at.Direction[c];
      m[c] = n[c] - 2 * part * at.Direction[c];
    }
    // What is behind a line, where a face goes on past a corner, has its image before it.
    for (int k = 0; k < crease.Count; ++k)
    {
      if (vtkMath::Dot(crease.Lines[k].Direction, y) > crease.Lines[k].Distance)
      {
        this->Add(y, m);
        return;
      }
    }
  }
};

VTK_ABI_NAMESPACE_END
#endif
