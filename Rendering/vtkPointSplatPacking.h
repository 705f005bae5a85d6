// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// From the arrays of one block of a mapper's input to packed splats, in the form
// that vtkPointSplatCloud.h describes.
#ifndef vtkPointSplatPacking_h
#define vtkPointSplatPacking_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include "vtkPointSplattingABI.h"

#include <array>
#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPointSplatMapper;
VTK_ABI_NAMESPACE_END

struct vtkPointSplatPacking
{
  vtkSmartPointer<vtkDataArray> Points;
  vtkSmartPointer<vtkDataArray> Normals;
  vtkSmartPointer<vtkDataArray> Radius;
  vtkSmartPointer<vtkDataArray> Plane;     // or none
  vtkSmartPointer<vtkDataArray> Curvature; // or none
  vtkSmartPointer<vtkDataArray> Axis1;
  vtkSmartPointer<vtkDataArray> Axis2;
  vtkUnsignedCharArray* Ghosts = nullptr;

  /**
   * The arrays of a block, what is missing estimated; sizes only if they are needed.
   */
  static vtkPointSplatPacking Collect(
    vtkPointSplatMapper* mapper, vtkPointSet* data, bool needSizes);

  /**
   * Packs the block's splats, 8 words each if circular, otherwise 16; without sizes their
   * radius is 0. valid gets 1 for each point that can be drawn; the caller closes the gaps
   * that the others leave.
   */
  void Pack(const std::array<double, 3>& origin, bool circular, uint32_t* splats,
    unsigned char* valid) const;

  /**
   * Of a bend as Pack() codes it, the mean of its eigenvalues: over the radius, the mean curvature.
   */
  static double MeanBend(uint32_t code);
};

#endif
