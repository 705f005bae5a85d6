// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLayers.h"

#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>
#include <cstring>

namespace
{
// Storage blocks begin at multiples of some 256 bytes, and have at least 128 MiB in drivers of use.
constexpr vtkIdType LeastBlockBytes = 1 << 27;
// Bands of rows begin at multiples of so many, whatever the size of tiles is.
constexpr int BandRows = 64;
constexpr vtkIdType TexelBytes = 16;
}

//------------------------------------------------------------------------------
void vtkPointSplatLayers::AllocateBuffers(
  const glm::ivec2& size, int layers, int factors, int looks, bool ids)
{
  if (!this->Buffers)
  {
    this->Release();
  }
  this->Buffers = true;
  this->Size = size;
  this->Capacity = layers;
  this->Factors = factors;
  this->Ids = ids;
  this->Covered.clear();
  const GLsizeiptr pixels = static_cast<GLsizeiptr>(size.x) * size.y;
  this->TexelBuffer.Reserve(TexelBytes * pixels * layers);
  if (factors > 0)
  {
    this->FactorBuffer.Reserve(4 * pixels * layers);
  }
  this->Looks = looks;
  if (looks > 0)
  {
    this->LookBuffer.Reserve(16 * looks * pixels * layers);
  }
  if (ids)
  {
    this->IdBuffer.Reserve(4 * pixels);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatLayers::AllocateImages(
  const glm::ivec2& size, int layers, int factors, bool ids)
{
  if (this->Buffers)
  {
    this->Release();
  }
  this->Buffers = false;
  this->Size = size;
  this->Capacity = layers;
  this->Factors = factors;
  this->Looks = 0;
  this->Ids = ids;
  this->Covered.clear();
  this->AddCovered({ { 0, 0, size.x - 1, size.y - 1 } });
  this->TexelImage.Allocate(size, layers);
  if (factors > 0)
  {
    this->FactorImage.Allocate(size, layers);
  }
  if (ids)
  {
    this->IdImage.Allocate(size);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatLayers::AddCovered(const std::vector<glm::ivec4>& rectangles)
{
  this->Covered.insert(this->Covered.end(), rectangles.begin(), rectangles.end());
  this->Rectangles.Upload(this->Covered);
}

//------------------------------------------------------------------------------
bool vtkPointSplatLayers::Clear(const std::vector<glm::ivec4>& rectangles, int layers)
{
  if (rectangles.empty())
  {
    return true;
  }
  const vtkIdType width = this->Size.x;
  auto texels = static_cast<char*>(this->TexelBuffer.Map(
    TexelBytes * width * this->Size.y * this->Capacity, GL_MAP_WRITE_BIT));
  if (!texels)
  {
    return false;
  }
  for (const glm::ivec4& rectangle : rectangles)
  {
    const size_t bytes = static_cast<size_t>(TexelBytes * (rectangle.z - rectangle.x + 1));
    for (vtkIdType row = rectangle.y; row <= rectangle.w; ++row)
    {
      for (int layer = 0; layer < layers; ++layer)
      {
        const vtkIdType at = (row * this->Capacity + layer) * width + rectangle.x;
        std::memset(texels + TexelBytes * at, 0, bytes);
      }
    }
  }
  this->TexelBuffer.Unmap();
  return true;
}

//------------------------------------------------------------------------------
int vtkPointSplatLayers::GetRowsPerBand() const
{
  GLint64 bound = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bound);
  const vtkIdType rows = std::max<vtkIdType>(static_cast<vtkIdType>(bound), LeastBlockBytes) /
    (16 * std::max(this->Looks, 1) * static_cast<vtkIdType>(this->Size.x) * this->Capacity);
  return static_cast<int>(
    std::max<vtkIdType>(std::min<vtkIdType>(rows, 1 << 20) / BandRows, 1) * BandRows);
}

//------------------------------------------------------------------------------
void vtkPointSplatLayers::BindRows(int row) const
{
  const GLsizeiptr rows = std::min(this->GetRowsPerBand(), this->Size.y - row);
  auto bind = [=](const vtkPointSplatBuffer& buffer, GLuint index, GLsizeiptr bytes) {
    buffer.BindStorage(index, bytes * this->Size.x * row, bytes * this->Size.x * rows);
  };
  bind(this->TexelBuffer, 0, 16 * this->Capacity);
  if (this->Factors > 0)
  {
    bind(this->FactorBuffer, 1, 4 * this->Capacity);
  }
  if (this->Ids)
  {
    bind(this->IdBuffer, 2, 4);
  }
  if (this->Looks > 0)
  {
    bind(this->LookBuffer, 5, 16 * this->Looks * this->Capacity);
  }
}

//------------------------------------------------------------------------------
std::string vtkPointSplatLayers::GetDefines() const
{
  return std::string(this->Buffers ? "#define LAYER_BUFFERS\n" : "") +
    (this->Factors > 0 ? "#define FACTORS " + std::to_string(this->Factors) + "\n" : "") +
    (this->Looks > 0 ? "#define LOOKS " + std::to_string(this->Looks) + "\n" : "");
}

//------------------------------------------------------------------------------
void vtkPointSplatLayers::Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const
{
  if (this->Buffers)
  {
    units.Bind(program, "LayerTexels", GL_TEXTURE_BUFFER, this->TexelBuffer.GetTexture());
    units.Bind(program, "LayerFactors", GL_TEXTURE_BUFFER,
      this->Factors > 0 ? this->FactorBuffer.GetTexture() : 0);
    units.Bind(program, "LayerLooks", GL_TEXTURE_BUFFER,
      this->Looks > 0 ? this->LookBuffer.GetTexture() : 0);
    units.Bind(
      program, "LayerIds", GL_TEXTURE_BUFFER, this->Ids ? this->IdBuffer.GetTexture() : 0);
  }
  else
  {
    units.Bind(program, "LayerTexels", GL_TEXTURE_2D_ARRAY, this->TexelImage.Get());
    units.Bind(program, "LayerFactors", GL_TEXTURE_2D_ARRAY,
      this->Factors > 0 ? this->FactorImage.Get() : 0);
    units.Bind(program, "LayerIds", GL_TEXTURE_2D, this->Ids ? this->IdImage.Get() : 0);
  }
  units.Bind(program, "LayerRectangles", GL_TEXTURE_BUFFER, this->Rectangles.GetTexture());
  program.Set("LayerSize", this->Size);
  program.Set("LayerCapacity", this->Capacity);
  program.Set("LayerCount", this->Count);
  program.Set("GatheredLayer", this->Gathered);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatLayers::GetMemorySize() const
{
  return this->Rectangles.GetSize() +
    (this->Buffers ? this->TexelBuffer.GetSize() + this->FactorBuffer.GetSize() +
          this->LookBuffer.GetSize() + this->IdBuffer.GetSize()
                   : this->TexelImage.GetMemorySize() + this->FactorImage.GetMemorySize() +
          this->IdImage.GetMemorySize());
}

//------------------------------------------------------------------------------
void vtkPointSplatLayers::Release()
{
  this->TexelBuffer.Release();
  this->FactorBuffer.Release();
  this->LookBuffer.Release();
  this->IdBuffer.Release();
  this->Rectangles.Release();
  this->TexelImage.Release();
  this->FactorImage.Release();
  this->IdImage.Release();
  this->Covered.clear();
  this->Count = this->Capacity = 0;
}
