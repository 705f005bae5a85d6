// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCase.h"
#include "FuzzData.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkIsosurfacePoints.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatGrouping.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace
{
bool Finite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/**
 * Runs the filter, and once more: the same must come out, and the input must stay.
 */
vtkDataObject* RunTwice(vtkAlgorithm* filter, vtkDataObject* input)
{
  const std::uint64_t before = FuzzData::Digest(input);
  const vtkMTimeType time = input->GetMTime();
  filter->SetInputDataObject(0, input);
  filter->Update();
  const std::uint64_t first = FuzzData::Digest(filter->GetOutputDataObject(0));
  filter->Modified();
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  FuzzExpect(FuzzData::Digest(output) == first, "the filter's outputs of two runs differ");
  FuzzExpect(
    FuzzData::Digest(input) == before && input->GetMTime() == time, "the filter changed its input");
  return output;
}

/**
 * An array of the output, of one tuple a point, or a finding.
 */
vtkDataArray* Wanted(vtkPolyData* output, const char* name, int components)
{
  vtkDataArray* array = output->GetPointData()->GetArray(name);
  FuzzExpect(array && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == output->GetNumberOfPoints(),
    std::string("the output's array is not there or has the wrong shape: ") + name);
  return array;
}

void CheckIsosurface(vtkPolyData* output)
{
  if (output->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  FuzzExpect(normals && normals->GetNumberOfTuples() == output->GetNumberOfPoints(), "no normals");
  Wanted(output, "Isovalue", 1);
  double v[3];
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    output->GetPoint(i, v);
    FuzzExpect(Finite(v), "an isosurface point is not finite");
    normals->GetTuple(i, v);
    FuzzExpect(
      std::abs(vtkMath::Norm(v) - 1) < 1e-3, "an isosurface normal has not unit length");
  }
  vtkPointData* data = output->GetPointData();
  FuzzExpect(!data->HasArray("SplatRadius") == !data->HasArray("SplatCurvature"),
    "one of an isosurface's size arrays is missing");
  if (data->HasArray("SplatRadius"))
  {
    vtkDataArray* radii = Wanted(output, "SplatRadius", 1);
    vtkDataArray* curvatures = Wanted(output, "SplatCurvature", 6);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double radius = radii->GetComponent(i, 0);
      FuzzExpect(radius >= 0 && std::isfinite(radius), "a radius is negative or not finite");
      for (int c = 0; c < 6; ++c)
      {
        FuzzExpect(
          std::isfinite(curvatures->GetComponent(i, c)), "a curvature is not finite");
      }
    }
  }
}

void RunIsosurface(FuzzRandom& random)
{
  vtkNew<vtkIsosurfacePoints> filter;
  filter->SetSplatSizes(!random.Chance(0.2));
  const int number = random.Chance(0.05) ? random.Below(300) : random.Below(4);
  filter->SetNumberOfContours(number);
  for (int i = 0; i < number; ++i)
  {
    filter->SetValue(i, random.Chance(0.1) ? random.Nasty() : random.Uniform(-5, 105));
  }
  const bool volume = random.Chance(0.6);
  if (random.Chance(0.4))
  {
    // Points go with the square of its inverse.
    filter->SetPointSpacing(random.Chance(0.9) ? random.Uniform(0.2, 3)
                                               : random.Pick({ 1e30, -1.0, 1e300, std::nan("") }));
  }
  filter->SetBlockPerIsovalue(random.Chance(0.2));
  filter->SetArrayComponent(random.Chance(0.1) ? random.Below(4) : 0);
  filter->SetNumberOfNeighbors(random.Chance(0.5) ? 26 : random.Pick({ -5, 6, 10, 60, 128, 1000 }));
  if (random.Chance(0.3))
  {
    filter->SetNeighborRadius(random.Property(0, 1));
  }
  filter->SetCorrection(random.Chance(0.7));
  vtkSmartPointer<vtkDataObject> input;
  if (volume)
  {
    input = FuzzData::MakeImage(random);
  }
  else
  {
    vtkSmartPointer<vtkPointSet> samples = FuzzData::MakePoints(random);
    if (!samples->GetPointData()->GetScalars())
    {
      vtkSmartPointer<vtkDataArray> scalars =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_DOUBLE));
      scalars->SetName("values");
      scalars->SetNumberOfTuples(samples->GetNumberOfPoints());
      for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
      {
        scalars->SetTuple1(i, random.Uniform(0, 100));
      }
      samples->GetPointData()->SetScalars(scalars);
    }
    else if (random.Chance(0.8))
    {
      double range[2];
      samples->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
      filter->GenerateValues(1 + random.Below(3), range[0], range[1]);
    }
    input = samples;
  }
  vtkDataObject* output = RunTwice(filter, input);
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
  {
    for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
    {
      CheckIsosurface(vtkPolyData::SafeDownCast(blocks->GetBlock(b)));
    }
    return;
  }
  CheckIsosurface(vtkPolyData::SafeDownCast(output));
}

void CheckEstimation(vtkPointSplatEstimation* filter, vtkPointSet* input, vtkPolyData* output)
{
  const vtkIdType n =
    input->GetNumberOfPoints() + static_cast<vtkIdType>(filter->GetFillPoints().size());
  FuzzExpect(output->GetNumberOfPoints() == n, "the estimation lost or made points");
  for (const vtkPointSplatEstimation::FillPoint& point : filter->GetFillPoints())
  {
    float sum = 0;
    for (int k = 0; k < point.Count; ++k)
    {
      FuzzExpect(point.Ends[k] >= 0 && point.Ends[k] < input->GetNumberOfPoints(),
        "a fill point lies between others than the input's");
      sum += point.Weights[k];
    }
    FuzzExpect(std::abs(sum - 1) < 1e-3, "a fill point's weights are no weights");
  }
  if (n == 0)
  {
    return;
  }
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  FuzzExpect(normals && normals->GetNumberOfTuples() == n, "the estimation gave no normals");
  const bool elliptical = filter->GetShape() == vtkPointSplatEstimation::Elliptical;
  vtkDataArray* sizes[2] = {
    elliptical ? Wanted(output, "SplatAxis1", 3) : Wanted(output, "SplatRadius", 1),
    elliptical ? Wanted(output, "SplatAxis2", 3) : Wanted(output, "SplatCurvature", 6)
  };
  const double scale = filter->GetRadiusScale();
  for (vtkIdType i = 0; i < n; ++i)
  {
    double normal[3], a[6], b[6];
    normals->GetTuple(i, normal);
    sizes[0]->GetTuple(i, a);
    sizes[1]->GetTuple(i, b);
    const double length = elliptical ? vtkMath::Norm(a) : a[0];
    if (std::isfinite(scale) && scale <= 1e6)
    {
      FuzzExpect(std::isfinite(length) && length >= 0, "a splat's size is no length");
    }
    if (!(length > 0))
    {
      continue;
    }
    FuzzExpect(std::abs(vtkMath::Norm(normal) - 1) < 1e-3, "a splat's normal has not unit length");
    if (!elliptical)
    {
      FuzzExpect(Finite(b) && Finite(b + 3), "a splat's curvature is not finite");
    }
  }
}

void RunEstimation(FuzzRandom& random)
{
  vtkNew<vtkPointSplatEstimation> filter;
  filter->SetNumberOfNeighbors(random.Pick({ 12, 12, -1, 4, 7, 32, 100 }));
  filter->SetShape(random.Below(2));
  filter->SetOrientation(random.Below(2));
  filter->SetFillGaps(random.Chance(0.7));
  filter->SetFillMeshGaps(random.Chance(0.7));
  filter->SetViewpoint(random.Property(-1, 1), random.Property(-1, 1), random.Property(-1, 1));
  if (random.Chance(0.2))
  {
    filter->SetRadiusScale(random.Property(0, 2));
  }
  vtkSmartPointer<vtkPointSet> input = FuzzData::MakePoints(random);
  CheckEstimation(filter, input, vtkPolyData::SafeDownCast(RunTwice(filter, input)));
}

void RunGrouping(FuzzRandom& random)
{
  vtkNew<vtkPointSplatGrouping> filter;
  filter->SetColoring(random.Below(2));
  filter->SetOverlapFactor(random.Property(0, 1));
  filter->SetReach(random.Chance(0.5) ? 1.5 : random.Property(0.5, 3));
  filter->SetIgnoreOpposite(random.Chance(0.3));
  filter->SetCoplanarAngle(random.Chance(0.5) ? 0 : random.Property(0, 90));
  filter->SetColorTolerance(random.Pick({ -1, 0, 4, 255, 1000 }));
  filter->SetWantedNumberOfGroups(random.Pick({ 0, 0, 1, 4, 64, 100 }));
  filter->SetMaximumOverlap(random.Property(0, 0.2));
  filter->SetCoverage(random.Chance(0.5) ? 0 : random.Below(3));
  filter->SetMaximumClipped(random.Property(0, 1));
  vtkSmartPointer<vtkPointSet> input = FuzzData::MakePoints(random);
  auto* output = vtkPolyData::SafeDownCast(RunTwice(filter, input));
  FuzzExpect(output->GetNumberOfPoints() >= input->GetNumberOfPoints(), "grouping lost points");
  if (output->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkDataArray* groups = Wanted(output, "SplatGroup", 1);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double group = groups->GetTuple1(i);
    FuzzExpect(group >= -1 && group < std::max(1, filter->GetNumberOfGroups()),
      "a splat's group is out of range");
  }
  FuzzExpect(std::isfinite(filter->GetOverlapWithinGroups()) &&
      std::isfinite(filter->GetMeanDegree()),
    "a figure of grouping is not finite");
  for (int k = 0; k < filter->GetNumberOfGroups(); ++k)
  {
    FuzzExpect(std::isfinite(filter->GetGroupCoverage(k)) &&
        std::isfinite(filter->GetGroupCoverageBefore(k)) && filter->GetGroupRadiusScale(k) > 0,
      "a group's coverage is not finite");
  }
}
}

void FuzzFilters(FuzzRandom& random)
{
  switch (random.Below(3))
  {
    case 0:
      RunIsosurface(random);
      break;
    case 1:
      RunEstimation(random);
      break;
    default:
      RunGrouping(random);
      break;
  }
}
