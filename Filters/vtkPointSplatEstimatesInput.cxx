// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the estimates: what the input has, its points, normals and triangles.
#include "vtkPointSplatEstimates.h"

#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatMeshNormals.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Makes the arrays, and returns the given normals, if they can be used.
vtkDataArray* vtkPointSplatEstimates::MakeArrays()
{
  vtkDataArray* given = this->Input->GetPointData()->GetNormals();
  if (given && given->GetNumberOfTuples() != this->NumberOfPoints)
  {
    vtkErrorWithObjectMacro(this->Self, "The point normals "
        << (given->GetName() ? given->GetName() : "") << " have " << given->GetNumberOfTuples()
        << " tuples for " << this->NumberOfPoints << " points; they are estimated instead.");
    given = nullptr;
  }
  const auto make = [](vtkFloatArray* array, const char* name, int components, vtkIdType count) {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(count);
  };
  const vtkIdType n = this->NumberOfPoints, ofCircles = this->Elliptical ? 0 : n;
  make(this->Normals, given && given->GetName() ? given->GetName() : "Normals", 3, n);
  if (this->Elliptical)
  {
    make(this->Sizes[0], vtkPointSplatArrays::Axis1, 3, n);
    make(this->Sizes[1], vtkPointSplatArrays::Axis2, 3, n);
  }
  else
  {
    make(this->Sizes[0], vtkPointSplatArrays::Radius, 1, n);
  }
  make(this->Planes, vtkPointSplatArrays::PlaneNormal, 3, ofCircles);
  make(this->Curvatures, vtkPointSplatArrays::Curvature, 6, ofCircles);
  this->Clips->SetName(vtkPointSplatArrays::Clip);
  this->Folds->SetName(vtkPointSplatArrays::Fold);
  return given;
}

/// Which points take part, and their given normals.
void vtkPointSplatEstimates::ReadPoints(vtkDataArray* given)
{
  this->Given = given != nullptr;
  float* n = this->GetNormal(vtkIdType(0));
  if (given)
  {
    vtkPointSplatInput::ReadNormals(given, n);
  }
  else
  {
    std::fill(n, n + 3 * this->NumberOfPoints, 0.0f);
  }
  const auto [bad, hidden] = vtkPointSplatInput::MarkUsable(this->Input, this->Used);
  this->Ghosts = vtkPointSplatInput::GetGhosts(this->Input);
  if (bad > 0 || hidden > 0)
  {
    vtkWarningWithObjectMacro(this->Self, "Of "
        << this->NumberOfPoints << " points " << bad
        << " have coordinates that are not finite and " << hidden << " are hidden ("
        << vtkDataSetAttributes::GhostArrayName()
        << "); they take no part and get radius 0.");
  }
}

/**
 * Meshes know their normals and neighbours. All other points' are searched for, and a mesh's where
 * normals tell of creases.
 */
void vtkPointSplatEstimates::ReadMesh()
{
  float* n = this->GetNormal(vtkIdType(0));
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(this->Input);
  // Ellipses have triangles' normals, and nothing else of them.
  const bool reads = mesh && !(this->Elliptical && this->Given) && this->Fans.IsEmpty();
  const vtkIdType bad = reads ? this->Fans.Read(mesh, this->Used.data()) : 0;
  if (!this->Fans.IsEmpty() && !this->OfLattice && vtkPointSplatMeshNormals::Complete(this->Fans, n))
  {
    this->Given = true;
  }
  // A mesh that was split has its planes' normals here, and those to shade with were mended before.
  if (!this->OfLattice && !this->Fans.IsSplit())
  {
    this->NumberOfMendedNormals += vtkPointSplatMeshNormals::MendSeams(this->Fans, n);
  }
  if (this->Elliptical)
  {
    this->Fans.Clear();
  }
  this->Fans.LeaveOutCollapsed(this->Used);
  if (this->OfLattice)
  {
    for (vtkIdType id = 0; id < this->NumberOfPoints; ++id)
    {
      this->Used[id] = this->Used[id] && this->Fans.Has(id); // where it has no area
    }
  }
  if (this->OfLattice || this->Fans.IsSplit())
  {
    vtkPointSplatMeshNormals::TakeNeighbors(this->Fans, this->Used, n);
  }
  if (bad > 0)
  {
    vtkWarningWithObjectMacro(this->Self,
      << bad << " polygons or strips index points that are not there; they take no part.");
  }
  std::vector<unsigned char> searched = this->Used;
  this->MeshAlone = this->Fans.AreAll(this->Used, n);
  if (this->MeshAlone)
  {
    this->Corners.resize(this->NumberOfPoints);
    vtkPointSplatThreads::For(0, this->NumberOfPoints, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        if (this->Fans.Has(id) && this->Fans.GetSame(id) == id)
        {
          this->Corners[id] = this->Fans.GetDisk(id, n);
        }
      }
    });
    // Where it was split, here or before, the mesh tells itself where faces end.
    const auto clear = [](vtkPointSplatFans::Disk& disk) { disk.Creased = false; };
    if (this->Fans.IsSplit())
    {
      std::for_each(this->Corners.begin(), this->Corners.end(), clear);
    }
    else
    {
      for (const vtkIdType id : this->Fans.FindSplit())
      {
        clear(this->Corners[id]);
      }
    }
    if (std::none_of(this->Corners.begin(), this->Corners.end(),
          [](const vtkPointSplatFans::Disk& disk) { return disk.Creased; }))
    {
      std::fill(searched.begin(), searched.end(), 0);
    }
  }
  this->Neighbors.Build(this->Input->GetPoints()->GetData(), searched.data());
}

VTK_ABI_NAMESPACE_END
