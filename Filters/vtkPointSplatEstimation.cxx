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
#include "vtkPointSplatFans.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatNeighbors.h"
#include "vtkPointSplatNoise.h"
#include "vtkPointSplatNormals.h"
#include "vtkPointSplatSensors.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
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

/// Whether all points that take part have triangles and normals (3 floats a point).
bool IsMeshAlone(
  const vtkPointSplatFans& fans, const std::vector<unsigned char>& used, const float* normals)
{
  bool alone = !fans.IsEmpty();
  for (std::size_t id = 0; id < used.size() && alone; ++id)
  {
    alone = !used[id] || (fans.Has(static_cast<vtkIdType>(id)) && !IsZero(normals + 3 * id));
  }
  return alone;
}

/// Disks as they are found, for each slot.
struct Disks
{
  explicit Disks(Slot slots, bool elliptical)
    : Length(slots, 0.0f)
    , Gap(slots, 0.0f)
    , Opening(slots, 0.0f)
    , Whole(slots, 0)
    , Spacing(slots, 0.0f)
    , Nearest(slots, 0.0f)
    , Witnesses(std::size_t(NumberOfWitnesses) * slots, vtkPointSplatNeighbors::None)
    , Axes(elliptical ? std::size_t(6) * slots : 0)
    , Planes(std::size_t(3) * slots, 0.0f)
    , Curvatures(elliptical ? 0 : std::size_t(6) * slots, 0.0f)
  {
  }

  bool IsAlone(Slot slot) const { return !(this->Length[slot] > 0); }

  /**
   * The distance of a cell's vertex, in spacings, past which it lies in a hole of the surface.
   */
  float GetHoleLimit() const
  {
    std::vector<float> sizes;
    sizes.reserve(this->Opening.size());
    for (std::size_t s = 0; s < this->Opening.size(); ++s)
    {
      if (this->Opening[s] > 0)
      {
        sizes.push_back(this->Opening[s] / this->Spacing[s]);
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

  /// Makes disks as large as the gaps that they are to close, and gives points alone their bodies.
  void Finish(float limit)
  {
    std::vector<float> lengths;
    lengths.reserve(this->Length.size());
    for (std::size_t s = 0; s < this->Length.size(); ++s)
    {
      if (this->Gap[s] <= limit * this->Spacing[s])
      {
        this->Length[s] = std::max(this->Length[s], this->Gap[s]);
      }
      if (this->Length[s] > 0)
      {
        lengths.push_back(this->Length[s]);
      }
    }
    this->Body = lengths.empty() ? std::numeric_limits<float>::max() : GetQuantile(lengths, 0.5);
  }

  /// At most LargestRatio times the second smallest of some neighbours' lengths.
  float GetBounded(Slot slot) const
  {
    if (this->IsAlone(slot))
    {
      return this->Nearest[slot] > 0 ? std::min(BodyRadius * this->Nearest[slot], this->Body)
                                     : LoneRadius;
    }
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
    return std::min(this->Length[slot], LargestRatio * second);
  }

  std::vector<float> Length;  // of the longer axis; 0 for a point alone
  std::vector<float> Gap;     // what it must at least be to close the gaps around
  std::vector<float> Opening; // the distance of its cell's farthest vertex, 0 for an open cell
  std::vector<unsigned char> Whole; // whether all neighbours are of its sheet
  std::vector<float> Spacing; // of the neighbours that the disk is made of
  std::vector<float> Nearest; // the distance to any neighbour
  std::vector<Slot> Witnesses;
  std::vector<float> Axes; // both, unless circular
  std::vector<float> Planes; // their normals
  std::vector<float> Curvatures; // tensors, if circular
  float Body = 0; // the largest radius of a point alone
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

    // Meshes know their neighbours. Those of all other points are searched for.
    vtkPointSplatFans fans;
    vtkPolyData* mesh = vtkPolyData::SafeDownCast(input);
    const vtkIdType badCells = mesh && !elliptical ? fans.Read(mesh, used.data()) : 0;
    if (badCells > 0)
    {
      vtkWarningMacro(<< badCells << " polygons or strips index points that are not there; they "
                         "take no part.");
    }
    std::vector<unsigned char> searched = used;
    if (IsMeshAlone(fans, used, n))
    {
      std::fill(searched.begin(), searched.end(), 0);
    }

    // 1. Neighbours
    vtkPointSplatNeighbors neighbors;
    neighbors.Build(points, searched.data());
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
    // A mesh is one surface, whatever its normals say.
    this->Noise = missing || !fans.IsEmpty()
      ? 0
      : vtkPointSplatNoise::Measure(this, neighbors, slotNormals.data());

    // 4. Disks, but for the corners of triangles
    std::vector<unsigned char> wanted(slots, 0);
    for (vtkIdType id = 0; id < numberOfPoints; ++id)
    {
      if (slotOf[id] != vtkPointSplatNeighbors::None && !fans.Has(id))
      {
        wanted[slotOf[id]] = 1;
      }
    }
    const float usual = GetUsualSpacing(this, neighbors);
    Disks disks(slots, elliptical);
    float holeLimit = std::numeric_limits<float>::max();
    // Slots with a neighbour whose normal is not that of the surface.
    std::vector<std::atomic<bool>> misled(slots);
    auto measure = [&](const vtkPointSplatNeighbors::Neighborhood& around, int round) {
      const Slot s = around.Center;
      vtkPointSplatDisk disk;
      const bool closed = disk.Estimate(around, slotNormals.data(), elliptical, usual, holeLimit);
      if (round > 0 && !closed)
      {
        // What more neighbours do not close is a border: the first round's disk stands.
        return round == 2 || !disk.InRow(this->NumberOfNeighbors);
      }
      std::copy(disk.Normal, disk.Normal + 3, disks.Planes.data() + std::size_t(3) * s);
      const bool fits =
        std::equal(disk.Normal, disk.Normal + 3, slotNormals.data() + std::size_t(3) * s);
      for (int i = 0; i < around.Count && !fits; ++i)
      {
        misled[around.Slots[i]].store(true, std::memory_order_relaxed);
      }
      float largest = std::numeric_limits<float>::max();
      if (!elliptical)
      {
        float* tensor = disks.Curvatures.data() + std::size_t(6) * s;
        vtkPointSplatCurvature curvature;
        // Normals that are not the surface's say nothing of its curvature.
        if (fits)
        {
          curvature.Estimate(around, slotNormals.data(), disk.Sheet);
        }
        std::copy_n(curvature.Tensor, 6, tensor);
        largest = curvature.Strongest > 0
          ? std::max(LargestBend / curvature.Strongest, LeastShare * disk.Length1)
          : largest;
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
      disks.Opening[s] = disk.Opening;
      disks.Whole[s] = disk.Sheet.Whole;
      disks.Spacing[s] = disk.Spacing;
      disks.Nearest[s] = around.Count > 0 ? std::sqrt(around.SquaredDistance[0]) : 0.0f;
      for (int w = 0; w < NumberOfWitnesses && around.Count >= NumberOfWitnesses; ++w)
      {
        disks.Witnesses[std::size_t(NumberOfWitnesses) * s + w] =
          around.Slots[(w + 1) * around.Count / NumberOfWitnesses - 1];
      }
      return closed;
    };
    if (!neighbors.Visit(this, missing ? 0.5 : 0.1, 0.85, this->NumberOfNeighbors, measure,
          [&](Slot s) { return wanted[s] != 0; }))
    {
      return 1;
    }
    // Again where that tells more: neighbours across holes and normals that are not the surface's.
    holeLimit = disks.GetHoleLimit();
    for (Slot s = 0; s < slots; ++s)
    {
      if (wanted[s])
      {
        wanted[s] = (misled[s] && !disks.Whole[s]) ||
          disks.Opening[s] > holeLimit * disks.Spacing[s];
        std::copy_n(disks.Planes.data() + std::size_t(3) * s, 3,
          slotNormals.data() + std::size_t(3) * s);
      }
    }
    if (!neighbors.Visit(this, 0.85, 0.9, this->NumberOfNeighbors, measure,
          [&](Slot s) { return wanted[s] != 0; }))
    {
      return 1;
    }
    disks.Finish(holeLimit);

    // 5. Bounds, and from slots back to points
    for (vtkIdType id = 0; id < numberOfPoints; ++id)
    {
      const Slot s = slotOf[id];
      this->NumberOfPointsAlone +=
        s != vtkPointSplatNeighbors::None && disks.IsAlone(s) && !fans.Has(id);
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
    if (!fans.IsEmpty())
    {
      vtkSMPTools::For(0, numberOfPoints, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType id = begin; id < end; ++id)
        {
          if (fans.Has(id) && !(ghost && (ghost[id] & vtkDataSetAttributes::DUPLICATEPOINT)))
          {
            const vtkPointSplatFans::Disk disk = fans.GetDisk(id, n);
            sizes[0]->SetValue(id, scale * disk.Radius);
            std::copy(disk.Plane, disk.Plane + 3, planes->GetPointer(3 * id));
            std::copy(disk.Curvature, disk.Curvature + 6, curvatures->GetPointer(6 * id));
          }
        }
      });
    }
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

//------------------------------------------------------------------------------
void vtkPointSplatEstimation::SetViewpoint(double x, double y, double z)
{
  const double wanted[3] = { x, y, z };
  if (!std::all_of(wanted, wanted + 3, [](double v) { return std::isfinite(v); }))
  {
    vtkErrorMacro("SetViewpoint(): " << x << ", " << y << ", " << z
                                     << " is no place. It stays where it is.");
    return;
  }
  if (!std::equal(wanted, wanted + 3, this->Viewpoint))
  {
    std::copy_n(wanted, 3, this->Viewpoint);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
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
