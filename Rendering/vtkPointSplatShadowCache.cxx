// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadowCache.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointSplatChoices.h"
#include "vtkPointSplatContrast.h"
#include "vtkPointSplatMapper.h"
#include "vtkPointSplatStages.h"
#include "vtkPointSplatView.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// As many as the shaders take.
constexpr size_t MaximumClipPlanes = 6;

std::vector<glm::dvec4> ClipPlanesOf(vtkMapper* mapper)
{
  std::vector<glm::dvec4> result;
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    vtkPlane* plane = nullptr;
    while (result.size() < MaximumClipPlanes && (plane = planes->GetNextPlane(it)))
    {
      const double* n = plane->GetNormal();
      result.emplace_back(n[0], n[1], n[2], -vtkMath::Dot(n, plane->GetOrigin()));
    }
  }
  return result;
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
bool vtkPointSplatShadowCache::Scene::IsLike(const Scene& other) const
{
  vtkPointSplatShadowSettings settings = other.Settings;
  settings.Samples = this->Settings.Samples;
  return this->Lights == other.Lights && this->Times == other.Times &&
    this->Settings == settings && this->Clouds == other.Clouds && this->Meshes == other.Meshes;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowCache::Casts(vtkLight* light)
{
  return light->GetSwitch() && !light->LightTypeIsHeadlight() &&
    vtkPointSplatShadowLight::From(light, 0.0).IsFinite();
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowCache::AddActor(vtkActor* actor, const glm::dmat4& matrix, Scene& scene,
  std::vector<Receiver>& receivers)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  if (auto splats = vtkPointSplatMapper::SafeDownCast(mapper))
  {
    if (!splats->UpdateCloud())
    {
      return;
    }
    vtkPointSplatShadowCloud cloud;
    cloud.Cloud = splats->GetCloud();
    cloud.MCWC = matrix;
    cloud.ClipPlanes = ClipPlanesOf(mapper);
    cloud.Casts = !actor->HasTranslucentPolygonalGeometry();
    cloud.Receives = splats->GetShadows();
    if (cloud.Receives)
    {
      receivers.push_back({ splats, vtkPointSplatContrast::OfLight(actor, splats) });
    }
    scene.Clouds.push_back(cloud);
  }
  else if (vtkPolyDataMapper::SafeDownCast(mapper) && !actor->HasTranslucentPolygonalGeometry() &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE)
  {
    for (vtkPolyData* mesh : MeshesOf(mapper))
    {
      scene.Meshes.push_back({ mesh, matrix, ClipPlanesOf(mapper) });
    }
  }
}

//------------------------------------------------------------------------------
vtkPointSplatShadowCache::Scene vtkPointSplatShadowCache::Gather(
  vtkRenderer* renderer, bool interacting)
{
  Scene scene;
  std::vector<Receiver> receivers;
  vtkCollectionSimpleIterator it;
  renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    if (auto actor = vtkActor::SafeDownCast(prop))
    {
      vtkPointSplatShadowCache::AddActor(
        actor, vtkPointSplatView::Matrix(actor->GetMatrix()), scene, receivers);
      continue;
    }
    prop->InitPathTraversal(); // of assemblies
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      auto actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (actor && actor->GetVisibility() && node->GetMatrix())
      {
        vtkPointSplatShadowCache::AddActor(
          actor, vtkPointSplatView::Matrix(node->GetMatrix()), scene, receivers);
      }
    }
  }
  if (receivers.empty())
  {
    return scene;
  }
  for (const vtkPointSplatShadowCloud& cloud : scene.Clouds)
  {
    scene.Times.push_back(cloud.Cloud->GetGeometryMTime());
  }
  for (const vtkPointSplatShadowMesh& mesh : scene.Meshes)
  {
    scene.Times.push_back(mesh.Data->GetMTime());
  }

  double intensity = 0.0; // errors of several lights are independent
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (!vtkPointSplatShadowCache::Casts(light))
    {
      continue;
    }
    if (scene.Lights.size() < static_cast<size_t>(MaximumLights))
    {
      const double* colour = light->GetDiffuseColor();
      intensity = std::hypot(intensity,
        light->GetIntensity() * std::max({ colour[0], colour[1], colour[2] }));
      scene.Lights.push_back(
        vtkPointSplatShadowLight::From(light, receivers[0].Mapper->GetShadowLightRadius()));
    }
    else if (!this->Warned)
    {
      this->Warned = true;
      vtkWarningWithObjectMacro(receivers[0].Mapper,
        << "Only the first " << MaximumLights << " lights cast shadows; turn others off.");
    }
  }

  scene.Settings.Samples = 1;
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  scene.Settings.Compute = vtkPointSplatStages::ComputeSupported(window);
  for (const Receiver& receiver : receivers)
  {
    vtkPointSplatMapper* mapper = receiver.Mapper;
    std::string reason;
    const int samples = vtkPointSplatChoices::ShadowSamples(mapper->GetNumberOfShadowSamples(),
      mapper->GetNumberOfInteractiveShadowSamples(), interacting, mapper->GetTargetError(),
      receiver.Diffuse * intensity, reason);
    if (samples >= scene.Settings.Samples)
    {
      scene.Settings.Samples = samples;
      this->SamplesReason = reason;
    }
    scene.Settings.Compute =
      scene.Settings.Compute && mapper->GetProjection() != vtkPointSplatMapper::QUADS;
  }
  scene.Settings.Seed = static_cast<unsigned int>(receivers[0].Mapper->GetShadowSeed());
  scene.Settings.LayerDistance = receivers[0].Mapper->GetShadowLayerDistance();
  scene.Settings.Resolution = receivers[0].Mapper->GetShadowResolution();
  return scene;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowCache::Update(vtkRenderer* renderer, bool interacting)
{
  Scene scene = this->Gather(renderer, interacting);
  const int had = this->Now.Settings.Samples;
  const int wanted = scene.Settings.Samples;
  if (this->Valid && this->Now.IsLike(scene) && (interacting ? had >= wanted : had == wanted))
  {
    return true;
  }
  this->Now = std::move(scene);
  this->Valid = this->Compute(renderer);
  ++this->Updates;
  return this->Valid;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowCache::Compute(vtkRenderer* renderer)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const std::vector<vtkPointSplatShadowCloud>& clouds = this->Now.Clouds;
  std::vector<std::vector<uint32_t>> packed(clouds.size());
  for (size_t i = 0; i < clouds.size(); ++i)
  {
    if (clouds[i].Receives)
    {
      packed[i].assign(static_cast<size_t>(clouds[i].Cloud->GetNumberOfSplats()), 0xffffffffu);
    }
  }
  this->SamplesUsed = 0;
  vtkPointSplatShadowSettings settings = this->Now.Settings;
  for (size_t light = 0; light < this->Now.Lights.size(); ++light)
  {
    std::vector<std::vector<float>> factors;
    if (!this->Shadows.Cast(
          window, this->Now.Lights[light], clouds, this->Now.Meshes, settings, factors))
    {
      this->Error = this->Shadows.GetError();
      return false;
    }
    ++settings.Seed;
    this->SamplesUsed = this->Shadows.GetSamplesUsed();
    const unsigned int shift = 8 * static_cast<unsigned int>(light);
    for (size_t i = 0; i < clouds.size(); ++i)
    {
      vtkSMPTools::For(
        0, static_cast<vtkIdType>(factors[i].size()), [&](vtkIdType first, vtkIdType last) {
          for (size_t k = static_cast<size_t>(first); k < static_cast<size_t>(last); ++k)
          {
            packed[i][k] &= ~(255u << shift);
            packed[i][k] |= static_cast<uint32_t>(std::lround(255.0f * factors[i][k])) << shift;
          }
        });
    }
  }
  if (!this->Buffers.empty())
  {
    glDeleteBuffers(static_cast<GLsizei>(this->Buffers.size()), this->Buffers.data());
  }
  this->Buffers.assign(clouds.size(), 0);
  for (size_t i = 0; i < clouds.size() && !this->Now.Lights.empty(); ++i)
  {
    if (clouds[i].Receives)
    {
      glGenBuffers(1, &this->Buffers[i]);
      glBindBuffer(GL_ARRAY_BUFFER, this->Buffers[i]);
      glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * packed[i].size()),
        packed[i].data(), GL_STATIC_DRAW);
    }
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return true;
}

//------------------------------------------------------------------------------
GLuint vtkPointSplatShadowCache::GetFactors(
  const vtkPointSplatCloud* cloud, const glm::dmat4& MCWC) const
{
  for (size_t i = 0; i < this->Buffers.size(); ++i)
  {
    if (this->Now.Clouds[i].Cloud == cloud && this->Now.Clouds[i].MCWC == MCWC)
    {
      return this->Buffers[i];
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowCache::Release()
{
  this->Shadows.Release();
  if (!this->Buffers.empty())
  {
    glDeleteBuffers(static_cast<GLsizei>(this->Buffers.size()), this->Buffers.data());
  }
  this->Forget();
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowCache::Forget()
{
  this->Buffers.clear();
  this->Now = Scene();
  this->Valid = false;
}
