// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The surface layers that were reconstructed (vtkPointSplatLayers.h), from buffers
// (LAYER_BUFFERS) or array textures.

#include "vtkPointSplatTexel"

uniform ivec2 LayerSize;
uniform int LayerCapacity; // that buffers have room for
uniform int LayerCount;
uniform int GatheredLayer; // that holds all that is behind the others; or -1
#ifdef LAYER_BUFFERS
#define LAYER_SAMPLER usamplerBuffer
#define ID_SAMPLER usamplerBuffer
#else
#define LAYER_SAMPLER usampler2DArray
#define ID_SAMPLER usampler2D
#endif
uniform LAYER_SAMPLER LayerTexels;
#ifdef LOOKS
uniform usamplerBuffer LayerLooks;
#endif
uniform LAYER_SAMPLER LayerFactors;
uniform ID_SAMPLER LayerIds;

int layerAt(ivec2 pixel, int layer)
{
  return (pixel.y * LayerCapacity + layer) * LayerSize.x + pixel.x;
}

uvec4 fetchLayer(ivec2 pixel, int layer)
{
#ifdef LAYER_BUFFERS
  return texelFetch(LayerTexels, layerAt(pixel, layer));
#else
  return texelFetch(LayerTexels, ivec3(pixel, layer), 0);
#endif
}

#ifdef LOOKS
uvec4 fetchLayerLook(ivec2 pixel, int layer, int texel)
{
  return texelFetch(LayerLooks, LOOKS * layerAt(pixel, layer) + texel);
}
#endif

uint fetchLayerId(ivec2 pixel)
{
#ifdef LAYER_BUFFERS
  return texelFetch(LayerIds, pixel.y * LayerSize.x + pixel.x).r;
#else
  return texelFetch(LayerIds, pixel, 0).r;
#endif
}

vec4 fetchLayerFactors(ivec2 pixel, int layer)
{
#ifdef LAYER_BUFFERS
  return unpackColour(texelFetch(LayerFactors, layerAt(pixel, layer)).r);
#else
  return unpackColour(texelFetch(LayerFactors, ivec3(pixel, layer), 0).r);
#endif
}
