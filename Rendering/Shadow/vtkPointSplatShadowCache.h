// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The shadow textures of a scene, kept as long as they are right: buffers of RGBA, 8 bits a light,
// a splat, in the order of the clouds' own buffers.
#ifndef vtkPointSplatShadowCache_h
#define vtkPointSplatShadowCache_h

#include "vtkPointSplatShadows.h"

#include <map>
#include <string>
#include <vector>

class vtkPointSplatShadowCache
{
public:
  /**
   * Computes what is not right any more, for up to four lights; interacting: whether more samples
   * than are wanted do as well. False, with GetError(), where OpenGL refuses.
   */
  bool Update(const vtkPointSplatShadowScene& scene, const vtkPointSplatShadowSettings& settings,
    bool interacting);

  /**
   * The factors of an item's cloud at its place, or null; grouped: in the order of the cloud's
   * groups. deviations: gets those of the levels' blocks.
   */
  const vtkPointSplatBuffer* GetFactors(
    const vtkPointSplatItem& item, bool grouped, vtkPointSplatLevels::Deviations& deviations);

  int GetNumberOfLights() const { return static_cast<int>(this->Scene.Lights.size()); }
  int GetSamplesUsed() const { return this->SamplesUsed; }
  unsigned long GetNumberOfUpdates() const { return this->Updates; }
  const std::string& GetError() const { return this->Shadows.GetError(); }
  void Release();

private:
  struct Factors
  {
    vtkPointSplatBuffer Buffer{ GL_R32UI };
    vtkPointSplatBuffer Grouped{ GL_R32UI };
    vtkPointSplatLevels::Deviations Deviations;
    vtkMTimeType GroupTime = 0; // of the groups that it follows
  };
  bool Compute();

  vtkPointSplatShadows Shadows;
  vtkPointSplatShadowScene Scene;
  vtkPointSplatShadowSettings Settings;
  std::vector<vtkMTimeType> Times; // of clouds, then of meshes
  vtkPointSplatContext Context;    // that the buffers are in
  bool Valid = false;
  std::map<size_t, Factors> All; // of the clouds that receive
  int SamplesUsed = 0;
  unsigned long Updates = 0;
};

#endif
