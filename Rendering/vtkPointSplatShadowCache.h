// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The shadow textures of a renderer's splat actors: who casts, on whom, by which lights, and what
// came of it, kept as long as it is right.
#ifndef vtkPointSplatShadowCache_h
#define vtkPointSplatShadowCache_h

#include "vtkPointSplatShadows.h"

#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkLight;
class vtkPointSplatMapper;
class vtkProp;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class vtkPointSplatShadowCache
{
public:
  static constexpr int MaximumLights = 4;

  vtkPointSplatShadowCache() = default;
  ~vtkPointSplatShadowCache() = default;
  vtkPointSplatShadowCache(const vtkPointSplatShadowCache&) = delete;
  void operator=(const vtkPointSplatShadowCache&) = delete;

  /**
   * Whether a light has factors at all: headlights have none, nor lights that are off or at no
   * finite place.
   */
  static bool Casts(vtkLight* light);

  /**
   * Computes what is not right any more; interacting: whether the user drags. False, with
   * GetError(), where OpenGL refuses.
   */
  bool Update(vtkRenderer* renderer, bool interacting);

  /**
   * The factors of a cloud at a place, as vtkPointSplatItem has them; or 0.
   */
  GLuint GetFactors(const vtkPointSplatCloud* cloud, const glm::dmat4& MCWC) const;

  int GetNumberOfLights() const { return static_cast<int>(this->Now.Lights.size()); }
  int GetSamplesUsed() const { return this->SamplesUsed; }
  /// Why so many.
  const std::string& GetSamplesReason() const { return this->SamplesReason; }
  unsigned long GetNumberOfUpdates() const { return this->Updates; }
  const std::string& GetError() const { return this->Error; }

  void Release();
  /// Forgets what was made, as when the context has gone.
  void Forget();

private:
  /**
   * All that factors depend on.
   */
  struct Scene
  {
    std::vector<vtkPointSplatShadowLight> Lights;
    std::vector<vtkPointSplatShadowCloud> Clouds;
    std::vector<vtkPointSplatShadowMesh> Meshes;
    std::vector<vtkMTimeType> Times; // of clouds, then of meshes
    vtkPointSplatShadowSettings Settings;

    bool IsLike(const Scene& other) const; // but for the number of samples
  };
  struct Receiver
  {
    vtkPointSplatMapper* Mapper;
    double Diffuse; // how much brighter light of intensity 1 makes it
  };
  Scene Gather(vtkRenderer* renderer, bool interacting);
  static void AddActor(vtkActor* actor, const glm::dmat4& matrix, Scene& scene,
    std::vector<Receiver>& receivers);
  bool Compute(vtkRenderer* renderer);

  vtkPointSplatShadows Shadows;
  Scene Now;
  bool Valid = false;
  bool Warned = false;
  std::vector<GLuint> Buffers; // of the clouds that receive; 0 for others
  int SamplesUsed = 0;
  std::string SamplesReason;
  unsigned long Updates = 0;
  std::string Error;
};

#endif
