// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDeviceLists.h"

#include "vtkPointSplatUnits.h"

namespace
{
constexpr vtkIdType ScanSize = 256;  // as in vtkPointSplatScanCS.glsl
constexpr GLuint PartSize = 8 * 256; // likewise
constexpr vtkIdType SortSize = 32;   // as in vtkPointSplatSortListsCS.glsl
// Work groups that sort: more than a device runs at once.
constexpr vtkIdType SortGroups = 4096;
}

//------------------------------------------------------------------------------
std::array<vtkPointSplatDeviceLists::Stage, 6> vtkPointSplatDeviceLists::GetStages()
{
  return { { { &this->CountProgram, "vtkPointSplatBinCS", "" },
    { &this->PartsProgram, "vtkPointSplatScanCS", "#define PARTS\n" },
    { &this->SumsProgram, "vtkPointSplatScanCS", "#define SUMS\n" },
    { &this->ScanProgram, "vtkPointSplatScanCS", "" },
    { &this->FillProgram, "vtkPointSplatBinCS", "#define FILL\n" },
    { &this->SortProgram, "vtkPointSplatSortListsCS", "" } } };
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeviceLists::Build()
{
  this->Error.clear();
  for (const Stage& stage : this->GetStages())
  {
    if (!stage.Program->Build({ { GL_COMPUTE_SHADER, stage.File } }, stage.Defines))
    {
      this->Error += stage.Program->GetLog();
    }
  }
  return this->Error.empty();
}

//------------------------------------------------------------------------------
void vtkPointSplatDeviceLists::Run(
  vtkPointSplatProgram& program, const vtkPointSplatBuffer& boxes)
{
  program.Use();
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  units.Bind(program, "Boxes", GL_TEXTURE_BUFFER, boxes.GetTexture());
  program.Set("BoxCount", static_cast<unsigned int>(this->Splats));
  program.Set("TilesAcross", this->Grid.Tiles.x);
  program.Set("TileCount", this->Grid.GetCount());
  program.Set("KindCount", this->Kinds);
  this->Counts.BindStorage(0);
  vtkPointSplatProgram::Dispatch(static_cast<vtkIdType>(this->Splats));
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeviceLists::Count(const vtkPointSplatBuffer& boxes, size_t splats,
  const vtkPointSplatTileGrid& grid, bool triangles)
{
  if (!this->Build())
  {
    return false;
  }
  this->Grid = grid;
  this->Splats = splats;
  this->Kinds = triangles ? 4 : 3;
  const glm::ivec2 blocks = (grid.Tiles + 15) >> 4;
  this->ListCount = static_cast<GLuint>(this->Kinds * grid.GetCount() + blocks.x * blocks.y);
  const GLsizeiptr bytes = 4 * static_cast<GLsizeiptr>(this->ListCount);
  this->Counts.Reserve(bytes);
  this->Counts.Fill(0, bytes, 0u);
  this->Starts.Reserve(bytes + 4);
  this->Sortables.Reserve(bytes + 4);
  this->Sortables.Fill(0, 4, 0u);
  this->Run(this->CountProgram, boxes);
  this->SumUp();

  GLuint entries = 0;
  glBindBuffer(GL_COPY_READ_BUFFER, this->Starts.Get());
  glGetBufferSubData(GL_COPY_READ_BUFFER, bytes, sizeof(entries), &entries);
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  this->Entries = entries;
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatDeviceLists::SumUp()
{
  const GLuint parts = (this->ListCount + PartSize - 1) / PartSize;
  this->Sums.Reserve(4 * static_cast<GLsizeiptr>(parts));
  this->Counts.BindStorage(0);
  this->Starts.BindStorage(1);
  this->Sums.BindStorage(2);
  this->Sortables.BindStorage(3);
  for (vtkPointSplatProgram* program : { &this->PartsProgram, &this->SumsProgram, &this->ScanProgram })
  {
    program->Use();
    program->Set("ListCount", this->ListCount);
    program->Set("PartCount", parts);
    const vtkIdType groups = program == &this->SumsProgram ? 1 : static_cast<vtkIdType>(parts);
    vtkPointSplatProgram::Dispatch(ScanSize * groups, ScanSize);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatDeviceLists::Fill(
  const vtkPointSplatBuffer& boxes, vtkPointSplatBuffer& lists)
{
  lists.Reserve(4 * static_cast<GLsizeiptr>(this->Entries));
  lists.BindStorage(1);
  this->Run(this->FillProgram, boxes);

  this->SortProgram.Use();
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  units.Bind(this->SortProgram, "Starts", GL_TEXTURE_BUFFER, this->Starts.GetTexture());
  units.Bind(this->SortProgram, "Sortables", GL_TEXTURE_BUFFER, this->Sortables.GetTexture());
  lists.BindStorage(0);
  vtkPointSplatProgram::Dispatch(SortSize * SortGroups, SortSize);
}

//------------------------------------------------------------------------------
void vtkPointSplatDeviceLists::Release()
{
  for (const Stage& stage : this->GetStages())
  {
    stage.Program->Release();
  }
  for (vtkPointSplatBuffer* buffer : { &this->Counts, &this->Starts, &this->Sums, &this->Sortables })
  {
    buffer->Release();
  }
}
