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
#include "vtkPointSplatBodies.h"
#include "vtkPointSplatBorders.h"
#include "vtkPointSplatCreases.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatDisks.h"
#include "vtkPointSplatFans.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatMeshBorders.h"
#include "vtkPointSplatNeighbors.h"
#include "vtkPointSplatNoise.h"
#include "vtkPointSplatNormals.h"
#include "vtkPointSplatSensors.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatEstimation);

namespace
{
using Slot = vtkPointSplatNeighbors::Slot;

/// The sixth neighbour's distance, of the third one's, for points at random in a plane (1.43) and a
/// little: it is the neighbour of another body where most bodies have few points.
constexpr float SixthPerThird = 1.5f;
/// Of how many leaves of the search tree, at least, the usual spacing is found.
constexpr Slot UsualLeaves = 512;

bool IsZero(const float n[3])
{
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
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
  return spacings.empty() ? 0.0f : vtkPointSplatDisks::GetQuantile(spacings, 0.5);
}

/// Adds the lines of disks on tubes to those points that have none.
void WriteTubeLines(
  const vtkPointSplatDisks& disks, const std::vector<Slot>& slotOf, vtkFloatArray* clips)
{
  for (std::size_t id = 0; id < slotOf.size(); ++id)
  {
    float lines[6];
    if (slotOf[id] == vtkPointSplatNeighbors::None || !disks.GetTubeLines(slotOf[id], lines))
    {
      continue;
    }
    vtkPointSplatBorders::MakeLines(clips, static_cast<vtkIdType>(slotOf.size()));
    float* clip = clips->GetPointer(static_cast<vtkIdType>(6 * id));
    if (std::all_of(clip, clip + 6, [](float v) { return v == 0; }))
    {
      std::copy_n(lines, 6, clip);
    }
  }
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
    if (vtkPointSplatCrease::Parts(n, slotNormals.data() + std::size_t(3) * s))
    {
      twins.push_back({ static_cast<vtkIdType>(id), s, { n[0], n[1], n[2] } });
    }
  }
  return twins;
}
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
  this->Noise = this->Contradiction = 0;

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

    // Meshes know their neighbours, but for those that were split at their creases. All other points'
    // are searched for, and a mesh's where normals tell of creases.
    vtkPointSplatFans fans;
    vtkPolyData* mesh = vtkPolyData::SafeDownCast(input);
    const vtkIdType badCells = mesh && !elliptical ? fans.Read(mesh, used.data()) : 0;
    if (fans.IsSplit(n))
    {
      fans.Clear();
    }
    if (badCells > 0)
    {
      vtkWarningMacro(<< badCells << " polygons or strips index points that are not there; they "
                         "take no part.");
    }
    std::vector<unsigned char> searched = used;
    const bool meshAlone = fans.AreAll(used, n);
    std::vector<vtkPointSplatFans::Disk> corners(meshAlone ? numberOfPoints : 0);
    std::atomic<bool> anyCreased{ false };
    vtkSMPTools::For(0, static_cast<vtkIdType>(corners.size()), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        corners[id] = fans.Has(id) ? fans.GetDisk(id, n) : vtkPointSplatFans::Disk();
        if (corners[id].Creased)
        {
          anyCreased = true;
        }
      }
    });
    if (meshAlone && !anyCreased)
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
    if (!missing && fans.IsEmpty())
    {
      const vtkPointSplatNoise::Shares found =
        vtkPointSplatNoise::Measure(this, neighbors, slotNormals.data());
      this->Noise = found.Noisy;
      this->Contradiction = found.Contradicted;
    }

    // 4. Disks, but for the corners of triangles
    std::vector<unsigned char> wanted(slots, 0);
    for (vtkIdType id = 0; id < numberOfPoints; ++id)
    {
      if (slotOf[id] != vtkPointSplatNeighbors::None && !fans.Has(id))
      {
        wanted[slotOf[id]] = 1;
      }
    }
    float usual = GetUsualSpacing(this, neighbors);
    vtkPointSplatDisks disks(slots, elliptical);
    vtkPointSplatBodies bodies(slots);
    std::vector<unsigned char> creased(slots, 0);
    // Slots with a neighbour whose normal is not that of the surface.
    std::vector<std::atomic<bool>> misled(slots);
    const float* directions = slotNormals.data();
    auto measure = [&](const vtkPointSplatNeighbors::Neighborhood& around, int round) {
      const Slot s = around.Center;
      vtkPointSplatDisk disk;
      const bool closed =
        disk.Estimate(around, directions, elliptical, usual, disks.HoleLimit);
      creased[s] = creased[s] ||
        (disk.Sheet.Uneven &&
          vtkPointSplatCrease::IsLikely(around, slotNormals.data(),
            slotNormals.data() + std::size_t(3) * s, disk.Sheet.Spacing));
      if (round == 0 && !known[s])
      {
        bodies.Look(around, slotNormals.data());
      }
      if (round == 2)
      {
        bodies.AddRow(around, disk.Sheet, disks.Length[s]);
      }
      if (round > 0 && !closed)
      {
        // What more neighbours do not close is a border: the first round's disk stands.
        if (round == 1)
        {
          const bool inRow = disk.InRow(this->NumberOfNeighbors);
          if (inRow && known[s])
          {
            bodies.LookAtRow(around, this->NumberOfNeighbors);
          }
          return !inRow;
        }
        return true;
      }
      std::copy(disk.Normal, disk.Normal + 3, disks.Planes.data() + std::size_t(3) * s);
      const bool fits =
        std::equal(disk.Normal, disk.Normal + 3, directions + std::size_t(3) * s);
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
          curvature.Estimate(around, directions, disk.Normal, disk.Sheet);
        }
        std::copy_n(curvature.Tensor, 6, tensor);
        largest = vtkPointSplatDisks::GetLargest(curvature.Strongest, disk.Length1);
      }
      disks.Set(around, disk, largest);
      return closed;
    };
    auto isWanted = [&wanted](Slot s) { return wanted[s] != 0; };
    if (!neighbors.Visit(
          this, missing ? 0.5 : 0.1, 0.8, this->NumberOfNeighbors, measure, isWanted))
    {
      return 1;
    }
    // Again where that tells more: neighbours across holes and normals that are not the surface's.
    disks.FindHoleLimit();
    if (disks.Stretched)
    {
      // Where points are sparse is no less known than where they are dense.
      usual = std::numeric_limits<float>::max();
    }
    std::vector<float> sheetNormals = slotNormals;
    for (Slot s = 0; s < slots; ++s)
    {
      if (wanted[s])
      {
        wanted[s] = (misled[s] && !disks.Whole[s]) ||
          disks.Opening[s] > disks.HoleLimit * disks.Spacing[s] ||
          (disks.Stretched && disks.Opening[s] == 0);
        std::copy_n(disks.Planes.data() + std::size_t(3) * s, 3,
          sheetNormals.data() + std::size_t(3) * s);
      }
    }
    directions = sheetNormals.data();
    if (!neighbors.Visit(this, 0.8, 0.83, this->NumberOfNeighbors, measure, isWanted) ||
      !bodies.Finish(this, 0.83, 0.85, neighbors, this->NumberOfNeighbors, disks))
    {
      return 1;
    }

    for (vtkIdType id = 0; id < static_cast<vtkIdType>(corners.size()); ++id)
    {
      if (slotOf[id] != vtkPointSplatNeighbors::None)
      {
        disks.Set(slotOf[id], corners[id]);
        creased[slotOf[id]] = corners[id].Creased;
      }
    }

    // 5. Borders and creases
    Twins twins = FindTwins(n, slotNormals, neighbors);
    vtkPointSplatBorders borders(neighbors, directions, usual, disks);
    if (!this->IsRough())
    {
      std::vector<unsigned char> open(slots, 0);
      for (vtkIdType id = 0; id < numberOfPoints; ++id)
      {
        const Slot s = slotOf[id];
        if (s != vtkPointSplatNeighbors::None && !fans.Has(id))
        {
          open[s] = disks.MayEnd(s);
        }
      }
      for (const vtkPointSplatCreases::Twin& twin : twins)
      {
        open[twin.At] = 0;
      }
      if (!borders.Find(this, elliptical, open) || !borders.Finish(this, disks))
      {
        return 1;
      }
    }
    vtkPointSplatCreases creases(neighbors, slotNormals.data(),
      elliptical ? nullptr : disks.Curvatures.data(), usual, elliptical);
    if (given && (fans.IsEmpty() || meshAlone) && !this->IsRough() &&
      !creases.Find(this, 0.85, 0.9, creased, std::move(twins)))
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
    for (vtkIdType id = 0; id < numberOfPoints; ++id)
    {
      const Slot s = slotOf[id];
      this->NumberOfPointsAlone +=
        s != vtkPointSplatNeighbors::None && disks.IsAlone(s) && !fans.Has(id);
    }
    // Coordinates may be so large that lengths overflow.
    const auto scaled = [scale = static_cast<float>(this->RadiusScale)](float length) {
      constexpr float largest = std::numeric_limits<float>::max();
      return std::min(scale * std::min(length, largest), largest);
    };
    vtkSMPTools::For(0, numberOfPoints, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const Slot s = slotOf[id];
        const bool drawn = s != vtkPointSplatNeighbors::None &&
          !(ghost && (ghost[id] & vtkDataSetAttributes::DUPLICATEPOINT));
        const float length = drawn ? scaled(disks.GetBounded(s)) : 0.0f;
        if (!elliptical)
        {
          sizes[0]->SetValue(id, length);
          const bool alone = drawn && disks.IsAlone(s);
          const float* plane = drawn ? disks.Planes.data() + std::size_t(3) * s : n + 3 * id;
          std::copy(plane, plane + 3, planes->GetPointer(3 * id));
          float* tensor = curvatures->GetPointer(6 * id);
          if (alone)
          {
            std::fill_n(planes->GetPointer(3 * id), 3, 0.0f);
          }
          if (alone && !known[s])
          {
            disks.GetBall(s, tensor);
          }
          else if (drawn && !alone)
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
      std::vector<unsigned char> ends(slots, 0); // at a crease
      for (const vtkPointSplatCreases::Splat& splat : creases.Splats)
      {
        ends[splat.At] = 1;
      }
      vtkSMPTools::For(0, numberOfPoints, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType id = begin; id < end; ++id)
        {
          const Slot s = slotOf[id];
          const bool drawn = !(ghost && (ghost[id] & vtkDataSetAttributes::DUPLICATEPOINT));
          if (fans.Has(id) && drawn && (s == vtkPointSplatNeighbors::None || !ends[s]))
          {
            const vtkPointSplatFans::Disk disk = meshAlone ? corners[id] : fans.GetDisk(id, n);
            sizes[0]->SetValue(id, scaled(disk.Radius));
            std::copy(disk.Plane, disk.Plane + 3, planes->GetPointer(3 * id));
            std::copy(disk.Curvature, disk.Curvature + 6, curvatures->GetPointer(6 * id));
          }
        }
      });
    }
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
        const float length = scaled(disks.GetBounded(splat.At));
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
    borders.Write(slotOf, clips);
    WriteTubeLines(disks, slotOf, clips);
    vtkPointSplatMeshBorders(fans, sizes[0], planes).Write(clips);
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
  os << indent << "Contradiction: " << this->Contradiction << "\n";
}

VTK_ABI_NAMESPACE_END
