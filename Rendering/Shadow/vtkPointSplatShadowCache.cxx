// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadowCache.h"

#include "vtkPointSplatThreads.h"

#include <cmath>

//------------------------------------------------------------------------------
bool vtkPointSplatShadowCache::Update(const vtkPointSplatShadowScene& scene,
  const vtkPointSplatShadowSettings& settings, bool interacting)
{
  std::vector<vtkMTimeType> times = scene.GetTimes();
  vtkPointSplatShadowSettings like = settings;
  if (interacting && this->Settings.Samples > settings.Samples)
  {
    like.Samples = this->Settings.Samples;
  }
  const vtkPointSplatContext& context = vtkPointSplatContext::Entered();
  if (this->Valid && this->Context == context && this->Times == times && this->Settings == like &&
    this->Scene == scene)
  {
    return true;
  }
  this->Context = context;
  this->Times = std::move(times);
  this->Settings = settings;
  this->Scene = scene;
  this->Valid = this->Compute();
  ++this->Updates;
  return this->Valid;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowCache::Compute()
{
  const std::vector<vtkPointSplatShadowCloud>& clouds = this->Scene.Clouds;
  std::vector<std::vector<uint32_t>> packed(clouds.size());
  for (size_t i = 0; i < clouds.size(); ++i)
  {
    packed[i].assign(static_cast<size_t>(clouds[i].Cloud->GetNumberOfSplats()), 0xffffffffu);
  }
  this->SamplesUsed = 0;
  vtkPointSplatShadowSettings settings = this->Settings;
  for (size_t light = 0; light < this->Scene.Lights.size(); ++light)
  {
    std::vector<std::vector<float>> factors;
    if (!this->Shadows.Cast(this->Scene.Lights[light], this->Scene, settings, factors))
    {
      return false;
    }
    ++settings.Seed;
    this->SamplesUsed = this->Shadows.GetSamplesUsed();
    const unsigned int shift = 8 * static_cast<unsigned int>(light);
    for (size_t i = 0; i < clouds.size(); ++i)
    {
      vtkPointSplatThreads::For(
        0, static_cast<vtkIdType>(factors[i].size()), [&](vtkIdType first, vtkIdType last) {
          for (size_t k = static_cast<size_t>(first); k < static_cast<size_t>(last); ++k)
          {
            packed[i][k] &= ~(255u << shift);
            packed[i][k] |= static_cast<uint32_t>(std::lround(255.0f * factors[i][k])) << shift;
          }
        });
    }
  }
  this->All.clear();
  for (size_t i = 0; i < clouds.size() && !this->Scene.Lights.empty(); ++i)
  {
    if (clouds[i].Receives)
    {
      const vtkPointSplatLevels& levels = clouds[i].Cloud->GetLevels();
      levels.AppendBytes(packed[i]);
      this->All[i].Buffer.Upload(packed[i]);
      this->All[i].Deviations = levels.MeasureDeviations(packed[i], false);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
const vtkPointSplatBuffer* vtkPointSplatShadowCache::GetFactors(
  const vtkPointSplatItem& item, bool grouped, vtkPointSplatLevels::Deviations& deviations)
{
  const vtkPointSplatCloud* cloud = item.Cloud;
  for (auto& entry : this->All)
  {
    const vtkPointSplatShadowCloud& own = this->Scene.Clouds[entry.first];
    if (own.Cloud != cloud || own.MCWC != item.MCWC)
    {
      continue;
    }
    Factors& factors = entry.second;
    deviations = factors.Deviations;
    const vtkPointSplatGroups& groups = own.Cloud->GetGroups();
    if (grouped && factors.GroupTime != groups.GetMTime())
    {
      std::vector<uint32_t> packed(static_cast<size_t>(cloud->GetNumberOfSplats()));
      factors.Buffer.Download(packed.data(), static_cast<GLsizeiptr>(4 * packed.size()));
      factors.Grouped.Upload(groups.Ordered(packed, 1));
      factors.GroupTime = groups.GetMTime();
    }
    return grouped ? &factors.Grouped : &factors.Buffer;
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowCache::Release()
{
  this->Shadows.Release();
  this->All.clear();
  this->Valid = false;
}
