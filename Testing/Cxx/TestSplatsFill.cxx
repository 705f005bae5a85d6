// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A disc whose rim is dense and whose faces are sparse looks like its fine mesh: fill points lie between its points,
// with their colours, values, textures and numbers, but in image space, which estimates no sizes.
#include "PickedPoints.h"
#include "RimmedDisc.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTexture.h"

#include <functional>
#include <string>

namespace
{
using namespace SplatScene;
using Mapper = vtkPointSplatMapper;
using Change = std::function<void(vtkPolyDataMapper*, vtkActor*)>;

constexpr double Rim = 0.1;

/// Values and texture coordinates go along x and y, so that a mesh of any fineness has the same.
vtkSmartPointer<vtkPolyData> AddFields(vtkSmartPointer<vtkPolyData> data)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  vtkNew<vtkFloatArray> places;
  places->SetName("places");
  places->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    values->InsertNextValue(x[0] + 0.5 * x[1]);
    places->InsertNextTuple2(0.5 + 0.4 * x[0], 0.5 + 0.4 * x[1]);
  }
  data->GetPointData()->SetScalars(values);
  data->GetPointData()->SetTCoords(places);
  return data;
}

vtkSmartPointer<vtkPolyData> MakeMesh(const RimmedDisc::Sampling& sampling)
{
  return AddFields(RimmedDisc(Rim).MakeMesh(sampling));
}

vtkSmartPointer<vtkPolyData> MakeCloud()
{
  return AddFields(Cloud(RimmedDisc(Rim).MakeMesh(RimmedDisc::Coarse)));
}

struct View
{
  double Elevation, Azimuth;
  const char* Name;
};
constexpr View Views[] = { { -50, 20, "aslant" }, { 0, 0, "above" }, { -80, 0, "aside" } };

Picture Draw(vtkPolyDataMapper* mapper, const View& view, const Change& change)
{
  Window window;
  mapper->ScalarVisibilityOff();
  vtkActor* actor = window.Add(mapper);
  window.Renderer->UseDepthPeelingOn(); // for the mesh's layers to be sorted
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  window.Renderer->ResetCamera();
  camera->Elevation(view.Elevation);
  camera->Azimuth(view.Azimuth);
  window.Renderer->ResetCamera();
  camera->Zoom(1.4);
  if (change)
  {
    change(mapper, actor);
  }
  window.Renderer->ResetCameraClippingRange();
  return window.Draw();
}

Picture DrawMesh(const View& view, const Change& change)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeMesh(RimmedDisc::Fine));
  return Draw(mapper, view, change);
}

Picture DrawSplats(vtkPolyData* data, const View& view, const Change& change)
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(data);
  return Draw(mapper, view, change);
}

/// The least likeness to the fine mesh; without fill points it is worse by some.
void Compare(Checks& checks, const std::string& name, double least, const Change& change)
{
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud();
  for (const View& view : Views)
  {
    const std::string label = name + ", " + view.Name;
    const Picture mesh = DrawMesh(view, change);
    const double with = Psnr(mesh, DrawSplats(cloud, view, change));
    const double without = Psnr(mesh,
      DrawSplats(cloud, view, [&change](vtkPolyDataMapper* mapper, vtkActor* actor) {
        Mapper::SafeDownCast(mapper)->FillGapsOff();
        change(mapper, actor);
      }));
    checks.AtLeast(with, least, label);
    checks.AtMost(without, with - 8.0, label + ", without fill points");
  }
}

void CompareMethods(Checks& checks)
{
  const auto splats = [](const std::function<void(Mapper*)>& set) {
    return [set](vtkPolyDataMapper* mapper, vtkActor*) {
      if (Mapper* own = Mapper::SafeDownCast(mapper))
      {
        set(own);
      }
    };
  };
  Compare(checks, "by itself", 44.0, [](vtkPolyDataMapper*, vtkActor*) {});
  Compare(checks, "quads", 44.0, splats([](Mapper* m) { m->SetProjection(Mapper::QUADS); }));
  Compare(checks, "two passes", 44.0, splats([](Mapper* m) { m->SetMethodToTwoPass(); }));
  Compare(checks, "translucent", 42.0,
    [](vtkPolyDataMapper*, vtkActor* actor) { actor->GetProperty()->SetOpacity(0.5); });
}

/// Between points mapped colours blend; with a fine mesh's, that has many more points on its faces, they agree less.
void CompareColours(Checks& checks)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(8);
  table->Build();
  for (const bool byValue : { false, true })
  {
    Compare(checks, byValue ? "values" : "colours", byValue ? 24.0 : 29.0,
      [&](vtkPolyDataMapper* mapper, vtkActor*) {
        mapper->ScalarVisibilityOn();
        mapper->SetScalarRange(-1.2, 1.2);
        mapper->SetInterpolateScalarsBeforeMapping(byValue);
        if (byValue)
        {
          mapper->SetLookupTable(table);
        }
      });
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = static_cast<unsigned char>(4 * x);
      pixel[1] = static_cast<unsigned char>(128 + 100 * std::sin(0.3 * y));
      pixel[2] = 60;
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  Compare(checks, "texture", 38.0, [&](vtkPolyDataMapper*, vtkActor* actor) {
    actor->GetProperty()->SetColor(1, 1, 1);
    actor->SetTexture(texture);
  });
}

/// Picked points are the input's, and no farther from the pixel than the faces' points are apart.
void TestPicking(Checks& checks)
{
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud();
  vtkNew<Mapper> mapper;
  mapper->SetInputData(cloud);
  mapper->ScalarVisibilityOff();
  Window window;
  window.Add(mapper);
  window.Renderer->ResetCamera();
  window.Draw();
  int picked = 0;
  const double farthest = FarthestPicked(window, cloud, picked);
  checks.AtLeast(picked, 20000, "pixels that show a point");
  const std::vector<PickedPoint> all = PickPoints(window);
  vtkIdType largest = 0;
  for (const PickedPoint& point : all)
  {
    largest = std::max(largest, point.Point);
  }
  checks.AtMost(largest, cloud->GetNumberOfPoints() - 1, "largest number of a point");
  // Pixels: rings are a third of the radius apart.
  checks.AtMost(farthest, 0.25 * Size, "the picked points' distance");
}

void TestWhere(Checks& checks)
{
  const View view = Views[0];
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud();
  const Picture filled = DrawSplats(cloud, view, {});
  const Picture mesh = DrawMesh(view, {});

  // Groups are the input's: what it says of its points does not say it of others.
  vtkSmartPointer<vtkPolyData> grouped = MakeCloud();
  vtkNew<vtkIntArray> groups;
  groups->SetName("SplatGroup");
  groups->SetNumberOfTuples(grouped->GetNumberOfPoints());
  groups->Fill(0);
  grouped->GetPointData()->AddArray(groups);
  const Change off = [](vtkPolyDataMapper* mapper, vtkActor*) {
    Mapper::SafeDownCast(mapper)->FillGapsOff();
  };
  checks.AtMost(LargestDifference(DrawSplats(grouped, view, {}), DrawSplats(grouped, view, off)), 0,
    "with groups given there are no fill points");

  // Triangles that are drawn as such need none.
  const vtkSmartPointer<vtkPolyData> triangles = MakeMesh(RimmedDisc::Coarse);
  checks.AtLeast(Psnr(mesh, DrawSplats(triangles, view, {})), 38.0, "a mesh's splats");
  checks.AtLeast(Psnr(mesh,
                   DrawSplats(triangles, view,
                     [](vtkPolyDataMapper* mapper, vtkActor*) {
                       Mapper::SafeDownCast(mapper)->SetHybrid(Mapper::AUTOMATIC_HYBRID);
                     })),
    38.0, "splats and triangles");

  // The switch works both ways in one window, and tells what is drawn.
  Window window;
  vtkNew<Mapper> mapper;
  mapper->SetInputData(cloud);
  mapper->ScalarVisibilityOff();
  window.Add(mapper);
  window.Renderer->ResetCamera();
  const Picture first = window.Draw();
  const vtkIdType with = mapper->GetNumberOfPointsProjected();
  mapper->FillGapsOff();
  const Picture second = window.Draw();
  const vtkIdType without = mapper->GetNumberOfPointsProjected();
  mapper->FillGapsOn();
  checks.AtMost(LargestDifference(first, window.Draw()), 0, "on again");
  checks.AtLeast(LargestDifference(first, second), 50, "switched off");
  checks.AtMost(without, cloud->GetNumberOfPoints(), "splats without fill points");
  checks.AtLeast(with, without + 1000, "splats with fill points");

  // As blocks, of which one has other points than the rest, and no values.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud);
  blocks->SetBlock(1, Moved(RandomSphere(10), 1.0, 10.0)); // what meets the cloud would be a piece of it
  Window both;
  vtkNew<Mapper> composite;
  composite->SetInputDataObject(blocks);
  composite->ScalarVisibilityOff();
  both.Add(composite);
  both.Renderer->GetActiveCamera()->DeepCopy(window.Renderer->GetActiveCamera());
  composite->SetBlockVisibility(2, false);
  checks.AtMost(LargestDifference(first, both.Draw()), 2, "as a block");
  checks.AtLeast(Psnr(mesh, filled), 38.0, "alone");
}
}

int TestSplatsFill(int, char*[])
{
  Checks checks;
  CompareMethods(checks);
  CompareColours(checks);
  TestPicking(checks);
  TestWhere(checks);
  return checks.Result();
}
