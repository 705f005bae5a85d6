// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceExtraction
 * @brief   one way to find points on isosurfaces: first how many, then which
 *
 * Internal to vtkIsosurfacePoints: what its extractions for all scalar types have in common.
 */
#ifndef vtkIsosurfaceExtraction_h
#define vtkIsosurfaceExtraction_h

#include "vtkIsosurfaceSplat.h"
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

class vtkAlgorithm;

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceExtraction
{
public:
  /// Where one isovalue's points go: one of the first two is set.
  struct Target
  {
    float* Points = nullptr;
    double* PrecisePoints = nullptr;
    float* Normals = nullptr;
    float* Radii = nullptr; // both or none of these
    float* Curvatures = nullptr;
    double LargestRadius = LargestNumber;

    /// Whether splats need their size and bend.
    bool HasSizes() const { return this->Radii != nullptr; }

    void Put(vtkIdType id, const vtkIsosurfaceSplat& splat) const
    {
      for (int c = 0; c < 3; ++c)
      {
        if (this->Points)
        {
          this->Points[3 * id + c] = static_cast<float>(splat.Position[c]);
        }
        else
        {
          this->PrecisePoints[3 * id + c] = splat.Position[c];
        }
        this->Normals[3 * id + c] = static_cast<float>(splat.Normal[c]);
      }
      if (this->HasSizes())
      {
        this->Radii[id] = static_cast<float>(std::min(splat.Radius, this->LargestRadius));
        for (int c = 0; c < 6; ++c)
        {
          this->Curvatures[6 * id + c] =
            static_cast<float>(std::clamp(splat.Curvature[c], -LargestNumber, LargestNumber));
        }
      }
    }

    /// Floats hold little more.
    static constexpr double LargestNumber = 3e38;
  };

  virtual ~vtkIsosurfaceExtraction() = default;

  /// Whether it knows how far the points lie apart, so that it can give splats their size.
  virtual bool KnowsSizes() const { return true; }

  ///@{
  /**
   * Moves self's progress from `from` to `to`; returns false if aborted. counts and targets
   * are in the order of the isovalues.
   */
  virtual bool Find(
    vtkAlgorithm* self, double from, double to, std::vector<vtkIdType>& counts) = 0;
  virtual bool Write(
    vtkAlgorithm* self, double from, double to, const std::vector<Target>& targets) const = 0;
  ///@}
};

VTK_ABI_NAMESPACE_END
#endif
