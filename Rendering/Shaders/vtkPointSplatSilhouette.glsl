// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Anti-aliasing of image-space layers (Dobrev, Rosenthal, Linsen 2010, section 3.5). A point marks
// all of the pixel that it falls in, so that a silhouette's pixels, which vtkPointSplatSmoothing has
// found, are covered by half in the mean: they are blended with the farthest of their
// neighbours, or with what is behind the layer.

uniform ivec2 PresentedSize; // of the images, pixels

// Background, as a distance that no surface has.
const float Farthest = 1e30;

float depthBeside(ivec2 at, float own)
{
  ivec2 last = PresentedSize - 1;
  if (at != clamp(at, ivec2(0), last))
  {
    return own; // nothing is known of what is beyond the window
  }
  uint code = fetchDepth(at);
  return code == NoDepth ? Farthest : decodeDepth(code);
}

vec4 smoothSilhouette(ivec2 at, uint code, vec4 shaded)
{
  if ((fetchTexel(at).z & 0x8000u) == 0u)
  {
    return shaded;
  }
  const ivec2 beside[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
  float farthest = decodeDepth(code);
  ivec2 beyond = at;
  for (int k = 0; k < 4; ++k)
  {
    float depth = depthBeside(at + beside[k], farthest);
    beyond = depth > farthest ? at + beside[k] : beyond;
    farthest = max(farthest, depth);
  }
  uint other = farthest < Farthest ? fetchDepth(beyond) : NoDepth;
  if (other == NoDepth || slotOf(other) != Slot)
  {
    return vec4(shaded.rgb, 0.5 * shaded.a);
  }
  vec3 normalVC;
  float behind;
  vec4 colour;
  bool back;
  fetchSums(beyond, normalVC, behind, colour);
#ifdef FACTORS
  lightFactors = fetchFactors(beyond);
#endif
  vec4 positionVC = pointOfPixel(beyond, -(NearDistance + farthest + behind));
  return mix(shaded, shadeSurface(positionVC.xyz, normalVC, colour, back), 0.5);
}
