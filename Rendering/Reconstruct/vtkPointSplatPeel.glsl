// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which fragments are still to come when layers are peeled one after the other
// (Guennebaud, Barthe, Paulin 2006, section 6; Dobrev, Rosenthal, Linsen 2010,
// sections 4 and 5): those behind the last layer that do not belong to it, nor to
// one shortly before. Three layers are looked back at: surfaces that run closer
// together than the least layer distance take turns.

uniform int PreviousCount;    // layers before this one; 0: nothing is peeled
uniform usampler2D Previous0; // R32UI: coded depths of the last layer, the one before it, ...
uniform usampler2D Previous1;
uniform usampler2D Previous2;
uniform bool HasSceneDepth;
uniform sampler2D SceneDepth; // of the opaque scene, as OpenGL has it
uniform vec4 PixelZ;          // view coordinates to z w

// Whether a depth of a splat belongs to the layers so far.
bool isPeeled(Splat q, float depth, ivec2 pixel)
{
  if (PreviousCount == 0)
  {
    return false;
  }
  uint last = texelFetch(Previous0, pixel, 0).r;
  if (last == NoDepth || encodeDepth(depth, q.tag) <= last)
  {
    return true;
  }
  return sameLayer(q, depth, last) ||
    (PreviousCount > 1 && sameLayer(q, depth, texelFetch(Previous1, pixel, 0).r)) ||
    (PreviousCount > 2 && sameLayer(q, depth, texelFetch(Previous2, pixel, 0).r));
}

// Whether the opaque scene hides a depth.
bool isHidden(float depth, ivec2 pixel)
{
  float z = -(depth + DepthRange.x);
  return HasSceneDepth && 0.5 * (PixelZ.z * z + PixelZ.w) / (PixelW.z * z + PixelW.w) + 0.5 >
      texelFetch(SceneDepth, pixel, 0).r;
}
