// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceDivision
 * @brief   candidates for points on the part of an isosurface in one cell of a grid
 *
 * Internal to vtkIsosurfaceSamples and vtkParticleSurface. A cell is divided until its parts are
 * small beside the wanted spacing of points, and each part's edge that the trilinear interpolant
 * of the corners' values crosses gives a candidate.
 */
#ifndef vtkIsosurfaceDivision_h
#define vtkIsosurfaceDivision_h

#include "vtkIsosurfaceThinning.h"
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceDivision
{
public:
  using Sample = vtkIsosurfaceThinning::Sample;

  struct Cell
  {
    vtkIdType Index[3];
    double Corners[8]; // less the isovalue
  };
  /// Two layers of values at the parts' corners.
  struct Scratch
  {
    std::vector<double> Layers[2];
  };

  /// Points keep this part of the wanted spacing as their least distance.
  static constexpr double DistancePerSpacing = 0.8;
  /// And are chosen from candidates that are denser by this factor.
  static constexpr double CandidatesPerSpacing = 2.5;

  /// sides: of a cell; spacing: wanted, of points.
  vtkIsosurfaceDivision(const double sides[3], double spacing)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Sides[c] = sides[c];
      this->Divisions[c] =
        static_cast<int>(std::max(std::ceil(CandidatesPerSpacing * sides[c] / spacing), 1.0));
    }
  }

  /// Appends the crossings of the parts' edges, layer by layer.
  void Divide(const Cell& cell, Scratch& scratch, std::vector<Sample>& samples) const
  {
    const int* m = this->Divisions;
    const std::size_t row = m[0] + 1;
    for (int c = 0; c <= m[2]; ++c)
    {
      std::vector<double>& layer = scratch.Layers[c % 2];
      const std::vector<double>& below = scratch.Layers[1 - c % 2];
      layer.resize(row * (m[1] + 1));
      for (int b = 0; b <= m[1]; ++b)
      {
        const double y = double(b) / m[1], z = double(c) / m[2];
        const double* s = cell.Corners;
        const double left =
          (1 - z) * ((1 - y) * s[0] + y * s[2]) + z * ((1 - y) * s[4] + y * s[6]);
        const double right =
          (1 - z) * ((1 - y) * s[1] + y * s[3]) + z * ((1 - y) * s[5] + y * s[7]);
        for (int a = 0; a <= m[0]; ++a)
        {
          const double x = double(a) / m[0];
          const double value = (1 - x) * left + x * right;
          layer[row * b + a] = value;
          // Along an axis the interpolant is linear: these crossings lie on it.
          const double others[3] = { a > 0 ? layer[row * b + a - 1] : value,
            b > 0 ? layer[row * (b - 1) + a] : value, c > 0 ? below[row * b + a] : value };
          for (int axis = 0; axis < 3; ++axis)
          {
            if ((value >= 0) != (others[axis] >= 0))
            {
              double at[3] = { x, y, z };
              at[axis] -= value / (value - others[axis]) / m[axis];
              this->AddSample(cell, at, samples);
            }
          }
        }
      }
    }
  }

private:
  void AddSample(const Cell& cell, const double at[3], std::vector<Sample>& samples) const
  {
    const double* s = cell.Corners;
    const double x = at[0], y = at[1], z = at[2];
    const double gradient[3] = {
      (1 - z) * ((1 - y) * (s[1] - s[0]) + y * (s[3] - s[2])) +
        z * ((1 - y) * (s[5] - s[4]) + y * (s[7] - s[6])),
      (1 - z) * ((1 - x) * (s[2] - s[0]) + x * (s[3] - s[1])) +
        z * ((1 - x) * (s[6] - s[4]) + x * (s[7] - s[5])),
      (1 - y) * ((1 - x) * (s[4] - s[0]) + x * (s[5] - s[1])) +
        y * ((1 - x) * (s[6] - s[2]) + x * (s[7] - s[3]))
    };
    const double largest =
      std::max({ std::abs(gradient[0]), std::abs(gradient[1]), std::abs(gradient[2]) });
    Sample sample;
    for (int c = 0; c < 3; ++c)
    {
      sample.Position[c] = (cell.Index[c] + at[c]) * this->Sides[c];
      sample.Side[c] = largest > 0
        ? static_cast<float>(gradient[c] / largest / this->Sides[c] * this->Sides[0])
        : 0.0f;
    }
    samples.push_back(sample);
  }

  double Sides[3];
  int Divisions[3];
};

VTK_ABI_NAMESPACE_END
#endif
