// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which fragments are still to come when layers are peeled one after the other
// (Guennebaud, Barthe, Paulin 2006, section 6; Dobrev, Rosenthal, Linsen 2010,
// sections 4 and 5): those behind the last layer that do not belong to it, nor to
// one shortly before. Three layers are looked back at: surfaces that run closer
// together than the least layer distance take turns.

uniform int PreviousCount;    // layers before this one; 0: nothing is peeled
uniform bool HasSceneDepth;
uniform sampler2D SceneDepth; // of the opaque scene, as OpenGL has it
uniform vec4 PixelZ;          // view coordinates to z w

// previous: coded depths of the last layer, the one before it, and so on.
bool isPeeled(Splat q, float depth, uvec3 previous)
{
  if (previous.x == NoDepth || encodeDepth(depth, q.tag) <= previous.x)
  {
    return true;
  }
  return sameLayer(q, depth, previous.x) || (PreviousCount > 1 && sameLayer(q, depth, previous.y)) ||
    (PreviousCount > 2 && sameLayer(q, depth, previous.z));
}

// Whether the opaque scene hides a depth.
bool isHidden(float depth, ivec2 pixel)
{
  float z = -(depth + DepthRange.x);
  float scene = texelFetch(SceneDepth, pixel, 0).r;
  return 0.5 * (PixelZ.z * z + PixelZ.w) / (PixelW.z * z + PixelW.w) + 0.5 > scene;
}
