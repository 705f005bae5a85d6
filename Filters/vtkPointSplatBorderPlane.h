// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatBorderPlane
 * @brief   directions in a disk's plane, and the lines that clip it where the surface ends
 *
 * An internal helper of vtkPointSplatBorders and vtkPointSplatMeshBorders. Angles are in radians,
 * counterclockwise about the plane's normal.
 */
#ifndef vtkPointSplatBorderPlane_h
#define vtkPointSplatBorderPlane_h

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatBorderPlane
{
public:
  /// Lines do not go through the points themselves, but so many distances to the next point off: their
  /// vectors are finite.
  static constexpr float LeastDistance = 0.02f;

  explicit vtkPointSplatBorderPlane(const float n[3])
  {
    const double normal[3] = { n[0], n[1], n[2] };
    double u[3], v[3];
    vtkMath::Perpendiculars(normal, u, v, 0);
    double across[3];
    vtkMath::Cross(u, v, across);
    const double side = vtkMath::Dot(across, normal) < 0 ? -1 : 1;
    for (int c = 0; c < 3; ++c)
    {
      this->U[c] = static_cast<float>(u[c]);
      this->V[c] = static_cast<float>(side * v[c]);
    }
  }

  double GetAngle(const float x[3]) const
  {
    return std::atan2(vtkMath::Dot(x, this->V), vtkMath::Dot(x, this->U));
  }

  /// From one angle counterclockwise to the other, less than a whole turn.
  static double Turn(double from, double to)
  {
    const double turn = to - from;
    return turn < 0 ? turn + 2 * vtkMath::Pi() : turn;
  }

  /// Whether a direction lies in a sector, which begins at an angle, and so far from its sides.
  bool IsInSector(const float x[3], double from, double sector, double margin) const
  {
    const double turn = Turn(from, this->GetAngle(x));
    return turn >= margin && turn < sector - margin;
  }

  /// The vector of a line (`SplatClip`) whose normal lies at that angle.
  void SetLine(double angle, float distance, float clip[3]) const
  {
    const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    for (int k = 0; k < 3; ++k)
    {
      clip[k] = (c * this->U[k] + s * this->V[k]) / distance;
    }
  }

  /// The lines along a sector's sides, the first one's before the second's.
  void SetSides(double from, double sector, float least, float clip[6]) const
  {
    this->SetLine(from + 0.5 * vtkMath::Pi(), least, clip);
    this->SetLine(from + sector - 0.5 * vtkMath::Pi(), least, clip + 3);
  }

  /// The one or two lines that leave out a sector, which begins at an angle. least: how far off a line is at
  /// least; nearest: how far the nearer one of the two points is that bound the sector.
  void SetLines(double from, double sector, float least, float nearest, float clip[6]) const
  {
    std::fill_n(clip, 6, 0.0f);
    if (sector >= vtkMath::Pi())
    {
      this->SetSides(from, sector, least, clip);
    }
    else
    {
      // The next points' splats cover the other halves of the edges to them.
      const float across = 0.5f * nearest * static_cast<float>(std::cos(0.5 * sector));
      this->SetLine(from + 0.5 * sector, std::max(across, least), clip);
    }
  }

private:
  float U[3], V[3];
};

VTK_ABI_NAMESPACE_END
#endif
