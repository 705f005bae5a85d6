// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The look of a surface point, of textures that were looked up, tangents and edges
// (vtkPointSplatLook.glsl), for what shades it.

struct Look
{
  bool isSet;       // else the surface has none of these
  vec4 colour;      // by which what is lit is multiplied; of physical ones albedo and opacity
  vec4 factors;     // of occlusion, roughness, metallic, anisotropy
  vec3 normal;      // view coordinates, to the viewer but for its map
  vec3 tangent;
  vec3 coatNormal;
  vec3 emission;
  float edge;       // what of the pixel edges cover
};

Look look = Look(
  false, vec4(1.0), vec4(1.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);

// hasLook: whether textures were looked up for the point's item; hasEdges: whether it has edges.
#if LOOKS > 1
void setLook(bool hasLook, bool hasEdges, uvec4 first, uvec4 second)
#else
void setLook(bool hasLook, uvec4 first)
#endif
{
  look.isSet = hasLook;
  look.colour = vec4(unpackHalf2x16(first.x), unpackHalf2x16(first.y));
  look.factors = unpackUnorm4x8(first.z);
  look.normal = decodeNormal(first.w);
#if LOOKS > 1
  vec2 mixed = unpackHalf2x16(second.y);
  look.tangent = decodeNormal(second.x);
  look.coatNormal = decodeNormal(second.w);
  look.emission = vec3(unpackHalf2x16(second.z), mixed.y);
  look.edge = hasEdges ? mixed.x : 0.0;
#endif
}
