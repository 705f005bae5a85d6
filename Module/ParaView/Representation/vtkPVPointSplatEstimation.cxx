// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVPointSplatEstimation.h"

#include "vtkCellArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVPointSplatBorders.h"
#include "vtkPVPointSplatOrientation.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatSensors.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace
{
bool IsMesh(vtkPointSet* input)
{
  auto mesh = vtkPolyData::SafeDownCast(input);
  return mesh && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0;
}

/// The points as vertices, which is what travels.
vtkSmartPointer<vtkPolyData> MakeVertices(vtkPointSet* input)
{
  auto vertices = vtkSmartPointer<vtkPolyData>::New();
  const vtkIdType count = input->GetNumberOfPoints();
  if (count > 0)
  {
    vertices->SetPoints(input->GetPoints());
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < count; ++i)
  {
    cells->InsertNextCell(1, &i);
  }
  vertices->SetVerts(cells);
  return vertices;
}

/// Given normals, or zeros, which are to be estimated.
vtkSmartPointer<vtkDataArray> MakeNormals(vtkDataArray* given, vtkIdType count)
{
  vtkNew<vtkFloatArray> normals;
  if (given)
  {
    normals->DeepCopy(given);
  }
  else
  {
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    normals->Fill(0.0);
  }
  normals->SetName("Normals");
  return normals;
}

/// The places of the sensors by point, since processes count scans each for itself.
vtkSmartPointer<vtkDataArray> MakeSensors(const vtkPointSplatSensors& sensors, vtkIdType count)
{
  vtkNew<vtkDoubleArray> places;
  places->SetName(vtkPointSplatArrays::Sensor);
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(count);
  places->Fill(vtkMath::Nan()); // a sensor nobody knows
  for (vtkIdType i = 0; i < count && !sensors.IsEmpty(); ++i)
  {
    double place[3];
    if (sensors.Get(i, place))
    {
      places->SetTuple(i, place);
    }
  }
  return places;
}

/// All processes have the flags, so that appended data sets have the array.
vtkSmartPointer<vtkDataArray> MakeGhosts(vtkPointSet* input)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  vtkUnsignedCharArray* given = input->GetPointGhostArray();
  if (given && given->GetNumberOfValues() == input->GetNumberOfPoints())
  {
    ghosts->DeepCopy(given);
  }
  else
  {
    ghosts->SetNumberOfTuples(input->GetNumberOfPoints());
    ghosts->Fill(0.0);
  }
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  return ghosts;
}

void Negate(vtkIdType point, vtkDataArray* array)
{
  for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
  {
    array->SetComponent(point, c, -array->GetComponent(point, c));
  }
}

/// Turns the normals of points, and what has its sign by them; fill points turn as the points do that they are
/// nearest to.
void Turn(const std::vector<bool>& turned,
  const std::vector<vtkPointSplatEstimation::FillPoint>& fill, vtkPointData* found)
{
  std::vector<vtkIdType> ids;
  for (size_t i = 0; i < turned.size(); ++i)
  {
    if (turned[i])
    {
      ids.push_back(static_cast<vtkIdType>(i));
    }
  }
  const vtkIdType first =
    found->GetNormals()->GetNumberOfTuples() - static_cast<vtkIdType>(fill.size());
  for (size_t i = 0; i < fill.size(); ++i)
  {
    const size_t nearest = static_cast<size_t>(fill[i].Ends[0]);
    if (nearest < turned.size() && turned[nearest])
    {
      ids.push_back(first + static_cast<vtkIdType>(i));
    }
  }
  vtkDataArray* planes = found->GetArray(vtkPointSplatArrays::PlaneNormal);
  for (const vtkIdType i : ids)
  {
    Negate(i, found->GetNormals());
    const double none[3] = { 0.0, 0.0, 0.0 };
    double plane[3];
    if (planes)
    {
      planes->GetTuple(i, plane);
    }
    // A body alone has no plane, and is curved like a ball from all sides.
    if (planes && !std::equal(plane, plane + 3, none))
    {
      Negate(i, planes);
      Negate(i, found->GetArray(vtkPointSplatArrays::Curvature));
    }
  }
}

/// The fill points that are nearest to a process' own points, and not to such as came.
class OwnFill
{
public:
  using List = std::vector<vtkPointSplatEstimation::FillPoint>;

  /// all: behind the points, of which so many are the process' own, in what was estimated.
  OwnFill(const List& all, vtkIdType own, vtkPolyData* estimated)
  {
    this->Places->SetDataTypeToDouble();
    const vtkIdType first = estimated->GetNumberOfPoints() - static_cast<vtkIdType>(all.size());
    this->Ids->SetNumberOfIds(own);
    std::iota(this->Ids->begin(), this->Ids->end(), vtkIdType(0));
    for (size_t i = 0; i < all.size(); ++i)
    {
      if (all[i].Ends[0] >= own)
      {
        continue;
      }
      // Values of other processes' points are not here.
      vtkPointSplatEstimation::FillPoint point{ 0, { 0, 0, 0 }, { 0, 0, 0 } };
      float sum = 0;
      for (int k = 0; k < all[i].Count; ++k)
      {
        if (all[i].Ends[k] < own)
        {
          point.Ends[point.Count] = all[i].Ends[k];
          point.Weights[point.Count++] = all[i].Weights[k];
          sum += all[i].Weights[k];
        }
      }
      std::for_each(point.Weights, point.Weights + 3, [sum](float& weight) { weight /= sum; });
      const vtkIdType id = first + static_cast<vtkIdType>(i);
      this->Points.push_back(point);
      this->Places->InsertNextPoint(estimated->GetPoint(id));
      this->Ids->InsertNextId(id);
    }
  }

  /// Of what was estimated, what is of the process' own points and these.
  vtkSmartPointer<vtkDataArray> Keep(vtkDataArray* found) const
  {
    vtkSmartPointer<vtkDataArray> kept;
    kept.TakeReference(found->NewInstance());
    kept->SetName(found->GetName());
    kept->SetNumberOfComponents(found->GetNumberOfComponents());
    kept->SetNumberOfTuples(this->Ids->GetNumberOfIds());
    found->GetTuples(this->Ids, kept);
    return kept;
  }

  List Points;
  vtkNew<vtkPoints> Places;

private:
  vtkNew<vtkIdList> Ids;
};

/// Arrays that one process has and another has not would be lost where they meet.
void AddWhereAnyHas(
  vtkMultiProcessController* controller, const char* name, vtkIdType count, vtkPointData* data)
{
  int own = data->GetArray(name) ? 1 : 0;
  int any = 0;
  controller->AllReduce(&own, &any, 1, vtkCommunicator::MAX_OP);
  if (any && !own)
  {
    vtkNew<vtkFloatArray> none;
    none->SetName(name);
    none->SetNumberOfComponents(6);
    none->SetNumberOfTuples(count);
    none->Fill(0.0);
    data->AddArray(none);
  }
}
}

vtkStandardNewMacro(vtkPVPointSplatEstimation);

//------------------------------------------------------------------------------
int vtkPVPointSplatEstimation::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (vtkPVPointSplatBorders::GetProcesses())
  {
    // Otherwise the pipeline would go through leaves, of which each process has others.
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVPointSplatEstimation::FillOutputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillOutputPortInformation(port, info);
  if (vtkPVPointSplatBorders::GetProcesses())
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkPVPointSplatEstimation::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  auto tree = vtkDataObjectTree::GetData(inputs[0], 0);
  const char* wanted = tree ? tree->GetClassName() : "vtkPolyData";
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  if (!output || !output->IsA(wanted))
  {
    vtkSmartPointer<vtkDataObject> made;
    tree ? made.TakeReference(tree->NewInstance()) : made.TakeReference(vtkPolyData::New());
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVPointSplatEstimation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkMultiProcessController* controller = vtkPVPointSplatBorders::GetProcesses();
  if (!controller)
  {
    return this->Superclass::RequestData(request, inputs, outputs);
  }
  auto tree = vtkDataObjectTree::GetData(inputs[0], 0);
  if (!tree)
  {
    this->EstimateTogether(vtkPointSet::GetData(inputs[0], 0), vtkPolyData::GetData(outputs, 0));
    return 1;
  }
  auto output = vtkDataObjectTree::GetData(outputs, 0);
  output->CopyStructure(tree);
  output->GetFieldData()->PassData(tree->GetFieldData());
  const std::vector<unsigned char> filled = vtkPVPointSplatBorders::FindLeaves(controller, tree);
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(tree->NewTreeIterator());
  it->InitTraversal();
  vtkNew<vtkPolyData> none;
  for (unsigned int index = 0; index < filled.size(); ++index)
  {
    if (!filled[index])
    {
      continue;
    }
    const bool own = !it->IsDoneWithTraversal() && it->GetCurrentFlatIndex() == index;
    auto leaf = own ? vtkPointSet::SafeDownCast(it->GetCurrentDataObject()) : nullptr;
    vtkNew<vtkPolyData> estimated;
    this->EstimateTogether(leaf ? leaf : none, estimated);
    if (leaf)
    {
      output->SetDataSet(it, estimated);
    }
    if (own)
    {
      it->GoToNextItem();
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVPointSplatEstimation::EstimateAlone(vtkPointSet* input, vtkPolyData* output)
{
  vtkNew<vtkInformation> in;
  in->Set(vtkDataObject::DATA_OBJECT(), input);
  vtkNew<vtkInformation> out;
  out->Set(vtkDataObject::DATA_OBJECT(), output);
  vtkNew<vtkInformationVector> input0;
  input0->Append(in);
  vtkNew<vtkInformationVector> outputs;
  outputs->Append(out);
  vtkInformationVector* inputs[] = { input0 };
  this->Superclass::RequestData(nullptr, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPVPointSplatEstimation::EstimateTogether(vtkPointSet* input, vtkPolyData* output)
{
  vtkMultiProcessController* controller = vtkPVPointSplatBorders::GetProcesses();
  const vtkIdType count = input->GetNumberOfPoints();
  vtkDataArray* given = input->GetPointData()->GetNormals();
  if (given && given->GetNumberOfTuples() != count)
  {
    vtkErrorMacro("The point normals have " << given->GetNumberOfTuples() << " tuples for " << count
                                            << " points; they are estimated instead.");
    given = nullptr;
  }
  std::string error;
  const vtkPointSplatSensors sensors(input, error);
  if (!error.empty() && !given && this->GetOrientation() == Consistent)
  {
    vtkErrorMacro(<< error);
  }
  // Which arrays travel is one answer for all.
  const int own[] = { IsMesh(input), given != nullptr, !sensors.IsEmpty() };
  int any[] = { 0, 0, 0 };
  controller->AllReduce(own, any, 3, vtkCommunicator::MAX_OP);
  if (any[0])
  {
    this->EstimateAlone(input, output);
    return;
  }
  const vtkSmartPointer<vtkPolyData> points = MakeVertices(input);
  points->GetPointData()->AddArray(MakeGhosts(input));
  if (any[1])
  {
    points->GetPointData()->SetNormals(MakeNormals(given, count));
  }
  if (any[2])
  {
    points->GetPointData()->AddArray(MakeSensors(sensors, count));
  }
  const std::vector<vtkBoundingBox> boxes =
    vtkPVPointSplatBorders::Gather(controller, vtkPVPointSplatBorders::FindBox(points));
  const vtkPVPointSplatBorders::Reach reach =
    vtkPVPointSplatBorders::FindReach(controller, points, this->GetNumberOfNeighbors());
  const auto exchange = [&]() {
    return vtkPVPointSplatBorders::Exchange(controller, points, boxes, reach);
  };
  const vtkSmartPointer<vtkPolyData> all = exchange();
  vtkNew<vtkPolyData> estimated;
  this->EstimateAlone(all, estimated);
  vtkPointData* found = estimated->GetPointData();
  for (const char* name : { vtkPointSplatArrays::Clip, vtkPointSplatArrays::Fold })
  {
    AddWhereAnyHas(controller, name, estimated->GetNumberOfPoints(), found);
  }
  // If any was aborted all leave orientation as it is.
  int finished = estimated->GetNumberOfPoints() >= count ? 1 : 0;
  int allFinished = 0;
  controller->AllReduce(&finished, &allFinished, 1, vtkCommunicator::MIN_OP);
  if (allFinished && this->GetOrientation() == Consistent && !any[1] && !any[2])
  {
    const vtkPVPointSplatOrientation orientation(this, all, found->GetNormals(), count);
    orientation.AddTo(points, controller->GetLocalProcessId());
    Turn(orientation.FindTurned(controller, exchange()), this->GetFillPoints(), found);
  }
  if (!finished)
  {
    return;
  }

  output->GetFieldData()->PassData(input->GetFieldData());
  const OwnFill fill(this->GetFillPoints(), count, estimated);
  if (fill.Points.empty())
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->PassData(input->GetPointData());
  }
  else
  {
    vtkPointSplatEstimation::AppendFillPoints(input, fill.Places, fill.Points, output);
  }
  vtkPointData* data = output->GetPointData();
  if (vtkDataArray* normals = found->GetNormals())
  {
    const vtkSmartPointer<vtkDataArray> own = fill.Keep(normals);
    own->SetName(given && given->GetName() ? given->GetName() : "Normals");
    data->SetNormals(own);
  }
  for (const char* name : { vtkPointSplatArrays::Radius, vtkPointSplatArrays::Axis1,
         vtkPointSplatArrays::Axis2, vtkPointSplatArrays::PlaneNormal,
         vtkPointSplatArrays::Curvature, vtkPointSplatArrays::Clip, vtkPointSplatArrays::Fold })
  {
    data->RemoveArray(name);
    if (vtkDataArray* array = found->GetArray(name))
    {
      data->AddArray(fill.Keep(array));
    }
  }
  this->SetFillPoints(fill.Points);
}
