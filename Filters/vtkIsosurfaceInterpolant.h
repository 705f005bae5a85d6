// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceInterpolant
 * @brief   a smooth function through a volume's samples, and the way onto its isosurface
 *
 * Internal; stage 3 of vtkIsosurfacePoints with a point spacing.
 */
#ifndef vtkIsosurfaceInterpolant_h
#define vtkIsosurfaceInterpolant_h

#include "vtkIsosurfaceField.h"

VTK_ABI_NAMESPACE_BEGIN

template <typename T>
class vtkIsosurfaceInterpolant
{
public:
  explicit vtkIsosurfaceInterpolant(const vtkIsosurfaceField<T>& field)
    : Field(field)
  {
  }

  /**
   * Moves an index from the trilinear interpolant's isosurface to the tricubic one's where
   * there is one near, and finds the gradient there.
   */
  void Place(double isovalue, double index[3], double gradient[3]) const
  {
    double x[3] = { index[0], index[1], index[2] };
    for (int step = 0; step < 8; ++step)
    {
      double value;
      if (!this->EvaluateCubic(x, value, gradient))
      {
        break;
      }
      const double squared =
        gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2];
      const double residual = isovalue - value;
      if (residual * residual <= Tolerance * Tolerance * squared)
      {
        if (squared > 0)
        {
          std::copy(x, x + 3, index);
          return;
        }
        break;
      }
      double moved = 0;
      for (int c = 0; c < 3; ++c)
      {
        x[c] += residual * gradient[c] / squared;
        x[c] = std::min(std::max(x[c], 0.0), this->Field.Grid.Dimensions[c] - 1.0);
        moved += (x[c] - index[c]) * (x[c] - index[c]);
      }
      if (!(moved <= 0.25))
      {
        break;
      }
    }
    this->InterpolateGradient(index, gradient);
  }

  /// The Hessians of the cell's corners, interpolated.
  void InterpolateHessian(const double index[3], double hessian[6]) const
  {
    std::fill_n(hessian, 6, 0.0);
    this->VisitCorners(index, [&](const vtkIdType ijk[3], double weight) {
      double h[6];
      this->Field.GetHessian(ijk, h);
      for (int c = 0; c < 6; ++c)
      {
        hessian[c] += weight * h[c];
      }
    });
  }

private:
  /// In voxels, of the distance to the surface.
  static constexpr double Tolerance = 1e-6;

  /// The cell that an index lies in, and where in it.
  void GetCell(const double index[3], vtkIdType cell[3], double at[3]) const
  {
    for (int c = 0; c < 3; ++c)
    {
      cell[c] = std::min(std::max<vtkIdType>(static_cast<vtkIdType>(index[c]), 0),
        this->Field.Grid.Dimensions[c] - 2);
      at[c] = index[c] - static_cast<double>(cell[c]);
    }
  }

  /// False where a sample around is not usable.
  bool EvaluateCubic(const double index[3], double& value, double gradient[3]) const
  {
    vtkIdType cell[3], offsets[3][4];
    double at[3], w[3][4], d[3][4];
    this->GetCell(index, cell, at);
    for (int c = 0; c < 3; ++c)
    {
      const double t = at[c];
      w[c][0] = 0.5 * t * (-1 + t * (2 - t));
      w[c][1] = 0.5 * (2 + t * t * (-5 + 3 * t));
      w[c][2] = 0.5 * t * (1 + t * (4 - 3 * t));
      w[c][3] = 0.5 * t * t * (t - 1);
      d[c][0] = 0.5 * (-1 + t * (4 - 3 * t));
      d[c][1] = 0.5 * t * (-10 + 9 * t);
      d[c][2] = 0.5 * (1 + t * (8 - 9 * t));
      d[c][3] = 0.5 * t * (3 * t - 2);
      if (cell[c] == 0)
      {
        Extrapolate(w[c][0], w[c][1], w[c][2]);
        Extrapolate(d[c][0], d[c][1], d[c][2]);
      }
      if (cell[c] == this->Field.Grid.Dimensions[c] - 2)
      {
        Extrapolate(w[c][3], w[c][2], w[c][1]);
        Extrapolate(d[c][3], d[c][2], d[c][1]);
      }
      for (int i = 0; i < 4; ++i)
      {
        offsets[c][i] = std::min(
          std::max<vtkIdType>(cell[c] + i - 1, 0), this->Field.Grid.Dimensions[c] - 1);
      }
    }
    value = gradient[0] = gradient[1] = gradient[2] = 0;
    for (int k = 0; k < 4; ++k)
    {
      for (int j = 0; j < 4; ++j)
      {
        double row = 0, slope = 0;
        for (int i = 0; i < 4; ++i)
        {
          if (this->Field.Grid.PointGhosts &&
            this->Field.Grid.IsHidden(offsets[0][i], offsets[1][j], offsets[2][k]))
          {
            return false;
          }
          const double s = this->Field.Get(offsets[0][i], offsets[1][j], offsets[2][k]);
          row += w[0][i] * s;
          slope += d[0][i] * s;
        }
        value += w[1][j] * w[2][k] * row;
        gradient[0] += w[1][j] * w[2][k] * slope;
        gradient[1] += d[1][j] * w[2][k] * row;
        gradient[2] += w[1][j] * d[2][k] * row;
      }
    }
    // NaN and infinity come through.
    return std::isfinite(value + gradient[0] + gradient[1] + gradient[2]);
  }

  /// A sample outside is the straight continuation of the two at the border.
  static void Extrapolate(double& outside, double& border, double& inner)
  {
    border += 2 * outside;
    inner -= outside;
    outside = 0;
  }

  /// The central differences of the cell's corners, interpolated.
  void InterpolateGradient(const double index[3], double gradient[3]) const
  {
    gradient[0] = gradient[1] = gradient[2] = 0;
    this->VisitCorners(index, [&](const vtkIdType ijk[3], double weight) {
      double g[3];
      this->Field.GetGradient(ijk, g);
      for (int c = 0; c < 3; ++c)
      {
        gradient[c] += weight * g[c];
      }
    });
  }

  /// Calls visit with each corner of the cell that an index lies in, and its trilinear weight.
  template <typename Visitor>
  void VisitCorners(const double index[3], const Visitor& visit) const
  {
    vtkIdType cell[3];
    double at[3];
    this->GetCell(index, cell, at);
    for (int corner = 0; corner < 8; ++corner)
    {
      vtkIdType ijk[3];
      double weight = 1;
      for (int c = 0; c < 3; ++c)
      {
        const int high = corner >> c & 1;
        ijk[c] = cell[c] + high;
        weight *= high ? at[c] : 1 - at[c];
      }
      visit(ijk, weight);
    }
  }

  const vtkIsosurfaceField<T>& Field;
};

VTK_ABI_NAMESPACE_END
#endif
