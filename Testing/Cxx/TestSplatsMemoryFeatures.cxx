// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Two thousand frames in which looks change: creases, values, scalars of cells, physically based and flat
// interpolation, points, wireframe, blocks, outlines, parts of a window. The process has no more memory
// and the context no more OpenGL objects after them than after the first.
#include "SplatMemory.h"

#include "vtkCellData.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkSelection.h"
#include "vtkTexture.h"

namespace
{
using namespace SplatScene;

constexpr int Cycle = 40;
constexpr int Interval = 5 * Cycle;
constexpr int Frames = SplatMemory::MeasureMemory ? 4000 + Interval : 3 * Interval;
// KiB in an interval: a hundred bytes a frame.
constexpr long MostGrowth = 20;

/**
 * What is drawn in turns.
 */
struct Cast
{
  vtkSmartPointer<vtkPolyData> Ball;      // with scalars
  vtkSmartPointer<vtkPolyData> Cells;     // with scalars of its triangles
  vtkSmartPointer<vtkPolyData> Cube;      // with creases
  vtkSmartPointer<vtkMultiBlockDataSet> Blocks;
  vtkNew<vtkLight> Lamp;
};

vtkSmartPointer<vtkFloatArray> Values(vtkIdType count)
{
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetName("values");
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->InsertNextValue(static_cast<float>(i) / static_cast<float>(count));
  }
  return values;
}

/// The sides of a cube, points with normals in a grid of their own each.
vtkSmartPointer<vtkPolyData> MakeCube()
{
  return RandomCloud(6 * 144, [count = 0](double, double, double* p, double* n) mutable {
    const int side = count / 144;
    const int at = count++ % 144;
    const int axis = side % 3;
    std::fill_n(n, 3, 0.0);
    n[axis] = side < 3 ? 1.0 : -1.0;
    p[axis] = 0.5 * n[axis];
    p[(axis + 1) % 3] = (at % 12 + 0.5) / 12.0 - 0.5;
    p[(axis + 2) % 3] = (at / 12 + 0.5) / 12.0 - 0.5;
  });
}

void MakeCast(Cast& cast)
{
  cast.Ball = Cloud(MakeSphereMesh(16));
  cast.Ball->GetPointData()->SetScalars(Values(cast.Ball->GetNumberOfPoints()));
  cast.Cells = MakeSphereMesh(16);
  cast.Cells->GetCellData()->SetScalars(Values(cast.Cells->GetNumberOfCells()));
  cast.Cube = MakeCube();
  cast.Blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  cast.Blocks->SetBlock(0, cast.Ball);
  cast.Blocks->SetBlock(1, RandomSphere(100));
  cast.Lamp->SetLightTypeToSceneLight();
  cast.Lamp->SetPosition(3, 2, 4);
  cast.Lamp->PositionalOn();
}

void PrepareImageBasedLighting(vtkRenderer* renderer)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(150.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  renderer->SetEnvironmentTexture(texture);
  auto own = vtkOpenGLRenderer::SafeDownCast(renderer);
  own->GetEnvMapLookupTable()->SetLUTSize(16);
  own->GetEnvMapLookupTable()->SetLUTSamples(16);
  own->GetEnvMapIrradiance()->SetIrradianceSize(8);
  own->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
  own->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(4);
}

void Pick(vtkRenderer* renderer)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(5, 5, 20, 20);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  vtkSmartPointer<vtkSelection>::Take(selector->Select());
}

/**
 * What one frame in a cycle changes.
 */
void Change(Window& window, int frame, const Cast& cast, vtkActor* actor)
{
  auto mapper = vtkPointSplatMapper::SafeDownCast(actor->GetMapper());
  vtkProperty* property = actor->GetProperty();
  switch (frame % Cycle)
  {
    case 0:
      window.Win->SetSize(40, 36);
      mapper->SetMaximumWindowMemory(0);
      mapper->SetInputDataObject(cast.Cube);
      cast.Cube->Modified(); // its sizes and creases are estimated anew
      break;
    case 3:
      mapper->SetInputDataObject(cast.Ball);
      break;
    case 5:
      mapper->InterpolateScalarsBeforeMappingOn();
      break;
    case 7:
      mapper->InterpolateScalarsBeforeMappingOff();
      mapper->SetInputDataObject(cast.Cells);
      break;
    case 9:
      property->SetInterpolationToPBR();
      break;
    case 10:
      window.Renderer->UseImageBasedLightingOn();
      break;
    case 12:
      window.Renderer->UseImageBasedLightingOff();
      property->SetInterpolationToFlat();
      break;
    case 14:
      property->SetInterpolationToGouraud();
      property->SetRepresentationToPoints();
      break;
    case 15:
      property->SetRepresentationToWireframe();
      break;
    case 16:
      property->SetRepresentationToSurface();
      mapper->SetInputDataObject(cast.Blocks);
      break;
    case 17:
      mapper->SetBlockColor(1, 1.0, 0.0, 0.0);
      break;
    case 18:
      mapper->SetBlockOpacity(2, 0.5);
      break;
    case 19:
      mapper->SetBlockVisibility(1, false);
      break;
    case 20:
      Pick(window.Renderer);
      break;
    case 21:
      // Another block, and none of the attributes.
      cast.Blocks->SetBlock(1, RandomSphere(100));
      mapper->SetCompositeDataDisplayAttributes(nullptr);
      break;
    case 23:
      property->SetOpacity(0.5);
      break;
    case 25:
      mapper->AntiAliasingOff();
      break;
    case 26:
      mapper->AntiAliasingOn();
      property->SetOpacity(1.0);
      break;
    case 27:
      mapper->ShadowsOn();
      window.Renderer->AddLight(cast.Lamp);
      break;
    case 29:
      mapper->ShadowsOff();
      window.Renderer->RemoveLight(cast.Lamp);
      break;
    case 30:
      window.Win->SetSize(36, 40);
      break;
    case 32:
      window.Win->SetSize(300, 30);
      break;
    case 33:
      mapper->SetMaximumWindowMemory(1);
      break;
    case 35:
      actor->ReleaseGraphicsResources(window.Win);
      break;
    case 37:
      Pick(window.Renderer);
      break;
    default:
      window.Renderer->GetActiveCamera()->Azimuth(frame % Cycle % 2 == 0 ? 9.0 : -9.0);
      break;
  }
}
}

int TestSplatsMemoryFeatures(int, char*[])
{
  Checks checks;
  Window window(40);
  window.SmoothOutlines = true;
  Cast cast;
  MakeCast(cast);
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(cast.Ball);
  vtkActor* actor = window.Add(mapper);
  window.Renderer->ResetCamera();
  window.Renderer->CreateLight(); // of its own; there is none where others are
  PrepareImageBasedLighting(window.Renderer);

  SplatMemory::Record record;
  for (int round = 0; round == 0 || (round < 3 && record.Grew(MostGrowth)); ++round)
  {
    record = SplatMemory::Record();
    for (int frame = 0; frame <= Frames; ++frame)
    {
      Change(window, frame, cast, actor);
      window.Win->Render();
      if (round == 0 && frame < Cycle)
      {
        checks.AtLeast(
          Read(window.Win).CountDrawn(), 50, "frame " + std::to_string(frame) + ", pixels");
      }
      if (frame >= Interval && frame % Interval == 0)
      {
        record.Add("frame " + std::to_string(frame), window.Win);
      }
    }
  }
  record.Check(checks, MostGrowth);
  return checks.Result();
}
