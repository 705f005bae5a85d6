// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The surface layers that a set of items makes in a view, nearest first, and how they
// are kept for as long as they are right.
//
// Opaque items have one layer. Translucent ones are peeled (Guennebaud, Barthe, Paulin 2006,
// section 6; Dobrev, Rosenthal, Linsen 2010, sections 4 and 5): each layer is reconstructed in
// full quality before the next begins, of what lies behind it and does not belong to it. It
// ends when a layer is empty, when what is left could change no pixel by more than is wanted, or at
// the most layers that are wanted; of these the last may gather all that is left.
#ifndef vtkPointSplatLayers_h
#define vtkPointSplatLayers_h

#include "vtkPointSplatBudget.h"
#include "vtkPointSplatDeferred.h"
#include "vtkPointSplatFill.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatStages.h"

#include <memory>

/**
 * All that layers depend on.
 */
struct vtkPointSplatLayersRequest
{
  vtkPointSplatView View;
  std::vector<vtkPointSplatItem> Items;
  std::vector<vtkMTimeType> CloudTimes;
  bool Compute = true;
  float VoronoiScale = -1.0f;  // of deferred blending, world units; negative: two passes
  int MaximumLayers = 1;
  double LeastContribution = 1.0 / 256.0; // peeling ends where less of the light is left
  bool Gather = false;         // the last layer takes all that is left
  int FillSteps = 0;           // most steps of filling; 0: no item is projected as points
  double LeastOpacity = 1.0;   // of any item
  vtkIdType MaximumMemory = 0; // bytes of all layers; 0: no bound
  GLuint SceneDepth = 0;       // or 0
  unsigned long Frame = 0;     // when the scene's depth was taken

  bool operator==(const vtkPointSplatLayersRequest& other) const;
};

class vtkPointSplatLayers
{
public:
  vtkPointSplatLayers() = default;
  ~vtkPointSplatLayers() = default;
  vtkPointSplatLayers(const vtkPointSplatLayers&) = delete;
  void operator=(const vtkPointSplatLayers&) = delete;

  /**
   * Makes the layers, unless they are those that were asked for last time. False, with
   * GetError(), where OpenGL refuses.
   */
  bool Build(vtkOpenGLRenderWindow* window, vtkPointSplatLayersRequest request,
    vtkPointSplatStages& stages);

  /**
   * Ids of one layer's splats.
   */
  bool Identify(vtkOpenGLRenderWindow* window, vtkPointSplatStages& stages,
    vtkPointSplatCloud::IdKind kind);

  int GetNumberOfLayers() const { return this->Count; }
  vtkPointSplatImages& GetImages(int layer) { return *this->Layers[static_cast<size_t>(layer)]; }
  const vtkPointSplatLayersRequest& GetRequest() const { return this->Request; }
  float GetDepthUnit() const { return this->DepthUnit; }
  bool IsGathered(int layer) const
  {
    return this->Request.Gather && layer == this->Request.MaximumLayers - 1;
  }
  /// What these layers take by which choice.
  vtkPointSplatBudget& GetBudget() { return this->Budget; }
  /// Counts how often layers were made: what is derived from them is right while this stays.
  unsigned long GetGeneration() const { return this->Generation; }
  /// Steps that the last layer's filling took.
  int GetNumberOfFillSteps() const { return this->Request.FillSteps > 0 ? this->Fill.GetNumberOfSteps() : 0; }
  vtkIdType GetMemorySize() const; // bytes
  const std::string& GetError() const { return this->Error; }

  /// Forgets what was built, as when the context has gone.
  void Invalidate() { this->Built = false; }
  void Release();

private:
  bool BuildLayer(vtkOpenGLRenderWindow* window, vtkPointSplatStages& stages, bool& empty);

  vtkPointSplatBudget Budget;
  vtkPointSplatDeferred Deferred;
  vtkPointSplatImages Projected; // before it is filled
  vtkPointSplatFill Fill;
  std::vector<std::unique_ptr<vtkPointSplatImages>> Layers;
  int Count = 0;
  bool Built = false;
  vtkPointSplatLayersRequest Request;
  float DepthUnit = 1.0f;
  int IdentifiedKind = -1; // what the first layer's ids name, if they are of these images
  unsigned long Generation = 0;
  std::string Error;
};

#endif
