// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What of splats' looks is blended beside colours and normals: with COORDINATES, of textures, which
// are looked up once a pixel before layers are shaded; with TANGENTS, of the surface; with EDGES,
// rings at the splats' rims.
//
// Each splat continues its coordinates linearly to the pixel (vtkPointSplatCoordinates.h), and these
// are blended. Where they jump, as at a seam or from chart to chart of an atlas, a mean would be of
// texels that have nothing to do with it. So each splat joins the chart that it agrees with, of two,
// whose first splats are the first in the list and the first that disagrees; the pixel has that of
// the greater weight. Where all textures of an item repeat, coordinates that differ by whole numbers
// agree.

#ifdef COORDINATES
uniform usamplerBuffer RecordCoordinates; // RGBA32UI: coordinates, or NaN; changes, two halves each

// Sums are of whole numbers, as exact as those of weights where charts are less than one wide.
const float CoordinateScale = 1024.0;
// Coordinates agree that differ by no more than they change by from a splat's centre to its rim,
// and this.
const float LeastDisagreement = 1.0 / 512.0;

// Loops over Pixels index arrays of these, one a chart: indices that are computed, as 2 k + 1, would
// leave the arrays in memory, and drivers for processors ten times as long to compile.
struct Chart
{
  vec2 first;  // the first splat's coordinates
  vec2 off;    // sum of differences from these
  vec4 change; // sum of changes, by pixels along x and y
  float weight;
};
Chart charts[Pixels];
Chart secondCharts[Pixels];
float bareWeights[Pixels]; // of splats without coordinates
#endif
#ifdef TANGENTS
uniform usamplerBuffer RecordTangents; // R32UI, coded as normals
vec3 tangents[Pixels];
#endif
#ifdef EDGES
float edges[Pixels]; // how much of a pixel rings cover
#endif

// What a splat adds; `at` and `edge` are set anew for each pixel.
struct SplatLook
{
#ifdef COORDINATES
  bool known;
  bool repeats;
  vec2 coordinates;
  vec4 change;     // along x and y of what places are in: radii, or pixels
  vec4 pixels;     // the same by pixels
  vec2 reach;      // how much they change from the centre to the rim
  vec2 at;         // coordinates at the pixel
#endif
#ifdef TANGENTS
  vec3 tangent;
#endif
#ifdef EDGES
  float width;     // of rings, pixels
  float edge;      // what of the pixel they cover
#endif
};

SplatLook lookOf(int record, uint tag)
{
  SplatLook s;
#ifdef COORDINATES
  uvec4 code = texelFetch(RecordCoordinates, record);
  s.known = (code.x & 0x7fffffffu) <= 0x7f800000u;
  s.coordinates = uintBitsToFloat(code.xy);
  s.change = vec4(unpackHalf2x16(code.z), unpackHalf2x16(code.w));
#endif
#ifdef TANGENTS
  s.tangent = decodeNormal(texelFetch(RecordTangents, record).r);
#endif
  vec4 item = itemLook(tag);
#ifdef COORDINATES
  s.repeats = item.z > 0.0;
#endif
#ifdef EDGES
  s.width = item.y;
#endif
  return s;
}

#ifdef EDGES
// r: distance from the centre, radii; steepness: how much it changes by a pixel.
float ringAt(float width, float r, float steepness)
{
  return width > 0.0
    ? clamp(0.5 + 0.5 * width - abs(r - 1.0) / max(steepness, 1e-6), 0.0, 1.0)
    : 0.0;
}
#endif

// Of flat splats, by whose form W(d, d) is the squared distance from the centre.
void prepareFlatLook(inout SplatLook s, vec3 form)
{
#ifdef COORDINATES
  s.pixels = s.change;
  float area = max(form.x * form.z - 0.25 * form.y * form.y, 1e-30);
  vec2 x = s.change.xy;
  vec2 y = s.change.zw;
  s.reach = sqrt(max((x * x * form.z - x * y * form.y + y * y * form.x) / area, 0.0));
#endif
}

void placeFlatLook(inout SplatLook s, vec3 form, vec2 d, float r2)
{
#ifdef COORDINATES
  s.at = s.coordinates + d.x * s.change.xy + d.y * s.change.zw;
#endif
#ifdef EDGES
  vec2 gradient = vec2(2.0 * form.x * d.x + form.y * d.y, form.y * d.x + 2.0 * form.z * d.y);
  float r = sqrt(r2);
  s.edge = ringAt(s.width, r, length(gradient) / max(2.0 * r, 1e-6));
#endif
}

// Of splats that are seen at a flatter angle than this, its sine, as of those seen at this one.
const float LeastTilt = 0.02;

// From pixels to places on a cap, by the images of its axes: u by x, v by x, u by y, v by y. Not as
// the filter widens it: a texture must be filtered as coarsely as pixels really lie on it.
vec4 placesByPixels(vec2 x, vec2 y)
{
  float area = x.x * y.y - x.y * y.x;
  float least = 0.5 * LeastTilt * (dot(x, x) + dot(y, y));
  area = (area < 0.0 ? -1.0 : 1.0) * max(abs(area), max(least, 1e-30));
  return vec4(y.y, -y.x, -x.y, x.x) / area;
}

// Of caps. places: placesByPixels().
void prepareCapLook(inout SplatLook s, vec4 places)
{
#ifdef COORDINATES
  s.pixels = vec4(places.x * s.change.xy + places.y * s.change.zw,
    places.z * s.change.xy + places.w * s.change.zw);
  s.reach = sqrt(s.change.xy * s.change.xy + s.change.zw * s.change.zw);
#endif
}

void placeCapLook(inout SplatLook s, vec4 places, vec2 uv)
{
#ifdef COORDINATES
  s.at = s.coordinates + uv.x * s.change.xy + uv.y * s.change.zw;
#endif
#ifdef EDGES
  float r = length(uv);
  vec2 gradient = vec2(dot(places.xy, uv), dot(places.zw, uv)) / max(r, 1e-6);
  s.edge = ringAt(s.width, r, length(gradient));
#endif
}

#ifdef COORDINATES
// What two coordinates differ by.
vec2 differenceOf(SplatLook s, vec2 from)
{
  vec2 d = s.at - from;
  return s.repeats ? d - round(d) : d;
}

// weight: 0 where the splat does not join the chart.
void addToChart(inout Chart chart, SplatLook s, float weight)
{
  bool joins = weight > 0.0; // what a splat has that does not may be infinite
  chart.first = joins && chart.weight == 0.0 ? s.at : chart.first;
  chart.off +=
    joins ? round(weight * CoordinateScale * differenceOf(s, chart.first)) : vec2(0.0);
  chart.change += joins ? weight * s.pixels : vec4(0.0);
  chart.weight += weight;
}

// Whether a chart is not there yet, or agrees with the splat.
bool takes(Chart chart, SplatLook s)
{
  return chart.weight == 0.0 ||
    all(lessThanEqual(abs(differenceOf(s, chart.first)), s.reach + LeastDisagreement));
}
#endif

// weight: 0 of what does not belong to the pixel's layer.
void addLook(int k, SplatLook s, float weight)
{
#ifdef COORDINATES
  float known = s.known ? weight : 0.0;
  bool first = takes(charts[k], s);
  bool second = !first && takes(secondCharts[k], s);
  bareWeights[k] += weight - known;
  addToChart(charts[k], s, first ? known : 0.0);
  addToChart(secondCharts[k], s, second ? known : 0.0);
#endif
#ifdef TANGENTS
  tangents[k] += round(weight * s.tangent);
#endif
#ifdef EDGES
  edges[k] = weight > 0.0 ? max(edges[k], s.edge) : edges[k];
#endif
}

void clearLooks(int k)
{
#ifdef COORDINATES
  charts[k] = Chart(vec2(0.0), vec2(0.0), vec4(0.0), 0.0);
  secondCharts[k] = charts[k];
  bareWeights[k] = 0.0;
#endif
#ifdef TANGENTS
  tangents[k] = vec3(0.0);
#endif
#ifdef EDGES
  edges[k] = 0.0;
#endif
}

// A pixel's texels (vtkPointSplatLook.glsl), before textures are looked up.
uvec4 coordinateTexel(int k)
{
#ifdef COORDINATES
  Chart chart = charts[k];
  if (secondCharts[k].weight > chart.weight)
  {
    chart = secondCharts[k];
  }
  float weight = max(chart.weight, 1.0);
  vec4 change = chart.change / weight;
  vec2 at = chart.first + chart.off / (CoordinateScale * weight);
  return chart.weight > bareWeights[k]
    ? uvec4(floatBitsToUint(at), packHalf2x16(change.xy), packHalf2x16(change.zw))
    : uvec4(NoCoordinates);
#else
  return uvec4(NoCoordinates);
#endif
}

uvec4 surfaceTexel(int k)
{
  uvec4 texel = uvec4(0u);
#ifdef TANGENTS
  float size = length(tangents[k]);
  texel.x = encodeNormal(size > 0.0 ? tangents[k] / size : vec3(1.0, 0.0, 0.0));
#endif
#ifdef EDGES
  texel.y = packHalf2x16(vec2(edges[k], 0.0));
#endif
  return texel;
}
