// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Blending kernels over the distance r from a splat's centre in units of its
// radius (Pajarola, Sainz, Guidotti 2004, section 5.2). PLATEAU: some cloud of the frame has a
// plateau kernel, else all are Gaussians.

// e^-x of x >= 0, within a thousandth up to 4: a power series at a sixteenth, squared four times.
// It costs half of exp() on CPUs.
float decay(float x)
{
  float y = min(x, 24.0) * (-1.0 / 16.0);
  float e = 1.0 + y * (1.0 + y * (0.5 + y * (1.0 / 6.0)));
  e *= e;
  e *= e;
  e *= e;
  return e * e;
}

// kernel: Gaussian: 1 / (2 sigma^2), 0, where it ends, 0; plateau: a, n, where it ends, 1.
// r2: the distance squared, within the end.
float kernelWeight(float r2, vec4 kernel)
{
#ifdef PLATEAU
  // Equation 10. It is printed with (r - b)^n, which has none of the properties that the paper
  // asks of it; with (r / b)^n, as here, it falls from 1 at the centre to 0 at the support's end b.
  float x = pow(sqrt(r2) / kernel.z, kernel.y);
  float plateau = x < 1.0 ? exp(-kernel.x * x / (1.0 - x)) : 0.0;
  return kernel.w > 0.5 ? plateau : decay(r2 * kernel.x);
#else
  return decay(r2 * kernel.x); // equation 9
#endif
}

// What of its weight a splat keeps in a layer whose nearest hit is so far off; layer: the least layer
// distance, along the same line. Disks that cover one surface lie much nearer together than that:
// what lies nearly as far off is rather of another surface, which crosses this one or ends on it.
// Where a plane is seen edge-on a pixel has many depths of it, which all count alike; as much as
// others do in the mean, so that beside these at a silhouette they do not prevail.
float layerShare(float off, float layer, bool edgeOn)
{
  return edgeOn ? 0.5 : max(1.0 - abs(off) / max(layer, 1e-30), 0.0);
}
