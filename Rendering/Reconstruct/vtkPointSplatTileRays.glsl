// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the depth range and clipping planes leave of the rays of a tile's pixels: of each an interval.

uniform vec2 DepthRange;  // distances of the near plane, and of the far from it
uniform vec4 PixelX;      // view coordinates to x w, in pixels
uniform vec4 PixelY;
uniform vec4 PixelW;

#ifdef CLIPPING
vec2 intervals[Pixels];     // depths, of the cloud ...
uint intervalsTag = NoTag;  // ... with a tag like this
#endif

// Before isWithin() of splats with that tag. One loop over planes for all pixels, since drivers for processors take
// seconds to compile one for each.
void cutRays(uint tag)
{
#ifdef CLIPPING
  if ((tag ^ intervalsTag) <= 1u)
  {
    return;
  }
  intervalsTag = tag;
  for (int k = 0; k < Pixels; ++k)
  {
    intervals[k] = vec2(0.0, DepthRange.y);
  }
  mat2 toView = inverse(mat2(PixelX.x, PixelY.x, PixelX.y, PixelY.y));
  int count = itemClipPlaneCount(tag);
  for (int i = 0; i < count; ++i)
  {
    // From the pixel, not from the splat: of one that is huge, rounding would leave nothing.
    vec4 plane = itemClipPlane(tag, i);
    vec2 across = plane.xy * toView;
    for (int k = 0; k < Pixels; ++k)
    {
      vec2 pixel = corner + offsetOf(k);
      float slope = plane.z + dot(across, pixel * PixelW.z - vec2(PixelX.z, PixelY.z));
      float level = plane.w + dot(across, pixel * PixelW.w - vec2(PixelX.w, PixelY.w));
      // What is kept has slope z + level >= 0, z = -(depth + DepthRange.x).
      float end = level / (abs(slope) < 1e-30 ? 1e-30 : slope) - DepthRange.x;
      intervals[k] = slope < 0.0 ? vec2(max(intervals[k].x, end), intervals[k].y)
                                 : vec2(intervals[k].x, min(intervals[k].y, end));
    }
  }
#endif
}

// Whether a point at a pixel is within the depth range, and not cut away.
bool isWithin(int k, float depth)
{
#ifdef CLIPPING
  return depth > intervals[k].x && depth < intervals[k].y;
#else
  return depth > 0.0 && depth < DepthRange.y;
#endif
}
