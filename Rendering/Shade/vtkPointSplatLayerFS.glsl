#version 330
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shades one surface layer and presents it as ordinary geometry: colour, opacity and depth, so
// that the depth test, depth peeling and the passes that work on depth treat it as they treat a
// mesh. Hooks as in VTK's own fragment shaders let render passes add to it; names that their code
// declares (pixel, front, ...) are not used here.
// OUTPUT: 0 shaded, 1 one colour for hardware selection, 2 ids for it. REFLECTION: some surfaces
// reflect the environment.

//PointSplat::Defines

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

#include "vtkPointSplatLayers"
#include "vtkPointSplatRay"
#if OUTPUT == 0
#include "vtkPointSplatShadedTexel"
#ifdef REFLECTION
#include "vtkPointSplatReflection"
#endif
#endif

uniform ivec2 ImageOrigin;   // the images' first pixel in the framebuffer
uniform int Layer;
uniform int OnlySlot;        // of the cloud that is presented; -1: of all
uniform vec4 SelectionColour;
uniform int SelectionShift;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
  uvec4 texel = fetchLayer(at, 0);
  bool apart = false;
#if OUTPUT == 0
  // What an outline runs through is drawn by samples (vtkPointSplatOutlineFS).
  apart = isOutline(texel);
#endif
  if (Layer > 0)
  {
    texel = fetchLayer(at, Layer);
  }
  if (apart || isEmpty(texel) || (OnlySlot >= 0 && int(tagOfTexel(texel) >> 1) != OnlySlot))
  {
    discard;
  }
  gl_FragDepth = windowDepth(-(NearDistance + unpackTexel(texel).depth));

  //VTK::DepthPeeling::PreColor

#if OUTPUT == 1
  gl_FragData[0] = SelectionColour;
#elif OUTPUT == 2
  uint id = fetchLayerId(at);
  if (id == 0xffffffffu)
  {
    discard;
  }
  id >>= uint(SelectionShift);
  gl_FragData[0] = vec4(uvec4(id, id >> 8, id >> 16, 255u) & 255u) / 255.0;
#else
  Shaded s = shadeTexel(texel, at, Layer);
  vec3 positionVC = s.positionVC;
  vec3 normalVC = s.normalVC;
  vec4 shaded = s.colour;
#ifdef REFLECTION
  shaded.rgb *= shaded.a;
  shaded = addReflection(s.slot, positionVC, normalVC, s.back, shaded);
  shaded.rgb /= max(shaded.a, 1e-6);
#endif
  gl_FragData[0] = shaded;
  //PointSplat::GeometryBuffer
#endif

  //VTK::DepthPeeling::Impl
}
