// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vtkPointSplatEstimation keeps bodies apart that lie in one plane, or close to one another, does not take
// specks for noise, and that a few points without a normal change nothing about the others.
#include "Expect.h"
#include "Gathered.h"

#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;

/// A cloud, and its estimation.
class Bodies
{
public:
  void Add(const Vector& x, Vector n)
  {
    vtkMath::Normalize(n.data());
    this->Points.Add(x.data(), n.data());
  }
  /// Six points about a centre, as an isosurface has about a voxel above its value, with normals as of a noisy field.
  void AddSpeck(const Vector& center, const std::array<double, 6>& reach,
    vtkMinimalStandardRandomSequence* random)
  {
    for (int side = 0; side < 6; ++side)
    {
      Vector x = center, n;
      std::generate(n.begin(), n.end(), [&]() { return random->GetNextRangeValue(-0.4, 0.4); });
      n[side / 2] = side % 2 ? 1 : -1;
      x[side / 2] += reach[side] * (side % 2 ? 1 : -1);
      this->Add(x, n);
    }
  }
  vtkPointSplatEstimation* Estimate()
  {
    this->Filter->SetInputData(this->Points.Cloud);
    this->Filter->FillGapsOn();
    this->Filter->Modified();
    this->Filter->Update();
    return this->Filter;
  }
  vtkPolyData* Get() { return this->Filter->GetOutput(); }
  vtkIdType GetNumberOfPoints() { return this->Points.Cloud->GetNumberOfPoints(); }
  void DropNormal(vtkIdType id) { this->Points.Cloud->GetPointData()->GetNormals()->SetTuple3(id, 0, 0, 0); }
  double GetRadius(vtkIdType id)
  {
    return this->Get()->GetPointData()->GetArray(vtkPointSplatArrays::Radius)->GetComponent(id, 0);
  }

private:
  Gathered Points;
  vtkNew<vtkPointSplatEstimation> Filter;
};

/// Four legs with soles in one plane, of which two points in the middle tell: what is nearest in that plane then are the
/// other soles.
void TestSoles()
{
  constexpr int around = 34, rows = 30;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  const auto off = [&](double most) { return random->GetNextRangeValue(-most, most); };
  double largest = 0;
  for (int animal = 0; animal < 8; ++animal)
  {
    Bodies legs;
    for (const Vector& at : { Vector{ 0, 0, 0 }, Vector{ 9, 0, 0 }, Vector{ 0, 9, 0 }, Vector{ 9, 9, 0 } })
    {
      for (int k = 0; k < around * rows; ++k)
      {
        const int row = k / around;
        const double angle = 2 * vtkMath::Pi() * (k + off(0.2)) / around, radius = 1 - 0.01 * row;
        const double x = std::cos(angle), y = std::sin(angle);
        const double down = row == 0 ? 1 + off(0.7) : 0.08 + off(0.08);
        legs.Add({ at[0] + radius * x, at[1] + radius * y, 0.17 * row + off(0.04) }, { x, y, -down });
      }
      const double x = at[0] + off(0.3), y = at[1] + off(0.3);
      for (int k = 0; k < 2; ++k)
      {
        legs.Add({ x + off(0.25), y + off(0.25), off(0.02) }, { 0, 0, -1 });
      }
    }
    legs.Estimate();
    for (vtkIdType id = 0; id < legs.Get()->GetNumberOfPoints(); ++id)
    {
      largest = std::max(largest, legs.GetRadius(id));
    }
  }
  AtMost(largest, 1, "the largest splat of legs of that radius");
}

/// Bodies of fewer points than are looked at around one are no noise, and nothing is put between them.
void TestSpecks()
{
  constexpr double apart = 4;
  Bodies specks;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  std::vector<std::array<double, 6>> reaches(4096);
  for (std::size_t i = 0; i < reaches.size(); ++i)
  {
    for (double& reach : reaches[i])
    {
      reach = random->GetNextRangeValue(0.1, 0.9);
    }
    specks.AddSpeck(
      { apart * (i % 16), apart * (i / 16 % 16), apart * (i / 256) }, reaches[i], random);
  }
  vtkPointSplatEstimation* filter = specks.Estimate();
  AtMost(filter->GetNoise(), 0.1, "the noise of specks");
  AtMost(filter->GetContradiction(), 0.04, "the contradiction of specks");
  int between = 0;
  for (vtkIdType id = specks.GetNumberOfPoints(); id < specks.Get()->GetNumberOfPoints(); ++id)
  {
    const double* x = specks.Get()->GetPoint(id);
    std::size_t speck = 0;
    bool past = false;
    for (int axis = 2; axis >= 0; --axis)
    {
      speck = 16 * speck + static_cast<std::size_t>(std::lround(x[axis] / apart));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double away = x[axis] - apart * std::lround(x[axis] / apart);
      past = past || std::abs(away) > 0.1 + 1.25 * reaches[speck][2 * axis + (away > 0 ? 1 : 0)];
    }
    between += past;
  }
  const double fill =
    static_cast<double>(specks.Get()->GetNumberOfPoints() - specks.GetNumberOfPoints());
  AtMost(between, 0.02 * fill, "of " + std::to_string(fill) + " fill points those between specks");
}

/// Specks close to a plane: few triangles lead from one to the other, and none where their corners face both its sides.
void TestClose()
{
  constexpr int side = 100;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  Bodies bodies;
  for (int k = 0; k < side * side; ++k)
  {
    bodies.Add({ double(k % side), double(k / side), 0 }, { 0, 0, 1 });
  }
  for (int k = 0; k < side; ++k)
  {
    std::array<double, 6> reach;
    std::generate(reach.begin(), reach.end(), [&]() { return random->GetNextRangeValue(0.1, 0.9); });
    const double x = random->GetNextValue(), y = random->GetNextValue();
    bodies.AddSpeck({ 5 + 10 * (k % 10) + x, 5 + 10 * (k / 10) + y, 1.8 }, reach, random);
  }
  bodies.Estimate();
  AtMost(static_cast<double>(bodies.Get()->GetNumberOfPoints() - bodies.GetNumberOfPoints()), 2150,
    "fill points of a hundred specks");
}

/// Isosurfaces have degenerate triangles, whose corners get no normals: the others' splats are as small all the same.
void TestFewWithoutNormals()
{
  constexpr int around = 5, rows = 400;
  Bodies tube;
  for (int k = 0; k < around * rows; ++k)
  {
    const double angle = 2 * vtkMath::Pi() * (k % around + 0.5 * (k / around % 2)) / around;
    const double x = std::cos(angle), y = std::sin(angle);
    tube.Add({ x, y, 0.9 * (k / around) }, { x, y, 0 });
  }
  tube.Estimate();
  std::vector<double> radii;
  for (vtkIdType id = 0; id < tube.GetNumberOfPoints(); ++id)
  {
    radii.push_back(tube.GetRadius(id));
  }
  const double fill = static_cast<double>(tube.Get()->GetNumberOfPoints() - tube.GetNumberOfPoints());
  constexpr vtkIdType step = 101;
  for (vtkIdType id = 50; id < tube.GetNumberOfPoints(); id += step)
  {
    tube.DropNormal(id);
  }
  tube.Estimate();
  int changed = 0;
  for (vtkIdType id = 0; id < tube.GetNumberOfPoints(); ++id)
  {
    changed += std::abs(tube.GetRadius(id) - radii[id]) > 0.05 * radii[id];
  }
  AtMost(changed, 10.0 * tube.GetNumberOfPoints() / step, "splats that a few points without normals change");
  const double left = static_cast<double>(tube.Get()->GetNumberOfPoints() - tube.GetNumberOfPoints());
  Expect(fill > 0 && left > 0.8 * fill, "and there is fill between them as before");
}
}

int TestSplatApart(int, char*[])
{
  TestSoles();
  TestSpecks();
  TestClose();
  TestFewWithoutNormals();
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
