// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A view of spheres over a plane, and which lights reach what its rays see.
#ifndef ShadowView_h
#define ShadowView_h

#include "ShadowScene.h"

namespace ShadowScene
{
using SplatScene::Checks;
using SplatScene::Picture;
using SplatScene::Window;

constexpr double Ambient = 0.2;
constexpr double Diffuse = 0.8;
const Vector Colour{ 0.9, 0.7, 0.5 };

/// A scene by its mapper, lit as the lights say, seen from above.
struct View
{
  Window Win;
  vtkNew<vtkPointSplatMapper> Mapper;
  vtkActor* Actor = nullptr;

  explicit View(vtkPolyData* points, const std::vector<vtkSmartPointer<vtkLight>>& lights)
  {
    this->Mapper->SetInputData(points);
    this->Mapper->ScalarVisibilityOff();
    this->Actor = this->Win.Add(this->Mapper);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetColor(Colour[0], Colour[1], Colour[2]);
    property->SetAmbient(Ambient);
    property->SetDiffuse(Diffuse);
    property->SetSpecular(0.0);
    this->Win.Renderer->AutomaticLightCreationOff();
    for (vtkLight* light : lights)
    {
      this->Win.Renderer->AddLight(light);
    }
    vtkCamera* camera = this->Win.Renderer->GetActiveCamera();
    camera->SetPosition(0.5, -5.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Win.Renderer->ResetCameraClippingRange();
  }
  /// The ray through a point of the picture.
  void Ray(double x, double y, Vector& o, Vector& d)
  {
    double world[2][4];
    vtkRenderer* renderer = this->Win.Renderer;
    for (int end = 0; end < 2; ++end)
    {
      renderer->SetDisplayPoint(x, y, end);
      renderer->DisplayToWorld();
      renderer->GetWorldPoint(world[end]);
    }
    for (size_t k = 0; k < 3; ++k)
    {
      o[k] = world[0][k] / world[0][3];
      d[k] = world[1][k] / world[1][3] - o[k];
    }
    d = Unit(d);
  }
};

/// What a ray sees: which surface, and by which lights it is lit.
struct Seen
{
  int Surface = -1;
  unsigned int Lit = 0;
  Vector Normal{ 0.0, 0.0, 1.0 };
  bool operator==(const Seen& other) const
  {
    return this->Surface == other.Surface && this->Lit == other.Lit;
  }
};

inline Seen See(const Spheres& scene, const std::vector<vtkSmartPointer<vtkLight>>& lights,
  const Vector& o, const Vector& d)
{
  Seen seen;
  const Hit hit = scene.Cast(o, d);
  seen.Surface = hit.Surface;
  if (hit.Surface < 0)
  {
    return seen;
  }
  const Vector p = Along(o, hit.T, d);
  if (hit.Surface > 0)
  {
    seen.Normal = Unit(Between(scene.Balls[static_cast<size_t>(hit.Surface) - 1].Centre, p));
  }
  for (size_t i = 0; i < lights.size(); ++i)
  {
    bool clear = false;
    seen.Lit |= IsLit(scene, lights[i], Along(p, 1e-6, seen.Normal), 0.0, clear) ? 1u << i : 0u;
  }
  return seen;
}

/// Compares a picture with the closed form where no edge of a surface or a shadow is near.
/// opacity: of the points before black; the first surface only counts then.
inline void Compare(Checks& checks, const std::string& name, View& view, const Spheres& scene,
  const std::vector<vtkSmartPointer<vtkLight>>& lights, double opacity = 1.0)
{
  const Picture picture = view.Win.Draw();
  const int reach = 4;
  double sum = 0.0;
  long inside = 0;
  long dark = 0;
  long wrong = 0;
  for (int y = 10; y < picture.Height - 10; y += 2)
  {
    for (int x = 10; x < picture.Width - 10; x += 2)
    {
      Vector o;
      Vector d;
      view.Ray(x + 0.5, y + 0.5, o, d);
      const Seen seen = See(scene, lights, o, d);
      if (seen.Surface < 0 || (opacity < 1.0 && seen.Surface > 0))
      {
        continue;
      }
      bool clear = true;
      for (int k = 0; k < 8 && clear; ++k)
      {
        Vector o2;
        Vector d2;
        view.Ray(x + 0.5 + reach * std::cos(k * vtkMath::Pi() / 4),
          y + 0.5 + reach * std::sin(k * vtkMath::Pi() / 4), o2, d2);
        clear = See(scene, lights, o2, d2) == seen;
      }
      if (!clear)
      {
        continue;
      }
      ++inside;
      double light = Ambient;
      for (size_t i = 0; i < lights.size(); ++i)
      {
        Vector from;
        Vector ray;
        RayTo(lights[i], Along(o, scene.Cast(o, d).T, d), from, ray);
        const double cosine = std::max(0.0, -Dot(seen.Normal, ray));
        light += (seen.Lit >> i & 1u) * Diffuse * cosine * lights[i]->GetIntensity();
      }
      dark += seen.Lit + 1u != 1u << lights.size();
      double worst = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        const double wanted =
          255.0 * opacity * std::min(1.0, light * Colour[static_cast<size_t>(c)]);
        worst = std::max(worst, std::abs(wanted - picture.At(x, y)[c]));
      }
      sum += worst;
      wrong += worst > 8.0;
    }
  }
  std::cout << name << " (" << view.Mapper->GetMethodUsed() << ", "
            << view.Mapper->GetProjectionUsed() << ", " << view.Mapper->GetTransparencyUsed()
            << "): " << inside << " pixels, " << dark << " of them in a shadow, mean error "
            << sum / inside << ", " << 100.0 * wrong / inside << " % wrong\n";
  checks.AtLeast(inside, 1000l, name + ": pixels");
  checks.AtLeast(dark, 100l, name + ": pixels in shadow");
  checks.AtMost(sum / inside, 2.0, name + ": mean error");
  checks.AtMost(100.0 * wrong / inside, 1.0, name + ": per cent wrong");
}

const Vector Middle{ 0.0, 0.0, 0.5 };
}

#endif
