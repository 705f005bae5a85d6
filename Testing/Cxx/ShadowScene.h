// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Spheres over a plane, and nested tori: points of them, and exact ray casting.
#ifndef ShadowScene_h
#define ShadowScene_h

#include "SplatScene.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPointSplatEstimation.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ShadowScene
{
using Vector = std::array<double, 3>;

inline Vector Along(const Vector& o, double t, const Vector& d)
{
  return { o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2] };
}
inline double Dot(const Vector& a, const Vector& b)
{
  return vtkMath::Dot(a.data(), b.data());
}
inline Vector Unit(Vector v)
{
  vtkMath::Normalize(v.data());
  return v;
}
inline Vector Between(const Vector& a, const Vector& b)
{
  return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
}
/// Two unit vectors across a direction.
inline void Across(const Vector& d, Vector& u, Vector& v)
{
  vtkMath::Perpendiculars(d.data(), u.data(), v.data(), 0.0);
}

struct Hit
{
  double T = std::numeric_limits<double>::infinity();
  int Surface = -1;
};

struct Scene
{
  vtkSmartPointer<vtkPolyData> Points;
  double Jump = 1.0; // what the distance changes by only where one surface hides another
  virtual ~Scene() = default;
  /// Where a ray meets the scene first, from its origin on.
  virtual Hit Cast(const Vector& o, const Vector& d) const = 0;

protected:
  /// With radii, which are estimated once for all uses.
  void SetPoints(vtkPolyData* points)
  {
    vtkNew<vtkPointSplatEstimation> estimation;
    estimation->SetInputData(points);
    estimation->Update();
    this->Points = estimation->GetOutput();
  }
};

struct Ball
{
  Vector Centre;
  double Radius;
};

/// The plane z = 0, |x|, |y| <= 2, surface 0, and spheres over it.
struct Spheres : Scene
{
  std::vector<Ball> Balls{ { { 0.0, 0.0, 0.9 }, 0.5 }, { { 1.1, 0.3, 0.7 }, 0.35 },
    { { -0.9, -0.8, 1.2 }, 0.4 } };

  explicit Spheres(int count)
  {
    std::vector<double> areas{ 16.0 };
    for (const Ball& ball : this->Balls)
    {
      areas.push_back(areas.back() + 4.0 * vtkMath::Pi() * ball.Radius * ball.Radius);
    }
    this->SetPoints(SplatScene::RandomCloud(count, [&](double u, double v, double* p, double* n) {
      const double at = u * areas.back();
      const size_t k = static_cast<size_t>(
        std::lower_bound(areas.begin(), areas.end(), at) - areas.begin());
      const double w = k == 0 ? at / areas[0] : (at - areas[k - 1]) / (areas[k] - areas[k - 1]);
      if (k == 0)
      {
        p[0] = 4.0 * w - 2.0;
        p[1] = 4.0 * v - 2.0;
        p[2] = n[0] = n[1] = 0.0;
        n[2] = 1.0;
        return;
      }
      const Ball& ball = this->Balls[k - 1];
      n[2] = 2.0 * w - 1.0;
      const double r = std::sqrt(1.0 - n[2] * n[2]);
      n[0] = r * std::cos(2.0 * vtkMath::Pi() * v);
      n[1] = r * std::sin(2.0 * vtkMath::Pi() * v);
      for (int i = 0; i < 3; ++i)
      {
        p[i] = ball.Centre[static_cast<size_t>(i)] + ball.Radius * n[i];
      }
    }));
  }
  Hit Cast(const Vector& o, const Vector& d) const override
  {
    Hit hit;
    const double t = -o[2] / d[2];
    const Vector p = Along(o, t, d);
    if (t > 0.0 && std::abs(p[0]) <= 2.0 && std::abs(p[1]) <= 2.0)
    {
      hit.T = t;
      hit.Surface = 0;
    }
    for (size_t k = 0; k < this->Balls.size(); ++k)
    {
      const Vector c = Between(this->Balls[k].Centre, o);
      const double b = Dot(c, d);
      const double root = b * b - Dot(c, c) + this->Balls[k].Radius * this->Balls[k].Radius;
      for (const double side : { -1.0, 1.0 })
      {
        const double s = -b + side * std::sqrt(std::max(root, 0.0));
        if (root > 0.0 && s > 1e-9 && s < hit.T)
        {
          hit.T = s;
          hit.Surface = static_cast<int>(k) + 1;
        }
      }
    }
    return hit;
  }
};

/// Tori about different axes, linked and one within the ring of another. Rays are marched by the
/// distance to the surfaces, which is exact.
struct Tori : Scene
{
  struct Torus
  {
    int Axis;
    Vector Centre;
    double Major;
    double Minor;
  };
  std::vector<Torus> All{ { 2, { 0.0, 0.0, 0.0 }, 1.0, 0.25 }, { 1, { 1.0, 0.0, 0.0 }, 0.7, 0.15 },
    { 2, { 0.0, 0.0, 0.0 }, 0.45, 0.12 } };

  explicit Tori(int count)
  {
    this->Jump = 0.1;
    std::vector<double> areas;
    for (const Torus& torus : this->All)
    {
      areas.push_back((areas.empty() ? 0.0 : areas.back()) + torus.Major * torus.Minor);
    }
    this->SetPoints(SplatScene::RandomCloud(count, [&](double u, double v, double* p, double* n) {
      const double at = u * areas.back();
      const size_t k = static_cast<size_t>(
        std::lower_bound(areas.begin(), areas.end(), at) - areas.begin());
      const double first = k == 0 ? 0.0 : areas[k - 1];
      const Torus& torus = this->All[k];
      const double a = 2.0 * vtkMath::Pi() * (at - first) / (areas[k] - first);
      // Uniform over the area: the angle about the tube, by Newton's method.
      const double e = torus.Minor / torus.Major;
      double b = 2.0 * vtkMath::Pi() * v;
      for (int i = 0; i < 8; ++i)
      {
        b -= (b + e * std::sin(b) - 2.0 * vtkMath::Pi() * v) / (1.0 + e * std::cos(b));
      }
      const double local[3] = { std::cos(b) * std::cos(a), std::cos(b) * std::sin(a),
        std::sin(b) };
      const double ring[3] = { torus.Major * std::cos(a), torus.Major * std::sin(a), 0.0 };
      for (int i = 0; i < 3; ++i)
      {
        const int to = (i + torus.Axis + 1) % 3;
        n[to] = local[i];
        p[to] = torus.Centre[static_cast<size_t>(to)] + ring[i] + torus.Minor * local[i];
      }
    }));
  }
  Hit Cast(const Vector& o, const Vector& d) const override
  {
    Hit hit;
    double t = 0.0;
    for (int step = 0; step < 2000 && t < 100.0; ++step)
    {
      const Vector p = Along(o, t, d);
      double nearest = 1e9;
      for (size_t k = 0; k < this->All.size(); ++k)
      {
        const Torus& torus = this->All[k];
        const Vector q = Between(torus.Centre, p);
        const size_t z = static_cast<size_t>(torus.Axis);
        const double x = q[(z + 1) % 3];
        const double y = q[(z + 2) % 3];
        const double ring = std::sqrt(x * x + y * y) - torus.Major;
        const double distance = std::sqrt(ring * ring + q[z] * q[z]) - torus.Minor;
        if (distance < nearest)
        {
          nearest = distance;
          hit.Surface = static_cast<int>(k);
        }
      }
      if (nearest < 1e-5)
      {
        hit.T = t;
        return hit;
      }
      t += nearest;
    }
    return Hit();
  }
};

/// The ray by which a light comes to a point, from far away if it is directional, and how far
/// the point is along it.
inline double RayTo(vtkLight* light, const Vector& p, Vector& o, Vector& d)
{
  Vector from;
  Vector to;
  light->GetTransformedPosition(from.data());
  light->GetTransformedFocalPoint(to.data());
  if (light->GetPositional())
  {
    o = from;
    d = Between(from, p);
    return vtkMath::Normalize(d.data());
  }
  d = Unit(Between(from, to));
  o = Along(p, -10.0, d);
  return 10.0;
}

/// Whether a light reaches a point; clear: no shadow's edge is within a pixel of it, as the
/// light sees it. pixel: world units, at a distance of 1 if the light is positional.
inline bool IsLit(
  const Scene& scene, vtkLight* light, const Vector& p, double pixel, bool& clear)
{
  Vector o;
  Vector d;
  const double distance = RayTo(light, p, o, d);
  const Hit hit = scene.Cast(o, d);
  clear = true;
  Vector u;
  Vector v;
  Across(d, u, v);
  for (int k = 0; k < 16 && pixel > 0.0; ++k)
  {
    const double a = k * vtkMath::Pi() / 8.0;
    const Vector off = Along(Along({ 0, 0, 0 }, std::cos(a) * pixel, u), std::sin(a) * pixel, v);
    const Hit other = light->GetPositional() ? scene.Cast(o, Unit(Along(d, 1.0, off)))
                                             : scene.Cast(Along(o, 1.0, off), d);
    clear = clear && other.Surface == hit.Surface && std::abs(other.T - hit.T) < scene.Jump;
  }
  return hit.T > distance - 1e-3;
}

inline vtkSmartPointer<vtkLight> MakeLight(
  const Vector& position, const Vector& focus, bool positional, double cone = 180.0)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(focus[0], focus[1], focus[2]);
  light->SetPositional(positional);
  light->SetConeAngle(cone);
  return light;
}
}

#endif
