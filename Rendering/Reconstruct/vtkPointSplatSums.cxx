// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSums.h"

#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"

//------------------------------------------------------------------------------
void vtkPointSplatSums::AllocateImages(const Content& content)
{
  this->Buffers = false;
  this->Has = content;
  this->Depths.Allocate(content.Size);
  this->WeightAndNormal.Allocate(content.Size);
  this->DepthAndColour.Allocate(content.Size);
  this->Opacities.Allocate(content.Size);
  this->DepthTest.Allocate(content.Size);
  if (content.Factors > 0)
  {
    this->Factors.Allocate(content.Size);
  }
  if (content.Ids)
  {
    this->Ids.Allocate(content.Size);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatSums::AllocateBuffers(const Content& content)
{
  this->Buffers = true;
  this->Has = content;
  const GLsizeiptr pixels = static_cast<GLsizeiptr>(content.Size.x) * content.Size.y;
  this->DepthBuffer.Reserve(4 * pixels);
  this->SumBuffer.Reserve(4 * this->GetSumStride() * pixels);
  if (content.Ids)
  {
    this->IdBuffer.Reserve(4 * pixels);
  }
}

//------------------------------------------------------------------------------
int vtkPointSplatSums::GetSumStride() const
{
  const int words = (this->Has.Colours ? 5 : 3) + (this->Has.Factors + 1) / 2;
  return words > 4 ? 8 : 4;
}

//------------------------------------------------------------------------------
void vtkPointSplatSums::ClearRows(int first, int last)
{
  const GLsizeiptr row = 4 * static_cast<GLsizeiptr>(this->Has.Size.x);
  const GLsizeiptr rows = last - first + 1;
  this->DepthBuffer.Fill(row * first, row * rows, 0xffffffffu);
  this->SumBuffer.Fill(row * this->GetSumStride() * first, row * this->GetSumStride() * rows, 0u);
  if (this->Has.Ids)
  {
    this->IdBuffer.Fill(row * first, row * rows, 0xffffffffu);
  }
}

//------------------------------------------------------------------------------
std::string vtkPointSplatSums::GetDefines() const
{
  return std::string(this->Buffers ? "#define SUM_BUFFERS\n" : "") +
    (this->Has.Colours ? "#define COLOURS\n" : "") +
    (this->Has.Factors > 0 ? "#define FACTORS " + std::to_string(this->Has.Factors) + "\n" : "");
}

//------------------------------------------------------------------------------
void vtkPointSplatSums::Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const
{
  if (this->Buffers)
  {
    units.Bind(program, "Depths", GL_TEXTURE_BUFFER, this->DepthBuffer.GetTexture());
    units.Bind(program, "Sums", GL_TEXTURE_BUFFER, this->SumBuffer.GetTexture());
    units.Bind(
      program, "Ids", GL_TEXTURE_BUFFER, this->Has.Ids ? this->IdBuffer.GetTexture() : 0);
    program.Set("ImageWidth", this->Has.Size.x);
    program.Set("TexelsPerPixel", this->GetSumStride() / 4);
    return;
  }
  units.Bind(program, "Depths", GL_TEXTURE_2D, this->Depths.Get());
  units.Bind(program, "WeightAndNormal", GL_TEXTURE_2D, this->WeightAndNormal.Get());
  units.Bind(program, "DepthAndColour", GL_TEXTURE_2D, this->DepthAndColour.Get());
  units.Bind(program, "Opacities", GL_TEXTURE_2D, this->Opacities.Get());
  units.Bind(
    program, "Factors", GL_TEXTURE_2D, this->Has.Factors > 0 ? this->Factors.Get() : 0);
  units.Bind(program, "Ids", GL_TEXTURE_2D, this->Has.Ids ? this->Ids.Get() : 0);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatSums::GetMemorySize() const
{
  vtkIdType bytes =
    this->DepthBuffer.GetSize() + this->SumBuffer.GetSize() + this->IdBuffer.GetSize();
  for (const vtkPointSplatImage* image : { &this->Depths, &this->WeightAndNormal,
         &this->DepthAndColour, &this->Opacities, &this->Factors, &this->Ids, &this->DepthTest })
  {
    bytes += image->GetMemorySize();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatSums::Release()
{
  for (vtkPointSplatImage* image : { &this->Depths, &this->WeightAndNormal, &this->DepthAndColour,
         &this->Opacities, &this->Factors, &this->Ids, &this->DepthTest })
  {
    image->Release();
  }
  for (vtkPointSplatBuffer* buffer : { &this->DepthBuffer, &this->SumBuffer, &this->IdBuffer })
  {
    buffer->Release();
  }
}
