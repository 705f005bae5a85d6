// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Deferred blending draws what two passes draw, in one pass over groups.
#include "SplatScene.h"

#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPointSplatGrouping.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTestErrorObserver.h"

namespace
{
using namespace SplatScene;

/**
 * The vertices of a torus' mesh: regular, as scanned meshes' are.
 */
vtkSmartPointer<vtkPolyData> MeshTorus(int resolution)
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetCrossSectionRadius(0.4);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(2 * resolution);
  source->SetVResolution(resolution);
  source->Update();
  return Cloud(source->GetOutput());
}

struct View
{
  double Azimuth, Elevation, Dolly;
};
constexpr View Views[] = { { 20, 30, 1 }, { 60, 75, 1.2 }, { -40, 10, 3 } };

void Look(Window& window, const View& view)
{
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 1);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 1, 0);
  window.Renderer->ResetCamera();
  camera->Elevation(view.Elevation);
  camera->Azimuth(view.Azimuth);
  camera->OrthogonalizeViewUp();
  camera->Dolly(view.Dolly);
  window.Renderer->ResetCameraClippingRange();
}

/// Pixels that b draws and a does not.
int CountBeyond(const Picture& a, const Picture& b)
{
  int count = 0;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      count += a.IsBackground(x, y) && !b.IsBackground(x, y);
    }
  }
  return count;
}

/**
 * The worst of all views' likeness to two passes.
 */
double Likeness(vtkPolyData* cloud, double factor, bool voronoi, Checks& checks)
{
  vtkNew<vtkPointSplatMapper> twoPass;
  twoPass->SetInputData(cloud);
  twoPass->SetMethodToTwoPass();
  vtkNew<vtkPointSplatMapper> deferred;
  deferred->SetInputData(cloud);
  deferred->SetMethodToDeferred();
  deferred->SetOverlapFactor(factor);
  deferred->SetVoronoiDepth(voronoi);
  Window a;
  Window b;
  a.Add(twoPass);
  b.Add(deferred);
  double worst = 1000.0;
  vtkMTimeType grouped = 0;
  for (const View& view : Views)
  {
    Look(a, view);
    Look(b, view);
    const Picture pa = a.Draw();
    const Picture pb = b.Draw();
    worst = std::min(worst, Psnr(pa, pb));
    // Flaps, without Voronoi depth, hide what is behind them, but stand out nowhere.
    checks.AtMost(voronoi ? CountDifferentCoverage(pa, pb) : CountBeyond(pa, pb), 10,
      "other silhouettes, c = " + std::to_string(factor));
    checks.Expect(grouped == 0 || grouped == deferred->GetGroupMTime(), "grouped again");
    grouped = deferred->GetGroupMTime();
  }
  checks.Expect(std::string(deferred->GetMethodUsed()) == "deferred" &&
      std::string(twoPass->GetMethodUsed()) == "two-pass",
    "the method used");
  checks.Expect(deferred->GetNumberOfGroups() > 2, "groups");
  return worst;
}

void TestLikeness(Checks& checks)
{
  for (const auto& cloud : { MeshTorus(120), RandomTorus(20000), Cloud(MakeSphereMesh()) })
  {
    checks.AtLeast(Likeness(cloud, 1.0, true, checks), 44.0, "c = 1");
    const double with = Likeness(cloud, 0.4, true, checks);
    const double without = Likeness(cloud, 0.4, false, checks);
    checks.AtLeast(with, 43.0, "c = 0.4 with Voronoi depth");
    checks.AtLeast(with, without + 10.0, "Voronoi depth, against flaps");
  }
}

/**
 * Figure 9: two disks in one plane and one group, the second slightly nearer. With Voronoi
 * depth they meet halfway; without, the nearer one hides half of the other.
 */
void TestVoronoi(Checks& checks)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  vtkNew<vtkIntArray> groups;
  groups->SetName("SplatGroup");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (const int i : { 0, 1 })
  {
    points->InsertNextPoint(i ? 0.4 : -0.4, 0.0, i ? 0.01 : 0.0);
    normals->InsertNextTuple3(0, 0, 1);
    radii->InsertNextValue(1.0f);
    groups->InsertNextValue(0);
    colors->InsertNextTuple3(i ? 255 : 0, i ? 0 : 255, 0);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->AddArray(groups);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetMethodToDeferred();
  Window window;
  vtkActor* actor = window.Add(mapper);
  actor->GetProperty()->LightingOff();
  window.Renderer->ResetCamera(-1.5, 1.5, -1.5, 1.5, -0.1, 0.1);
  for (const bool voronoi : { true, false })
  {
    mapper->SetVoronoiDepth(voronoi);
    const Picture picture = window.Draw();
    int red = 0;
    int green = 0;
    for (int x = 0; x < Size; ++x)
    {
      const unsigned char* p = picture.At(x, Size / 2);
      red += p[0] > p[1];
      green += p[1] > p[0];
    }
    if (voronoi)
    {
      checks.AtMost(std::abs(red - green), 3, "the border between two splats is halfway");
    }
    else
    {
      checks.AtLeast(red, green + 10, "without Voronoi depth the nearer splat lies over the other");
    }
  }
}

void TestGivenGroups(Checks& checks)
{
  // Groups come with the points, though these were shuffled and some left out.
  vtkNew<vtkPointSplatGrouping> grouping;
  grouping->SetInputData(MeshTorus(60));
  grouping->SetOverlapFactor(0.8);
  grouping->Update();
  vtkPolyData* grouped = grouping->GetOutput();
  vtkNew<vtkPolyData> shuffled;
  vtkNew<vtkPoints> points;
  shuffled->GetPointData()->CopyAllOn();
  shuffled->GetPointData()->CopyAllocate(grouped->GetPointData());
  const vtkIdType count = grouped->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType from = (i * 7919) % count;
    shuffled->GetPointData()->CopyData(
      grouped->GetPointData(), from, points->InsertNextPoint(grouped->GetPoint(from)));
  }
  shuffled->SetPoints(points);
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetMethodToDeferred();
  mapper->ScalarVisibilityOff();
  Window window;
  window.Add(mapper);
  mapper->SetInputData(grouped);
  Look(window, Views[0]);
  const Picture first = window.Draw();
  checks.Expect(mapper->GetNumberOfGroups() == grouping->GetNumberOfGroups(), "given groups");
  mapper->SetInputData(shuffled);
  const Picture second = window.Draw();
  checks.Expect(mapper->GetNumberOfGroups() == grouping->GetNumberOfGroups(), "shuffled groups");
  checks.AtLeast(Psnr(first, second), 60.0, "shuffled points");

  // Picking names the input's points, whatever order they are drawn in.
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(window.Renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  checks.Expect(selection->GetNumberOfNodes() == 1, "picked a node");
  auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList());
  checks.AtLeast(ids->GetNumberOfValues(), count / 4, "picked points");
  int off = 0;
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    // Its point is where it was seen: in front of the torus' middle plane or not far behind.
    double p[3];
    shuffled->GetPoint(ids->GetValue(i), p);
    double toEye[3];
    window.Renderer->GetActiveCamera()->GetPosition(toEye);
    double n[3];
    shuffled->GetPointData()->GetNormals()->GetTuple(ids->GetValue(i), n);
    const double v[3] = { toEye[0] - p[0], toEye[1] - p[1], toEye[2] - p[2] };
    off += n[0] * v[0] + n[1] * v[1] + n[2] * v[2] < -0.5;
  }
  checks.AtMost(off, static_cast<int>(ids->GetNumberOfValues() / 100), "picked from behind");
}

void TestChanges(Checks& checks)
{
  // New points are grouped anew; colours alone are not a reason.
  vtkSmartPointer<vtkPolyData> cloud = RandomTorus(5000);
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(cloud);
  mapper->SetMethodToDeferred();
  Window window;
  vtkActor* actor = window.Add(mapper);
  window.Renderer->ResetCamera();
  window.Draw();
  vtkMTimeType before = mapper->GetGroupMTime();
  actor->GetProperty()->SetColor(0, 1, 0);
  window.Win->SetSize(200, 250);
  window.Draw();
  checks.Expect(mapper->GetGroupMTime() == before, "grouped again for a colour");
  cloud->GetPoints()->SetPoint(0, 0, 0, 0);
  cloud->GetPoints()->Modified();
  cloud->Modified();
  window.Draw();
  checks.Expect(mapper->GetGroupMTime() > before, "not grouped again for new points");

  // Past the bound it says so, and takes two passes.
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  mapper->SetMaximumImageMemory(1000);
  const Picture bounded = window.Draw();
  checks.Expect(std::string(mapper->GetMethodUsed()) == "two-pass" && observer->GetWarning() &&
      std::string(mapper->GetMethodReason()).find("MaximumImageMemory") != std::string::npos,
    "the bound on memory");
  observer->Clear();
  mapper->SetMaximumImageMemory(0);
  const Picture unbounded = window.Draw();
  checks.Expect(std::string(mapper->GetMethodUsed()) == "deferred" && !observer->GetWarning(),
    "no bound on memory, and nothing to warn of");
  checks.AtLeast(Psnr(bounded, unbounded), 48.0, "bounded and unbounded");
  checks.AtLeast(mapper->GetImageMemorySize(),
    vtkIdType(20) * 200 * 250 * mapper->GetNumberOfGroups(), "reported memory");
}

/**
 * A sheet of waves so high, and if wanted its back, a third of the points' distance below.
 */
vtkSmartPointer<vtkPolyData> Sheet(double height, bool withBack)
{
  constexpr int Side = 60;
  constexpr double Step = 2.0 / (Side - 1);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  for (int back = 0; back <= (withBack ? 1 : 0); ++back)
  {
    for (int i = 0; i < Side * Side; ++i)
    {
      const double x = Step * (i % Side) - 1.0;
      const double y = Step * (i / Side) - 1.0;
      double n[3] = { -5.0 * height * std::cos(5.0 * x), 0.0, 1.0 };
      vtkMath::Normalize(n);
      const double down = back * Step / 3.0;
      points->InsertNextPoint(
        x - down * n[0], y, height * std::sin(5.0 * x) - down * n[2]);
      const double side = back ? -1.0 : 1.0;
      normals->InsertNextTuple3(side * n[0], side * n[1], side * n[2]);
      radii->InsertNextValue(1.2 * Step);
    }
  }
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(radii);
  return data;
}

/**
 * All three relaxations of section 4.1 hold where the mapper groups splats itself: a sheet's back
 * asks for no more groups, nor does a plane that looks the same all over; and pictures stay.
 */
void TestRelaxations(Checks& checks)
{
  const auto groupsOf = [&checks](vtkPolyData* data) {
    Picture pictures[2];
    int groups = 0;
    for (const int method : { vtkPointSplatMapper::TWO_PASS, vtkPointSplatMapper::DEFERRED })
    {
      vtkNew<vtkPointSplatMapper> mapper;
      mapper->SetInputData(data);
      mapper->SetMethod(method);
      mapper->SetProjectionToQuads();
      Window window;
      window.Add(mapper);
      Look(window, Views[0]);
      pictures[method == vtkPointSplatMapper::DEFERRED] = window.Draw();
      groups = mapper->GetNumberOfGroups();
    }
    checks.AtLeast(Psnr(pictures[0], pictures[1]), 39.0, "sheets, against two passes");
    return groups;
  };
  const int single = groupsOf(Sheet(0.05, false));
  checks.AtLeast(single, 3, "a sheet's groups");
  checks.AtMost(groupsOf(Sheet(0.05, true)), single + 1, "groups of a sheet with a back");

  const auto plane = Sheet(0.0, false);
  checks.AtMost(groupsOf(plane), 1, "groups of a plane");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple3(2.0 * static_cast<double>(i % 60), 128, 128);
  }
  plane->GetPointData()->SetScalars(colours);
  checks.AtLeast(groupsOf(plane), 4, "groups of a plane of many colours");
}

/**
 * By hand only: automatic takes two passes, by quads and for a rough target error too.
 */
void TestAutomatic(Checks& checks)
{
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(RandomTorus(40000));
  Window window(272);
  window.Add(mapper);
  auto used = [&]() {
    window.Draw();
    return std::string(mapper->GetMethodUsed()) + ", " + mapper->GetProjectionUsed();
  };
  checks.Expect(used() == "two-pass, compute", "full quality");
  mapper->SetProjectionToQuads();
  mapper->SetTargetError(1.0 / 64.0);
  checks.Expect(used() == "two-pass, quads", "quads");
  mapper->SetMethodToDeferred();
  checks.Expect(used().find("deferred") == 0, "deferred because it is asked for");
}

/**
 * Two nested spheres of other colours, one of them with scalars, share the groups' images.
 */
void TestSeveralActors(Checks& checks)
{
  Picture pictures[2];
  for (const bool deferred : { false, true })
  {
    Window window;
    for (const double radius : { 0.6, 0.5 })
    {
      vtkNew<vtkPointSplatMapper> mapper;
      mapper->SetInputData(Cloud(MakeSphereMesh(120)));
      mapper->SetMethod(deferred ? vtkPointSplatMapper::DEFERRED : vtkPointSplatMapper::TWO_PASS);
      mapper->SetOverlapFactor(1.0);
      vtkActor* actor = window.Add(mapper);
      actor->SetScale(radius * 2);
      actor->SetPosition(radius == 0.5 ? 0.4 : 0.0, 0, 0);
      actor->GetProperty()->SetColor(radius == 0.5, 0.5, 1.0);
    }
    window.Renderer->ResetCamera();
    pictures[deferred] = window.Draw();
  }
  checks.AtLeast(Psnr(pictures[0], pictures[1]), 43.0, "two actors");
}
}

int TestSplatsDeferred(int, char*[])
{
  Checks checks;
  TestLikeness(checks);
  TestVoronoi(checks);
  TestGivenGroups(checks);
  TestChanges(checks);
  TestRelaxations(checks);
  TestSeveralActors(checks);
  TestAutomatic(checks);
  return checks.Failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
