// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMesh.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatLattice.h"
#include "vtkPointSplatLatticeFrame.h"
#include "vtkPointSplatMeshFaces.h"
#include "vtkPointSplatMeshNormals.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// A cloud's points with copies of some of them after these.
vtkSmartPointer<vtkPolyData> MakePoints(
  vtkPointSet* cloud, const std::vector<vtkIdType>& sources, const std::vector<float>& normals)
{
  const vtkIdType count = cloud->GetNumberOfPoints(), copies = static_cast<vtkIdType>(sources.size());
  vtkNew<vtkIdList> from, to;
  for (vtkIdType k = 0; k < copies; ++k)
  {
    from->InsertNextId(sources[k]);
    to->InsertNextId(count + k);
  }
  const auto extend = [&](vtkAbstractArray* array, vtkAbstractArray* extended) {
    extended->SetName(array->GetName());
    extended->SetNumberOfComponents(array->GetNumberOfComponents());
    extended->SetNumberOfTuples(count + copies);
    extended->InsertTuples(0, count, 0, array);
    extended->InsertTuples(to, from, array);
  };
  vtkNew<vtkPoints> points;
  points->SetDataType(cloud->GetPoints()->GetDataType());
  extend(cloud->GetPoints()->GetData(), points->GetData());
  vtkNew<vtkFloatArray> directions;
  directions->SetNumberOfComponents(3);
  directions->SetNumberOfTuples(count + copies);
  std::copy(normals.begin(), normals.end(), directions->GetPointer(0));
  auto split = vtkSmartPointer<vtkPolyData>::New();
  split->SetPoints(points);
  split->GetPointData()->SetNormals(directions);
  if (vtkPointSplatInput::GetGhosts(cloud))
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    extend(cloud->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()), ghosts);
    split->GetPointData()->AddArray(ghosts);
  }
  return split;
}
}

/// Reads the input's normals, if it has any that can be used; otherwise there are none.
bool vtkPointSplatMesh::ReadNormals()
{
  vtkDataArray* given = this->Input->GetPointData()->GetNormals();
  if (given && given->GetNumberOfTuples() == this->Input->GetNumberOfPoints())
  {
    this->Normals.resize(3 * given->GetNumberOfTuples());
    vtkPointSplatInput::ReadNormals(given, this->Normals.data());
  }
  return !given || !this->Normals.empty();
}

void vtkPointSplatMesh::Read(vtkPointSet* input)
{
  this->Input = input;
  if (input->GetNumberOfPoints() == 0 || !this->ReadNormals())
  {
    return;
  }
  vtkPointSplatInput::MarkUsable(input, this->Used);
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(input);
  if (mesh && this->Fans.Read(mesh, this->Used.data()) > 0)
  {
    this->Fans.Clear();
    return;
  }
  if (this->Fans.IsEmpty() && !this->Normals.empty())
  {
    this->FindLattice();
  }
}

/// Takes the triangles of the isosurface whose vertices the points are, if they are.
void vtkPointSplatMesh::FindLattice()
{
  std::vector<double> positions = vtkPointSplatInput::ReadPositions(this->Input->GetPoints()->GetData());
  const auto findAlong = [&](const std::vector<double>& places, const std::vector<float>& normals) {
    vtkPointSplatLattice lattice({ places, this->Used, normals.data(), vtkPointSplatInput::GetGhosts(this->Input) });
    if (lattice.Find())
    {
      this->OfLattice = true;
      this->Fans.Take(std::move(positions), std::move(lattice.Corners), std::move(lattice.Same));
    }
  };
  findAlong(positions, this->Normals);
  vtkPointSplatLatticeFrame frame;
  if (!this->OfLattice && frame.Find(positions, this->Used))
  {
    findAlong(frame.Turn(positions), frame.Turn(this->Normals));
  }
}

/// Completes the normals to shade with; there are none if they are the planes'.
void vtkPointSplatMesh::CompleteNormals(bool ofFaces)
{
  if (this->OfLattice)
  {
    vtkPointSplatMeshNormals::TakeNeighbors(this->Fans, this->Used, this->Normals.data());
  }
  else if (!this->Normals.empty() || !ofFaces)
  {
    this->Normals.resize(3 * this->Fans.GetNumberOfPoints(), 0.0f);
    if (vtkPointSplatMeshNormals::AreMissing(this->Fans, this->Normals.data()))
    {
      vtkPointSplatFans whole = this->Fans;
      vtkPointSplatMeshNormals::Complete(whole, this->Normals.data());
    }
    this->NumberOfMended = vtkPointSplatMeshNormals::MendSeams(this->Fans, this->Normals.data());
  }
}

/// Gives each corner of a triangle its face's point, and these their planes.
void vtkPointSplatMesh::Copy(
  const vtkPointSplatMeshFaces& faces, std::vector<vtkIdType>& corners, std::vector<float>& planes)
{
  constexpr vtkIdType none = vtkPointSplatMeshFaces::None;
  const vtkIdType count = this->Fans.GetNumberOfPoints();
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> copies; // of a point and a face's corner
  std::vector<vtkIdType> first(count, none);
  corners = this->Fans.GetCorners();
  planes.assign(3 * count, 0.0f);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const vtkIdType point = corners[i], corner = faces.GetCorner(i);
    if (corner == none)
    {
      continue;
    }
    if (first[point] == none)
    {
      first[point] = corner;
      faces.GetNormal(corner, planes.data() + 3 * point);
    }
    if (first[point] == corner)
    {
      continue;
    }
    const vtkIdType next = count + static_cast<vtkIdType>(this->Sources.size());
    const auto [copy, isNew] = copies.try_emplace({ point, corner }, next);
    corners[i] = copy->second;
    if (isNew)
    {
      this->Sources.push_back(point);
      planes.resize(planes.size() + 3, 0.0f);
      faces.GetNormal(corner, planes.data() + 3 * next);
    }
  }
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    if (faces.IsTurned(i / 3))
    {
      std::swap(corners[i], corners[i + 1]);
    }
  }
}

/// Takes given normals for planes where these are of one face, and about the same, and where triangles have no normal: those
/// around a point may cancel.
void vtkPointSplatMesh::TakeGiven(std::vector<float>& planes) const
{
  const vtkIdType count = this->Fans.GetNumberOfPoints();
  std::vector<unsigned char> several(planes.size() / 3, 0);
  std::fill(several.begin() + count, several.end(), 1);
  for (const vtkIdType source : this->Sources)
  {
    several[source] = 1;
  }
  for (std::size_t id = 0; id < several.size() && !this->Normals.empty(); ++id)
  {
    const float* given = this->GetNormal(static_cast<vtkIdType>(id));
    float* plane = planes.data() + 3 * id;
    if (vtkPointSplatInput::IsZero(plane) ||
      (!several[id] && vtkMath::Dot(given, plane) > vtkPointSplatMeshNormals::AlikeCosine))
    {
      std::copy_n(given, 3, plane);
    }
  }
}

bool vtkPointSplatMesh::Split()
{
  const bool joins = !this->OfLattice && !this->Normals.empty();
  const bool apart = this->Fans.AreApart();
  if (joins && apart)
  {
    this->Fans.Join(this->Normals.data()); // those of one place and normal are one point
  }
  if (this->Fans.IsEmpty() || this->Fans.AreApart())
  {
    return false;
  }
  vtkPointSplatMeshFaces::Edges edges = vtkPointSplatMeshFaces::Look(this->Fans);
  edges.Ordered = this->OfLattice;
  if (!edges.AreSharp)
  {
    return false;
  }
  if (joins && !apart && this->Fans.HasEdgesWithoutLength())
  {
    this->Fans.Join(this->Normals.data()); // as an isosurface's at a sample that is its value
  }
  const vtkIdType count = this->Fans.GetNumberOfPoints();
  this->Fans.LeaveOutCollapsed(this->Used);
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (this->Used[id] && !this->Fans.Has(id))
    {
      if (!this->OfLattice)
      {
        return false;
      }
      this->Used[id] = 0; // there the isosurface has no area
    }
  }
  vtkPointSplatFans joined = this->Fans;
  joined.Join(std::vector<float>(3 * count, 0.0f).data());
  if (joined.IsEmpty())
  {
    return false;
  }
  this->CompleteNormals(edges.OfFlat);
  const vtkPointSplatMeshFaces faces(
    this->Fans, joined, edges, this->Normals.empty() ? nullptr : this->Normals.data());
  this->TellsFront = faces.TellFront();
  std::vector<vtkIdType> corners;
  std::vector<float> planes;
  this->Copy(faces, corners, planes);
  if (this->Sources.empty())
  {
    return false;
  }
  this->TakeGiven(planes);
  this->Points = MakePoints(this->Input, this->Sources, planes);
  this->Fans.Split(this->Sources, std::move(corners));
  return true;
}

VTK_ABI_NAMESPACE_END
