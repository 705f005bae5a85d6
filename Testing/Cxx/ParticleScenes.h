// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Particles of fluids whose surface is known, one unit apart.
#ifndef ParticleScenes_h
#define ParticleScenes_h

#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

/**
 * Particles on a lattice, each moved at random by up to `jitter` along each axis.
 */
class Particles
{
public:
  vtkNew<vtkPoints> Points;

  explicit Particles(double jitter)
    : Jitter(jitter)
  {
    this->Points->SetDataTypeToDouble();
    this->Random->SetSeed(11);
  }

  void Add(double x, double y, double z, bool moved = true)
  {
    double p[3] = { x, y, z };
    for (double& c : p)
    {
      c += moved ? this->Random->GetNextRangeValue(-this->Jitter, this->Jitter) : 0.0;
    }
    this->Points->InsertNextPoint(p);
  }

  /// Where the function is negative, in a box of whole numbers of cells.
  void Fill(const std::array<int, 3>& size, const std::function<double(const double[3])>& outside)
  {
    for (int k = 0; k < size[2]; ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const double p[3] = { i + 0.5, j + 0.5, k + 0.5 };
          if (outside(p) < 0)
          {
            this->Add(p[0], p[1], p[2]);
          }
        }
      }
    }
  }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(this->Points);
    return data;
  }

private:
  double Jitter;
  vtkNew<vtkMinimalStandardRandomSequence> Random;
};

/// The height of water in a tank 30 long and 16 wide.
inline double GetWave(double x)
{
  return 9 + 3 * std::sin(x / 30 * 2 * vtkMath::Pi());
}

/// Water in the tank, four drops, one of them of two particles, and a sheet of one layer above.
struct DamBreak
{
  static constexpr int Drops = 4;
  static constexpr double SheetHeight = 30;
  static constexpr int SheetSize = 14;

  static vtkSmartPointer<vtkPolyData> Make(double jitter)
  {
    Particles particles(jitter);
    particles.Fill({ { 30, 16, 12 } }, [](const double p[3]) { return p[2] - GetWave(p[0]); });
    for (int drop = 0; drop < Drops; ++drop)
    {
      particles.Add(4 + 6 * drop, 5, 20, false);
    }
    particles.Add(4 + 6 * (Drops - 1) + 0.8, 5, 20, false);
    for (int i = 0; i < SheetSize; ++i)
    {
      for (int j = 0; j < SheetSize; ++j)
      {
        particles.Add(i + 0.5, j + 0.5, SheetHeight);
      }
    }
    return particles.Get();
  }
};

/// The point numbers of each set of points that are connected by steps up to a length.
inline std::vector<std::vector<vtkIdType>> GetComponents(vtkPolyData* points, double step)
{
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(points);
  locator->BuildLocator();
  std::vector<bool> seen(points->GetNumberOfPoints(), false);
  std::vector<std::vector<vtkIdType>> components;
  vtkNew<vtkIdList> near;
  for (vtkIdType start = 0; start < points->GetNumberOfPoints(); ++start)
  {
    if (seen[start])
    {
      continue;
    }
    seen[start] = true;
    components.push_back({ start });
    for (std::size_t at = 0; at < components.back().size(); ++at)
    {
      locator->FindPointsWithinRadius(step, points->GetPoint(components.back()[at]), near);
      for (vtkIdType i = 0; i < near->GetNumberOfIds(); ++i)
      {
        if (!seen[near->GetId(i)])
        {
          seen[near->GetId(i)] = true;
          components.back().push_back(near->GetId(i));
        }
      }
    }
  }
  return components;
}

/// The volume that points of even density enclose, from an inner point: a third of each point's
/// share of the area times its height over that point.
inline double GetVolume(vtkPolyData* data, const std::vector<vtkIdType>& ids, double share)
{
  double centre[3] = { 0, 0, 0 }, x[3], n[3], volume = 0;
  for (const vtkIdType id : ids)
  {
    data->GetPoint(id, x);
    for (int c = 0; c < 3; ++c)
    {
      centre[c] += x[c] / ids.size();
    }
  }
  for (const vtkIdType id : ids)
  {
    data->GetPoint(id, x);
    data->GetPointData()->GetNormals()->GetTuple(id, n);
    vtkMath::Subtract(x, centre, x);
    volume += vtkMath::Dot(x, n) * share / 3;
  }
  return volume;
}

#endif
