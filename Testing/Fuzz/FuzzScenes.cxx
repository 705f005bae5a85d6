// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCase.h"
#include "FuzzChange.h"
#include "FuzzData.h"
#include "FuzzProperties.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkFloatArray.h"
#include "vtkFramebufferPass.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkLightsPass.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkPixelBufferObject.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointSplatMapper.h"
#include "vtkPointSplatPass.h"
#include "vtkPointSplatShadowPass.h"
#include "vtkPointSplattingOpenGL.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSequencePass.h"
#include "vtkSphereSource.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// Any number up to this of splats in one pixel has the same sum in every frame.
constexpr vtkIdType SplatsThatAddUp = 64;

struct Splats
{
  vtkSmartPointer<vtkDataObject> Data;
  vtkSmartPointer<vtkPointSplatMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
};

Splats MakeSplats(FuzzRandom& random, vtkSmartPointer<vtkDataObject> data)
{
  Splats splats;
  splats.Data = data;
  splats.Mapper = vtkSmartPointer<vtkPointSplatMapper>::New();
  splats.Mapper->SetInputDataObject(data);
  FuzzProperties::SetOwn(random, splats.Mapper);
  FuzzProperties::SetColouring(random, splats.Mapper);
  splats.Actor = vtkSmartPointer<vtkActor>::New();
  splats.Actor->SetMapper(splats.Mapper);
  FuzzProperties::SetActor(random, splats.Actor);
  return splats;
}

/**
 * What matters of splats that a finding is about.
 */
std::string Describe(const Splats& splats)
{
  std::ostringstream text;
  vtkPointSplatMapper* mapper = splats.Mapper;
  text << "\n  " << splats.Data->GetClassName() << ", " << mapper->GetNumberOfSplats()
       << " splats, " << mapper->GetNumberOfSkippedPoints() << " skipped, layer distance "
       << mapper->GetLayerDistance() << " (" << mapper->GetLayerDistanceUsed()
       << "), radius scale " << mapper->GetRadiusScale() << ", kernel " << mapper->GetKernel()
       << " " << mapper->GetKernelSigma() << " " << mapper->GetKernelSupport() << ", "
       << mapper->GetProjectionUsed() << ", " << mapper->GetMethodUsed() << ", "
       << mapper->GetTransparencyUsed() << ", layers " << mapper->GetNumberOfLayersDrawn() << " of "
       << mapper->GetMaximumNumberOfLayers() << ", opacity "
       << splats.Actor->GetProperty()->GetOpacity()
       << (splats.Actor->GetForceTranslucent() ? " forced" : "")
       << (splats.Actor->HasTranslucentPolygonalGeometry() ? " translucent" : "") << ", matrix";
  for (int i = 0; i < 16; ++i)
  {
    text << " " << splats.Actor->GetMatrix()->GetData()[i];
  }
  return text.str();
}

std::string Describe(const std::vector<Splats>& all)
{
  std::string text;
  for (const Splats& splats : all)
  {
    text += Describe(splats);
  }
  return text;
}

vtkSmartPointer<vtkActor> MakeMesh(FuzzRandom& random)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(random.Uniform(0.1, 1));
  source->SetCenter(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(random.Chance(0.5) ? 1 : 0.5);
  return actor;
}

vtkSmartPointer<vtkRenderPass> MakeChain(FuzzRandom& random)
{
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  passes->AddItem(lights);
  if (random.Chance(0.5))
  {
    vtkNew<vtkPointSplatPass> splats;
    splats->SetMethod(random.Below(6) - 2);
    splats->SetTransparency(random.Below(6) - 2);
    splats->SetMaximumNumberOfLayers(random.Pick({ -1, 0, 1, 3, 1000 }));
    splats->SetLayerDistance(random.Chance(0.5) ? -1 : random.Property(0, 1));
    passes->AddItem(splats);
  }
  else
  {
    vtkNew<vtkOpaquePass> opaque;
    vtkNew<vtkTranslucentPass> translucent;
    passes->AddItem(opaque);
    passes->AddItem(translucent);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  if (random.Chance(0.4))
  {
    auto shadows = vtkSmartPointer<vtkPointSplatShadowPass>::New();
    shadows->SetDelegatePass(camera);
    return shadows;
  }
  return camera;
}
}

class FuzzScenes::Implementation
{
public:
  explicit Implementation(FuzzMessages& messages)
    : Messages(messages)
  {
  }
  void RunAny(FuzzRandom& random);
  void RunNeighbour(FuzzRandom& random);
  void RunFloats(FuzzRandom& random);
  void Clear();
  vtkSmartPointer<vtkEGLHeadlessRenderWindow> Window;
  std::uint64_t WindowSeed = 0;

private:
  using Pixels = std::vector<unsigned char>;

  Pixels Draw(const std::string& when);
  void ForgetErrors();
  bool HasEmptyViewport();
  void ExpectNoError(const std::string& when);
  void Select(FuzzRandom& random, const std::vector<Splats>& all);
  void ChangeSomething(FuzzRandom& random, std::vector<Splats>& all, vtkRenderer* renderer);
  vtkSmartPointer<vtkRenderer> AddRenderer(FuzzRandom& random, int index);

  FuzzMessages& Messages;
};

void FuzzScenes::Implementation::Clear()
{
  this->Window->GetRenderers()->InitTraversal();
  while (vtkRenderer* renderer = this->Window->GetRenderers()->GetFirstRenderer())
  {
    this->Window->RemoveRenderer(renderer);
  }
}

void FuzzScenes::Implementation::ForgetErrors()
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
}

bool FuzzScenes::Implementation::HasEmptyViewport()
{
  vtkCollectionSimpleIterator it;
  this->Window->GetRenderers()->InitTraversal(it);
  while (vtkRenderer* renderer = this->Window->GetRenderers()->GetNextRenderer(it))
  {
    int viewport[4];
    renderer->GetTiledSizeAndOrigin(&viewport[0], &viewport[1], &viewport[2], &viewport[3]);
    if (viewport[0] < 1 || viewport[1] < 1)
    {
      return true;
    }
  }
  return false;
}

void FuzzScenes::Implementation::ExpectNoError(const std::string& when)
{
  this->Window->MakeCurrent();
  const GLenum error = glGetError();
  this->ForgetErrors();
  // VTK's translucent pass makes images of no pixels there, and uses them.
  if (this->HasEmptyViewport())
  {
    return;
  }
  FuzzExpect(error == GL_NO_ERROR, "OpenGL error " + std::to_string(error) + " " + when);
}

FuzzScenes::Implementation::Pixels FuzzScenes::Implementation::Draw(const std::string& when)
{
  // vtkRenderer leaves errors when it resets a camera outside of a frame.
  this->Window->MakeCurrent();
  this->ForgetErrors();
  this->Window->Render();
  this->ExpectNoError(when);
  const int* size = this->Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
  return Pixels(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

vtkSmartPointer<vtkRenderer> FuzzScenes::Implementation::AddRenderer(FuzzRandom& random, int index)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  if (index > 0)
  {
    const double x = random.Uniform(0, 0.6), y = random.Uniform(0, 0.6);
    renderer->SetViewport(x, y, random.Uniform(x + 0.1, 1), random.Uniform(y + 0.1, 1));
  }
  renderer->SetUseDepthPeeling(random.Chance(0.2));
  renderer->SetMaximumNumberOfPeels(random.Below(6));
  renderer->SetUseFXAA(random.Chance(0.1));
  renderer->SetUseHiddenLineRemoval(random.Chance(0.05));
  renderer->SetUseSSAO(random.Chance(0.05));
  renderer->SetTwoSidedLighting(random.Chance(0.8));
  renderer->SetAutomaticLightCreation(random.Chance(0.9));
  if (random.Chance(0.15))
  {
    renderer->SetPass(MakeChain(random));
  }
  this->Window->AddRenderer(renderer);
  return renderer;
}

void FuzzScenes::Implementation::Select(FuzzRandom& random, const std::vector<Splats>& all)
{
  vtkRenderer* renderer = this->Window->GetRenderers()->GetFirstRenderer();
  const int* size = this->Window->GetSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  const bool points = random.Chance(0.6);
  selector->SetFieldAssociation(
    points ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, static_cast<unsigned int>(size[0] - 1),
    static_cast<unsigned int>(size[1] - 1));
  // vtkOpenGLHardwareSelector binds at its end what was bound at its beginning: a vertex buffer of
  // VTK's own mappers, which may be gone by then.
  this->Window->MakeCurrent();
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  this->ExpectNoError("after a selection");
  for (unsigned int n = 0; selection && n < selection->GetNumberOfNodes(); ++n)
  {
    vtkSelectionNode* node = selection->GetNode(n);
    vtkObjectBase* prop = node->GetProperties()->Get(vtkSelectionNode::PROP());
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (const Splats& splats : all)
    {
      auto* data = vtkPointSet::SafeDownCast(splats.Data);
      // A point that no cell uses has no cell id, and what lies behind shows its own there.
      const bool behind = !points && renderer->GetViewProps()->GetNumberOfItems() > 1;
      if (prop != splats.Actor || !ids || !data || behind)
      {
        continue;
      }
      const bool ofPoints = points || data->GetNumberOfCells() == 0;
      const vtkIdType most = ofPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells();
      for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
      {
        FuzzExpect(ids->GetValue(i) >= 0 && ids->GetValue(i) < most,
          std::string("selected ") + (points ? "point " : "cell ") +
            std::to_string(ids->GetValue(i)) + " of " + std::to_string(most) + Describe(splats));
      }
    }
  }
}

void FuzzScenes::Implementation::ChangeSomething(
  FuzzRandom& random, std::vector<Splats>& all, vtkRenderer* renderer)
{
  Splats& splats = all[static_cast<size_t>(random.Below(static_cast<int>(all.size())))];
  switch (random.Below(10))
  {
    case 0:
      // Seldom one that can be drawn in parts.
      this->Window->SetSize(
        1 + random.Below(random.Chance(0.1) ? 400 : 150), 1 + random.Below(100));
      break;
    case 1:
      FuzzData::Change(random, splats.Data);
      break;
    case 2:
      FuzzProperties::SetOwn(random, splats.Mapper);
      FuzzProperties::SetShared(random, splats.Mapper);
      break;
    case 3:
      FuzzProperties::SetColouring(random, splats.Mapper);
      break;
    case 4:
      FuzzProperties::SetActor(random, splats.Actor);
      break;
    case 5:
      FuzzProperties::SetCamera(random, renderer);
      break;
    case 6:
      if (renderer->HasViewProp(splats.Actor))
      {
        renderer->RemoveActor(splats.Actor);
      }
      else
      {
        renderer->AddActor(splats.Actor);
      }
      break;
    case 7:
      splats.Actor->ReleaseGraphicsResources(this->Window);
      break;
    case 8:
      splats.Data = FuzzData::MakeAny(random);
      splats.Mapper->SetInputDataObject(splats.Data);
      break;
    default:
      splats.Actor->SetVisibility(!splats.Actor->GetVisibility());
      renderer->AddActor(MakeMesh(random));
      break;
  }
}

void FuzzScenes::Implementation::RunAny(FuzzRandom& random)
{
  const bool large = random.Chance(0.15);
  this->Window->SetSize(1 + random.Below(random.Chance(0.1) ? 3 : large ? 300 : 120),
    1 + random.Below(random.Chance(0.1) ? 3 : large ? 200 : 80));
  std::vector<vtkSmartPointer<vtkRenderer>> renderers;
  for (int r = random.Chance(0.8) ? 0 : random.Below(3); r >= 0; --r)
  {
    renderers.push_back(this->AddRenderer(random, static_cast<int>(renderers.size())));
  }
  std::vector<Splats> all;
  for (int a = random.Below(3); a >= 0; --a)
  {
    all.push_back(MakeSplats(random, FuzzData::MakeAny(random)));
    FuzzProperties::SetShared(random, all.back().Mapper);
    vtkRenderer* renderer =
      renderers[static_cast<size_t>(random.Below(static_cast<int>(renderers.size())))];
    if (random.Chance(0.1))
    {
      vtkNew<vtkAssembly> assembly;
      assembly->AddPart(all.back().Actor);
      renderer->AddActor(assembly);
    }
    else
    {
      renderer->AddActor(all.back().Actor);
    }
    if (random.Chance(0.1))
    {
      renderers[0]->AddActor(all.back().Actor); // in two renderers, with one mapper
    }
  }
  if (random.Chance(0.3))
  {
    renderers[0]->AddActor(MakeMesh(random));
  }
  for (vtkRenderer* renderer : renderers)
  {
    FuzzProperties::SetCamera(random, renderer);
    FuzzProperties::SetLights(random, renderer, true);
    FuzzProperties::SetEnvironment(random, renderer, true);
  }

  for (int frame = random.Below(3); frame >= 0; --frame)
  {
    std::vector<std::uint64_t> before;
    for (const Splats& splats : all)
    {
      before.push_back(FuzzData::Digest(splats.Data));
    }
    this->Draw("after a frame"); // VTK's cullers may want one more
    const Pixels first = this->Draw("after a second frame");
    this->Messages.TakeOwn();
    const Pixels second = this->Draw("after the same frame again");
    const std::vector<std::string> said = this->Messages.TakeOwn();
    FuzzExpect(said.empty(), "said again at a frame without change: " + (said.empty() ? "" : said[0]));
    // Where hundreds of splats share a pixel, compute shaders take those that come first.
    vtkIdType splatsInAll = 0;
    for (const Splats& splats : all)
    {
      splatsInAll += splats.Mapper->GetNumberOfSplats();
    }
    FuzzExpect(first == second || splatsInAll > SplatsThatAddUp,
      "a frame without change differs from the one before in " +
        std::to_string(std::inner_product(first.begin(), first.end(), second.begin(), 0L,
          std::plus<long>(), std::not_equal_to<unsigned char>())) +
        " bytes" + Describe(all));
    for (size_t a = 0; a < all.size(); ++a)
    {
      FuzzExpect(before[a] == FuzzData::Digest(all[a].Data), "drawing changed the data");
      all[a].Mapper->GetBounds();
      all[a].Mapper->GetImageMemorySize();
    }
    if (random.Chance(0.15))
    {
      this->Select(random, all);
    }
    this->ChangeSomething(random, all, renderers[0]);
  }
}

void FuzzScenes::Implementation::RunNeighbour(FuzzRandom& random)
{
  const int size[2] = { 60 + random.Below(140), 60 + random.Below(140) };
  this->Window->SetSize(size[0], size[1]);
  vtkNew<vtkRenderer> renderer;
  this->Window->AddRenderer(renderer);
  const double left[3] = { -1, 0, 0 };
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(FuzzData::MakeSphere(left, 0.7));
  mapper->SetProjection(random.Below(3));
  mapper->SetMethodToTwoPass(); // groups of wild radii may send deferred blending to two passes
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const double opacity = random.Chance(0.7) ? 1 : 0.5;
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 5);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetParallelProjection(random.Chance(0.5));
  camera->SetParallelScale(1.8);
  camera->SetViewAngle(40);
  camera->SetClippingRange(1, 20);
  const Pixels alone = this->Draw("after a good frame");

  Splats wild = MakeSplats(random, FuzzData::MakeAny(random));
  wild.Mapper->SetMethodToTwoPass();
  wild.Mapper->SetProjection(mapper->GetProjection());
  wild.Mapper->SetMaximumImageMemory(mapper->GetMaximumImageMemory());
  // Outlines are smooth where all actors of a frame want it.
  wild.Mapper->SetAntiAliasing(mapper->GetAntiAliasing());
  // VTK's points and lines are wider than what clipping planes leave of them.
  wild.Actor->GetProperty()->SetRepresentationToSurface();
  wild.Mapper->RemoveAllClippingPlanes();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1, 0, 0);
  plane->SetOrigin(0, 0, 0);
  wild.Mapper->AddClippingPlane(plane);
  wild.Actor->AddPosition(1, 0, 0);
  renderer->AddActor(wild.Actor);
  const Pixels together = this->Draw("after a frame with a neighbour");
  // Left of the middle there is nothing of it.
  constexpr int Margin = 3;
  const FuzzChange change(alone, together, size[0], size[0] / 2 - Margin);
  FuzzExpect(change.Pixels == 0,
    "a neighbour changes " + std::to_string(change.Pixels) +
      " pixels of a good actor, by up to " + std::to_string(change.Worst) + Describe(wild));
}

void FuzzScenes::Implementation::RunFloats(FuzzRandom& random)
{
  this->Window->SetSize(20 + random.Below(100), 20 + random.Below(100));
  vtkNew<vtkRenderer> renderer;
  this->Window->AddRenderer(renderer);
  vtkNew<vtkFramebufferPass> pass;
  pass->SetColorFormat(vtkTextureObject::Float32);
  pass->SetDepthFormat(vtkTextureObject::Fixed32);
  pass->SetDelegatePass(MakeChain(random));
  renderer->SetPass(pass);
  std::vector<Splats> all;
  for (int a = random.Below(2); a >= 0; --a)
  {
    all.push_back(MakeSplats(random, FuzzData::MakeAny(random)));
    FuzzProperties::SetShared(random, all.back().Mapper);
    // Infinite light is VTK's affair.
    vtkProperty* property = all.back().Actor->GetProperty();
    property->SetOpacity(random.Uniform());
    property->SetSpecular(random.Uniform());
    property->SetSpecularPower(random.Uniform(0, 128));
    renderer->AddActor(all.back().Actor);
  }
  FuzzProperties::SetCamera(random, renderer);
  FuzzProperties::SetLights(random, renderer, false);
  FuzzProperties::SetEnvironment(random, renderer, false);
  this->Draw("after a frame of floats");
  vtkTextureObject* texture = pass->GetColorTexture();
  auto buffer = vtkSmartPointer<vtkPixelBufferObject>::Take(texture->Download());
  const unsigned int dimensions[2] = { texture->GetWidth(), texture->GetHeight() };
  const int components = texture->GetComponents();
  std::vector<float> values(
    static_cast<size_t>(components) * dimensions[0] * dimensions[1], 0.0f);
  unsigned int wanted[2] = { dimensions[0], dimensions[1] };
  vtkIdType increments[2] = { 0, 0 };
  FuzzExpect(buffer->Download2D(VTK_FLOAT, values.data(), wanted, components, increments),
    "the image cannot be read");
  this->ExpectNoError("after reading floats");
  renderer->ReleaseGraphicsResources(this->Window);
  pass->ReleaseGraphicsResources(this->Window);
  for (const float value : values)
  {
    FuzzExpect(std::isfinite(value), "a pixel's colour is not finite");
  }
}

FuzzScenes::FuzzScenes(FuzzMessages& messages)
  : Internals(new Implementation(messages))
{
}

FuzzScenes::~FuzzScenes() = default;

void FuzzScenes::Reset(std::uint64_t seed)
{
  this->Internals->Window = nullptr;
  this->Internals->WindowSeed = seed;
}

void FuzzScenes::Run(FuzzRandom& random)
{
  Implementation& scenes = *this->Internals;
  if (!scenes.Window)
  {
    scenes.Window = vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New();
    scenes.Window->SetSize(100, 100);
    FuzzRandom window(scenes.WindowSeed);
    scenes.Window->SetMultiSamples(window.Chance(0.1) ? 4 : 0);
    scenes.Window->SetAlphaBitPlanes(window.Chance(0.2));
    scenes.Window->Render();
  }
  const int kind = random.Below(10);
  if (kind < 6)
  {
    scenes.RunAny(random);
  }
  else if (kind < 9)
  {
    scenes.RunNeighbour(random);
  }
  else
  {
    scenes.RunFloats(random);
  }
  scenes.Clear();
}
