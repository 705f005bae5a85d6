// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The environment as it is seen through refracting bodies (Zhang, Pajarola 2006, section 5.2.3, and
// beyond it), behind all their layers.
//
// 1. Each peeled layer becomes an interface: its normal, depth and slot go to a texel of an
//    array texture, nearest layer first.
// 2. For each pixel the eye's ray is bent where it meets the first refracting interface, by Snell's
//    law, and followed through the others. Layers are images of the whole body, so that a ray
//    that has left its pixel meets the interface where that is seen: the number of bodies around a
//    point, counted by the interfaces in front of it, changes there; steps, halvings and the
//    interface's tangent plane find the place. At each interface the ray goes on bent, or
//    reflected where there is no other way (total reflection); the light that Fresnel's equations
//    send back into a body is taken to leave it unbent. Between two interfaces light is
//    absorbed, by Beer and Lambert.
// 3. Where it meets no further interface, its direction and the environment texture give the
//    colour.
// Layers that are sorted and not peeled are only counted; then equation 12 bends the ray once, at
// the first interface: sin T = eta^l sin I.
//
// Texture: interfaces, RGBA32F, w x h x layers (vtkPointSplatInterfaces.glsl). Images: RGBA16F,
// colour with opacity 1; R32F, a depth just behind the last layer.
#ifndef vtkPointSplatRefraction_h
#define vtkPointSplatRefraction_h

#include "vtkPointSplatEnvironment.h"
#include "vtkPointSplatLayers.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSplatMapper;
VTK_ABI_NAMESPACE_END

class vtkPointSplatRefraction
{
public:
  vtkPointSplatRefraction() = default;
  ~vtkPointSplatRefraction() = default;
  vtkPointSplatRefraction(const vtkPointSplatRefraction&) = delete;
  void operator=(const vtkPointSplatRefraction&) = delete;

  /// Interfaces that rays are followed through, of each pixel; farther ones do not bend them.
  static constexpr int MaximumInterfaces = 12;

  /**
   * Whether an item of these layers refracts.
   */
  static bool IsNeeded(const vtkPointSplatLayers& layers);

  /**
   * Draws colour and depth to the colour attachments of the framebuffer that is bound, all
   * of whose pixels are the layers'. mappers: of the layers' items. layerCounts: an image of the
   * number of sorted layers behind the nearest, and of the groups that have some, or 0.
   */
  bool Draw(vtkRenderer* renderer, const std::vector<vtkPointSplatMapper*>& mappers,
    vtkPointSplatLayers& layers, const vtkPointSplatEnvironment& environment,
    GLuint layerCounts);

  ///@{
  /**
   * The same to images of its own.
   */
  bool DrawImages(vtkRenderer* renderer, const std::vector<vtkPointSplatMapper*>& mappers,
    vtkPointSplatLayers& layers, const vtkPointSplatEnvironment& environment);
  GLuint GetColour() const { return this->Colour; }
  GLuint GetDepth() const { return this->Depth; }
  ///@}

  vtkIdType GetMemorySize() const; // bytes
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  bool MakeInterfaces(vtkOpenGLRenderWindow* window, vtkPointSplatLayers& layers);
  void SetMedia(const std::vector<vtkPointSplatMapper*>& mappers,
    const vtkPointSplatLayersRequest& request, vtkShaderProgram* program) const;
  void DrawTriangle();

  glm::ivec3 Size{ 0, 0, 0 }; // of the interfaces
  glm::ivec2 ImageSize{ 0, 0 };
  GLuint Interfaces = 0;
  GLuint Colour = 0;
  GLuint Depth = 0;
  GLuint InterfaceFramebuffer = 0;
  GLuint ImageFramebuffer = 0;
  GLuint VertexArray = 0;
  int Count = 0; // of interfaces made
  const vtkPointSplatLayers* Source = nullptr; // compared only
  unsigned long Generation = 0;
  std::string Error;
};

#endif
