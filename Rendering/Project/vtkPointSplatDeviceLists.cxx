// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDeviceLists.h"

#include "vtkPointSplatUnits.h"

namespace
{
constexpr vtkIdType GroupSize = 64;  // as in vtkPointSplatBinCS.glsl
constexpr vtkIdType ScanSize = 256;  // as in vtkPointSplatScanCS.glsl
constexpr vtkIdType SortSize = 128;  // as in vtkPointSplatSortListsCS.glsl
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeviceLists::Build()
{
  const bool built =
    this->CountProgram.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatBinCS" } }) &&
    this->ScanProgram.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatScanCS" } }) &&
    this->FillProgram.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatBinCS" } }, "#define FILL\n") &&
    this->SortProgram.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatSortListsCS" } });
  this->Error = this->CountProgram.GetLog() + this->ScanProgram.GetLog() +
    this->FillProgram.GetLog() + this->SortProgram.GetLog();
  return built;
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
  vtkPointSplatProgram::Dispatch(static_cast<vtkIdType>(this->Splats), GroupSize);
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
  this->Run(this->CountProgram, boxes);

  this->ScanProgram.Use();
  this->ScanProgram.Set("ListCount", this->ListCount);
  this->Counts.BindStorage(0);
  this->Starts.BindStorage(1);
  vtkPointSplatProgram::Dispatch(1, ScanSize);

  GLuint entries = 0;
  glBindBuffer(GL_COPY_READ_BUFFER, this->Starts.Get());
  glGetBufferSubData(GL_COPY_READ_BUFFER, bytes, sizeof(entries), &entries);
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  this->Entries = entries;
  return true;
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
  this->SortProgram.Set("ListCount", this->ListCount);
  lists.BindStorage(0);
  vtkPointSplatProgram::Dispatch(SortSize * static_cast<vtkIdType>(this->ListCount), SortSize);
}

//------------------------------------------------------------------------------
void vtkPointSplatDeviceLists::Release()
{
  for (vtkPointSplatProgram* program : { &this->CountProgram, &this->ScanProgram, &this->FillProgram,
         &this->SortProgram })
  {
    program->Release();
  }
  this->Counts.Release();
  this->Starts.Release();
}
