// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The shadows in a renderer's frame: which actors cast them, on which splats, by which lights, and
// by how many samples. All visible splats and meshes that are not translucent cast; splats whose
// mapper wants shadows receive them, as textures of the splats. What follows from that is kept as
// long as it is right (vtkPointSplatShadowCache.h). Translucent splats cast, too, what of the
// lights' colours they do not let pass: by maps that are asked by the pixel
// (vtkPointSplatShadowMaps.h), as they are for meshes, where these are to receive shadows.
#ifndef vtkPointSplatFrameShadows_h
#define vtkPointSplatFrameShadows_h

#include "vtkPointSplatCollection.h"
#include "vtkPointSplatSettings.h"
#include "vtkPointSplatShadowCache.h"
#include "vtkPointSplatShadowMaps.h"
#include "vtkPointSplatSurfaces.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkRenderer;
VTK_ABI_NAMESPACE_END
class vtkPointSplatSource;

class vtkPointSplatFrameShadows
{
public:
  /// Computes what is not right any more. False, with GetError(), where OpenGL refuses.
  bool Update(vtkRenderer* renderer, vtkPointSplatReconstruction& reconstruction);
  /// The same of maps alone. opaque: whether they are to tell of opaque surfaces, too.
  bool UpdateMaps(
    vtkRenderer* renderer, vtkPointSplatReconstruction& reconstruction, bool opaque);
  /// Null where there are none, or nothing in them.
  vtkPointSplatLightMaps* GetMaps();

  /// The factors of lights that an item is drawn with: those of shadows, where its mapper wants
  /// these, else those that its input has. grouped: in the order of its groups.
  void SetFactors(vtkPointSplatItem& item, bool shadows, bool grouped);

  int GetSamplesUsed() const { return this->Cache.GetSamplesUsed(); }
  /// Why so many.
  const std::string& GetSamplesReason() const { return this->Reason; }
  unsigned long GetNumberOfUpdates() const { return this->Cache.GetNumberOfUpdates(); }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  struct Receiver
  {
    vtkPointSplatSource* Source;
    vtkPointSplatSettings Settings;
    double Diffuse; // how much brighter light of intensity 1 makes it
  };
  struct Gathered
  {
    vtkRenderer* Renderer = nullptr;
    vtkPointSplatShadowScene Scene;
    std::vector<Receiver> Receivers;
    bool HasTranslucent = false; // splats that cast
    vtkPointSplatShadowSettings Settings;
    bool Interacting = false;
  };
  static void AddActor(vtkActor* actor, const glm::dmat4& matrix, Gathered& all);
  Gathered Gather(vtkRenderer* renderer);
  bool UpdateMaps(vtkRenderer* renderer, vtkPointSplatReconstruction& reconstruction,
    const Gathered& all, bool opaque);
  vtkPointSplatRequest MakeRequest(const vtkPointSplatView& view);
  /// Returns the error of one sample of each, on white.
  double AddLights(vtkRenderer* renderer, Gathered& all);

  vtkPointSplatShadowCache Cache;
  vtkPointSplatShadowMaps Maps;
  bool HasMaps = false;
  vtkPointSplatCollection::Entries Casters; // translucent ones
  vtkPointSplatSurfaces Layers;             // of these, as a light sees them
  std::string Reason;
  std::string Error;
  bool Warned = false;
};

#endif
