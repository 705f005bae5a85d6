// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkParticleSurfacePoints of particles that are missing, bad, or odd.
#include "ParticleScenes.h"
#include "ScatteredSamples.h"

#include "vtkParticleSurfacePoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
using Change = std::function<void(vtkParticleSurfacePoints*)>;

vtkSmartPointer<vtkPolyData> Run(vtkDataObject* data, int errors, int warnings,
  const std::string& words, const std::string& what, const Change& change = nullptr)
{
  vtkNew<vtkParticleSurfacePoints> filter;
  Messages messages(filter);
  filter->SetInputData(data);
  if (change)
  {
    change(filter);
  }
  filter->Update();
  messages.Expect(errors, warnings, words, what);
  for (const double number : GetNumbers(filter->GetOutput()))
  {
    Expect(std::isfinite(number), what + ": numbers are finite");
  }
  return filter->GetOutput();
}

void ExpectPoints(vtkPolyData* data, bool some, const std::string& what)
{
  Expect((data->GetNumberOfPoints() > 0) == some,
    what + ": " + std::to_string(data->GetNumberOfPoints()) + " points");
}

vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<std::array<double, 3>>& points)
{
  Particles particles(0);
  for (const auto& p : points)
  {
    particles.Add(p[0], p[1], p[2]);
  }
  return particles.Get();
}

vtkSmartPointer<vtkDoubleArray> AddArray(
  vtkPolyData* data, const char* name, const std::function<double(vtkIdType)>& get)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(get(i));
  }
  data->GetPointData()->AddArray(array);
  return array;
}

vtkSmartPointer<vtkPolyData> MakeBox(int size)
{
  Particles particles(0.15);
  particles.Fill({ { size, size, size } }, [](const double[3]) { return -1.0; });
  return particles.Get();
}

/// The largest distance of a point out of a box that spans from 0 to size.
double GetOutside(vtkPolyData* data, double size)
{
  const double* b = data->GetBounds();
  return std::max({ -b[0], -b[2], -b[4], b[1] - size, b[3] - size, b[5] - size });
}

void Few()
{
  vtkNew<vtkPolyData> nothing;
  ExpectPoints(Run(nothing, 0, 0, "", "no points"), false, "no points");
  nothing->SetPoints(vtkNew<vtkPoints>());
  ExpectPoints(Run(nothing, 0, 0, "", "no points"), false, "no points");
  vtkSmartPointer<vtkPolyData> one = Run(MakePoints({ { { 1, 2, 3 } } }), 0, 0, "", "one");
  ExpectPoints(one, true, "one particle");
  // The default spacing of a lone particle without a size: 0.1.
  AtMost(std::abs(one->GetLength() / (2 * std::sqrt(3.0)) / 0.062 - 1), 0.2, "a lone particle");
  // Its size from its arrays, in the coordinates' units.
  vtkSmartPointer<vtkPolyData> sized = MakePoints({ { { 1, 2, 3 } } });
  AddArray(sized, "mass", [](vtkIdType) { return 8000; });
  AddArray(sized, "Density", [](vtkIdType) { return 1000; });
  AtMost(std::abs(Run(sized, 0, 0, "", "one")->GetLength() / (2 * std::sqrt(3.0)) / 1.24 - 1), 0.2,
    "a lone particle with a mass");
  ExpectPoints(Run(MakePoints({ { { 0, 0, 0 } }, { { 1, 2, 2 } } }), 0, 0, "", "two"), true, "two");
  vtkSmartPointer<vtkPolyData> same =
    MakePoints(std::vector<std::array<double, 3>>(1000, { { 5, 5, 5 } }));
  ExpectPoints(
    Run(same, 0, 1, "999 lie where another one lies", "coincident"), true, "coincident");
  std::vector<std::array<double, 3>> near;
  for (int i = 0; i < 1000; ++i)
  {
    near.push_back({ { 1e-9 * i, 1e-10 * (i % 7), 0 } });
  }
  ExpectPoints(Run(MakePoints(near), 0, 0, "", "next to each other"), true, "next to each other");
}

void Arrays()
{
  auto choose = [](int index, const char* name) {
    return [index, name](vtkParticleSurfacePoints* filter) {
      filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    };
  };
  vtkSmartPointer<vtkPolyData> box = MakeBox(8);
  ExpectPoints(Run(box, 1, 0, "\"Nothing\"", "no such array", choose(1, "Nothing")), false, "none");
  vtkNew<vtkStringArray> strings;
  strings->SetName("Words");
  strings->SetNumberOfValues(box->GetNumberOfPoints());
  box->GetPointData()->AddArray(strings);
  ExpectPoints(Run(box, 1, 0, "\"Words\"", "words", choose(0, "Words")), false, "words");
  vtkNew<vtkFloatArray> few;
  few->SetName("Few");
  few->SetNumberOfTuples(10);
  box->GetPointData()->AddArray(few);
  ExpectPoints(Run(box, 1, 0, "\"Few\"", "too few", choose(2, "Few")), false, "too few");
  // Not asked for by name, an array of wrong length is none of ours.
  few->SetName("density");
  ExpectPoints(Run(box, 0, 0, "", "too few by name"), true, "too few by name");
  box->GetPointData()->RemoveArray("density");

  // Units and conventions of smoothing lengths do not matter.
  AddArray(box, "wide", [](vtkIdType) { return 4.0; });
  AddArray(box, "usual", [](vtkIdType) { return 1.2; });
  const vtkIdType plain = Run(box, 0, 0, "", "plain")->GetNumberOfPoints();
  for (const char* name : { "wide", "usual" })
  {
    const vtkIdType number = Run(box, 0, 0, "", name, choose(0, name))->GetNumberOfPoints();
    Expect(number == plain, std::string(name) + " smoothing lengths change the surface");
  }

  // Densities by summation are too low at the surface; particles there are no larger for it.
  AddArray(box, "rho", [&box](vtkIdType i) {
    double x[3];
    box->GetPoint(i, x);
    return std::min({ x[0], x[1], x[2], 8 - x[0], 8 - x[1], 8 - x[2] }) < 1 ? 400 : 1000;
  });
  AtMost(GetOutside(Run(box, 0, 0, "", "densities"), 8), 0.7, "densities at the surface");
  box->GetPointData()->RemoveArray("rho");

  // What is not positive counts as usual, and what is wild does no harm far away.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double odd[] = { 0, -1, nan, std::numeric_limits<double>::infinity() };
  AddArray(box, "h", [&odd](vtkIdType i) { return i % 10 == 0 ? odd[i / 10 % 4] : 1.2; });
  AtMost(
    GetOutside(Run(box, 0, 1, "52 have a smoothing length", "odd lengths"), 8), 0.7, "lengths");
  AddArray(box, "h", [](vtkIdType i) { return std::pow(10.0, (i * 7919) % 13 - 6); });
  ExpectPoints(Run(box, 0, 1, "more than a thousand times", "wild lengths"), true, "wild lengths");
  AddArray(box, "h", [](vtkIdType i) { return i == 0 ? 1e300 : i == 1 ? 1e-300 : 1.2; });
  AtMost(GetOutside(Run(box, 0, 1, "2 ", "two wild lengths"), 8), 3, "two wild lengths");
}

/// Two sizes of particles, one eight times the other, each with a body of their own.
void Sizes()
{
  vtkSmartPointer<vtkPolyData> both = MakeBox(10);
  const vtkIdType small = both->GetNumberOfPoints();
  for (int i = 0; i < 1000; ++i)
  {
    both->GetPoints()->InsertNextPoint(20 + 8 * (i % 10), 8 * (i / 10 % 10), 8 * (i / 100));
  }
  AddArray(both, "SmoothingLength", [small](vtkIdType i) { return i < small ? 1.2 : 9.6; });
  vtkSmartPointer<vtkPolyData> surface = Run(both, 0, 0, "", "two sizes");
  // The large ones' points are 3.2 apart, the bodies 5.
  auto components = GetComponents(surface, 4.5);
  Expect(components.size() == 2, std::to_string(components.size()) + " bodies of two sizes");
  AtMost(std::abs(surface->GetBounds()[1] - (20 + 72 + 4)), 2, "end of the large ones");
  AtMost(std::abs(surface->GetBounds()[0]), 0.5, "end of the small ones");
}

/// What is bad does not spoil what is good.
void Spoilt()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  vtkSmartPointer<vtkPolyData> box = MakeBox(10);
  vtkPoints* points = box->GetPoints();
  const vtkIdType good = points->GetNumberOfPoints();
  for (int i = 0; i < 10; ++i)
  {
    points->InsertNextPoint(i % 2 ? nan : 0, i % 2 ? 0 : infinity, 0);
    points->InsertNextPoint(points->GetPoint(300));
    points->InsertNextPoint(-5, -5, -5.0 * i); // hidden
  }
  points->InsertNextPoint(1e30, -1e36, 0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const bool hidden = i >= good && (i - good) % 3 == 2;
    ghosts->InsertNextValue(hidden ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  box->GetPointData()->AddArray(ghosts);
  vtkSmartPointer<vtkPolyData> surface =
    Run(box, 0, 1, "11 have coordinates that are not finite", "bad particles");
  AtMost(GetOutside(surface, 10), 0.7, "beside bad particles");
  Run(box, 0, 1, "10 are hidden", "bad particles");
  Run(box, 0, 1, "10 lie where another one lies", "bad particles");
  Expect(surface->GetNumberOfPoints() > 3000, "points beside bad particles");

  for (const double odd : { nan, infinity, 1e300, 1e-300, -1.0 })
  {
    vtkSmartPointer<vtkPolyData> plain = MakeBox(4);
    const bool refused = std::isnan(odd);
    Run(plain, refused ? 1 : 0, 0, refused ? "SetPointSpacing(): NaN" : "", "odd spacing",
      [odd](vtkParticleSurfacePoints* filter) { filter->SetPointSpacing(odd); });
  }
  // A particle as far away as can be, with nothing between.
  vtkSmartPointer<vtkPolyData> far = MakeBox(4);
  far->GetPoints()->InsertNextPoint(1e9, 0, 0);
  surface = Run(far, 0, 0, "", "far away");
  Expect(GetComponents(surface, 10).size() == 2, "a body and a drop far away");
}
}

int TestParticleSurfaceBadInput(int, char*[])
{
  Few();
  Arrays();
  Sizes();
  Spoilt();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
