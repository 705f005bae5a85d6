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

#include "vtkPointSplattingABI.h"
#include "vtkType.h"

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

    void Put(vtkIdType id, const double x[3], const double n[3]) const
    {
      for (int c = 0; c < 3; ++c)
      {
        if (this->Points)
        {
          this->Points[3 * id + c] = static_cast<float>(x[c]);
        }
        else
        {
          this->PrecisePoints[3 * id + c] = x[c];
        }
        this->Normals[3 * id + c] = static_cast<float>(n[c]);
      }
    }
  };

  virtual ~vtkIsosurfaceExtraction() = default;

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
