// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The surface layers as interfaces between media.

#include "vtkPointSplatLayers"
#include "vtkPointSplatMaterials"

uniform int InterfaceCount;   // layers that are interfaces
uniform ivec4 LayerWindow;    // pixels that layers were made of: first x, y, last x, y

struct Interface
{
  vec3 position; // view coordinates
  vec3 normal;   // out of the medium
  int slot;      // or -1: something that does not refract
  int crossing;  // what passing it along the eye's ray adds to the bodies that one is in: 1, -1
};

// Layers to look at of a pixel: none where none were made.
int layersAt(ivec2 pixel)
{
  return pixel == clamp(pixel, LayerWindow.xy, LayerWindow.zw) ? InterfaceCount : 0;
}

// False where there is no such layer; layers: how many there may be.
bool fetchInterface(ivec2 pixel, int layer, inout int layers, out Interface found)
{
  uvec4 texel = layer < layers ? fetchLayer(pixel, layer) : uvec4(0u);
  layers = isLast(texel) ? layer + 1 : layers;
  bool there = !isEmpty(texel);
  uint tag = there ? tagOfTexel(texel) : 0u;
  int slot = int(tag >> 1);
  found = Interface(pointOfPixel(pixel, -(NearDistance + uintBitsToFloat(texel.x))),
    decodeNormal(texel.y), there && mediumOf(slot).w > 0.0 ? slot : -1,
    (tag & 1u) != 0u ? -1 : 1);
  return there;
}

// The pixel's coordinates at which a point is seen.
vec2 pixelOfPoint(vec3 positionVC)
{
  vec4 p = vec4(positionVC, 1.0);
  float w = dot(PixelW, p);
  return w > 0.0 ? vec2(dot(PixelX, p), dot(PixelY, p)) / w : vec2(-1.0);
}

// How many bodies a point is in, less how many the eye is in.
int bodiesAround(vec3 positionVC)
{
  ivec2 pixel = ivec2(floor(pixelOfPoint(positionVC)));
  int layers = layersAt(pixel);
  int count = 0;
  Interface found;
  for (int layer = 0;
       fetchInterface(pixel, layer, layers, found) && found.position.z >= positionVC.z; ++layer)
  {
    count += found.slot >= 0 ? found.crossing : 0;
  }
  return count;
}

// Of the interfaces at a pixel that a ray leaves, or enters, a body by, the one that is nearest in
// depth to a point.
bool nearestInterface(ivec2 pixel, float z, vec3 ray, bool leaving, inout Interface nearest)
{
  float best = 1e30;
  int layers = layersAt(pixel);
  Interface found;
  for (int layer = 0; fetchInterface(pixel, layer, layers, found); ++layer)
  {
    float off = abs(found.position.z - z);
    if (found.slot >= 0 && (dot(ray, found.normal) > 0.0) == leaving && off < best)
    {
      best = off;
      nearest = found;
    }
  }
  return best < 1e30;
}

// The normal at a point of an interface, between the pixels around it.
vec3 smoothNormal(vec3 positionVC, vec3 ray, bool leaving, Interface at)
{
  vec2 between = pixelOfPoint(positionVC) - 0.5;
  ivec2 low = ivec2(floor(between));
  vec2 f = between - vec2(low);
  vec3 sum = 1e-6 * at.normal;
  for (int k = 0; k < 4; ++k)
  {
    ivec2 corner = ivec2(k & 1, k >> 1);
    Interface other;
    if (nearestInterface(low + corner, positionVC.z, ray, leaving, other) &&
      other.slot == at.slot && dot(other.normal, at.normal) > 0.5)
    {
      vec2 share = mix(1.0 - f, f, vec2(corner));
      sum += share.x * share.y * other.normal;
    }
  }
  return normalize(sum);
}
