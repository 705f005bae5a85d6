// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Blending kernels over the distance r from a splat's centre in units of its
// radius (Pajarola, Sainz, Guidotti 2004, section 5.2), and the fixed-point
// form in which compute shaders add them up.

uniform int KernelType;    // 0 Gaussian, 1 plateau
uniform vec2 KernelShape;  // Gaussian: 1 / (2 sigma^2); plateau: a and n

// r2: the distance squared; support: where the kernel ends.
float kernelWeight(float r2, float support)
{
  if (KernelType == 0)
  {
    return exp(-r2 * KernelShape.x); // equation 9
  }
  // Equation 10, over the distance as a fraction of the support.
  float x = pow(sqrt(r2) / support, KernelShape.y);
  return x < 1.0 ? exp(-KernelShape.x * x / (1.0 - x)) : 0.0;
}
