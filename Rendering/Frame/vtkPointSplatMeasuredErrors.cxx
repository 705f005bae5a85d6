// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeasuredErrors.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkPointSplatLights.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
constexpr double LeastTurnCosine = 0.7; // of how far the camera may turn
constexpr double MostGrowth = 2.0;
constexpr unsigned long MostGenerations = 30;
// So many changes of the scene, each within so many generations of the one before, are an animation.
constexpr int MostChanges = 3;
constexpr unsigned long FewGenerations = 8;
}

//------------------------------------------------------------------------------
void vtkPointSplatMeasuredErrors::Look(vtkRenderer* renderer,
  const vtkPointSplatCollection::Entries& entries, const vtkPointSplatView& view,
  double targetError, unsigned long generation)
{
  Sight sight;
  sight.Scene.push_back(targetError);
  const auto add = [&sight](const double* values) {
    sight.Scene.insert(sight.Scene.end(), values, values + 3);
  };
  add(renderer->GetBackground());
  for (vtkLight* light : vtkPointSplatLights::Of(renderer, false))
  {
    sight.Scene.push_back(light->GetIntensity());
    add(light->GetDiffuseColor());
  }
  for (const vtkPointSplatEntry& entry : entries)
  {
    sight.Scene.push_back(static_cast<double>(entry.Item.Cloud->GetNumberOfSplats()));
    sight.Scene.push_back(static_cast<double>(entry.Actor->GetProperty()->GetMTime()));
  }
  const glm::dmat3 turn(view.WCVC);
  sight.Direction = glm::normalize(glm::dvec3(turn[0].z, turn[1].z, turn[2].z));
  sight.PixelSize =
    view.PixelSizes(entries[0].Item.MCWC, entries[0].Item.Cloud->GetBounds().data()).x;
  sight.Generation = generation;
  if (sight.Scene != this->Now.Scene)
  {
    this->Changes = generation < this->ChangeGeneration + FewGenerations ? this->Changes + 1 : 0;
    this->ChangeGeneration = generation;
    this->Ends.clear();
    this->Apart.clear();
    this->IsKnown = false;
  }
  this->Now = std::move(sight);
}

//------------------------------------------------------------------------------
bool vtkPointSplatMeasuredErrors::IsStale() const
{
  const Sight& before = this->Measured;
  if (!this->IsKnown)
  {
    return this->Changes < MostChanges ||
      this->Now.Generation >= this->ChangeGeneration + FewGenerations;
  }
  return glm::dot(this->Now.Direction, before.Direction) < LeastTurnCosine ||
    std::abs(std::log(this->Now.PixelSize / before.PixelSize)) > std::log(MostGrowth) ||
    this->Now.Generation > before.Generation + MostGenerations;
}

//------------------------------------------------------------------------------
void vtkPointSplatMeasuredErrors::Set(std::vector<double> ends, std::vector<double> apart)
{
  this->Ends = std::move(ends);
  this->Apart = std::move(apart);
  this->Measured = this->Now;
  this->IsKnown = true;
}
