#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The environment as it is seen through refracting bodies: colour of opacity 1, and a depth just
// behind the pixel's last layer. Nothing where the opaque scene lies behind.
// LAYER_COUNT: rays are bent once, by the number of layers (Zhang, Pajarola 2006, equation 12);
// else they are traced through all interfaces. DISPERSION: once for each of red, green and blue.

#include "vtkPointSplatInterfaces"
#include "vtkPointSplatEnvironmentMap"

uniform bool HasSceneDepth;
uniform sampler2D SceneDepth; // of the opaque scene, as OpenGL has it
#ifdef LAYER_COUNT
uniform sampler2D LayerCounts; // behind the first, summed over groups; groups that have some
#endif

layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 depth;

const int MaximumBends = 12;
const int Steps = 16;
const int Halvings = 4;
const int TangentSteps = 3;
const int MaximumNesting = 4;

// What becomes of an eye's ray: light that it collects on its way, and the direction in which, and
// the weight by which, it leaves for the environment.
struct Path
{
  vec3 light;
  vec3 weight;
  vec3 direction;
};

float indexOf(int slot, float shift)
{
  vec4 medium = mediumOf(slot);
  return max(medium.x + shift * medium.y, 1.0);
}

// Where a ray passes an interface between two distances from its start, of which the number of
// bodies around tells that it does: by halving, then by the interface's tangent plane. False
// where there is no such interface after all, but a crack.
bool meet(
  vec3 from, vec3 ray, int bodies, bool leaving, float before, float behind, inout Interface hit)
{
  float reach = behind - before;
  vec2 bounds = vec2(max(before - reach, 0.0), behind + reach);
  for (int i = 0; i < Halvings; ++i)
  {
    float middle = 0.5 * (before + behind);
    bool changed = bodiesAround(from + middle * ray) != bodies;
    before = changed ? before : middle;
    behind = changed ? middle : behind;
  }
  float t = behind;
  vec3 at = from + t * ray;
  Interface found;
  if (!nearestInterface(ivec2(floor(pixelOfPoint(at))), at.z, ray, leaving, found))
  {
    // Beyond an outline.
    t = before;
    at = from + t * ray;
    if (!nearestInterface(ivec2(floor(pixelOfPoint(at))), at.z, ray, leaving, found))
    {
      return false;
    }
  }
  for (int i = 0; i < TangentSteps; ++i)
  {
    float slope = dot(ray, found.normal);
    float next = abs(slope) > 0.02 ? dot(found.position - from, found.normal) / slope : t;
    t = clamp(next, bounds.x, bounds.y);
    at = from + t * ray;
    nearestInterface(ivec2(floor(pixelOfPoint(at))), at.z, ray, leaving, found);
  }
  if (abs(dot(found.position - at, found.normal)) > 0.1 * reach)
  {
    return false;
  }
  hit = found;
  hit.position = at;
  hit.normal = smoothNormal(at, ray, leaving, found);
  return true;
}

// Follows a ray to the next interface, at most to its reach.
bool follow(vec3 from, vec3 ray, int bodies, float reach, inout Interface hit)
{
  float size = reach / float(Steps);
  for (int i = 0; i < Steps; ++i)
  {
    float behind = size * float(i + 1);
    int other = bodiesAround(from + behind * ray);
    if (other != bodies && meet(from, ray, bodies, other < bodies, behind - size, behind, hit))
    {
      return true;
    }
  }
  return false;
}

// Traces a ray from its first interface. shift: of the index, in spreads.
Path trace(Interface hit, vec3 ray, float shift)
{
  Path path = Path(vec3(0.0), vec3(1.0), ray);
  int around[MaximumNesting + 1]; // slots of the bodies that the ray is in
  int nesting = 0;
  int bodies = 0;
  for (int i = 0; i < MaximumBends; ++i)
  {
    bool leaving = dot(path.direction, hit.normal) > 0.0;
    float own = indexOf(hit.slot, shift);
    float n1 = nesting > 0 ? indexOf(around[nesting], shift) : leaving ? own : 1.0;
    float n2 = !leaving ? own : nesting > 1 ? indexOf(around[nesting - 1], shift) : 1.0;
    vec3 normal = leaving ? -hit.normal : hit.normal;
    float cosine = min(-dot(path.direction, normal), 1.0);
    vec3 bent = refract(path.direction, normal, n1 / n2);
    vec3 reflected = reflect(path.direction, normal);
    if (n1 == n2)
    {
      bent = path.direction;
    }
    if (dot(bent, bent) == 0.0)
    {
      path.direction = reflected; // totally, and stays in the body
    }
    else
    {
      if (leaving)
      {
        // What is reflected here is taken to leave the body without being bent again.
        float share = fresnel(n1, n2, cosine, min(-dot(bent, normal), 1.0));
        path.light +=
          path.weight * share * environmentAlong(reflected, vec3(0.0), vec3(0.0));
        path.weight *= 1.0 - share;
        nesting = max(nesting - 1, 0);
        --bodies;
      }
      else
      {
        nesting = min(nesting + 1, MaximumNesting);
        around[nesting] = hit.slot;
        ++bodies;
      }
      path.direction = bent;
    }
    vec3 from = hit.position;
    float reach = nesting > 0 ? mediumOf(around[nesting]).z : absorptionOf(hit.slot).w;
    if (!follow(from, path.direction, bodies, reach, hit))
    {
      break;
    }
    if (nesting > 0)
    {
      vec3 lost = absorptionOf(around[nesting]).rgb * distance(from, hit.position);
      // Nothing is left, but not NaN, which exp() of infinity is with some drivers.
      path.weight *= exp(-min(lost, vec3(80.0)));
    }
  }
  return path;
}

#ifdef LAYER_COUNT
// sin T = eta^l sin I.
Path bend(Interface hit, vec3 ray, float shift, float layers)
{
  bool leaving = dot(ray, hit.normal) > 0.0;
  vec3 normal = leaving ? -hit.normal : hit.normal;
  float eta = pow(indexOf(hit.slot, shift), leaving ? layers : -layers);
  vec3 bent = eta == 1.0 ? ray : refract(ray, normal, eta);
  return Path(vec3(0.0), vec3(1.0), dot(bent, bent) > 0.0 ? bent : reflect(ray, normal));
}
#endif

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  Interface first = Interface(pointOfPixel(at, -NearDistance), vec3(0.0, 0.0, 1.0), -1, 0);
  float last = 0.0;
  int layers = layersAt(at);
  Interface found;
  for (int layer = 0; fetchInterface(at, layer, layers, found); ++layer)
  {
    last = found.position.z;
    if (first.slot < 0 && found.slot >= 0)
    {
      first = found;
    }
  }
  bool seen = first.slot >= 0 && !(HasSceneDepth && texelFetch(SceneDepth, at, 0).r < 1.0);
  vec3 ray = eyeRay(first.position);
  Path path = Path(vec3(0.0), vec3(1.0), ray);
#ifdef LAYER_COUNT
  vec2 counts = texelFetch(LayerCounts, at, 0).rg;
  float bends = 1.0 + counts.x / max(counts.y, 1.0);
#define PATH(shift) bend(first, ray, shift, bends)
#else
#define PATH(shift) trace(first, ray, shift)
#endif
  if (seen)
  {
    path = PATH(0.0);
  }
  vec3 through = path.light + path.weight * environment(path.direction);
#ifdef DISPERSION
  Path red = path;
  Path blue = path;
  if (seen)
  {
    red = PATH(-1.0);
    blue = PATH(1.0);
  }
  through.r = red.light.r + red.weight.r * environment(red.direction).r;
  through.b = blue.light.b + blue.weight.b * environment(blue.direction).b;
#endif
  if (!seen)
  {
    discard;
  }
  colour = vec4(through, 1.0);
  // Farther than the layer by some steps of a depth buffer of 24 bits, so that
  // none of the two is lost where depths are peeled.
  depth = vec4(min(windowDepth(last) + 1e-6, 1.0));
}
