// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HydrogenVolume.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeHydrogenVolume(int size)
{
  const double extent = 40.0;
  const double step = extent / (size - 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetSpacing(step, step, step);
  image->SetOrigin(-0.5 * extent, -0.5 * extent, -0.5 * extent);
  vtkNew<vtkFloatArray> density;
  density->SetName("density");
  density->SetNumberOfTuples(static_cast<vtkIdType>(size) * size * size);
  float* values = density->GetPointer(0);
  vtkPointSplatThreads::For(0, size, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType k = begin; k < end; ++k)
    {
      for (vtkIdType j = 0; j < size; ++j)
      {
        for (vtkIdType i = 0; i < size; ++i)
        {
          const double x = i * step - 0.5 * extent;
          const double y = j * step - 0.5 * extent;
          const double z = k * step - 0.5 * extent;
          const double r2 = x * x + y * y + z * z;
          // psi of n = 3, l = 2, m = 0, without its constant.
          const double psi = (3.0 * z * z - r2) * std::exp(-std::sqrt(r2) / 3.0);
          values[(k * size + j) * size + i] = static_cast<float>(psi * psi);
        }
      }
    }
  });
  const float greatest = *std::max_element(values, values + density->GetNumberOfTuples());
  std::for_each(values, values + density->GetNumberOfTuples(),
    [greatest](float& value) { value *= 100.0f / greatest; });
  image->GetPointData()->SetScalars(density);
  return image;
}
