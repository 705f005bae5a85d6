// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A window that is drawn in parts shows what it shows drawn whole: by all methods, with all kinds of
// layers, beside meshes, in a selection; and no image is larger than it may be.
#include "SplatTables.h"

#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"

#include "vtkPointSplatWindowParts.h"

namespace
{
using namespace SplatScene;

constexpr int Width = 900;
constexpr int Height = 700;
// Parts of the least size there is.
constexpr vtkIdType Least = 1;

struct Scene
{
  Window Win;
  vtkNew<vtkPointSplatMapper> Mapper;
  vtkActor* Actor;

  Scene()
  {
    this->Win.Win->SetSize(Width, Height);
    this->Win.SmoothOutlines = true;
    this->Mapper->SetInputData(RandomTorus(30000));
    this->Actor = this->Win.Add(this->Mapper);
    vtkCamera* camera = this->Win.Renderer->GetActiveCamera();
    camera->SetPosition(1.0, 2.5, 3.0);
    this->Win.Renderer->ResetCamera();
    camera->Zoom(1.6); // beyond the window's edges
  }
};

using Change = std::function<void(Scene&)>;

void AddBall(Scene& scene)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeSphereMesh(60));
  scene.Win.Add(mapper)->SetScale(1.6);
}

void AddEnvironment(Scene& scene)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (vtkIdType i = 0; i < 16 * 8; ++i)
  {
    image->GetPointData()->GetScalars()->SetTuple3(i, i, 255 - 2 * i, 100);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  scene.Win.Renderer->SetEnvironmentTexture(texture);
}

int CountOff(const Picture& a, const Picture& b)
{
  int count = 0;
  for (size_t i = 0; i < a.Pixels.size(); i += 3)
  {
    int most = 0;
    for (size_t c = i; c < i + 3; ++c)
    {
      most = std::max(most, std::abs(int(a.Pixels[c]) - int(b.Pixels[c])));
    }
    count += most > 12;
  }
  return count;
}

void Compare(
  Checks& checks, const std::string& name, const Change& change, double least = 70.0)
{
  Scene whole;
  change(whole);
  const Picture wanted = whole.Win.Draw();
  const std::vector<double> depth = whole.Win.Depth();
  Scene parts;
  change(parts);
  parts.Mapper->SetMaximumWindowMemory(Least);
  const Picture picture = parts.Win.Draw();
  checks.AtLeast(wanted.CountDrawn(), 100000, name + ": pixels drawn");
  // Places are rounded to floats about another origin: here and there a pixel shows the other side of an
  // edge, and a point projected as one pixel is in the next one.
  checks.AtLeast(PsnrOfAll(wanted, picture), least, name + ": dB of the window drawn whole");
  if (least < 50.0)
  {
    return;
  }
  // Of image space a hole beside such a point is filled, or is not.
  const int few = least < 70.0 ? 500 : 100;
  checks.AtMost(CountOff(wanted, picture), few, name + ": pixels that differ by more than 12");
  checks.AtMost(CountDifferentCoverage(wanted, picture), 10, name + ": pixels drawn by one alone");
  const std::vector<double> partsDepth = parts.Win.Depth();
  int off = 0;
  for (size_t i = 0; i < depth.size(); ++i)
  {
    off += std::abs(depth[i] - partsDepth[i]) > 0.02;
  }
  checks.AtMost(off, few, name + ": pixels with another depth");
  checks.AtMost(parts.Mapper->GetImageMemorySize(), whole.Mapper->GetImageMemorySize(),
    name + ": bytes of images");
  checks.AtLeast(
    parts.Mapper->GetNumberOfLayersDrawn(), whole.Mapper->GetNumberOfLayersDrawn(), name + ": layers");
}

/// Points that a selection of the whole window finds.
std::vector<vtkIdType> Select(Scene& scene)
{
  scene.Win.Win->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Win.Renderer);
  selector->SetArea(0, 0, Width - 1, Height - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  std::vector<vtkIdType> ids;
  for (unsigned int n = 0; n < selection->GetNumberOfNodes(); ++n)
  {
    auto list = vtkIdTypeArray::SafeDownCast(selection->GetNode(n)->GetSelectionList());
    ids.insert(ids.end(), list->GetPointer(0), list->GetPointer(0) + list->GetNumberOfValues());
  }
  return ids;
}

/// Parts cover each pixel once, and their images fit.
void Divide(Checks& checks, int width, int height, vtkIdType bytes)
{
  const std::string name = std::to_string(width) + " x " + std::to_string(height) + " in " +
    std::to_string(bytes) + " bytes";
  std::vector<int> shown(static_cast<size_t>(width) * height, 0);
  vtkIdType largest = 0;
  const auto parts = vtkPointSplatWindowParts::Divide({ width, height }, 28, bytes);
  for (const vtkPointSplatWindowPart& part : parts)
  {
    largest = std::max(largest, vtkIdType(28) * part.Size.x * part.Size.y);
    for (int y = part.First.y + part.Shown.y; y <= part.First.y + part.Shown.w; ++y)
    {
      for (int x = part.First.x + part.Shown.x; x <= part.First.x + part.Shown.z; ++x)
      {
        ++shown[static_cast<size_t>(y) * width + x];
      }
    }
  }
  checks.Expect(std::all_of(shown.begin(), shown.end(), [](int count) { return count == 1; }),
    name + ": each pixel once");
  const vtkIdType least = vtkIdType(28) * (256 + 128) * (256 + 128);
  checks.AtMost(largest, bytes == 0 ? VTK_ID_MAX : std::max(bytes, least), name + ": bytes");
  checks.AtMost<size_t>(parts.size(), bytes == 0 ? 1 : 100, name + ": parts");
}
}

int TestSplatsWindowParts(int, char*[])
{
  Checks checks;
  for (const vtkIdType bytes : { 0, 1, 10000000, 30000000, 100000000 })
  {
    Divide(checks, 1500, 1100, bytes);
    Divide(checks, 2500, 300, bytes);
    Divide(checks, 70, 2000, bytes);
    Divide(checks, 1, 1, bytes);
  }
  for (const Way& way : Ways)
  {
    Compare(
      checks, way.Name,
      [&way](Scene& scene) {
        scene.Mapper->SetMethod(way.Method);
        scene.Mapper->SetProjection(way.Projection);
      },
      way.Method == Mapper::IMAGE_SPACE ? 50.0 : 70.0);
  }
  Compare(checks, "beside a mesh", AddBall);
  const auto translucent = [](Scene& scene) { scene.Actor->GetProperty()->SetOpacity(0.5); };
  Compare(checks, "layers", translucent);
  Compare(checks, "layers, before a mesh", [&](Scene& scene) {
    translucent(scene);
    AddBall(scene);
  });
  Compare(checks, "layers, peeled with a mesh", [&](Scene& scene) {
    translucent(scene);
    AddBall(scene);
    scene.Win.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(0.4);
    scene.Win.Renderer->UseDepthPeelingOn();
  });
  Compare(checks, "sorted layers", [&](Scene& scene) {
    translucent(scene);
    scene.Mapper->SetTransparencyToSorted();
  });
  // Its rays end at the parts' rims.
  Compare(
    checks, "glass",
    [&](Scene& scene) {
      scene.Actor->GetProperty()->SetOpacity(0.1);
      scene.Mapper->RefractionOn();
      AddEnvironment(scene);
    },
    30.0);
  Compare(checks, "parallel", [](Scene& scene) {
    scene.Win.Renderer->GetActiveCamera()->ParallelProjectionOn();
  });
  Compare(checks, "part of the window", [](Scene& scene) {
    scene.Win.Renderer->SetViewport(0.1, 0.05, 1.0, 0.9);
  });
  Compare(checks, "many samples a pixel", [](Scene& scene) { scene.Win.Win->SetMultiSamples(4); });

  Scene whole;
  Scene parts;
  parts.Mapper->SetMaximumWindowMemory(Least);
  const std::vector<vtkIdType> wanted = Select(whole);
  const std::vector<vtkIdType> found = Select(parts);
  std::vector<vtkIdType> both;
  std::set_intersection(
    wanted.begin(), wanted.end(), found.begin(), found.end(), std::back_inserter(both));
  checks.AtLeast<size_t>(wanted.size(), 5000, "points selected");
  checks.AtLeast(both.size(), wanted.size() - wanted.size() / 500, "of which in parts too");
  checks.AtLeast(both.size(), found.size() - found.size() / 500, "and no others");
  return checks.Result();
}
