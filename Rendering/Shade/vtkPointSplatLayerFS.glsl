#version 330
#extension GL_ARB_sample_shading : enable
#extension GL_ARB_shading_language_packing : enable
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shades one surface layer and presents it as ordinary geometry: colour, opacity and depth, so that
// the depth test, depth peeling and the passes that work on depth treat it as they treat a mesh.
// Hooks as in VTK's own fragment shaders let render passes add to it; names that their code
// declares (pixel, front, ...) are not used here.
// OUTPUT: 0 shaded, 1 one colour for hardware selection, 2 ids for it. REFLECTION: some surfaces
// reflect the environment. OUTLINES (vtkPointSplatOutline): a pixel that an outline runs through
// gets the mean of the shaded pixels that its samples take after, and the share that these cover as
// opacity, at the depth of the nearest; in multisampled framebuffers each sample has its own colour
// and depth, so that splats and meshes meet within pixels. 0: there are none. Where depth is kept it
// is the pixel's own, if it shows anything itself: a selection draws over it, and would find nothing
// behind the nearest.
// PASS_FACTORS: a shadow map pass of VTK's tells how much of each light arrives, by code that finds
// the point as vertexVC. SHADOW_MAP: such a pass's map is drawn, by code that finds the pixel as
// coordinate, since gl_FragCoord is here at no depth of the surface.

//PointSplat::Defines

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

//VTK::Light::Dec

#include "vtkPointSplatLayers"
#include "vtkPointSplatRay"
#include "vtkPointSplatShownTexel"
#if OUTPUT == 0
#include "vtkPointSplatShadedTexel"
#ifdef REFLECTION
#include "vtkPointSplatReflection"
#endif
#if OUTLINES > 0
#include "vtkPointSplatOutline"
#endif
#endif

uniform ivec2 ImageOrigin;   // the images' first pixel in the framebuffer
uniform int Layer;
uniform vec4 SelectionColour;
uniform int SelectionShift;
uniform vec2 SelectionNearer; // to the eye: at depth 0, and its growth with the depth
uniform bool KeepsDepth;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
  bool sampled = false;
#if OUTLINES == 3
  at = pixelOfSample(at);
#endif
  uvec4 texel = fetchLayer(at, 0);
#if OUTLINES == 1 || OUTLINES == 2
  sampled = isOutline(texel);
#endif
  if (Layer > 0)
  {
    texel = fetchLayer(at, Layer);
  }
  float depth = uintBitsToFloat(texel.x);
#if OUTLINES == 1
  Mean mean = Mean(vec4(0.0), depth, 0u);
  for (bool fetched = !sampled; !fetched; fetched = true) // left where no pixel of several goes on
  {
    mean = meanAt(at);
  }
  bool own = KeepsDepth && isShown(texel);
  depth = own ? depth : mean.depth;
  if (sampled ? mean.colour.a <= 0.0 : !isShown(texel))
#else
  if (sampled || !isShown(texel))
#endif
  {
    discard;
  }
  float shownDepth = NearDistance + depth;
#if OUTPUT != 0
  shownDepth -= SelectionNearer.x + SelectionNearer.y * shownDepth;
#endif
  gl_FragDepth = windowDepth(-shownDepth);

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
#ifdef PASS_FACTORS
  vec4 vertexVC = vec4(pointOfPixel(at, -(NearDistance + depth)), 1.0);
  //VTK::Light::Impl
  //PointSplat::PassFactors
#endif
  Shaded s = shadeTexel(texel, at, Layer);
  vec3 positionVC = s.positionVC;
  vec3 normalVC = s.normalVC;
  vec4 shaded = s.colour;
#if OUTLINES == 1
  positionVC = sampled ? pointOfPixel(at, -(NearDistance + depth)) : positionVC;
  normalVC = sampled && !own ? decodeNormal(mean.normal) : normalVC;
  shaded = sampled ? vec4(mean.colour.rgb / max(mean.colour.a, 1e-6), mean.colour.a) : shaded;
#endif
#ifdef REFLECTION
  shaded.rgb *= shaded.a;
  shaded = addReflection(s.slot, positionVC, normalVC, s.back, shaded);
  shaded.rgb /= max(shaded.a, 1e-6);
#endif
  gl_FragData[0] = shaded;
#ifdef SHADOW_MAP
  int cameraParallel = Parallel ? 1 : 0;
  vec4 coordinate =
    vec4(gl_FragCoord.xy, gl_FragDepth, Parallel ? 1.0 : 1.0 / (NearDistance + depth));
  //PointSplat::ShadowMap
#endif
  //PointSplat::GeometryBuffer
#endif

  //VTK::DepthPeeling::Impl
}
