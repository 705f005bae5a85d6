// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One renderer's frame: all of its splat actors are collected, described, chosen for and built
// together, once; actors only present.
//
// 1. The first splat actor that draws in a pass (opaque geometry, translucent geometry, one peel,
//    one pass of a selection) collects all splat actors that the pass will draw.
// 2. Facts of them make choices (vtkPointSplatChoices.h), and the choices a request, by which layers
//    are built, or kept where they are still right (vtkPointSplatSurfaces.h). So actors hide one
//    another before anything is accumulated, and layers are peeled over all of them.
// 3. That actor presents the layers of all; the others of this pass find them presented. Only
//    selections, and render passes whose shaders are made for each actor, present one by one.
//    Translucent layers are flattened to one, where nothing else translucent can lie between them,
//    or presented from the back, each with its own depth, to take part in the pass; before them
//    what is seen through refracting bodies.
// 4. At target errors above full quality a frame at rest now and then has all splats and layers, and
//    measures what fewer would lose, for the choices of those after it
//    (vtkPointSplatFrameMeasures.cxx).
// 5. Where the images of a window would take too many bytes, 2 and 3 are done part by part
//    (vtkPointSplatWindowParts.h), and 4 is not.
//
// A pass ends when an actor draws a second time, or another view, kind of geometry or framebuffer
// comes. Actors that are no props of the renderer themselves (parts of vtkAssembly, vtkLODActor and
// the like, whose matrices belong to them while they draw) are built and presented each for itself.
#ifndef vtkPointSplatFrame_h
#define vtkPointSplatFrame_h

#include "vtkPointSplatCollection.h"
#include "vtkPointSplatErrors.h"
#include "vtkPointSplatEnvironment.h"
#include "vtkPointSplatFlat.h"
#include "vtkPointSplatFrameShadows.h"
#include "vtkPointSplatLooks.h"
#include "vtkPointSplatNextFrame.h"
#include "vtkPointSplatReconstruction.h"
#include "vtkPointSplatResolve.h"
#include "vtkPointSplatSceneDepth.h"
#include "vtkPointSplatSurfaces.h"
#include "vtkPointSplatWindowParts.h"

#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>

VTK_ABI_NAMESPACE_BEGIN
class vtkWindow;
VTK_ABI_NAMESPACE_END

/**
 * What the last pass did for an actor, and why.
 */
struct vtkPointSplatReport
{
  vtkPointSplatSettings Settings; // the mapper's, or what a render pass made of them
  vtkPointSplatChoice Choice;
  const char* Method = "none";
  const char* Projection = "none";
  const char* Transparency = "none";
  int Layers = 0;
  int FillSteps = 0;
  double ProjectedSpacing = 0.0;   // pixels, of image space
  vtkPointSplatProjected Projected;
  vtkIdType ImageMemory = 0;       // bytes, of all actors of the renderer
  int StrideShift = 0;
  int ShadowSamples = 0;
  std::string ShadowReason;
  unsigned long ShadowUpdates = 0;
  bool HasEnvironment = false;
};

class vtkPointSplatFrame
{
public:
  explicit vtkPointSplatFrame(vtkRenderer* renderer);
  ~vtkPointSplatFrame();
  vtkPointSplatFrame(const vtkPointSplatFrame&) = delete;
  void operator=(const vtkPointSplatFrame&) = delete;

  /// The renderer's frame, made at need. It lives as long as somebody keeps it.
  static std::shared_ptr<vtkPointSplatFrame> Of(vtkRenderer* renderer);

  /**
   * Draws the actor, whose mapper has this source, in the pass that is under way; report gets what
   * was done. False, with GetError(), where OpenGL refuses.
   */
  bool Present(vtkActor* actor, vtkPointSplatSource& source, vtkPointSplatReport& report);

  /// What a render pass wants of the actors that it draws from now on; null: nothing.
  void SetWishes(const vtkPointSplatWishes* wishes);

  /**
   * The maps by which splats cast shadows on what is not drawn here, and on one another; null where
   * no mapper wants shadows, or, with GetError(), where OpenGL refuses. Good for one rendering.
   */
  vtkPointSplatLightMaps* PrepareLightMaps();

  /**
   * A mapper that is drawn here goes, or has released its share of the window's resources; with
   * the last one go the images and the programs.
   */
  void Leave(vtkPointSplatSource& source, vtkWindow* window);

  /// Asks for another frame when what sources make in the background is ready, if anything is.
  void AskForNext();

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  const std::string& GetError() const { return this->Error; }
  vtkIdType GetMemorySize() const; // bytes

private:
  class Observer;
  struct Pass
  {
    bool Translucent = false;
    unsigned long Frame = 0;
    vtkPointSplatView View;      // of the window; of a part while that is drawn
    std::vector<vtkPointSplatWindowPart> Parts;
    size_t Part = 0; // that is drawn
    GLint Framebuffer = 0;
    int SelectionPass = -1;
    vtkPointSplatCollection::Entries Entries;
    std::unordered_map<vtkActor*, size_t> Own;
    std::unordered_set<vtkActor*> Called;
    bool Joint = true;   // else of an actor that is drawn for itself
    bool Batched = true; // one actor presents all
    bool Presented = false;
    bool Good = true;
    bool Flat = false;
    bool Shadowed = false; // shadows fall on some
    bool Measures = false; // what less work would lose
    vtkPointSplatFlat::SortedLayers Sorted = vtkPointSplatFlat::None;
    vtkPointSplatFacts Facts;
    vtkPointSplatChoice Choice;
    vtkPointSplatSurfaces* Surfaces = nullptr;
    int Layers = 0;                   // the most that a part has
    std::vector<vtkPointSplatProjected> Projected; // of each slot, in all parts
  };

  void Begin(vtkActor* actor, bool translucent);
  size_t MostEntries(const Pass& pass) const;
  bool IsUnderWay(vtkActor* actor, bool translucent) const;
  /// Which of the pass's entries an actor is, if any.
  static std::optional<size_t> OwnOf(
    const Pass& pass, vtkActor* actor, const vtkPointSplatSource& source);
  bool PresentAlone(vtkActor* actor, vtkPointSplatSource& source, vtkPointSplatReport& report);
  static bool MayUseTiles(const Pass& pass);
  static std::vector<vtkPointSplatWindowPart> PartsOf(const Pass& pass, vtkActor* actor);
  static glm::ivec4 ShownWindow(const Pass& pass);
  bool Draw(Pass& pass, vtkActor* actor, size_t own);
  bool DrawPart(Pass& pass, vtkActor* actor, size_t own);
  bool Build(Pass& pass);
  void Choose(Pass& pass);
  /// Whether frames like this can tell what less work would lose, and somebody wants to know.
  bool CanMeasure(const Pass& pass, const vtkPointSplatFacts& facts, bool interacts);
  bool CastShadows(Pass& pass);
  vtkPointSplatRequest MakeRequest(Pass& pass, GLuint sceneDepth);
  GLuint CaptureScene(const Pass& pass, bool& failed);
  bool CaptureParts(const Pass& pass);
  void PrepareEnvironment(const Pass& pass);
  bool LookUpTextures(Pass& pass);
  bool PresentLayers(Pass& pass, vtkActor* actor, size_t own);
  bool PresentSelection(Pass& pass, vtkActor* actor, size_t own);
  bool Flatten(Pass& pass, const vtkPointSplatShading& shading);
  bool MeasureErrors(Pass& pass, const vtkPointSplatShading& shading);
  std::vector<double> TryFewer(Pass& pass, const vtkPointSplatShading& shading);
  bool PresentTranslucent(Pass& pass, const vtkPointSplatShading& shading,
    const vtkPointSplatResolve::Target& target, int slot);
  void Report(const Pass& pass, size_t own, vtkPointSplatReport& report) const;
  void ReleaseAll();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long ObserverTag = 0;
  unsigned long Frame = 1; // counts the renderer's frames
  const vtkPointSplatWishes* Wishes = nullptr;

  Pass Current;
  vtkPointSplatReconstruction Reconstruction;
  vtkPointSplatSurfaces Opaque;
  vtkPointSplatSurfaces Translucent;
  vtkPointSplatSurfaces Trial; // of fewer splats
  std::map<vtkPointSplatSource*, std::unique_ptr<vtkPointSplatSurfaces>> Alone;
  vtkPointSplatFlat Flat;
  vtkPointSplatErrors Errors;
  vtkPointSplatResolve Resolve;
  vtkPointSplatMaterials Materials;
  vtkPointSplatLooks Looks;
  vtkPointSplatRadiance Radiance;
  vtkPointSplatFrameShadows Shadows;
  std::vector<std::unique_ptr<vtkPointSplatSceneDepth>> Scene; // of each part
  unsigned long SceneFrame = 0;
  std::vector<vtkPointSplatWindowPart> SceneParts;
  bool SceneGood = false;
  vtkPointSplatEnvironment Environment;
  unsigned long EnvironmentFrame = 0;
  bool EnvironmentGood = false;
  bool HasEnvironment = false; // and the pass that is under way wants it
  std::set<vtkPointSplatSource*> Users;
  vtkPointSplatNextFrame Next;
  std::string Error;
};

#endif
