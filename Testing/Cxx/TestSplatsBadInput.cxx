// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Bad input, kind by kind: nothing crashes or hangs, what is good beside it is drawn
// as ever, and what is left out is reported once.
#include "SplatScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkStringArray.h"

#include <limits>
#include <set>

namespace
{
using namespace SplatScene;

constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Messages
{
  int Errors = 0;
  int Warnings = 0;
  static void Count(vtkObject*, unsigned long event, void* self, void*)
  {
    ++(event == vtkCommand::ErrorEvent ? static_cast<Messages*>(self)->Errors
                                       : static_cast<Messages*>(self)->Warnings);
  }
  void Watch(vtkObject* object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(Messages::Count);
    command->SetClientData(this);
    object->AddObserver(vtkCommand::ErrorEvent, command);
    object->AddObserver(vtkCommand::WarningEvent, command);
  }
};

/**
 * A good square of splats, or one to spoil.
 */
vtkSmartPointer<vtkPolyData> Grid(bool radii)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radius;
  radius->SetName("SplatRadius");
  for (int y = 0; y < 40; ++y)
  {
    for (int x = 0; x < 40; ++x)
    {
      points->InsertNextPoint(x, y, 0.0);
      normals->InsertNextTuple3(0, 0, 1);
      radius->InsertNextValue(0.75f);
    }
  }
  auto grid = vtkSmartPointer<vtkPolyData>::New();
  grid->SetPoints(points);
  grid->GetPointData()->SetNormals(normals);
  if (radii)
  {
    grid->GetPointData()->AddArray(radius);
  }
  return grid;
}

/**
 * Appends a point; radius is left out where the grid has none.
 */
void Append(vtkPolyData* data, double x, double y, double z, double nx, double ny, double nz,
  double radius = 0.75)
{
  data->GetPoints()->InsertNextPoint(x, y, z);
  data->GetPointData()->GetNormals()->InsertNextTuple3(nx, ny, nz);
  if (vtkDataArray* radii = data->GetPointData()->GetArray("SplatRadius"))
  {
    radii->InsertNextTuple1(radius);
  }
  data->Modified();
}

void LookAtGrid(Window& window)
{
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(19.5, 19.5, 50);
  camera->SetFocalPoint(19.5, 19.5, 0);
  camera->SetParallelScale(24);
  camera->SetClippingRange(10, 100);
}

Picture DrawData(vtkDataObject* data, Messages& messages, vtkIdType* skipped = nullptr)
{
  Window window(200);
  vtkNew<vtkPointSplatMapper> mapper;
  messages.Watch(mapper);
  if (data)
  {
    mapper->SetInputDataObject(data);
  }
  window.Add(mapper);
  LookAtGrid(window);
  window.Draw();
  Picture picture = window.Draw();
  if (skipped)
  {
    *skipped = mapper->GetNumberOfSkippedPoints();
  }
  return picture;
}

/**
 * Bad points beside a good grid: the picture stays, and one warning counts them.
 */
void Spoil(Checks& checks, const std::string& name, bool radii,
  const std::function<int(vtkPolyData*)>& spoil)
{
  Messages none;
  const Picture good = DrawData(Grid(radii), none);
  vtkSmartPointer<vtkPolyData> data = Grid(radii);
  const int bad = spoil(data);
  Messages messages;
  vtkIdType skipped = 0;
  const Picture picture = DrawData(data, messages, &skipped);
  checks.AtLeast(good.CountDrawn(), 20000, name + ": the good picture");
  checks.AtMost(CountDifferentCoverage(good, picture), 0, name + ": changed pixels");
  checks.AtLeast(Psnr(good, picture), 60.0, name + ": psnr beside the good picture");
  checks.Expect(skipped == bad,
    name + ": " + std::to_string(skipped) + " points reported, not " + std::to_string(bad));
  checks.Expect(messages.Warnings == (bad > 0 ? 1 : 0),
    name + ": " + std::to_string(messages.Warnings) + " warnings in two frames");
  checks.AtMost(messages.Errors, 0, name + ": errors");
}
}

int TestSplatsBadInput(int, char*[])
{
  Checks checks;

  for (const bool radii : { true, false })
  {
    const std::string with = radii ? " (radii given)" : " (radii estimated)";
    Spoil(checks, "NaN and infinite coordinates" + with, radii, [](vtkPolyData* d) {
      Append(d, NAN, 1, 1, 0, 0, 1);
      Append(d, 1, Infinity, 1, 0, 0, 1);
      Append(d, 1, 1, -Infinity, 0, 0, 1);
      return 3;
    });
    Spoil(checks, "ghost points" + with, radii, [](vtkPolyData* d) {
      Append(d, 20, 20, 10, 0, 0, 1);
      Append(d, 21, 20, 10, 0, 0, 1);
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      ghosts->SetNumberOfTuples(d->GetNumberOfPoints());
      ghosts->FillValue(0);
      ghosts->SetValue(d->GetNumberOfPoints() - 2, vtkDataSetAttributes::HIDDENPOINT);
      ghosts->SetValue(d->GetNumberOfPoints() - 1, vtkDataSetAttributes::DUPLICATEPOINT);
      d->GetPointData()->AddArray(ghosts);
      return 2;
    });
  }
  Spoil(checks, "zero and NaN normals", true, [](vtkPolyData* d) {
    Append(d, 20, 20, 10, 0, 0, 0);
    Append(d, 21, 20, 10, NAN, 0, 1);
    Append(d, 22, 20, 10, 0, Infinity, 1);
    return 3;
  });
  Spoil(checks, "bad radii", true, [](vtkPolyData* d) {
    Append(d, 20, 20, 10, 0, 0, 1, 0.0);
    Append(d, 21, 20, 10, 0, 0, 1, -1.0);
    Append(d, 22, 20, 10, 0, 0, 1, NAN);
    Append(d, 23, 20, 10, 0, 0, 1, Infinity);
    return 4;
  });
  Spoil(checks, "duplicates", false, [](vtkPolyData* d) {
    for (int i = 0; i < 1000; ++i)
    {
      Append(d, 20, 20, 0, 0, 0, 1);
    }
    return 0;
  });
  Spoil(checks, "double normals, int radii of 1, long normals", true, [](vtkPolyData* d) {
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < d->GetNumberOfPoints(); ++i)
    {
      normals->InsertNextTuple3(0, 0, 1e6);
    }
    d->GetPointData()->SetNormals(normals);
    return 0;
  });

  // No input, and inputs with nothing to draw: black pictures.
  Messages messages;
  checks.AtMost(DrawData(nullptr, messages).CountDrawn(), 0, "no input");
  vtkNew<vtkPolyData> empty;
  Messages silent;
  checks.AtMost(DrawData(empty, silent).CountDrawn(), 0, "no points");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, nullptr);
  blocks->SetBlock(1, empty);
  checks.AtMost(DrawData(blocks, silent).CountDrawn(), 0, "empty blocks");
  checks.AtMost(silent.Errors, 0, "no points: errors");

  // One point, two equal ones, in the middle of a pixel: that is drawn, or few.
  for (const int count : { 1, 2 })
  {
    vtkSmartPointer<vtkPolyData> few = RandomCloud(count, [](double, double, double* p, double* n) {
      p[0] = p[1] = 20.1;
      p[2] = n[0] = n[1] = 0.0;
      n[2] = 1.0;
    });
    const int dot = DrawData(few, silent).CountDrawn();
    checks.AtLeast(dot, 1, "a point or two: drawn");
    checks.AtMost(dot, 9, "a point or two: drawn");
    vtkNew<vtkFloatArray> radius;
    radius->SetName("SplatRadius");
    radius->SetNumberOfTuples(count);
    radius->FillValue(5.0f);
    few->GetPointData()->AddArray(radius);
    const int drawn = DrawData(few, silent).CountDrawn();
    // A disk of radius 5 * 1.15 where 200 pixels are 48.
    checks.AtLeast(drawn, 1300, "a point or two with a radius");
    checks.AtMost(drawn, 2000, "a point or two with a radius");
  }

  // Missing normals are estimated.
  vtkSmartPointer<vtkPolyData> bare = Grid(false);
  bare->GetPointData()->SetNormals(nullptr);
  checks.AtLeast(DrawData(bare, silent).CountDrawn(), 20000, "no normals: drawn");

  // Arrays of the wrong kind are errors that name them, and the rest is drawn.
  vtkSmartPointer<vtkPolyData> wrong = Grid(false);
  vtkNew<vtkFloatArray> three;
  three->SetName("SplatRadius");
  three->SetNumberOfComponents(3);
  three->SetNumberOfTuples(wrong->GetNumberOfPoints());
  three->Fill(1.0);
  wrong->GetPointData()->AddArray(three);
  Messages told;
  checks.AtLeast(DrawData(wrong, told).CountDrawn(), 20000, "radii of 3 components: drawn");
  checks.AtLeast(told.Errors, 1, "radii of 3 components: errors");
  vtkSmartPointer<vtkPolyData> strings = Grid(false);
  vtkNew<vtkStringArray> text;
  text->SetName("SplatRadius");
  text->SetNumberOfTuples(strings->GetNumberOfPoints());
  strings->GetPointData()->AddArray(text);
  checks.AtLeast(DrawData(strings, silent).CountDrawn(), 20000, "radii as strings: drawn");
  vtkSmartPointer<vtkPolyData> brief = Grid(false);
  vtkNew<vtkFloatArray> tooShort;
  tooShort->SetName("SplatRadius");
  tooShort->SetNumberOfTuples(3);
  tooShort->Fill(1.0);
  brief->GetPointData()->AddArray(tooShort);
  Messages toldToo;
  checks.AtLeast(DrawData(brief, toldToo).CountDrawn(), 20000, "too few radii: drawn");
  checks.AtLeast(toldToo.Errors, 1, "too few radii: errors");

  // Numbers of groups that would fill any memory.
  vtkSmartPointer<vtkPolyData> wild = Grid(true);
  vtkNew<vtkDoubleArray> groups;
  groups->SetName("SplatGroup");
  for (vtkIdType i = 0; i < wild->GetNumberOfPoints(); ++i)
  {
    const double numbers[] = { 0.0, 2147483646.0, -5.0, 1e300, NAN };
    groups->InsertNextValue(numbers[i % 5]);
  }
  wild->GetPointData()->AddArray(groups);
  Window deferred(200);
  vtkNew<vtkPointSplatMapper> grouped;
  grouped->SetInputData(wild);
  grouped->SetMethodToDeferred();
  deferred.Add(grouped);
  checks.AtLeast(deferred.Draw().CountDrawn(), 5000, "wild groups: drawn");
  checks.AtLeast(grouped->GetNumberOfGroups(), 1, "wild groups");
  checks.AtMost(grouped->GetNumberOfGroups(), 3, "wild groups");

  // Arrays that can be no colours.
  vtkSmartPointer<vtkPolyData> eight = Grid(true);
  vtkNew<vtkUnsignedCharArray> components;
  components->SetName("eight");
  components->SetNumberOfComponents(8);
  components->SetNumberOfTuples(eight->GetNumberOfPoints());
  components->Fill(100.0);
  eight->GetPointData()->SetScalars(components);
  Messages toldOfColours;
  checks.AtLeast(DrawData(eight, toldOfColours).CountDrawn(), 20000, "8 colour components: drawn");
  checks.AtLeast(toldOfColours.Errors, 1, "8 colour components: errors");
  Window plain(200);
  vtkNew<vtkPointSplatMapper> ofPoints;
  ofPoints->SetInputData(Grid(true));
  vtkProperty* points = plain.Add(ofPoints)->GetProperty();
  points->SetRepresentationToPoints();
  points->SetPointSize(4.0);
  const int drawn = plain.Draw().CountDrawn();
  Messages toldOfPoints;
  toldOfPoints.Watch(ofPoints);
  ofPoints->SetInputData(eight);
  checks.AtLeast(plain.Draw().CountDrawn(), drawn, "8 colour components, as points: drawn");
  checks.AtLeast(toldOfPoints.Errors, 1, "8 colour components, as points: errors");
  vtkSmartPointer<vtkPolyData> few = Grid(true);
  vtkNew<vtkUnsignedCharArray> noGhosts;
  noGhosts->SetName(vtkDataSetAttributes::GhostArrayName());
  few->GetPointData()->AddArray(noGhosts);
  vtkNew<vtkDoubleArray> oneNormal;
  oneNormal->SetNumberOfComponents(3);
  oneNormal->InsertNextTuple3(0.0, 0.0, 1.0);
  few->GetPointData()->SetNormals(oneNormal);
  ofPoints->SetInputData(few);
  checks.AtLeast(plain.Draw().CountDrawn(), drawn, "arrays that are too short, as points: drawn");

  // A translucent actor that draws nothing does not change what others draw.
  Window translucent(200);
  vtkNew<vtkPointSplatMapper> ball;
  ball->SetInputData(RandomSphere(2000));
  translucent.Add(ball)->GetProperty()->SetOpacity(0.5);
  const Picture alone = translucent.Draw();
  vtkNew<vtkPointSplatMapper> nothing;
  nothing->SetInputData(empty);
  translucent.Add(nothing)->GetProperty()->SetOpacity(0.5);
  checks.Expect(translucent.Draw().Pixels == alone.Pixels, "beside an empty translucent actor");

  // Cells of points that are not there, where a selection asks for cells.
  vtkSmartPointer<vtkPolyData> lost = Grid(true);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 100000 });
  verts->InsertNextCell({ 0 });
  lost->SetVerts(verts);
  Window picked(200);
  vtkNew<vtkPointSplatMapper> cellular;
  cellular->SetInputData(lost);
  picked.Add(cellular);
  picked.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(picked.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, 199, 199);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  vtkDataArray* cells = selection->GetNumberOfNodes() == 1
    ? vtkDataArray::SafeDownCast(selection->GetNode(0)->GetSelectionList())
    : nullptr;
  std::set<double> found;
  for (vtkIdType i = 0; cells && i < cells->GetNumberOfTuples(); ++i)
  {
    found.insert(cells->GetTuple1(i));
  }
  checks.Expect(found == std::set<double>{ 1.0 }, "a selection of lost cells");

  // Far coordinates beside near ones: these are drawn as ever where single precision can tell them
  // apart, and others' are whatever one of an actor's points has.
  Messages none;
  const Picture good = DrawData(Grid(true), none);
  vtkSmartPointer<vtkPolyData> far = Grid(true);
  Append(far, 1e7, 0, 0, 0, 0, 1);
  checks.AtMost(CountDifferentCoverage(good, DrawData(far, silent)), 0, "beside a far point");
  vtkSmartPointer<vtkPolyData> huge = Grid(true);
  Append(huge, 1e30, 0, 0, 0, 0, 1);
  Window beside(200);
  Messages left;
  for (const vtkSmartPointer<vtkPolyData>& data : { Grid(true), huge })
  {
    vtkNew<vtkPointSplatMapper> mapper;
    (data == huge ? left : none).Watch(mapper);
    mapper->SetInputData(data);
    beside.Add(mapper);
  }
  LookAtGrid(beside);
  beside.Draw();
  checks.AtLeast(beside.Draw().CountDrawn(), good.CountDrawn(), "beside an actor with huge coordinates");
  checks.AtMost(left.Errors, 0, "huge coordinates: errors");
  checks.Expect(left.Warnings == 1, "huge coordinates: one warning of a point that is left out");
  checks.AtMost(silent.Errors, 0, "errors where there is nothing wrong");
  return checks.Result();
}
