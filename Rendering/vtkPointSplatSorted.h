// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Group-sorted transparency (Zhang, Pajarola 2006, section 5.2, Algorithms 2 and 3): all
// layers, or all but the nearest, in one pass over the splats.
//
// Splats are divided into groups, each of which covers the surfaces by itself, with little
// overlap. For each group:
// 1. Its leaves, runs of splats in Morton order that were made with the groups, are sorted from the
//    back by their distance from the eye: one entry for 16 splats, not a sort of all.
// 2. They are drawn in this order to one image, blended, shaded a fragment.
// 3. The image is added to the average of all groups.
// Images: RGBA16F, premultiplied colour; DEPTH_COMPONENT32F, the coarse depth; R16F, the number of
// refracting layers. (Section 5.2.3 has it from the accumulated opacity, which holds for one
// opacity, and not for none.)
#ifndef vtkPointSplatSorted_h
#define vtkPointSplatSorted_h

#include "vtkPointSplatLayers.h"
#include "vtkPointSplatResolve.h"

class vtkPointSplatSorted
{
public:
  vtkPointSplatSorted() = default;
  ~vtkPointSplatSorted() = default;
  vtkPointSplatSorted(const vtkPointSplatSorted&) = delete;
  void operator=(const vtkPointSplatSorted&) = delete;

  /**
   * Adds the average of all groups to the first colour attachment of a framebuffer, the
   * nearest depth to its second one and, if wanted, to its third the number of refracting
   * layers behind the nearest, summed over groups, and of groups that have some.
   * actors: of the request's items. nearest: that layer, which is left out unless keepNearest, or
   * null.
   */
  bool Draw(vtkRenderer* renderer, const std::vector<vtkActor*>& actors,
    const vtkPointSplatLayersRequest& request, const vtkPointSplatImages* nearest,
    bool keepNearest, float coarseDepth, GLuint framebuffer, bool countLayers);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  struct Batch
  {
    size_t Item;
    std::vector<std::pair<vtkIdType, vtkIdType>> Ranges; // first splat, count
  };
  static std::vector<Batch> Order(const vtkPointSplatLayersRequest& request, int group);
  void Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size);
  bool DrawGroup(vtkRenderer* renderer, const std::vector<vtkActor*>& actors,
    const vtkPointSplatLayersRequest& request, const vtkPointSplatImages* nearest,
    bool keepNearest, float coarseDepth, int group, bool countLayers);

  vtkPointSplatProgram Average;
  vtkPointSplatProgram AverageAndCount;
  std::string Error;
  glm::ivec2 Size{ 0, 0 };
  GLuint Colour = 0;
  GLuint Depth = 0;
  GLuint LayerCount = 0;
  GLuint Framebuffer = 0;
  GLuint VertexArray = 0;
  GLuint Commands = 0; // for indirect draws
};

#endif
