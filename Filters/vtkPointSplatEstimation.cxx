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

using Slot = vtkPointSplatNeighbors::Slot;

bool IsZero(const float n[3])
{
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

/// Disks as they are found, for each slot.
struct Disks
{
  explicit Disks(Slot slots, bool elliptical)
    : Length(slots, 0.0f)
    , Size(slots, 0.0f)
    , Witnesses(std::size_t(NumberOfWitnesses) * slots, vtkPointSplatNeighbors::None)
    , Axes(elliptical ? std::size_t(6) * slots : 0)
    , Planes(elliptical ? 0 : std::size_t(3) * slots)
    , Curvatures(elliptical ? 0 : std::size_t(6) * slots, 0.0f)
  {
  }

  /**
   * The size, in spacings, past which a disk reaches over a hole in the surface.
   */
  float GetHoleLimit() const
  {
    std::vector<float> sizes;
    sizes.reserve(this->Size.size());
    for (const float size : this->Size)
    {
      if (size > 0 && std::isfinite(size))
      {
        sizes.push_back(size);
      }
    }
    if (sizes.size() < 100)
    {
      return std::numeric_limits<float>::max();
    }
    auto quantile = [&sizes](double q) {
      auto at = sizes.begin() + static_cast<std::ptrdiff_t>(q * (sizes.size() - 1));
      std::nth_element(sizes.begin(), at, sizes.end());
      return *at;
    };
    const float usual = quantile(0.5), large = quantile(0.95);
    const float t = std::clamp(
      (large / usual - RegularSpread) / (IrregularSpread - RegularSpread), 0.0f, 1.0f);
    return large * (HoleFactor + t * (GapFactor - HoleFactor));
  }

  /// At most LargestRatio times the second smallest of some neighbours' lengths.
  float GetBounded(Slot slot) const
  {
    float smallest = std::numeric_limits<float>::max(), second = smallest;
    for (int w = 0; w < NumberOfWitnesses; ++w)
    {
      const Slot witness = this->Witnesses[std::size_t(NumberOfWitnesses) * slot + w];
      if (witness != vtkPointSplatNeighbors::None)
      {
        const float length = this->Length[witness];
        second = std::min(second, std::max(smallest, length));
        smallest = std::min(smallest, length);
      }
    }
    return std::min(this->Length[slot], LargestRatio * second);
  }

  std::vector<float> Length; // of the longer axis
  std::vector<float> Size;   // in spacings
  std::vector<Slot> Witnesses;
  std::vector<float> Axes; // both, unless circular
  std::vector<float> Planes; // their normals, if circular
  std::vector<float> Curvatures; // tensors, if circular
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
    Disks disks(slots, elliptical);
    float limit = std::numeric_limits<float>::max();
    auto measure = [&](const vtkPointSplatNeighbors::Neighborhood& around, int round) {
      const Slot s = around.Center;
      if (round == 0 && !elliptical)
      {
        vtkPointSplatCurvature curvature;
        curvature.Estimate(around, slotNormals.data());
        std::copy_n(curvature.Tensor, 6, disks.Curvatures.data() + std::size_t(6) * s);
      }
      vtkPointSplatDisk disk;
      const bool closed = disk.Estimate(
        around, slotNormals.data(), elliptical, this->NumberOfNeighbors, round == 1, limit);
      if (!closed && round != 1)
      {
        // More neighbours may tell; in the last round, the border's disk of the one before stands.
        return round == 2;
      }
      disks.Length[s] = disk.Length1 > 0 ? disk.Length1 : LoneRadius;
      disks.Size[s] = disk.Spacing > 0 ? std::sqrt(disk.Length1 * disk.Length2) / disk.Spacing : 0;
      for (int w = 0; w < NumberOfWitnesses && around.Count >= NumberOfWitnesses; ++w)
      {
        disks.Witnesses[std::size_t(NumberOfWitnesses) * s + w] =
          around.Slots[(w + 1) * around.Count / NumberOfWitnesses - 1];
      }
      if (!elliptical)
      {
        std::copy(disk.Normal, disk.Normal + 3, disks.Planes.data() + std::size_t(3) * s);
        if (!std::equal(disk.Normal, disk.Normal + 3, slotNormals.data() + std::size_t(3) * s))
        {
          // The normals are not the surface's, nor is what they tell of its curvature.
          std::fill_n(disks.Curvatures.data() + std::size_t(6) * s, 6, 0.0f);
        }
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
      return closed || !disk.InRow();
    };
    if (!neighbors.Visit(this, missing ? 0.5 : 0.1, 0.8, this->NumberOfNeighbors, measure))
    {
      return 1;
    }
    limit = disks.GetHoleLimit();
    const std::vector<float> firstSizes = disks.Size;
    if (!neighbors.Visit(this, 0.8, 0.9, this->NumberOfNeighbors, measure,
          [&](Slot s) { return firstSizes[s] > limit; }))
    {
      return 1;
    }

    // 5. Bounds, and from slots back to points
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
          for (int c = 0; c < 6; ++c)
          {
            curvatures->SetValue(
              6 * id + c, drawn ? disks.Curvatures[std::size_t(6) * s + c] : 0.0f);
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
  }

  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  output->GetFieldData()->PassData(input->GetFieldData());
  for (const char* name : { vtkPointSplatArrays::Radius, vtkPointSplatArrays::Axis1,
         vtkPointSplatArrays::Axis2, vtkPointSplatArrays::PlaneNormal,
         vtkPointSplatArrays::Curvature })
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
  os << indent << "Noise: " << this->Noise << "\n";
}

VTK_ABI_NAMESPACE_END
