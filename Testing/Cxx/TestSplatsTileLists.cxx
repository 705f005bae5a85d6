// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of the splats in each tile of the image, made by the device and by the processor: the
// same picture, but for what a 32nd of a pixel may change. The device's tiles, of a pixel an
// invocation, take rays for parallel nowhere, the processor's where that moves nothing by more. Tiles
// without splats, which the processor's lists leave out, show nothing of the frames before.
#include "SplatScene.h"

#include "vtkHardwareSelector.h"

#include <cmath>

namespace
{
using namespace SplatScene;

/// A torus behind a coarse sphere, so that splats of a pixel and of many tiles are listed together.
struct Scene
{
  Window Win;
  vtkNew<vtkPointSplatMapper> Mappers[2];

  explicit Scene(double opacity, int size)
    : Win(size)
  {
    this->Mappers[0]->SetInputData(RandomTorus(30000));
    this->Mappers[1]->SetInputData(RandomSphere(150));
    for (vtkPointSplatMapper* mapper : { this->Mappers[0].Get(), this->Mappers[1].Get() })
    {
      this->Win.Add(mapper)->GetProperty()->SetOpacity(opacity);
    }
    this->Win.Renderer->ResetCamera();
    this->Win.Renderer->GetActiveCamera()->Elevation(-50);
    this->Win.Renderer->ResetCameraClippingRange();
  }
  Picture Draw(vtkPointSplatMapper::TileListsType lists)
  {
    for (vtkPointSplatMapper* mapper : { this->Mappers[0].Get(), this->Mappers[1].Get() })
    {
      mapper->SetTileLists(lists);
    }
    return this->Win.Draw();
  }
};

/// Of each pixel: the actor and the point that hardware selection names.
std::vector<std::pair<int, vtkIdType>> PickAll(Scene& scene)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Win.Renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  std::vector<std::pair<int, vtkIdType>> hits;
  if (selector->CaptureBuffers())
  {
    for (unsigned int y = 0; y < Size; ++y)
    {
      for (unsigned int x = 0; x < Size; ++x)
      {
        const unsigned int pixel[2] = { x, y };
        const auto hit = selector->GetPixelInformation(pixel);
        hits.emplace_back(hit.Valid ? hit.PropID : -1, hit.Valid ? hit.AttributeID : -1);
      }
    }
  }
  return hits;
}

void TestSame(Checks& checks, const std::string& name, Scene& scene)
{
  const Picture processor = scene.Draw(vtkPointSplatMapper::PROCESSOR);
  const Picture device = scene.Draw(vtkPointSplatMapper::DEVICE);
  checks.AtLeast(processor.CountDrawn(), 3000, name + ": pixels drawn");
  checks.Expect(std::string(scene.Mappers[0]->GetProjectionUsed()) == "compute",
    name + ": tiles were not used");
  int slight = 0;
  int other = 0;
  for (int y = 0; y < processor.Height; ++y)
  {
    for (int x = 0; x < processor.Width; ++x)
    {
      int largest = 0;
      for (int c = 0; c < 3; ++c)
      {
        largest = std::max(largest, std::abs(processor.At(x, y)[c] - device.At(x, y)[c]));
      }
      slight += largest > 0;
      other += largest > 2;
    }
  }
  const int drawn = processor.CountDrawn();
  std::cout << name << ": of " << drawn << " pixels " << slight << " differ, " << other
            << " by more than 2 of 255, " << CountDifferentCoverage(processor, device)
            << " in coverage\n";
  // There are 12 in 10000 at most, and 6 in 100 that differ by 1.
  checks.AtMost(other, drawn / 500, name + ": pixels that differ");
  checks.AtMost(slight, drawn / 10, name + ": pixels that differ at all");
  // Mesa's llvmpipe draws on the processor, which then makes the lists, too; a graphics card makes its own.
  const bool card = std::string(scene.Win.Win->ReportCapabilities()).find("llvmpipe") == std::string::npos;
  checks.Expect(scene.Draw(vtkPointSplatMapper::AUTOMATIC_LISTS).Pixels == (card ? device : processor).Pixels,
    name + ": the automatic picture differs");
}

/// Two bodies at the ends of a window's diagonal, and nothing between them.
struct Bodies
{
  Window Win;
  vtkNew<vtkPointSplatMapper> Mapper;
  vtkActor* Actors[2];

  Bodies(double opacity, vtkPointSplatMapper::TileListsType lists)
    : Win(Size)
  {
    this->Mapper->SetInputData(RandomSphere(2000));
    this->Mapper->SetTileLists(lists);
    for (vtkActor*& actor : this->Actors)
    {
      actor = this->Win.Add(this->Mapper);
      actor->GetProperty()->SetOpacity(opacity);
    }
    this->Put(0.0);
    this->Win.Renderer->ResetCamera();
  }
  void Put(double angle)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double side = i == 0 ? 6.0 : -6.0;
      this->Actors[i]->SetPosition(side * std::cos(angle), side * std::sin(angle), 0.0);
    }
  }
};

void TestEmptyTiles(Checks& checks, const std::string& name, double opacity)
{
  Bodies moved(opacity, vtkPointSplatMapper::PROCESSOR);
  for (const double angle : { 0.0, 0.4, 1.2, 2.5 })
  {
    moved.Put(angle);
    const Picture picture = moved.Win.Draw();
    Bodies fresh(opacity, vtkPointSplatMapper::PROCESSOR);
    fresh.Put(angle);
    Bodies device(opacity, vtkPointSplatMapper::DEVICE);
    device.Put(angle);
    checks.AtLeast(picture.CountDrawn(), 500, name + ", two bodies: pixels drawn");
    checks.Expect(fresh.Win.Draw().Pixels == picture.Pixels,
      name + ", two bodies: what was drawn before is seen");
    checks.AtMost(CountDifferentCoverage(picture, device.Win.Draw()), 10,
      name + ", two bodies: pixels that the device's lists cover otherwise");
  }
}
}

int TestSplatsTileLists(int, char*[])
{
  Checks checks;
  for (const double opacity : { 1.0, 0.4 })
  {
    const std::string name = opacity < 1.0 ? "translucent" : "opaque";
    TestEmptyTiles(checks, name, opacity);
    Scene scene(opacity, Size);
    TestSame(checks, name, scene);
    scene.Draw(vtkPointSplatMapper::PROCESSOR);
    const auto hits = PickAll(scene);
    scene.Draw(vtkPointSplatMapper::DEVICE);
    checks.AtLeast<size_t>(hits.size(), Size * Size, name + ": pixels of selections");
    const auto others = PickAll(scene);
    int different = 0;
    for (size_t i = 0; i < std::min(hits.size(), others.size()); ++i)
    {
      different += hits[i] != others[i];
    }
    checks.AtLeast(others.size(), hits.size(), name + ": pixels of the device's selections");
    checks.AtMost(different, 100, name + ": selections that differ");
    scene.Win.Renderer->GetActiveCamera()->Zoom(5);
    TestSame(checks, name + ", close-up", scene);
    // No multiple of tiles, and larger than before.
    scene.Win.Win->SetSize(Size + 61, Size - 37);
    TestSame(checks, name + ", resized", scene);
    for (vtkPointSplatMapper* mapper : { scene.Mappers[0].Get(), scene.Mappers[1].Get() })
    {
      mapper->SetRadiusScale(4);
    }
    TestSame(checks, name + ", large splats", scene);
    // The processor tries on outlines' samples what boxes of pixels let through, the device all of a tile.
    scene.Win.Renderer->GetActiveCamera()->Zoom(0.2);
    for (vtkPointSplatMapper* mapper : { scene.Mappers[0].Get(), scene.Mappers[1].Get() })
    {
      mapper->SetRadiusScale(1);
      mapper->AntiAliasingOn();
    }
    TestSame(checks, name + ", smooth outlines", scene);
  }
  return checks.Result();
}
