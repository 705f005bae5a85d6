// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes and curvature of vtkIsosurfacePoints against closed forms, and whether its disks cover the
// isosurface.
#include "Expect.h"
#include "Isosurfaces.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIsosurfacePoints.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <string>

namespace
{
/// The tensor at a place with a normal.
using Bends = std::function<void(const double x[3], const double n[3], double tensor[3][3])>;

/// Next to the volume's border, where gradients are one-sided differences, nothing is expected.
bool IsInner(vtkImageData* volume, const double x[3])
{
  if (!volume)
  {
    return true;
  }
  double index[3];
  volume->TransformPhysicalPointToContinuousIndex(x, index);
  bool inner = true;
  for (int c = 0; c < 3; ++c)
  {
    inner = inner && index[c] > 1 && index[c] < volume->GetDimensions()[c] - 2;
  }
  return inner;
}

void CheckCurvature(vtkImageData* volume, vtkPolyData* points, const Bends& truth,
  double tolerance, const std::string& name)
{
  vtkDataArray* normals = points->GetPointData()->GetNormals();
  vtkDataArray* curvatures = points->GetPointData()->GetArray(vtkPointSplatArrays::Curvature);
  Expect(points->GetNumberOfPoints() > 100 && curvatures != nullptr, name + ": points and array");
  if (!curvatures)
  {
    return;
  }
  double worst = 0, along = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3], n[3], b[6], expected[3][3];
    points->GetPoint(i, x);
    if (!IsInner(volume, x))
    {
      continue;
    }
    normals->GetTuple(i, n);
    curvatures->GetTuple(i, b);
    truth(x, n, expected);
    const double found[3][3] = { { b[0], b[3], b[5] }, { b[3], b[1], b[4] }, { b[5], b[4], b[2] } };
    for (int r = 0; r < 3; ++r)
    {
      along = std::max(along, std::abs(vtkMath::Dot(found[r], n)));
      for (int c = 0; c < 3; ++c)
      {
        const double error = std::abs(found[r][c] - expected[r][c]);
        worst = std::isfinite(error) ? std::max(worst, error) : error;
      }
    }
  }
  AtMost(worst, tolerance, name + ": curvature");
  AtMost(along, 1e-4, name + ": curvature along the normal");
}

/// P H P / |g| by the normal's side.
void ByDerivatives(const double g[3], const double h[3][3], const double n[3], double tensor[3][3])
{
  const double slope = vtkMath::Dot(g, n);
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      tensor[r][c] = 0;
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          tensor[r][c] +=
            ((r == i) - n[r] * n[i]) * h[i][j] * ((j == c) - n[j] * n[c]) / slope;
        }
      }
    }
  }
}

void Curvatures(const std::array<double, 3>& spacing, bool turned, bool mirrored)
{
  const std::string name = "spacing " + std::to_string(spacing[0]) + " " +
    std::to_string(spacing[1]) + " " + std::to_string(spacing[2]) +
    (turned ? ", turned" : "") + (mirrored ? ", mirrored" : "");
  const double coarsest = *std::max_element(spacing.begin(), spacing.end());
  for (const double pointSpacing : { 0.0, 0.1 })
  {
    const std::string how = name + (pointSpacing > 0 ? ", spaced, " : ", ");
    // Of second degree, of which differences are exact.
    vtkSmartPointer<vtkImageData> sphere = Volume(
      [](const double x[3]) { return vtkMath::Dot(x, x); }, spacing, turned, mirrored);
    CheckCurvature(sphere, Extract(sphere, 0.64, pointSpacing, false),
      [](const double x[3], const double n[3], double tensor[3][3]) {
        const double g[3] = { 2 * x[0], 2 * x[1], 2 * x[2] };
        const double h[3][3] = { { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
        ByDerivatives(g, h, n, tensor);
      },
      1e-5, how + "sphere");
    vtkSmartPointer<vtkImageData> cylinder = Volume(
      [](const double x[3]) { return -x[0] * x[0] - x[1] * x[1]; }, spacing, turned, mirrored);
    CheckCurvature(cylinder, Extract(cylinder, -0.36, pointSpacing, false),
      [](const double x[3], const double n[3], double tensor[3][3]) {
        const double g[3] = { -2 * x[0], -2 * x[1], 0 };
        const double h[3][3] = { { -2, 0, 0 }, { 0, -2, 0 }, { 0, 0, 0 } };
        ByDerivatives(g, h, n, tensor);
      },
      1e-5, how + "cylinder");
    // Differences of second order have an error with the square of the spacing.
    vtkSmartPointer<vtkImageData> torus = Volume(
      [](const double x[3]) {
        return std::hypot(std::hypot(x[0], x[1]) - 0.6, x[2]);
      },
      spacing, turned, mirrored);
    CheckCurvature(torus, Extract(torus, 0.35, pointSpacing, false),
      [](const double x[3], const double n[3], double tensor[3][3]) {
        // Around the tube, and along it.
        const double ring = std::hypot(x[0], x[1]), q = ring - 0.6;
        const double tube = std::hypot(q, x[2]);
        const double t[3] = { -x[1] / ring, x[0] / ring, 0 };
        const double u[3] = { -x[2] / tube * x[0] / ring, -x[2] / tube * x[1] / ring, q / tube };
        const double outward[3] = { x[0] / ring * q, x[1] / ring * q, x[2] };
        const double side = vtkMath::Dot(n, outward) > 0 ? 1 : -1;
        for (int r = 0; r < 3; ++r)
        {
          for (int c = 0; c < 3; ++c)
          {
            tensor[r][c] = side * (u[r] * u[c] / tube + t[r] * t[c] * q / tube / ring);
          }
        }
      },
      70 * coarsest * coarsest, how + "torus");
    const double w = 3;
    vtkSmartPointer<vtkImageData> gyroid = Volume(
      [w](const double x[3]) {
        return std::sin(w * x[0]) * std::cos(w * x[1]) + std::sin(w * x[1]) * std::cos(w * x[2]) +
          std::sin(w * x[2]) * std::cos(w * x[0]);
      },
      spacing, turned, mirrored);
    CheckCurvature(gyroid, Extract(gyroid, 0.3, pointSpacing, false),
      [w](const double x[3], const double n[3], double tensor[3][3]) {
        double s[3], k[3], g[3], h[3][3];
        for (int c = 0; c < 3; ++c)
        {
          s[c] = std::sin(w * x[c]);
          k[c] = std::cos(w * x[c]);
        }
        for (int c = 0; c < 3; ++c)
        {
          const int next = (c + 1) % 3, last = (c + 2) % 3;
          g[c] = w * (k[c] * k[next] - s[last] * s[c]);
          h[c][c] = -w * w * (s[c] * k[next] + s[last] * k[c]);
          h[c][next] = h[next][c] = -w * w * k[c] * s[next];
        }
        ByDerivatives(g, h, n, tensor);
      },
      20 * coarsest * coarsest, how + "gyroid");
  }
}

/// Radii on a plane through the middles of a grid's edges are 0.87 of half the diagonal of its
/// rectangles: disks are drawn to 1.15 radii.
void PlaneRadii()
{
  vtkSmartPointer<vtkImageData> plane =
    Volume([](const double x[3]) { return x[2]; }, { 0.2, 0.1, 0.05 }, false, false);
  vtkSmartPointer<vtkPolyData> points = Extract(plane, 0.013, 0);
  vtkDataArray* radii = points->GetPointData()->GetArray(vtkPointSplatArrays::Radius);
  vtkDataArray* curvatures = points->GetPointData()->GetArray(vtkPointSplatArrays::Curvature);
  double range[2];
  radii->GetRange(range);
  const double radius = 0.87 * 0.5 * std::hypot(0.2, 0.1);
  AtMost(std::abs(range[0] - radius), 1e-6, "plane: least radius");
  AtMost(std::abs(range[1] - radius), 1e-6, "plane: largest radius");
  AtMost(curvatures->GetMaxNorm(), 1e-5, "plane: curvature");
  points = Extract(plane, 0.013, 0.1);
  points->GetPointData()->GetArray(vtkPointSplatArrays::Radius)->GetRange(range);
  AtMost(std::abs(range[0] - 0.088), 1e-6, "plane, spaced: least radius");
  AtMost(std::abs(range[1] - 0.088), 1e-6, "plane, spaced: largest radius");
}

/// Every place on vtkFlyingEdges3D's triangles lies on what is drawn of a disk, which reaches 1.15 radii, or of
/// what is spaced next to a disk; where disks bend, and are a quarter smaller for it, within the kernel,
/// which reaches 1.5 radii.
void Covered(vtkImageData* image, double isovalue, double pointSpacing, const std::string& name,
  bool bends = false)
{
  vtkNew<vtkFlyingEdges3D> mesh;
  mesh->SetInputData(image);
  mesh->SetValue(0, isovalue);
  mesh->Update();
  vtkSmartPointer<vtkPolyData> points = Extract(image, isovalue, pointSpacing);
  vtkDataArray* radii = points->GetPointData()->GetArray(vtkPointSplatArrays::Radius);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(points);
  locator->BuildLocator();
  double largest[2];
  radii->GetRange(largest);
  const double* h = image->GetSpacing();
  const double diagonal = std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
  if (pointSpacing == 0)
  {
    AtMost(largest[1], diagonal, name + ": the largest radius");
  }
  double worst = 0;
  vtkNew<vtkIdList> corners, near;
  for (vtkIdType t = 0; t < mesh->GetOutput()->GetNumberOfCells(); ++t)
  {
    mesh->GetOutput()->GetCellPoints(t, corners);
    double x[3][3];
    for (int c = 0; c < 3; ++c)
    {
      mesh->GetOutput()->GetPoint(corners->GetId(c), x[c]);
    }
    for (int a = 0; a <= 4; ++a)
    {
      for (int b = 0; a + b <= 4; ++b)
      {
        double at[3];
        for (int c = 0; c < 3; ++c)
        {
          at[c] = 0.25 * (a * x[0][c] + b * x[1][c] + (4 - a - b) * x[2][c]);
        }
        locator->FindPointsWithinRadius(1.5 * largest[1], at, near);
        double least = VTK_DOUBLE_MAX;
        for (vtkIdType i = 0; i < near->GetNumberOfIds(); ++i)
        {
          const double* p = points->GetPoint(near->GetId(i));
          least = std::min(least,
            std::sqrt(vtkMath::Distance2BetweenPoints(p, at)) /
              radii->GetComponent(near->GetId(i), 0));
        }
        worst = std::max(worst, least);
      }
    }
  }
  AtMost(worst, bends ? 1.1 / 0.75 : pointSpacing > 0 ? 1.1 : 1.15, name + ": the farthest place from a disk's centre, in radii");
}

void Coverage()
{
  const std::array<double, 3> even = { 0.1, 0.1, 0.1 }, uneven = { 0.05, 0.1, 0.2 };
  const Field slanted = [](const double x[3]) { return x[0] + x[1] + x[2]; };
  const Field gyroid = [](const double x[3]) {
    return std::sin(4 * x[0]) * std::cos(4 * x[1]) + std::sin(4 * x[1]) * std::cos(4 * x[2]) +
      std::sin(4 * x[2]) * std::cos(4 * x[0]);
  };
  // A tube 0.7 samples in radius, as a scanner would have it, and a speck.
  const Field vessel = [](const double x[3]) {
    const double tube = std::hypot(x[0] - 0.4 * std::sin(2 * x[2]), x[1]);
    const double centre[3] = { -0.6, 0.6, 0.1 };
    const double speck = std::sqrt(vtkMath::Distance2BetweenPoints(x, centre));
    return std::clamp(0.5 - (std::min(tube, speck) - 0.07) / 0.2, 0.0, 1.0);
  };
  for (const double s : { 0.0, 0.08 })
  {
    const std::string spaced = s > 0 ? ", spaced" : "";
    // Hexagons, which a face's points alone do not tell from smaller outlines.
    Covered(Volume(slanted, even, false, false), 0.0431, s, "slanted plane" + spaced);
    Covered(Volume(gyroid, even, false, false), 0.2, s, "gyroid" + spaced);
    Covered(Volume(vessel, even, false, false), 0.45, s, "vessel" + spaced, true);
    if (s == 0)
    {
      // Samples that lie on the surface, where several edges have the same point.
      Covered(Volume(slanted, even, false, false), 0.0, s, "plane through samples");
      Covered(Volume(gyroid, uneven, true, false), 0.2, s, "gyroid, uneven");
    }
  }
}

/// Of a ball that the volume cuts: what lines leave of disks is what lies in the volume. open: the face at which
/// the volume goes on, or -1.
void ExpectClipped(vtkImageData* image, vtkPolyData* points, int open, const std::string& name)
{
  vtkPointData* arrays = points->GetPointData();
  auto* radii = vtkFloatArray::SafeDownCast(arrays->GetArray(vtkPointSplatArrays::Radius));
  auto* clips = vtkFloatArray::SafeDownCast(arrays->GetArray(vtkPointSplatArrays::Clip));
  Expect(clips != nullptr, name + ": there are clip lines");
  if (!clips)
  {
    return;
  }
  int wrong = 0, cut = 0;
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    double x[3], n[3], axes[2][3];
    points->GetPoint(id, x);
    arrays->GetNormals()->GetTuple(id, n);
    vtkMath::Perpendiculars(n, axes[0], axes[1], 0);
    const float* clip = clips->GetPointer(6 * id);
    for (int k = 0; k < 32; ++k)
    {
      const double angle = k * vtkMath::Pi() / 16, reach = 1.5 * radii->GetValue(id);
      double w[3], at[3], index[3];
      for (int c = 0; c < 3; ++c)
      {
        w[c] = reach * (std::cos(angle) * axes[0][c] + std::sin(angle) * axes[1][c]);
        at[c] = x[c] + w[c];
      }
      image->TransformPhysicalPointToContinuousIndex(at, index);
      double inside = 1; // voxels from the nearest face
      for (int face = 0; face < 6; ++face)
      {
        const double last = image->GetDimensions()[face / 2] - 1;
        const double distance = face % 2 ? last - index[face / 2] : index[face / 2];
        inside = face == open ? inside : std::min(inside, distance);
      }
      const bool kept = clip[0] * w[0] + clip[1] * w[1] + clip[2] * w[2] <= 1 &&
        clip[3] * w[0] + clip[4] * w[1] + clip[5] * w[2] <= 1;
      // Lines do not go through the points themselves.
      wrong += std::abs(inside) > 0.03 && kept != (inside > 0);
      cut += !kept;
    }
  }
  Expect(wrong == 0, name + ": splats end at the volume's faces, " + std::to_string(wrong));
  Expect(cut > 1000, name + ": splats are cut");
}

void Borders()
{
  const auto field = [](const double x[3]) { return vtkMath::Dot(x, x); };
  for (const bool turned : { false, true })
  {
    const auto image = Volume(field, { 0.05, 0.04, 0.06 }, turned, turned);
    ExpectClipped(image, Extract(image, 1.96, 0), -1, turned ? "turned" : "upright");
    ExpectClipped(image, Extract(image, 1.96, 0.08), -1, "points further apart");
    // A piece of a larger volume.
    vtkNew<vtkTrivialProducer> piece;
    piece->SetOutput(image);
    int whole[6];
    image->GetExtent(whole);
    whole[1] += 10;
    piece->SetWholeExtent(whole);
    vtkNew<vtkIsosurfacePoints> points;
    points->SetInputConnection(piece->GetOutputPort());
    points->SetValue(0, 1.96);
    points->UpdateInformation();
    points->GetInputInformation()->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), image->GetExtent(), 6);
    points->Update();
    ExpectClipped(image, points->GetOutput(), 1, "a piece");
  }
  const auto closed = Volume(field, { 0.05, 0.05, 0.05 }, false, false);
  Expect(!Extract(closed, 0.64, 0)->GetPointData()->HasArray(vtkPointSplatArrays::Clip),
    "what the volume does not cut has no lines");
}

void ExpectUsable(vtkPolyData* points, const std::string& name)
{
  vtkDataArray* radii = points->GetPointData()->GetArray(vtkPointSplatArrays::Radius);
  vtkDataArray* curvatures = points->GetPointData()->GetArray(vtkPointSplatArrays::Curvature);
  bool good = radii && curvatures &&
    radii->GetNumberOfTuples() == points->GetNumberOfPoints() &&
    curvatures->GetNumberOfTuples() == points->GetNumberOfPoints();
  for (vtkIdType i = 0; good && i < points->GetNumberOfPoints(); ++i)
  {
    good = radii->GetComponent(i, 0) > 0 && std::isfinite(radii->GetComponent(i, 0));
    for (int c = 0; c < 6; ++c)
    {
      good = good && std::isfinite(curvatures->GetComponent(i, c));
    }
  }
  Expect(good, name + ": radii and curvatures");
}

void BadInput()
{
  const Field ball = [](const double x[3]) { return vtkMath::Dot(x, x); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkSmartPointer<vtkImageData> image = Volume(ball, { 0.1, 0.1, 0.1 }, false, false);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i += 7)
  {
    values->SetTuple1(i, i % 2 ? nan : std::numeric_limits<double>::infinity());
  }
  for (const double s : { 0.0, 0.1 })
  {
    vtkSmartPointer<vtkPolyData> points = Extract(image, 0.64, s);
    Expect(points->GetNumberOfPoints() > 0 || s > 0, "some points beside samples not finite");
    ExpectUsable(points, "samples not finite");
  }
  const std::array<double, 3> wide = { 0.1, 0.1, 0.1 };
  for (const double s : { 0.0, 0.1, 1e30, 1e300 })
  {
    const std::string name = ", point spacing " + std::to_string(s);
    vtkSmartPointer<vtkPolyData> none =
      Extract(Volume([](const double*) { return 0.64; }, wide, false, false), 0.64, s);
    Expect(none->GetNumberOfPoints() == 0, "a constant field has no isosurface" + name);
    ExpectUsable(none, "constant" + name);
    ExpectUsable(Extract(Volume(ball, wide, false, false), 0.64, s), "ball" + name);
    ExpectUsable(
      Extract(Volume([&ball](const double* x) { return 1e300 * ball(x); }, wide, false, false),
        0.64e300, s), "huge values" + name);
    ExpectUsable(
      Extract(Volume([&ball](const double* x) { return 1e-300 * ball(x); }, wide, false, false),
        0.64e-300, s), "tiny values" + name);
    ExpectUsable(Extract(Volume([&ball](const double* x) { return ball(x) < 0.64; }, wide, false,
                   false), 0.5, s), "steps" + name);
    for (const double size : { 1e-15, 1.0, 1e15 })
    {
      vtkNew<vtkImageData> voxel;
      voxel->SetDimensions(2, 2, 2);
      voxel->SetSpacing(size, size, size);
      voxel->AllocateScalars(VTK_FLOAT, 1);
      voxel->GetPointData()->GetScalars()->Fill(0);
      voxel->GetPointData()->GetScalars()->SetTuple1(3, 1);
      vtkSmartPointer<vtkPolyData> corner = Extract(voxel, 0.5, s > 0 ? s * size : 0);
      Expect(corner->GetNumberOfPoints() > 0, "one voxel's points" + name);
      ExpectUsable(corner, "one voxel" + name);
    }
  }
  // Switched off, and of points between pairs only, whose gaps are not known.
  vtkNew<vtkIsosurfacePoints> off;
  off->SetInputData(Volume(ball, wide, false, false));
  off->SetValue(0, 0.64);
  Expect(off->GetSplatSizes(), "sizes are on by default");
  off->SplatSizesOff();
  off->Update();
  Expect(!off->GetOutput()->GetPointData()->HasArray(vtkPointSplatArrays::Radius) &&
      !off->GetOutput()->GetPointData()->HasArray(vtkPointSplatArrays::Curvature) &&
      off->GetOutput()->GetNumberOfPoints() > 0,
    "no sizes if switched off");
}

/// The same field at scattered places: curvature of a ball.
void Scattered()
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  vtkIdType state = 1;
  auto random = [&state]() {
    state = state * 16807 % 2147483647;
    return 2.2 * static_cast<double>(state) / 2147483647 - 1.1;
  };
  for (int i = 0; i < 20000; ++i)
  {
    const double x[3] = { random(), random(), random() };
    places->InsertNextPoint(x);
    values->InsertNextValue(vtkMath::Dot(x, x));
  }
  vtkNew<vtkPolyData> samples;
  samples->SetPoints(places);
  samples->GetPointData()->SetScalars(values);
  vtkNew<vtkIsosurfacePoints> points;
  points->SetInputData(samples);
  points->SetValue(0, 0.64);
  points->Update();
  CheckCurvature(nullptr, points->GetOutput(),
    [](const double*, const double n[3], double tensor[3][3]) {
      for (int r = 0; r < 3; ++r)
      {
        for (int c = 0; c < 3; ++c)
        {
          // Normals against the gradient point inward.
          tensor[r][c] = -((r == c) - n[r] * n[c]) / 0.8;
        }
      }
    },
    0.05, "scattered ball");
  ExpectUsable(points->GetOutput(), "scattered ball");
  points->CorrectionOff();
  points->Update();
  Expect(!points->GetOutput()->GetPointData()->HasArray(vtkPointSplatArrays::Radius),
    "points on pairs of samples have no sizes");
}
}

int TestIsosurfaceSizes(int, char*[])
{
  Curvatures({ 0.05, 0.05, 0.05 }, false, false);
  Curvatures({ 0.05, 0.03, 0.06 }, true, false);
  Curvatures({ 0.06, 0.03, 0.05 }, true, true);
  PlaneRadii();
  Coverage();
  Borders();
  BadInput();
  Scattered();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
