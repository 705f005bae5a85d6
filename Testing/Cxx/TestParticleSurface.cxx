// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkParticleSurfacePoints against bodies of fluid known in closed form.
#include "ParticleScenes.h"
#include "ScatteredSamples.h"

#include "vtkIntArray.h"
#include "vtkParticleSurfacePoints.h"
#include "vtkPointSplatArrays.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

namespace
{
vtkSmartPointer<vtkPolyData> Extract(vtkDataObject* particles, double spacing = 0)
{
  vtkNew<vtkParticleSurfacePoints> filter;
  Messages messages(filter);
  filter->SetInputData(particles);
  filter->SetPointSpacing(spacing);
  filter->Update();
  messages.Expect(0, 0, "", "clean particles");
  return filter->GetOutput();
}

double Quantile(std::vector<double> values, double q)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 1e300 : values[static_cast<std::size_t>(q * (values.size() - 1))];
}

/// One that is alone is a ball of its cube's volume, whatever the units; its curvature is known.
void Ball(double scale, double offset)
{
  vtkNew<vtkPolyData> one;
  one->SetPoints(vtkNew<vtkPoints>());
  one->GetPoints()->SetDataTypeToDouble();
  one->GetPoints()->InsertNextPoint(offset, -offset, 2 * offset);
  vtkNew<vtkParticleSurfacePoints> filter;
  filter->SetInputData(one);
  filter->SetParticleSpacing(scale);
  filter->SetPointSpacing(0.1 * scale);
  filter->Update();
  vtkPolyData* ball = filter->GetOutput();
  const double radius = std::cbrt(0.75 / vtkMath::Pi()) * scale;
  const std::string name = "a ball of " + std::to_string(scale) + " at " + std::to_string(offset);
  // A point for each s * s.
  const double expected = 4 * vtkMath::Pi() * radius * radius / (0.01 * scale * scale);
  AtMost(std::abs(ball->GetNumberOfPoints() / expected - 1), 0.15, name + ": number of points");
  vtkDataArray* curvatures =
    ball->GetPointData()->GetArray(vtkPointSplatArrays::Curvature);
  double worst = 0, angle = 0, bend = 0;
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    double x[3], n[3], b[6];
    ball->GetPoint(i, x);
    ball->GetPointData()->GetNormals()->GetTuple(i, n);
    curvatures->GetTuple(i, b);
    x[0] -= offset;
    x[1] += offset;
    x[2] -= 2 * offset;
    worst = std::max(worst, std::abs(vtkMath::Norm(x) / radius - 1));
    angle = std::max(angle, 1 - vtkMath::Dot(x, n) / vtkMath::Norm(x));
    for (int k = 0; k < 6; ++k)
    {
      const int r = k < 3 ? k : k == 5 ? 0 : k - 3, c = k < 3 ? k : k == 3 ? 1 : 2;
      bend = std::max(bend, std::abs(b[k] * radius - ((r == c) - n[r] * n[c])));
    }
  }
  AtMost(worst, 1e-3, name + ": radius");
  AtMost(angle, 1e-4, name + ": normals");
  AtMost(bend, 1e-2, name + ": curvature");
}

/// The tank's water, in particle spacings.
void Tank(double jitter)
{
  vtkSmartPointer<vtkPolyData> particles = DamBreak::Make(jitter);
  vtkSmartPointer<vtkPolyData> surface = Extract(particles);
  const std::string name = "tank with jitter " + std::to_string(jitter);
  auto components = GetComponents(surface, 0.75);
  std::sort(components.begin(), components.end(),
    [](const auto& a, const auto& b) { return a.size() > b.size(); });
  // Water, sheet and drops, and nothing inside.
  Expect(components.size() == 2 + DamBreak::Drops,
    name + ": has " + std::to_string(components.size()) + " components");
  if (components.size() != 2 + DamBreak::Drops)
  {
    return;
  }

  // Up to the water's edges, which are rounded.
  std::vector<double> distances, angles;
  for (const vtkIdType id : components[0])
  {
    double x[3], n[3];
    surface->GetPoint(id, x);
    surface->GetPointData()->GetNormals()->GetTuple(id, n);
    Expect(std::min({ x[0], 30 - x[0], x[1], 16 - x[1], x[2], GetWave(x[0]) - x[2] }) < 1,
      name + ": a point inside the water");
    if (x[2] > 4 && x[0] > 3 && x[0] < 27 && x[1] > 3 && x[1] < 13)
    {
      const double slope = 3 * 2 * vtkMath::Pi() / 30 * std::cos(x[0] / 30 * 2 * vtkMath::Pi());
      const double length = std::sqrt(1 + slope * slope);
      distances.push_back((x[2] - GetWave(x[0])) / length);
      angles.push_back(vtkMath::DegreesFromRadians(
        std::acos(std::clamp((n[2] - slope * n[0]) / length, -1.0, 1.0))));
    }
  }
  std::vector<double> sizes;
  for (double distance : distances)
  {
    sizes.push_back(std::abs(distance));
  }
  std::printf("%s: %d points, offset %.3f, distances %.3f %.3f, normals %.1f %.1f\n", name.c_str(),
    static_cast<int>(surface->GetNumberOfPoints()), Quantile(distances, 0.5), Quantile(sizes, 0.5),
    Quantile(sizes, 0.95), Quantile(angles, 0.5), Quantile(angles, 0.95));
  // A slope of lattice layers is known to half a spacing at best.
  AtMost(std::abs(Quantile(distances, 0.5)), 0.2, name + ": offset of the wave");
  AtMost(Quantile(sizes, 0.95), 0.5, name + ": distance from the wave");
  AtMost(Quantile(angles, 0.5), 10, name + ": median angle of normals");

  // The sheet is closed: from any place in it, above and below, a point is near.
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  std::vector<double> heights[2];
  for (double x = 1.5; x < DamBreak::SheetSize - 1.5; x += 0.11)
  {
    for (double y = 1.5; y < DamBreak::SheetSize - 1.5; y += 0.11)
    {
      for (int side = 0; side < 2; ++side)
      {
        const double p[3] = { x, y, DamBreak::SheetHeight + (side ? 0.5 : -0.5) };
        double q[3];
        surface->GetPoint(locator->FindClosestPoint(p), q);
        AtMost(std::hypot(p[0] - q[0], p[1] - q[1]), 0.45, name + ": a hole in the sheet");
        heights[side].push_back(q[2] - DamBreak::SheetHeight);
      }
    }
  }
  const double thickness = Quantile(heights[1], 0.5) - Quantile(heights[0], 0.5);
  AtMost(std::abs(thickness - 1), 0.3, name + ": thickness of the sheet");

  // Three drops of one particle, and one of two.
  for (std::size_t c = 2; c < components.size(); ++c)
  {
    const double share = 4 * vtkMath::Pi() / std::cbrt(16 * vtkMath::Pi() * vtkMath::Pi() / 9) /
      components.back().size();
    const double volume = GetVolume(surface, components[c], share);
    const double expected = c == 2 ? 2 : 1;
    AtMost(std::abs(volume / expected - 1), c == 2 ? 0.35 : 0.2,
      name + ": volume of drop " + std::to_string(c));
  }
}

/// Curved, and in double precision far away.
void Body()
{
  for (const double offset : { 0.0, 1e6 })
  {
    Particles particles(0.2);
    auto ball = [](const double p[3]) {
      return std::hypot(p[0] - 12, p[1] - 12, p[2] - 12) - 10.0;
    };
    particles.Fill({ { 24, 24, 24 } }, ball);
    for (vtkIdType i = 0; i < particles.Points->GetNumberOfPoints(); ++i)
    {
      double x[3];
      particles.Points->GetPoint(i, x);
      // A millimetre, where coordinates are metres.
      particles.Points->SetPoint(
        i, offset + 1e-3 * x[0], offset + 1e-3 * x[1], 1e-3 * x[2] - offset);
    }
    vtkSmartPointer<vtkPolyData> surface = Extract(particles.Get());
    Expect(surface->GetPoints()->GetDataType() == (offset > 0 ? VTK_DOUBLE : VTK_FLOAT),
      "type of points");
    std::vector<double> radii, angles;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double x[3], n[3];
      surface->GetPoint(i, x);
      surface->GetPointData()->GetNormals()->GetTuple(i, n);
      const double p[3] = { 1e3 * (x[0] - offset) - 12, 1e3 * (x[1] - offset) - 12,
        1e3 * (x[2] + offset) - 12 };
      radii.push_back(vtkMath::Norm(p));
      angles.push_back(vtkMath::DegreesFromRadians(
        std::acos(std::clamp(vtkMath::Dot(p, n) / vtkMath::Norm(p), -1.0, 1.0))));
    }
    std::printf("ball at %g: radius %.2f to %.2f, normals %.1f %.1f\n", offset,
      Quantile(radii, 0.0), Quantile(radii, 1.0), Quantile(angles, 0.5), Quantile(angles, 0.95));
    AtMost(std::abs(Quantile(radii, 0.5) - 10), 0.2, "radius of a body");
    AtMost(10 - Quantile(radii, 0.0), 1, "depth in a body");
    AtMost(Quantile(radii, 1.0) - 10, 1, "height over a body");
    AtMost(Quantile(angles, 0.5), 10, "median angle of a body's normals");
  }
}

void Outputs()
{
  vtkSmartPointer<vtkPolyData> particles = DamBreak::Make(0.2);
  const vtkIdType number = particles->GetNumberOfPoints();
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> ids;
  ids->SetName("id");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < number; ++i)
  {
    const double* x = particles->GetPoint(i);
    velocity->InsertNextTuple3(2 * x[0], x[1] + x[2], 7);
    ids->InsertNextValue(static_cast<int>(i));
    ghosts->InsertNextValue(x[0] > 15 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  particles->GetPointData()->AddArray(velocity);
  particles->GetPointData()->AddArray(ids);

  vtkNew<vtkParticleSurfacePoints> filter;
  filter->SetInputData(particles);
  ExpectSameByAllBackends(filter);
  vtkPolyData* output = filter->GetOutput();
  vtkPointData* data = output->GetPointData();
  auto* radii = vtkFloatArray::SafeDownCast(data->GetArray(vtkPointSplatArrays::Radius));
  auto* curvatures = vtkFloatArray::SafeDownCast(data->GetArray(vtkPointSplatArrays::Curvature));
  Expect(output->GetNumberOfCells() == 0 && vtkFloatArray::SafeDownCast(data->GetNormals()) &&
      radii && curvatures && curvatures->GetNumberOfComponents() == 6 && !data->GetScalars() &&
      vtkIntArray::SafeDownCast(data->GetArray("id")),
    "arrays of the output");
  AtMost(std::abs(filter->GetMeasuredSpacing() - 1), 0.05, "measured spacing");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3], v[3], p[3];
    output->GetPoint(i, x);
    data->GetArray("velocity")->GetTuple(i, v);
    AtMost(std::hypot(v[0] - 2 * x[0], v[1] - x[1] - x[2], 10 * (v[2] - 7)), 3, "velocity");
    const vtkIdType id = static_cast<vtkIdType>(data->GetArray("id")->GetComponent(i, 0));
    particles->GetPoint(id, p);
    AtMost(std::sqrt(vtkMath::Distance2BetweenPoints(x, p)), 2, "distance to the particle");
    AtMost(radii->GetValue(i), 0.33, "radius");
  }

  // Two processes' points are those of one.
  const double ofOne = static_cast<double>(output->GetNumberOfPoints());
  particles->GetPointData()->AddArray(ghosts);
  vtkIdType total = 0;
  for (int process = 0; process < 2; ++process)
  {
    filter->Modified();
    filter->Update();
    vtkPolyData* half = filter->GetOutput();
    total += half->GetNumberOfPoints();
    for (vtkIdType i = 0; i < half->GetNumberOfPoints(); ++i)
    {
      const double x = half->GetPoint(i)[0];
      AtMost(process ? 15 - x : x - 15, 1.5, "another process' point");
    }
    for (vtkIdType i = 0; i < number; ++i)
    {
      ghosts->SetValue(i, vtkDataSetAttributes::DUPLICATEPOINT - ghosts->GetValue(i));
    }
    ghosts->Modified();
  }
  AtMost(std::abs(total / ofOne - 1), 0.02, "points of both processes");
  particles->GetPointData()->RemoveArray(ghosts->GetName());

  // The wanted spacing, coarser and finer.
  const double number04 = Extract(particles, 0.4)->GetNumberOfPoints();
  for (const double spacing : { 0.2, 0.8 })
  {
    const double ratio = Extract(particles, spacing)->GetNumberOfPoints() / number04;
    AtMost(std::abs(ratio * spacing * spacing / 0.16 - 1), 0.15, "number of points");
  }
  // Where it bends strongly there are more, if nobody asked for a spacing.
  AtMost(1.1, ofOne / number04, "denser points at edges");

  // Stops when it is told to.
  vtkNew<vtkCallbackCommand> stop;
  int calls = 0;
  stop->SetClientData(&calls);
  stop->SetCallback([](vtkObject* caller, unsigned long, void* count, void*) {
    auto* self = static_cast<vtkAlgorithm*>(caller);
    ++*static_cast<int*>(count);
    self->SetAbortExecute(self->GetProgress() > 0.3);
  });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Modified();
  filter->Update();
  Expect(calls > 3, "progress is reported");
  Expect(filter->GetOutput()->GetNumberOfPoints() == 0, "an aborted filter's output is empty");
}
}

int TestParticleSurface(int, char*[])
{
  Ball(1, 0);
  Ball(1e-3, 10);
  Ball(50, 1e6);
  Tank(0);
  Tank(0.2);
  Body();
  Outputs();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
