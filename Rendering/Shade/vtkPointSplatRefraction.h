// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The environment as it is seen through refracting bodies (Zhang, Pajarola 2006, section 5.2.3, and
// beyond it), behind all their layers.
//
// 1. The peeled layers are the interfaces: position and normal, the medium by the slot, and whether
//    the eye's ray enters or leaves it by the side that is seen.
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
#ifndef vtkPointSplatRefraction_h
#define vtkPointSplatRefraction_h

#include "vtkPointSplatLayers.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatScreen.h"
#include "vtkPointSplatShading.h"

#include <map>
#include <string>

class vtkPointSplatRefraction
{
public:
  /// Interfaces that rays are followed through, of each pixel; farther ones do not bend them.
  static constexpr int MaximumInterfaces = 12;

  /**
   * Draws colour, of opacity 1, and a depth just behind the last layer to the two colour
   * attachments of the framebuffer that is bound. layerCounts: an image of the number of sorted
   * layers behind the nearest, and of the groups that have some, or null. False, with GetError(),
   * where the shaders do not build.
   */
  bool Draw(const vtkPointSplatShading& shading, const vtkPointSplatRequest& request,
    const vtkPointSplatLayers& layers, const vtkPointSplatImage* layerCounts);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  std::map<std::string, vtkPointSplatProgram> Programs; // by defines
  vtkPointSplatScreen Screen;
  std::string Error;
};

#endif
