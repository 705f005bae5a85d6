// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The multiresolution octree: each point once in any cut, what stands for what covers it, sheets and
// gaps stay apart, the same whatever threads do.
#include "Expect.h"

#include "vtkCallbackCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatOctree.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;

struct Cloud
{
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> Radii;
  vtkNew<vtkMinimalStandardRandomSequence> Sequence;

  Cloud()
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Radii->SetName("SplatRadius");
    this->Data->SetPoints(this->Points);
    this->Data->GetPointData()->SetNormals(this->Normals);
    this->Data->GetPointData()->AddArray(this->Radii);
    this->Sequence->SetSeed(7);
  }
  double Random(double low, double high)
  {
    this->Sequence->Next();
    return this->Sequence->GetRangeValue(low, high);
  }
  void Add(const double p[3], const double n[3], double r)
  {
    this->Points->InsertNextPoint(p);
    this->Normals->InsertNextTuple(n);
    this->Radii->InsertNextValue(static_cast<float>(r));
  }
  /// A ball of radius 1 about a place far from the origin.
  void AddBall(int count)
  {
    const double r = 1.5 * std::sqrt(4.0 * Pi / count);
    for (int i = 0; i < count; ++i)
    {
      const double z = this->Random(-1.0, 1.0);
      const double a = this->Random(0.0, 2.0 * Pi);
      const double s = std::sqrt(1.0 - z * z);
      const double n[3] = { s * std::cos(a), s * std::sin(a), z };
      const double p[3] = { 5000.0 + n[0], -3000.0 + n[1], n[2] };
      this->Add(p, n, r);
    }
  }
  /// Squares of 1 x 1 at two heights, that face opposite ways.
  void AddSheets(int count, double distance)
  {
    const double r = 1.5 / std::sqrt(0.5 * count);
    for (int i = 0; i < count; ++i)
    {
      const double side = i % 2 ? 1.0 : -1.0;
      const double p[3] = { this->Random(0.0, 1.0), this->Random(0.0, 1.0),
        0.5 * side * distance };
      const double n[3] = { 0.0, 0.0, side };
      this->Add(p, n, r);
    }
  }
};

struct Result
{
  vtkNew<vtkPointSplatOctree> Octree;
  vtkPolyData* Points = nullptr;
  vtkPolyData* Levels = nullptr;

  explicit Result(vtkPolyData* data)
  {
    this->Octree->SetInputData(data);
    this->Octree->Update();
    this->Points = this->Octree->GetOutput(0);
    this->Levels = this->Octree->GetOutput(1);
  }
  vtkDataArray* Of(const char* name) { return this->Levels->GetPointData()->GetArray(name); }
  vtkDataArray* OfBlocks(const char* name) { return this->Levels->GetFieldData()->GetArray(name); }
  /// Where a level begins in the outputs.
  vtkIdType Start(int level)
  {
    vtkIdType start = 0;
    for (vtkIdType i = 0; level > 0 && i < this->Levels->GetNumberOfPoints(); ++i)
    {
      start += this->Of("SplatLevel")->GetComponent(i, 0) < level;
    }
    return start;
  }
  vtkPolyData* At(int level) { return level == 0 ? this->Points : this->Levels; }
};

double Distance(const double a[3], const double b[3])
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
}

void TestPoints(Cloud& cloud, Result& r)
{
  const vtkIdType count = cloud.Points->GetNumberOfPoints();
  Expect(r.Points->GetNumberOfPoints() == count, "all points are in output 0");
  std::vector<int> seen(static_cast<size_t>(count), 0);
  vtkDataArray* ids = r.Points->GetPointData()->GetArray("vtkOriginalPointIds");
  bool same = ids != nullptr;
  for (vtkIdType i = 0; same && i < count; ++i)
  {
    const vtkIdType id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
    ++seen[static_cast<size_t>(id)];
    same = Distance(r.Points->GetPoint(i), cloud.Points->GetPoint(id)) == 0.0;
    for (const char* name : { "Normals", "SplatRadius", "SplatClip", "SplatGroup", "Colours" })
    {
      vtkDataArray* was = cloud.Data->GetPointData()->GetArray(name);
      vtkDataArray* is = r.Points->GetPointData()->GetArray(name);
      for (int k = 0; k < was->GetNumberOfComponents(); ++k)
      {
        same = same && is->GetDataType() == was->GetDataType() &&
          is->GetComponent(i, k) == was->GetComponent(id, k);
      }
    }
  }
  Expect(same, "points keep their coordinates and arrays");
  Expect(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }), "each point is once");
  Expect(!r.Of("SplatGroup"), "groups have no means");
  Expect(r.Of("SplatClip") && r.Of("SplatClip")->GetNumberOfComponents() == 6, "lines have levels");
}

/// Splats stand for consecutive ones, all of the level below, and cover these.
void TestCovering(Result& r, int levels)
{
  for (int level = 1; level < levels; ++level)
  {
    const vtkIdType begin = r.Start(level);
    const vtkIdType end =
      level + 1 < levels ? r.Start(level + 1) : r.Levels->GetNumberOfPoints();
    const vtkIdType below = r.Start(level - 1);
    const vtkIdType all = level == 1 ? r.Points->GetNumberOfPoints() : begin - below;
    vtkPolyData* from = r.At(level - 1);
    vtkIdType next = 0;
    bool covered = true;
    bool ordered = true;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType first = static_cast<vtkIdType>(r.Of("SplatFirstChild")->GetComponent(i, 0));
      const vtkIdType count = static_cast<vtkIdType>(r.Of("SplatChildCount")->GetComponent(i, 0));
      ordered = ordered && first == next && count > 0;
      next = first + count;
      for (vtkIdType c = first; c < next; ++c)
      {
        const vtkIdType at = level == 1 ? c : below + c;
        covered = covered &&
          Distance(r.Levels->GetPoint(i), from->GetPoint(at)) +
              from->GetPointData()->GetArray("SplatRadius")->GetComponent(at, 0) <=
            1.0001 * r.Of("SplatRadius")->GetComponent(i, 0) + 1e-6;
      }
    }
    Expect(ordered && next == all, "level " + std::to_string(level) + " stands for all below");
    Expect(covered, "level " + std::to_string(level) + " covers those below");
    AtMost(static_cast<double>(end - begin), 0.4 * static_cast<double>(all),
      "splats of level " + std::to_string(level));
  }
}

void TestBlocks(Result& r, int levels)
{
  vtkDataArray* ranges = r.OfBlocks("SplatBlockRange");
  vtkDataArray* children = r.OfBlocks("SplatBlockChildren");
  vtkDataArray* bounds = r.OfBlocks("SplatBlockBounds");
  vtkDataArray* cones = r.OfBlocks("SplatBlockCone");
  vtkDataArray* sizes = r.OfBlocks("SplatBlockSize");
  double origin[3];
  r.OfBlocks("SplatBlockOrigin")->GetTuple(0, origin);
  std::vector<int> seen(static_cast<size_t>(r.Points->GetNumberOfPoints()), 0);
  bool inside = true;
  bool parted = true;
  for (vtkIdType b = 0; b < ranges->GetNumberOfTuples(); ++b)
  {
    const int level = static_cast<int>(ranges->GetComponent(b, 0));
    const vtkIdType first = static_cast<vtkIdType>(ranges->GetComponent(b, 1));
    const vtkIdType count = static_cast<vtkIdType>(ranges->GetComponent(b, 2));
    parted = parted && count > 0 && count <= 160;
    const vtkIdType start = r.Start(level);
    const double* axis = cones->GetTuple(b);
    double half[4];
    std::copy_n(axis, 4, half);
    for (vtkIdType i = first; i < first + count; ++i)
    {
      seen[static_cast<size_t>(i)] += level == 0;
      vtkPolyData* from = r.At(level);
      double p[3], n[3];
      from->GetPoint(start + i, p);
      from->GetPointData()->GetNormals()->GetTuple(start + i, n);
      for (int k = 0; k < 3; ++k)
      {
        inside = inside && p[k] - origin[k] >= bounds->GetComponent(b, 2 * k) - 1e-5 &&
          p[k] - origin[k] <= bounds->GetComponent(b, 2 * k + 1) + 1e-5;
      }
      inside = inside && vtkMath::Dot(half, n) >= std::cos(half[3]) - 1e-5 &&
        from->GetPointData()->GetArray("SplatRadius")->GetComponent(start + i, 0) <=
          sizes->GetComponent(b, 0) + 1e-6;
    }
    // Those below have the same splats, one after the other.
    if (level > 0)
    {
      vtkIdType next = static_cast<vtkIdType>(
        r.Of("SplatFirstChild")->GetComponent(start + first, 0));
      const vtkIdType child = static_cast<vtkIdType>(children->GetComponent(b, 0));
      for (vtkIdType c = child; c < child + children->GetComponent(b, 1); ++c)
      {
        parted = parted && ranges->GetComponent(c, 0) == level - 1 &&
          ranges->GetComponent(c, 1) == next;
        next += static_cast<vtkIdType>(ranges->GetComponent(c, 2));
      }
      const vtkIdType last = start + first + count - 1;
      parted = parted &&
        next ==
          r.Of("SplatFirstChild")->GetComponent(last, 0) +
            r.Of("SplatChildCount")->GetComponent(last, 0);
    }
  }
  Expect(parted, "blocks part those above");
  Expect(inside, "blocks bound their splats");
  Expect(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }),
    "each point is in one block");
  Expect(ranges->GetComponent(0, 0) == levels - 1, "the coarsest blocks come first");
}

void TestBall()
{
  constexpr int count = 30000;
  Cloud cloud;
  cloud.AddBall(count);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colours");
  colours->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> lines;
  lines->SetName("SplatClip");
  lines->SetNumberOfComponents(6);
  vtkNew<vtkIntArray> groups;
  groups->SetName("SplatGroup");
  for (int i = 0; i < count; ++i)
  {
    const double* n = cloud.Normals->GetTuple3(i);
    colours->InsertNextTuple3(100 + 100 * n[0], 100 + 100 * n[1], 100 + 100 * n[2]);
    lines->InsertNextTuple6(i, 0, 0, 0, 0, 0);
    groups->InsertNextValue(i % 5);
  }
  cloud.Data->GetPointData()->SetScalars(colours);
  cloud.Data->GetPointData()->AddArray(lines);
  cloud.Data->GetPointData()->AddArray(groups);
  Result r(cloud.Data);
  const int levels = r.Octree->GetNumberOfLevels();
  Expect(levels >= 4, "a ball has levels");
  TestPoints(cloud, r);
  TestCovering(r, levels);
  TestBlocks(r, levels);

  // Apexes lie on the ball, and normals, curvature and colours are the ball's.
  double off = 0.0;
  double turned = 0.0;
  double bend = 0.0;
  double colour = 0.0;
  const vtkIdType begin = r.Start(2);
  const vtkIdType end = r.Start(4);
  for (vtkIdType i = begin; i < end; ++i)
  {
    double p[3], n[3];
    r.Levels->GetPoint(i, p);
    r.Levels->GetPointData()->GetNormals()->GetTuple(i, n);
    double q[3] = { p[0] - 5000.0, p[1] + 3000.0, p[2] };
    off = std::max(off, std::abs(vtkMath::Normalize(q) - 1.0));
    turned = std::max(turned, 1.0 - vtkMath::Dot(q, n));
    const double* k = r.Of("SplatCurvature")->GetTuple(i);
    bend += std::abs(k[0] + k[1] + k[2] - 2.0) / static_cast<double>(end - begin);
    for (int c = 0; c < 3; ++c)
    {
      colour = std::max(colour, std::abs(r.Of("Colours")->GetComponent(i, c) - 100 - 100 * q[c]));
    }
  }
  AtMost(off, 1e-3, "apexes off the ball"); // their disks sag by 5e-3
  AtMost(turned, 1e-4, "normals turned");
  AtMost(bend, 0.05, "mean error of the curvature, of 2");
  AtMost(colour, 4.0, "colours, of 255");
}

void TestSheets()
{
  Cloud cloud;
  cloud.AddSheets(20000, 0.004);
  Result r(cloud.Data);
  Expect(r.Octree->GetNumberOfLevels() >= 4, "two sheets have levels");
  int mixed = 0;
  for (vtkIdType i = 0; i < r.Levels->GetNumberOfPoints(); ++i)
  {
    const double z = r.Levels->GetPoint(i)[2];
    const double n = r.Levels->GetPointData()->GetNormals()->GetComponent(i, 2);
    mixed += std::abs(std::abs(z) - 0.002) > 1e-6 || z * n < 0.0;
  }
  AtMost(mixed, 0, "splats between the sheets");

  // Islands that no disk connects: none of the lower levels bridges the gap.
  Cloud islands;
  const double up[3] = { 0.0, 0.0, 1.0 };
  for (int i = 0; i < 8000; ++i)
  {
    const double p[3] = { islands.Random(0.0, 1.0) + 30.0 * (i % 3), islands.Random(0.0, 1.0),
      0.0 };
    islands.Add(p, up, 1.5 / std::sqrt(8000.0 / 3.0));
  }
  Result far(islands.Data);
  double largest = 0.0;
  for (vtkIdType i = 0; i < far.Start(3); ++i)
  {
    largest = std::max(largest, far.Of("SplatRadius")->GetComponent(i, 0));
  }
  AtMost(largest, 0.5, "radii beside gaps of 29");
}

void TestEllipses()
{
  Cloud cloud;
  const double up[3] = { 0.0, 0.0, 1.0 };
  for (int i = 0; i < 4000; ++i)
  {
    const double p[3] = { cloud.Random(0.0, 4.0), cloud.Random(0.0, 1.0), 0.0 };
    cloud.Add(p, up, 0.0);
  }
  vtkNew<vtkFloatArray> axes[2];
  for (int k = 0; k < 2; ++k)
  {
    axes[k]->SetName(k ? "SplatAxis2" : "SplatAxis1");
    axes[k]->SetNumberOfComponents(3);
    for (int i = 0; i < 4000; ++i)
    {
      axes[k]->InsertNextTuple3(k ? 0.0 : 0.05, k ? 0.04 : 0.0, 0.0);
    }
    cloud.Data->GetPointData()->AddArray(axes[k]);
  }
  cloud.Data->GetPointData()->RemoveArray("SplatRadius");
  Result r(cloud.Data);
  bool good = r.Octree->GetNumberOfLevels() > 2 && r.Of("SplatAxis1") && !r.Of("SplatRadius");
  for (vtkIdType i = 0; good && i < r.Levels->GetNumberOfPoints(); ++i)
  {
    double a[3], b[3];
    r.Of("SplatAxis1")->GetTuple(i, a);
    r.Of("SplatAxis2")->GetTuple(i, b);
    const double ratio = vtkMath::Norm(b) / vtkMath::Norm(a);
    good = std::abs(vtkMath::Dot(a, b)) < 1e-6 && std::abs(a[2]) + std::abs(b[2]) < 1e-6 &&
      ratio <= 1.0001 && ratio >= 0.2499;
  }
  Expect(good, "ellipses have axes in their plane");
}

/// All that an output holds, as one list of numbers.
std::vector<double> Numbers(vtkPolyData* data)
{
  std::vector<double> all;
  auto add = [&all](vtkDataArray* array) {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        all.push_back(array->GetComponent(i, k));
      }
    }
  };
  add(data->GetPoints()->GetData());
  for (int a = 0; a < data->GetPointData()->GetNumberOfArrays(); ++a)
  {
    add(data->GetPointData()->GetArray(a));
  }
  for (int a = 0; a < data->GetFieldData()->GetNumberOfArrays(); ++a)
  {
    add(data->GetFieldData()->GetArray(a));
  }
  return all;
}

/// Of squares whose splats end at their edges, those of all levels do, and show all of the squares.
void TestEdges(bool folded)
{
  Cloud cloud;
  cloud.AddSheets(40000, 1.0);
  vtkNew<vtkDoubleArray> lines;
  lines->SetName("SplatClip");
  lines->SetNumberOfComponents(6);
  for (vtkIdType i = 0; i < cloud.Points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    cloud.Points->GetPoint(i, p);
    double c[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    for (int k = 0; k < 2; ++k)
    {
      const double side = p[k] < 0.5 ? -1.0 : 1.0;
      const double distance = side < 0.0 ? p[k] : 1.0 - p[k];
      if (distance < 2.0 * cloud.Radii->GetValue(i))
      {
        c[4 * k] = side / std::max(distance, 1e-9);
      }
    }
    lines->InsertNextTuple(c);
  }
  cloud.Data->GetPointData()->AddArray(lines);
  vtkNew<vtkFloatArray> folds;
  folds->SetName("SplatFold");
  folds->SetNumberOfComponents(6);
  folds->SetNumberOfTuples(folded ? cloud.Points->GetNumberOfPoints() : 0);
  folds->Fill(0.0);
  vtkNew<vtkFloatArray> planes;
  planes->DeepCopy(cloud.Normals);
  planes->SetName("SplatPlaneNormal");
  if (folded)
  {
    cloud.Data->GetPointData()->AddArray(folds);
    cloud.Data->GetPointData()->AddArray(planes);
  }
  Result r(cloud.Data);
  Expect(r.Octree->GetNumberOfLevels() > 3, "squares have levels");
  Expect((r.Of("SplatFold") != nullptr) == folded && (r.Of("SplatPlaneNormal") != nullptr) == folded,
    "levels have what points have");
  int beyond = 0;
  int lost = 0;
  for (vtkIdType i = 0; i < r.Levels->GetNumberOfPoints(); ++i)
  {
    const double* c = r.Of("SplatClip")->GetTuple(i);
    const double radius = r.Of("SplatRadius")->GetComponent(i, 0);
    double p[3];
    r.Levels->GetPoint(i, p);
    for (int s = 0; s < 64; ++s)
    {
      const double x[2] = { radius * (s % 8 - 3.5) / 4.0, radius * (s / 8 - 3.5) / 4.0 };
      const bool kept = std::max(c[0] * x[0] + c[1] * x[1], c[3] * x[0] + c[4] * x[1]) <= 1.0;
      const double off = std::max(std::abs(p[0] + x[0] - 0.5), std::abs(p[1] + x[1] - 0.5)) - 0.5;
      beyond += kept && off > 0.02 * radius ? 1 : 0;
      lost += !kept && off < -0.02 * radius ? 1 : 0;
    }
  }
  Expect(beyond == 0, "levels' splats end at edges: " + std::to_string(beyond));
  Expect(lost == 0, "and not before: " + std::to_string(lost));
}

void TestThreads()
{
  Cloud cloud;
  cloud.AddBall(20000);
  std::vector<double> results[2];
  for (int k = 0; k < 2; ++k)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ k ? 4 : 1 }, [&] {
      Result r(cloud.Data);
      results[k] = Numbers(r.Points);
      const std::vector<double> levels = Numbers(r.Levels);
      results[k].insert(results[k].end(), levels.begin(), levels.end());
    });
  }
  Expect(!results[0].empty() && results[0] == results[1], "threads change nothing");
}

void TestBadInput()
{
  vtkNew<vtkTest::ErrorObserver> observer;
  Cloud cloud;
  cloud.AddBall(3000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(3000);
  ghosts->FillValue(0);
  ghosts->SetValue(5, vtkDataSetAttributes::DUPLICATEPOINT);
  ghosts->SetValue(6, vtkDataSetAttributes::HIDDENPOINT);
  cloud.Data->GetPointData()->AddArray(ghosts);
  cloud.Points->SetPoint(0, nan, 0, 0);
  cloud.Normals->SetTuple3(1, 0, 0, 0);
  cloud.Normals->SetTuple3(2, nan, 0, 0);
  cloud.Radii->SetValue(3, -1.0f);
  cloud.Radii->SetValue(4, std::numeric_limits<float>::infinity());
  vtkNew<vtkPointSplatOctree> octree;
  octree->AddObserver(vtkCommand::WarningEvent, observer);
  octree->SetInputData(cloud.Data);
  octree->Update();
  Expect(octree->GetNumberOfSkippedPoints() == 7, "bad points and ghosts are counted");
  Expect(observer->GetWarning(), "and warned of");
  Expect(octree->GetOutput(0)->GetNumberOfPoints() == 2993, "the others are there");

  // Points in a volume, whose normals say nothing.
  Cloud noise;
  for (int i = 0; i < 5000; ++i)
  {
    const double p[3] = { noise.Random(0, 1), noise.Random(0, 1), noise.Random(0, 1) };
    double n[3] = { noise.Random(-1, 1), noise.Random(-1, 1), noise.Random(-1, 1) };
    vtkMath::Normalize(n);
    noise.Add(p, n, 0.01);
  }
  Result r(noise.Data);
  Expect(r.Octree->GetNumberOfLevels() == 1 && r.Levels->GetNumberOfPoints() == 0,
    "noise has no levels");
  Expect(r.Points->GetNumberOfPoints() == 5000, "but its points");

  // All in one place; and none.
  Cloud heap;
  const double p[3] = { 1.0, 2.0, 3.0 };
  const double n[3] = { 0.0, 0.0, 1.0 };
  for (int i = 0; i < 5000; ++i)
  {
    heap.Add(p, n, 0.01);
  }
  Result one(heap.Data);
  Expect(one.Points->GetNumberOfPoints() == 5000, "points in one place");
  Cloud none;
  Result nothing(none.Data);
  Expect(nothing.Points->GetNumberOfPoints() == 0, "no points");

  // Aborted in the middle.
  Cloud ball;
  ball.AddBall(20000);
  vtkNew<vtkPointSplatOctree> aborted;
  aborted->SetInputData(ball.Data);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    auto* self = static_cast<vtkPointSplatOctree*>(caller);
    if (self->GetProgress() > 0.3)
    {
      self->AbortExecuteOn();
    }
  });
  aborted->AddObserver(vtkCommand::ProgressEvent, stop);
  aborted->Update();
  Expect(aborted->GetOutput(0)->GetNumberOfPoints() == 0, "aborted filters have no output");
}
}

int TestSplatOctree(int, char*[])
{
  TestBall();
  TestSheets();
  TestEllipses();
  TestEdges(false);
  TestEdges(true);
  TestThreads();
  TestBadInput();
  return failures;
}
