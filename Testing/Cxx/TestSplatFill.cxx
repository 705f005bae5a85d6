// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vtkPointSplatEstimation puts fill points where points are too uneven for disks about them, on the
// surface, and none where points are even; and that other arrays go with them.
#include "Expect.h"
#include "Gathered.h"
#include "RimmedDisc.h"
#include "UnevenColumns.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <string>

namespace
{
constexpr double Rim = 0.1;

using Place = std::function<void(double u, double v, double x[3], double n[3])>;

vtkSmartPointer<vtkPolyData> MakeRandom(int count, const Place& place)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(11);
  Gathered gathered;
  for (int i = 0; i < count; ++i)
  {
    double x[3], n[3];
    const double u = random->GetNextValue();
    place(u, random->GetNextValue(), x, n);
    gathered.Add(x, n);
  }
  return gathered.Cloud;
}

void PlaceOnBall(double u, double v, double x[3], double n[3])
{
  n[2] = 2 * u - 1;
  n[0] = std::sqrt(1 - n[2] * n[2]) * std::cos(2 * vtkMath::Pi() * v);
  n[1] = std::sqrt(1 - n[2] * n[2]) * std::sin(2 * vtkMath::Pi() * v);
  std::copy_n(n, 3, x);
}

vtkSmartPointer<vtkPolyData> MakeCloud(vtkPolyData* mesh)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(mesh->GetPoints());
  cloud->GetPointData()->SetNormals(mesh->GetPointData()->GetNormals());
  return cloud;
}

vtkSmartPointer<vtkPolyData> MakeDisc()
{
  return MakeCloud(RimmedDisc(Rim).MakeMesh(RimmedDisc::Coarse));
}

struct Filled
{
  vtkNew<vtkPointSplatEstimation> Filter;

  explicit Filled(vtkPolyData* data, const std::function<void(vtkPointSplatEstimation*)>& set = {})
  {
    this->Filter->SetInputData(data);
    this->Filter->FillGapsOn();
    if (set)
    {
      set(this->Filter);
    }
    this->Filter->Update();
  }
  vtkPolyData* Get() { return this->Filter->GetOutput(); }
  vtkIdType CountFill() const { return static_cast<vtkIdType>(this->Filter->GetFillPoints().size()); }
  vtkFloatArray* Array(const char* name)
  {
    return vtkFloatArray::SafeDownCast(this->Get()->GetPointData()->GetArray(name));
  }
  /// Where fill points are, in an order that does not depend on the input's.
  std::vector<std::array<double, 3>> GetPlaces()
  {
    std::vector<std::array<double, 3>> places;
    for (vtkIdType i = this->Get()->GetNumberOfPoints() - this->CountFill();
         i < this->Get()->GetNumberOfPoints(); ++i)
    {
      places.emplace_back();
      this->Get()->GetPoint(i, places.back().data());
    }
    std::sort(places.begin(), places.end());
    return places;
  }
};

void TestEven()
{
  vtkSmartPointer<vtkPolyData> ball = MakeRandom(20000, PlaceOnBall);
  Filled random(ball);
  AtMost(double(random.CountFill()), 200, "fill points of 20000 random ones");
  Filled lattice(MakeRandom(10000, [k = 0](double, double, double x[3], double n[3]) mutable {
    x[0] = k % 100;
    x[1] = k++ / 100;
    x[2] = n[0] = n[1] = 0;
    n[2] = 1;
  }));
  Expect(lattice.CountFill() == 0, "a lattice needs no fill points");
  Expect(!lattice.Get()->GetPointData()->HasArray(vtkPointSplatArrays::Source),
    "there is no source without fill points");
  Filled off(MakeDisc(), [](vtkPointSplatEstimation* filter) { filter->FillGapsOff(); });
  Expect(off.CountFill() == 0, "there are no fill points but with FillGaps");
  Expect(off.Get()->GetNumberOfPoints() == MakeDisc()->GetNumberOfPoints(), "and no other points");
  Filled ellipses(MakeDisc(), [](vtkPointSplatEstimation* filter) { filter->SetShapeToElliptical(); });
  Expect(ellipses.CountFill() == 0, "ellipses have no fill points");
}

/// Points that are not quite on a surface whose normals are: their steps are no bends.
void TestSlightNoise()
{
  constexpr int count = 20000;
  const double spacing = std::sqrt(4 * vtkMath::Pi() / count);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (const double noise : { 0.05, 0.1, 0.2 })
  {
    Filled ball(MakeRandom(count, [&](double u, double v, double x[3], double n[3]) {
      PlaceOnBall(u, v, x, n);
      const double off = noise * spacing * (2 * random->GetNextValue() - 1);
      std::transform(n, n + 3, x, [off](double c) { return (1 + off) * c; });
    }));
    AtMost(double(ball.CountFill()), 0.05 * count,
      "fill points of a ball whose points are off it by " + std::to_string(noise));
  }
}

/// Fill points lie on the surface with its normals, disks do not leave it, and together they cover it.
void TestDisc(Filled& filled, double most, const std::string& what)
{
  const RimmedDisc disc(Rim);
  vtkPolyData* output = filled.Get();
  const vtkIdType count = output->GetNumberOfPoints(), own = count - filled.CountFill();
  Expect(filled.CountFill() > 1000, what + " has fill points");
  AtMost(double(filled.CountFill()), double(own), what + ": fill points");
  vtkFloatArray* radii = filled.Array(vtkPointSplatArrays::Radius);
  vtkFloatArray* planes = filled.Array(vtkPointSplatArrays::PlaneNormal);
  vtkFloatArray* curvatures = filled.Array(vtkPointSplatArrays::Curvature);
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  double farthest = 0, least = 1, standing = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double x[3], n[3], given[3], plane[3], t[6], u[3], v[3];
    output->GetPoint(i, x);
    const double distance = disc.GetDistance(x, n);
    normals->GetTuple(i, given);
    if (i >= own)
    {
      farthest = std::max(farthest, distance);
      least = std::min(least, vtkMath::Dot(n, given));
    }
    planes->GetTuple(i, plane);
    curvatures->GetTuple(i, t);
    vtkMath::Perpendiculars(plane, u, v, 0);
    const double r = radii->GetValue(i);
    for (int k = 0; k < 8; ++k)
    {
      const double a = vtkMath::Pi() * k / 4;
      double d[3], y[3];
      for (int c = 0; c < 3; ++c)
      {
        d[c] = r * (std::cos(a) * u[c] + std::sin(a) * v[c]);
      }
      const double bend = t[0] * d[0] * d[0] + t[1] * d[1] * d[1] + t[2] * d[2] * d[2] +
        2 * (t[3] * d[0] * d[1] + t[4] * d[1] * d[2] + t[5] * d[0] * d[2]);
      for (int c = 0; c < 3; ++c)
      {
        y[c] = x[c] + d[c] - 0.5 * bend * plane[c];
      }
      standing = std::max(standing, disc.GetDistance(y, n));
    }
  }
  AtMost(farthest, 1e-3 * Rim, what + ": fill points off the surface");
  AtMost(1 - least, 1e-2, what + ": fill points' normals");
  AtMost(standing, most * Rim, what + ": disks off the surface");

  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(3);
  int bare = 0;
  for (int k = 0; k < 2000; ++k)
  {
    // A place on the upper face, and on the rim.
    const double r = std::sqrt(random->GetNextValue()), a = 2 * vtkMath::Pi() * random->GetNextValue();
    const double b = vtkMath::Pi() * (random->GetNextValue() - 0.5);
    const bool rim = k % 2;
    const double across = rim ? 1 + Rim * std::cos(b) : r;
    const double x[3] = { across * std::cos(a), across * std::sin(a), rim ? Rim * std::sin(b) : Rim };
    double n[3], y[3], m[3];
    disc.GetDistance(x, n);
    bool covered = false;
    for (vtkIdType i = 0; i < count && !covered; ++i)
    {
      output->GetPoint(i, y);
      normals->GetTuple(i, m);
      // What draws a disk reaches a seventh past its radius where no other takes part.
      covered = std::sqrt(vtkMath::Distance2BetweenPoints(x, y)) < 1.12 * radii->GetValue(i) &&
        vtkMath::Dot(n, m) > 0.7;
    }
    bare += !covered;
  }
  Expect(bare == 0, what + ": " + std::to_string(bare) + " of 2000 places are covered by no disk");
}

void TestArrays()
{
  vtkSmartPointer<vtkPolyData> cloud = MakeDisc();
  const vtkIdType own = cloud->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> height;
  height->SetName("height");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colours");
  colours->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> shorter;
  shorter->SetName("shorter");
  shorter->SetNumberOfTuples(5);
  shorter->Fill(0);
  for (vtkIdType i = 0; i < own; ++i)
  {
    height->InsertNextValue(cloud->GetPoint(i)[0]);
    ids->InsertNextValue(1000000 + i);
    names->InsertNextValue(std::to_string(i));
    colours->InsertNextTuple3(200, 128 + 100 * cloud->GetPoint(i)[0], 0);
  }
  for (vtkAbstractArray* array :
    std::initializer_list<vtkAbstractArray*>{ height, ids, names, colours, shorter })
  {
    cloud->GetPointData()->AddArray(array);
  }
  cloud->GetPointData()->SetActiveScalars("height");
  Filled filled(cloud);
  vtkPointData* data = filled.Get()->GetPointData();
  Expect(data->GetScalars() && std::string(data->GetScalars()->GetName()) == "height",
    "active scalars stay so");
  Expect(!data->HasArray("shorter"), "arrays of another length are left out");
  auto* heights = vtkDoubleArray::SafeDownCast(data->GetArray("height"));
  auto* numbers = vtkIdTypeArray::SafeDownCast(data->GetArray("ids"));
  auto* texts = vtkStringArray::SafeDownCast(data->GetAbstractArray("names"));
  auto* hues = vtkUnsignedCharArray::SafeDownCast(data->GetArray("colours"));
  auto* sources = vtkIdTypeArray::SafeDownCast(data->GetArray(vtkPointSplatArrays::Source));
  Expect(heights && numbers && texts && hues && sources, "all arrays are there, of their types");
  if (failures)
  {
    return;
  }
  int others = 0;
  double off = 0;
  for (vtkIdType i = 0; i < filled.Get()->GetNumberOfPoints(); ++i)
  {
    const vtkIdType source = sources->GetValue(i);
    others += i < own ? source != i : source != filled.Filter->GetFillPoints()[i - own].Ends[0];
    others += numbers->GetValue(i) != 1000000 + source;
    others += texts->GetValue(i) != std::to_string(source);
    others += hues->GetTypedComponent(i, 0) != 200;
    if (i >= own)
    {
      const vtkPointSplatEstimation::FillPoint& point = filled.Filter->GetFillPoints()[i - own];
      double mean = 0, sum = 0;
      for (int k = 0; k < point.Count; ++k)
      {
        mean += point.Weights[k] * height->GetValue(point.Ends[k]);
        sum += point.Weights[k];
        others += point.Weights[k] > point.Weights[0] || point.Ends[k] < 0 || point.Ends[k] >= own;
      }
      off = std::max({ off, std::abs(heights->GetValue(i) - mean), std::abs(sum - 1) });
      // On a flat face means are what a linear field is there.
      if (data->GetNormals()->GetTuple(i)[2] > 0.999 && point.Count < 3)
      {
        off = std::max(off, std::abs(mean - filled.Get()->GetPoint(i)[0]) - 1e-3);
      }
    }
  }
  Expect(others == 0, std::to_string(others) + " values are not the nearest point's");
  AtMost(off, 1e-6, "interpolated values");
}

/// In the notch of an L there is nothing, dense though one of its ends is; but its corner is as round as gaps may be wide.
void TestNotch()
{
  Gathered gathered;
  const auto add = [&gathered](double u, double v) {
    const double x[3] = { u, v, 0 }, n[3] = { 0, 0, 1 };
    gathered.Add(x, n);
  };
  for (int j = 0; j <= 40; ++j)
  {
    for (int i = 0; i <= 40; ++i)
    {
      if (i <= 16 || j <= 16)
      {
        add(i, j);
      }
    }
  }
  for (int i = 0; i <= 400; ++i)
  {
    for (int j = 1; j < 5; ++j)
    {
      add(0.1 * i, -0.1 * j);
    }
  }
  Filled filled(gathered.Cloud);
  Expect(filled.CountFill() > 0, "between dense and sparse rows there are fill points");
  int outside = 0;
  for (const std::array<double, 3>& x : filled.GetPlaces())
  {
    outside += (x[0] > 16.01 && x[1] > 16.01 && x[0] + x[1] > 36.3) || x[2] != 0 || x[0] < -1e-6 || x[0] > 40.01;
  }
  Expect(outside == 0, std::to_string(outside) + " fill points are beside the surface");
}

/// A rim alone, with nothing inside, has no lid: the nearest points of its own say how large a hole is.
void TestRing()
{
  vtkSmartPointer<vtkPolyData> disc = RimmedDisc(0.05).MakeMesh({ 48, 4, 0, 8 });
  Gathered ring;
  for (vtkIdType i = 0; i < disc->GetNumberOfPoints(); ++i)
  {
    double x[3];
    disc->GetPoint(i, x);
    if (std::hypot(x[0], x[1]) > 0.99)
    {
      ring.Add(x, disc->GetPointData()->GetNormals()->GetTuple(i));
    }
  }
  Filled filled(ring.Cloud);
  Expect(filled.CountFill() > 0, "a coarse rim has fill points");
  int inside = 0;
  for (const std::array<double, 3>& x : filled.GetPlaces())
  {
    inside += std::hypot(x[0], x[1]) < 0.9;
  }
  Expect(inside == 0, std::to_string(inside) + " fill points are in a ring's opening");
}

/// Three rings of points about holes in a sheet whose columns are up to twelve times as dense in its middle. Of a hole's border some
/// neighbours are points of the second ring across it, whose own cells are closed and small.
void TestHoles()
{
  constexpr int size = 60;
  constexpr double radius = 3, step = 0.4;
  const auto place = [](double t) { return PlaceColumn(t, size, 12); };
  const double centers[4][2] = { { place(15), 15 }, { place(15), 45 }, { place(45), 15 }, { place(45), 45 } };
  const auto isWithin = [&centers](const double x[3], double reach) {
    return std::any_of(centers, centers + 4,
      [&](const double c[2]) { return std::hypot(x[0] - c[0], x[1] - c[1]) < reach; });
  };
  Gathered sheet;
  const auto add = [&sheet](double u, double v) {
    const double x[3] = { u, v, 0 }, n[3] = { 0, 0, 1 };
    sheet.Add(x, n);
  };
  for (const auto& center : centers)
  {
    for (int ring = 0; ring < 3; ++ring)
    {
      const int points = ring == 0 ? 18 : 37;
      for (int k = 0; k < points; ++k)
      {
        const double turn = 2 * vtkMath::Pi() * k / points, r = radius + step * ring;
        add(center[0] + r * std::cos(turn), center[1] + r * std::sin(turn));
      }
    }
  }
  for (int k = 0; k < size * size; ++k)
  {
    const double x[3] = { place(k % size), static_cast<double>(k / size), 0 };
    if (!isWithin(x, radius + 2 * step + 0.6))
    {
      add(x[0], x[1]);
    }
  }
  int inside = 0;
  for (const std::array<double, 3>& x : Filled(sheet.Cloud).GetPlaces())
  {
    inside += isWithin(x.data(), 0.9 * radius);
  }
  Expect(inside == 0, std::to_string(inside) + " fill points are in holes among uneven columns");
}

/**
 * A cube of which one face is five times as dense as others: fill points bevel its edges by no more than a mesh of the
 * points would, whose edges are about 0.05 long.
 */
void TestCreases()
{
  Filled filled(MakeRandom(12000, [k = 0](double u, double v, double x[3], double n[3]) mutable {
    const int face = k < 10000 ? 0 : k % 6;
    ++k;
    n[0] = n[1] = n[2] = 0;
    n[face / 2] = face % 2 ? 1 : -1;
    x[face / 2] = 0.5 * n[face / 2];
    x[(face / 2 + 1) % 3] = u - 0.5;
    x[(face / 2 + 2) % 3] = v - 0.5;
  }));
  double off = 0;
  for (const std::array<double, 3>& x : filled.GetPlaces())
  {
    off = std::max(off, std::abs(0.5 - std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) })));
  }
  AtMost(off, 0.025, "fill points off a cube");
}

/// Each of two processes that have the other's points as ghosts draws its own fill points, and no other does.
void TestGhosts()
{
  Filled whole(MakeDisc());
  std::vector<std::array<double, 3>> both;
  for (const int half : { 0, 1 })
  {
    vtkSmartPointer<vtkPolyData> cloud = MakeDisc();
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      ghosts->InsertNextValue(
        (cloud->GetPoint(i)[0] > 0.03) == (half == 0) ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
    }
    cloud->GetPointData()->AddArray(ghosts);
    Filled filled(cloud);
    const auto places = filled.GetPlaces();
    both.insert(both.end(), places.begin(), places.end());
    auto* marks = vtkUnsignedCharArray::SafeDownCast(
      filled.Get()->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
    Expect(marks && std::all_of(marks->GetPointer(cloud->GetNumberOfPoints()),
                      marks->GetPointer(0) + marks->GetNumberOfTuples(),
                      [](unsigned char mark) { return mark == 0; }),
      "fill points are no ghosts");
  }
  std::sort(both.begin(), both.end());
  Expect(both == whole.GetPlaces(), "two halves have the whole's fill points");
}

void TestBadInput()
{
  // Copies of a cloud that are not quite the same.
  vtkSmartPointer<vtkPolyData> cloud = MakeRandom(5000, PlaceOnBall);
  for (vtkIdType i = 0; i < 5000; ++i)
  {
    double x[3];
    cloud->GetPoint(i, x);
    const vtkIdType copy =
      cloud->GetPoints()->InsertNextPoint(x[0] + 1e-5, x[1] - 2e-5, x[2] + 1e-5 * (i % 7));
    cloud->GetPointData()->GetNormals()->InsertTuple3(copy, x[0], x[1], x[2]);
  }
  AtMost(double(Filled(cloud).CountFill()), 4 * 10000 + 4096, "fill points of copies");

  // Points all over a volume, whose normals have nothing to do with one another. The sizes that would ask for too many
  // fill points are not tried one after the other: that took minutes for a few hundred thousand points.
  const int many = 20000;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(12);
  vtkSmartPointer<vtkPolyData> volume = MakeRandom(many, [&](double u, double v, double x[3], double n[3]) {
    const double place[3] = { u, v, random->GetNextValue() };
    const double turn = random->GetNextValue();
    PlaceOnBall(turn, random->GetNextValue(), x, n);
    std::copy_n(place, 3, x);
  });
  AtMost(double(Filled(volume).CountFill()), 4 * many + 4096, "fill points of a volume");

  // Bad points among the disc's, ahead of them.
  Filled good(MakeDisc());
  vtkSmartPointer<vtkPolyData> disc = MakeDisc();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  disc->GetPoints()->InsertNextPoint(nan, 0, 0);
  disc->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
  disc->GetPoints()->InsertNextPoint(1e38, 0, 0);
  disc->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
  Filled bad(disc);
  Expect(bad.GetPlaces() == good.GetPlaces(), "bad points do not change the others' fill points");

  vtkNew<vtkPolyData> empty;
  Expect(Filled(empty).CountFill() == 0, "nothing has no fill points");
}

void TestSameAgain()
{
  std::vector<std::array<double, 3>> places[2];
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]() { places[threads / 4] = Filled(MakeDisc()).GetPlaces(); });
  }
  Expect(places[0] == places[1], "fill points do not depend on threads");

  vtkSmartPointer<vtkPolyData> disc = MakeDisc(), turned = MakeDisc();
  const vtkIdType count = disc->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    turned->GetPoints()->SetPoint(i, disc->GetPoint(count - 1 - i));
    turned->GetPointData()->GetNormals()->SetTuple(
      i, disc->GetPointData()->GetNormals()->GetTuple(count - 1 - i));
  }
  const Filled other(turned);
  AtMost(std::abs(double(other.CountFill()) - double(places[0].size())), 0.01 * places[0].size(),
    "fill points of the same points in another order, how many more or fewer");

  Filled filled(MakeDisc());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    vtkAlgorithm::SafeDownCast(caller)->AbortExecuteOn();
  });
  filled.Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filled.Filter->Modified();
  filled.Filter->Update();
  Expect(filled.CountFill() == 0 && filled.Get()->GetNumberOfPoints() == 0,
    "aborted filters have no output");
}
}

int TestSplatFill(int, char*[])
{
  TestEven();
  TestSlightNoise();
  Filled cloud(MakeDisc());
  TestDisc(cloud, 0.05, "a cloud");
  vtkSmartPointer<vtkPolyData> mesh = RimmedDisc(Rim).MakeMesh(RimmedDisc::Coarse);
  Filled corners(mesh);
  TestDisc(corners, 0.05, "a mesh");
  Filled left(mesh, [](vtkPointSplatEstimation* filter) { filter->FillMeshGapsOff(); });
  Expect(left.CountFill() == 0, "large triangles can be left to what draws them");
  TestArrays();
  TestNotch();
  TestRing();
  TestHoles();
  TestCreases();
  TestGhosts();
  TestBadInput();
  TestSameAgain();
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
