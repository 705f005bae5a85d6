// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: buffers of the splats of a frame's own runs, where all are more than a buffer holds.
#include "vtkPointSplatCloud.h"

#include "vtkPointSplatCoordinates.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cstddef>
#include <vector>

//------------------------------------------------------------------------------
std::array<vtkPointSplatCloud::Array, 6> vtkPointSplatCloud::GetArrays(Buffers& buffers)
{
  auto& stores = buffers.Stores;
  return { { { this->Splats, this->GetWordsPerSplat(), this->SplatTime, buffers.Splats, stores[0] },
    { this->ClipLines, 4, this->SplatTime, buffers.ClipLines, stores[1] },
    { this->Colours, 1, this->ColourTime, buffers.Colours, stores[2] },
    { this->Factors, 1, this->FactorTime, buffers.Factors, stores[3] },
    { this->Coordinates, vtkPointSplatCoordinates::Words, this->CoordinateTime, buffers.Coordinates,
      stores[4] },
    { this->Tangents, 1, this->CoordinateTime, buffers.Tangents, stores[5] } } };
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::KeepOnDevice(Buffers& buffers)
{
  if (this->GetMTime() > buffers.StoreTime)
  {
    // Points that move would be brought there in each frame; those without levels get them soon.
    const bool stays = this->Levels.AreMade() && !this->Motion.HasBegun();
    const std::array<Array, 6> arrays = this->GetArrays(buffers);
    size_t bytes = 0; // of what is to be brought
    for (const Array& array : arrays)
    {
      bytes += array.Store.IsKept(array.Changed) ? 0 : sizeof(uint32_t) * array.Data.size();
    }
    const bool kept = stays && vtkPointSplatStore::CanKeep(bytes) &&
      std::all_of(arrays.begin(), arrays.end(),
        [](const Array& array) { return array.Store.Keep(array.Data, array.Words, array.Changed); });
    for (size_t i = 0; !kept && i < arrays.size(); ++i)
    {
      arrays[i].Store.Release();
    }
    buffers.StoreTime.Modified();
  }
  return buffers.Stores[0].IsKept();
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
    if (this->KeepOnDevice(buffers))
    {
      this->Gather(buffers);
    }
    else
    {
      for (const Array& array : this->GetArrays(buffers))
      {
        vtkPointSplatCloud::UploadSome(array.Data, array.Words, buffers, array.To);
      }
    }
    buffers.ValueTable.Upload(this->ValueTable);
    buffers.RunTime.Modified();
  }
  if (ids && (anew || buffers.IdTime < buffers.RunTime || buffers.IdsAre != *ids))
  {
    vtkPointSplatCloud::UploadSome(this->MakeIds(*ids), 1, buffers, buffers.Ids);
    buffers.IdsAre = *ids;
    buffers.IdTime.Modified();
  }
  return buffers;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Gather(Buffers& buffers)
{
  const size_t number = buffers.Resident.size();
  std::vector<glm::uvec4> table(number);
  for (size_t i = 0; i < number; ++i)
  {
    const vtkPointSplatRuns::Run& run = buffers.Resident[i];
    table[i] = { buffers.Runs->Runs[i].First, run.First, run.Count, 0u };
  }
  buffers.RunTable.Upload(table);
  const size_t splats = number > 0 ? size_t(table.back().y) + table.back().z : 0;
  for (const Array& array : this->GetArrays(buffers))
  {
    if (!array.Data.empty())
    {
      array.Store.Gather(buffers.RunTable, number, std::min(splats, MostWords / array.Words), array.To);
    }
  }
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
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(buffers.Resident.size()), 256, [&](vtkIdType begin, vtkIdType end) {
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

