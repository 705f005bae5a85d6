// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatEstimation.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCreases.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatDisk.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatNeighbors.h"
#include "vtkPointSplatNoise.h"
#include "vtkPointSplatNormals.h"
#include "vtkPointSplatSensors.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatEstimation);

namespace
{
using Slot = vtkPointSplatNeighbors::Slot;

/// The radius of a point that has no neighbour to compare with.
constexpr float LoneRadius = 0.1f;
/// How much larger than its neighbours' disks one may be.
constexpr float LargestRatio = 2.5f;
/// Where samplings are as regular as meshes' (the 95th percentile of the disks' sizes, in
/// spacings, is below RegularSpread medians), a disk of more than HoleFactor such percentiles
/// reaches over a hole; where they are random (IrregularSpread medians), over a gap to be closed.
constexpr float RegularSpread = 1.25f;
constexpr float IrregularSpread = 1.45f;
constexpr float HoleFactor = 1.3f;
constexpr float GapFactor = 3.0f;
/// The neighbours, by rank, that bound a disk.
constexpr int NumberOfWitnesses = 4;
/// How far the normal may turn from the centre to the rim of a disk: the kernel's rim, a half
/// farther out, then stays within a tube's silhouette.
constexpr float LargestBend = 0.6f;
/// What is left of a disk at least, however much the surface bends: noise may look like it.
constexpr float LeastShare = 0.75f;
/// Points at the same position whose normals part by more than this cosine (15 degrees) are of two
/// faces.
constexpr float TwinCosine = 0.966f;
/// The radius of a body alone, of the distance to what is nearest.
constexpr float BodyRadius = 0.5f;
/// The sixth neighbour's distance, of the third one's, for points at random in a plane (1.43) and a
/// little: it is the neighbour of another body where most bodies have few points.
constexpr float SixthPerThird = 1.5f;
/// Of how many leaves of the search tree, at least, the usual spacing is found.
constexpr Slot UsualLeaves = 512;

bool IsZero(const float n[3])
{
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

/// The radius at which a disk bends as much as it may.
float GetLargest(float curvature, float radius)
{
  return curvature > 0 ? std::max(LargestBend / curvature, LeastShare * radius)
                       : std::numeric_limits<float>::max();
}

/// The second fundamental form of a ball.
void GetBall(const float n[3], float curvature, float tensor[6])
{
  static const int rows[6] = { 0, 1, 2, 0, 1, 0 };
  static const int columns[6] = { 0, 1, 2, 1, 2, 2 };
  for (int k = 0; k < 6; ++k)
  {
    tensor[k] = curvature * ((k < 3 ? 1.0f : 0.0f) - n[rows[k]] * n[columns[k]]);
  }
}

/// An element of some order; values are shuffled.
float GetQuantile(std::vector<float>& values, double q)
{
  auto at = values.begin() + static_cast<std::ptrdiff_t>(q * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The spacing of most points: the median of points all over the cloud.
float GetUsualSpacing(vtkAlgorithm* self, const vtkPointSplatNeighbors& neighbors)
{
  const Slot slots = neighbors.GetNumberOfSlots();
  const Slot leaves = (slots + vtkPointSplatNeighbors::LeafSize - 1) / vtkPointSplatNeighbors::LeafSize;
  const Slot stride = std::max<Slot>(1, leaves / UsualLeaves);
  std::vector<float> spacings(slots, 0.0f);
  neighbors.Visit(self, 0.05, 0.1, vtkPointSplatSheet::SpacingRank,
    [&](const vtkPointSplatNeighbors::Neighborhood& around, int) {
      const int third = std::min(3, around.Count) - 1;
      spacings[around.Center] = third < 0
        ? 0.0f
        : std::min(vtkPointSplatSheet::GetSpacing(around),
            SixthPerThird * std::sqrt(around.SquaredDistance[third]));
      return true;
    },
    [&](Slot s) { return s / vtkPointSplatNeighbors::LeafSize % stride == 0; });
  spacings.erase(std::remove(spacings.begin(), spacings.end(), 0.0f), spacings.end());
  return spacings.empty() ? 0.0f : GetQuantile(spacings, 0.5);
}

using Twins = std::vector<vtkPointSplatCreases::Twin>;

/// Points that share a slot with one whose normal is another; normals: of points, as given.
Twins FindTwins(const float* normals, const std::vector<float>& slotNormals,
  const vtkPointSplatNeighbors& neighbors)
{
  Twins twins;
  const std::vector<Slot>& slotOf = neighbors.GetSlots();
  for (std::size_t id = 0; id < slotOf.size(); ++id)
  {
    const Slot s = slotOf[id];
    const float* n = normals + 3 * id;
    if (s == vtkPointSplatNeighbors::None || neighbors.GetId(s) == static_cast<vtkIdType>(id) ||
      IsZero(n))
    {
      continue;
    }
    const float* m = slotNormals.data() + std::size_t(3) * s;
    if (std::abs(n[0] * m[0] + n[1] * m[1] + n[2] * m[2]) < TwinCosine)
    {
      twins.push_back({ static_cast<vtkIdType>(id), s, { n[0], n[1], n[2] } });
    }
  }
  return twins;
}

/// Disks as they are found, for each slot.
struct Disks
{
  explicit Disks(Slot slots, bool elliptical)
    : Length(slots, 0.0f)
    , Gap(slots, 0.0f)
    , Spacing(slots, 0.0f)
    , Nearest(slots, 0.0f)
    , Witnesses(std::size_t(NumberOfWitnesses) * slots, vtkPointSplatNeighbors::None)
    , Axes(elliptical ? std::size_t(6) * slots : 0)
    , Planes(elliptical ? 0 : std::size_t(3) * slots)
    , Curvatures(elliptical ? 0 : std::size_t(6) * slots, 0.0f)
  {
  }

  bool IsAlone(Slot slot) const { return !(this->Length[slot] > 0); }

  /**
   * The size of a gap, in spacings, past which it is a hole in the surface.
   */
  float GetHoleLimit() const
  {
    std::vector<float> sizes;
    sizes.reserve(this->Gap.size());
    for (std::size_t s = 0; s < this->Gap.size(); ++s)
    {
      if (this->Gap[s] > 0)
      {
        sizes.push_back(this->Gap[s] / this->Spacing[s]);
      }
    }
    if (sizes.size() < 100)
    {
      return std::numeric_limits<float>::max();
    }
    const float usual = GetQuantile(sizes, 0.5), large = GetQuantile(sizes, 0.95);
    const float t = std::clamp(
      (large / usual - RegularSpread) / (IrregularSpread - RegularSpread), 0.0f, 1.0f);
    return large * (HoleFactor + t * (GapFactor - HoleFactor));
  }

  /// Takes over what was found at creases.
  void Set(const vtkPointSplatCreases::Splat& splat)
  {
    const std::size_t s = splat.At;
    float largest = std::numeric_limits<float>::max();
    if (this->Axes.empty())
    {
      largest = GetLargest(splat.Strongest, splat.Length1);
      std::copy_n(splat.Normal, 3, this->Planes.data() + 3 * s);
      std::copy_n(splat.Tensor, 6, this->Curvatures.data() + 6 * s);
    }
    else
    {
      const float ratio = splat.Length1 > 0 ? splat.Length2 / splat.Length1 : 1.0f;
      for (int c = 0; c < 3; ++c)
      {
        this->Axes[6 * s + c] = splat.Axis1[c];
        this->Axes[6 * s + 3 + c] = ratio * splat.Axis2[c];
      }
    }
    this->Length[s] = std::min(splat.Length1, largest);
    this->Gap[s] = std::min(splat.Gap, largest);
    this->Spacing[s] = splat.Spacing;
  }

  /// Makes a disk as large as the gap that it is to close.
  void Close(Slot s)
  {
    if (this->Gap[s] <= this->HoleLimit * this->Spacing[s])
    {
      this->Length[s] = std::max(this->Length[s], this->Gap[s]);
    }
  }

  /// Makes disks as large as the gaps that they are to close, and gives points alone their bodies.
  void Finish()
  {
    this->HoleLimit = this->GetHoleLimit();
    std::vector<float> lengths;
    lengths.reserve(this->Length.size());
    for (std::size_t s = 0; s < this->Length.size(); ++s)
    {
      this->Close(static_cast<Slot>(s));
      if (this->Length[s] > 0)
      {
        lengths.push_back(this->Length[s]);
      }
    }
    this->Body = lengths.empty() ? std::numeric_limits<float>::max() : GetQuantile(lengths, 0.5);
  }

  float GetBounded(Slot slot) const
  {
    if (this->IsAlone(slot))
    {
      return this->Nearest[slot] > 0 ? std::min(BodyRadius * this->Nearest[slot], this->Body)
                                     : LoneRadius;
    }
    return std::min(this->Length[slot], this->GetBound(slot));
  }

  /// LargestRatio times the second smallest of some neighbours' lengths.
  float GetBound(Slot slot) const
  {
    float smallest = std::numeric_limits<float>::max(), second = smallest;
    for (int w = 0; w < NumberOfWitnesses; ++w)
    {
      const Slot witness = this->Witnesses[std::size_t(NumberOfWitnesses) * slot + w];
      if (witness != vtkPointSplatNeighbors::None && !this->IsAlone(witness))
      {
        const float length = this->Length[witness];
        second = std::min(second, std::max(smallest, length));
        smallest = std::min(smallest, length);
      }
    }
    return LargestRatio * second;
  }

  std::vector<float> Length;  // of the longer axis; 0 for a point alone
  std::vector<float> Gap;     // what it must at least be to close the gaps around
  std::vector<float> Spacing; // of the neighbours that the disk is made of
  std::vector<float> Nearest; // the distance to any neighbour
  std::vector<Slot> Witnesses;
  std::vector<float> Axes; // both, unless circular
  std::vector<float> Planes; // their normals, if circular
  std::vector<float> Curvatures; // tensors, if circular
  float HoleLimit = 0; // once finished
  float Body = 0;      // the largest radius of a point alone
};
}

vtkPointSplatEstimation::vtkPointSplatEstimation() = default;
vtkPointSplatEstimation::~vtkPointSplatEstimation() = default;

int vtkPointSplatEstimation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkPointSplatEstimation::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  const bool elliptical = this->Shape == Elliptical;
  this->NumberOfPointsAlone = 0;
  this->Noise = 0;

  vtkNew<vtkFloatArray> normals;
  vtkDataArray* given = input->GetPointData()->GetNormals();
  if (given && given->GetNumberOfTuples() != numberOfPoints)
  {
    vtkErrorMacro("The point normals " << (given->GetName() ? given->GetName() : "") << " have "
                                       << given->GetNumberOfTuples() << " tuples for "
                                       << numberOfPoints
                                       << " points; they are estimated instead.");
    given = nullptr;
  }
  normals->SetName(given && given->GetName() ? given->GetName() : "Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(numberOfPoints);
  vtkNew<vtkFloatArray> sizes[2];
  for (int a = 0; a < 2; ++a)
  {
    sizes[a]->SetName(!elliptical ? vtkPointSplatArrays::Radius
        : a == 0                  ? vtkPointSplatArrays::Axis1
                                  : vtkPointSplatArrays::Axis2);
    sizes[a]->SetNumberOfComponents(elliptical ? 3 : 1);
    sizes[a]->SetNumberOfTuples(elliptical || a == 0 ? numberOfPoints : 0);
  }

  vtkNew<vtkFloatArray> planes;
  planes->SetName(vtkPointSplatArrays::PlaneNormal);
  planes->SetNumberOfComponents(3);
  planes->SetNumberOfTuples(elliptical ? 0 : numberOfPoints);

  vtkNew<vtkFloatArray> curvatures;
  curvatures->SetName(vtkPointSplatArrays::Curvature);
  curvatures->SetNumberOfComponents(6);
  curvatures->SetNumberOfTuples(elliptical ? 0 : numberOfPoints);

  vtkNew<vtkFloatArray> clips, folds; // stay empty where there are none
  clips->SetName(vtkPointSplatArrays::Clip);
  folds->SetName(vtkPointSplatArrays::Fold);

  if (numberOfPoints > 0)
  {
    vtkDataArray* points = input->GetPoints()->GetData();
    float* n = normals->GetPointer(0);
    if (given)
    {
      vtkPointSplatInput::ReadNormals(given, n);
    }
    else
    {
      std::fill(n, n + 3 * numberOfPoints, 0.0f);
    }

    // Which points take part.
    std::vector<unsigned char> used;
    const auto [bad, hidden] = vtkPointSplatInput::MarkUsable(input, used);
    const unsigned char* ghost = vtkPointSplatInput::GetGhosts(input);
    if (bad > 0 || hidden > 0)
    {
      vtkWarningMacro("Of " << numberOfPoints << " points " << bad
                            << " have coordinates that are not finite and " << hidden
                            << " are hidden (" << vtkDataSetAttributes::GhostArrayName()
                            << "); they take no part and get radius 0.");
    }

    // 1. Neighbours
    vtkPointSplatNeighbors neighbors;
    neighbors.Build(points, used.data());
    const Slot slots = neighbors.GetNumberOfSlots();
    const std::vector<Slot>& slotOf = neighbors.GetSlots();

    // 2. and 3. Normals
    std::vector<float> slotNormals(std::size_t(3) * slots, 0.0f);
    std::vector<unsigned char> known(slots, 0);
    bool missing = false;
    for (Slot s = 0; s < slots; ++s)
    {
      const vtkIdType id = neighbors.GetId(s);
      if (id >= 0)
      {
        std::copy(n + 3 * id, n + 3 * id + 3, slotNormals.data() + std::size_t(3) * s);
        known[s] = !IsZero(n + 3 * id);
        missing = missing || !known[s];
      }
    }
    if (missing)
    {
      vtkPointSplatNormals fitted(neighbors, slotNormals, known);
      const bool consistent = this->Orientation == Consistent;
      std::string error;
      const vtkPointSplatSensors sensors(input, error);
      if (consistent && !error.empty())
      {
        vtkErrorMacro(<< error);
      }
      if (!fitted.Fit(this, 0.1, 0.4, this->NumberOfNeighbors, consistent))
      {
        return 1;
      }
      if (consistent && !sensors.IsEmpty())
      {
        fitted.OrientToSensors(sensors);
      }
      else if (consistent)
      {
        fitted.OrientConsistently();
      }
      else
      {
        fitted.OrientToViewpoint(this->Viewpoint);
      }
    }
    this->Noise = missing ? 0 : vtkPointSplatNoise::Measure(this, neighbors, slotNormals.data());

    // 4. Disks
    const float usual = GetUsualSpacing(this, neighbors);
    Disks disks(slots, elliptical);
    std::vector<unsigned char> uneven(slots, 0);
    auto measure = [&](const vtkPointSplatNeighbors::Neighborhood& around, int round) {
      const Slot s = around.Center;
      vtkPointSplatDisk disk;
      const bool closed = disk.Estimate(around, slotNormals.data(), elliptical, usual);
      uneven[s] = uneven[s] || disk.Sheet.Uneven;
      if (round > 0 && !closed)
      {
        // What more neighbours do not close is a border: the first round's disk stands.
        return round == 2 || !disk.InRow(this->NumberOfNeighbors);
      }
      float largest = std::numeric_limits<float>::max();
      if (!elliptical)
      {
        float* tensor = disks.Curvatures.data() + std::size_t(6) * s;
        vtkPointSplatCurvature curvature;
        // Normals that are not the surface's say nothing of its curvature.
        if (std::equal(disk.Normal, disk.Normal + 3, slotNormals.data() + std::size_t(3) * s))
        {
          curvature.Estimate(around, slotNormals.data(), disk.Normal, disk.Sheet);
        }
        std::copy_n(curvature.Tensor, 6, tensor);
        std::copy(disk.Normal, disk.Normal + 3, disks.Planes.data() + std::size_t(3) * s);
        largest = GetLargest(curvature.Strongest, disk.Length1);
      }
      else
      {
        const float ratio = disk.Length1 > 0 ? disk.Length2 / disk.Length1 : 1.0f;
        for (int c = 0; c < 3; ++c)
        {
          disks.Axes[std::size_t(6) * s + c] = disk.Axis1[c];
          disks.Axes[std::size_t(6) * s + 3 + c] = ratio * disk.Axis2[c];
        }
      }
      disks.Length[s] = std::min(disk.Length1, largest);
      disks.Gap[s] = std::min(disk.Gap, largest);
      disks.Spacing[s] = disk.Spacing;
      disks.Nearest[s] = around.Count > 0 ? std::sqrt(around.SquaredDistance[0]) : 0.0f;
      for (int w = 0; w < NumberOfWitnesses && around.Count >= NumberOfWitnesses; ++w)
      {
        disks.Witnesses[std::size_t(NumberOfWitnesses) * s + w] =
          around.Slots[(w + 1) * around.Count / NumberOfWitnesses - 1];
      }
      return closed;
    };
    if (!neighbors.Visit(this, missing ? 0.5 : 0.1, 0.8, this->NumberOfNeighbors, measure))
    {
      return 1;
    }

    // 5. Creases
    vtkPointSplatCreases creases(neighbors, slotNormals.data(),
      elliptical ? nullptr : disks.Curvatures.data(), usual, elliptical);
    if (given && !this->IsNoisy() &&
      !creases.Find(this, 0.8, 0.9, uneven, FindTwins(n, slotNormals, neighbors)))
    {
      return 1;
    }
    for (const vtkPointSplatCreases::Splat& splat : creases.Splats)
    {
      if (splat.Id < 0)
      {
        disks.Set(splat);
      }
    }
    disks.Finish();

    // 6. Bounds, and from slots back to points
    for (const Slot s : slotOf)
    {
      this->NumberOfPointsAlone += s != vtkPointSplatNeighbors::None && disks.IsAlone(s);
    }
    const float scale = static_cast<float>(this->RadiusScale);
    vtkSMPTools::For(0, numberOfPoints, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const Slot s = slotOf[id];
        const bool drawn = s != vtkPointSplatNeighbors::None &&
          !(ghost && (ghost[id] & vtkDataSetAttributes::DUPLICATEPOINT));
        const float length = drawn ? scale * disks.GetBounded(s) : 0.0f;
        if (!elliptical)
        {
          sizes[0]->SetValue(id, length);
          const float* plane = drawn ? disks.Planes.data() + std::size_t(3) * s : n + 3 * id;
          std::copy(plane, plane + 3, planes->GetPointer(3 * id));
          float* tensor = curvatures->GetPointer(6 * id);
          if (drawn && disks.IsAlone(s))
          {
            GetBall(plane, LargestBend / disks.GetBounded(s), tensor);
          }
          else if (drawn)
          {
            std::copy_n(disks.Curvatures.data() + std::size_t(6) * s, 6, tensor);
          }
          else
          {
            std::fill_n(tensor, 6, 0.0f);
          }
        }
        else
        {
          for (int c = 0; c < 6; ++c)
          {
            sizes[c / 3]->SetValue(
              3 * id + c % 3, drawn ? length * disks.Axes[std::size_t(6) * s + c] : 0.0f);
          }
        }
        if (s != vtkPointSplatNeighbors::None && IsZero(n + 3 * id))
        {
          const float* m = slotNormals.data() + std::size_t(3) * s;
          std::copy(m, m + 3, n + 3 * id);
        }
      }
    });

    if (!creases.Splats.empty())
    {
      creases.Write(slotOf, clips, folds);
      for (const vtkPointSplatCreases::Splat& splat : creases.Splats)
      {
        if (splat.Id < 0 || (ghost && (ghost[splat.Id] & vtkDataSetAttributes::DUPLICATEPOINT)))
        {
          continue;
        }
        // A twin takes its slot for the time of its own output.
        disks.Set(splat);
        disks.Close(splat.At);
        const float length = scale * disks.GetBounded(splat.At);
        for (int c = 0; c < 6 && elliptical; ++c)
        {
          sizes[c / 3]->SetValue(
            3 * splat.Id + c % 3, length * disks.Axes[std::size_t(6) * splat.At + c]);
        }
        if (!elliptical)
        {
          sizes[0]->SetValue(splat.Id, length);
          std::copy_n(splat.Normal, 3, planes->GetPointer(3 * splat.Id));
          std::copy_n(splat.Tensor, 6, curvatures->GetPointer(6 * splat.Id));
        }
      }
    }
  }

  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->GetFieldData()->PassData(input->GetFieldData());
  for (const char* name : { vtkPointSplatArrays::Radius, vtkPointSplatArrays::Axis1,
         vtkPointSplatArrays::Axis2, vtkPointSplatArrays::PlaneNormal,
         vtkPointSplatArrays::Curvature, vtkPointSplatArrays::Clip, vtkPointSplatArrays::Fold })
  {
    // Of an earlier estimation, possibly of the other shape.
    output->GetPointData()->RemoveArray(name);
  }
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(sizes[0]);
  if (elliptical)
  {
    output->GetPointData()->AddArray(sizes[1]);
  }
  else
  {
    output->GetPointData()->AddArray(planes);
    output->GetPointData()->AddArray(curvatures);
  }
  for (vtkFloatArray* array : { clips.Get(), folds.Get() })
  {
    if (array->GetNumberOfTuples() > 0)
    {
      output->GetPointData()->AddArray(array);
    }
  }
  this->UpdateProgress(1.0);
  return 1;
}

void vtkPointSplatEstimation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "Shape: " << (this->Shape == Elliptical ? "Elliptical" : "Circular") << "\n";
  os << indent << "Orientation: "
     << (this->Orientation == Consistent ? "Consistent" : "TowardsViewpoint") << "\n";
  os << indent << "Viewpoint: " << this->Viewpoint[0] << " " << this->Viewpoint[1] << " "
     << this->Viewpoint[2] << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "NumberOfPointsAlone: " << this->NumberOfPointsAlone << "\n";
  os << indent << "Noise: " << this->Noise << "\n";
}

VTK_ABI_NAMESPACE_END
