// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Scalars of cells and of field data: a splat has the colour of one cell, a pixel that of one
// splat, and no colour appears that the table has not.
#include "SplatTables.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"

namespace
{
using namespace SplatScene;
using Change = std::function<void(Window&, vtkActor*)>;

/// One of the table's five, by the octant of a place and so in large patches.
int LabelOf(const double p[3])
{
  return ((p[0] > 0.0) + 2 * (p[1] > 0.1) + 4 * (p[2] > 0.3)) % 5;
}

Picture Draw(vtkPolyData* data, const Way* way, const Change& change)
{
  Window window;
  vtkSmartPointer<vtkPolyDataMapper> mapper;
  if (way)
  {
    vtkNew<Mapper> splats;
    splats->SetMethod(way->Method);
    splats->SetProjection(way->Projection);
    splats->AntiAliasingOff();
    mapper = splats;
  }
  else
  {
    mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  }
  mapper->SetInputData(data);
  mapper->SetLookupTable(Saturated());
  mapper->SetScalarRange(0, 4);
  vtkActor* actor = window.Add(mapper);
  Unlit(actor);
  window.Renderer->ResetCamera();
  change(window, actor);
  return window.Draw();
}

const Change Nothing = [](Window&, vtkActor*) {};

/// Labels one a cell, of the cell's first point.
vtkSmartPointer<vtkIntArray> LabelsOfCells(vtkPolyData* data)
{
  auto labels = vtkSmartPointer<vtkIntArray>::New();
  labels->SetName("labels");
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    data->GetCellPoints(c, ids);
    labels->InsertNextValue(LabelOf(data->GetPoint(ids->GetId(0))));
  }
  return labels;
}

/// A cloud with a vertex a point, or of so many points each.
vtkSmartPointer<vtkPolyData> WithVertices(vtkPolyData* mesh, vtkIdType pointsPerCell = 1)
{
  vtkSmartPointer<vtkPolyData> cloud = Cloud(mesh);
  vtkNew<vtkCellArray> verts;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += pointsPerCell)
  {
    verts->InsertNextCell(0);
    vtkIdType count = 0;
    for (; count < pointsPerCell && i + count < mesh->GetNumberOfPoints(); ++count)
    {
      verts->InsertCellPoint(i + count);
    }
    verts->UpdateCellCount(static_cast<int>(count));
  }
  cloud->SetVerts(verts);
  return cloud;
}

double ShareOfDifferent(const Picture& a, const Picture& b)
{
  int different = 0;
  for (size_t i = 0; i < a.Pixels.size(); i += 3)
  {
    different += !std::equal(&a.Pixels[i], &a.Pixels[i] + 3, &b.Pixels[i]);
  }
  return double(different) / a.CountDrawn();
}

void TestWays(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(150);
  mesh->GetCellData()->SetScalars(LabelsOfCells(mesh));
  vtkSmartPointer<vtkPolyData> surface = Cloud(mesh);
  surface->SetPolys(mesh->GetPolys());
  surface->GetCellData()->SetScalars(mesh->GetCellData()->GetScalars());
  vtkSmartPointer<vtkPolyData> vertices = WithVertices(mesh);
  vertices->GetCellData()->SetScalars(LabelsOfCells(vertices));
  const Picture wanted = Draw(mesh, nullptr, Nothing);
  for (const Way& way : Ways)
  {
    for (const bool polygons : { false, true })
    {
      const Picture picture = Draw(polygons ? surface : vertices, &way, Nothing);
      const std::string label = std::string(way.Name) + (polygons ? ", polygons" : ", vertices");
      checks.AtMost(CountOffTable(picture, Saturated()), 0, label + ": pixels off the table");
      // Patches' borders are a splat's radius off, and image space marks outlines' pixels as well.
      checks.AtMost(ShareOfDifferent(wanted, picture),
        way.Method == Mapper::IMAGE_SPACE ? 0.15 : 0.04, label + ": pixels not as on the mesh");
    }
  }
}

/// Each pixel of a random cloud with as many colours as points has one of them.
void TestEveryCell(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> cloud = WithVertices(RandomSphere(3000));
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  std::set<std::array<int, 3>> known{ { 0, 0, 0 } };
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const std::array<int, 3> c{ int(50 + i % 200), int(50 + i / 200 * 10), int(50 + i * 7 % 200) };
    colours->InsertNextTuple3(c[0], c[1], c[2]);
    known.insert(c);
  }
  cloud->GetCellData()->SetScalars(colours);
  for (const Way& way : Ways)
  {
    Picture last;
    for (int run = 0; run < 2; ++run)
    {
      const Picture picture = Draw(cloud, &way, Nothing);
      int unknown = 0;
      for (size_t i = 0; i < picture.Pixels.size(); i += 3)
      {
        unknown +=
          known.count({ picture.Pixels[i], picture.Pixels[i + 1], picture.Pixels[i + 2] }) == 0;
      }
      checks.AtMost(unknown, 0, std::string(way.Name) + ": pixels that no cell has coloured");
      if (run == 1)
      {
        checks.AtMost(LargestDifference(last, picture), 0, std::string(way.Name) + ": once more");
      }
      last = picture;
    }
  }
}

void TestKindsOfCells(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(150);
  const Picture wanted = Draw(mesh, nullptr, [&](Window&, vtkActor*) {
    mesh->GetCellData()->SetScalars(LabelsOfCells(mesh));
  });
  auto check = [&](const std::string& name, vtkPolyData* data, const Change& change, double most) {
    const Picture picture = Draw(data, &Ways[0], change);
    checks.AtMost(CountOffTable(picture, Saturated()), 0, name + ": pixels off the table");
    checks.AtMost(ShareOfDifferent(wanted, picture), most, name + ": pixels not as on the mesh");
  };
  vtkSmartPointer<vtkPolyData> pairs = WithVertices(mesh, 2);
  pairs->GetCellData()->SetScalars(LabelsOfCells(pairs));
  // Of each further point of a cell patches are a spacing longer.
  check("poly-vertices", pairs, Nothing, 0.05);

  vtkSmartPointer<vtkPolyData> lines = WithVertices(mesh, 3);
  lines->SetLines(lines->GetVerts());
  lines->SetVerts(nullptr);
  lines->GetCellData()->SetScalars(LabelsOfCells(lines));
  check("lines", lines, Nothing, 0.07);

  vtkSmartPointer<vtkPolyData> strips = Cloud(mesh);
  strips->SetStrips(mesh->GetPolys());
  strips->GetCellData()->SetScalars(LabelsOfCells(strips));
  check("strips", strips, Nothing, 0.04);

  vtkSmartPointer<vtkPolyData> named = WithVertices(mesh);
  named->GetCellData()->AddArray(LabelsOfCells(named));
  check("cell field data by name", named, [](Window&, vtkActor* actor) {
    actor->GetMapper()->SetScalarModeToUseCellFieldData();
    actor->GetMapper()->SelectColorArray("labels");
  }, 0.04);

  // The cells' own scalars, beside others of the points.
  vtkNew<vtkIntArray> others;
  others->SetNumberOfTuples(named->GetNumberOfPoints());
  others->Fill(1);
  named->GetPointData()->SetScalars(others);
  named->GetCellData()->SetScalars(LabelsOfCells(named));
  check("cell data beside point data", named, [](Window&, vtkActor* actor) {
    actor->GetMapper()->SetScalarModeToUseCellData();
    actor->GetMapper()->InterpolateScalarsBeforeMappingOn(); // which is for points
  }, 0.04);
}

/// Three splats side by side: of the points' cells the first counts, and none is NaN's colour.
void TestWhichCell(Checks& checks)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint(3.0 * i, 0.0, 0.0);
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
    radii->InsertNextValue(1.0f);
  }
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(radii);
  auto colourOf = [&](int point, const Change& change = Nothing) {
    const Picture picture = Draw(data, &Ways[0], [&](Window& window, vtkActor* actor) {
      window.Renderer->ResetCamera(-1.0, 7.0, -1.0, 1.0, 0.0, 0.0);
      window.Renderer->GetActiveCamera()->ParallelProjectionOn();
      window.Renderer->GetActiveCamera()->SetParallelScale(4.0);
      change(window, actor);
    });
    const unsigned char* p = picture.At(Size / 2 + (point - 1) * 3 * Size / 8, Size / 2);
    return std::array<int, 3>{ p[0], p[1], p[2] };
  };
  auto expect = [&](const std::array<int, 3>& found, int r, int g, int b, const std::string& what) {
    // 229.5 is rounded either way by drivers.
    checks.AtMost(std::max({ std::abs(found[0] - r), std::abs(found[1] - g), std::abs(found[2] - b) }), 1,
      what + ": " + std::to_string(found[0]) + " " + std::to_string(found[1]) + " " +
        std::to_string(found[2]));
  };
  vtkNew<vtkIntArray> labels;
  data->GetCellData()->SetScalars(labels);
  expect(colourOf(0), 230, 153, 102, "no cells: the actor's colour");

  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 1 });
  verts->InsertNextCell({ 0 });
  verts->InsertNextCell({ 0 });
  data->SetVerts(verts);
  labels->InsertNextValue(0);
  labels->InsertNextValue(1);
  labels->InsertNextValue(2);
  labels->Modified();
  expect(colourOf(0), 0, 255, 0, "the first cell of a point that has two");
  expect(colourOf(1), 255, 0, 0, "a point's only cell");
  expect(colourOf(2), 0, 0, 0, "a point without a cell is not there");

  vtkNew<vtkIntArray> few;
  few->InsertNextValue(3);
  data->GetCellData()->SetScalars(few);
  expect(colourOf(1), 255, 255, 0, "an array that is too short");
  expect(colourOf(0), 255, 255, 255, "of cells that it does not have");

  // Field data: a tuple a cell, or one of them for all, as on meshes.
  labels->SetName("field");
  data->GetCellData()->SetScalars(nullptr);
  data->GetFieldData()->AddArray(labels);
  auto field = [](int tuple) {
    return [tuple](Window&, vtkActor* actor) {
      actor->GetMapper()->SetScalarModeToUseFieldData();
      actor->GetMapper()->SelectColorArray("field");
      actor->GetMapper()->SetFieldDataTupleId(tuple);
    };
  };
  expect(colourOf(0, field(-1)), 0, 255, 0, "field data, a tuple a cell");
  expect(colourOf(0, field(2)), 0, 0, 255, "field data, one tuple for all");
  expect(colourOf(1, field(2)), 0, 0, 255, "field data, one tuple for all");

  // Cells that change while their scalars stay.
  data->GetFieldData()->Initialize();
  data->GetCellData()->SetScalars(labels);
  Window window;
  vtkNew<Mapper> mapper;
  mapper->SetInputData(data);
  mapper->SetLookupTable(Saturated());
  mapper->SetScalarRange(0, 4);
  Unlit(window.Add(mapper));
  window.Renderer->ResetCamera();
  const Picture before = window.Draw();
  vtkNew<vtkCellArray> turned;
  turned->InsertNextCell({ 0 });
  turned->InsertNextCell({ 1 });
  turned->InsertNextCell({ 2 });
  data->SetVerts(turned);
  checks.AtLeast(LargestDifference(before, window.Draw()), 255, "other cells: difference");
}

/// Field data on a mesh and on its points.
void TestFieldData(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(150);
  vtkSmartPointer<vtkIntArray> labels = LabelsOfCells(mesh);
  mesh->GetFieldData()->AddArray(labels);
  vtkSmartPointer<vtkPolyData> surface = Cloud(mesh);
  surface->SetPolys(mesh->GetPolys());
  surface->GetFieldData()->AddArray(labels);
  for (const int tuple : { -1, 0, 5000 })
  {
    const Change change = [&](Window&, vtkActor* actor) {
      actor->GetMapper()->SetScalarModeToUseFieldData();
      actor->GetMapper()->SelectColorArray("labels");
      actor->GetMapper()->SetFieldDataTupleId(tuple);
    };
    checks.AtMost(ShareOfDifferent(Draw(mesh, nullptr, change), Draw(surface, &Ways[0], change)),
      0.04, "field data, tuple " + std::to_string(tuple) + ": pixels not as on the mesh");
  }
}

/// Beside a cloud with values and one with colours; and layers behind the first.
void TestTogether(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(150);
  mesh->GetCellData()->SetScalars(LabelsOfCells(mesh));
  vtkSmartPointer<vtkPolyData> surface = Cloud(mesh);
  surface->SetPolys(mesh->GetPolys());
  surface->GetCellData()->SetScalars(mesh->GetCellData()->GetScalars());
  const Change translucent = [](Window& window, vtkActor* actor) {
    actor->GetProperty()->SetOpacity(0.5);
    window.Renderer->UseDepthPeelingOn();
    window.Renderer->SetMaximumNumberOfPeels(8);
    window.Renderer->SetOcclusionRatio(0.0);
    window.Win->AlphaBitPlanesOn();
  };
  const Picture wanted = Draw(mesh, nullptr, translucent);
  for (const Way& way : Ways)
  {
    if (way.Method == Mapper::TWO_PASS || way.Method == Mapper::AUTOMATIC_METHOD)
    {
      // Borders of patches are in both layers.
      checks.AtLeast(Psnr(wanted, Draw(surface, &way, translucent)), 20.0,
        std::string(way.Name) + ", two layers: psnr");
    }
    Picture pictures[3];
    for (int kind = 0; kind < 3; ++kind) // values alone, cells alone, both
    {
      Window window;
      for (int side = 0; side < 2; ++side)
      {
        vtkNew<vtkPolyData> moved;
        moved->DeepCopy(surface);
        for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
        {
          double p[3];
          moved->GetPoint(i, p);
          moved->GetPoints()->SetPoint(i, 0.4 * p[0] + (side ? 0.3 : -0.3), 0.4 * p[1], 0.4 * p[2]);
        }
        vtkNew<vtkDoubleArray> heights;
        for (vtkIdType i = 0; side == 0 && i < moved->GetNumberOfPoints(); ++i)
        {
          heights->InsertNextValue(10.0 * moved->GetPoint(i)[1] + 2.0);
        }
        moved->GetPointData()->SetScalars(side == 0 ? heights.Get() : nullptr);
        vtkNew<Mapper> mapper;
        mapper->SetMethod(way.Method);
        mapper->SetProjection(way.Projection);
        mapper->AntiAliasingOff();
        mapper->SetInputData(moved);
        mapper->SetLookupTable(Saturated());
        mapper->SetScalarRange(0, 4);
        mapper->InterpolateScalarsBeforeMappingOn();
        vtkActor* actor = window.Add(mapper);
        Unlit(actor);
        actor->SetVisibility(kind == 2 || kind == side);
      }
      window.Renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
      pictures[kind] = window.Draw();
    }
    checks.AtMost(CountOffTable(pictures[2], Saturated()), 0,
      std::string(way.Name) + ", values and cells: pixels off the table");
    int wrong = 0;
    for (size_t i = 0; i < pictures[0].Pixels.size(); ++i)
    {
      wrong += std::abs(
        pictures[0].Pixels[i] + pictures[1].Pixels[i] - int(pictures[2].Pixels[i])) > 1;
    }
    checks.AtMost(wrong, way.Method == Mapper::DEFERRED ? 40 : 0,
      std::string(way.Name) + ", values and cells: channels not as of each alone");
  }
}

void TestCellNormals(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> cloud = WithVertices(RandomSphere(500));
  cloud->GetCellData()->SetNormals(cloud->GetPointData()->GetNormals());
  cloud->GetPointData()->SetNormals(nullptr);
  cloud->GetPointData()->Initialize();
  int warnings = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&warnings);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  Window window;
  vtkNew<Mapper> mapper;
  mapper->AddObserver(vtkCommand::WarningEvent, count);
  mapper->SetInputData(cloud);
  window.Add(mapper);
  window.Renderer->ResetCamera();
  checks.AtLeast(window.Draw().CountDrawn(), 10000, "cell normals alone: pixels drawn");
  window.Draw();
  checks.AtMost(warnings, 1, "cell normals alone: warnings");
  checks.AtLeast(warnings, 1, "cell normals alone: warnings");
}
}

int TestSplatsCells(int, char*[])
{
  Checks checks;
  TestWays(checks);
  TestEveryCell(checks);
  TestKindsOfCells(checks);
  TestWhichCell(checks);
  TestFieldData(checks);
  TestTogether(checks);
  TestCellNormals(checks);
  return checks.Result();
}
