// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the estimates: from slots back to points.
#include "vtkPointSplatEstimates.h"

#include "vtkPointSet.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatMeshBorders.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <atomic>

VTK_ABI_NAMESPACE_BEGIN

void vtkPointSplatEstimates::Write()
{
  const std::vector<Slot>& slotOf = this->Neighbors.GetSlots();
  const vtkPointSplatDisks& disks = *this->Disks;
  // Of slots in their order, whose neighbours' sizes lie near to theirs in memory.
  vtkPointSplatLargeArray<float> lengths(disks.Length.size());
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(lengths.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType s = begin; s < end; ++s)
    {
      lengths[s] = disks.GetBounded(static_cast<Slot>(s));
    }
  });
  std::atomic<vtkIdType> pointsAlone{ 0 };
  vtkPointSplatThreads::For(0, this->NumberOfPoints, [&](vtkIdType begin, vtkIdType end) {
    vtkIdType aloneHere = 0;
    for (vtkIdType id = begin; id < end; ++id)
    {
      const Slot s = slotOf[id];
      aloneHere += s != vtkPointSplatNeighbors::None && disks.IsAlone(s) && !this->Fans.Has(id);
      float* n = this->GetNormal(id);
      const bool drawn = s != vtkPointSplatNeighbors::None && this->IsDrawn(id);
      const float length = drawn ? this->GetScaled(lengths[s]) : 0.0f;
      if (!this->Elliptical)
      {
        this->Sizes[0]->SetValue(id, length);
        const bool alone = drawn && disks.IsAlone(s);
        const float* plane = drawn ? disks.Planes.data() + std::size_t(3) * s : n;
        std::copy(plane, plane + 3, this->Planes->GetPointer(3 * id));
        float* tensor = this->Curvatures->GetPointer(6 * id);
        if (alone)
        {
          std::fill_n(this->Planes->GetPointer(3 * id), 3, 0.0f);
        }
        if (alone && !this->Known[s])
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
          this->Sizes[c / 3]->SetValue(
            3 * id + c % 3, drawn ? length * disks.Axes[std::size_t(6) * s + c] : 0.0f);
        }
      }
      if (s != vtkPointSplatNeighbors::None && vtkPointSplatInput::IsZero(n))
      {
        std::copy_n(this->GetSlotNormal(s), 3, n);
      }
    }
    pointsAlone += aloneHere;
  });
  this->NumberOfPointsAlone = pointsAlone;
  this->WriteMesh();
  this->WriteCreases();
  this->Borders->Write(slotOf, this->Clips);
  this->WriteTubeLines();
  const vtkPointSplatMeshBorders ends(this->Fans, this->Sizes[0], this->Planes);
  // Those of a mesh are known from before fill points took room from its disks; but scaled ones reach other edges.
  if (!this->MeshAlone || this->Self->GetRadiusScale() != 1)
  {
    this->Ends = ends.FindEnds(ends.FindNear(), this->FillsMesh());
  }
  ends.Write(this->Ends, this->Clips);
}

/// The disks of triangles' corners, but for those at creases.
void vtkPointSplatEstimates::WriteMesh()
{
  if (this->Fans.IsEmpty())
  {
    return;
  }
  const std::vector<unsigned char> ends = this->GetSlotsAtCreases();
  const float* n = this->Normals->GetPointer(0);
  vtkPointSplatThreads::For(0, this->NumberOfPoints, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType id = begin; id < end; ++id)
    {
      if (this->Fans.Has(id) && this->IsDrawn(id) && !this->IsAt(ends, id))
      {
        const vtkPointSplatFans::Disk disk =
          this->MeshAlone ? this->GetCorner(id) : this->Fans.GetDisk(this->Fans.GetSame(id), n);
        this->Sizes[0]->SetValue(id, this->GetScaled(disk.Radius));
        std::copy(disk.Plane, disk.Plane + 3, this->Planes->GetPointer(3 * id));
        std::copy(disk.Curvature, disk.Curvature + 6, this->Curvatures->GetPointer(6 * id));
      }
    }
  });
}

void vtkPointSplatEstimates::WriteCreases()
{
  if (this->Creases->Splats.empty())
  {
    return;
  }
  vtkPointSplatDisks& disks = *this->Disks;
  this->Creases->Write(this->Neighbors.GetSlots(), this->Clips, this->Folds);
  for (const vtkPointSplatCreases::Splat& splat : this->Creases->Splats)
  {
    if (splat.Id < 0 || !this->IsDrawn(splat.Id))
    {
      continue;
    }
    // A twin takes its slot for the time of its own output.
    disks.Set(splat);
    disks.Close(splat.At);
    const float length = this->GetScaled(disks.GetBounded(splat.At));
    for (int c = 0; c < 6 && this->Elliptical; ++c)
    {
      this->Sizes[c / 3]->SetValue(
        3 * splat.Id + c % 3, length * disks.Axes[std::size_t(6) * splat.At + c]);
    }
    if (!this->Elliptical)
    {
      this->Sizes[0]->SetValue(splat.Id, length);
      std::copy_n(splat.Normal, 3, this->Planes->GetPointer(3 * splat.Id));
      std::copy_n(splat.Tensor, 6, this->Curvatures->GetPointer(6 * splat.Id));
    }
  }
}

/// Adds the lines of disks on tubes to those points that have none.
void vtkPointSplatEstimates::WriteTubeLines()
{
  const std::vector<Slot>& slotOf = this->Neighbors.GetSlots();
  for (std::size_t id = 0; id < slotOf.size(); ++id)
  {
    float lines[6];
    if (slotOf[id] == vtkPointSplatNeighbors::None ||
      !this->Disks->GetTubeLines(slotOf[id], lines))
    {
      continue;
    }
    vtkPointSplatBorders::MakeLines(this->Clips, this->NumberOfPoints);
    float* clip = this->Clips->GetPointer(static_cast<vtkIdType>(6 * id));
    if (std::all_of(clip, clip + 6, [](float v) { return v == 0; }))
    {
      std::copy_n(lines, 6, clip);
    }
  }
}

/// Fill points end at the lines of their ends, but for those behind which these go on.
void vtkPointSplatEstimates::ClipFill()
{
  if (this->Clips->GetNumberOfTuples() == 0)
  {
    return;
  }
  vtkDataArray* points = this->Input->GetPoints()->GetData();
  const std::vector<unsigned char> creased = this->GetSlotsAtCreases();
  const auto clip = [&](vtkPointSplatRefinement::Point& point) {
    vtkPointSplatBorders::Lines lines;
    lines.Reach = vtkPointSplatBorders::KernelReach * point.Size;
    for (int k = 0; k < point.Count; ++k)
    {
      const vtkIdType id = point.Ends[k];
      if (this->MeshAlone && !this->IsAt(creased, id))
      {
        continue;
      }
      double x[3];
      points->GetTuple(id, x);
      const float place[3] = { static_cast<float>(x[0] - point.X[0]),
        static_cast<float>(x[1] - point.X[1]), static_cast<float>(x[2] - point.X[2]) };
      for (int l = 0; l < 2; ++l)
      {
        const float* fold = this->Folds->GetNumberOfTuples() > 0
          ? this->Folds->GetPointer(6 * id + 3 * l)
          : nullptr;
        if (!fold || vtkPointSplatInput::IsZero(fold))
        {
          vtkPointSplatBorders::AddLine(
            this->Clips->GetPointer(6 * id + 3 * l), place, point.Plane, lines);
        }
      }
    }
    if (this->MeshAlone && !this->Fans.GetBorder().empty() && lines.Count == 0)
    {
      std::copy_n(this->FindEnd(point, point.Size).Clip, 6, point.Clip);
    }
    else
    {
      lines.Write(point.Clip);
    }
  };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Fill.size()), [&](vtkIdType begin, vtkIdType end) {
    std::for_each(this->Fill.begin() + begin, this->Fill.begin() + end, clip);
  });
}

VTK_ABI_NAMESPACE_END
