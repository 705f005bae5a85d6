// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatProjection.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSplatAround.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatNeighbors.h"
#include "vtkPointSplatNoise.h"
#include "vtkPointSplatNormals.h"
#include "vtkPointSplatRobustSurface.h"
#include "vtkPointSplatSheet.h"
#include "vtkPointSplatSensors.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatProjection);

namespace
{
/// The most that noise widens the kernel: what is twice as wide takes four times as long.
constexpr float LargestWidening = 3;
/// Where a cloud is sparser than usual by more than this there is no surface, but strays among
/// strays: a hundredth of the usual density, with the usual OutlierFactor.
constexpr float Sparsest = 2.5f;
/// The nearest neighbours, by whose mean distance support is measured.
constexpr int SupportNeighbors = 8;
/// Neighbours nearer than this, as a share of the farthest, tell of noise and not of curvature.
constexpr float LeastCurvatureReach = 0.25f;
/// The median of the absolute values of what is normally distributed, to its standard deviation.
constexpr float DeviationPerMedian = 1.4826f;

using Slot = vtkPointSplatNeighbors::Slot;
using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

/// The value that a share of `values` is below; their order changes.
float Quantile(float* values, std::size_t count, double share)
{
  float* at = values + static_cast<std::size_t>(share * (count - 1));
  std::nth_element(values, at, values + count);
  return *at;
}

struct MoveWorker
{
  template <typename Array>
  void operator()(
    Array* points, const std::vector<Slot>& slots, const std::vector<float>& moves) const
  {
    auto range = vtk::DataArrayTupleRange<3>(points);
    using Value = vtk::GetAPIType<Array>;
    vtkPointSplatThreads::For(0, range.size(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        if (slots[id] == vtkPointSplatNeighbors::None)
        {
          continue;
        }
        auto x = range[id];
        for (int c = 0; c < 3; ++c)
        {
          x[c] = static_cast<Value>(
            static_cast<double>(x[c]) + moves[std::size_t(3) * slots[id] + c]);
        }
      }
    });
  }
};
}

/// What one update finds, a tuple a slot.
struct vtkPointSplatProjection::Run
{
  Run(vtkPointSplatProjection* self, vtkPointSet* input)
    : Self(self)
    , Input(input)
  {
  }

  /// Reads the input, and sorts its points; normals are those of the array, or null.
  bool Begin(vtkDataArray* given);
  bool FindNeighbors();
  bool MendNormals();
  bool Project();
  bool ProjectNoise();
  bool Describe();
  void Write(vtkPolyData* output, const char* normalsName);

private:
  /// Calls visit(neighborhood) for each slot, in parallel; false if aborted.
  template <typename Visitor>
  bool Visit(double from, double to, const Visitor& visit);
  vtkPointSplatRobustSurface MakeSurface() const
  {
    return vtkPointSplatRobustSurface(static_cast<float>(this->Self->NormalBandwidth),
      static_cast<float>(this->Self->ResidualBandwidth));
  }
  void Store(Slot s, const vtkPointSplatRobustSurface& surface)
  {
    std::copy_n(surface.Offset, 3, this->Moves.data() + std::size_t(3) * s);
    std::copy_n(surface.Normal, 3, this->Projected.data() + std::size_t(3) * s);
  }
  void Collect(
    Slot leaf, float distance, std::vector<Slot>& found, std::vector<float>& offsets) const;
  void ProjectWidely(
    Slot slot, const std::vector<Slot>& candidates, const std::vector<float>& offsets);
  bool IsOutlier(const Neighborhood& around) const;

  vtkPointSplatProjection* Self;
  vtkPointSet* Input;
  vtkPointSplatNeighbors Neighbors;
  std::vector<float> PointNormals; // 3 a point, as given
  std::vector<float> Normals;      // 3, before
  std::vector<Slot> Lists;         // the nearest NumberOfNeighbors, then None
  std::vector<float> Moves;        // 3
  std::vector<float> Projected;    // 3, normals of the surface
  std::vector<float> Curvatures;   // 6
  std::vector<float> Reach;        // to the nearest SupportNeighbors, their mean
  float UsualReach = 0;            // of all
  std::vector<float> Spacing;
  std::vector<float> WideSupport; // where there is noise, else 0
  std::vector<unsigned char> Strays; // whether a slot is an outlier
};

bool vtkPointSplatProjection::Run::Begin(vtkDataArray* given)
{
  const vtkIdType points = this->Input->GetNumberOfPoints();
  this->PointNormals.assign(std::size_t(3) * points, 0.0f);
  if (given)
  {
    vtkPointSplatInput::ReadNormals(given, this->PointNormals.data());
  }
  std::vector<unsigned char> used;
  const vtkPointSplatInput::LeftOut left = vtkPointSplatInput::MarkUsable(this->Input, used);
  if (left.NotFinite > 0 || left.Hidden > 0)
  {
    vtkWarningWithObjectMacro(this->Self,
      "Of " << points << " points " << left.NotFinite
            << " have coordinates that are not finite and " << left.Hidden << " are hidden ("
            << vtkDataSetAttributes::GhostArrayName() << "); they take no part and stay where they are.");
  }
  this->Neighbors.Build(this->Input->GetPoints()->GetData(), used.data());
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Normals.assign(std::size_t(3) * slots, 0.0f);
  std::vector<unsigned char> known(slots, 0);
  bool missing = false;
  for (Slot s = 0; s < slots; ++s)
  {
    const vtkIdType id = this->Neighbors.GetId(s);
    if (id >= 0)
    {
      const float* n = this->PointNormals.data() + 3 * id;
      std::copy(n, n + 3, this->Normals.data() + std::size_t(3) * s);
      known[s] = n[0] != 0 || n[1] != 0 || n[2] != 0;
      missing = missing || !known[s];
    }
  }
  if (!missing)
  {
    return true;
  }
  vtkPointSplatNormals fitted(this->Neighbors, this->Normals.data(), known);
  // Noise has no second order; stages 2 and 3 take what is wrong with planes away.
  const int k = this->Self->NumberOfNeighbors;
  if (!fitted.Fit(this->Self, 0.1, 0.3, { k, k, fitted.GetTimes(this->Self, k) == 1 }, true))
  {
    return false;
  }
  std::string error;
  const vtkPointSplatSensors sensors(this->Input, error);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(this->Self, << error);
  }
  if (sensors.IsEmpty())
  {
    fitted.OrientConsistently();
  }
  else
  {
    fitted.OrientToSensors(sensors);
  }
  return true;
}

bool vtkPointSplatProjection::Run::FindNeighbors()
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  const int k = this->Self->NumberOfNeighbors;
  this->Lists.assign(std::size_t(k) * slots, vtkPointSplatNeighbors::None);
  this->Reach.assign(slots, 0.0f);
  auto find = [&](const Neighborhood& around, int) {
    const Slot s = around.Center;
    std::copy_n(around.Slots, around.Count, this->Lists.data() + std::size_t(k) * s);
    const int nearest = std::min(around.Count, +SupportNeighbors);
    float sum = 0;
    for (int i = 0; i < nearest; ++i)
    {
      sum += std::sqrt(around.SquaredDistance[i]);
    }
    this->Reach[s] = nearest > 0 ? sum / nearest : 0;
    return true;
  };
  return this->Neighbors.Visit(this->Self, 0.3, 0.5, k, find);
}

template <typename Visitor>
bool vtkPointSplatProjection::Run::Visit(double from, double to, const Visitor& visit)
{
  const int k = this->Self->NumberOfNeighbors;
  auto all = [&](vtkIdType begin, vtkIdType end) {
    vtkPointSplatAround around;
    for (vtkIdType s = begin; s < end; ++s)
    {
      const Slot slot = static_cast<Slot>(s);
      if (this->Neighbors.GetId(slot) >= 0)
      {
        visit(around.Take(this->Neighbors, slot, this->Lists.data() + std::size_t(k) * s, k));
      }
    }
  };
  return vtkPointSplatBatches::For(
    this->Self, this->Neighbors.GetNumberOfSlots(), 1024, from, to, all);
}

/// What each point's normal is by its neighbours', before any moves.
bool vtkPointSplatProjection::Run::MendNormals()
{
  this->Projected = this->Normals;
  const bool mended = this->Visit(0.5, 0.55, [this](const Neighborhood& around) {
    vtkPointSplatRobustSurface surface = this->MakeSurface();
    surface.Gather(around, this->Normals.data());
    surface.FindNormal();
    std::copy_n(surface.Normal, 3, this->Projected.data() + std::size_t(3) * around.Center);
  });
  this->Normals.swap(this->Projected);
  return mended;
}

bool vtkPointSplatProjection::Run::Project()
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Moves.assign(std::size_t(3) * slots, 0.0f);
  this->Projected = this->Normals;
  this->Spacing.assign(slots, 0.0f);
  this->WideSupport.assign(slots, 0.0f);
  return this->Visit(0.55, 0.65, [this](const Neighborhood& around) {
    const Slot s = around.Center;
    vtkPointSplatRobustSurface surface = this->MakeSurface();
    surface.Gather(around, this->Normals.data());
    const bool found = surface.Project();
    this->Store(s, surface);
    this->Spacing[s] = surface.Spacing;
    if (!found || surface.Noise > vtkPointSplatNoise::Noisy)
    {
      const float wider = found ? surface.Noise / vtkPointSplatNoise::Noisy + 1 : LargestWidening;
      this->WideSupport[s] = std::min(wider, LargestWidening) * surface.Support;
    }
  });
}

/**
 * Where there is noise, again with all points in the wider supports. A leaf of the search tree
 * collects the points about it once for all of its own.
 */
bool vtkPointSplatProjection::Run::ProjectNoise()
{
  constexpr int leafSize = vtkPointSplatNeighbors::LeafSize;
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  vtkSMPThreadLocal<std::vector<Slot>> candidates;
  vtkSMPThreadLocal<std::vector<float>> positions;
  auto project = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType leaf = begin; leaf < end; ++leaf)
    {
      const Slot first = static_cast<Slot>(leaf * leafSize);
      const Slot last = std::min(first + leafSize, slots);
      const float widest = *std::max_element(
        this->WideSupport.begin() + first, this->WideSupport.begin() + last);
      if (!(widest > 0))
      {
        continue;
      }
      this->Collect(static_cast<Slot>(leaf), widest, candidates.Local(), positions.Local());
      for (Slot s = first; s < last; ++s)
      {
        if (this->WideSupport[s] > 0)
        {
          this->ProjectWidely(s, candidates.Local(), positions.Local());
        }
      }
    }
  };
  return vtkPointSplatBatches::For(
    this->Self, (slots + leafSize - 1) / leafSize, 64, 0.65, 0.9, project);
}

/// The slots within a distance of a leaf, and their offsets from its first point, 3 floats each.
void vtkPointSplatProjection::Run::Collect(
  Slot leaf, float distance, std::vector<Slot>& found, std::vector<float>& offsets) const
{
  constexpr Slot leafSize = vtkPointSplatNeighbors::LeafSize;
  double origin[3];
  this->Neighbors.GetPosition(leaf * leafSize, origin);
  found.clear();
  offsets.clear();
  this->Neighbors.VisitLeaves(leaf, distance, [&](Slot other) {
    int count;
    this->Neighbors.GetDiagonal(other, count);
    for (Slot s = other * leafSize; s < other * leafSize + count; ++s)
    {
      double x[3];
      this->Neighbors.GetPosition(s, x);
      found.push_back(s);
      for (int c = 0; c < 3; ++c)
      {
        offsets.push_back(static_cast<float>(x[c] - origin[c]));
      }
    }
    return true;
  });
}

void vtkPointSplatProjection::Run::ProjectWidely(
  Slot slot, const std::vector<Slot>& candidates, const std::vector<float>& offsets)
{
  const float support = this->WideSupport[slot];
  const std::size_t own =
    std::find(candidates.begin(), candidates.end(), slot) - candidates.begin();
  const float* centre = offsets.data() + 3 * own;
  auto getOffset = [&](std::size_t i, float offset[3]) {
    float squared = 0;
    for (int c = 0; c < 3; ++c)
    {
      offset[c] = offsets[3 * i + c] - centre[c];
      squared += offset[c] * offset[c];
    }
    return squared < support * support;
  };
  float offset[3];
  int inside = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    inside += getOffset(i, offset) ? 1 : 0;
  }
  // Where a much denser part is in reach, every so many of the points stand for all.
  constexpr int capacity = vtkPointSplatRobustSurface::MaximumNumberOfSamples;
  const int stride = (inside + capacity - 1) / capacity;
  vtkPointSplatRobustSurface surface = this->MakeSurface();
  surface.Begin(support, this->Spacing[slot], this->Projected.data() + std::size_t(3) * slot);
  int at = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (getOffset(i, offset) && at++ % stride == 0)
    {
      surface.Add(offset, this->Normals.data() + std::size_t(3) * candidates[i]);
    }
  }
  if (surface.Project())
  {
    this->Store(slot, surface);
  }
}

bool vtkPointSplatProjection::Run::IsOutlier(const Neighborhood& around) const
{
  const Slot s = around.Center;
  if (around.Count < SupportNeighbors)
  {
    // Of clouds so small nothing can be told.
    return false;
  }
  const float factor = static_cast<float>(this->Self->OutlierFactor);
  std::array<float, vtkPointSplatNeighbors::MaximumNumberOfNeighbors> values;
  for (int i = 0; i < around.Count; ++i)
  {
    values[i] = this->Reach[around.Slots[i]];
  }
  if (this->Reach[s] >
    factor * std::min(Quantile(values.data(), around.Count, 0.75), Sparsest * this->UsualReach))
  {
    return true;
  }
  for (int i = 0; i < around.Count; ++i)
  {
    values[i] = vtkMath::Norm(this->Moves.data() + std::size_t(3) * around.Slots[i]);
  }
  const float deviation = DeviationPerMedian * Quantile(values.data(), around.Count, 0.5);
  return vtkMath::Norm(this->Moves.data() + std::size_t(3) * s) >
    std::max(factor * deviation, this->Spacing[s]);
}

bool vtkPointSplatProjection::Run::Describe()
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Curvatures.assign(std::size_t(6) * slots, 0.0f);
  this->Strays.assign(slots, 0);
  std::vector<float> reaches = this->Reach;
  reaches.erase(std::remove(reaches.begin(), reaches.end(), 0.0f), reaches.end());
  this->UsualReach = reaches.empty() ? 0 : Quantile(reaches.data(), reaches.size(), 0.5);
  return this->Visit(0.9, 0.95, [this](const Neighborhood& around) {
    const Slot s = around.Center;
    this->Strays[s] = this->Self->Outliers != Keep && this->IsOutlier(around);
    constexpr int capacity = vtkPointSplatNeighbors::MaximumNumberOfNeighbors;
    std::array<float, capacity> x, y, z, squared;
    std::array<Slot, capacity> slotsOf;
    const float* move = this->Moves.data() + std::size_t(3) * s;
    const float farthest = around.Count > 0 ? around.SquaredDistance[around.Count - 1] : 0;
    int count = 0;
    for (int i = 0; i < around.Count; ++i)
    {
      const float* other = this->Moves.data() + std::size_t(3) * around.Slots[i];
      x[count] = around.X[i] + other[0] - move[0];
      y[count] = around.Y[i] + other[1] - move[1];
      z[count] = around.Z[i] + other[2] - move[2];
      squared[count] = x[count] * x[count] + y[count] * y[count] + z[count] * z[count];
      slotsOf[count] = around.Slots[i];
      count += squared[count] >= LeastCurvatureReach * LeastCurvatureReach * farthest ? 1 : 0;
    }
    vtkPointSplatCurvature curvature;
    const Neighborhood moved{ s, count, slotsOf.data(), x.data(), y.data(), z.data(),
      squared.data() };
    const float spacing = vtkPointSplatSheet::GetSpacing(moved);
    vtkPointSplatSheet sheet;
    sheet.Compare(moved, this->Projected.data(), this->Projected.data() + std::size_t(3) * s);
    sheet.Select(moved, vtkPointSplatSheet::CountNear(moved, spacing), spacing);
    curvature.Estimate(
      moved, this->Projected.data(), this->Projected.data() + std::size_t(3) * s, sheet);
    std::copy_n(curvature.Tensor, 6, this->Curvatures.data() + std::size_t(6) * s);
  });
}

void vtkPointSplatProjection::Run::Write(vtkPolyData* output, const char* normalsName)
{
  const vtkIdType points = this->Input->GetNumberOfPoints();
  const std::vector<Slot>& slotOf = this->Neighbors.GetSlots();

  vtkNew<vtkPoints> moved;
  const int type = this->Input->GetPoints()->GetDataType();
  moved->SetDataType(type == VTK_FLOAT || type == VTK_DOUBLE ? type : VTK_DOUBLE);
  moved->GetData()->DeepCopy(this->Input->GetPoints()->GetData());
  vtkPointSplatInput::Dispatch<MoveWorker>(moved->GetData(), slotOf, this->Moves);

  vtkNew<vtkFloatArray> normals, curvatures, distances;
  normals->SetName(normalsName);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(points);
  curvatures->SetName(vtkPointSplatArrays::Curvature);
  curvatures->SetNumberOfComponents(6);
  curvatures->SetNumberOfTuples(points);
  distances->SetName(vtkPointSplatArrays::ProjectionDistance);
  distances->SetNumberOfTuples(points);
  vtkNew<vtkUnsignedCharArray> strays;
  strays->SetName(vtkPointSplatArrays::Outlier);
  strays->SetNumberOfTuples(points);
  vtkPointSplatThreads::For(0, points, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType id = begin; id < end; ++id)
    {
      const Slot s = slotOf[id];
      const bool taken = s != vtkPointSplatNeighbors::None;
      const float* n =
        taken ? this->Projected.data() + std::size_t(3) * s : this->PointNormals.data() + 3 * id;
      std::copy(n, n + 3, normals->GetPointer(3 * id));
      for (int c = 0; c < 6; ++c)
      {
        curvatures->SetValue(6 * id + c, taken ? this->Curvatures[std::size_t(6) * s + c] : 0);
      }
      distances->SetValue(
        id, taken ? vtkMath::Norm(this->Moves.data() + std::size_t(3) * s) : 0);
      strays->SetValue(id, taken ? this->Strays[s] : 0);
    }
  });

  vtkNew<vtkPolyData> all;
  all->SetPoints(moved);
  vtkPointData* data = all->GetPointData();
  data->PassData(this->Input->GetPointData());
  for (const char* name : { vtkPointSplatArrays::Radius, vtkPointSplatArrays::Axis1,
         vtkPointSplatArrays::Axis2, vtkPointSplatArrays::PlaneNormal,
         vtkPointSplatArrays::ProjectionDistance, vtkPointSplatArrays::Outlier })
  {
    data->RemoveArray(name);
  }
  data->SetNormals(normals);
  data->AddArray(curvatures);
  if (this->Self->ComputeDistance)
  {
    data->AddArray(distances);
  }
  if (this->Self->Outliers == Mark)
  {
    data->AddArray(strays);
  }

  const unsigned char* isStray = strays->GetPointer(0);
  this->Self->NumberOfOutliers = std::count(isStray, isStray + points, 1);
  output->GetFieldData()->PassData(this->Input->GetFieldData());
  if (this->Self->Outliers != Remove || this->Self->NumberOfOutliers == 0)
  {
    output->SetPoints(moved);
    output->GetPointData()->ShallowCopy(data);
    return;
  }
  vtkNew<vtkIdList> kept, places;
  kept->Allocate(points);
  places->Allocate(points);
  for (vtkIdType id = 0; id < points; ++id)
  {
    if (!isStray[id])
    {
      places->InsertNextId(kept->InsertNextId(id));
    }
  }
  vtkNew<vtkPoints> left;
  left->SetDataType(moved->GetDataType());
  left->SetNumberOfPoints(kept->GetNumberOfIds());
  moved->GetData()->GetTuples(kept, left->GetData());
  output->SetPoints(left);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(data, kept->GetNumberOfIds());
  output->GetPointData()->CopyData(data, kept, places);
}

vtkPointSplatProjection::vtkPointSplatProjection() = default;
vtkPointSplatProjection::~vtkPointSplatProjection() = default;

int vtkPointSplatProjection::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkPointSplatProjection::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->NumberOfOutliers = 0;
  if (input->GetNumberOfPoints() == 0)
  {
    output->GetPointData()->PassData(input->GetPointData());
    output->GetFieldData()->PassData(input->GetFieldData());
    return 1;
  }
  vtkDataArray* given = input->GetPointData()->GetNormals();
  if (given && given->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    vtkErrorMacro("The point normals " << (given->GetName() ? given->GetName() : "") << " have "
                                       << given->GetNumberOfTuples() << " tuples for "
                                       << input->GetNumberOfPoints()
                                       << " points; they are estimated instead.");
    given = nullptr;
  }
  Run run(this, input);
  if (!run.Begin(given) || !run.FindNeighbors() || !run.MendNormals() || !run.Project() ||
    !run.ProjectNoise() || !run.Describe())
  {
    return 1;
  }
  run.Write(output, given && given->GetName() ? given->GetName() : "Normals");
  this->UpdateProgress(1.0);
  return 1;
}

void vtkPointSplatProjection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "NormalBandwidth: " << this->NormalBandwidth << "\n";
  os << indent << "ResidualBandwidth: " << this->ResidualBandwidth << "\n";
  os << indent << "Outliers: "
     << (this->Outliers == Keep   ? "Keep"
            : this->Outliers == Mark ? "Mark"
                                     : "Remove")
     << "\n";
  os << indent << "OutlierFactor: " << this->OutlierFactor << "\n";
  os << indent << "ComputeDistance: " << (this->ComputeDistance ? "On" : "Off") << "\n";
  os << indent << "NumberOfOutliers: " << this->NumberOfOutliers << "\n";
}

VTK_ABI_NAMESPACE_END
