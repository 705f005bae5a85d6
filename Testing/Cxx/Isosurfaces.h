// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes of a field, and their isosurfaces by vtkIsosurfacePoints, for tests.
#ifndef Isosurfaces_h
#define Isosurfaces_h

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIsosurfacePoints.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <functional>

using Field = std::function<double(const double x[3])>;

/// A volume of [-1.1, 1.1]^3 in its own axes, which are turned if asked, of samples so far apart.
inline vtkSmartPointer<vtkImageData> Volume(
  const Field& field, const std::array<double, 3>& spacing, bool turned, bool mirrored)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int n[3];
  for (int c = 0; c < 3; ++c)
  {
    n[c] = static_cast<int>(std::round(2.2 / spacing[c])) + 1;
  }
  image->SetDimensions(n);
  image->SetSpacing(spacing.data());
  const double s = turned ? 0.6 : 0, d = turned ? 0.8 : 1, m = mirrored ? -1 : 1;
  // The third axis mirrored, then about z, then about x.
  image->SetDirectionMatrix(d, -s, 0, s * d, d * d, -s * m, s * s, d * s, d * m);
  double centre[3], index[3] = { 0.5 * (n[0] - 1), 0.5 * (n[1] - 1), 0.5 * (n[2] - 1) };
  image->TransformContinuousIndexToPhysicalPoint(index, centre);
  image->SetOrigin(-centre[0], -centre[1], -centre[2]);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    int ijk[3] = { static_cast<int>(i % n[0]), static_cast<int>(i / n[0] % n[1]),
      static_cast<int>(i / n[0] / n[1]) };
    image->TransformIndexToPhysicalPoint(ijk, x);
    values->SetValue(i, field(x));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

inline vtkSmartPointer<vtkPolyData> Extract(
  vtkImageData* image, double isovalue, double pointSpacing, bool fillGaps = true)
{
  vtkNew<vtkIsosurfacePoints> points;
  points->SetInputData(image);
  points->SetValue(0, isovalue);
  points->SetPointSpacing(pointSpacing);
  points->SetFillGaps(fillGaps);
  points->Update();
  vtkSmartPointer<vtkPolyData> output = points->GetOutput();
  return output;
}

#endif
