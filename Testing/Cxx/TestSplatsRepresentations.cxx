// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// As points and as wireframe the picture and the picks are vtkPolyDataMapper's; what of an actor's looks
// splats do not show is said once.
#include "SplatTables.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"

namespace
{
using namespace SplatScene;
using Change = std::function<void(Window&, vtkActor*)>;

/// The same points, each with a vertex.
vtkSmartPointer<vtkPolyData> WithVertices(vtkPolyData* data, bool backwards = false)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(data->GetPoints());
  result->GetPointData()->ShallowCopy(data->GetPointData());
  vtkNew<vtkCellArray> verts;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const vtkIdType id = backwards ? data->GetNumberOfPoints() - 1 - i : i;
    verts->InsertNextCell(1, &id);
  }
  result->SetVerts(verts);
  return result;
}

vtkSmartPointer<vtkPolyData> MakeMesh()
{
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(30);
  vtkNew<vtkDoubleArray> heights;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(mesh->GetPoint(i)[1]);
  }
  mesh->GetPointData()->SetScalars(heights);
  return mesh;
}

Picture Draw(vtkMapper* mapper, vtkDataObject* data, int representation, const Change& change)
{
  Window window;
  mapper->SetInputDataObject(data);
  mapper->SetScalarRange(-0.5, 0.5);
  vtkActor* actor = window.Add(mapper);
  actor->GetProperty()->SetRepresentation(representation);
  actor->GetProperty()->SetPointSize(5.0);
  actor->GetProperty()->SetLineWidth(2.0);
  window.Renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
  change(window, actor);
  window.Renderer->ResetCameraClippingRange(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
  return window.Draw();
}

void Same(Checks& checks, const std::string& name, vtkDataObject* data, vtkDataObject* asVTK,
  const Change& change)
{
  for (const int representation : { VTK_POINTS, VTK_WIREFRAME })
  {
    const std::string label = name + (representation == VTK_POINTS ? ", points" : ", wireframe");
    const Picture wanted = Draw(vtkNew<vtkPolyDataMapper>(), asVTK, representation, change);
    const Picture picture = Draw(vtkNew<vtkPointSplatMapper>(), data, representation, change);
    checks.AtLeast(wanted.CountDrawn(), 100, label + ": pixels drawn");
    checks.AtMost(LargestDifference(wanted, picture), 0, label + ": not as VTK's mapper");
  }
}

const Change Nothing = [](Window&, vtkActor*) {};

void TestPictures(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  vtkSmartPointer<vtkPolyData> cloud = Cloud(mesh);
  cloud->GetPointData()->SetScalars(mesh->GetPointData()->GetScalars());
  vtkSmartPointer<vtkPolyData> vertices = WithVertices(cloud);
  Same(checks, "mesh", mesh, mesh, Nothing);
  Same(checks, "vertices", vertices, vertices, Nothing);
  Same(checks, "points alone", cloud, vertices, Nothing);
  Same(checks, "material", cloud, vertices, [](Window&, vtkActor* actor) {
    actor->GetMapper()->ScalarVisibilityOff();
    actor->GetProperty()->SetColor(0.2, 0.9, 0.3);
    actor->GetProperty()->SetSpecular(0.8);
  });
  Same(checks, "translucent", cloud, vertices, [](Window& window, vtkActor* actor) {
    actor->GetProperty()->SetOpacity(0.4);
    window.Renderer->UseDepthPeelingOn();
    window.Win->AlphaBitPlanesOn();
  });
  Same(checks, "clipped", cloud, vertices, [](Window&, vtkActor* actor) {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(1, 1, 0);
    actor->GetMapper()->AddClippingPlane(plane);
  });
  Same(checks, "spheres", cloud, vertices, [](Window&, vtkActor* actor) {
    actor->GetProperty()->RenderPointsAsSpheresOn();
  });

  vtkNew<vtkPolyData> bad;
  bad->ShallowCopy(vertices);
  vtkNew<vtkCellArray> triangles;
  const vtkIdType ids[3] = { 0, 1, 1000000 };
  triangles->InsertNextCell(3, ids);
  bad->SetPolys(triangles);
  Same(checks, "cells that name no point", bad, vertices, Nothing);

  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(cloud->GetPoints());
  grid->GetPointData()->ShallowCopy(cloud->GetPointData());
  Same(checks, "unstructured grid", grid, vertices, Nothing);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud);
  blocks->SetBlock(2, cloud);
  const Picture wanted = Draw(vtkNew<vtkPolyDataMapper>(), vertices, VTK_POINTS, Nothing);
  const Picture picture = Draw(vtkNew<vtkPointSplatMapper>(), blocks, VTK_POINTS, Nothing);
  checks.AtMost(LargestDifference(wanted, picture), 0, "blocks: not as VTK's mapper");
}

/// Pressing w, s and p, and changing what is drawn in between.
void TestSwitching(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  vtkSmartPointer<vtkPolyData> cloud = Cloud(mesh);
  vtkSmartPointer<vtkPolyData> vertices = WithVertices(cloud);
  Window windows[2];
  vtkActor* actors[2];
  for (int kind = 0; kind < 2; ++kind)
  {
    auto mapper = kind == 0 ? vtkSmartPointer<vtkPolyDataMapper>::New()
                            : vtkSmartPointer<vtkPolyDataMapper>(vtkNew<vtkPointSplatMapper>());
    mapper->SetInputData(kind == 0 ? vertices : cloud);
    mapper->SetScalarRange(-0.5, 0.5);
    actors[kind] = windows[kind].Add(mapper);
    windows[kind].Renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
  }
  auto differ = [&](int representation) {
    Picture pictures[2];
    for (int kind = 0; kind < 2; ++kind)
    {
      actors[kind]->GetProperty()->SetRepresentation(representation);
      pictures[kind] = windows[kind].Draw();
    }
    return LargestDifference(pictures[0], pictures[1]);
  };
  actors[1]->GetProperty()->SetRepresentationToSurface();
  const Picture surface = windows[1].Draw();
  checks.AtMost(differ(VTK_WIREFRAME), 0, "switched to wireframe");
  vtkNew<vtkDoubleArray> scalars;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(cloud->GetPoint(i)[0]);
  }
  cloud->GetPointData()->SetScalars(scalars);
  vertices->GetPointData()->SetScalars(scalars);
  checks.AtMost(differ(VTK_POINTS), 0, "new scalars");
  for (vtkActor* actor : actors)
  {
    actor->GetMapper()->SetScalarRange(0.0, 0.1);
  }
  checks.AtMost(differ(VTK_POINTS), 0, "new range");
  cloud->GetPointData()->SetScalars(nullptr);
  actors[1]->GetProperty()->SetRepresentationToSurface();
  checks.AtMost(LargestDifference(surface, windows[1].Draw()), 0, "switched back to surface");
}

/// Behind splats, and before them.
void TestBesideSplats(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  vtkSmartPointer<vtkPolyData> cloud = Cloud(mesh);
  Picture pictures[2];
  for (int kind = 0; kind < 2; ++kind)
  {
    Window window;
    vtkNew<vtkPointSplatMapper> sphere;
    sphere->SetInputData(cloud);
    window.Add(sphere);
    auto mapper = kind == 0 ? vtkSmartPointer<vtkPolyDataMapper>::New()
                            : vtkSmartPointer<vtkPolyDataMapper>(vtkNew<vtkPointSplatMapper>());
    mapper->SetInputData(WithVertices(cloud));
    vtkActor* points = window.Add(mapper);
    points->SetPosition(0.3, 0.2, 0.1);
    points->GetProperty()->SetRepresentationToPoints();
    points->GetProperty()->SetPointSize(4);
    window.Renderer->ResetCamera(-0.5, 0.8, -0.5, 0.7, -0.5, 0.6);
    pictures[kind] = window.Draw();
  }
  checks.AtMost(LargestDifference(pictures[0], pictures[1]), 0, "points beside splats");
}

vtkIdType Pick(Window& window, int association, const double* p, unsigned int& block)
{
  window.Renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
  window.Renderer->WorldToDisplay();
  const int x = static_cast<int>(window.Renderer->GetDisplayPoint()[0]);
  const int y = static_cast<int>(window.Renderer->GetDisplayPoint()[1]);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(window.Renderer);
  selector->SetArea(x, y, x, y);
  selector->SetFieldAssociation(association);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    return -1;
  }
  vtkSelectionNode* node = selection->GetNode(0);
  block = static_cast<unsigned int>(
    node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX()));
  auto ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
  return ids && ids->GetNumberOfTuples() == 1 ? ids->GetValue(0) : -2;
}

void TestPicks(Checks& checks)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(NAN, 0, 0);
  for (int i = 0; i < 100; ++i)
  {
    points->InsertNextPoint(i % 10, i / 10, 0);
  }
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(points);
  vtkSmartPointer<vtkPolyData> vertices = WithVertices(bare, true);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, bare);
  for (vtkDataObject* data :
    std::initializer_list<vtkDataObject*>{ bare.Get(), vertices.Get(), blocks.Get() })
  {
    const std::string name = data == bare ? "points alone" : data == blocks ? "blocks" : "vertices";
    Window window;
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputDataObject(data);
    vtkActor* actor = window.Add(mapper);
    actor->GetProperty()->SetRepresentationToPoints();
    actor->GetProperty()->SetPointSize(7);
    window.Renderer->ResetCamera(0, 9, 0, 9, 0, 0);
    window.Draw();
    for (const vtkIdType id : { 1, 37, 64, 100 })
    {
      unsigned int block = 0;
      const double* p = points->GetPoint(id);
      checks.Expect(
        Pick(window, vtkDataObject::FIELD_ASSOCIATION_POINTS, p, block) == id, name + ": point");
      checks.Expect(data != blocks || block == 2, name + ": block is " + std::to_string(block));
      const vtkIdType cell = Pick(window, vtkDataObject::FIELD_ASSOCIATION_CELLS, p, block);
      checks.Expect(cell == (data == vertices ? 100 - id : id),
        name + ": cell of " + std::to_string(id) + " is " + std::to_string(cell));
    }
    double between[3] = { 4.5, 4.5, 0.0 };
    unsigned int block = 0;
    checks.Expect(Pick(window, vtkDataObject::FIELD_ASSOCIATION_POINTS, between, block) == -1,
      name + ": something between points");
  }
}

/**
 * With flat interpolation each pixel has the tone of a point nearby. White, by a headlight from
 * straight above that is the z of its normal.
 */
void TestFlat(Checks& checks, const Way& way, bool device)
{
  vtkSmartPointer<vtkPolyData> cloud = RandomSphere(500);
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(cloud);
  mapper->SetMethod(way.Method);
  mapper->SetProjection(way.Projection);
  device ? mapper->SetTileListsToDevice() : mapper->SetTileListsToProcessor();
  mapper->AntiAliasingOff();
  mapper->FillGapsOff(); // their tones lie between those of points
  vtkActor* actor = window.Add(mapper);
  actor->GetProperty()->SetColor(1, 1, 1);
  actor->GetProperty()->SetSpecular(0);
  actor->GetProperty()->SetAmbient(0);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.1);
  camera->SetPosition(0, 0, 5);
  window.Renderer->ResetCameraClippingRange();
  const Picture smooth = window.Draw();
  actor->GetProperty()->SetInterpolationToFlat();
  const Picture flat = window.Draw();
  actor->GetProperty()->SetInterpolationToGouraud();
  const std::string name = std::string("flat, ") + way.Name + (device ? ", device's lists" : "");
  checks.AtMost(LargestDifference(smooth, window.Draw()), 0, name + ": switched back");
  int pairs = 0;
  int equal = 0;
  int strange = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x + 1 < Size; ++x)
    {
      const double p[2] = { 1.1 * (2.0 * (x + 0.5) / Size - 1.0),
        1.1 * (2.0 * (y + 0.5) / Size - 1.0) };
      const double q = p[0] * p[0] + p[1] * p[1];
      if (q > 0.8)
      {
        continue;
      }
      const int tone = flat.At(x, y)[0];
      ++pairs;
      equal += tone == flat.At(x + 1, y)[0];
      bool known = false;
      for (vtkIdType i = 0; i < cloud->GetNumberOfPoints() && !known; ++i)
      {
        const double* c = cloud->GetPoint(i);
        // Random points leave gaps of four times their mean distance.
        known = std::hypot(p[0] - c[0], p[1] - c[1], std::sqrt(1.0 - q) - c[2]) < 0.4 &&
          std::abs(tone - 255.0 * c[2]) <= 1.0;
      }
      strange += !known;
    }
  }
  checks.AtMost(strange, 0, name + ": pixels with no point's tone");
  checks.AtLeast(double(equal) / pairs, 0.85, name + ": neighbours of one tone");
}

void TestFlatInLayers(Checks& checks)
{
  Picture pictures[2];
  for (int kind = 0; kind < 2; ++kind)
  {
    Window window;
    window.Renderer->UseDepthPeelingOn();
    window.Win->AlphaBitPlanesOn();
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(RandomSphere(500));
    mapper->SetProjection(kind ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::COMPUTE);
    vtkActor* actor = window.Add(mapper);
    actor->GetProperty()->SetInterpolationToFlat();
    actor->GetProperty()->SetOpacity(0.5);
    window.Renderer->ResetCamera();
    pictures[kind] = window.Draw();
  }
  checks.AtLeast(Psnr(pictures[0], pictures[1]), 38.0, "flat layers, by quads: psnr");
}

void TestWarnings(Checks& checks)
{
  const std::pair<std::string, std::function<void(vtkActor*)>> all[] = {
    { "no texture coordinates", [](vtkActor* a) { a->SetTexture(vtkNew<vtkTexture>()); } },
    { "textures with Method Deferred; EdgeVisibility with Method Deferred",
      [](vtkActor* a) {
        static_cast<vtkPointSplatMapper*>(a->GetMapper())->SetMethodToDeferred();
        a->SetTexture(vtkNew<vtkTexture>());
        a->GetProperty()->EdgeVisibilityOn();
      } },
    { "EdgeVisibility where splats are drawn by quads",
      [](vtkActor* a) {
        static_cast<vtkPointSplatMapper*>(a->GetMapper())->SetProjectionToQuads();
        a->GetProperty()->EdgeVisibilityOn();
      } },
    { "VertexVisibility", [](vtkActor* a) { a->GetProperty()->VertexVisibilityOn(); } },
    { "Anisotropy, since the points have no tangents",
      [](vtkActor* a) {
        a->GetProperty()->SetInterpolationToPBR();
        a->GetProperty()->SetAnisotropy(0.5);
      } },
    { "flat",
      [](vtkActor* a) {
        static_cast<vtkPointSplatMapper*>(a->GetMapper())->SetMethodToImageSpace();
        a->GetProperty()->SetInterpolationToFlat();
      } },
    { "", [](vtkActor* a) { a->GetProperty()->EdgeVisibilityOn(); } },
    { "", [](vtkActor*) {} },
  };
  for (const auto& one : all)
  {
    std::vector<std::string> warnings;
    vtkNew<vtkCallbackCommand> listen;
    listen->SetClientData(&warnings);
    listen->SetCallback([](vtkObject*, unsigned long, void* data, void* text) {
      static_cast<std::vector<std::string>*>(data)->emplace_back(static_cast<char*>(text));
    });
    Window window;
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(RandomSphere(500));
    mapper->AddObserver(vtkCommand::WarningEvent, listen);
    vtkActor* actor = window.Add(mapper);
    window.Renderer->ResetCamera();
    window.Draw();
    one.second(actor);
    window.Draw();
    window.Draw();
    const bool named = warnings.size() == 1 && warnings[0].find(one.first) != std::string::npos;
    checks.Expect(one.first.empty() ? warnings.empty() : named,
      one.first + ": " + std::to_string(warnings.size()) + " warnings");
  }
}
}

int TestSplatsRepresentations(int, char*[])
{
  Checks checks;
  TestPictures(checks);
  TestSwitching(checks);
  TestBesideSplats(checks);
  TestPicks(checks);
  for (const Way& way : Ways)
  {
    if (way.Method != Mapper::IMAGE_SPACE)
    {
      TestFlat(checks, way, false);
    }
  }
  TestFlat(checks, Ways[0], true);
  TestFlatInLayers(checks);
  TestWarnings(checks);
  return checks.Result();
}
