// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadowMaps.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double MostBytes = 256.0 * 1024.0 * 1024.0;
constexpr int LeastMap = 64;    // pixels along a side
constexpr int LargestMap = 4096;
// Of a light, at most: each is asked at each pixel.
constexpr int MostSamples = 32;

/// Of the axes of a cube's face, as toFace() in vtkPointSplatShadowMap.glsl has it.
glm::dmat4 FaceMatrix(int face)
{
  if (face < 0)
  {
    return glm::dmat4(1.0);
  }
  glm::dmat4 rows(0.0);
  const int axis = face / 2;
  for (int k = 0; k < 3; ++k)
  {
    rows[k][(k + axis + 1) % 3] = k == 2 && (face & 1) != 0 ? -1.0 : 1.0;
  }
  rows[3][3] = 1.0;
  return glm::transpose(rows);
}
}

/**
 * A map to draw.
 */
struct vtkPointSplatShadowMaps::Plan
{
  vtkPointSplatShadowView View;
  int Face; // of a cube; -1: there is none

  glm::dmat4 GetWCLC() const { return FaceMatrix(this->Face) * this->View.WCLC; }
  /// The same as a camera, in front of whose near plane is room for splats about the first point;
  /// it has the depths of the light by an offset.
  vtkPointSplatView GetCamera(double margin, double& depthOffset) const;
};

//------------------------------------------------------------------------------
vtkPointSplatView vtkPointSplatShadowMaps::Plan::GetCamera(double margin, double& depthOffset) const
{
  const vtkPointSplatShadowView& light = this->View;
  vtkPointSplatView camera;
  camera.Size = light.Size;
  camera.Parallel = light.Parallel;
  // The eye of a parallel view stands off by as much as the points reach.
  const double back = light.Parallel ? light.Depth + 2.0 * margin : 0.0;
  const glm::dmat4 turn(glm::dvec4(1.0, 0.0, 0.0, 0.0), glm::dvec4(0.0, -1.0, 0.0, 0.0),
    glm::dvec4(0.0, 0.0, -1.0, 0.0), glm::dvec4(0.0, 0.0, -back, 1.0));
  camera.WCVC = turn * this->GetWCLC();
  camera.Near = light.Parallel ? back - margin : light.NearDistance;
  camera.Far = back + light.Depth + margin;
  depthOffset = camera.Near - back;
  const double range = camera.Far - camera.Near;
  const glm::dvec2 offset(light.Offset.x, light.Size.y - light.Offset.y); // rows are turned round
  if (light.Parallel)
  {
    camera.PixelX = glm::vec4(light.Scale.x, 0.0, 0.0, offset.x);
    camera.PixelY = glm::vec4(0.0, light.Scale.y, 0.0, offset.y);
    camera.PixelW = glm::vec4(0.0, 0.0, 0.0, 1.0);
    camera.PixelZ = glm::vec4(0.0, 0.0, -2.0 / range, -(camera.Far + camera.Near) / range);
  }
  else
  {
    camera.PixelX = glm::vec4(light.Scale.x, 0.0, -offset.x, 0.0);
    camera.PixelY = glm::vec4(0.0, light.Scale.y, -offset.y, 0.0);
    camera.PixelW = glm::vec4(0.0, 0.0, -1.0, 0.0);
    camera.PixelZ = glm::vec4(
      0.0, 0.0, -(camera.Far + camera.Near) / range, -2.0 * camera.Far * camera.Near / range);
  }
  return camera;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowMaps::IsValid(const vtkPointSplatShadowScene& scene,
  const vtkPointSplatShadowSettings& settings, const Wanted& wanted) const
{
  const vtkPointSplatTranslucentCasters* casters = wanted.Translucent;
  vtkPointSplatShadowSettings like = settings;
  like.Samples =
    wanted.Interacting ? std::max(like.Samples, this->Settings.Samples) : like.Samples;
  return this->Valid && this->Context == vtkPointSplatContext::Entered() &&
    this->Settings == like && this->Times == scene.GetTimes() && this->Scene == scene &&
    (this->Maps.HasDepths || !wanted.Opaque) && this->Maps.HasLayers == (casters != nullptr) &&
    (!casters || (this->Request == casters->Request && this->SlotColours == casters->Colours));
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowMaps::Update(const vtkPointSplatShadowScene& scene,
  const vtkPointSplatShadowSettings& settings, const Wanted& wanted)
{
  if (this->IsValid(scene, settings, wanted))
  {
    return true;
  }
  this->Context = vtkPointSplatContext::Entered();
  this->Scene = scene;
  this->Settings = settings;
  this->Times = scene.GetTimes();
  this->Maps.HasDepths = wanted.Opaque;
  this->Maps.HasLayers = wanted.Translucent != nullptr;
  if (wanted.Translucent)
  {
    this->Request = wanted.Translucent->Request;
    this->SlotColours = wanted.Translucent->Colours;
    this->Colours.Upload(this->SlotColours);
  }
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  int maximum = std::min(largest, LargestMap);
  std::vector<Plan> plans = this->MakePlans(wanted, maximum);
  const double texel = (this->Maps.HasDepths ? 4.0 : 0.0) +
    (this->Maps.HasLayers ? 8.0 * vtkPointSplatLightMaps::MostLayers : 0.0);
  const int fitting = static_cast<int>(
    std::sqrt(MostBytes / (texel * static_cast<double>(std::max(plans.size(), size_t(1))))));
  if (fitting < maximum)
  {
    plans = this->MakePlans(wanted, std::max(fitting, LeastMap));
  }
  this->Valid = this->Draw(plans, wanted);
  return this->Valid;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatShadowMaps::Plan> vtkPointSplatShadowMaps::MakePlans(
  const Wanted& wanted, int maximum)
{
  const double radius = vtkPointSplatShadows::RadiusOf(this->Scene);
  std::vector<glm::dvec3> corners;
  for (const vtkPointSplatShadowCloud& cloud : this->Scene.Clouds)
  {
    vtkPointSplatShadows::AddCorners(cloud, corners);
  }
  for (const vtkPointSplatShadowMesh& mesh : this->Scene.Meshes)
  {
    if (wanted.Opaque && mesh.Data->GetNumberOfPoints() > 0)
    {
      vtkPointSplatShadows::AddCorners(mesh.MCWC, mesh.Data->GetBounds(), corners);
    }
  }
  GLint images = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &images);
  const int perSample = 6 * (wanted.Translucent ? vtkPointSplatLightMaps::MostLayers : 1) *
    static_cast<int>(std::max(this->Scene.Lights.size(), size_t(1)));
  const int count =
    std::min({ this->Settings.Samples, MostSamples, std::max(images / perSample, 1) });
  std::vector<Plan> plans;
  this->Lights.assign(this->Scene.Lights.size(), vtkPointSplatLightMaps::Light());
  unsigned int seed = this->Settings.Seed;
  for (size_t i = 0; i < this->Lights.size() && !corners.empty(); ++i)
  {
    const vtkPointSplatShadowLight& light = this->Scene.Lights[i];
    const double pixel = vtkPointSplatShadows::PixelSizeFor(light, count, corners, radius);
    const std::vector<vtkPointSplatShadowLight> samples = light.Sample(count, seed++);
    std::vector<vtkPointSplatShadowView> views;
    for (const vtkPointSplatShadowLight& sample : samples)
    {
      views.push_back(vtkPointSplatShadowView::Fit(
        sample, corners, pixel, std::min(this->Settings.Resolution, maximum), maximum));
    }
    // Where one sample stands among what casts and another does not, the latter ones are left out.
    const bool cube = std::any_of(views.begin(), views.end(),
      [](const vtkPointSplatShadowView& view) { return view.Cube; });
    this->Lights[i].First = static_cast<int>(plans.size());
    this->Lights[i].Faces = cube ? 6 : 1;
    for (const vtkPointSplatShadowView& view : views)
    {
      if (view.Size.x < 1 || view.Cube != cube)
      {
        continue; // by an actor's matrix all is nowhere
      }
      ++this->Lights[i].Samples;
      for (int face = 0; face < this->Lights[i].Faces; ++face)
      {
        plans.push_back({ view, cube ? face : -1 });
      }
    }
  }
  return plans;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowMaps::Draw(const std::vector<Plan>& plans, const Wanted& wanted)
{
  const glm::dvec2 layer = vtkPointSplatShadows::LayerDistanceFor(
    this->Settings, vtkPointSplatShadows::RadiusOf(this->Scene));
  glm::ivec2 size(1);
  this->Maps.Maps.clear();
  for (const Plan& plan : plans)
  {
    const vtkPointSplatShadowView& view = plan.View;
    size = glm::max(size, view.Size);
    this->Maps.Maps.push_back({ plan.GetWCLC(), glm::vec4(glm::dvec4(view.Scale, view.Offset)),
      glm::vec4(view.Size.x, view.Size.y, view.PixelSize, view.Depth),
      glm::vec4(view.Parallel ? 1.0 : 0.0, layer.x, layer.y, 0.0) });
  }
  const int count = std::max(static_cast<int>(plans.size()), 1);
  if (wanted.Opaque)
  {
    this->Maps.Depths.Allocate(size, count);
  }
  if (wanted.Translucent)
  {
    this->Maps.Layers.Allocate(size, count * vtkPointSplatLightMaps::MostLayers);
  }
  bool good = true;
  for (size_t i = 0; i < plans.size() && good; ++i)
  {
    const int map = static_cast<int>(i);
    const Plan& plan = plans[i];
    good = !wanted.Opaque ||
      this->Shadows.DrawTo(
        { this->Maps.Depths, map }, plan.View, plan.Face, this->Scene, this->Settings);
    this->Error = good ? this->Error : this->Shadows.GetError();
    good = good && (!wanted.Translucent || this->DrawLayers(plan, map, *wanted.Translucent));
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowMaps::DrawLayers(
  const Plan& plan, int map, const vtkPointSplatTranslucentCasters& casters)
{
  double offset = 0.0;
  const double margin = vtkPointSplatShadows::RadiusOf(this->Scene);
  glm::ivec4 inside(0);
  const vtkPointSplatLayers* layers = casters.Peel(plan.GetCamera(margin, offset), inside);
  if (!layers)
  {
    this->Error = "the layers that a light sees cannot be made.";
    return false;
  }
  vtkPointSplatProgram& program = this->Programs[layers->AreBuffers() ? 1 : 0];
  if (!program.BuildScreen("vtkPointSplatShadowLayerFS", layers->GetDefines()))
  {
    this->Error = program.GetLog();
    return false;
  }
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  const vtkPointSplatSavedState saved(window->GetState());
  saved.SetForImages(plan.View.Size);
  program.Use();
  vtkPointSplatUnits units(window);
  layers->Bind(units, program);
  units.Bind(program, "SlotColours", GL_TEXTURE_BUFFER, this->Colours.GetTexture());
  program.Set("Window", inside);
  program.Set("DepthOffset", static_cast<float>(offset));
  program.Set("DepthRange", static_cast<float>(plan.View.Depth));
  for (int k = 0; k < vtkPointSplatLightMaps::MostLayers; ++k)
  {
    program.Set("Layer", k);
    program.Set("IsLastLayer", k + 1 == vtkPointSplatLightMaps::MostLayers);
    this->Framebuffer.Bind(window->GetState(),
      { { this->Maps.Layers, map * vtkPointSplatLightMaps::MostLayers + k } });
    this->Screen.Draw();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowMaps::Release()
{
  this->Shadows.Release();
  this->Maps.Release();
  for (vtkPointSplatProgram& program : this->Programs)
  {
    program.Release();
  }
  this->Framebuffer.Release();
  this->Screen.Release();
  this->Colours.Release();
  this->Valid = false;
}
