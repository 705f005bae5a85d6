// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The surface layers as interfaces between media, nearest first, in one array texture
// (RGBA32F): x and y of the unit normal; z in view coordinates; and the slot plus one, 64
// more where the normal points away from the viewer, with the sign of the normal's z. Empty: 0.

uniform sampler2DArray Interfaces;
uniform int InterfaceCount;

// Of each slot: index of refraction, its spread, the longest way through the body (world units),
// and 1 if it refracts at all.
uniform vec4 Medium[64];

struct Interface
{
  vec3 position; // view coordinates
  vec3 normal;   // out of the medium
  int slot;      // or -1
  int crossing;  // what passing it along the eye's ray adds to the bodies that one is in: 1, -1
};

// False where this layer and all behind it are empty. Slot -1: something that does not refract.
bool fetchInterface(ivec2 pixel, int layer, out Interface found)
{
  vec4 texel = texelFetch(Interfaces, ivec3(pixel, layer), 0);
  if (texel.w == 0.0)
  {
    return false;
  }
  float tag = abs(texel.w);
  bool back = tag > 64.5;
  found.slot = int(tag + 0.5) - (back ? 65 : 1);
  found.slot = Medium[found.slot].w > 0.0 ? found.slot : -1;
  found.crossing = back ? -1 : 1;
  found.normal = vec3(texel.xy, sign(texel.w) * sqrt(max(1.0 - dot(texel.xy, texel.xy), 0.0)));
  found.position = pointOfPixel(pixel, texel.z).xyz;
  return true;
}

bool isInside(ivec2 pixel)
{
  return pixel == clamp(pixel, ivec2(0), textureSize(Interfaces, 0).xy - 1);
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
  int count = 0;
  Interface found;
  for (int layer = 0; isInside(pixel) && layer < InterfaceCount; ++layer)
  {
    if (!fetchInterface(pixel, layer, found) || found.position.z < positionVC.z)
    {
      break;
    }
    count += found.slot >= 0 ? found.crossing : 0;
  }
  return count;
}

// Of the interfaces at a pixel that a ray leaves, or enters, a body by, the one that is nearest in
// depth to a point.
bool nearestInterface(ivec2 pixel, float z, vec3 ray, bool leaving, inout Interface nearest)
{
  float best = 1e30;
  Interface found;
  for (int layer = 0; isInside(pixel) && layer < InterfaceCount; ++layer)
  {
    if (!fetchInterface(pixel, layer, found))
    {
      break;
    }
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
