// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps that tell at any point how much of each light's light passes to it: what is shaded by
// the pixel asks them, meshes and splats alike. A light has a map a sample, or six about a light
// that stands among what casts. The textures:
//
// Depths (R32UI, an array of the maps): what is opaque, as vtkPointSplatShadowMap.glsl has it,
// holes filled.
// Layers (RG32UI, an array of so many layers a map): what is translucent, the nearest to the light
// first, as the reconstructed surface layers are: overlapping splats of one surface count once.
// Above the depth, as in Depths; below the share of red, green and blue light, 8 bits each, that
// passes this layer and those before it. The last one takes in all that is behind.
//
// A layer of opacity a and colour c lets pass (1 - a) (1 + a c): 1 - a go by, as blending has it
// for the eye's rays; of the a that meet the surface 1 - a go on, with its colour. So shadows are
// coloured, and are black of what is opaque, however nearly.
//
// The table (RGBA32F), a map: three rows from view to the light's coordinates; scale and offset to
// pixels, as vtkPointSplatShadowView has them; width, height, PixelSize, range of depths; whether
// light is parallel, d~, pixels that d~ measures at least.
#ifndef vtkPointSplatLightMaps_h
#define vtkPointSplatLightMaps_h

#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatImage.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkPointSplatProgram;
class vtkPointSplatUnits;

struct vtkPointSplatLightMap
{
  glm::dmat4 WCLC{ 1.0 }; // world to the light's coordinates, or to a face's of its cube
  glm::vec4 Place{ 0.0f };
  glm::vec4 Size{ 0.0f };
  glm::vec4 Kind{ 0.0f };
};

class vtkPointSplatLightMaps
{
public:
  /// Translucent layers that are kept apart.
  static constexpr int MostLayers = 6;

  /**
   * A light's maps, one sample after another.
   */
  struct Light
  {
    int First = 0;
    int Samples = 0; // 0: it casts none
    int Faces = 1;
  };

  vtkPointSplatImage Depths{ GL_R32UI };
  vtkPointSplatImage Layers{ GL_RG32UI };
  std::vector<vtkPointSplatLightMap> Maps;
  std::vector<Light> Lights; // those that are on
  bool HasDepths = false;
  bool HasLayers = false;

  /// Lines for programs that include vtkPointSplatLightMaps.glsl. depths: whether they are to ask
  /// for what is opaque, too.
  std::string GetDefines(bool depths) const;
  /// Binds them to a program in use, whose view coordinates these are.
  void Bind(const glm::dmat4& WCVC, vtkPointSplatUnits& units, vtkPointSplatProgram& program);
  void Release();

private:
  vtkPointSplatBuffer Table{ GL_RGBA32F };
  std::vector<glm::vec4> Texels; // that are in it
};

#endif
