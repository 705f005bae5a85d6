// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOutlines.h"

#include "vtkPointSplatLayers.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>

namespace
{
constexpr uint32_t PixelBits = 0xfffffffu;
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatOutlines::Use(const char* file, const std::string& defines)
{
  vtkPointSplatProgram& program = this->Programs[file + defines];
  if (!program.Build({ { GL_COMPUTE_SHADER, file } }, defines))
  {
    this->Error = program.GetLog();
    return nullptr;
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOutlines::ListTiles(
  const Search& search, const std::string& size, const glm::ivec4& tiles, GLuint& listed)
{
  vtkPointSplatProgram* program = this->Use("vtkPointSplatOutlineTilesCS", size);
  if (!program)
  {
    return false;
  }
  const vtkIdType count = static_cast<vtkIdType>(tiles.z - tiles.x + 1) * (tiles.w - tiles.y + 1);
  listed = 0;
  this->Tiles.Reserve(4 * static_cast<GLsizeiptr>(count));
  this->TileCounter.Upload(&listed, 4);
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  units.Bind(*program, "ItemTable", GL_TEXTURE_BUFFER, search.Items);
  units.Bind(*program, "Summaries", GL_TEXTURE_BUFFER, search.Summaries);
  program->Set("Tiles", tiles);
  program->Set("TileWindow", search.Window / glm::ivec4(search.TileSize, search.TileSize));
  program->Set("TilesAcross", search.TilesAcross);
  this->Tiles.BindStorage(0);
  this->TileCounter.BindStorage(7);
  vtkPointSplatProgram::Dispatch(count);
  this->TileCounter.Download(&listed, 4);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOutlines::Find(const vtkPointSplatLayers& layers, const Search& search)
{
  const std::string size = "#define TILE_WIDTH " + std::to_string(search.TileSize.x) +
    "\n#define TILE_HEIGHT " + std::to_string(search.TileSize.y) + "\n";
  const std::string defines =
    std::string(layers.GetNumberOfLayers() > 1 ? "#define LAYERS\n" : "") +
    (search.Summaries ? "#define LISTED\n" : "") + size;
  this->Size = layers.GetSize();
  const GLsizeiptr bytes = 4 * static_cast<GLsizeiptr>(this->Size.x) * this->Size.y;
  this->Pixels.Reserve(bytes);
  this->Indices.Reserve(bytes);
  const GLuint found = static_cast<GLuint>(this->Count);
  this->Counter.Upload(&found, 4);
  const int rows = layers.GetRowsPerBand();
  for (int row = search.Window.y / rows * rows; row <= search.Window.w; row += rows)
  {
    const glm::ivec4 tiles(search.Window.x / search.TileSize.x,
      std::max(row, search.Window.y) / search.TileSize.y, search.Window.z / search.TileSize.x,
      std::min(row + rows - 1, search.Window.w) / search.TileSize.y);
    GLuint count = static_cast<GLuint>((tiles.z - tiles.x + 1) * (tiles.w - tiles.y + 1));
    if (search.Summaries && !this->ListTiles(search, size, tiles, count))
    {
      return false;
    }
    vtkPointSplatProgram* program = this->Use("vtkPointSplatOutlineCS", defines);
    if (!program)
    {
      return false;
    }
    vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
    layers.Bind(units, *program);
    units.Bind(*program, "ItemTable", GL_TEXTURE_BUFFER, search.Items);
    units.Bind(*program, "ListedTiles", GL_TEXTURE_BUFFER, this->Tiles.GetTexture());
    program->Set("TileWindow", search.Window);
    program->Set("TilesAcross", search.TilesAcross);
    program->Set("TileCount", static_cast<int>(count));
    layers.BindRows(row);
    program->Set("FirstRow", row);
    program->Set("RowCount", rows);
    this->Pixels.BindStorage(4);
    this->Counter.BindStorage(7); // 5 is the layers' looks
    this->Indices.BindStorage(6);
    vtkPointSplatProgram::Dispatch(count);
  }
  GLuint all = found;
  this->Counter.Download(&all, 4);
  this->Count = static_cast<int>(all);
  this->Choices.Reserve(bytes);
  this->Choices.Fill(4 * found, 4 * static_cast<GLsizeiptr>(all - found), 0);
  return true;
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatOutlines::DownloadPixels(int first) const
{
  std::vector<uint32_t> pixels(static_cast<size_t>(this->Count));
  this->Pixels.Download(pixels.data(), 4 * static_cast<GLsizeiptr>(pixels.size()));
  pixels.erase(pixels.begin(), pixels.begin() + first);
  for (uint32_t& pixel : pixels)
  {
    pixel &= PixelBits;
  }
  return pixels;
}

//------------------------------------------------------------------------------
void vtkPointSplatOutlines::Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const
{
  units.Bind(program, "OutlinePixels", GL_TEXTURE_BUFFER, this->Pixels.GetTexture());
  units.Bind(program, "OutlineIndices", GL_TEXTURE_BUFFER, this->Indices.GetTexture());
  units.Bind(program, "OutlineChoices", GL_TEXTURE_BUFFER, this->Choices.GetTexture());
  program.Set("OutlineImage", this->Size);
}

//------------------------------------------------------------------------------
void vtkPointSplatOutlines::Release()
{
  this->Pixels.Release();
  this->Counter.Release();
  this->Tiles.Release();
  this->TileCounter.Release();
  this->Choices.Release();
  this->Indices.Release();
  this->Programs.clear();
  this->Count = 0;
}
