// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// InterpolateScalarsBeforeMapping: values are blended and then mapped, as on a mesh with the same
// flag, and no colour appears that the table has not.
#include "SplatPassChain.h"
#include "SplatTables.h"

#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"

#include <limits>

namespace
{
using namespace SplatScene;
using Change = std::function<void(Window&, vtkActor*)>;

// dB: what the issue of colours by value is held to.
constexpr double LeastPsnr = 38.0;

/// A wave of about a quarter of the sphere's girth, from 0.1 to 2.1.
double Wave(const double p[3])
{
  return 1.1 + std::sin(7.0 * p[0]) * std::cos(6.0 * p[1] + 2.0 * p[2]);
}

void AddArrays(vtkPolyData* mesh)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    const double wave = Wave(p);
    values->InsertNextValue(wave);
    vectors->InsertNextTuple3(wave, 1.0 - wave, 0.5);
  }
  mesh->GetPointData()->SetScalars(values);
  mesh->GetPointData()->AddArray(vectors);
}

vtkSmartPointer<vtkPolyData> MakeMesh(int resolution = 300)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(resolution);
  AddArrays(mesh);
  return mesh;
}

/// Larger than the window, with points closer than pixels: what points of one pixel are made for.
vtkSmartPointer<vtkPolyData> MakeSheet()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(600, 600);
  plane->Update();
  vtkSmartPointer<vtkPolyData> mesh = plane->GetOutput();
  AddArrays(mesh);
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeCloud(vtkPolyData* mesh)
{
  vtkSmartPointer<vtkPolyData> cloud = Estimated(Cloud(mesh));
  cloud->GetPointData()->SetScalars(mesh->GetPointData()->GetScalars());
  cloud->GetPointData()->AddArray(mesh->GetPointData()->GetArray("vectors"));
  return cloud;
}

struct Surface
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Cloud;

  explicit Surface(vtkPolyData* mesh)
    : Mesh(mesh)
    , Cloud(MakeCloud(mesh))
  {
  }
};

vtkSmartPointer<vtkPolyDataMapper> MakeMapper(vtkPolyData* data, const Way* way)
{
  vtkSmartPointer<vtkPolyDataMapper> mapper;
  if (way)
  {
    vtkNew<Mapper> splats;
    splats->SetMethod(way->Method);
    splats->SetProjection(way->Projection);
    mapper = splats;
  }
  else
  {
    mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  }
  mapper->SetInputData(data);
  mapper->InterpolateScalarsBeforeMappingOn();
  mapper->SetScalarRange(0.1, 2.1);
  return mapper;
}

/// The mesh's picture without a way.
Picture Draw(vtkPolyData* data, const Way* way, const Change& change)
{
  Window window;
  vtkSmartPointer<vtkPolyDataMapper> mapper = MakeMapper(data, way);
  vtkActor* actor = window.Add(mapper);
  window.Renderer->ResetCamera();
  change(window, actor);
  window.Renderer->ResetCameraClippingRange();
  return window.Draw();
}

void Compare(
  Checks& checks, const Surface& sphere, const std::string& name, const Change& change)
{
  const Picture wanted = Draw(sphere.Mesh, nullptr, change);
  for (const Way& way : Ways)
  {
    if (way.Method != Mapper::IMAGE_SPACE)
    {
      checks.AtLeast(Psnr(wanted, Draw(sphere.Cloud, &way, change)), LeastPsnr,
        name + ", " + way.Name + ": psnr");
    }
  }
}

void CompareSheets(
  Checks& checks, const Surface& sheet, const std::string& name, const Change& change)
{
  const Change zoomed = [&](Window& window, vtkActor* actor) {
    change(window, actor);
    window.Renderer->GetActiveCamera()->Zoom(2.2);
  };
  const Picture wanted = Draw(sheet.Mesh, nullptr, zoomed);
  checks.AtLeast(wanted.CountDrawn(), Size * Size, name + ": pixels of the sheet");
  for (const Way& way : Ways)
  {
    checks.AtLeast(Psnr(wanted, Draw(sheet.Cloud, &way, zoomed)), LeastPsnr,
      name + " on a sheet, " + way.Name + ": psnr");
  }
}

void TestTables(Checks& checks)
{
  const Surface sphere(MakeMesh());
  const Surface sheet(MakeSheet());
  Compare(checks, sphere, "smooth table", [](Window&, vtkActor*) {});
  CompareSheets(checks, sheet, "smooth table", [](Window&, vtkActor*) {});
  Compare(checks, sphere, "colour transfer function", [](Window&, vtkActor* actor) {
    vtkNew<vtkDiscretizableColorTransferFunction> function;
    function->AddRGBPoint(0.1, 0.1, 0.1, 1.0);
    function->AddRGBPoint(0.8, 0.9, 0.9, 0.9);
    function->AddRGBPoint(2.1, 1.0, 0.1, 0.1);
    function->DiscretizeOff();
    function->Build();
    actor->GetMapper()->SetLookupTable(function);
  });
  Compare(checks, sphere, "logarithm", [](Window&, vtkActor* actor) {
    vtkNew<vtkLookupTable> table;
    table->SetScaleToLog10();
    actor->GetMapper()->SetLookupTable(table);
  });
  Compare(checks, sphere, "magnitude of vectors", [](Window&, vtkActor* actor) {
    vtkNew<vtkLookupTable> table;
    table->SetVectorModeToMagnitude();
    actor->GetMapper()->SetLookupTable(table);
    actor->GetMapper()->SetScalarModeToUsePointFieldData();
    actor->GetMapper()->SelectColorArray("vectors");
    actor->GetMapper()->SetScalarRange(0.5, 2.5);
  });
  Compare(checks, sphere, "below and above the range", [](Window&, vtkActor* actor) {
    vtkNew<vtkLookupTable> table;
    table->SetHueRange(0.2, 0.5);
    table->UseBelowRangeColorOn();
    table->SetBelowRangeColor(0.6, 0.9, 0.1, 1.0);
    table->UseAboveRangeColorOn();
    table->SetAboveRangeColor(0.2, 0.9, 0.8, 1.0);
    actor->GetMapper()->SetLookupTable(table);
    actor->GetMapper()->SetScalarRange(0.8, 1.4);
  });
  // Of the lightness alone: what eight bits of a value cannot tell apart are sixteen entries.
  const Change bands = [](Window&, vtkActor* actor) {
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(4096);
    for (int i = 0; i < 4096; ++i)
    {
      const double grey = 0.5 + 0.4 * std::sin(i * 2.0 * vtkMath::Pi() / 1024.0);
      table->SetTableValue(i, grey, grey, grey);
    }
    actor->GetMapper()->SetLookupTable(table);
  };
  Compare(checks, sphere, "4096 grey bands", bands);
  CompareSheets(checks, sheet, "4096 grey bands", bands);
  // Few entries of a range a hundred times as wide as the table's.
  Compare(checks, sphere, "narrow range", [](Window&, vtkActor* actor) {
    actor->GetMapper()->SetScalarRange(1.09, 1.11);
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(2);
    table->SetTableValue(0, 0.4, 0.5, 0.6);
    table->SetTableValue(1, 0.6, 0.5, 0.4);
    actor->GetMapper()->SetLookupTable(table);
  });
}

void TestOnTable(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh(120);
  vtkSmartPointer<vtkPolyData> cloud = MakeCloud(mesh);
  vtkSmartPointer<vtkLookupTable> table = Saturated();
  for (const Way& way : Ways)
  {
    for (const double zoom : { 1.0, 4.0 })
    {
      const Picture picture = Draw(cloud, &way, [&](Window& window, vtkActor* actor) {
        actor->GetMapper()->SetLookupTable(table);
        Mapper::SafeDownCast(actor->GetMapper())->SetAntiAliasing(false);
        Unlit(actor);
        window.Renderer->GetActiveCamera()->Zoom(zoom);
      });
      // Bands end where they do on the mesh; points of one pixel are too far apart for that here.
      if (way.Method != Mapper::IMAGE_SPACE)
      {
        const Picture wanted = Draw(mesh, nullptr, [&](Window& window, vtkActor* actor) {
          actor->GetMapper()->SetLookupTable(table);
          Unlit(actor);
          window.Renderer->GetActiveCamera()->Zoom(zoom);
        });
        int different = 0;
        for (size_t i = 0; i < wanted.Pixels.size(); i += 3)
        {
          different += !std::equal(&wanted.Pixels[i], &wanted.Pixels[i] + 3, &picture.Pixels[i]);
        }
        checks.AtMost(double(different) / wanted.CountDrawn(), 0.03,
          std::string(way.Name) + ": share of pixels that differ from the mesh's");
      }
      const std::string label = std::string(way.Name) + ", zoomed " + std::to_string(zoom);
      checks.AtMost(CountOffTable(picture, table), 0, label + ": pixels off the table");
      checks.AtLeast(picture.CountDrawn(), 20000, label + ": pixels drawn");
    }
  }
}

/// Values at the very ends of the range belong to it.
void TestEnds(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> cloud = MakeCloud(MakeMesh(120));
  vtkNew<vtkDoubleArray> ends;
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    ends->InsertNextValue(cloud->GetPoint(i)[0] < 0.0 ? 0.1 : 2.1);
  }
  cloud->GetPointData()->SetScalars(ends);
  for (const int entries : { 2, 7, 100, 1000 })
  {
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(entries);
    for (int i = 0; i < entries; ++i)
    {
      table->SetTableValue(i, i < entries / 2 ? 1 : 0, 0, i < entries / 2 ? 0 : 1);
    }
    table->UseBelowRangeColorOn();
    table->SetBelowRangeColor(0, 1, 0, 1);
    table->UseAboveRangeColorOn();
    table->SetAboveRangeColor(1, 1, 0, 1);
    for (const Way& way : Ways)
    {
      const Picture picture = Draw(cloud, &way, [&](Window&, vtkActor* actor) {
        actor->GetMapper()->SetLookupTable(table);
        Mapper::SafeDownCast(actor->GetMapper())->SetAntiAliasing(false);
        Unlit(actor);
      });
      checks.AtMost(CountOffTable(picture, table), 0,
        std::string(way.Name) + ": pixels beyond a range of " + std::to_string(entries));
    }
  }
}

void TestNan(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> cloud = MakeCloud(MakeMesh(120));
  vtkSmartPointer<vtkPolyData> spoilt = MakeCloud(MakeMesh(120));
  auto values = vtkDoubleArray::SafeDownCast(spoilt->GetPointData()->GetScalars());
  double p[3] = { 0.25, 0.25, 0.35 };
  const vtkIdType one = spoilt->FindPoint(p);
  values->SetValue(one, std::numeric_limits<double>::quiet_NaN());
  vtkSmartPointer<vtkLookupTable> table = Saturated();
  for (const Way& way : Ways)
  {
    const Change change = [&](Window&, vtkActor* actor) {
      actor->GetMapper()->SetLookupTable(table);
      Mapper::SafeDownCast(actor->GetMapper())->SetAntiAliasing(false);
      Unlit(actor);
    };
    const Picture good = Draw(cloud, &way, change);
    const Picture bad = Draw(spoilt, &way, change);
    int white = 0;
    int others = 0;
    for (size_t i = 0; i < good.Pixels.size(); i += 3)
    {
      const bool isWhite =
        bad.Pixels[i] == 255 && bad.Pixels[i + 1] == 255 && bad.Pixels[i + 2] == 255;
      white += isWhite;
      others += !isWhite &&
        !std::equal(&good.Pixels[i], &good.Pixels[i] + 3, &bad.Pixels[i]);
    }
    checks.AtLeast(white, 1, std::string(way.Name) + ": pixels of a NaN");
    checks.AtMost(white, 60, std::string(way.Name) + ": pixels of a NaN");
    checks.AtMost(others, 8, std::string(way.Name) + ": pixels about it");
    checks.AtMost(CountOffTable(bad, table), 0, std::string(way.Name) + ": off the table");
  }
}

/// The half of a sphere to one side, with the same radii everywhere.
vtkSmartPointer<vtkPolyData> Half(double side)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh(120);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    p[0] = 0.4 * p[0] + 0.3 * side;
    mesh->GetPoints()->SetPoint(i, p);
  }
  return MakeCloud(mesh);
}

/// Clouds with other tables, and without the flag, beside one another: each as if alone.
void TestSeveral(Checks& checks)
{
  vtkNew<vtkLookupTable> grey;
  grey->SetHueRange(0.0, 0.0);
  grey->SetSaturationRange(0.0, 0.0);
  grey->SetValueRange(0.3, 1.0);
  const vtkSmartPointer<vtkPolyData> halves[] = { Half(-1.0), Half(1.0) };
  for (const bool flag : { false, true })
  {
    for (const Way& way : Ways)
    {
      Picture pictures[3];
      for (int shown = 0; shown < 3; ++shown) // the left one, the right one, both
      {
        Window window;
        for (int side = 0; side < 2; ++side)
        {
          vtkSmartPointer<vtkPolyDataMapper> mapper = MakeMapper(halves[side], &way);
          mapper->SetLookupTable(side == 0 ? Saturated().Get() : grey.Get());
          mapper->SetInterpolateScalarsBeforeMapping(side == 0 || flag);
          vtkActor* actor = window.Add(mapper);
          Mapper::SafeDownCast(mapper)->SetAntiAliasing(false);
          actor->SetVisibility(shown == 2 || shown == side);
        }
        window.Renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
        pictures[shown] = window.Draw();
      }
      int wrong = 0;
      for (int y = 0; y < Size; ++y)
      {
        for (int x = 0; x < Size; ++x)
        {
          const Picture& own = pictures[pictures[0].IsBackground(x, y) ? 1 : 0];
          for (int c = 0; c < 3; ++c)
          {
            wrong += std::abs(own.At(x, y)[c] - pictures[2].At(x, y)[c]) > 1;
          }
        }
      }
      checks.AtMost(wrong, way.Method == Mapper::DEFERRED ? 40 : 0,
        std::string(way.Name) + (flag ? ", two tables" : ", one without the flag") +
          ": channels that differ");
      checks.AtLeast(pictures[2].CountDrawn(), 10000, "pixels of two clouds");
    }
  }
}

/// A table whose opacity goes with the value, by each way through translucent layers.
void TestTranslucent(Checks& checks)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(64);
  for (int i = 0; i < 64; ++i)
  {
    table->SetTableValue(i, i / 63.0, 0.5, 1.0 - i / 63.0, 0.2 + 0.6 * i / 63.0);
  }
  auto change = [&](Window& window, vtkActor* actor) {
    actor->GetMapper()->SetLookupTable(table);
    window.Renderer->UseDepthPeelingOn();
    window.Renderer->SetMaximumNumberOfPeels(8);
    window.Renderer->SetOcclusionRatio(0.0);
    window.Win->AlphaBitPlanesOn();
  };
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  vtkSmartPointer<vtkPolyData> cloud = MakeCloud(mesh);
  const Picture wanted = Draw(mesh, nullptr, change);
  // Points of one pixel at 1.3 pixels' distance.
  const double leastOfPoints = 32.0;
  for (const Way& way : Ways)
  {
    const double least = way.Method == Mapper::IMAGE_SPACE ? leastOfPoints : LeastPsnr;
    if (way.Method != Mapper::DEFERRED)
    {
      checks.AtLeast(Psnr(wanted, Draw(cloud, &way, change)), least,
        std::string("peeled, ") + way.Name + ": psnr");
      // The last layer has all: here there is one, which is the mean of both.
      for (const int layers : { 1, 2 })
      {
        const Picture gathered = Draw(cloud, &way, [&](Window& window, vtkActor* actor) {
          change(window, actor);
          window.Renderer->UseDepthPeelingOff();
          auto mapper = Mapper::SafeDownCast(actor->GetMapper());
          mapper->SetTransparencyToPeeling();
          mapper->SetMaximumNumberOfLayers(layers);
          mapper->SetGatherRemaining(true);
        });
        checks.AtLeast(Psnr(wanted, gathered), layers == 1 ? 21.0 : least,
          std::string("gathered into ") + std::to_string(layers) + ", " + way.Name + ": psnr");
      }
    }
  }
  for (const int transparency : { Mapper::SORTED, Mapper::NEAREST_EXACT })
  {
    const Picture sorted = Draw(cloud, &Ways[0], [&](Window& window, vtkActor* actor) {
      change(window, actor);
      window.Renderer->UseDepthPeelingOff();
      Mapper::SafeDownCast(actor->GetMapper())->SetTransparency(transparency);
    });
    checks.AtLeast(Psnr(wanted, sorted), 30.0,
      transparency == Mapper::SORTED ? "sorted: psnr" : "nearest exact: psnr");
  }
}

/// What vtkMapper has no texture for is drawn as without the flag; and the flag can be changed.
void TestOthers(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> cloud = MakeCloud(MakeMesh(120));
  auto both = [&](const std::string& name, const Change& change) {
    const Picture on = Draw(cloud, &Ways[0], change);
    const Picture off = Draw(cloud, &Ways[0], [&](Window& window, vtkActor* actor) {
      change(window, actor);
      actor->GetMapper()->InterpolateScalarsBeforeMappingOff();
    });
    checks.AtMost(LargestDifference(on, off), 0, name + ": the flag's difference");
    checks.AtLeast(on.CountDrawn(), 20000, name + ": pixels drawn");
  };
  both("indexed lookup", [](Window&, vtkActor* actor) {
    vtkSmartPointer<vtkLookupTable> table = Saturated();
    table->IndexedLookupOn();
    table->SetAnnotation(vtkVariant(1.1), "middle");
    actor->GetMapper()->SetLookupTable(table);
  });
  both("a component that is not there", [](Window&, vtkActor* actor) {
    vtkNew<vtkLookupTable> table;
    table->SetVectorModeToComponent();
    table->SetVectorComponent(2);
    actor->GetMapper()->SetLookupTable(table);
  });
  both("no scalars", [](Window&, vtkActor* actor) { actor->GetMapper()->ScalarVisibilityOff(); });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud);
  blocks->SetBlock(1, Cloud(MakeSphereMesh(60)));
  both("a block without scalars", [&](Window&, vtkActor* actor) {
    actor->GetMapper()->SetInputDataObject(blocks);
  });

  // On, off, on again, and a pass in the place of the mapper's own frame.
  Window window;
  vtkActor* actor = window.Add(MakeMapper(cloud, &Ways[0]));
  actor->GetMapper()->SetLookupTable(Saturated());
  window.Renderer->ResetCamera();
  const Picture on = window.Draw();
  actor->GetMapper()->InterpolateScalarsBeforeMappingOff();
  checks.AtLeast(LargestDifference(on, window.Draw()), 50, "switched off");
  actor->GetMapper()->InterpolateScalarsBeforeMappingOn();
  checks.AtMost(LargestDifference(on, window.Draw()), 0, "switched on again");
  DrawByPass(window);
  checks.AtMost(LargestDifference(on, window.Draw()), 1, "by vtkPointSplatPass");
}
}

int TestSplatsValues(int, char*[])
{
  Checks checks;
  TestTables(checks);
  TestOnTable(checks);
  TestEnds(checks);
  TestNan(checks);
  TestSeveral(checks);
  TestTranslucent(checks);
  TestOthers(checks);
  return checks.Result();
}
