// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Group-sorted transparency (Zhang, Pajarola 2006, section 5.2, Algorithms 2 and 3): all
// layers, or all but the nearest, in one pass over the splats.
//
// Splats are divided into groups, each of which covers the surfaces by itself, with little
// overlap (vtkPointSplatGroups.h). For each group:
// 1. Its leaves, runs of splats in Morton order that were made with the groups, are sorted from the
//    back by their distance from the eye: one entry for 16 splats, not a sort of all.
// 2. They are drawn in this order to one image, blended, shaded a fragment.
// 3. The image is added to the average of all groups.
// The nearest layer of Algorithm 3 is the first of the peeled ones, from one visibility pass and the sums
// over what belongs to it. The paper makes it of K groups' images, as opaque surfaces (Algorithm 1): then
// groups that cover the surface, whose splats overlap, would serve for deferred blending too, which
// wants groups whose splats do not. So it is exact whatever the groups are.
// Images: RGBA16F, premultiplied colour; DEPTH_COMPONENT32F, the coarse depth; R16F, the number of
// refracting layers; RG16F, that of all groups, and of how many. (Section 5.2.3 has it from the
// accumulated opacity, which holds for one opacity, and not for none.)
#ifndef vtkPointSplatSorted_h
#define vtkPointSplatSorted_h

#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatScreen.h"
#include "vtkPointSplatShading.h"

#include <map>
#include <string>

class vtkPointSplatSorted
{
public:
  /**
   * What to draw.
   */
  struct Scene
  {
    const vtkPointSplatShading& Shading;
    const vtkPointSplatRequest& Request;
    const vtkPointSplatLayers* Nearest; // whose first one is left out, unless KeepNearest; or null
    bool KeepNearest;
    bool CountLayers;
  };

  /**
   * Adds the average of all groups to an image of colours, and brings the nearest depth to one of
   * depths. False, with GetError(), where the shaders do not build.
   */
  bool Draw(
    const Scene& scene, const vtkPointSplatImage& colour, const vtkPointSplatImage& depth);

  /// The refracting layers behind the nearest, summed over groups, and the groups that have some.
  const vtkPointSplatImage& GetLayerCount() const { return this->LayerCount; }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  /// A run of splats in the order, of one item.
  struct Batch
  {
    size_t Item;
    int First;
    int Count;
  };
  static std::vector<Batch> Sort(
    const vtkPointSplatRequest& request, int group, std::vector<uint32_t>& order);
  bool DrawGroup(const Scene& scene, int group);
  bool DrawAverage(const Scene& scene, int groups);
  bool DrawDepth(const Scene& scene);
  vtkPointSplatProgram* Use(
    const char* vertex, const char* fragment, const std::string& defines);

  std::map<std::string, vtkPointSplatProgram> Programs; // by files and defines
  vtkPointSplatBuffer Order{ GL_R32UI };
  vtkPointSplatBuffer Corners; // indices of the vertices of many quads
  vtkPointSplatHandle VertexArray{ vtkPointSplatHandle::VertexArray };
  vtkPointSplatImage GroupColour{ GL_RGBA16F };
  vtkPointSplatImage GroupDepth{ GL_DEPTH_COMPONENT32F };
  vtkPointSplatImage GroupLayerCount{ GL_R16F };
  vtkPointSplatImage LayerCount{ GL_RG16F };
  vtkPointSplatFramebuffer Groups;
  vtkPointSplatFramebuffer Sums;
  vtkPointSplatFramebuffer Depths;
  vtkPointSplatScreen Screen;
  std::string Error;
};

#endif
