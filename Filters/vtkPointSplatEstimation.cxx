// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatEstimation.h"

#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimates.h"
#include "vtkPointSplatMesh.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatEstimation);

namespace
{
/// A number of something, rather than an amount of it: there is none between two of them.
bool IsCount(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  const bool measures = type == VTK_FLOAT || type == VTK_DOUBLE;
  const bool colours = array->GetNumberOfComponents() > 1;
  return !vtkDataArray::SafeDownCast(array) || !(measures || colours);
}

/// Adds the fill points to what was estimated of others.
void Append(vtkPointSplatEstimates& estimates)
{
  const vtkIdType count = estimates.Normals->GetNumberOfTuples();
  const vtkIdType all = count + static_cast<vtkIdType>(estimates.Fill.size());
  for (vtkFloatArray* array :
    { estimates.Normals.Get(), estimates.Sizes[0].Get(), estimates.Planes.Get(),
      estimates.Curvatures.Get(), estimates.Clips.Get(), estimates.Folds.Get() })
  {
    if (array->GetNumberOfTuples() > 0)
    {
      array->Resize(all);
      array->SetNumberOfTuples(all);
    }
  }
  const float none[6] = { 0, 0, 0, 0, 0, 0 };
  vtkIdType at = count;
  for (const vtkPointSplatRefinement::Point& point : estimates.Fill)
  {
    estimates.Normals->SetTypedTuple(at, point.Normal);
    estimates.Sizes[0]->SetValue(at, point.Size);
    estimates.Planes->SetTypedTuple(at, point.Plane);
    estimates.Curvatures->SetTypedTuple(at, point.Curvature);
    if (estimates.Clips->GetNumberOfTuples() > 0)
    {
      estimates.Clips->SetTypedTuple(at, point.Clip);
    }
    if (estimates.Folds->GetNumberOfTuples() > 0)
    {
      estimates.Folds->SetTypedTuple(at, none);
    }
    ++at;
  }
}
}

vtkSmartPointer<vtkAbstractArray> vtkPointSplatEstimation::WithFillPoints(
  vtkAbstractArray* array, const std::vector<FillPoint>& points)
{
  const vtkIdType own = array->GetNumberOfTuples();
  vtkSmartPointer<vtkAbstractArray> extended;
  extended.TakeReference(array->NewInstance());
  extended->SetName(array->GetName());
  extended->SetNumberOfComponents(array->GetNumberOfComponents());
  extended->CopyComponentNames(array);
  extended->SetNumberOfTuples(own + static_cast<vtkIdType>(points.size()));
  extended->InsertTuples(0, own, 0, array);
  const bool nearest = IsCount(array);
  vtkNew<vtkIdList> ends;
  vtkIdType at = own;
  for (const FillPoint& point : points)
  {
    if (nearest)
    {
      extended->SetTuple(at++, point.Ends[0], array);
      continue;
    }
    double weights[3];
    ends->SetNumberOfIds(point.Count);
    for (int k = 0; k < point.Count; ++k)
    {
      ends->SetId(k, point.Ends[k]);
      weights[k] = point.Weights[k];
    }
    extended->InterpolateTuple(at++, ends, array, weights);
  }
  return extended;
}

void vtkPointSplatEstimation::AppendFillPoints(vtkPointSet* input, vtkPoints* places,
  const std::vector<FillPoint>& points, vtkPolyData* output)
{
  const vtkIdType own = input->GetNumberOfPoints();
  vtkNew<vtkPoints> all;
  all->SetDataType(input->GetPoints()->GetDataType());
  all->SetNumberOfPoints(own + places->GetNumberOfPoints());
  all->InsertPoints(0, own, 0, input->GetPoints());
  all->InsertPoints(own, places->GetNumberOfPoints(), 0, places);
  output->SetPoints(all);

  vtkPointData *from = input->GetPointData(), *to = output->GetPointData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != own)
    {
      continue; // it could not be told whose values they are
    }
    const int at = to->AddArray(vtkPointSplatEstimation::WithFillPoints(array, points));
    const int attribute = from->IsArrayAnAttribute(i);
    if (attribute >= 0)
    {
      to->SetActiveAttribute(at, attribute);
    }
  }
  vtkNew<vtkIdTypeArray> sources;
  sources->SetName(vtkPointSplatArrays::Source);
  sources->SetNumberOfTuples(all->GetNumberOfPoints());
  std::iota(sources->GetPointer(0), sources->GetPointer(own), vtkIdType(0));
  std::transform(points.begin(), points.end(), sources->GetPointer(own),
    [](const FillPoint& point) { return point.Ends[0]; });
  to->AddArray(sources);
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
  // Points that are corners of several faces have a splat for each.
  vtkPointSplatMesh mesh;
  if (this->Shape == Circular)
  {
    mesh.Read(input);
  }
  const bool split = this->FillGaps && this->FillMeshGaps && mesh.Split();
  vtkPointSplatEstimates estimates(this, split ? mesh.Points.Get() : input);
  estimates.SetMesh(std::move(mesh));
  const bool finished = estimates.Run();
  this->NumberOfPointsAlone = estimates.NumberOfPointsAlone;
  this->NumberOfMendedNormals = estimates.NumberOfMendedNormals;
  this->Noise = estimates.Noise;
  this->Contradiction = estimates.Contradiction;
  this->FillPoints.clear();
  if (!finished)
  {
    return 1;
  }
  estimates.MakeFill();

  vtkPointData* data = output->GetPointData();
  output->GetFieldData()->PassData(input->GetFieldData());
  const std::vector<vtkPointSplatRefinement::Point>& fill = estimates.Fill;
  if (fill.empty())
  {
    output->SetPoints(input->GetPoints());
    data->PassData(input->GetPointData());
  }
  else
  {
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    for (const vtkPointSplatRefinement::Point& point : fill)
    {
      places->InsertNextPoint(point.X);
      FillPoint made{ point.Count, { 0, 0, 0 }, { 0, 0, 0 } };
      std::copy_n(point.Ends, point.Count, made.Ends);
      std::copy_n(point.Weights, point.Count, made.Weights);
      this->FillPoints.push_back(made);
    }
    Append(estimates);
    vtkPointSplatEstimation::AppendFillPoints(input, places, this->FillPoints, output);
  }
  for (const char* name : { vtkPointSplatArrays::Radius, vtkPointSplatArrays::Axis1,
         vtkPointSplatArrays::Axis2, vtkPointSplatArrays::PlaneNormal,
         vtkPointSplatArrays::Curvature, vtkPointSplatArrays::Clip, vtkPointSplatArrays::Fold })
  {
    // Of an earlier estimation, possibly of the other shape.
    data->RemoveArray(name);
  }
  data->SetNormals(estimates.Normals);
  data->AddArray(estimates.Sizes[0]);
  if (this->Shape == Elliptical)
  {
    data->AddArray(estimates.Sizes[1]);
  }
  else
  {
    data->AddArray(estimates.Planes);
    data->AddArray(estimates.Curvatures);
  }
  for (vtkFloatArray* lines : { estimates.Clips.Get(), estimates.Folds.Get() })
  {
    if (lines->GetNumberOfTuples() > 0)
    {
      data->AddArray(lines);
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
  os << indent << "FillGaps: " << (this->FillGaps ? "On" : "Off") << "\n";
  os << indent << "FillMeshGaps: " << (this->FillMeshGaps ? "On" : "Off") << "\n";
  os << indent << "FillNoise: " << (this->FillNoise ? "On" : "Off") << "\n";
  os << indent << "Relief: " << (this->Relief ? "On" : "Off") << "\n";
  os << indent << "NumberOfPointsAlone: " << this->NumberOfPointsAlone << "\n";
  os << indent << "NumberOfMendedNormals: " << this->NumberOfMendedNormals << "\n";
  os << indent << "Noise: " << this->Noise << "\n";
  os << indent << "Contradiction: " << this->Contradiction << "\n";
}

VTK_ABI_NAMESPACE_END
