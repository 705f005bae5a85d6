// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces sampled at random, with nothing but points and normals, against the exact
// surface by closed-form ray casting: depth, holes, spill.
#include "SplatScene.h"

#include "vtkMatrix4x4.h"

namespace
{
using namespace SplatScene;

/**
 * The ray through a pixel's centre in world coordinates.
 */
void Ray(Window& window, int x, int y, double origin[3], double direction[3])
{
  vtkRenderer* r = window.Renderer;
  double ends[2][4];
  for (int k = 0; k < 2; ++k)
  {
    const double view[3] = { 2.0 * (x + 0.5) / Size - 1.0, 2.0 * (y + 0.5) / Size - 1.0,
      k == 0 ? -1.0 : 1.0 };
    vtkNew<vtkMatrix4x4> m;
    m->DeepCopy(r->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0, -1, 1));
    m->Invert();
    const double in[4] = { view[0], view[1], view[2], 1.0 };
    m->MultiplyPoint(in, ends[k]);
    for (int c = 0; c < 3; ++c)
    {
      ends[k][c] /= ends[k][3];
    }
  }
  double length = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    origin[c] = ends[0][c];
    direction[c] = ends[1][c] - ends[0][c];
    length += direction[c] * direction[c];
  }
  for (int c = 0; c < 3; ++c)
  {
    direction[c] /= std::sqrt(length);
  }
}

/**
 * Where a ray meets the unit sphere: true with the point, and how far from the centre
 * the ray passes.
 */
bool HitSphere(const double o[3], const double d[3], double hit[3], double& miss)
{
  const double b = o[0] * d[0] + o[1] * d[1] + o[2] * d[2];
  const double c = o[0] * o[0] + o[1] * o[1] + o[2] * o[2];
  miss = std::sqrt(std::max(c - b * b, 0.0));
  if (miss >= 1.0)
  {
    return false;
  }
  const double t = -b - std::sqrt(1.0 - miss * miss);
  for (int k = 0; k < 3; ++k)
  {
    hit[k] = o[k] + t * d[k];
  }
  return true;
}

void Sphere(Checks& checks, int points, bool parallel, double zoom, double depthBound)
{
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(RandomSphere(points));
  window.Add(mapper);
  window.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
  window.Renderer->ResetCamera();
  window.Renderer->GetActiveCamera()->Azimuth(30);
  window.Renderer->GetActiveCamera()->Elevation(20);
  if (parallel)
  {
    window.Renderer->GetActiveCamera()->SetParallelScale(1.1 / zoom);
  }
  else
  {
    window.Renderer->GetActiveCamera()->Dolly(zoom);
  }
  window.Renderer->ResetCameraClippingRange();
  window.Draw();
  const std::vector<double> depth = window.Depth();

  vtkCamera* camera = window.Renderer->GetActiveCamera();
  double eye[3], axis[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(axis);
  long holes = 0, spill = 0, inside = 0;
  std::vector<double> errors;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      double o[3], d[3], hit[3] = { 0, 0, 0 }, miss;
      Ray(window, x, y, o, d);
      const bool covered = HitSphere(o, d, hit, miss);
      const double drawn = depth[static_cast<size_t>(y) * Size + x];
      if (covered && miss < 0.97)
      {
        ++inside;
        holes += drawn == 0.0;
        double exact = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          exact += (hit[k] - eye[k]) * axis[k];
        }
        if (drawn > 0.0)
        {
          errors.push_back(std::abs(drawn - exact));
        }
      }
      spill += miss > 1.03 && drawn > 0.0;
    }
  }
  std::sort(errors.begin(), errors.end());
  const double p95 = errors.empty() ? 1e9 : errors[static_cast<size_t>(0.95 * errors.size())];
  const std::string name = std::to_string(points) + " points, " +
    (parallel ? "parallel" : "perspective") + ", zoom " + std::to_string(zoom);
  std::cout << name << ": inside " << inside << ", holes " << holes << ", spill " << spill
            << ", depth error (95 %) " << p95 << "\n";
  checks.AtLeast(inside, 5000L, name + ": pixels inside");
  checks.AtMost(holes, 0L, name + ": holes");
  checks.AtMost(spill, 0L, name + ": pixels outside");
  checks.AtMost(p95, depthBound, name + ": depth error");
}

/**
 * A plane seen at an angle: depths must be those of the plane, whatever splat is hit.
 */
void Plane(Checks& checks, double elevation)
{
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(RandomCloud(20000, [](double u, double v, double* p, double* n) {
    p[0] = 2.0 * u - 1.0;
    p[1] = 2.0 * v - 1.0;
    p[2] = 0.0;
    n[0] = n[1] = 0.0;
    n[2] = 1.0;
  }));
  window.Add(mapper);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  const double angle = elevation * M_PI / 180.0;
  camera->SetPosition(0, -3.0 * std::cos(angle), 3.0 * std::sin(angle));
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->SetClippingRange(0.5, 6.0);
  window.Draw();
  const std::vector<double> depth = window.Depth();
  double eye[3], axis[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(axis);
  long holes = 0, inside = 0;
  double worst = 0.0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      double o[3], d[3];
      Ray(window, x, y, o, d);
      const double t = -o[2] / d[2];
      const double px = o[0] + t * d[0];
      const double py = o[1] + t * d[1];
      if (std::abs(px) > 0.95 || std::abs(py) > 0.95)
      {
        continue;
      }
      ++inside;
      const double drawn = depth[static_cast<size_t>(y) * Size + x];
      if (drawn == 0.0)
      {
        ++holes;
        continue;
      }
      const double exact = (px - eye[0]) * axis[0] + (py - eye[1]) * axis[1] - eye[2] * axis[2];
      worst = std::max(worst, std::abs(drawn - exact));
    }
  }
  const std::string name = "plane at " + std::to_string(elevation) + " degrees";
  std::cout << name << ": inside " << inside << ", holes " << holes << ", worst depth " << worst
            << "\n";
  checks.AtLeast(inside, 500L, name + ": pixels inside");
  checks.AtMost(holes, 0L, name + ": holes");
  checks.AtMost(worst, 0.02, name + ": depth error");
}
/**
 * The eye just above a plane, in the midst of its splats: many cross the near plane
 * and the plane of the eye. What lies below the horizon is drawn, what lies above not.
 */
void WithinPlane(Checks& checks, bool quads)
{
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  if (quads)
  {
    mapper->SetProjectionToQuads();
  }
  mapper->SetInputData(RandomCloud(20000, [](double u, double v, double* p, double* n) {
    p[0] = 2.0 * u - 1.0;
    p[1] = 2.0 * v - 1.0;
    p[2] = 0.0;
    n[0] = n[1] = 0.0;
    n[2] = 1.0;
  }));
  window.Add(mapper);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 0.01);
  camera->SetFocalPoint(0, 1, 0.01);
  camera->SetViewUp(0, 0, 1);
  camera->SetClippingRange(0.005, 3.0);
  const Picture picture = window.Draw();
  long above = 0, missing = 0, below = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      double o[3], d[3];
      Ray(window, x, y, o, d);
      const double t = d[2] < 0.0 ? -o[2] / d[2] : 0.0;
      const bool hit = t > 0.0 && o[1] + t * d[1] < 0.9 && std::abs(o[0] + t * d[0]) < 0.9;
      above += y > Size / 2 + 2 && !picture.IsBackground(x, y);
      below += hit;
      missing += hit && picture.IsBackground(x, y);
    }
  }
  const std::string name = quads ? "within a plane, quads" : "within a plane";
  std::cout << name << ": below the horizon " << below << ", missing " << missing
            << ", above it " << above << "\n";
  checks.AtLeast(below, 30000L, name + ": pixels below the horizon");
  checks.AtMost(above, 0L, name + ": drawn above the horizon");
  checks.AtMost(missing, 0L, name + ": missing below the horizon");
}
}

int TestSplatsExact(int, char*[])
{
  Checks checks;
  // Depth bounds in units of the sphere's radius. Flat disks would sag by r^2 / 2, four
  // times as much; what is left are splats near the outline smaller than a pixel.
  Sphere(checks, 5000, false, 1.0, 0.0018);
  Sphere(checks, 20000, false, 1.0, 0.0008);
  Sphere(checks, 20000, false, 3.0, 0.0004);
  Sphere(checks, 20000, true, 1.0, 0.0006);
  Sphere(checks, 60000, true, 1.0, 0.00095);
  Plane(checks, 90.0);
  Plane(checks, 30.0);
  Plane(checks, 8.0);
  WithinPlane(checks, false);
  WithinPlane(checks, true);
  return checks.Result();
}
