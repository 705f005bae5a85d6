// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: its buffers in OpenGL contexts.
#include "vtkPointSplatCloud.h"

#include "vtkPointSet.h"
#include "vtkPointSplatCoordinates.h"
#include "vtkPointSplatPacking.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>

namespace
{
constexpr size_t MostWords = size_t(1) << 29;
}

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
vtkPointSplatCloud::Buffers& vtkPointSplatCloud::UploadRuns(
  const std::shared_ptr<const vtkPointSplatRuns>& runs, const IdKind* ids)
{
  Buffers& buffers = this->GetRunBuffers();
  const bool anew = buffers.Runs != runs || this->GetMTime() > buffers.RunTime;
  if (anew)
  {
    buffers.Runs = runs;
    buffers.Resident = runs->Runs;
    uint32_t first = 0;
    for (vtkPointSplatRuns::Run& run : buffers.Resident)
    {
      run.First = first;
      first += run.Count;
    }
    this->UploadSome(this->Splats, this->GetWordsPerSplat(), buffers, buffers.Splats);
    this->UploadSome(this->ClipLines, 4, buffers, buffers.ClipLines);
    this->UploadSome(this->Colours, 1, buffers, buffers.Colours);
    this->UploadSome(this->Factors, 1, buffers, buffers.Factors);
    this->UploadSome(this->Coordinates, vtkPointSplatCoordinates::Words, buffers, buffers.Coordinates);
    this->UploadSome(this->Tangents, 1, buffers, buffers.Tangents);
    buffers.ValueTable.Upload(this->ValueTable);
    buffers.RunTime.Modified();
  }
  if (ids && (anew || buffers.IdTime < buffers.RunTime || buffers.IdsAre != *ids))
  {
    this->UploadSome(this->MakeIds(*ids), 1, buffers, buffers.Ids);
    buffers.IdsAre = *ids;
    buffers.IdTime.Modified();
  }
  return buffers;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::UploadSome(const std::vector<uint32_t>& data, size_t words,
  const Buffers& buffers, vtkPointSplatBuffer& to)
{
  if (data.empty() || buffers.Resident.empty())
  {
    to.Upload(nullptr, 0);
    return;
  }
  const vtkPointSplatRuns::Run& last = buffers.Resident.back();
  const size_t size = std::min(words * (size_t(last.First) + last.Count), MostWords);
  const GLsizeiptr bytes = static_cast<GLsizeiptr>(sizeof(uint32_t) * size);
  to.Reserve(bytes);
  // All threads put them where the driver fetches them: a copy by one would take most of a frame.
  auto some = static_cast<uint32_t*>(to.Map(bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT));
  if (!some)
  {
    to.Fill(0, bytes, 0u); // out of memory: splats of no size
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(buffers.Resident.size()), 256, [&](vtkIdType begin, vtkIdType end) {
    for (size_t i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
    {
      const size_t from = words * buffers.Runs->Runs[i].First;
      const size_t at = words * buffers.Resident[i].First;
      // Splats of levels have no ids.
      const size_t count = std::min({ words * buffers.Resident[i].Count,
        data.size() - std::min(from, data.size()), size - std::min(at, size) });
      std::copy_n(data.begin() + static_cast<std::ptrdiff_t>(std::min(from, data.size())), count,
        some + std::min(at, size));
    }
  });
  to.Unmap();
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
