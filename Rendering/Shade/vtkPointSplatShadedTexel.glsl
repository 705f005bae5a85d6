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
  keptLight = clamp(s.agreement / FullAgreement, 0.0, 1.0);
  shaded.colour = shadeSurface(shaded.slot, shaded.positionVC, shaded.normalVC, s.colour,
    layer == GatheredLayer, shaded.back);
  shaded.colour.a *= s.coverage;
  return shaded;
}
