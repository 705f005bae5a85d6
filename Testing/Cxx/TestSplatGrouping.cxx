// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Groups of splats against brute force, closed forms and each other.
#include "Expect.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkLogger.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatGrouping.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <vector>

namespace
{
/**
 * A cloud with normals and radii, built splat by splat.
 */
struct Cloud
{
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkDoubleArray> Radii;

  Cloud()
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Radii->SetName("SplatRadius");
    this->Data->SetPoints(this->Points);
    this->Data->GetPointData()->SetNormals(this->Normals);
    this->Data->GetPointData()->AddArray(this->Radii);
  }
  void Add(double x, double y, double z, double nx, double ny, double nz, double r)
  {
    this->Points->InsertNextPoint(x, y, z);
    this->Normals->InsertNextTuple3(nx, ny, nz);
    this->Radii->InsertNextValue(r);
  }
};

struct Random
{
  vtkNew<vtkMinimalStandardRandomSequence> Sequence;
  explicit Random(int seed) { this->Sequence->SetSeed(seed); }
  double operator()(double low, double high)
  {
    this->Sequence->Next();
    return this->Sequence->GetRangeValue(low, high);
  }
};

vtkIntArray* Groups(vtkPointSplatGrouping* grouping)
{
  grouping->Update();
  return vtkIntArray::SafeDownCast(
    grouping->GetOutput()->GetPointData()->GetAbstractArray("SplatGroup"));
}

/**
 * Thousands of small clouds: random, lattices whose disks touch exactly, nested and identical
 * splats, radii over six decades.
 */
void TestIndependence()
{
  Random random(7);
  long pairs = 0;
  for (int trial = 0; trial < 3000; ++trial)
  {
    Cloud cloud;
    const int count = static_cast<int>(random(1, 60));
    const int kind = trial % 5;
    for (int i = 0; i < count; ++i)
    {
      double r = random(0.05, 0.3);
      double p[3] = { random(0, 1), random(0, 1), random(0, 1) };
      if (kind == 1)
      {
        // Multiples of 1/8 and radii of 1/16: disks touch without a rounding error.
        for (double& x : p)
        {
          x = std::floor(8 * x) / 8;
        }
        r = 0.0625;
      }
      else if (kind == 2 && i > 0)
      {
        cloud.Points->GetPoint(i / 2, p); // identical positions, some identical radii
        r = i % 3 ? r : cloud.Radii->GetValue(i / 2);
      }
      else if (kind == 3)
      {
        r = std::pow(10.0, random(-5, 1));
      }
      else if (kind == 4)
      {
        // Far from the origin, in a plane.
        p[0] += 500000;
        p[1] += 4000000;
        p[2] = 0;
      }
      cloud.Add(p[0], p[1], p[2], random(-1, 1), random(-1, 1), random(-1, 1), r);
    }
    vtkNew<vtkPointSplatGrouping> grouping;
    grouping->SetInputData(cloud.Data);
    grouping->SetReach(1.0);
    vtkIntArray* groups = Groups(grouping);
    std::vector<int> degree(count, 0);
    int largest = 0;
    for (int i = 0; i < count; ++i)
    {
      Expect(groups->GetValue(i) >= 0 && groups->GetValue(i) < grouping->GetNumberOfGroups(),
        "a splat without a group");
      for (int j = 0; j < i; ++j)
      {
        double p[3], q[3];
        cloud.Points->GetPoint(i, p);
        cloud.Points->GetPoint(j, q);
        const double reach = cloud.Radii->GetValue(i) + cloud.Radii->GetValue(j);
        if (std::sqrt(vtkMath::Distance2BetweenPoints(p, q)) < reach * (1 - 1e-12))
        {
          ++pairs;
          ++degree[i];
          ++degree[j];
          Expect(groups->GetValue(i) != groups->GetValue(j), "splats of a group overlap");
        }
      }
    }
    double mean = 0;
    for (const int d : degree)
    {
      largest = std::max(largest, d);
      mean += static_cast<double>(d) / count;
    }
    if (kind != 1)
    {
      Expect(grouping->GetMaximumDegree() == largest &&
          std::abs(grouping->GetMeanDegree() - mean) < 1e-9,
        "degrees");
    }
    Expect(grouping->GetNumberOfGroups() <= largest + 1, "more groups than the largest degree asks");
  }
  Expect(pairs > 100000, "too few overlaps to tell anything");
}

/**
 * A sphere, a torus or a square, sampled at random.
 */
void Sample(Cloud& cloud, int kind, int count, double spacings, int seed)
{
  Random random(seed);
  const double area = kind == 0 ? 4 * vtkMath::Pi()
    : kind == 1                 ? 4 * vtkMath::Pi() * vtkMath::Pi() * 0.4
                                : 1.0;
  const double r = spacings * std::sqrt(area / count);
  while (cloud.Points->GetNumberOfPoints() < count)
  {
    const double u = random(0, 2 * vtkMath::Pi());
    if (kind == 0)
    {
      const double z = random(-1, 1);
      const double c = std::sqrt(1 - z * z);
      cloud.Add(c * std::cos(u), c * std::sin(u), z, c * std::cos(u), c * std::sin(u), z, r);
    }
    else if (kind == 1)
    {
      const double v = random(0, 2 * vtkMath::Pi());
      if (random(0, 1.4) < 1 + 0.4 * std::cos(v))
      {
        const double n[3] = { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) };
        cloud.Add(std::cos(u) + 0.4 * n[0], std::sin(u) + 0.4 * n[1], 0.4 * n[2], n[0], n[1], n[2],
          r);
      }
    }
    else
    {
      const double x = random(0, 1);
      cloud.Add(x, random(0, 1), 0, 0, 0, 1, r);
    }
  }
}

void TestRelaxations()
{
  Cloud plane;
  Sample(plane, 2, 2000, 1.0, 3);
  vtkNew<vtkPointSplatGrouping> grouping;
  grouping->SetInputData(plane.Data);
  grouping->SetReach(1.0);
  int last = 1000;
  for (const double c : { 1.0, 0.8, 0.6, 0.4 })
  {
    grouping->SetOverlapFactor(c);
    vtkIntArray* groups = Groups(grouping);
    Expect(grouping->GetNumberOfGroups() <= last, "a smaller c gives more groups");
    last = grouping->GetNumberOfGroups();
    const double reach = c * 2 * plane.Radii->GetValue(0);
    for (int i = 0; i < 2000; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        double p[3], q[3];
        plane.Points->GetPoint(i, p);
        plane.Points->GetPoint(j, q);
        if (groups->GetValue(i) == groups->GetValue(j) &&
          vtkMath::Distance2BetweenPoints(p, q) < reach * reach * (1 - 1e-12))
        {
          Expect(false, "splats of a group are nearer than c (ri + rj)");
        }
      }
    }
  }
  grouping->SetOverlapFactor(1.0);
  grouping->SetCoplanarAngle(5.0);
  grouping->Update();
  Expect(grouping->GetNumberOfGroups() == 1, "a plane of one colour needs one group");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < 2000; ++i)
  {
    colors->InsertNextTuple3(i % 2 ? 255 : 0, 0, 0);
  }
  plane.Data->GetPointData()->SetScalars(colors);
  grouping->Update();
  Expect(grouping->GetNumberOfGroups() > 1, "splats of different colours share a group");

  Cloud sheets; // two, back to back
  sheets.Add(0, 0, 0, 0, 0, 1, 1);
  sheets.Add(0, 0, -0.1, 0, 0, -1, 1);
  vtkNew<vtkPointSplatGrouping> back;
  back->SetInputData(sheets.Data);
  back->Update();
  Expect(back->GetNumberOfGroups() == 2, "sheets overlap");
  back->IgnoreOppositeOn();
  back->Update();
  Expect(back->GetNumberOfGroups() == 1, "opposite sheets are ignored");
}

void TestDeterminism()
{
  Cloud torus;
  Sample(torus, 1, 20000, 0.9, 5);
  std::vector<int> reference[2];
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&]() {
      for (const int coloring : { 0, 1 })
      {
        vtkNew<vtkPointSplatGrouping> grouping;
        grouping->SetInputData(torus.Data);
        grouping->SetColoring(coloring);
        grouping->SetWantedNumberOfGroups(4);
        vtkIntArray* groups = Groups(grouping);
        const std::vector<int> found(groups->GetPointer(0), groups->GetPointer(0) + 20000);
        reference[coloring] = threads == 1 ? found : reference[coloring];
        Expect(found == reference[coloring], "groups depend on the number of threads");
      }
    });
  }
}

double Lens(double d, double r)
{
  return d >= 2 * r ? 0.0 : 2 * r * r * std::acos(d / (2 * r)) - 0.5 * d * std::sqrt(4 * r * r - d * d);
}

/**
 * Of pairs within groups, all of one radius.
 */
double OverlapWithin(const Cloud& cloud, const std::vector<int>& groups)
{
  double sum = 0;
  const double r = cloud.Radii->GetValue(0);
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (groups[i] == groups[j])
      {
        double p[3], q[3];
        cloud.Points->GetPoint(static_cast<vtkIdType>(i), p);
        cloud.Points->GetPoint(static_cast<vtkIdType>(j), q);
        sum += Lens(std::sqrt(vtkMath::Distance2BetweenPoints(p, q)), r);
      }
    }
  }
  return sum;
}

void TestWeighted()
{
  for (int seed = 1; seed <= 10; ++seed)
  {
    Cloud cloud;
    Sample(cloud, seed % 3, 800, 1.0, seed);
    vtkNew<vtkPointSplatGrouping> grouping;
    grouping->SetInputData(cloud.Data);
    grouping->SetReach(1.0);
    vtkIntArray* first = Groups(grouping);
    const std::vector<int> largestFirst(first->GetPointer(0), first->GetPointer(0) + 800);
    double last = 1e30;
    for (const int K : { 1, 2, 3, 4, 6, 8 })
    {
      grouping->SetColoringToWeighted();
      grouping->SetWantedNumberOfGroups(K);
      vtkIntArray* groups = Groups(grouping);
      const std::vector<int> weighted(groups->GetPointer(0), groups->GetPointer(0) + 800);
      const double left = OverlapWithin(cloud, weighted);
      const double total = 800 * vtkMath::Pi() * std::pow(cloud.Radii->GetValue(0), 2);
      Expect(std::abs(left / total - grouping->GetOverlapWithinGroups()) < 1e-4, "overlap reported");
      // Largest-first cut down in either of two ways: wrapped around, or the least colour's.
      std::vector<int> wrapped = largestFirst;
      std::vector<int> clamped = largestFirst;
      for (std::size_t i = 0; i < wrapped.size(); ++i)
      {
        wrapped[i] %= K;
        clamped[i] = std::min(clamped[i], K - 1);
      }
      Expect(left <= OverlapWithin(cloud, wrapped) * (1 + 1e-6), "worse than largest-first, wrapped");
      Expect(left <= OverlapWithin(cloud, clamped) * (1 + 1e-6), "worse than largest-first, clamped");
      Expect(left <= last * (1 + 1e-6), "more groups leave more overlap");
      last = left;
    }
    grouping->SetWantedNumberOfGroups(0);
    grouping->SetMaximumOverlap(0.02);
    grouping->Update();
    Expect(grouping->GetOverlapWithinGroups() <= 0.02, "more overlap than is wanted");
    const int K = grouping->GetNumberOfGroups();
    grouping->SetWantedNumberOfGroups(K - 1);
    grouping->Update();
    Expect(K == 1 || grouping->GetOverlapWithinGroups() > 0.02, "fewer groups would have done");
  }
}

void TestCoverage()
{
  // Two disks of known overlap, in one plane: each group covers one of them.
  for (const double d : { 0.2, 0.7, 1.3, 1.9 })
  {
    Cloud two;
    two.Add(0, 0, 0, 0, 0, 1, 1);
    two.Add(d, 0, 0, 0, 0, 1, 1);
    vtkNew<vtkPointSplatGrouping> grouping;
    grouping->SetInputData(two.Data);
    grouping->SetReach(1.0);
    grouping->SetCoverageToDuplicate();
    grouping->SetMaximumClipped(0.0);
    grouping->Update();
    const double share = vtkMath::Pi() / (2 * vtkMath::Pi() - Lens(d, 1));
    Expect(grouping->GetNumberOfGroups() == 2 && grouping->GetNumberOfDuplicates() == 0,
      "two disks, two groups");
    Expect(std::abs(grouping->GetGroupCoverage(0) - share) < 0.01, "two disks' covered share");
  }

  for (int kind = 0; kind < 3; ++kind)
  {
    Cloud cloud;
    Sample(cloud, kind, 6000, 1.6, 11 + kind); // random samplings need large disks to cover
    vtkNew<vtkPointSplatGrouping> grouping;
    grouping->SetInputData(cloud.Data);
    grouping->SetReach(1.0);
    grouping->SetColoringToWeighted();
    grouping->SetWantedNumberOfGroups(4);
    grouping->SetCoverageToEnlarge();
    vtkIntArray* groups = Groups(grouping);
    vtkDataArray* radii = grouping->GetOutput()->GetPointData()->GetArray("SplatRadius");
    const double r = cloud.Radii->GetValue(0);
    for (int k = 0; k < 4; ++k)
    {
      const double covered = grouping->GetGroupCoverage(k);
      const double scale = grouping->GetGroupRadiusScale(k);
      Expect(covered > 0.99 && covered < 1.01,
        "enlarged radii miss the area: " + std::to_string(covered));
      Expect(scale > 1 && scale < 4, "scale " + std::to_string(scale));
    }
    for (vtkIdType i = 0; i < 6000; ++i)
    {
      if (std::abs(radii->GetComponent(i, 0) -
            r * grouping->GetGroupRadiusScale(groups->GetValue(i))) > 1e-6)
      {
        Expect(false, "a radius is not scaled as reported");
      }
    }
    // A Monte Carlo count of one group's cover, that shares no code with the filter.
    Cloud probes;
    Sample(probes, kind, 4000, 1.0, 99);
    int hit = 0;
    int probed = 0;
    for (vtkIdType s = 0; s < 4000; ++s)
    {
      double p[3];
      probes.Points->GetPoint(s, p);
      // The square's splats stand out over its border: only its middle can tell.
      if (kind == 2 && (p[0] < 0.15 || p[1] < 0.15 || p[0] > 0.85 || p[1] > 0.85))
      {
        continue;
      }
      ++probed;
      bool covered = false;
      for (vtkIdType i = 0; i < 6000 && !covered; ++i)
      {
        double q[3], n[3];
        cloud.Points->GetPoint(i, q);
        cloud.Normals->GetTuple(i, n);
        const double R = radii->GetComponent(i, 0);
        const double e[3] = { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
        const double off = vtkMath::Dot(e, n);
        covered = groups->GetValue(i) == 0 && vtkMath::Dot(e, e) - off * off < R * R &&
          std::abs(off) < R;
      }
      hit += covered;
    }
    Expect(hit > 0.975 * probed, "probes covered: " + std::to_string(double(hit) / probed));

    // Duplicates, where disks are so small that a quarter of them leaves gaps.
    Cloud sparse;
    Sample(sparse, kind, 6000, 0.7, 21 + kind);
    vtkNew<vtkFloatArray> lines;
    lines->SetName("SplatClip");
    lines->SetNumberOfComponents(6);
    for (int i = 0; i < 6000; ++i)
    {
      lines->InsertNextTuple6(i, 0, 0, 0, 0, i);
    }
    sparse.Data->GetPointData()->AddArray(lines);
    grouping->SetInputData(sparse.Data);
    grouping->SetCoverageToDuplicate();
    groups = Groups(grouping);
    vtkPolyData* out = grouping->GetOutput();
    auto* ids =
      vtkIdTypeArray::SafeDownCast(out->GetPointData()->GetAbstractArray("vtkOriginalPointIds"));
    Expect(grouping->GetNumberOfDuplicates() > 0 &&
        out->GetNumberOfPoints() == 6000 + grouping->GetNumberOfDuplicates(),
      "number of points with duplicates");
    std::set<std::pair<vtkIdType, int>> seen;
    for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      out->GetPoint(i, p);
      sparse.Points->GetPoint(ids->GetValue(i), q);
      if (vtkMath::Distance2BetweenPoints(p, q) != 0 ||
        out->GetPointData()->GetArray("SplatClip")->GetComponent(i, 5) != ids->GetValue(i) ||
        !seen.insert({ ids->GetValue(i), groups->GetValue(i) }).second)
      {
        Expect(false, "a duplicate is not its original, or twice in a group");
      }
    }
    for (int k = 0; k < 4; ++k)
    {
      Expect(grouping->GetGroupCoverage(k) > grouping->GetGroupCoverageBefore(k) + 0.05,
        "duplicates cover nothing");
    }
  }
}

void TestEllipses()
{
  Cloud row;
  vtkNew<vtkFloatArray> axes[2];
  for (int a = 0; a < 2; ++a)
  {
    axes[a]->SetName(a ? "SplatAxis2" : "SplatAxis1");
    axes[a]->SetNumberOfComponents(3);
  }
  for (int i = 0; i < 10; ++i)
  {
    row.Add(i, 0, 0, 0, 0, 1, 0);
    axes[0]->InsertNextTuple3(0.8, 0, 0);
    axes[1]->InsertNextTuple3(0, 0.1, 0);
  }
  row.Data->GetPointData()->RemoveArray("SplatRadius");
  row.Data->GetPointData()->AddArray(axes[0]);
  row.Data->GetPointData()->AddArray(axes[1]);
  vtkNew<vtkPointSplatGrouping> grouping;
  grouping->SetInputData(row.Data);
  grouping->SetReach(1.0);
  grouping->Update();
  Expect(grouping->GetNumberOfGroups() == 2 && grouping->GetMaximumDegree() == 2, "ellipses in a row");
}

void TestBadInput()
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkPointSplatGrouping> grouping;
  grouping->AddObserver(vtkCommand::ErrorEvent, observer);
  grouping->AddObserver(vtkCommand::WarningEvent, observer);
  vtkNew<vtkPolyData> empty;
  grouping->SetInputData(empty);
  grouping->Update();
  Expect(grouping->GetNumberOfGroups() == 0 && !observer->GetError(), "no points");

  const double nan = std::numeric_limits<double>::quiet_NaN();
  Cloud bad;
  bad.Add(0, 0, 0, 0, 0, 1, 0.5);
  bad.Add(nan, 0, 0, 0, 0, 1, 0.5);
  bad.Add(0, 0, 0, 0, 0, 0, 0.5);
  bad.Add(0, 0, 0, nan, 0, 1, 0.5);
  bad.Add(0, 0, 0, 0, 0, 1, -1);
  bad.Add(0, 0, 0, 0, 0, 1, nan);
  bad.Add(0, 0, 0, 0, 0, 1, 0);
  bad.Add(1e300, 0, 0, 0, 0, 1, 0.5);
  bad.Add(0.1, 0, 0, 0, 0, 1, 0.5);
  bad.Add(0.1, 0, 0, 0, 0, 1, 0.5); // a ghost
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int i = 0; i < 10; ++i)
  {
    ghosts->InsertNextValue(i == 9 ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  bad.Data->GetPointData()->AddArray(ghosts);
  grouping->SetInputData(bad.Data);
  vtkIntArray* groups = Groups(grouping);
  const int expected[] = { 0, -1, -1, -1, -1, -1, -1, 0, 1, -1 };
  for (int i = 0; i < 10; ++i)
  {
    Expect(i == 7 ? groups->GetValue(i) >= 0 : groups->GetValue(i) == expected[i], "bad splat " + std::to_string(i));
  }
  Expect(grouping->GetNumberOfSkippedPoints() == 7 && observer->GetWarning(), "skipped and reported");
  observer->Clear();

  // No radii and no normals: estimated.
  Cloud sphere;
  Sample(sphere, 0, 1000, 1.0, 3);
  sphere.Data->GetPointData()->Initialize();
  grouping->SetInputData(sphere.Data);
  grouping->Update();
  Expect(grouping->GetNumberOfGroups() > 3 &&
      grouping->GetOutput()->GetPointData()->GetArray("SplatRadius"),
    "estimated sizes");

  // A heap of splats that all overlap is refused, and soon.
  Cloud heap;
  for (int i = 0; i < 20000; ++i)
  {
    heap.Add(0, 0, 0, 0, 0, 1, 1);
  }
  grouping->SetInputData(heap.Data);
  groups = Groups(grouping);
  Expect(observer->GetError() && grouping->GetNumberOfGroups() == 0 && groups->GetValue(5) == -1,
    "a heap is refused");
  observer->Clear();

  // Of a few splats only the coverage is, and the groups are given.
  Cloud few;
  for (int i = 0; i < 1000; ++i)
  {
    few.Add(0.001 * i, 0, 0, 0, 0, 1, 1);
  }
  grouping->SetInputData(few.Data);
  grouping->SetCoverageToEnlarge();
  groups = Groups(grouping);
  Expect(observer->GetError() && grouping->GetNumberOfGroups() == 1000 && groups->GetValue(5) >= 0,
    "coverage of a heap is refused");
  observer->Clear();

  // Radii of fewer tuples than there are points are not used, nor written to.
  vtkNew<vtkFloatArray> brief;
  brief->SetName("SplatRadius");
  brief->SetNumberOfTuples(3);
  brief->Fill(0.1);
  sphere.Data->GetPointData()->AddArray(brief);
  grouping->SetInputData(sphere.Data);
  grouping->Update();
  vtkDataArray* used = grouping->GetOutput()->GetPointData()->GetArray("SplatRadius");
  Expect(used && used->GetNumberOfTuples() == 1000 && grouping->GetNumberOfGroups() > 3,
    "too few radii");
}
}

int TestSplatGrouping(int, char*[])
{
  TestIndependence();
  TestRelaxations();
  TestDeterminism();
  TestWeighted();
  TestCoverage();
  TestEllipses();
  TestBadInput();
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
