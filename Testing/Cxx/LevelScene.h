// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What tests of levels of detail share: a torus of many points, drawn with levels and without.
#ifndef LevelScene_h
#define LevelScene_h

#include "SplatScene.h"

#include "vtkFloatArray.h"

#include <chrono>
#include <cstring>
#include <thread>

namespace LevelScene
{
using namespace SplatScene;

constexpr int Pixels = 400;

/// A torus; evenly random, with its radii. roughness: of the normals, radians.
inline vtkSmartPointer<vtkPolyData> Torus(int count, double roughness, bool coloured)
{
  vtkNew<vtkMinimalStandardRandomSequence> sequence;
  sequence->SetSeed(3);
  auto random = [&sequence](double low, double high) {
    sequence->Next();
    return sequence->GetRangeValue(low, high);
  };
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  const double pi = vtkMath::Pi();
  const float radius = static_cast<float>(1.5 * std::sqrt(4.0 * pi * pi * 0.4 / count));
  while (points->GetNumberOfPoints() < count)
  {
    const double a = random(0.0, 2.0 * pi);
    const double b = random(0.0, 2.0 * pi);
    if (random(0.0, 1.4) > 1.0 + 0.4 * std::cos(b))
    {
      continue;
    }
    double n[3] = { std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b) };
    points->InsertNextPoint(std::cos(a) + 0.4 * n[0], std::sin(a) + 0.4 * n[1], 0.4 * n[2]);
    for (double& x : n)
    {
      x += random(-roughness, roughness);
    }
    vtkMath::Normalize(n);
    normals->InsertNextTuple(n);
    radii->InsertNextValue(radius);
    values->InsertNextValue(static_cast<float>(std::sin(3.0 * a) * std::sin(2.0 * b)));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(radii);
  if (coloured)
  {
    data->GetPointData()->SetScalars(values);
  }
  return data;
}

struct Scene
{
  vtkNew<vtkPointSplatMapper> Mapper;
  Window Win{ Pixels };
  vtkActor* Actor = nullptr;

  explicit Scene(vtkDataObject* data)
  {
    this->Mapper->SetInputDataObject(data);
    this->Mapper->SetScalarRange(-1.0, 1.0);
    this->Win.SmoothOutlines = true;
    this->Actor = this->Win.Add(this->Mapper);
    this->Win.Renderer->ResetCamera();
    this->Win.Renderer->GetActiveCamera()->Elevation(-50.0);
    this->Win.Renderer->ResetCameraClippingRange();
  }
  bool HasLevels() const
  {
    return std::strstr(this->Mapper->GetChoices(), "stand for others") != nullptr;
  }
  /// Draws until levels are there; at most a minute.
  bool Wait()
  {
    for (int i = 0; i < 1200 && !this->HasLevels(); ++i)
    {
      this->Win.Draw();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return this->HasLevels();
  }
  Picture DrawAll()
  {
    this->Mapper->LevelOfDetailOff();
    Picture all = this->Win.Draw();
    this->Mapper->LevelOfDetailOn();
    return all;
  }
};

inline bool Expect(bool good, const std::string& what)
{
  if (!good)
  {
    std::cerr << "FAILED: " << what << "\n";
  }
  return good;
}

inline bool IsLike(const Picture& a, const Picture& b, double least, const std::string& what)
{
  const double psnr = Psnr(a, b);
  std::cout << what << ": " << psnr << " dB\n";
  return Expect(psnr >= least, what + ": " + std::to_string(psnr) + " dB");
}
}

#endif
