// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks of a composite input that are hidden, or have colours and opacities of their own: the
// picture that VTK's own mapper makes of their meshes, and what is picked.
#include "SplatScene.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSplattingConfigure.h"
#if PointSplatting_HAVE_COMPOSITE_DELEGATOR
#include "vtkCompositePolyDataMapper.h"
using MeshMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using MeshMapper = vtkCompositePolyDataMapper2;
#endif

namespace
{
using namespace SplatScene;

/// The flat indices.
enum Block
{
  Left = 1,
  Pair = 2, // of the next ones; 4 is empty
  Near = 3,
  Far = 5,
  Coloured = 6
};

vtkSmartPointer<vtkPolyData> Ball(double x, double y, double z)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, y, z);
  source->SetThetaResolution(120);
  source->SetPhiResolution(60);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkMultiBlockDataSet> Balls()
{
  auto root = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  root->SetBlock(0, Ball(-0.6, 0.5, 0.0));
  vtkNew<vtkMultiBlockDataSet> pair;
  pair->SetNumberOfBlocks(3);
  pair->SetBlock(0, Ball(0.6, 0.5, 0.0));
  pair->SetBlock(2, Ball(0.35, 0.35, -1.2));
  root->SetBlock(1, pair);
  vtkSmartPointer<vtkPolyData> coloured = Ball(0.0, -0.5, 0.0);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colours");
  colours->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < coloured->GetNumberOfPoints(); ++i)
  {
    const double y = coloured->GetPoint(i)[1] + 1.0;
    colours->InsertNextTuple4(255 * y, 60, 255 - 255 * y, 255);
  }
  coloured->GetPointData()->SetScalars(colours);
  root->SetBlock(2, coloured);
  return root;
}

template <typename Mapper>
struct Drawing
{
  vtkSmartPointer<vtkMultiBlockDataSet> Data = Balls();
  vtkNew<Mapper> Blocks;
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  Window Win;
  vtkActor* Actor = nullptr;

  Drawing()
  {
    this->Blocks->SetInputDataObject(0, this->Data);
    this->Blocks->SetCompositeDataDisplayAttributes(this->Attributes);
    this->Actor = this->Win.Add(this->Blocks);
    this->Win.Renderer->SetUseDepthPeeling(1);
    this->Win.Renderer->SetMaximumNumberOfPeels(20);
    this->Win.Renderer->GetActiveCamera()->SetPosition(0, 0, 6);
    this->Win.Renderer->ResetCamera();
  }
};

/**
 * The same done to both, and the pictures held against each other.
 */
template <typename Change>
void Compare(Checks& checks, const std::string& name, Change&& change)
{
  Drawing<vtkPointSplatMapper> splats;
  Drawing<MeshMapper> mesh;
  splats.Win.Draw(); // without attributes first, as a user does
  mesh.Win.Draw();
  change(splats.Blocks.Get(), splats.Actor);
  change(mesh.Blocks.Get(), mesh.Actor);
  const Picture ours = splats.Win.Draw();
  const Picture theirs = mesh.Win.Draw();
  const bool nothing = ours.CountDrawn() == 0 && theirs.CountDrawn() == 0;
  checks.Expect(nothing == (name == "all hidden"), name + ": what is drawn");
  checks.AtLeast(nothing ? 99.0 : Psnr(ours, theirs), 34.0, name);
}

void CompareAll(Checks& checks)
{
  Compare(checks, "no attributes", [](auto*, vtkActor*) {});
  Compare(checks, "a hidden block", [](auto* m, vtkActor*) { m->SetBlockVisibility(Near, false); });
  Compare(checks, "hidden, but for one", [](auto* m, vtkActor*) {
    m->SetBlockVisibility(Pair, false);
    m->SetBlockVisibility(Far, true);
  });
  Compare(checks, "all hidden", [](auto* m, vtkActor*) { m->SetBlockVisibility(0u, false); });
  Compare(checks, "seen again", [](auto* m, vtkActor*) {
    m->SetBlockVisibility(0u, false);
    m->RemoveBlockVisibilities();
  });
  Compare(checks, "colours", [](auto* m, vtkActor*) {
    m->SetBlockColor(Pair, 0.1, 0.9, 0.2);
    m->SetBlockColor(Far, 0.2, 0.3, 1.0);
  });
  // Of VTK 9.6's mapper the scalars win.
  Drawing<MeshMapper> mesh;
  const Picture byScalars = mesh.Win.Draw();
  mesh.Blocks->SetBlockColor(Coloured, 1.0, 1.0, 0.0);
  if (mesh.Win.Draw().Pixels != byScalars.Pixels)
  {
    Compare(checks, "a colour over scalars",
      [](auto* m, vtkActor*) { m->SetBlockColor(Coloured, 1.0, 1.0, 0.0); });
  }
  Compare(checks, "a colour, without scalars", [](auto* m, vtkActor*) {
    m->ScalarVisibilityOff();
    m->SetBlockColor(Left, 1.0, 0.0, 0.0);
  });
  Compare(checks, "an opacity", [](auto* m, vtkActor*) { m->SetBlockOpacity(Near, 0.4); });
  Compare(checks, "an opacity of coloured points",
    [](auto* m, vtkActor*) { m->SetBlockOpacity(Coloured, 0.4); });
  Compare(checks, "in the actor's place", [](auto* m, vtkActor* actor) {
    actor->GetProperty()->SetOpacity(0.3);
    m->SetBlockOpacity(Pair, 0.8);
    m->SetBlockColor(Near, 0.3, 0.3, 1.0);
  });
}

/// Of each flat index how many pixels select it; [0]: how many select none.
std::vector<int> Pick(Window& window)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(window.Renderer);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  std::vector<int> counts(8, 0);
  if (selector->CaptureBuffers())
  {
    for (unsigned int y = 0; y < Size; ++y)
    {
      for (unsigned int x = 0; x < Size; ++x)
      {
        const unsigned int pixel[2] = { x, y };
        const auto hit = selector->GetPixelInformation(pixel);
        ++counts[hit.Valid ? std::min(hit.CompositeID, 7u) : 0u];
      }
    }
  }
  return counts;
}

void PickBlocks(Checks& checks)
{
  Drawing<vtkPointSplatMapper> splats;
  splats.Win.Draw();
  const std::vector<int> all = Pick(splats.Win);
  for (int block : { Left, Near, Far, Coloured })
  {
    checks.AtLeast(all[size_t(block)], 1000, "pixels of block " + std::to_string(block));
  }
  splats.Blocks->SetBlockVisibility(Near, false);
  splats.Win.Draw();
  const std::vector<int> some = Pick(splats.Win);
  checks.Expect(some[Near] == 0, "a hidden block is picked");
  checks.AtLeast(some[Far], all[Far] + 500, "what it hid");
  checks.AtLeast(some[Left], all[Left], "another one");
  checks.AtMost(splats.Blocks->GetBounds()[1], 0.86, "the bounds without it");
}

void ChangeBlocks(Checks& checks)
{
  // What is set by index holds for what comes to be there, and may be set before there is any.
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetBlockColor(Left, 0.0, 1.0, 0.0);
  mapper->SetBlockVisibility(Coloured, false);
  Window window;
  mapper->SetInputDataObject(Balls());
  vtkActor* actor = window.Add(mapper);
  actor->GetProperty()->SetSpecular(0.0);
  window.Renderer->GetActiveCamera()->SetPosition(0, 0, 6);
  window.Renderer->ResetCamera();
  auto check = [&](const std::string& when) {
    const Picture picture = window.Draw();
    int green = 0;
    int blue = 0;
    for (size_t i = 0; i < picture.Pixels.size(); i += 3)
    {
      green += picture.Pixels[i] == 0 && picture.Pixels[i + 1] > 0 && picture.Pixels[i + 2] == 0;
      blue += picture.Pixels[i + 2] > picture.Pixels[i];
    }
    checks.AtLeast(green, 3000, when + ": pixels of the green block");
    checks.Expect(blue == 0, when + ": the hidden block is seen");
  };
  check("set before the input");
  for (int i = 0; i < 3; ++i)
  {
    mapper->SetInputDataObject(Balls());
    check("blocks made anew");
  }
  checks.Expect(!mapper->GetBlockVisibility(Coloured), "the visibility that was set");
  checks.Expect(mapper->GetBlockColor(Left)[1] == 1.0 && mapper->GetBlockColor(Left)[0] == 0.0,
    "the colour that was set");

  // Blocks that vanish, while something is set of them.
  vtkSmartPointer<vtkMultiBlockDataSet> data = Balls();
  mapper->SetInputDataObject(data);
  window.Draw();
  data->SetBlock(0, nullptr);
  data->Modified();
  const int without = window.Draw().CountDrawn();
  checks.AtLeast(without, 3000, "pixels of the other blocks");
  data->SetBlock(0, Ball(-0.6, 0.5, 0.0));
  check("back again");
  data->SetNumberOfBlocks(0);
  data->Modified();
  checks.Expect(window.Draw().CountDrawn() == 0, "nothing is left to draw");
  mapper->SetBlockOpacity(77u, 0.5); // there is no such block
  mapper->SetInputData(Ball(0, 0, 0));
  checks.AtLeast(window.Draw().CountDrawn(), 3000, "pixels of a single data set");
}

void ReuseEstimates(Checks& checks)
{
  // After the first time a block that is hidden or comes back takes no estimation: no progress between
  // 0 and 1 is told.
  Drawing<vtkPointSplatMapper> splats;
  splats.Blocks->SetBlockVisibility(Left, false);
  splats.Win.Draw();
  splats.Blocks->SetBlockVisibility(Left, true);
  splats.Win.Draw();
  vtkNew<ProgressCounter> counter;
  splats.Blocks->AddObserver(vtkCommand::ProgressEvent, counter);
  splats.Blocks->SetBlockVisibility(Near, false);
  splats.Win.Draw();
  splats.Blocks->SetBlockVisibility(Near, true);
  splats.Win.Draw();
  checks.Expect(counter->Partial == 0, "hiding a block makes all sizes anew");
  splats.Data->SetBlock(0, Ball(-0.6, 0.6, 0.0));
  splats.Win.Draw();
  checks.Expect(counter->Partial > 0, "this test does not notice an estimation");
}

void RefuseNumbers(Checks& checks)
{
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputDataObject(Balls());
  vtkObject::GlobalWarningDisplayOff();
  mapper->SetBlockOpacity(Left, NAN);
  mapper->SetBlockColor(Left, 0.5, INFINITY, 0.5);
  vtkObject::GlobalWarningDisplayOn();
  checks.Expect(mapper->GetBlockOpacity(Left) == 1.0, "an opacity of NaN is taken");
  checks.Expect(mapper->GetBlockColor(Left)[0] == 1.0, "a colour of infinity is taken");
  mapper->SetBlockOpacity(Left, 7.0);
  checks.Expect(mapper->GetBlockOpacity(Left) == 1.0, "an opacity of 7 is taken");
}
}

int TestSplatsBlocks(int, char*[])
{
  Checks checks;
  CompareAll(checks);
  PickBlocks(checks);
  ChangeBlocks(checks);
  ReuseEstimates(checks);
  RefuseNumbers(checks);
  return checks.Result();
}
