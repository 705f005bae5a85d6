// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of splats that are out of view are not projected, and no picture tells: close-ups of a
// cloud against the same cloud cut up so that each block has splats in view.
//
// The mapper sorts the points of each data set along a Morton curve, one data set after the other,
// and 128 splats in that order make a block. So a composite of data sets of 128 points each has
// these for its blocks, wherever their points lie.
#include "SplatScene.h"

#include "vtkHardwareSelector.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using namespace SplatScene;

constexpr int Rows = 150;
constexpr int Columns = 200;
constexpr vtkIdType Points = vtkIdType(Rows) * Columns;
constexpr size_t PointsOfBlock = 128;
// Of the windows, pixels: splats of close-ups are many pixels wide all the same.
constexpr int Side = 160;

/**
 * A torus about the middle, of splats that overlap.
 */
vtkSmartPointer<vtkPolyData> Torus(const double middle[3])
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  vtkNew<vtkIntArray> ids;
  ids->SetName("Place");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(0.0, 1.0);
  for (int i = 0; i < Points; ++i)
  {
    const double a = 2.0 * M_PI * (i % Columns + jitter(random)) / Columns;
    const double b = 2.0 * M_PI * (i / Columns + jitter(random)) / Rows;
    const double n[3] = { std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b) };
    points->InsertNextPoint(middle[0] + std::cos(a) + 0.4 * n[0],
      middle[1] + std::sin(a) + 0.4 * n[1], middle[2] + 0.4 * n[2]);
    normals->InsertNextTuple(n);
    radii->InsertNextValue(0.05f);
    ids->InsertNextValue(i);
  }
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  cloud->GetPointData()->AddArray(radii);
  cloud->GetPointData()->SetScalars(ids);
  return cloud;
}

/// The cloud as data sets of PointsOfBlock each, in an order.
vtkSmartPointer<vtkMultiBlockDataSet> CutUp(vtkPolyData* cloud, const std::vector<vtkIdType>& order)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (size_t first = 0; first < order.size(); first += PointsOfBlock)
  {
    vtkNew<vtkPolyData> block;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    block->GetPointData()->CopyAllocate(cloud->GetPointData());
    for (size_t i = first; i < std::min(first + PointsOfBlock, order.size()); ++i)
    {
      block->GetPointData()->CopyData(
        cloud->GetPointData(), order[i], points->InsertNextPoint(cloud->GetPoint(order[i])));
    }
    block->SetPoints(points);
    blocks->SetBlock(static_cast<unsigned int>(first / PointsOfBlock), block);
  }
  return blocks;
}

/**
 * Those in view (or in doubt) spread evenly over the others, so that every block has some of them.
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

/// Of each pixel: which point of the cloud hardware selection names; -1: none, -2: one that is not there.
std::vector<double> PickAll(vtkRenderer* renderer, vtkDataObject* input)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, Side - 1, Side - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  auto blocks = vtkMultiBlockDataSet::SafeDownCast(input);
  std::vector<double> places;
  if (selector->CaptureBuffers())
  {
    for (unsigned int y = 0; y < Side; ++y)
    {
      for (unsigned int x = 0; x < Side; ++x)
      {
        const unsigned int pixel[2] = { x, y };
        const auto hit = selector->GetPixelInformation(pixel);
        auto data = vtkPolyData::SafeDownCast(
          blocks && hit.Valid ? blocks->GetBlock(hit.CompositeID - 1) : input);
        const bool exists = data && hit.AttributeID < data->GetNumberOfPoints();
        places.push_back(!hit.Valid ? -1.0
            : !exists               ? -2.0
                      : data->GetPointData()->GetScalars()->GetTuple1(hit.AttributeID));
      }
    }
  }
  return places;
}

/**
 * A way to draw. Compute shaders add integers up, so that no order matters; the rasteriser adds
 * floats.
 */
struct Way
{
  const char* Name;
  vtkPointSplatMapper::MethodType Method;
  vtkPointSplatMapper::ProjectionType Projection;
};
const Way Ways[] = {
  { "two passes, compute", vtkPointSplatMapper::TWO_PASS, vtkPointSplatMapper::COMPUTE },
  { "two passes, quads", vtkPointSplatMapper::TWO_PASS, vtkPointSplatMapper::QUADS },
  { "image space, compute", vtkPointSplatMapper::IMAGE_SPACE, vtkPointSplatMapper::COMPUTE },
  { "image space, quads", vtkPointSplatMapper::IMAGE_SPACE, vtkPointSplatMapper::QUADS },
};

/// Other ways than tiles settle which of equal points is named by the least id, of blocks and of
/// points each for itself.
bool IsByTiles(const Way& way)
{
  return way.Method == vtkPointSplatMapper::TWO_PASS &&
    way.Projection == vtkPointSplatMapper::COMPUTE;
}

/// The same picture, to the bit but for the rounding of the rasteriser's sums.
void Same(Checks& checks, const Way& way, const std::string& name, const Picture& a, const Picture& b)
{
  if (way.Projection == vtkPointSplatMapper::COMPUTE)
  {
    checks.Expect(a.Pixels == b.Pixels, name);
  }
  else
  {
    int largest = 0;
    for (size_t i = 0; i < a.Pixels.size(); ++i)
    {
      largest = std::max(largest, std::abs(a.Pixels[i] - b.Pixels[i]));
    }
    checks.AtMost(largest, 1, name);
  }
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

void TestCloseUp(Checks& checks, Kind kind, const Way& way)
{
  const std::string name = std::string(Names[kind]) + ", " + way.Name + ": ";
  const double far = kind == FarAway ? 3e6 : 0.0;
  const double middle[3] = { far, -2.0 * far, 0.1 * far };
  const vtkSmartPointer<vtkPolyData> cloud = Torus(middle);

  Window window(Side);
  vtkNew<vtkPlane> plane;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetMethod(way.Method);
  mapper->SetProjection(way.Projection);
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

  checks.AtLeast(window.Draw().CountDrawn(), 1500, name + "pixels with all in view");
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
  checks.AtLeast(picture.CountDrawn(), 600, name + "pixels of the close-up");
  checks.AtMost(static_cast<double>(projected), 0.6 * Points, name + "points projected");
  checks.AtLeast(static_cast<double>(projected), 0.005 * Points, name + "points projected");

  // The same where no block can be left out.
  std::vector<vtkIdType> order =
    Spread(cloud, window.Renderer, actor, kind == Clipped ? plane.GetPointer() : nullptr);
  for (const bool shuffled : { false, true })
  {
    if (shuffled)
    {
      std::shuffle(order.begin(), order.end(), std::mt19937(11));
    }
    const vtkSmartPointer<vtkMultiBlockDataSet> blocks = CutUp(cloud, order);
    mapper->SetInputDataObject(blocks);
    const std::string what = name + (shuffled ? "shuffled: " : "spread: ");
    Same(checks, way, what + "the picture is the same", window.Draw(), picture);
    checks.Expect(mapper->GetNumberOfPointsProjected() == Points, what + "no block is left out");
    const std::vector<double> others = PickAll(window.Renderer, blocks);
    checks.AtLeast(others.size(), places.size(), what + "pixels of selections");
    int different = 0;
    for (size_t i = 0; i < places.size(); ++i)
    {
      different += others[i] != places[i];
    }
    checks.AtMost(different, IsByTiles(way) ? 0 : picture.CountDrawn() / 500,
      what + "selections name other points");
  }

  // Blocks follow points that change.
  mapper->SetInputData(cloud);
  Same(checks, way, name + "the first cloud again", window.Draw(), picture);
  checks.Expect(
    mapper->GetNumberOfPointsProjected() == projected, name + "points projected again");
}

/// Camera after camera: borders of the window pass through blocks everywhere.
void TestManyViews(Checks& checks, vtkPointSplatMapper::MethodType method)
{
  const double middle[3] = { 0.0, 0.0, 0.0 };
  const vtkSmartPointer<vtkPolyData> cloud = Torus(middle);
  std::vector<vtkIdType> order(Points);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  const vtkSmartPointer<vtkDataObject> clouds[2] = { cloud, CutUp(cloud, order) };
  Window windows[2] = { Window(64), Window(64) };
  vtkNew<vtkPointSplatMapper> mappers[2];
  for (int k = 0; k < 2; ++k)
  {
    mappers[k]->SetMethod(method);
    mappers[k]->SetScalarRange(0, static_cast<double>(Points));
    mappers[k]->SetInputDataObject(clouds[k]);
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

int TestSplatsSelection(int, char*[])
{
  Checks checks;
  for (int kind = 0; kind < Kinds; ++kind)
  {
    for (const Way& way : Ways)
    {
      TestCloseUp(checks, static_cast<Kind>(kind), way);
    }
  }
  TestManyViews(checks, vtkPointSplatMapper::TWO_PASS);
  TestManyViews(checks, vtkPointSplatMapper::IMAGE_SPACE);
  return checks.Result();
}
