// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes the shadow maps that are asked by the pixel (vtkPointSplatLightMaps.h), and keeps them as
// long as they are right. For each sample of each light:
//
// 1. A map is laid over all that casts (vtkPointSplatShadowView.h); beyond it everything is lit.
//    Its pixels are those of shadow textures, unless all maps would take more than 256 MiB. A light
//    has 32 samples at most.
// 2. Opaque meshes and splats are drawn to it as for shadow textures (vtkPointSplatShadows.h), and
//    holes are filled.
// 3. Translucent splats are reconstructed as surface layers, as for the eye, and what of red, green
//    and blue light passes these is multiplied up, layer by layer.
#ifndef vtkPointSplatShadowMaps_h
#define vtkPointSplatShadowMaps_h

#include "vtkPointSplatLayers.h"
#include "vtkPointSplatLightMaps.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatShadows.h"

#include <functional>
#include <memory>

/**
 * Translucent splats: what their layers are asked by, but for the view; of their slots the colours
 * and opacities, times those of points; and who makes the layers that a view has, null where OpenGL
 * refuses, and says in which pixels they are: first x, y, last x, y.
 */
struct vtkPointSplatTranslucentCasters
{
  std::vector<glm::vec4> Colours;
  vtkPointSplatRequest Request;
  std::function<const vtkPointSplatLayers*(const vtkPointSplatView& view, glm::ivec4& window)>
    Peel;
};

class vtkPointSplatShadowMaps
{
public:
  /**
   * What maps are to tell of.
   */
  struct Wanted
  {
    bool Opaque;                                        // what is opaque
    const vtkPointSplatTranslucentCasters* Translucent; // or null
    bool Interacting; // more samples than settings want do as well
  };
  /// Makes what is not right any more. False where OpenGL refuses.
  bool Update(const vtkPointSplatShadowScene& scene, const vtkPointSplatShadowSettings& settings,
    const Wanted& wanted);

  vtkPointSplatLightMaps& GetMaps() { return this->Maps; }
  /// Of each light of the scene.
  const std::vector<vtkPointSplatLightMaps::Light>& GetLights() const { return this->Lights; }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  struct Plan;
  bool IsValid(const vtkPointSplatShadowScene& scene, const vtkPointSplatShadowSettings& settings,
    const Wanted& wanted) const;
  std::vector<Plan> MakePlans(const Wanted& wanted, int maximum);
  bool Draw(const std::vector<Plan>& plans, const Wanted& wanted);
  bool DrawLayers(const Plan& plan, int map, const vtkPointSplatTranslucentCasters& casters);

  vtkPointSplatShadows Shadows;
  vtkPointSplatLightMaps Maps;
  std::vector<vtkPointSplatLightMaps::Light> Lights;
  vtkPointSplatProgram Programs[2]; // of layers that are images, or buffers
  vtkPointSplatFramebuffer Framebuffer;
  vtkPointSplatScreen Screen;
  vtkPointSplatBuffer Colours{ GL_RGBA32F };

  vtkPointSplatShadowScene Scene;
  vtkPointSplatShadowSettings Settings;
  std::vector<vtkMTimeType> Times; // of the scene's parts
  vtkPointSplatRequest Request;    // of translucent casters
  std::vector<glm::vec4> SlotColours;
  vtkPointSplatContext Context;
  bool Valid = false;
  std::string Error;
};

#endif
