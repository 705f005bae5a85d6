// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: its buffers in OpenGL contexts.
#include "vtkPointSplatCloud.h"

#include "vtkPointSet.h"
#include "vtkPointSplatCoordinates.h"
#include "vtkPointSplatPacking.h"

#include <algorithm>

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
    for (vtkIdType i = block.First; i < block.First + block.Count; ++i)
    {
      const vtkIdType own = this->GetPointId(i);
      const vtkIdType point = this->Whole ? (*this->WholeIds)[static_cast<size_t>(own)] : own;
      const vtkIdType id = kind == CompositeIds ? block.FlatIndex
        : cells                                 ? cellOf[static_cast<size_t>(point)]
                                                : point;
      ids[static_cast<size_t>(i)] = id < 0 ? 0xffffffffu : static_cast<uint32_t>(id);
    }
  }
  return ids;
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Buffers& vtkPointSplatCloud::Fill(ContextBuffers& all, Extent extent)
{
  const bool grouped = extent == GroupedSplats;
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
  Buffers& buffers = found->second;
  const vtkMTimeType order = grouped ? this->Groups.GetMTime() : 0;
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
        buffer.Upload(data);
      }
      filled.Modified();
    }
  };
  this->FillSplats(buffers, extent);
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
void vtkPointSplatCloud::FillSplats(Buffers& buffers, Extent extent)
{
  const size_t words = this->GetWordsPerSplat();
  const bool some = extent == MovedSplats && !this->AllMoved;
  if (!some)
  {
    this->MoveAll();
  }
  if (extent == GroupedSplats)
  {
    if (std::max(this->SplatTime.GetMTime(), this->Groups.GetMTime()) > buffers.SplatTime)
    {
      buffers.Splats.Upload(this->Groups.Ordered(this->Splats, words));
      buffers.ClipLines.Upload(this->Groups.Ordered(this->ClipLines, 4));
      buffers.SplatTime.Modified();
    }
    return;
  }
  const bool anew = this->SplatTime > buffers.SplatTime;
  if (!some && (anew || !buffers.Parts.empty()))
  {
    buffers.Splats.Upload(this->Splats);
    buffers.ClipLines.Upload(this->ClipLines);
    buffers.Parts.clear();
    buffers.SplatTime.Modified();
    return;
  }
  if (anew)
  {
    buffers.Splats.Reserve(static_cast<GLsizeiptr>(4 * this->Splats.size()));
    buffers.ClipLines.Reserve(static_cast<GLsizeiptr>(4 * this->ClipLines.size()));
    buffers.Parts.assign(this->Motion.GetNumberOfParts(), false);
    buffers.SplatTime.Modified();
  }
  // Parts that follow one another at once.
  for (size_t part = 0; part < buffers.Parts.size(); ++part)
  {
    const vtkPointSplatMotion::Part& first = this->Motion.GetPart(part);
    size_t count = 0;
    for (; part < buffers.Parts.size() && !buffers.Parts[part] && this->Motion.IsMoved(part) &&
         this->Motion.GetPart(part).First == first.First + count;
         ++part)
    {
      count += this->Motion.GetPart(part).Count;
      buffers.Parts[part] = true;
    }
    if (count > 0)
    {
      --part; // the one that ended the run may begin another
      buffers.Splats.Replace(words * first.First, this->Splats, words * count);
      if (!this->ClipLines.empty())
      {
        buffers.ClipLines.Replace(4 * size_t(first.First), this->ClipLines, 4 * count);
      }
    }
  }
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
}
