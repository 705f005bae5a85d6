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

// How far behind the near side, in pixels' sizes, a far side lies that may be but its edge: farther away it is the
// inside of an open surface (Testing/Accuracy/likeness.py --light, cut_points and meshes).
const float SliverDepth = 16.0;

// Whether a pixel, which shows a body's far side, is but an edge of it that looks out from behind the body's
// outline, as disks there reach out over the surface by a pixel or two. That is where, in no
// two by two pixels, the far side is seen, but beside it the near side, and something that is farther. near: of
// the near side what is next to it in depth.
bool isSliver(uvec4 texel, ivec2 at, vec3 positionVC, out uvec4 near)
{
  uint tag = tagOfTexel(texel);
  float depth = uintBitsToFloat(texel.x);
  float pixelSize = distance(positionVC, pointOfPixel(at + ivec2(1, 0), positionVC.z));
  float nearDepth = depth - SliverDepth * pixelSize;
  near = texel;
  bool farther = false;
  for (int corner = 0; corner < 4; ++corner)
  {
    ivec2 step = ivec2((corner & 1) * 2 - 1, (corner & 2) - 1);
    bool wide = true;
    for (int k = 1; k < 4; ++k)
    {
      uvec4 other =
        fetchLayer(clamp(at + step * ivec2(k & 1, k >> 1), ivec2(0), LayerSize - 1), 0);
      float otherDepth = uintBitsToFloat(other.x);
      uint otherTag = tagOfTexel(other); // of nothing, none that there is
      wide = wide && otherTag == tag;
      farther = farther || isEmpty(other) || otherDepth > depth;
      if (otherTag == tag - 1u && otherDepth < depth && otherDepth > nearDepth)
      {
        near = other;
        nearDepth = otherDepth;
      }
    }
    if (wide)
    {
      return false;
    }
  }
  return tagOfTexel(near) != tag && farther;
}

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
  shaded.back = isBack(s.tag, s.normal, shaded.positionVC);
  uvec4 near;
  if (LayerCount == 1 && shaded.back && isSliver(texel, at, shaded.positionVC, near))
  {
    // The near side goes on there. Where layers blend, far sides are seen everywhere.
    shaded.back = false;
    shaded.normalVC = decodeNormal(near.y);
  }
  shaded.colour = shadeSurface(shaded.slot, shaded.positionVC, shaded.normalVC, s.colour,
    layer == GatheredLayer, shaded.back);
  shaded.colour.a *= s.coverage;
  return shaded;
}
