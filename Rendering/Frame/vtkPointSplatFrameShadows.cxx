// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFrameShadows.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPointSplatChoices.h"
#include "vtkPointSplatCollection.h"
#include "vtkPointSplatLights.h"
#include "vtkPointSplatSource.h"
#include "vtkPointSplatStopwatch.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
double Rms(const double* colour)
{
  return std::sqrt(
    (colour[0] * colour[0] + colour[1] * colour[1] + colour[2] * colour[2]) / 3.0);
}

// Of the scene's splats, which have a map's pixel or two: how long the edges are of triangles that cast
// shadows in the place of splats. Shorter ones cast the same and take longer: a torus of 2 million in
// moving light 719 ms of processor time a frame instead of 398.
constexpr double TriangleRadii = 4.0;

// Of translucent splats that a light sees. Behind so many next to nothing of it is left.
constexpr int MostLayers = 16;

/// By which requests of casters are told apart, whatever their views are.
vtkPointSplatView SomeView()
{
  vtkPointSplatView view;
  view.Size = glm::ivec2(1);
  view.PixelX = glm::vec4(1.0f, 0.0f, 0.0f, 0.0f);
  view.PixelY = glm::vec4(0.0f, 1.0f, 0.0f, 0.0f);
  view.PixelW = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  view.Parallel = true;
  return view;
}

/// The meshes that a mapper draws; its input is brought up to date, as it will do itself.
std::vector<vtkPolyData*> MeshesOf(vtkMapper* mapper)
{
  std::vector<vtkPolyData*> meshes;
  if (mapper->GetNumberOfInputConnections(0) == 0)
  {
    return meshes;
  }
  if (!mapper->GetStatic())
  {
    mapper->GetInputAlgorithm()->Update(mapper->GetInputConnection(0, 0)->GetIndex());
  }
  vtkDataObject* input = mapper->GetExecutive()->GetInputData(0, 0);
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      meshes.push_back(vtkPolyData::SafeDownCast(it->GetCurrentDataObject()));
    }
  }
  else
  {
    meshes.push_back(vtkPolyData::SafeDownCast(input));
  }
  meshes.erase(std::remove(meshes.begin(), meshes.end(), nullptr), meshes.end());
  return meshes;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatFrameShadows::AddActor(
  vtkActor* actor, const glm::dmat4& matrix, Gathered& all)
{
  vtkMapper* mapper = actor->GetMapper();
  if (vtkPointSplatSource* source = vtkPointSplatSource::Of(actor))
  {
    const vtkPointSplatSettings settings = source->GetSettings(all.Renderer, nullptr);
    if (source->Update(settings))
    {
      vtkPointSplatShadowCloud cloud;
      cloud.Cloud = &source->GetCloud();
      cloud.MCWC = matrix;
      cloud.ClipPlanes = vtkPointSplatItem::ClipPlanesOf(mapper);
      cloud.Casts = !actor->HasTranslucentPolygonalGeometry();
      cloud.CastsTriangles = settings.Hybrid != vtkPointSplatSettings::HybridOff;
      if (cloud.CastsTriangles)
      {
        cloud.Cloud->MakeTriangles();
      }
      cloud.Receives = settings.Shadows;
      all.HasTranslucent = all.HasTranslucent || !cloud.Casts;
      all.Scene.Clouds.push_back(cloud);
      if (cloud.Receives)
      {
        vtkProperty* property = actor->GetProperty();
        all.Receivers.push_back({ source, settings,
          property->GetDiffuse() *
            (cloud.Cloud->HasColours() ? 1.0 : Rms(property->GetDiffuseColor())) });
      }
    }
  }
  else if (vtkPolyDataMapper::SafeDownCast(mapper) && !actor->HasTranslucentPolygonalGeometry() &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE)
  {
    for (vtkPolyData* mesh : MeshesOf(mapper))
    {
      all.Scene.Meshes.push_back({ mesh, matrix, vtkPointSplatItem::ClipPlanesOf(mapper) });
    }
  }
}

//------------------------------------------------------------------------------
vtkPointSplatFrameShadows::Gathered vtkPointSplatFrameShadows::Gather(vtkRenderer* renderer)
{
  Gathered all;
  all.Renderer = renderer;
  all.Interacting = vtkPointSplatStopwatch::IsInteracting(renderer);
  for (vtkProp* prop : vtkPointSplatCollection::VisibleProps(renderer))
  {
    if (auto actor = vtkActor::SafeDownCast(prop))
    {
      vtkPointSplatFrameShadows::AddActor(
        actor, vtkPointSplatView::Matrix(actor->GetMatrix()), all);
      continue;
    }
    prop->InitPathTraversal(); // of assemblies
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      auto actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (actor && actor->GetVisibility() && node->GetMatrix())
      {
        vtkPointSplatFrameShadows::AddActor(
          actor, vtkPointSplatView::Matrix(node->GetMatrix()), all);
      }
    }
  }
  if (all.Receivers.empty())
  {
    return all;
  }
  const double radius = vtkPointSplatShadows::RadiusOf(all.Scene);
  for (vtkPointSplatShadowCloud& cloud : all.Scene.Clouds)
  {
    cloud.CastsTriangles = cloud.HasTriangles() &&
      cloud.GetMeanStretch() * cloud.Cloud->GetTriangles().GetLongestEdge() >=
        TriangleRadii * radius;
  }
  const double error = this->AddLights(renderer, all);
  const vtkPointSplatSettings& first = all.Receivers[0].Settings;
  vtkPointSplatShadowSettings& settings = all.Settings;
  settings.Seed = static_cast<unsigned int>(first.ShadowSeed);
  settings.LayerDistance = first.ShadowLayerDistance;
  settings.Resolution = first.ShadowResolution;
  for (const Receiver& receiver : all.Receivers)
  {
    std::string reason;
    const int samples = vtkPointSplatChoices::ShadowSamples(
      receiver.Settings, all.Interacting, receiver.Diffuse * error, reason);
    if (samples >= settings.Samples)
    {
      settings.Samples = samples;
      this->Reason = reason;
    }
    settings.Compute =
      settings.Compute && receiver.Settings.Projection != vtkPointSplatSettings::Quads;
  }
  return all;
}

//------------------------------------------------------------------------------
double vtkPointSplatFrameShadows::AddLights(vtkRenderer* renderer, Gathered& all)
{
  std::vector<vtkLight*> lights = vtkPointSplatLights::Of(renderer, true);
  if (lights.size() > vtkPointSplatLights::MostCasting)
  {
    if (!this->Warned)
    {
      vtkWarningWithObjectMacro(all.Receivers[0].Source->GetMapper(),
        << "Only the first " << vtkPointSplatLights::MostCasting
        << " lights cast shadows; turn others off.");
    }
    this->Warned = true;
    lights.resize(vtkPointSplatLights::MostCasting);
  }
  std::vector<glm::dvec3> corners;
  for (const vtkPointSplatShadowCloud& cloud : all.Scene.Clouds)
  {
    vtkPointSplatShadows::AddCorners(cloud, corners);
  }
  glm::dvec3 centre(0.0);
  if (!corners.empty())
  {
    const auto [low, high] = vtkPointSplatShadows::BoxOf(corners);
    centre = 0.5 * (low + high);
  }
  double error = 0.0; // those of several lights are independent
  for (vtkLight* light : lights)
  {
    const vtkPointSplatShadowLight lamp =
      vtkPointSplatShadowLight::From(light, all.Receivers[0].Settings.ShadowLightRadius);
    const double* colour = light->GetDiffuseColor();
    error = std::hypot(error,
      light->GetIntensity() * std::max({ colour[0], colour[1], colour[2] }) *
        vtkPointSplatChoices::OneSampleError(lamp.GetTangent(centre)));
    all.Scene.Lights.push_back(lamp);
  }
  return error;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrameShadows::Update(
  vtkRenderer* renderer, vtkPointSplatReconstruction& reconstruction)
{
  const Gathered all = this->Gather(renderer);
  if (all.Receivers.empty())
  {
    return true;
  }
  if (!this->Cache.Update(all.Scene, all.Settings, all.Interacting))
  {
    this->Error = this->Cache.GetError();
    return false;
  }
  return this->UpdateMaps(renderer, reconstruction, all, false);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrameShadows::UpdateMaps(
  vtkRenderer* renderer, vtkPointSplatReconstruction& reconstruction, bool opaque)
{
  return this->UpdateMaps(renderer, reconstruction, this->Gather(renderer), opaque);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrameShadows::UpdateMaps(vtkRenderer* renderer,
  vtkPointSplatReconstruction& reconstruction, const Gathered& all, bool opaque)
{
  this->HasMaps = !all.Scene.Lights.empty() && (opaque || all.HasTranslucent);
  if (!this->HasMaps)
  {
    return true;
  }
  vtkPointSplatTranslucentCasters casters;
  if (all.HasTranslucent)
  {
    this->Casters = vtkPointSplatCollection::Collect(renderer, true, nullptr);
    casters.Request = this->MakeRequest(SomeView());
    for (const vtkPointSplatItem& item : casters.Request.Items)
    {
      casters.Colours.push_back(item.Colour);
    }
    casters.Peel = [this, &reconstruction](const vtkPointSplatView& view, glm::ivec4& window)
    {
      const bool good = this->Layers.Build(this->MakeRequest(view), reconstruction);
      window = this->Layers.GetRequest().GetWindow();
      return good ? &this->Layers.GetLayers() : nullptr;
    };
  }
  if (!this->Maps.Update(all.Scene, all.Settings,
        { opaque, casters.Colours.empty() ? nullptr : &casters, all.Interacting }))
  {
    this->Error = this->Maps.GetError();
    this->HasMaps = false;
    return false;
  }
  std::vector<vtkPointSplatLightMaps::Light>& lights = this->Maps.GetMaps().Lights;
  lights.clear();
  size_t casting = 0;
  for (vtkLight* light : vtkPointSplatLights::Of(renderer, false))
  {
    const bool casts =
      vtkPointSplatLights::Casts(light) && casting < this->Maps.GetLights().size();
    lights.push_back(
      casts ? this->Maps.GetLights()[casting++] : vtkPointSplatLightMaps::Light());
  }
  return true;
}

//------------------------------------------------------------------------------
vtkPointSplatRequest vtkPointSplatFrameShadows::MakeRequest(const vtkPointSplatView& view)
{
  vtkPointSplatFacts facts =
    vtkPointSplatCollection::Describe(this->Casters, view, true, 0.0);
  facts.Compute = vtkPointSplatTiles::IsSupported(view.Size);
  facts.AsksDeferred = false;
  facts.Transparency = vtkPointSplatSettings::Peeling;
  const vtkPointSplatChoice choice = vtkPointSplatChoices::Make(facts);
  vtkPointSplatRequest request;
  request.View = view;
  request.Compute = choice.Compute;
  request.OnDevice = !vtkPointSplatContext::IsSoftware();
  request.FillSteps = choice.FillSteps;
  request.MaximumLayers = std::min(choice.MaximumLayers, MostLayers);
  request.LeastContribution = choice.LeastContribution;
  for (vtkPointSplatEntry& entry : this->Casters)
  {
    vtkPointSplatCollection::MakeItem(
      entry, static_cast<int>(request.Items.size()), view, choice);
    request.Items.push_back(entry.Item);
    request.CloudTimes.push_back(entry.Item.Cloud->GetMTime());
    request.MaximumMemory =
      std::max(request.MaximumMemory, entry.Settings.MaximumImageMemory);
  }
  return request;
}

//------------------------------------------------------------------------------
vtkPointSplatLightMaps* vtkPointSplatFrameShadows::GetMaps()
{
  return this->HasMaps && !this->Maps.GetMaps().Lights.empty() ? &this->Maps.GetMaps() : nullptr;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrameShadows::Release()
{
  this->Cache.Release();
  this->Maps.Release();
  this->Layers.Release();
  this->Casters.clear();
  this->HasMaps = false;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrameShadows::SetFactors(vtkPointSplatItem& item, bool shadows, bool grouped)
{
  if (shadows)
  {
    item.Factors = this->Cache.GetFactors(item, grouped, item.FactorDeviations);
    item.FactorCount = item.Factors ? this->Cache.GetNumberOfLights() : 0;
    item.FactorVersion = this->Cache.GetNumberOfUpdates();
  }
  else if (item.Cloud->GetFactorCount() > 0)
  {
    item.Factors = grouped ? &item.Cloud->UploadGrouped().Factors
      : item.IsStreamed    ? &item.Cloud->GetRunBuffers().Factors // filled with the rest
                           : &item.Cloud->Upload().Factors;
    item.FactorCount = item.Cloud->GetFactorCount();
    item.FactorDeviations = item.Cloud->GetFactorDeviations();
  }
}
