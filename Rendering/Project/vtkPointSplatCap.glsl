// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the ray through a pixel meets the cap of a paraboloid (vtkPointSplatProjection). In the
// splat's coordinates (u, v, h) the ray through the pixel (x, y) is where two planes meet, row 1 =
// x row 3 and row 2 = y row 3:
//   (s.x - x s.z, t.x - x t.z, m.x - x m.z) . (u, v, h) = x, and for y likewise.
// a, b: of the images of s, t and m the x and the y; g: their w; bend: K; d: the pixel's offset
// from the centre. x gets the point that is met. False: none is.
bool meetCap(vec3 a, vec3 b, vec3 g, vec3 bend, vec2 d, out vec3 x)
{
  a -= d.x * g;
  b -= d.y * g;
  // The ray's direction, and its point nearest to the centre.
  vec3 c = cross(a, b);
  x = cross(d.x * b - d.y * a, c) / max(dot(c, c), 1e-37);
  // h + K(q, q) / 2 = 0 along it: alpha tau^2 + beta tau + gamma = 0. Of two hits
  // the one that tends to the plane's as the bend goes to zero, in the form that is
  // stable there.
  vec2 Kc = bend.xy * c.x + bend.yz * c.y;
  vec2 Kx = bend.xy * x.x + bend.yz * x.y;
  float alpha = 0.5 * dot(Kc, c.xy);
  float beta = c.z + dot(Kc, x.xy);
  float gamma = x.z + 0.5 * dot(Kx, x.xy);
  float discriminant = beta * beta - 4.0 * alpha * gamma;
  float root = sqrt(max(discriminant, 0.0));
  float divisor = beta + (beta < 0.0 ? -root : root);
  // A ray within the plane meets nothing: so far off that no disk is there.
  x -= 2.0 * gamma / (abs(divisor) < 1e-30 ? 1e-30 : divisor) * c;
  return discriminant >= 0.0;
}
