// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The shadows in a renderer's frame: which actors cast them, on which splats, by which lights, and
// by how many samples. All visible splats and meshes that are not translucent cast; splats whose
// mapper wants shadows receive them. What follows from that is kept as long as it is right
// (vtkPointSplatShadowCache.h).
#ifndef vtkPointSplatFrameShadows_h
#define vtkPointSplatFrameShadows_h

#include "vtkPointSplatSettings.h"
#include "vtkPointSplatShadowCache.h"

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
  bool Update(vtkRenderer* renderer);

  /// The factors of lights that an item is drawn with: those of shadows, where its mapper wants
  /// these, else those that its input has. grouped: in the order of its groups.
  void SetFactors(vtkPointSplatItem& item, bool shadows, bool grouped);

  int GetSamplesUsed() const { return this->Cache.GetSamplesUsed(); }
  /// Why so many.
  const std::string& GetSamplesReason() const { return this->Reason; }
  unsigned long GetNumberOfUpdates() const { return this->Cache.GetNumberOfUpdates(); }
  const std::string& GetError() const { return this->Cache.GetError(); }
  void Release() { this->Cache.Release(); }

private:
  struct Receiver
  {
    vtkPointSplatSource* Source;
    vtkPointSplatSettings Settings;
    double Diffuse; // how much brighter light of intensity 1 makes it
  };
  struct Gathered
  {
    vtkPointSplatShadowScene Scene;
    std::vector<Receiver> Receivers;
  };
  static void AddActor(vtkActor* actor, const glm::dmat4& matrix, Gathered& all);
  static Gathered Gather(vtkRenderer* renderer);
  double AddLights(vtkRenderer* renderer, Gathered& all);

  vtkPointSplatShadowCache Cache;
  std::string Reason;
  bool Warned = false;
};

#endif
