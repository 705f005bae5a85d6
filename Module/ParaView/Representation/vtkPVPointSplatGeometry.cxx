// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVPointSplatGeometry.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVPointSplatBorders.h"
#include "vtkPVPointSplatEstimation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
bool AreMany()
{
  return vtkPVPointSplatBorders::GetProcesses() != nullptr;
}

template <typename Array, typename Value>
void AddConstant(vtkFieldData* data, const char* name, Value value, vtkIdType count)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(count);
  array->Fill(static_cast<double>(value));
  data->AddArray(array);
}

/// The points of a data set, and its own where it has such.
vtkSmartPointer<vtkPoints> PointsOf(vtkDataSet* data)
{
  if (auto set = vtkPointSet::SafeDownCast(data))
  {
    return set->GetPoints();
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double position[3];
    data->GetPoint(i, position);
    points->SetPoint(i, position);
  }
  return points;
}

/// Of each point the cell of least id, or -1.
std::vector<vtkIdType> CellsOf(vtkDataSet* data)
{
  std::vector<vtkIdType> cells(static_cast<size_t>(data->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = data->GetNumberOfCells() - 1; cell >= 0; --cell)
  {
    data->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      cells[static_cast<size_t>(ids->GetId(i))] = cell;
    }
  }
  return cells;
}

/// Every point that is not left out, as a vertex with the data of its cell. Where there are cells,
/// points that none of them uses are left out, as Surface leaves them out.
void MakeVertices(vtkDataSet* input, bool withoutCopies, vtkPolyData* output)
{
  const vtkSmartPointer<vtkPoints> from = PointsOf(input);
  vtkUnsignedCharArray* ghosts = withoutCopies ? input->GetPointGhostArray() : nullptr;
  const std::vector<vtkIdType> cellOf = CellsOf(input);
  const bool anyCell = input->GetNumberOfCells() > 0;
  vtkNew<vtkIdList> kept;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const bool copy = ghosts && (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT);
    const bool unused = anyCell && cellOf[static_cast<size_t>(i)] < 0;
    if (!copy && !unused)
    {
      kept->InsertNextId(i);
    }
  }
  const vtkIdType count = kept->GetNumberOfIds();
  vtkNew<vtkPoints> points;
  points->SetDataType(from->GetDataType());
  points->SetNumberOfPoints(count);
  from->GetPoints(kept, points);
  output->SetPoints(points);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(input->GetPointData(), count);
  output->GetPointData()->CopyData(input->GetPointData(), kept);
  output->GetFieldData()->ShallowCopy(input->GetFieldData());

  vtkNew<vtkIdTypeArray> pointIds;
  vtkNew<vtkIdTypeArray> cellIds;
  pointIds->SetName("vtkOriginalPointIds");
  cellIds->SetName("vtkOriginalCellIds");
  pointIds->SetNumberOfTuples(count);
  cellIds->SetNumberOfTuples(count);
  vtkCellData* cells = output->GetCellData();
  cells->CopyAllOn();
  cells->CopyAllocate(input->GetCellData(), count);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->InsertNextCell(1, &i);
    const vtkIdType cell = cellOf[static_cast<size_t>(kept->GetId(i))];
    pointIds->SetValue(i, kept->GetId(i));
    cellIds->SetValue(i, std::max<vtkIdType>(cell, 0));
    if (cell >= 0)
    {
      cells->CopyData(input->GetCellData(), cell, i);
      continue;
    }
    for (int a = 0; a < cells->GetNumberOfArrays(); ++a)
    {
      if (vtkDataArray* array = cells->GetArray(a))
      {
        const bool real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
        const std::vector<double> none(
          static_cast<size_t>(array->GetNumberOfComponents()), real ? vtkMath::Nan() : 0.0);
        array->InsertTuple(i, none.data());
      }
    }
  }
  output->SetVerts(vertices);
  cells->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  output->GetPointData()->AddArray(pointIds);
  cells->AddArray(cellIds);
}

template <typename Array>
void AddCounted(vtkFieldData* data, const char* name, vtkIdType count)
{
  if (!data->GetAbstractArray(name))
  {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->SetValue(i, i);
    }
    data->AddArray(array);
  }
}

/// Makes one data set of the children that are, in the place of the first.
void Merge(vtkDataObjectTree* pieces)
{
  vtkNew<vtkAppendPolyData> append;
  std::vector<vtkSmartPointer<vtkPolyData>> leaves;
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(pieces->NewTreeIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto leaf = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    AddCounted<vtkIdTypeArray>(
      leaf->GetPointData(), "vtkOriginalPointIds", leaf->GetNumberOfPoints());
    AddCounted<vtkIdTypeArray>(
      leaf->GetCellData(), "vtkOriginalCellIds", leaf->GetNumberOfCells());
    append->AddInputData(leaf);
    leaves.emplace_back(leaf);
  }
  if (leaves.size() > 1)
  {
    append->Update();
    append->GetOutput()->GetFieldData()->ShallowCopy(leaves[0]->GetFieldData());
    leaves[0] = append->GetOutput();
  }
  vtkDataObject* all = leaves.empty() ? nullptr : leaves[0].Get();
  if (auto set = vtkPartitionedDataSet::SafeDownCast(pieces))
  {
    set->SetNumberOfPartitions(1);
    set->SetPartition(0, all);
  }
  else if (auto blocks = vtkMultiBlockDataSet::SafeDownCast(pieces))
  {
    blocks->SetNumberOfBlocks(1);
    blocks->SetBlock(0, all);
  }
}

/// Pieces of one surface are to be one data set, else each ends where the next begins.
void MergePieces(bool all, vtkDataObjectTree* tree)
{
  if (all)
  {
    Merge(tree);
    return;
  }
  std::vector<vtkDataObjectTree*> sets;
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(tree->NewTreeIterator());
  it->VisitOnlyLeavesOff();
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (auto set = vtkPartitionedDataSet::SafeDownCast(it->GetCurrentDataObject()))
    {
      sets.push_back(set);
    }
  }
  std::for_each(sets.begin(), sets.end(), Merge);
}

/// Points are vertices here, with cell data of their own, and so fill points are, too.
void AddVertices(
  const std::vector<vtkPointSplatEstimation::FillPoint>& fill, vtkPolyData* points)
{
  vtkNew<vtkCellArray> vertices;
  vertices->DeepCopy(points->GetVerts());
  for (size_t i = 0; i < fill.size(); ++i)
  {
    const vtkIdType id = points->GetNumberOfPoints() + static_cast<vtkIdType>(i);
    vertices->InsertNextCell(1, &id);
  }
  points->SetVerts(vertices);
  vtkCellData* data = points->GetCellData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    // Of the same name, it takes the other's place, and what attribute that is.
    data->AddArray(vtkPointSplatEstimation::WithFillPoints(data->GetAbstractArray(i), fill));
  }
}

bool HasSizes(vtkPolyData* points)
{
  vtkPointData* data = points->GetPointData();
  return data->GetNormals() &&
    (data->GetArray(vtkPointSplatArrays::Radius) ||
      (data->GetArray(vtkPointSplatArrays::Axis1) && data->GetArray(vtkPointSplatArrays::Axis2)));
}
}

vtkStandardNewMacro(vtkPVPointSplatGeometry);

//------------------------------------------------------------------------------
void vtkPVPointSplatGeometry::SetSizeArray(const std::string& name)
{
  if (name != this->SizeArray)
  {
    this->SizeArray = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkPVPointSplatGeometry::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVPointSplatGeometry::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const bool tree = vtkDataObjectTree::GetData(inputs[0], 0) != nullptr;
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  if (!output || output->IsA("vtkMultiBlockDataSet") != (tree ? 1 : 0))
  {
    vtkSmartPointer<vtkDataObject> made;
    tree ? made.TakeReference(vtkMultiBlockDataSet::New()) : made.TakeReference(vtkPolyData::New());
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVPointSplatGeometry::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (auto tree = vtkDataObjectTree::GetData(inputs[0], 0))
  {
    this->MakeTree(tree, vtkDataObjectTree::GetData(outputs, 0));
    return 1;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  this->MakePoints(vtkDataSet::GetData(inputs[0], 0), 0, output);
  this->Estimate(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVPointSplatGeometry::MakePoints(vtkDataSet* input, unsigned int index, vtkPolyData* output)
{
  auto mesh = vtkPolyData::SafeDownCast(input);
  if (input->GetNumberOfPoints() == 0)
  {
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    return;
  }
  mesh && !AreMany() ? output->ShallowCopy(mesh) : MakeVertices(input, AreMany(), output);
  vtkPointData* data = output->GetPointData();
  const vtkIdType count = output->GetNumberOfPoints();
  if (AreMany())
  {
    AddConstant<vtkUnsignedIntArray>(data, "vtkProcessId",
      vtkPVPointSplatBorders::GetProcesses()->GetLocalProcessId(), count);
  }
  if (index > 0)
  {
    AddConstant<vtkUnsignedIntArray>(data, "vtkCompositeIndex", index, count);
  }
  vtkDataArray* sizes = this->SizeArray.empty() ? nullptr : data->GetArray(this->SizeArray.c_str());
  if (sizes)
  {
    vtkNew<vtkFloatArray> radii;
    radii->SetName(vtkPointSplatArrays::Radius);
    radii->SetNumberOfTuples(count);
    std::vector<double> tuple(static_cast<size_t>(sizes->GetNumberOfComponents()));
    for (vtkIdType i = 0; i < count; ++i)
    {
      sizes->GetTuple(i, tuple.data());
      double squared = 0.0;
      for (const double component : tuple)
      {
        squared += component * component;
      }
      radii->SetValue(i, static_cast<float>(std::sqrt(squared)));
    }
    data->RemoveArray(vtkPointSplatArrays::Curvature); // it belongs to other sizes
    data->AddArray(radii);
  }
}

//------------------------------------------------------------------------------
void vtkPVPointSplatGeometry::MakeTree(vtkDataObjectTree* input, vtkDataObjectTree* output)
{
  output->CopyStructure(input);
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(input->NewTreeIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto block = vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
    if (!block)
    {
      continue;
    }
    vtkNew<vtkPolyData> points;
    this->MakePoints(block, it->GetCurrentFlatIndex(), points);
    if (points->GetNumberOfPoints() > 0)
    {
      output->SetDataSet(it, points);
    }
  }
  MergePieces(vtkPartitionedDataSet::SafeDownCast(input) != nullptr, output);
  const std::vector<unsigned char> filled =
    vtkPVPointSplatBorders::FindLeaves(vtkPVPointSplatBorders::GetProcesses(), output);
  it.TakeReference(output->NewTreeIterator());
  it->SkipEmptyNodesOff();
  unsigned int block = 0;
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem(), ++block)
  {
    const size_t index = it->GetCurrentFlatIndex();
    if (index >= filled.size() || !filled[index])
    {
      continue;
    }
    auto points = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    if (!points)
    {
      vtkNew<vtkPolyData> empty;
      output->SetDataSet(it, empty);
      points = empty;
    }
    this->Estimate(points);
    AddConstant<vtkUnsignedIntArray>(points->GetFieldData(), "vtkBlockColors",
      block % static_cast<unsigned int>(this->BlockColorsDistinctValues), 1);
  }
  if (block > 0)
  {
    // So that the array does not count as one of some blocks only.
    AddConstant<vtkUnsignedIntArray>(output->GetFieldData(), "vtkBlockColors", 0u, 1);
  }
}

//------------------------------------------------------------------------------
void vtkPVPointSplatGeometry::Estimate(vtkPolyData* points)
{
  if (!AreMany())
  {
    return;
  }
  int wanted = points->GetNumberOfPoints() > 0 && !HasSizes(points) ? 1 : 0;
  int any = 0;
  vtkPVPointSplatBorders::GetProcesses()->AllReduce(&wanted, &any, 1, vtkCommunicator::MAX_OP);
  if (!any)
  {
    return;
  }
  vtkNew<vtkPVPointSplatEstimation> estimation;
  estimation->SetInputData(points);
  estimation->SetFillGaps(this->FillGaps);
  estimation->Update();
  if (points->GetNumberOfPoints() == 0)
  {
    return;
  }
  points->GetPointData()->ShallowCopy(estimation->GetOutput()->GetPointData());
  const auto& fill = estimation->GetFillPoints();
  if (!fill.empty())
  {
    AddVertices(fill, points);
    points->SetPoints(estimation->GetOutput()->GetPoints());
  }
}

//------------------------------------------------------------------------------
void vtkPVPointSplatGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SizeArray: " << this->SizeArray << "\n";
  os << indent << "BlockColorsDistinctValues: " << this->BlockColorsDistinctValues << "\n";
  os << indent << "FillGaps: " << (this->FillGaps ? "On" : "Off") << "\n";
}
