// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What makes one surface of all splat actors of a renderer.
//
// The first splat mapper that draws in a frame builds the images of the layer
// for all opaque splat actors of its renderer together, so that they hide one
// another before anything is accumulated; each mapper then presents its own
// actor's part. Images that are still right are used again: by the passes of a
// hardware selection, and by a frame in which only other things changed.
//
// Translucent actors, and actors that are no props of the renderer themselves (parts
// of vtkAssembly, vtkLODActor and the like, whose matrices and paths belong to them
// while they draw), are built and presented each for itself.
#ifndef vtkPointSplatCompositor_h
#define vtkPointSplatCompositor_h

#include "vtkPointSplatDeferred.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatResolve.h"
#include "vtkPointSplatStages.h"

#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <set>
#include <vector>

class vtkPointSplatCompositor
{
public:
  vtkPointSplatCompositor() = default;
  ~vtkPointSplatCompositor() = default;
  vtkPointSplatCompositor(const vtkPointSplatCompositor&) = delete;
  void operator=(const vtkPointSplatCompositor&) = delete;

  /**
   * The renderer's compositor, made at need. It lives as long as somebody
   * keeps it.
   */
  static std::shared_ptr<vtkPointSplatCompositor> Of(vtkRenderer* renderer);

  /**
   * Draws the actor, which has this mapper, in the pass that is under way.
   * False, with GetError(), where OpenGL refuses.
   */
  bool Present(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper);

  /**
   * A mapper that uses this has released its share of the window's resources;
   * with the last one go the images and the programs.
   */
  void Leave(vtkPointSplatMapper* mapper, vtkWindow* window);

  const std::string& GetError() const { return this->Error; }
  bool IsCompute() const { return this->Images.IsCompute(); }
  bool IsDeferred() const { return this->VoronoiScale >= 0.0f; }
  /// Why two passes were taken where deferred blending was asked for; else empty.
  const std::string& GetMethodReason() const { return this->MethodReason; }
  vtkIdType GetMemorySize() const
  {
    return this->Images.GetMemorySize() + this->Deferred.GetMemorySize();
  }

private:
  /**
   * An actor to draw, and the item that its mapper makes of it.
   */
  struct Entry
  {
    vtkActor* Actor;
    vtkPointSplatMapper* Mapper;
    vtkPointSplatItem Item;
  };

  static std::vector<Entry> CollectOpaque(vtkRenderer* renderer);
  bool Build(vtkRenderer* renderer, const vtkPointSplatView& view, std::vector<Entry>& entries);
  bool WantsDeferred(
    const std::vector<Entry>& entries, const glm::ivec2& size, bool compute);
  bool WantsCompute(vtkOpenGLRenderWindow* window, const std::vector<Entry>& entries,
    const glm::ivec2& size) const;
  bool PresentSelection(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, const vtkPointSplatItem& item);

  vtkPointSplatStages Stages;
  vtkPointSplatDeferred Deferred;
  vtkPointSplatImages Images;
  vtkPointSplatResolve Resolve;
  std::set<vtkPointSplatMapper*> Users;
  vtkWeakPointer<vtkWindow> Window; // whose context the resources belong to
  std::string Error;

  // What the images show.
  bool Built = false;
  vtkPointSplatView View;
  std::vector<vtkPointSplatItem> Items;
  std::vector<vtkMTimeType> CloudTimes;
  float DepthUnit = 1.0f;
  float VoronoiScale = -1.0f; // of deferred blending's Voronoi depth; negative: two passes
  std::string MethodReason;
  int IdentifiedKind = -1; // what the ids name, if they are of these images
};

#endif
