// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSource.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkPointSplatPrimitives.h"
#include "vtkPointSplatTextures.h"
#include "vtkPointSplatTimers.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <map>
#include <mutex>

namespace
{
// Mappers may be made and destroyed in any thread, and after static objects are.
struct Registry
{
  std::mutex Mutex;
  std::map<vtkMapper*, vtkPointSplatSource*> Sources;

  static Registry& Get()
  {
    static Registry* registry = new Registry;
    return *registry;
  }
};
}

//------------------------------------------------------------------------------
vtkPointSplatSource::vtkPointSplatSource(vtkMapper* mapper)
  : Mapper(mapper)
{
  Registry& registry = Registry::Get();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  registry.Sources[mapper] = this;
}

//------------------------------------------------------------------------------
vtkPointSplatSource::~vtkPointSplatSource()
{
  Registry& registry = Registry::Get();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  registry.Sources.erase(this->Mapper);
}

//------------------------------------------------------------------------------
vtkPointSplatSettings vtkPointSplatSource::GetSettings(vtkActor* actor) const
{
  vtkPointSplatSettings settings = this->GetSettings();
  const double* colour = actor->GetProperty()->GetDiffuseColor();
  settings.ActorColour = { colour[0], colour[1], colour[2], actor->GetProperty()->GetOpacity() };
  const vtkPointSplatTextures textures = vtkPointSplatTextures::Of(actor, true);
  settings.NeedCoordinates = !textures.GetAll().empty();
  settings.NeedTangents = textures.NeedTangents();
  return settings;
}

//------------------------------------------------------------------------------
vtkPointSplatSettings vtkPointSplatSource::GetSettings(vtkRenderer* renderer, vtkActor* actor) const
{
  vtkPointSplatSettings settings = actor ? this->GetSettings(actor) : this->GetSettings();
  settings.MayBeDraft =
    settings.Progressive && vtkPointSplatTimers::AreOf(renderer->GetRenderWindow());
  return settings;
}

//------------------------------------------------------------------------------
void vtkPointSplatSource::UpdateCloud(const vtkPointSplatCloudInput& input, bool mayBeDraft)
{
  if (mayBeDraft)
  {
    this->Drafts.TakeMoving(this->Cloud);
    if (this->Cloud->Follow(input))
    {
      // What is under way is of another time: nobody waits for it.
      this->Drafts.Stop();
    }
    else if (this->Drafts.Update(input, *this->Cloud))
    {
      return;
    }
  }
  this->Drafts.Finish(this->Cloud);
  this->Cloud->Update(input);
}

//------------------------------------------------------------------------------
bool vtkPointSplatSource::IsUnderWay() const
{
  return this->Drafts.IsUnderWay() || this->Cloud->AreLevelsUnderWay() ||
    this->Cloud->GetLevelsPending() != 0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatSource::Advance()
{
  if (this->Drafts.AreDrawn())
  {
    return this->Drafts.Advance(this->Cloud);
  }
  const vtkMTimeType asked = this->Cloud->GetLevelsPending();
  if (asked != 0 && asked == this->LevelsAskedFor)
  {
    this->Cloud->BeginLevels();
  }
  this->LevelsAskedFor = asked;
  return this->Cloud->AreLevelsReady();
}

//------------------------------------------------------------------------------
vtkPointSplatSource* vtkPointSplatSource::Of(vtkProp* prop)
{
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper || vtkPointSplatPrimitives::AreShown(actor))
  {
    return nullptr;
  }
  Registry& registry = Registry::Get();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  const auto found = registry.Sources.find(mapper);
  return found == registry.Sources.end() ? nullptr : found->second;
}
