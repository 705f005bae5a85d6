// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkIsosurfacePoints' fill points: where there are some, where they lie, and how they bend.
#include "Expect.h"
#include "Isosurfaces.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkIsosurfacePoints.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

namespace
{
double Box(const double x[3])
{
  return std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
}

/// The voxels about a cube's edges have fill points, and no others.
void Edges(bool turned)
{
  const std::string name = turned ? "turned cube" : "cube";
  const auto image = Volume(Box, { 0.1, 0.1, 0.1 }, turned, turned);
  const auto plain = Extract(image, 0.63, 0, false);
  const auto filled = Extract(image, 0.63, 0, true);
  const vtkIdType first = plain->GetNumberOfPoints();
  Expect(filled->GetNumberOfPoints() > first + 100, name + ": edges have fill points");
  int elsewhere = 0, moved = 0, contrary = 0;
  double farthest = 0;
  for (vtkIdType i = 0; i < filled->GetNumberOfPoints(); ++i)
  {
    double x[3], n[3];
    filled->GetPoint(i, x);
    filled->GetPointData()->GetNormals()->GetTuple(i, n);
    if (i < first)
    {
      moved += vtkMath::Distance2BetweenPoints(x, plain->GetPoint(i)) > 0;
      continue;
    }
    // Gradients are central differences, two voxels wide.
    const auto near = std::count_if(
      x, x + 3, [](double c) { return std::abs(c) > 0.63 - 0.25; });
    elsewhere += near < 2;
    // vtkFlyingEdges3D's normals are against the gradient, but those of a mirrored volume.
    contrary += (vtkMath::Dot(x, n) > 0) != turned;
    farthest = std::max(farthest, std::abs(Box(x) - 0.63));
  }
  Expect(moved == 0, name + ": fill points come after all others");
  Expect(elsewhere == 0, name + ": faces have no fill points");
  Expect(contrary == 0, name + ": fill points look to the side that points look to");
  AtMost(farthest, 0.06, name + ": how far fill points are off");
}

/// On a torus in voxels of a seventh of its radius fill points are bent as it is.
void Bends(bool turned)
{
  const std::string name = turned ? "turned torus" : "torus";
  const Field field = [](const double x[3]) {
    return std::hypot(std::hypot(x[0], x[1]) - 0.6, x[2]);
  };
  const auto torus = Volume(field, { 0.05, 0.05, 0.05 }, turned, turned);
  const vtkIdType first = Extract(torus, 0.35, 0, false)->GetNumberOfPoints();
  const auto points = Extract(torus, 0.35, 0, true);
  Expect(points->GetNumberOfPoints() > first, name + ": there are fill points");
  double angle = 0, along = 0, across = 0;
  for (vtkIdType i = first; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3], n[3], b[6];
    points->GetPoint(i, x);
    points->GetPointData()->GetNormals()->GetTuple(i, n);
    points->GetPointData()->GetArray(vtkPointSplatArrays::Curvature)->GetTuple(i, b);
    const double ring = std::hypot(x[0], x[1]), q = ring - 0.6, tube = std::hypot(q, x[2]);
    const double outward[3] = { x[0] / ring * q / tube, x[1] / ring * q / tube, x[2] / tube };
    const double side = vtkMath::Dot(n, outward) > 0 ? 1 : -1;
    const double t[3] = { -x[1] / ring, x[0] / ring, 0 };
    double u[3];
    vtkMath::Cross(n, t, u);
    const auto bend = [&b](const double d[3]) {
      return b[0] * d[0] * d[0] + b[1] * d[1] * d[1] + b[2] * d[2] * d[2] +
        2 * (b[3] * d[0] * d[1] + b[4] * d[1] * d[2] + b[5] * d[0] * d[2]);
    };
    angle = std::max(angle, std::acos(std::min(side * vtkMath::Dot(n, outward), 1.0)));
    along = std::max(along, std::abs(bend(t) - side * q / tube / ring));
    across = std::max(across, std::abs(bend(u) - side / tube));
  }
  AtMost(angle, 0.05, name + ": angle of normals");
  AtMost(along, 0.5, name + ": curvature along the ring, of 4");
  AtMost(across, 0.5, name + ": curvature around the tube, of 2.9");
}

/// No fill points where points have a spacing, or no sizes, nor in cells that are not this process'.
void Without()
{
  const auto image = Volume(Box, { 0.1, 0.1, 0.1 }, false, false);
  const vtkIdType first = Extract(image, 0.63, 0, false)->GetNumberOfPoints();
  const vtkIdType all = Extract(image, 0.63, 0, true)->GetNumberOfPoints();
  Expect(Extract(image, 0.63, 0.08, true)->GetNumberOfPoints() ==
      Extract(image, 0.63, 0.08, false)->GetNumberOfPoints(),
    "spaced points have no fill points");
  vtkNew<vtkIsosurfacePoints> bare;
  bare->SetInputData(image);
  bare->SetValue(0, 0.63);
  Expect(bare->GetFillGaps(), "fill points are made by default");
  bare->SplatSizesOff();
  bare->Update();
  Expect(bare->GetOutput()->GetNumberOfPoints() == first, "nor have points without sizes");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(image->GetNumberOfCells());
  ghosts->FillValue(0);
  std::fill_n(ghosts->GetPointer(0), image->GetNumberOfCells() / 2,
    static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATECELL));
  image->GetCellData()->AddArray(ghosts);
  const vtkIdType own = Extract(image, 0.63, 0, true)->GetNumberOfPoints() -
    Extract(image, 0.63, 0, false)->GetNumberOfPoints();
  Expect(2 * own == all - first,
    "half of the cells have " + std::to_string(own) + " fill points of " +
      std::to_string(all - first));
}

/// Two isovalues are as each for itself, whether in blocks or not.
void Several()
{
  const auto image = Volume(Box, { 0.1, 0.1, 0.1 }, true, true);
  vtkNew<vtkIsosurfacePoints> points;
  points->SetInputData(image);
  points->SetValue(0, 0.63);
  points->SetValue(1, 0.41);
  points->Update();
  const auto outer = Extract(image, 0.63, 0, true);
  const auto inner = Extract(image, 0.41, 0, true);
  const vtkIdType first = outer->GetNumberOfPoints();
  Expect(points->GetOutput()->GetNumberOfPoints() == first + inner->GetNumberOfPoints(),
    "two isovalues: number of points");
  int different = 0;
  vtkDataArray* isovalues = points->GetOutput()->GetPointData()->GetArray("Isovalue");
  for (vtkIdType i = 0; i < points->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double x[3], other[3];
    points->GetOutput()->GetPoint(i, x);
    i < first ? outer->GetPoint(i, other) : inner->GetPoint(i - first, other);
    different += vtkMath::Distance2BetweenPoints(x, other) > 0 ||
      isovalues->GetComponent(i, 0) != (i < first ? 0.63 : 0.41);
  }
  Expect(different == 0, "two isovalues: points of each, one after the other");
}
}

int TestIsosurfaceFill(int, char*[])
{
  for (const bool turned : { false, true })
  {
    Edges(turned);
    Bends(turned);
  }
  Without();
  Several();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
