// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkIsosurfacePoints of scattered samples that are missing, bad, or odd.
#include "ScatteredSamples.h"

#include "vtkIsosurfacePoints.h"
#include "vtkStringArray.h"

#include <array>
#include <limits>

int TestIsosurfaceScatterBadInput(int, char*[])
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  auto run = [](vtkDataObject* data, int errors, int warnings, const std::string& words,
               const std::string& what, bool empty, const char* array = nullptr) {
    vtkNew<vtkIsosurfacePoints> filter;
    Messages messages(filter);
    filter->SetInputData(data);
    filter->SetValue(0, 0.5);
    if (array)
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
    }
    filter->Update();
    messages.Expect(errors, warnings, words, what);
    Expect((filter->GetOutput()->GetNumberOfPoints() == 0) == empty, what + ": points");
    for (const double number : GetNumbers(filter->GetOutput()))
    {
      Expect(std::isfinite(number), what + ": numbers are finite");
    }
    return vtkSmartPointer<vtkPolyData>(filter->GetOutput());
  };
  vtkNew<vtkPolyData> nothing;
  run(nothing, 0, 1, "0 usable samples", "no points", true);
  nothing->SetPoints(vtkNew<vtkPoints>());
  run(nothing, 0, 1, "0 usable samples", "no points", true);

  auto make = [](int count) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(vtkNew<vtkPoints>());
    vtkNew<vtkDoubleArray> values;
    values->SetName("Field");
    for (int i = 0; i < count; ++i)
    {
      data->GetPoints()->InsertNextPoint(0, 0, 0);
      values->InsertNextValue(i);
    }
    data->GetPointData()->SetScalars(values);
    return data;
  };
  run(make(1), 0, 1, "1 usable samples", "one point", true);
  run(make(100), 0, 2, "99 lie where another one lies", "all duplicates", true);
  vtkSmartPointer<vtkPolyData> two = make(2);
  two->GetPoints()->SetPoint(1, 1, 2, 4);
  vtkSmartPointer<vtkPolyData> middle = run(two, 0, 0, "", "two points", false);
  Expect(middle->GetNumberOfPoints() == 1 &&
      std::sqrt(vtkMath::Distance2BetweenPoints(
        middle->GetPoint(0), std::array<double, 3>{ { 0.5, 1, 2 } }.data())) < 1e-5,
    "halfway between two points");

  vtkSmartPointer<vtkPolyData> sphere = Scatter(fields[0], Uniform, 10000);
  run(sphere, 1, 0, "\"Nothing\"", "no such array", true, "Nothing");
  vtkNew<vtkStringArray> strings;
  strings->SetName("Words");
  strings->SetNumberOfValues(10000);
  sphere->GetPointData()->AddArray(strings);
  run(sphere, 1, 0, "\"Words\"", "an array of words", true, "Words");
  vtkNew<vtkFloatArray> few;
  few->SetName("Few");
  few->SetNumberOfTuples(10);
  sphere->GetPointData()->AddArray(few);
  run(sphere, 1, 0, "\"Few\"", "too few values", true, "Few");

  // What is bad does not spoil what is good.
  auto* values = vtkDoubleArray::SafeDownCast(sphere->GetPointData()->GetScalars());
  for (int i = 0; i < 10; ++i)
  {
    sphere->GetPoints()->SetPoint(i, i % 2 ? nan : 0, i % 2 ? 0 : infinity, 0);
    values->SetValue(100 + i, i % 2 ? nan : -infinity);
    sphere->GetPoints()->SetPoint(200 + i, sphere->GetPoint(300));
  }
  sphere->GetPoints()->SetPoint(400, 1e30, -1e36, 0);
  vtkNew<vtkIsosurfacePoints> filter;
  Messages messages(filter);
  filter->SetInputData(sphere);
  filter->SetValue(0, 0.7);
  filter->Update();
  messages.Expect(0, 1, "10 have coordinates that are not finite, 10 have values", "bad samples");
  messages.Expect(0, 1, "\"Field\"", "bad samples");
  messages.Expect(0, 1, "10 lie where another one lies", "bad samples");
  Expect(filter->GetOutput()->GetNumberOfPoints() > 500, "points beside bad samples");
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    AtMost(std::abs(Distance(filter->GetOutput()->GetPoint(i)) - 0.7), 0.01, "bad samples");
  }
  filter->SetArrayComponent(1);
  filter->Update();
  Expect(messages.Errors == 1, "no such component is an error");
  filter->SetArrayComponent(0);
  for (const double spacing : { nan, infinity, 1e300, 1e-300 })
  {
    filter->SetPointSpacing(spacing);
    filter->SetNeighborRadius(spacing);
    filter->Update();
  }
  // NaN is refused by both; what else is odd is clamped.
  Expect(messages.Errors == 3, "odd lengths are no error");

  // A plane's isosurface is a line, a jump's is where it is, and noise has one somewhere.
  vtkSmartPointer<vtkPolyData> odd = Scatter(fields[0], Uniform, 5000);
  values = vtkDoubleArray::SafeDownCast(odd->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < 5000; ++i)
  {
    values->SetValue(i, values->GetValue(i) > 0.7 ? 1 : 0);
  }
  run(odd, 0, 0, "", "a jump", false);
  for (vtkIdType i = 0; i < 5000; ++i)
  {
    values->SetValue(i, std::fmod(1000 * odd->GetPoint(i)[1] + 1000, 1.0));
  }
  run(odd, 0, 0, "", "noise", false);
  for (vtkIdType i = 0; i < 5000; ++i)
  {
    double x[3];
    odd->GetPoint(i, x);
    odd->GetPoints()->SetPoint(i, x[0], x[1], 0);
    values->SetValue(i, Ball(x) - x[2] * x[2]);
  }
  vtkSmartPointer<vtkPolyData> line = run(odd, 0, 0, "", "samples in a plane", false);
  AtMost(std::max(std::abs(line->GetBounds()[4]), line->GetBounds()[5]), 1e-6, "off the plane");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
