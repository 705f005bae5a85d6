// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkIsosurfaceField.h
 * @brief a volume's samples as vtkIsosurfacePoints works on them
 *
 * Internal. A *class* of a sample is the number of isovalues that it reaches, so two samples
 * of different class have an isosurface between them, and the sweep over a volume is a
 * comparison of bytes whatever the scalar type and the number of isovalues.
 */
#ifndef vtkIsosurfaceField_h
#define vtkIsosurfaceField_h

#include "vtkDataSetAttributes.h"
#include "vtkIsosurfaceSplat.h"
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Of a sample: the number of isovalues that it reaches.
using vtkIsosurfaceClass = std::uint8_t;

/// What does not depend on the scalars' type.
struct vtkIsosurfaceGrid
{
  vtkIdType Dimensions[3];
  vtkIdType Strides[3]; // of points, in samples
  double Spacing[3];    // lengths of a cell's sides
  double ToWorld[3][4]; // from indices counted from 0
  double ToNormal[3][3]; // from a gradient in index space, not normalised
  double Side;           // of the normal: -1 against the gradient, 1 along it
  const unsigned char* PointGhosts = nullptr;
  const unsigned char* CellGhosts = nullptr;

  bool IsHidden(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    return this->PointGhosts &&
      (this->PointGhosts[i + this->Dimensions[0] * (j + this->Dimensions[1] * k)] &
        vtkDataSetAttributes::HIDDENPOINT);
  }

  /// A cell that is there and this process' own.
  bool HasCell(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    const vtkIdType* n = this->Dimensions;
    return i >= 0 && j >= 0 && k >= 0 && i < n[0] - 1 && j < n[1] - 1 && k < n[2] - 1 &&
      !(this->CellGhosts &&
        (this->CellGhosts[i + (n[0] - 1) * (j + (n[1] - 1) * k)] &
          (vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL)));
  }

  void GetWorld(const double index[3], double x[3]) const
  {
    for (int r = 0; r < 3; ++r)
    {
      const double* m = this->ToWorld[r];
      x[r] = m[0] * index[0] + m[1] * index[1] + m[2] * index[2] + m[3];
    }
  }

  /// The unit normal; false if the gradient is zero.
  bool GetNormal(const double gradient[3], double normal[3]) const
  {
    double largest = 0;
    for (int r = 0; r < 3; ++r)
    {
      const double* m = this->ToNormal[r];
      normal[r] = m[0] * gradient[0] + m[1] * gradient[1] + m[2] * gradient[2];
      largest = std::max(largest, std::abs(normal[r]));
    }
    // Scaled first, since squares may overflow or underflow.
    double squared = 0;
    for (int r = 0; r < 3; ++r)
    {
      normal[r] /= largest;
      squared += normal[r] * normal[r];
    }
    if (!(squared > 0) || !std::isfinite(squared))
    {
      return false;
    }
    const double inverse = 1 / std::sqrt(squared);
    normal[0] *= inverse;
    normal[1] *= inverse;
    normal[2] *= inverse;
    return true;
  }

  /// The field's slope in world units along a normal, which is the gradient's direction or against it.
  double GetSlope(const double gradient[3], const double normal[3]) const
  {
    double slope = 0;
    for (int r = 0; r < 3; ++r)
    {
      const double* m = this->ToNormal[r];
      slope += normal[r] * (m[0] * gradient[0] + m[1] * gradient[1] + m[2] * gradient[2]);
    }
    return slope;
  }

  /// Bends a splat, its normal and radius set, by the slope along it and a Hessian in index space.
  void Bend(double slope, const double hessian[6], vtkIsosurfaceSplat& splat) const
  {
    const double (&m)[3][3] = this->ToNormal;
    double rotated[6];
    static const int rows[6] = { 0, 1, 2, 0, 1, 0 };
    static const int columns[6] = { 0, 1, 2, 1, 2, 2 };
    const double* h = hessian;
    for (int k = 0; k < 6; ++k)
    {
      const double *p = m[rows[k]], *q = m[columns[k]];
      rotated[k] = this->Side *
        (h[0] * p[0] * q[0] + h[1] * p[1] * q[1] + h[2] * p[2] * q[2] +
          h[3] * (p[0] * q[1] + p[1] * q[0]) + h[4] * (p[1] * q[2] + p[2] * q[1]) +
          h[5] * (p[0] * q[2] + p[2] * q[0]));
    }
    splat.Bend(rotated, slope);
  }
};

template <typename T>
class vtkIsosurfaceField
{
public:
  using Class = vtkIsosurfaceClass;
  /// What fits into Class.
  static constexpr int MaximumNumberOfIsovalues = 254;

  /// values: the first point's component; isovalues: finite, ascending.
  vtkIsosurfaceField(
    const vtkIsosurfaceGrid& grid, const T* values, const std::vector<double>& isovalues)
    : Grid(grid)
    , Isovalues(isovalues)
    , Values(values)
    , ReachedByAll(0)
  {
    for (double isovalue : isovalues)
    {
      T threshold;
      const int always = GetThreshold(isovalue, threshold);
      this->ReachedByAll += always > 0;
      if (always == 0)
      {
        this->Thresholds.push_back(threshold);
      }
    }
  }

  const vtkIsosurfaceGrid& Grid;
  const std::vector<double> Isovalues;

  const T* GetPointer(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    return this->Values + i * this->Grid.Strides[0] + j * this->Grid.Strides[1] +
      k * this->Grid.Strides[2];
  }
  double Get(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    return static_cast<double>(*this->GetPointer(i, j, k));
  }
  /// Whether a surface may be looked for beside this sample.
  bool IsUsable(vtkIdType i, vtkIdType j, vtkIdType k) const
  {
    return std::isfinite(this->Get(i, j, k)) && !this->Grid.IsHidden(i, j, k);
  }

  /// Bytes from one row of classes to the next: rows are padded with their last class.
  vtkIdType GetClassStride() const { return (this->Grid.Dimensions[0] + 16) / 8 * 8; }

  /// The classes of slice k.
  void Classify(vtkIdType k, std::vector<Class>& classes) const
  {
    // Of its own, since a byte that is written may be part of whatever is read through a pointer.
    const vtkIdType count = this->Grid.Dimensions[0], rows = this->Grid.Dimensions[1];
    const vtkIdType stride = this->GetClassStride();
    classes.resize(stride * rows);
    std::vector<T> row;
    for (vtkIdType j = 0; j < rows; ++j)
    {
      const T* values = this->GetPointer(0, j, k);
      if (this->Grid.Strides[0] != 1)
      {
        row.resize(count);
        for (vtkIdType i = 0; i < count; ++i)
        {
          row[i] = values[i * this->Grid.Strides[0]];
        }
        values = row.data();
      }
      Class* out = classes.data() + stride * j;
      std::memset(out, this->ReachedByAll, count);
      for (const T threshold : this->Thresholds)
      {
        for (vtkIdType i = 0; i < count; ++i)
        {
          out[i] = static_cast<Class>(out[i] + (values[i] >= threshold));
        }
      }
      std::memset(out + count, out[count - 1], stride - count);
    }
  }

  /**
   * The gradient in index space: central differences, one-sided where the volume ends or the
   * next sample is not to be used, zero where both are not.
   */
  void GetGradient(const vtkIdType ijk[3], double gradient[3]) const
  {
    const T* s = this->GetPointer(ijk[0], ijk[1], ijk[2]);
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType stride = this->Grid.Strides[c];
      vtkIdType before = ijk[c] > 0, after = ijk[c] < this->Grid.Dimensions[c] - 1;
      gradient[c] = before + after > 0
        ? (static_cast<double>(s[after * stride]) - static_cast<double>(s[-before * stride])) /
          static_cast<double>(before + after)
        : 0.0;
      if (this->Grid.PointGhosts || !std::isfinite(gradient[c]))
      {
        vtkIdType other[3] = { ijk[0], ijk[1], ijk[2] };
        other[c] = ijk[c] - before;
        before = before && this->IsUsable(other[0], other[1], other[2]);
        other[c] = ijk[c] + after;
        after = after && this->IsUsable(other[0], other[1], other[2]);
        gradient[c] = before + after > 0
          ? (static_cast<double>(s[after * stride]) - static_cast<double>(s[-before * stride])) /
            static_cast<double>(before + after)
          : 0.0;
      }
    }
  }

  /**
   * The Hessian in index space, XX, YY, ZZ, XY, YZ, XZ. Second derivatives along an axis are
   * second differences two samples wide, which are the central differences of GetGradient's and
   * average noise, and half of what ones that are one sample wide add to them: these follow thin
   * parts. But where they differ by more than the wide ones' own size, as in values rounded to
   * integers, they are mostly noise, and no more than that counts. Mixed ones are central
   * differences of central differences. Where the volume ends they are those of the next sample
   * inside, and where a sample is not to be used, the narrow ones or zero.
   */
  void GetHessian(const vtkIdType ijk[3], double hessian[6]) const
  {
    const vtkIdType* n = this->Grid.Dimensions;
    bool inner = !this->Grid.PointGhosts;
    for (int c = 0; c < 3; ++c)
    {
      inner = inner && ijk[c] >= 2 && ijk[c] < n[c] - 2;
    }
    // All but a few samples have all that they need around them, which is much faster.
    if (!inner || !this->GetInnerHessian(ijk, hessian))
    {
      this->GetOuterHessian(ijk, hessian);
    }
  }

private:
  /// A second derivative from differences one and two samples wide.
  static double Join(double narrow, double wide)
  {
    const double most = std::abs(wide);
    return wide + 0.5 * std::clamp(narrow - wide, -most, most);
  }

  /// False if it is not finite.
  bool GetInnerHessian(const vtkIdType ijk[3], double hessian[6]) const
  {
    const T* s = this->GetPointer(ijk[0], ijk[1], ijk[2]);
    const vtkIdType* stride = this->Grid.Strides;
    auto get = [s](vtkIdType offset) { return static_cast<double>(s[offset]); };
    const double here = get(0);
    double sum = 0;
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType a = stride[c], b = stride[(c + 1) % 3];
      hessian[c] = Join(
        get(-a) - 2 * here + get(a), 0.25 * (get(-2 * a) - 2 * here + get(2 * a)));
      hessian[3 + c] = 0.25 * (get(a + b) - get(a - b) - get(b - a) + get(-a - b));
      sum += hessian[c] + hessian[3 + c];
    }
    return std::isfinite(sum);
  }

  void GetOuterHessian(const vtkIdType ijk[3], double hessian[6]) const
  {
    const vtkIdType* n = this->Grid.Dimensions;
    vtkIdType low[3], high[3];
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::max<vtkIdType>(ijk[c] - 1, 0);
      high[c] = std::min(ijk[c] + 1, n[c] - 1);
      hessian[c] = 0;
      if (n[c] > 2)
      {
        vtkIdType at[3] = { ijk[0], ijk[1], ijk[2] };
        const vtkIdType middle = std::clamp<vtkIdType>(ijk[c], 1, n[c] - 2);
        auto difference = [&](vtkIdType width) {
          double sum = 0;
          for (int i = -1; i <= 1; ++i)
          {
            at[c] = middle + i * width;
            sum += (i == 0 ? -2 : 1) * this->GetUsable(at);
          }
          return sum / static_cast<double>(width * width);
        };
        const double narrow = difference(1);
        const double wide = middle >= 2 && middle < n[c] - 2 ? difference(2) : narrow;
        const double both = Join(narrow, wide);
        hessian[c] = std::isfinite(both) ? both : std::isfinite(narrow) ? narrow : 0.0;
      }
    }
    // XY, YZ, and ZX, which is XZ
    for (int c = 0; c < 3; ++c)
    {
      const int d = (c + 1) % 3;
      vtkIdType at[3] = { ijk[0], ijk[1], ijk[2] };
      auto get = [&](vtkIdType i, vtkIdType j) {
        at[c] = i;
        at[d] = j;
        return this->GetUsable(at);
      };
      const double mixed = (get(high[c], high[d]) - get(high[c], low[d]) - get(low[c], high[d]) +
                             get(low[c], low[d])) /
        static_cast<double>((high[c] - low[c]) * (high[d] - low[d]));
      hessian[3 + c] = std::isfinite(mixed) ? mixed : 0.0;
    }
  }

  /// A sample's value, not a number where it is not to be used.
  double GetUsable(const vtkIdType ijk[3]) const
  {
    return this->Grid.IsHidden(ijk[0], ijk[1], ijk[2]) ? std::numeric_limits<double>::quiet_NaN()
                                                       : this->Get(ijk[0], ijk[1], ijk[2]);
  }

  /// The least T that is not less than the isovalue, if some are (0); 1 if all are, -1 if none.
  static int GetThreshold(double isovalue, T& threshold)
  {
    if constexpr (std::is_same<T, double>::value)
    {
      threshold = isovalue;
    }
    else if constexpr (std::is_floating_point<T>::value)
    {
      if (std::abs(isovalue) > std::numeric_limits<T>::max())
      {
        return isovalue > 0 ? -1 : 1;
      }
      threshold = static_cast<T>(isovalue);
      if (static_cast<double>(threshold) < isovalue)
      {
        threshold = std::nextafter(threshold, std::numeric_limits<T>::max());
      }
    }
    else
    {
      const double least = std::ceil(isovalue);
      if (least <= static_cast<double>(std::numeric_limits<T>::lowest()))
      {
        return 1;
      }
      // The maximum of a 64 bit type is rounded up to a power of 2, out of its range.
      if (least > static_cast<double>(std::numeric_limits<T>::max()) ||
        least >= std::ldexp(1.0, std::numeric_limits<T>::digits))
      {
        return -1;
      }
      threshold = static_cast<T>(least);
    }
    return 0;
  }

  const T* Values;
  std::vector<T> Thresholds;
  int ReachedByAll;
};

VTK_ABI_NAMESPACE_END
#endif
