// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What makes surface layers of all splat actors of a renderer.
//
// The first splat mapper that draws in a frame builds the layer of all opaque splat actors of its
// renderer together, so that they hide one another before anything is accumulated; each mapper
// then presents its own actor's part. Likewise the first one that draws in a
// translucent pass peels the layers of all translucent splat actors, and presents them for all:
// - flattened to one layer, where nothing else translucent can lie between them;
// - else layer by layer from the back, each as a quad with its own depth, which takes part in
//   whatever translucent pass is under way.
// Layers that are still right are used again: by the passes of a hardware selection and of
// depth peeling, and by a frame in which only other things changed.
//
// Actors that are no props of the renderer themselves (parts of vtkAssembly, vtkLODActor
// and the like, whose matrices and paths belong to them while they draw) are built and
// presented each for itself.
#ifndef vtkPointSplatCompositor_h
#define vtkPointSplatCompositor_h

#include "vtkPointSplatChoices.h"
#include "vtkPointSplatContext.h"
#include "vtkPointSplatEnvironment.h"
#include "vtkPointSplatFlat.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatRefraction.h"
#include "vtkPointSplatResolve.h"
#include "vtkPointSplatSceneDepth.h"
#include "vtkPointSplatShadowCache.h"
#include "vtkPointSplatStages.h"

#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
VTK_ABI_NAMESPACE_END

class vtkPointSplatCompositor
{
public:
  explicit vtkPointSplatCompositor(vtkRenderer* renderer);
  ~vtkPointSplatCompositor();
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

  ///@{
  /**
   * Of the layers that the last call of Present() drew.
   */
  bool IsCompute() const { return this->Last && this->Last->GetRequest().Compute; }
  bool IsDeferred() const { return this->Last && this->Last->GetRequest().VoronoiScale >= 0.0f; }
  const char* GetTransparencyUsed() const { return this->TransparencyUsed; }
  int GetNumberOfFillSteps() const { return this->Last ? this->Last->GetNumberOfFillSteps() : 0; }
  int GetNumberOfLayers() const { return this->Last ? this->Last->GetNumberOfLayers() : 0; }
  ///@}

  /// What the last call of Present() did, and why.
  const vtkPointSplatChoice& GetChoice() const { return this->Choice; }

  /// Whether the user drags: the window wants frames faster than at rest.
  static bool IsInteracting(vtkRenderer* renderer);

  /// Whether there is something to refract, where a mapper of the last call of Present() wanted it.
  bool HasEnvironment() const { return this->HasPreparedEnvironment; }
  vtkIdType GetMemorySize() const;
  const vtkPointSplatShadowCache& GetShadows() const { return this->Shadows; }

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
  class FrameObserver;

  static std::vector<vtkProp*> VisibleProps(vtkRenderer* renderer);
  /// A splat actor that draws nothing, and so is in nobody's way.
  static bool IsWithoutSplats(vtkProp* prop);
  static std::vector<Entry> Collect(vtkRenderer* renderer, bool translucent);
  /// Seconds that VTK allots to these actors together; 0 at rest.
  static double AllocatedSeconds(vtkRenderer* renderer, const std::vector<Entry>& entries);
  /// hurried: time may be short, so that all is to be known.
  vtkPointSplatSceneFacts Describe(vtkRenderer* renderer, const vtkPointSplatView& view,
    const std::vector<Entry>& entries, bool translucent, bool flat, bool hurried);
  /// Of entries whose points are so far apart (world units); found anew when clouds or places change.
  double FindCrowding(const std::vector<Entry>& entries, double spacing);
  void Choose(vtkRenderer* renderer, const vtkPointSplatView& view,
    const std::vector<Entry>& entries, bool translucent, bool flat, vtkPointSplatLayers& layers);
  void PrepareEnvironment(vtkRenderer* renderer, const std::vector<Entry>& entries);
  GLuint CaptureScene(vtkRenderer* renderer, const vtkPointSplatView& view, bool& failed);
  bool MakeFactors(vtkRenderer* renderer, std::vector<Entry>& entries);
  bool Build(vtkRenderer* renderer, const vtkPointSplatView& view, std::vector<Entry>& entries,
    bool translucent, vtkPointSplatLayers& layers, bool& flat,
    vtkPointSplatFlat::SortedLayers& sorted);
  bool BuildAndPresent(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, std::vector<Entry>& entries, size_t own, bool joint, bool flat,
    bool& isSorted, vtkPointSplatLayers& layers);
  bool PresentTranslucent(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, const std::vector<Entry>& entries, bool joint, bool flat,
    vtkPointSplatFlat::SortedLayers sorted, vtkPointSplatLayers& layers);
  bool PresentLayers(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, const std::vector<Entry>& entries, bool batched,
    vtkPointSplatLayers& layers);
  bool PresentSelection(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, const vtkPointSplatItem& item, vtkPointSplatLayers& layers);
  void ReleaseAll();

  vtkPointSplatStages Stages;
  vtkPointSplatResolve Resolve;
  vtkPointSplatLayers Opaque;
  vtkPointSplatLayers Translucent;
  std::map<vtkPointSplatMapper*, std::unique_ptr<vtkPointSplatLayers>> Alone;
  vtkPointSplatSceneDepth Scene;
  vtkPointSplatFlat Flat;
  vtkPointSplatEnvironment Environment;
  vtkPointSplatRefraction Refraction;
  vtkPointSplatShadowCache Shadows;
  const vtkPointSplatLayers* Last = nullptr;
  const char* TransparencyUsed = "none";

  std::set<vtkPointSplatMapper*> Users;
  vtkWeakPointer<vtkWindow> Window; // whose context the resources belong to
  vtkPointSplatContext Context;     // and that context
  std::string Error;
  vtkPointSplatChoice Choice;
  using CrowdingKey = std::tuple<const vtkPointSplatCloud*, vtkMTimeType, glm::dmat4>;
  std::vector<CrowdingKey> CrowdingKeys; // what Crowding was found of
  double Crowding = 1.0;

  // Frames are counted as the renderer starts them: what depends on the whole scene, its depth
  // and its lights, is made once in each.
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long ObserverTag = 0;
  unsigned long Frame = 1;
  unsigned long SceneFrame = 0;
  bool SceneGood = false;
  unsigned long FlatFrame = 0;
  unsigned long FlatGeneration = 0;
  unsigned long EnvironmentFrame = 0;
  bool HasPreparedEnvironment = false;
  unsigned long PresenterFrame = 0;
  vtkActor* Presenter = nullptr; // compared only
};

#endif
