// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Batches of points that are out of view are not projected, and no picture tells: close-ups of
// ordered points against the same points in orders in which each batch has some that show.
#include "SplatScene.h"

#include "vtkHardwareSelector.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using namespace SplatScene;

constexpr int Rows = 300;
constexpr int Columns = 400;
constexpr vtkIdType Points = vtkIdType(Rows) * Columns;

/**
 * A torus about the middle, patch after patch: points that follow each other are neighbours.
 */
vtkSmartPointer<vtkPolyData> Torus(const double middle[3])
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> ids;
  ids->SetName("Place");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(0.0, 1.0);
  constexpr int Patch = 10;
  for (int patch = 0; patch < Rows * Columns / (Patch * Patch); ++patch)
  {
    for (int k = 0; k < Patch * Patch; ++k)
    {
      const int row = patch / (Columns / Patch) * Patch + k / Patch;
      const int column = patch % (Columns / Patch) * Patch + k % Patch;
      const double a = 2.0 * M_PI * (column + jitter(random)) / Columns;
      const double b = 2.0 * M_PI * (row + jitter(random)) / Rows;
      const double n[3] = { std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b) };
      points->InsertNextPoint(middle[0] + std::cos(a) + 0.4 * n[0],
        middle[1] + std::sin(a) + 0.4 * n[1], middle[2] + 0.4 * n[2]);
      normals->InsertNextTuple(n);
      ids->InsertNextValue(static_cast<int>(ids->GetNumberOfTuples()));
    }
  }
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  cloud->GetPointData()->SetScalars(ids);
  return cloud;
}

vtkSmartPointer<vtkPolyData> InOrder(vtkPolyData* cloud, const std::vector<vtkIdType>& order)
{
  auto ordered = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkPointData* from = cloud->GetPointData();
  ordered->GetPointData()->CopyAllocate(from);
  for (size_t i = 0; i < order.size(); ++i)
  {
    points->InsertNextPoint(cloud->GetPoint(order[i]));
    ordered->GetPointData()->CopyData(from, order[i], static_cast<vtkIdType>(i));
  }
  ordered->SetPoints(points);
  return ordered;
}

/**
 * Those in view (or in doubt) spread evenly over the others, so that every batch has some of them;
 * they keep their own order, in which the rasteriser adds floats up.
 */
std::vector<vtkIdType> Spread(
  vtkPolyData* cloud, vtkRenderer* renderer, vtkActor* actor, vtkPlane* plane)
{
  vtkNew<vtkMatrix4x4> toImage;
  vtkMatrix4x4::Multiply4x4(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
                              renderer->GetTiledAspectRatio(), -1, 1),
    actor->GetMatrix(), toImage);
  constexpr double Limit = 1.0001;
  std::vector<vtkIdType> near;
  std::vector<vtkIdType> others;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double p[4] = { 0.0, 0.0, 0.0, 1.0 };
    cloud->GetPoint(i, p);
    toImage->MultiplyPoint(p, p);
    const bool seen = p[3] > 0.0 && std::abs(p[0]) < Limit * p[3] &&
      std::abs(p[1]) < Limit * p[3] && std::abs(p[2]) < Limit * p[3] &&
      (!plane || plane->EvaluateFunction(cloud->GetPoint(i)) > -1e-4);
    (seen ? near : others).push_back(i);
  }
  std::vector<vtkIdType> order;
  for (size_t k = 0, i = 0; i < others.size() || k < near.size();)
  {
    // As many of each as their numbers have it.
    if (k * others.size() <= i * near.size() && k < near.size())
    {
      order.push_back(near[k++]);
    }
    else
    {
      order.push_back(others[i++]);
    }
  }
  return order;
}

/// Of each pixel: which point of the original order hardware selection names.
std::vector<double> PickAll(vtkRenderer* renderer, vtkPolyData* cloud)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  std::vector<double> places;
  if (selector->CaptureBuffers())
  {
    for (unsigned int y = 0; y < Size; ++y)
    {
      for (unsigned int x = 0; x < Size; ++x)
      {
        const unsigned int pixel[2] = { x, y };
        const auto hit = selector->GetPixelInformation(pixel);
        places.push_back(
          hit.Valid ? cloud->GetPointData()->GetScalars()->GetTuple1(hit.AttributeID) : -1.0);
      }
    }
  }
  return places;
}

enum Kind
{
  Opaque,
  Parallel,
  Translucent,
  Moved,   // by the actor's matrix
  FarAway, // coordinates of millions
  NearPlane,
  Clipped,
  Kinds
};
const char* const Names[Kinds] = { "opaque", "parallel", "translucent", "moved", "far away",
  "near plane", "clipped" };

void TestCloseUp(Checks& checks, Kind kind, bool raster)
{
  const std::string name = std::string(Names[kind]) + (raster ? ", quads: " : ", compute: ");
  const double far = kind == FarAway ? 3e6 : 0.0;
  const double middle[3] = { far, -2.0 * far, 0.1 * far };
  const vtkSmartPointer<vtkPolyData> cloud = Torus(middle);

  Window window;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetMethodToImageSpace();
  mapper->SetProjection(raster ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::COMPUTE);
  mapper->SetScalarRange(0, static_cast<double>(Points));
  mapper->SetInputData(cloud);
  vtkActor* actor = window.Add(mapper);
  if (kind == Translucent)
  {
    actor->GetProperty()->SetOpacity(0.5);
  }
  if (kind == Moved)
  {
    actor->SetPosition(5, -3, 2);
    actor->SetScale(0.3, 2.0, 1.0);
    actor->RotateWXYZ(77, 1, 2, 3);
  }
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetParallelProjection(kind == Parallel);
  window.Renderer->ResetCamera();
  camera->Elevation(-40);
  window.Renderer->ResetCameraClippingRange();

  checks.AtLeast(window.Draw().CountDrawn(), 5000, name + "pixels with all in view");
  checks.Expect(mapper->GetNumberOfPointsProjected() == Points, name + "all are projected");
  if (kind == NearPlane)
  {
    // A slice of what stays in the window.
    double range[2];
    camera->GetClippingRange(range);
    camera->SetClippingRange(
      0.4 * range[0] + 0.6 * range[1], 0.25 * range[0] + 0.75 * range[1]);
  }
  else if (kind == Clipped)
  {
    plane->SetOrigin(0.3, 0, 0);
    plane->SetNormal(1, 0.2, 0);
    mapper->AddClippingPlane(plane);
  }
  else
  {
    // To where there are points, not the hole in the middle.
    camera->Zoom(4);
    camera->Yaw(kind == Moved ? 4 : -6);
  }
  const Picture picture = window.Draw();
  const vtkIdType projected = mapper->GetNumberOfPointsProjected();
  const std::vector<double> places = PickAll(window.Renderer, cloud);
  std::cout << name << projected << " of " << Points << " points projected, "
            << picture.CountDrawn() << " pixels drawn\n";
  checks.AtLeast(picture.CountDrawn(), 2000, name + "pixels of the close-up");
  checks.AtMost(static_cast<double>(projected), 0.6 * Points, name + "points projected");
  checks.AtLeast(static_cast<double>(projected), 0.005 * Points, name + "points projected");

  // The same where no batch can be left out.
  std::vector<vtkIdType> order =
    Spread(cloud, window.Renderer, actor, kind == Clipped ? plane.GetPointer() : nullptr);
  vtkSmartPointer<vtkPolyData> reordered = InOrder(cloud, order);
  mapper->SetInputData(reordered);
  checks.Expect(window.Draw().Pixels == picture.Pixels, name + "the picture is the same");
  checks.Expect(
    mapper->GetNumberOfPointsProjected() == Points, name + "no batch of spread points is left out");
  checks.Expect(
    PickAll(window.Renderer, reordered) == places, name + "selections name the same points");
  if (!raster)
  {
    // Compute shaders add integers up, so that no order matters.
    std::shuffle(order.begin(), order.end(), std::mt19937(11));
    reordered = InOrder(cloud, order);
    mapper->SetInputData(reordered);
    checks.Expect(
      window.Draw().Pixels == picture.Pixels, name + "the picture of shuffled points");
    checks.Expect(mapper->GetNumberOfPointsProjected() == Points,
      name + "no batch of shuffled points is left out");
  }

  // Batches follow points that change, and the method.
  mapper->SetInputData(cloud);
  checks.Expect(window.Draw().Pixels == picture.Pixels, name + "the first order again");
  checks.Expect(
    mapper->GetNumberOfPointsProjected() == projected, name + "points projected again");
  mapper->SetMethodToTwoPass();
  window.Win->Render();
  checks.Expect(mapper->GetNumberOfPointsProjected() == 0, name + "none are by other methods");
}

/// Camera after camera: borders of the window pass through batches everywhere.
void TestManyViews(Checks& checks)
{
  const double middle[3] = { 0.0, 0.0, 0.0 };
  const vtkSmartPointer<vtkPolyData> cloud = Torus(middle);
  std::vector<vtkIdType> order(Points);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  const vtkSmartPointer<vtkPolyData> clouds[2] = { cloud, InOrder(cloud, order) };
  Window windows[2] = { Window(64), Window(64) };
  vtkNew<vtkPointSplatMapper> mappers[2];
  for (int k = 0; k < 2; ++k)
  {
    mappers[k]->SetMethodToImageSpace();
    mappers[k]->SetInputData(clouds[k]);
    windows[k].Add(mappers[k]);
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int different = 0;
  int drawn = 0;
  vtkIdType projected = 0;
  constexpr int Views = 100;
  for (int view = 0; view < Views; ++view)
  {
    const double eye[3] = { 2.0 * uniform(random), 2.0 * uniform(random), 2.0 * uniform(random) };
    const double focus[3] = { 1.2 * uniform(random), 1.2 * uniform(random), 0.4 * uniform(random) };
    Picture pictures[2];
    for (int k = 0; k < 2; ++k)
    {
      vtkCamera* camera = windows[k].Renderer->GetActiveCamera();
      camera->SetPosition(eye);
      camera->SetFocalPoint(focus);
      camera->SetViewAngle(view % 2 ? 30.0 : 5.0);
      camera->SetParallelProjection(view % 5 == 0);
      camera->SetParallelScale(0.2);
      camera->SetClippingRange(0.3, 1.0 + view % 4);
      pictures[k] = windows[k].Draw();
    }
    different += pictures[0].Pixels != pictures[1].Pixels;
    drawn += pictures[0].CountDrawn() > 0;
    projected += mappers[0]->GetNumberOfPointsProjected();
  }
  std::cout << Views << " views, " << drawn << " not empty: "
            << 100.0 * projected / (double(Points) * Views) << " % of the points projected\n";
  checks.AtMost(different, 0, "views that differ from those of shuffled points");
  checks.AtLeast(drawn, Views / 2, "views that show something");
  checks.AtMost(static_cast<double>(projected), 0.5 * Points * Views, "points projected");
}
}

int TestSplatsBatches(int, char*[])
{
  Checks checks;
  for (int kind = 0; kind < Kinds; ++kind)
  {
    for (const bool raster : { false, true })
    {
      TestCloseUp(checks, static_cast<Kind>(kind), raster);
    }
  }
  TestManyViews(checks);
  return checks.Result();
}
