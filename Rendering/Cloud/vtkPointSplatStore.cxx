// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatStore.h"

#include <algorithm>

namespace
{

/// Whether memory ran out since errors were asked for last.
bool IsOutOfMemory()
{
  constexpr int mostErrors = 16; // a lost context may give them for ever
  bool found = false;
  for (int i = 0; i < mostErrors; ++i)
  {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR)
    {
      break;
    }
    found = found || error == GL_OUT_OF_MEMORY;
  }
  return found;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatStore::CanKeep(size_t bytes)
{
  return vtkPointSplatProgram::IsComputeSupported() && 2 * bytes <= vtkPointSplatContext::GetFreeMemory();
}

//------------------------------------------------------------------------------
bool vtkPointSplatStore::Keep(const std::vector<uint32_t>& data, size_t words, vtkMTimeType changed)
{
  if (this->IsKept(changed))
  {
    return true;
  }
  this->Release();
  if (!this->Program.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatGatherCS" } }))
  {
    return false;
  }
  GLint most = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  this->Words = words;
  this->Splats = data.size() / words;
  this->PerPart = std::min(this->PartBytes, static_cast<size_t>(most)) / (sizeof(uint32_t) * words);
  IsOutOfMemory(); // for others, who did not ask
  for (size_t first = 0; first < this->Splats; first += this->PerPart)
  {
    this->Parts.emplace_back();
    const size_t count = std::min(this->PerPart, this->Splats - first);
    this->Parts.back().Upload(
      data.data() + words * first, static_cast<GLsizeiptr>(sizeof(uint32_t) * words * count));
  }
  if (IsOutOfMemory())
  {
    this->Release();
    return false;
  }
  this->Kept.Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatStore::Gather(
  const vtkPointSplatBuffer& runs, size_t numberOfRuns, size_t splats, vtkPointSplatBuffer& to)
{
  to.Reserve(static_cast<GLsizeiptr>(sizeof(uint32_t) * this->Words * splats));
  this->Program.Use();
  this->Program.Set("RunCount", static_cast<unsigned int>(numberOfRuns));
  this->Program.Set("WordsPerSplat", static_cast<unsigned int>(this->Words));
  this->Program.Set("Room", static_cast<unsigned int>(splats));
  to.BindStorage(2);
  runs.BindStorage(7);
  size_t first = 0;
  for (const vtkPointSplatBuffer& part : this->Parts)
  {
    const size_t count = std::min(this->PerPart, this->Splats - first);
    this->Program.Set("PartFirst", static_cast<unsigned int>(first));
    this->Program.Set("PartCount", static_cast<unsigned int>(count));
    part.BindStorage(1);
    vtkPointSplatProgram::Dispatch(static_cast<vtkIdType>(numberOfRuns) * vtkPointSplatProgram::GroupSize);
    first += count;
  }
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT); // quads take them as such
}

//------------------------------------------------------------------------------
void vtkPointSplatStore::Release()
{
  this->Parts.clear();
  this->Program.Release();
}
