// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shaded surface of a layer's texel.

#include "vtkPointSplatLayers"
#include "vtkPointSplatMaterials"

struct Shaded
{
  int slot;
  bool back;       // whether the back is seen
  vec3 positionVC;
  vec3 normalVC;   // to the viewer, unit length
  vec4 colour;     // and opacity times coverage; not premultiplied
};

// texel: of a layer at a pixel, not empty.
Shaded shadeTexel(uvec4 texel, ivec2 at, int layer)
{
  Surface s = unpackTexel(texel);
#ifdef FACTORS
  lightFactors = fetchLayerFactors(at, layer);
#endif
  Shaded shaded;
  shaded.slot = int(s.tag >> 1);
  shaded.positionVC = pointOfPixel(at, -(NearDistance + s.depth));
  shaded.normalVC = s.normal;
#ifdef LOOKS
  vec4 kinds = materialTexel(shaded.slot, 10);
#if LOOKS > 1
  setLook(kinds.w == 1.0 || kinds.w == 3.0, kinds.w >= 2.0, fetchLayerLook(at, layer, 0),
    fetchLayerLook(at, layer, 1));
#else
  setLook(kinds.w > 0.0, fetchLayerLook(at, layer, 0));
#endif
#endif
  // Gathered splats are of different surfaces. Diffuse light is linear in the normal, so that of a mean
  // normal as long as it is it is the mean of the splats' own, as if each were lit for itself
  // (Guennebaud, Barthe, Paulin 2006, section 6, lights them so; highlights are not linear).
  keptLight = layer == GatheredLayer ? min(s.agreement, 1.0)
                                     : clamp(s.agreement / FullAgreement, 0.0, 1.0);
  shaded.colour = shadeSurface(shaded.slot, shaded.positionVC, shaded.normalVC, s.colour,
    layer == GatheredLayer, shaded.back);
  shaded.colour.a *= s.coverage;
  return shaded;
}
