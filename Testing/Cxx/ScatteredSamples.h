// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Scattered samples of fields known in closed form, and what tests of them have in common.
#ifndef ScatteredSamples_h
#define ScatteredSamples_h

#include "Expect.h"

#include "vtkCallbackCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

/// In the cube from -1 to 1.
struct Field
{
  const char* Name;
  double (*Get)(const double p[3]);
  double Isovalue;

  /// The difference to the isovalue, and its gradient.
  double Evaluate(const double p[3], double gradient[3]) const
  {
    const double step = 1e-5;
    for (int c = 0; c < 3; ++c)
    {
      double a[3] = { p[0], p[1], p[2] }, b[3] = { p[0], p[1], p[2] };
      a[c] -= step;
      b[c] += step;
      gradient[c] = (this->Get(b) - this->Get(a)) / (2 * step);
    }
    return this->Get(p) - this->Isovalue;
  }
};

inline double Ball(const double p[3])
{
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

inline double Distance(const double p[3])
{
  return std::sqrt(Ball(p));
}

inline double Torus(const double p[3])
{
  const double q = std::sqrt(p[0] * p[0] + p[1] * p[1]) - 0.55;
  return std::sqrt(q * q + p[2] * p[2]);
}

inline double Gyroid(const double p[3])
{
  const double a = 4.5;
  return std::sin(a * p[0]) * std::cos(a * p[1]) + std::sin(a * p[1]) * std::cos(a * p[2]) +
    std::sin(a * p[2]) * std::cos(a * p[0]);
}

inline double Metaballs(const double p[3])
{
  const double a[3] = { p[0] - 0.36, p[1], p[2] }, b[3] = { p[0] + 0.36, p[1], p[2] };
  return std::exp(-6 * Ball(a)) + std::exp(-6 * Ball(b));
}

inline const Field fields[] = { { "sphere", Distance, 0.7 }, { "torus", Torus, 0.25 },
  { "gyroid", Gyroid, 0.1 }, { "metaballs", Metaballs, 0.55 } };

/// Ten times denser at one side than at the other, by a ramp or by a step.
enum Density
{
  Uniform,
  Ramp,
  Step
};

inline double GetDensity(Density density, double x)
{
  // The mean is 1.
  x = std::clamp(x, -1.0, 1.0);
  return density == Uniform ? 1 : density == Ramp ? (5.5 + 4.5 * x) / 5.5 : (x < 0 ? 1 : 10) / 5.5;
}

inline double GetSpacing(Density density, int count, double x)
{
  return std::cbrt(8 / (count * GetDensity(density, x)));
}

inline vtkSmartPointer<vtkPolyData> Scatter(const Field& field, Density density, int count)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> values;
  values->SetName("Field");
  while (points->GetNumberOfPoints() < count)
  {
    double p[4];
    for (double& x : p)
    {
      x = random->GetNextRangeValue(-1, 1);
    }
    if (GetDensity(density, p[0]) >= (p[3] + 1) / 2 * GetDensity(density, 1))
    {
      points->InsertNextPoint(p);
      values->InsertNextValue(field.Get(p));
    }
  }
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  samples->SetPoints(points);
  samples->GetPointData()->SetScalars(values);
  return samples;
}

/// Counts errors and warnings, and keeps their words.
struct Messages
{
  vtkNew<vtkCallbackCommand> Command;
  int Errors = 0, Warnings = 0;
  std::string Text;

  explicit Messages(vtkObject* object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* self, void* text) {
      Messages* messages = static_cast<Messages*>(self);
      ++(event == vtkCommand::ErrorEvent ? messages->Errors : messages->Warnings);
      messages->Text += static_cast<const char*>(text);
    });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
  }

  void Expect(int errors, int warnings, const std::string& words, const std::string& what) const
  {
    ::Expect(this->Errors == errors && this->Warnings == warnings, what + ": says " + this->Text);
    ::Expect(this->Text.find(words) != std::string::npos, what + ": does not say " + words);
  }
};

inline std::vector<double> GetNumbers(vtkPolyData* data)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3], n[3];
    data->GetPoint(i, x);
    data->GetPointData()->GetNormals()->GetTuple(i, n);
    numbers.insert(numbers.end(), x, x + 3);
    numbers.insert(numbers.end(), n, n + 3);
  }
  return numbers;
}

/// Points and normals are the same whatever threads make them.
inline void ExpectSameByAllBackends(vtkPolyDataAlgorithm* filter)
{
  std::vector<double> first;
  const std::string usual = vtkSMPTools::GetBackend();
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
    if (vtkSMPTools::SetBackend(backend))
    {
      filter->Modified();
      filter->Update();
      const std::vector<double> all = GetNumbers(filter->GetOutput());
      Expect(first.empty() || all == first, "points depend on threads");
      first = all;
    }
  }
  vtkSMPTools::SetBackend(usual.c_str());
}

#endif
