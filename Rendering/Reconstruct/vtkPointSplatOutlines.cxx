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
bool vtkPointSplatOutlines::Find(const vtkPointSplatLayers& layers, const Search& search)
{
  const std::string defines =
    std::string(layers.GetNumberOfLayers() > 1 ? "#define LAYERS\n" : "") +
    (search.Summaries ? "#define SUMMARIES\n" : "") + "#define TILE_WIDTH " +
    std::to_string(search.TileSize.x) + "\n#define TILE_HEIGHT " +
    std::to_string(search.TileSize.y) + "\n";
  vtkPointSplatProgram& program = this->Programs[defines];
  if (!program.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatOutlineCS" } }, defines))
  {
    this->Error = program.GetLog();
    return false;
  }
  this->Size = layers.GetSize();
  const GLsizeiptr bytes = 4 * static_cast<GLsizeiptr>(this->Size.x) * this->Size.y;
  this->Pixels.Reserve(bytes);
  this->Indices.Reserve(bytes);
  const GLuint found = static_cast<GLuint>(this->Count);
  this->Counter.Upload(&found, 4);
  program.Use();
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  layers.Bind(units, program);
  units.Bind(program, "ItemTable", GL_TEXTURE_BUFFER, search.Items);
  units.Bind(program, "Summaries", GL_TEXTURE_BUFFER, search.Summaries);
  program.Set("TileWindow", search.Window);
  program.Set("TilesAcross", search.TilesAcross);
  this->Pixels.BindStorage(4);
  this->Counter.BindStorage(7); // 5 is the layers' looks
  this->Indices.BindStorage(6);
  const int rows = layers.GetRowsPerBand();
  const glm::ivec2 across = glm::ivec2(search.Window.x, search.Window.z) / search.TileSize.x;
  for (int row = search.Window.y / rows * rows; row <= search.Window.w; row += rows)
  {
    layers.BindRows(row);
    program.Set("FirstRow", row);
    program.Set("RowCount", rows);
    const int low = std::max(row, search.Window.y) / search.TileSize.y;
    const int high = std::min(row + rows - 1, search.Window.w) / search.TileSize.y;
    vtkPointSplatProgram::Dispatch(
      static_cast<vtkIdType>(across.y - across.x + 1) * (high - low + 1));
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
  this->Choices.Release();
  this->Indices.Release();
  this->Programs.clear();
  this->Count = 0;
}
