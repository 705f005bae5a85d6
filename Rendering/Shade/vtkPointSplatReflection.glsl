// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a dielectric surface reflects of the environment, over its own colour.

#include "vtkPointSplatEnvironmentMap"

// shaded: premultiplied; normalVC: towards the viewer. To be called by all fragments of a 2 x 2
// block.
vec4 addReflection(int slot, vec3 positionVC, vec3 normalVC, bool back, vec4 shaded)
{
  // Light from the air; what meets a translucent body's far side from within is the business of
  // vtkPointSplatRefractionFS.
  vec4 medium = mediumOf(slot);
  vec3 ray = eyeRay(positionVC);
  vec3 reflected = environment(reflect(ray, normalVC));
  float share = medium.w == 0.0 || (back && shaded.a < 1.0)
    ? 0.0
    : fresnelOfAir(medium.x, -dot(ray, normalVC));
  return vec4(mix(shaded.rgb, reflected, share), mix(shaded.a, 1.0, share));
}
