// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVPointSplatMapper.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <map>

namespace
{
using Selector = vtkHardwareSelector;

/// The 24 bits that a pass's pixel has.
uint64_t Read(const unsigned char* buffer, unsigned int at)
{
  return buffer ? buffer[at] | buffer[at + 1] << 8 | buffer[at + 2] << 16 : 0u;
}

void Write(unsigned char* buffer, unsigned int at, uint64_t value)
{
  buffer[at] = static_cast<unsigned char>(value & 0xff);
  buffer[at + 1] = static_cast<unsigned char>(value >> 8 & 0xff);
  buffer[at + 2] = static_cast<unsigned char>(value >> 16 & 0xff);
}

std::map<uint64_t, vtkDataSet*> BlocksOf(vtkDataObject* input)
{
  std::map<uint64_t, vtkDataSet*> blocks;
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      blocks[it->GetCurrentFlatIndex()] = vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
    }
  }
  return blocks;
}
}

vtkStandardNewMacro(vtkPVPointSplatMapper);

//------------------------------------------------------------------------------
void vtkPVPointSplatMapper::SetIdArrays(const std::string& ofPoints, const std::string& ofCells)
{
  this->PointIdArray = ofPoints;
  this->CellIdArray = ofCells;
}

//------------------------------------------------------------------------------
void vtkPVPointSplatMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop)
{
  this->Superclass::ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
  const int pass = selector->GetCurrentPass();
  const bool ofCells = pass == Selector::CELL_ID_LOW24 || pass == Selector::CELL_ID_HIGH24;
  const bool high = pass == Selector::POINT_ID_HIGH24 || pass == Selector::CELL_ID_HIGH24;
  const char* name = ofCells ? this->CellIdArray.c_str()
    : pass == Selector::POINT_ID_LOW24 || pass == Selector::POINT_ID_HIGH24
    ? this->PointIdArray.c_str()
    : pass == Selector::COMPOSITE_INDEX_PASS ? "vtkCompositeIndex"
    : pass == Selector::PROCESS_PASS ? "vtkProcessId"
                                     : nullptr;
  unsigned char* written = name ? selector->GetPixelBuffer(pass) : nullptr;
  const unsigned char* lows =
    selector->GetRawPixelBuffer(ofCells ? Selector::CELL_ID_LOW24 : Selector::POINT_ID_LOW24);
  const unsigned char* highs =
    selector->GetRawPixelBuffer(ofCells ? Selector::CELL_ID_HIGH24 : Selector::POINT_ID_HIGH24);
  const unsigned char* indices = selector->GetRawPixelBuffer(Selector::COMPOSITE_INDEX_PASS);
  if (!written || !lows || !indices)
  {
    return; // the pass comes again when all are there
  }
  const std::map<uint64_t, vtkDataSet*> blocks = BlocksOf(this->GetInputDataObject(0, 0));
  for (const unsigned int at : pixelOffsets)
  {
    const auto block = blocks.find(Read(indices, at));
    if (block == blocks.end() || !block->second)
    {
      continue;
    }
    vtkDataSetAttributes* data = block->second->GetPointData();
    if (ofCells)
    {
      data = block->second->GetCellData();
    }
    vtkDataArray* array = data->GetArray(name);
    const auto id = static_cast<vtkIdType>(Read(highs, at) << 24 | Read(lows, at));
    if (!array || id >= array->GetNumberOfTuples())
    {
      continue;
    }
    auto value = static_cast<uint64_t>(array->GetComponent(id, 0));
    value += pass == Selector::PROCESS_PASS ? 1 : 0; // as the selector has it, 0 is none
    Write(written, at, high ? value >> 24 : value);
  }
}

//------------------------------------------------------------------------------
void vtkPVPointSplatMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PointIdArray: " << this->PointIdArray << "\n";
  os << indent << "CellIdArray: " << this->CellIdArray << "\n";
}
