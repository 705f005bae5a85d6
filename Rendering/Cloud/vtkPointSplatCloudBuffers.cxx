// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: its buffers in OpenGL contexts.
#include "vtkPointSplatCloud.h"

#include "vtkPointSet.h"
#include "vtkPointSplatCoordinates.h"
#include "vtkPointSplatPacking.h"

#include <algorithm>
#include <cstddef>

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatCloud::MakeIds(IdKind kind) const
{
  std::vector<uint32_t> ids(static_cast<size_t>(this->Count));
  for (const Block& block : this->Blocks)
  {
    // A cloud without cells: the cell id that VTK's selections carry is the point's.
    vtkPointSet* data = this->Whole ? this->Whole : block.Data;
    const bool cells = kind == CellIds && data->GetNumberOfCells() > 0;
    const std::vector<vtkIdType> cellOf =
      cells ? vtkPointSplatPacking::CellsOfPoints(data) : std::vector<vtkIdType>();
    for (vtkIdType k = block.First; k < block.First + block.Count; ++k)
    {
      const size_t i = this->SplatOf(k);
      const vtkIdType own = this->GetPointId(static_cast<vtkIdType>(i));
      const vtkIdType point = this->Whole ? (*this->WholeIds)[static_cast<size_t>(own)] : own;
      const vtkIdType id = kind == CompositeIds ? block.FlatIndex
        : cells                                 ? cellOf[static_cast<size_t>(point)]
                                                : point;
      ids[i] = id < 0 ? 0xffffffffu : static_cast<uint32_t>(id);
    }
  }
  return ids;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::Fits(vtkIdType splats) const
{
  return this->GetWordsPerSplat() * static_cast<size_t>(splats) < MostWords;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::AreStreamed() const
{
  return (this->Motion.HasBegun() && this->Levels.AreMade()) ||
    !this->Fits(this->GetNumberOfStoredSplats());
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Buffers& vtkPointSplatCloud::Find(ContextBuffers& all)
{
  const vtkPointSplatContext& context = vtkPointSplatContext::Entered();
  all.remove_if([](const auto& entry) { return !entry.first.IsAlive(); });
  auto found = std::find_if(
    all.begin(), all.end(), [&context](const auto& entry) { return entry.first == context; });
  if (found == all.end())
  {
    all.emplace_front();
    found = all.begin();
    found->first = context;
    found->second.VertexArray.Make();
  }
  return found->second;
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Buffers& vtkPointSplatCloud::Fill(ContextBuffers& all, bool grouped)
{
  Buffers& buffers = vtkPointSplatCloud::Find(all);
  this->MoveAll();
  const vtkMTimeType order = grouped ? this->Groups.GetMTime() : 0;
  // Where levels' splats do not fit, points alone.
  const size_t splats = static_cast<size_t>(
    this->Fits(this->GetNumberOfStoredSplats()) ? this->GetNumberOfStoredSplats() : this->Count);
  auto fill = [&](vtkPointSplatBuffer& buffer, vtkTimeStamp& filled, vtkMTimeType changed,
                const std::vector<uint32_t>& data, size_t words) {
    if (std::max(changed, order) > filled)
    {
      if (grouped)
      {
        buffer.Upload(this->Groups.Ordered(data, words));
      }
      else
      {
        const size_t held = std::min({ data.size(), words * splats, MostWords });
        buffer.Upload(data.data(), static_cast<GLsizeiptr>(sizeof(uint32_t) * held));
      }
      filled.Modified();
    }
  };
  fill(buffers.Splats, buffers.SplatTime, this->SplatTime, this->Splats, this->GetWordsPerSplat());
  fill(buffers.ClipLines, buffers.ClipLineTime, this->SplatTime, this->ClipLines, 4);
  fill(buffers.Colours, buffers.ColourTime, this->ColourTime, this->Colours, 1);
  if (this->ColourTime > buffers.ValueTime)
  {
    buffers.ValueTable.Upload(this->ValueTable);
    buffers.ValueTime.Modified();
  }
  fill(buffers.Factors, buffers.FactorTime, this->FactorTime, this->Factors, 1);
  if (!grouped)
  {
    fill(buffers.Coordinates, buffers.CoordinateTime, this->CoordinateTime, this->Coordinates,
      vtkPointSplatCoordinates::Words);
    fill(buffers.Tangents, buffers.TangentTime, this->CoordinateTime, this->Tangents, 1);
  }
  return buffers;
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Buffers& vtkPointSplatCloud::UploadIds(IdKind kind)
{
  Buffers& buffers = this->Upload();
  vtkMTimeType changed = this->OrderTime;
  for (const Block& block : this->Blocks)
  {
    changed = std::max( // of cells
      changed, this->Whole ? this->Whole->GetMTime() : block.Data->GetMTime());
  }
  if (changed > buffers.IdTime || buffers.IdsAre != kind)
  {
    buffers.Ids.Upload(this->MakeIds(kind));
    buffers.IdsAre = kind;
    buffers.IdTime.Modified();
  }
  return buffers;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Release(vtkOpenGLRenderWindow* window)
{
  auto belongs = [window](const auto& entry) { return entry.first.GetWindow() == window; };
  this->PerContext.remove_if(belongs);
  this->GroupedPerContext.remove_if(belongs);
  this->RunsPerContext.remove_if(belongs);
}
