// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkIsosurfacePoints of scattered samples against closed forms: how far points are from the
// surface, their normals, gaps and clumps.
#include "ScatteredSamples.h"

#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkIsosurfacePoints.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkSMPTools.h"
#include "vtkStaticPointLocator.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace
{
double Quantile(std::vector<double>& values, double q)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 1e300 : values[static_cast<std::size_t>(q * (values.size() - 1))];
}

struct Measured
{
  double Median, Percentile95, Normals, Gap, Nearest;
};

/// In spacings of the samples, or of the points where that is given.
Measured Measure(
  const Field& field, Density density, int count, vtkPolyData* surface, double spacing)
{
  std::vector<double> distances, angles;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3], n[3], g[3];
    surface->GetPoint(i, p);
    surface->GetPointData()->GetNormals()->GetTuple(i, n);
    const double difference = field.Evaluate(p, g);
    const double h = GetSpacing(density, count, p[0]);
    distances.push_back(std::abs(difference) / vtkMath::Norm(g) / h);
    angles.push_back(
      vtkMath::DegreesFromRadians(
      std::acos(std::clamp(-vtkMath::Dot(n, g) / vtkMath::Norm(g), -1.0, 1.0))));
  }
  Measured measured;
  measured.Median = Quantile(distances, 0.5);
  measured.Percentile95 = Quantile(distances, 0.95);
  measured.Normals = Quantile(angles, 0.5);

  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  auto to = [&](const double p[3], int rank) {
    vtkNew<vtkIdList> ids;
    locator->FindClosestNPoints(rank, p, ids);
    double x[3];
    surface->GetPoint(ids->GetId(rank - 1), x);
    return std::sqrt(vtkMath::Distance2BetweenPoints(p, x)) /
      (spacing > 0 ? spacing : GetSpacing(density, count, p[0]));
  };
  // Places on the surface, but for a border of the cube.
  measured.Gap = 0;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(3);
  for (int i = 0; i < 10000; ++i)
  {
    double p[3], g[3];
    for (double& x : p)
    {
      x = random->GetNextRangeValue(-1, 1);
    }
    double difference = 1;
    for (int step = 0; step < 20 && std::abs(difference) > 1e-9; ++step)
    {
      difference = field.Evaluate(p, g);
      const double squared = vtkMath::Dot(g, g) + 1e-12;
      for (int c = 0; c < 3; ++c)
      {
        p[c] -= std::clamp(difference / squared * g[c], -0.1, 0.1);
      }
    }
    const double inside = 1 - 1.5 * GetSpacing(density, count, p[0]);
    if (std::abs(difference) <= 1e-9 && std::abs(p[0]) < inside && std::abs(p[1]) < inside &&
      std::abs(p[2]) < inside)
    {
      measured.Gap = std::max(measured.Gap, to(p, 1));
    }
  }
  std::vector<double> nearest;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    nearest.push_back(to(p, 2));
  }
  measured.Nearest = Quantile(nearest, 0.0);
  return measured;
}

/// Points of 4 fields, 3 densities: the figures that are reached, with a fifth to spare.
void Accuracy(int count, double spacing)
{
  for (const Field& field : fields)
  {
    for (const Density density : { Uniform, Ramp, Step })
    {
      vtkSmartPointer<vtkPolyData> samples = Scatter(field, density, count);
      vtkNew<vtkIsosurfacePoints> filter;
      filter->SetInputData(samples);
      filter->SetValue(0, field.Isovalue);
      filter->SetPointSpacing(spacing);
      filter->Update();
      const Measured m = Measure(field, density, count, filter->GetOutput(), spacing);
      const std::string name = std::string(field.Name) + ", " + std::to_string(count) +
        " samples " + (density == Uniform ? "uniform" : density == Ramp ? "on a ramp" : "with a step") +
        ", spacing " + std::to_string(spacing);
      std::printf("%s: %d points, distances %.4f %.4f, normals %.2f, gap %.2f, nearest %.2f\n",
        name.c_str(), static_cast<int>(filter->GetOutput()->GetNumberOfPoints()), m.Median,
        m.Percentile95, m.Normals, m.Gap, m.Nearest);
      const double step = density == Step ? 2 : 1;
      AtMost(m.Median, 0.009, name + ": median distance");
      AtMost(m.Percentile95, 0.032 * step, name + ": 95th percentile of distances");
      AtMost(m.Normals, 1.6, name + ": median angle of normals");
      AtMost(m.Gap, spacing == 0 ? 1.5 : 1.5 * step, name + ": widest gap");
      // Both sides of a step have their own spacing.
      AtMost(spacing == 0 ? 0.35 : 0.79, m.Nearest, name + ": nearest points");
    }
  }
}

/// What volumes' isosurfaces have, those of samples have too.
void Outputs()
{
  vtkSmartPointer<vtkPolyData> samples = Scatter(fields[1], Ramp, 10000);
  vtkNew<vtkIsosurfacePoints> filter;
  filter->SetInputData(samples);
  filter->SetNumberOfContours(3);
  filter->SetValue(0, 0.3);
  filter->SetValue(1, 0.2);
  filter->SetValue(2, 0.25);
  ExpectSameByAllBackends(filter);
  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* isovalues = output->GetPointData()->GetArray(vtkPointSplatArrays::Isovalue);
  Expect(output->GetPoints()->GetDataType() == VTK_FLOAT &&
      vtkFloatArray::SafeDownCast(output->GetPointData()->GetNormals()) &&
      vtkDoubleArray::SafeDownCast(isovalues) && output->GetNumberOfCells() == 0,
    "types of the output");
  vtkIdType counts[3] = { 0, 0, 0 };
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    AtMost(std::abs(Torus(x) - isovalues->GetComponent(i, 0)), 0.03, "distance of each isovalue");
    for (int v = 0; v < 3; ++v)
    {
      counts[v] += isovalues->GetComponent(i, 0) == filter->GetValue(v);
    }
  }
  filter->BlockPerIsovalueOn();
  filter->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  Expect(blocks && blocks->GetNumberOfBlocks() == 3, "a block for each isovalue");
  for (unsigned int v = 0; blocks && v < 3; ++v)
  {
    Expect(vtkPolyData::SafeDownCast(blocks->GetBlock(v))->GetNumberOfPoints() == counts[v],
      "the points of block " + std::to_string(v));
  }

  // Another array, component, type, and place far away; cells do not matter.
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> pairs;
  pairs->SetName("Pairs");
  pairs->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    double x[3];
    samples->GetPoint(i, x);
    const int distance = static_cast<int>(std::lround(1e6 * Torus(x)));
    points->InsertNextPoint(x[0] + 3e6, x[1] - 5e6, x[2]);
    pairs->InsertNextTuple2(17, distance);
  }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(pairs);
  vtkNew<vtkIsosurfacePoints> other;
  other->SetInputData(grid);
  other->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Pairs");
  other->SetArrayComponent(1);
  other->SetValue(0, 250000);
  other->Update();
  output = other->GetOutput();
  Expect(output->GetPoints()->GetDataType() == VTK_DOUBLE, "double far from the origin");
  Expect(output->GetNumberOfPoints() > 500, "points far from the origin");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    x[0] -= 3e6;
    x[1] += 5e6;
    AtMost(std::abs(Torus(x) - 0.25), 0.02, "distance far from the origin");
  }

  // Progress goes up; and stops when asked to.
  vtkNew<vtkCallbackCommand> watch;
  double last = -1;
  watch->SetClientData(&last);
  watch->SetCallback([](vtkObject* self, unsigned long, void* before, void*) {
    auto* algorithm = static_cast<vtkAlgorithm*>(self);
    double& progress = *static_cast<double*>(before);
    Expect(algorithm->GetProgress() >= progress, "progress goes back");
    progress = algorithm->GetProgress();
  });
  const unsigned long tag = other->AddObserver(vtkCommand::ProgressEvent, watch);
  other->SetPointSpacing(0.02);
  other->Update();
  Expect(last == 1, "progress ends with 1");
  other->RemoveObserver(tag);
  for (const double when : { 0.1, 0.3, 0.8 })
  {
    vtkNew<vtkCallbackCommand> stop;
    double limit = when;
    stop->SetClientData(&limit);
    stop->SetCallback([](vtkObject* self, unsigned long, void* at, void*) {
      auto* algorithm = static_cast<vtkAlgorithm*>(self);
      if (algorithm->GetProgress() >= *static_cast<double*>(at))
      {
        algorithm->SetAbortExecute(1);
      }
    });
    const unsigned long stopping = other->AddObserver(vtkCommand::ProgressEvent, stop);
    other->Modified();
    other->Update();
    Expect(other->GetOutput()->GetNumberOfPoints() == 0, "an aborted filter's output is empty");
    other->RemoveObserver(stopping);
    other->SetAbortExecute(0);
  }
}

/// Linear fields are met exactly, on a grid by its edges only if not corrected.
void Linear()
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(9, 9, 9);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  values->SetName("Field");
  const double slope[3] = { 1.0, 0.5, 0.25 };
  for (int i = 0; i < 729; ++i)
  {
    const double x[3] = { i % 9 - 4.0, i / 9 % 9 - 4.0, i / 81 - 4.0 };
    points->InsertNextPoint(x);
    values->InsertNextValue(static_cast<float>(vtkMath::Dot(slope, x)));
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(values);
  for (const bool correction : { false, true })
  {
    vtkNew<vtkIsosurfacePoints> filter;
    filter->SetInputData(grid);
    filter->SetValue(0, 0.1);
    filter->SetCorrection(correction);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    Expect(output->GetNumberOfPoints() > 50, "points on a plane");
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double x[3], n[3];
      output->GetPoint(i, x);
      output->GetPointData()->GetNormals()->GetTuple(i, n);
      AtMost(std::abs(vtkMath::Dot(slope, x) - 0.1), 1e-4, "value on a plane");
      AtMost(vtkMath::Norm(slope) * (1 - 1e-4), -vtkMath::Dot(slope, n), "normal of a plane");
      int whole = 0;
      for (const double coordinate : x)
      {
        whole += std::abs(coordinate - std::round(coordinate)) < 1e-5;
      }
      Expect(correction || whole >= 2, "a point off the grid's edges");
    }
  }

  // Blanked samples are as good as none.
  for (int i = 0; i < 729; ++i)
  {
    if (points->GetPoint(i)[2] > 0.5)
    {
      grid->BlankPoint(i);
      values->SetValue(i, 1000);
    }
  }
  vtkNew<vtkIsosurfacePoints> filter;
  filter->SetInputData(grid);
  filter->SetValue(0, 0.1);
  Messages messages(filter);
  filter->Update();
  messages.Expect(0, 1, "324 are hidden", "blanked samples");
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  AtMost(bounds[5], 0.3, "blanked samples");
  Expect(filter->GetOutput()->GetNumberOfPoints() > 20, "points beside blanked samples");
}

/// Two clusters far from each other, with a value each.
void Radius()
{
  vtkNew<vtkPolyData> samples;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  for (int i = 0; i < 250; ++i)
  {
    points->InsertNextPoint(i % 5 + (i < 125 ? 0 : 10), i / 5 % 5, i / 25 % 5);
    values->InsertNextValue(i < 125 ? 0.0f : 1.0f);
  }
  samples->SetPoints(points);
  samples->GetPointData()->SetScalars(values);
  vtkNew<vtkIsosurfacePoints> filter;
  filter->SetInputData(samples);
  filter->SetValue(0, 0.5);
  filter->SetNumberOfNeighbors(128);
  filter->Update();
  Expect(filter->GetOutput()->GetNumberOfPoints() > 0, "points between two clusters");
  filter->SetNeighborRadius(2.5);
  filter->Update();
  Expect(filter->GetOutput()->GetNumberOfPoints() == 0, "no points beyond NeighborRadius");
}

/// A process gives the points next to its own samples.
void Pieces()
{
  vtkSmartPointer<vtkPolyData> samples = Scatter(fields[0], Uniform, 10000);
  vtkNew<vtkPolyData> both;
  vtkNew<vtkPoints> points;
  for (const double side : { -1, 1 })
  {
    vtkNew<vtkPolyData> piece;
    piece->ShallowCopy(samples);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
    {
      ghosts->InsertNextValue(
        piece->GetPoint(i)[0] * side > 0 ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
    }
    piece->GetPointData()->AddArray(ghosts);
    vtkNew<vtkIsosurfacePoints> filter;
    filter->SetInputData(piece);
    filter->SetValue(0, fields[0].Isovalue);
    Messages messages(filter);
    filter->Update();
    messages.Expect(0, 0, "", "duplicated points");
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
    {
      AtMost(-side * filter->GetOutput()->GetPoint(i)[0], 0.15, "a point of the other process");
      points->InsertNextPoint(filter->GetOutput()->GetPoint(i));
    }
  }
  vtkNew<vtkIsosurfacePoints> whole;
  whole->SetInputData(samples);
  whole->SetValue(0, fields[0].Isovalue);
  whole->Update();
  Expect(points->GetNumberOfPoints() == whole->GetOutput()->GetNumberOfPoints(),
    "two processes give as many points as one");
}

}

int TestIsosurfaceScatter(int, char*[])
{
  Outputs();
  Linear();
  Radius();
  Pieces();
  Accuracy(10000, 0.0);
  Accuracy(50000, 0.0);
  Accuracy(50000, 0.03);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
