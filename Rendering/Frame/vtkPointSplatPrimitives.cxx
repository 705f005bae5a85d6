// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPrimitives.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatCells.h"
#include "vtkPointSplatPacking.h"
#include "vtkPointSplatScalars.h"
#include "vtkPointSplattingConfigure.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#if PointSplatting_HAVE_COMPOSITE_DELEGATOR
#include "vtkCompositePolyDataMapper.h"
using vtkPointSplatCompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using vtkPointSplatCompositeMapper = vtkCompositePolyDataMapper2;
#endif
#include "vtkOpenGLPolyDataMapper.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
/// Of the cells that selections are to name.
const char* const CellIds = "PointSplatCellIds";

/// Calls f(data set, iterator or null) for each block.
template <typename F>
void ForEachBlock(vtkDataObject* data, F f)
{
  if (auto composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      f(vtkPointSet::SafeDownCast(it->GetCurrentDataObject()), it.Get());
    }
  }
  else
  {
    f(vtkPointSet::SafeDownCast(data), static_cast<vtkCompositeDataIterator*>(nullptr));
  }
}

/// Of all blocks: a composite data set's own time tells nothing of them.
vtkMTimeType TimeOf(vtkDataObject* data)
{
  vtkMTimeType time = data->GetMTime();
  ForEachBlock(data, [&time](vtkPointSet* block, vtkCompositeDataIterator*) {
    time = block ? std::max(time, block->GetMTime()) : time;
  });
  return time;
}

bool AreGood(vtkCellArray* cells, vtkIdType points)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; cells && c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellAtId(c, ids);
    if (!vtkPointSplatCells::ArePoints(ids->GetPointer(0), ids->GetNumberOfIds(), points))
    {
      return false;
    }
  }
  return true;
}

bool CanBeDrawn(vtkPointSet* data)
{
  auto mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh || mesh->GetNumberOfCells() == 0 || !vtkPointSplatCells::CanBeRead(data))
  {
    return false;
  }
  vtkCellArray* const all[] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  return std::all_of(std::begin(all), std::end(all), [mesh](vtkCellArray* cells) {
    return AreGood(cells, mesh->GetNumberOfPoints());
  });
}

/// The points that become vertices.
std::vector<vtkIdType> VerticesOf(vtkPointSet* data, const std::vector<vtkIdType>& cellOf)
{
  std::vector<vtkIdType> vertices;
  vtkUnsignedCharArray* ghosts = vtkPointSplatPacking::GivenGhostsOf(data);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    const bool ghost = ghosts &&
      (ghosts->GetValue(i) &
        (vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT));
    if (!ghost && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) &&
      (cellOf.empty() || cellOf[static_cast<size_t>(i)] >= 0))
    {
      vertices.push_back(i);
    }
  }
  return vertices;
}

/// VTK reads as many tuples as there are points or cells.
void RemoveShort(vtkDataSetAttributes* arrays, vtkIdType count)
{
  for (int a = arrays->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    if (arrays->GetAbstractArray(a)->GetNumberOfTuples() < count)
    {
      arrays->RemoveArray(a);
    }
  }
}

vtkSmartPointer<vtkPolyData> MakePrimitives(vtkPointSet* data)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  if (CanBeDrawn(data))
  {
    made->ShallowCopy(data);
    RemoveShort(made->GetPointData(), made->GetNumberOfPoints());
    RemoveShort(made->GetCellData(), made->GetNumberOfCells());
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName(CellIds);
    for (vtkIdType c = 0; c < made->GetNumberOfCells(); ++c)
    {
      ids->InsertNextValue(c);
    }
    made->GetCellData()->AddArray(ids);
    return made;
  }
  const bool cells = data->GetNumberOfCells() > 0 && vtkPointSplatCells::CanBeRead(data);
  const std::vector<vtkIdType> cellOf =
    cells ? vtkPointSplatPacking::CellsOfPoints(data) : std::vector<vtkIdType>();
  made->SetPoints(data->GetPoints());
  made->GetPointData()->ShallowCopy(data->GetPointData());
  RemoveShort(made->GetPointData(), made->GetNumberOfPoints());
  made->GetFieldData()->ShallowCopy(data->GetFieldData());
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(CellIds);
  vtkCellData* cellData = made->GetCellData();
  vtkNew<vtkCellData> given;
  if (cells)
  {
    given->ShallowCopy(data->GetCellData());
    RemoveShort(given, data->GetNumberOfCells());
    cellData->CopyAllOn();
    cellData->CopyAllocate(given);
  }
  for (const vtkIdType point : VerticesOf(data, cellOf))
  {
    const vtkIdType cell = cells ? cellOf[static_cast<size_t>(point)] : point;
    const vtkIdType vertex = verts->InsertNextCell(1, &point);
    ids->InsertNextValue(cell);
    if (cells)
    {
      cellData->CopyData(given, cell, vertex);
    }
  }
  made->SetVerts(verts);
  cellData->AddArray(ids);
  return made;
}

vtkSmartPointer<vtkPolyDataMapper> NewMapper(bool composite)
{
  if (composite)
  {
    auto mapper = vtkSmartPointer<vtkPointSplatCompositeMapper>::New();
    mapper->SetCellIdArrayName(CellIds);
    return mapper;
  }
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  if (auto own = vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    own->SetCellIdArrayName(CellIds);
  }
  return mapper;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatPrimitives::AreShown(vtkActor* actor)
{
  return actor->GetProperty()->GetRepresentation() != VTK_SURFACE;
}

//------------------------------------------------------------------------------
void vtkPointSplatPrimitives::SetInput(vtkDataObject* data)
{
  auto composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!this->Mapper || this->IsComposite != (composite != nullptr))
  {
    this->IsComposite = composite != nullptr;
    this->Mapper = NewMapper(this->IsComposite);
    this->SettingsTime = 0;
  }
  vtkSmartPointer<vtkDataObject> made;
  if (composite)
  {
    vtkSmartPointer<vtkCompositeDataSet> copy;
    copy.TakeReference(composite->NewInstance());
    copy->CopyStructure(composite);
    ForEachBlock(data, [&copy](vtkPointSet* block, vtkCompositeDataIterator* it) {
      if (block)
      {
        copy->SetDataSet(it, MakePrimitives(block));
      }
    });
    made = copy;
  }
  else
  {
    made = MakePrimitives(vtkPointSet::SafeDownCast(data));
  }
  this->Mapper->SetInputDataObject(made);
}

//------------------------------------------------------------------------------
void vtkPointSplatPrimitives::Render(
  vtkPolyDataMapper* settings, vtkDataObject* data, vtkRenderer* renderer, vtkActor* actor)
{
  const vtkMTimeType time = TimeOf(data);
  if (!this->Mapper || data != this->Data || time != this->DataTime)
  {
    this->SetInput(data);
    this->Data = data;
    this->DataTime = time;
    this->SettingsTime = 0; // whether there can be colours follows from both
  }
  if (settings->GetMTime() != this->SettingsTime)
  {
    // Without vtkPolyDataMapper's own, which would take the input too.
    this->Mapper->vtkMapper::ShallowCopy(settings);
    this->Mapper->SetSeamlessU(settings->GetSeamlessU());
    this->Mapper->SetSeamlessV(settings->GetSeamlessV());
    ForEachBlock(data, [this, settings](vtkPointSet* block, vtkCompositeDataIterator*) {
      if (block && !vtkPointSplatScalars(settings, block).CanBeColours)
      {
        this->Mapper->ScalarVisibilityOff();
      }
    });
    this->SettingsTime = settings->GetMTime();
  }
  this->Mapper->Render(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkPointSplatPrimitives::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& offsets, vtkProp* prop)
{
  if (this->Mapper)
  {
    this->Mapper->ProcessSelectorPixelBuffers(selector, offsets, prop);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatPrimitives::Release(vtkWindow* window)
{
  if (this->Mapper)
  {
    this->Mapper->ReleaseGraphicsResources(window);
  }
}
