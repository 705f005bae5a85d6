// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatTiles.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatReach.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
// Entries of all lists, so that these are within a storage block, which has at least 128 MiB in
// drivers of use.
constexpr size_t MostEntries = size_t(1) << 25;
// The last word of the summary of a tile in which nothing is (vtkPointSplatTileSummary.glsl).
constexpr GLuint EmptyTile = 0xffffu;
// Room for layers before it is known how many there are. Where there is too little the frame is drawn again,
// which graphics cards do in no time, and have less memory for room that nobody needs.
constexpr int FirstTileLayers[2] = { 12, 8 }; // of the processor, and of a card

/// Pixels that an invocation has, or shares with others.
std::string SizeDefines(const glm::ivec2& size, int lanes)
{
  return "#define LANES " + std::to_string(lanes) + "\n#define TILE_WIDTH " +
    std::to_string(size.x) + "\n#define TILE_HEIGHT " + std::to_string(size.y) + "\n";
}

/// To be read; null: they cannot be.
const uint32_t* MapWords(vtkPointSplatBuffer& buffer, size_t words)
{
  return static_cast<const uint32_t*>(
    buffer.Map(4 * static_cast<GLsizeiptr>(words), GL_MAP_READ_BIT));
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatTiles::IsSupported(const glm::ivec2& size)
{
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  // A record is five texels. Boxes have 12 and 13 bits for tiles of 4 x 2 pixels.
  return vtkPointSplatProgram::IsComputeSupported() && texels / 5 >= Capacity &&
    static_cast<vtkIdType>(size.x) * size.y <= texels && size.x <= 16384 && size.y <= 16384;
}

//------------------------------------------------------------------------------
vtkPointSplatTiles::Variant vtkPointSplatTiles::VariantOf(
  const vtkPointSplatRequest& request)
{
  Variant v;
  bool clipping = false;
  bool plateau = false;
  bool kernels = false;
  for (const vtkPointSplatItem& item : request.Items)
  {
    clipping = clipping || !item.ClipPlanes.empty();
    plateau = plateau || item.Kernel.Plateau;
    kernels = kernels || !(item.Kernel == request.Items.front().Kernel);
  }
  v.ClipLines = request.HasClipLines();
  v.Colours = request.HasColours() || request.Gather;
  v.Factors = request.GetFactorCount();
  v.Looks = request.GetLookTexels();
  v.Coordinates = request.HasLook(
    [](const vtkPointSplatItemLook& look) { return look.Coordinates; });
  v.Tangents = request.HasLook([](const vtkPointSplatItemLook& look) { return look.Tangents; });
  v.Ids = request.HasIds;
  const std::string clips = clipping ? "#define CLIPPING\n" : "";
  v.Lines = v.ClipLines ? "#define CLIP_LINES\n" : "";
  const std::string both = std::string(v.Colours ? "#define COLOURS\n" : "") +
    (v.Factors > 0 ? "#define FACTORS " + std::to_string(v.Factors) + "\n" : "") +
    (v.Ids ? "#define IDS\n" : "") + request.GetLookDefines() + clips;
  const bool layers = request.IsPeeled();
  v.Project = both + v.Lines;
  v.Walk = clips + (layers ? "#define LAYERS\n" : "");
  v.Tile = both + request.GetAppearanceDefines(false) + (layers ? "#define LAYERS\n" : "") +
    (request.Gather ? "#define GATHER\n" : "") +
    (v.Looks > 0 ? "#define LOOKS " + std::to_string(v.Looks) + "\n" : "") +
    (plateau ? "#define PLATEAU\n" : "") + (kernels ? "#define KERNELS\n" : "");
  if (request.OnDevice)
  {
    // An invocation a pixel: what those of a tile load comes from one place. In small tiles few splats
    // are tried in vain, and there are more lists: an H200 takes 1.05 ms for the splats of a million
    // points in these, 1.9 in tiles of 8 x 8 pixels, and as long to make the lists.
    v.TileSize = { 4, 4 };
    v.Lanes = 16;
  }
  else
  {
    // As many pixels as leave registers to work with.
    v.TileSize = layers || v.Colours || v.Factors > 0 || v.Looks > 0 ? glm::ivec2(4, 2)
                                                                     : glm::ivec2(4, 4);
    v.Lanes = 1;
    v.Tile += request.Outlines ? "#define SUMMARIES\n" : "";
    v.Project += request.Outlines ? "#define PIXEL_BOXES\n" : "";
    v.BoxWords = request.Outlines ? vtkPointSplatPixelLists::BoxWords : v.BoxWords;
  }
  v.Tile += SizeDefines(v.TileSize, v.Lanes);
  return v;
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatTiles::Use(
  std::map<std::string, vtkPointSplatProgram>& programs, const char* file,
  const std::string& defines)
{
  vtkPointSplatProgram& program = programs[defines];
  if (!program.Build({ { GL_COMPUTE_SHADER, file } }, defines))
  {
    this->Error = program.GetLog();
    return nullptr;
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
vtkPointSplatTiles::Result vtkPointSplatTiles::Bin(const Variant& variant)
{
  const size_t splats = static_cast<size_t>(this->Splats);
  if (variant.Lanes > 1)
  {
    if (!this->DeviceLists.Count(this->Boxes, splats, this->Grid, this->HasTriangles))
    {
      this->Error = this->DeviceLists.GetError();
      return Failed;
    }
    if (this->DeviceLists.GetNumberOfEntries() > MostEntries)
    {
      return TooMany;
    }
    this->DeviceLists.Fill(this->Boxes, this->Lists);
    this->Curved = this->CurvedSplats = true;
    return Made;
  }
  const uint32_t* boxes = MapWords(this->Boxes, variant.BoxWords * splats);
  if (!boxes)
  {
    this->Error = "the splats' boxes cannot be read: out of memory?";
    return Failed;
  }
  this->HostLists.Count(boxes, variant.BoxWords, splats, this->Grid);
  this->Boxes.Unmap();
  if (this->HostLists.GetNumberOfEntries() > MostEntries)
  {
    return TooMany;
  }
  const GLsizeiptr entries = 4 * static_cast<GLsizeiptr>(this->HostLists.GetNumberOfEntries());
  this->Lists.Reserve(entries);
  void* lists = this->Lists.Map(entries, GL_MAP_WRITE_BIT);
  if (!lists)
  {
    this->Error = "the tiles' lists cannot be written: out of memory?";
    return Failed;
  }
  this->HostLists.Fill(static_cast<uint32_t*>(lists));
  this->Lists.Unmap();
  this->Curved = this->HostLists.HasCurved();
  this->CurvedSplats = this->HostLists.HasCurvedSplats();
  return Made;
}

//------------------------------------------------------------------------------
vtkPointSplatTiles::Result vtkPointSplatTiles::Prepare(
  const vtkPointSplatRequest& request, const vtkPointSplatPart& part, const Variant& variant)
{
  this->Grid.Shift = { static_cast<int>(std::lround(std::log2(variant.TileSize.x))),
    static_cast<int>(std::lround(std::log2(variant.TileSize.y))) };
  this->Grid.Tiles = (request.View.Size + variant.TileSize - 1) / variant.TileSize;
  this->Grid.Window = glm::ivec4(glm::ivec2(part.Window) >> this->Grid.Shift,
    glm::ivec2(part.Window.z, part.Window.w) >> this->Grid.Shift);
  this->Measure(request, part);
  if (this->Splats > Capacity)
  {
    return TooMany;
  }
  for (const Share& share : this->SharesOf(variant))
  {
    share.Buffer->Reserve(share.Bytes * this->Splats);
  }
  return this->Project(request, part, variant) ? this->Bin(variant) : Failed;
}

//------------------------------------------------------------------------------
GLuint vtkPointSplatTiles::GetSceneDepth(const vtkPointSplatRequest& request)
{
  const GLenum format = request.SceneDepth == 0 && request.IsPeeled()
    ? vtkPointSplatFramebuffer::GetReadDepthFormat()
    : 0;
  if (format == 0)
  {
    return request.SceneDepth;
  }
  this->NoDepth.Allocate(format, glm::ivec2(1));
  return this->NoDepth.Get();
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatTiles::UseTiles(const vtkPointSplatRequest& request,
  const vtkPointSplatPart& part, vtkPointSplatUnits& units, const Shader& shader)
{
  const std::string curved = std::string(this->CurvedSplats ? shader.Lines + "#define CURVED\n" : "") +
    (this->HasTriangles ? "#define TRIANGLES\n" : "");
  vtkPointSplatProgram* program = this->Use(
    this->TilePrograms, shader.File, shader.Defines + (shader.Curved ? curved : ""));
  if (!program)
  {
    return nullptr;
  }
  const vtkPointSplatView& view = request.View;
  const vtkPointSplatKernel& kernel = request.Items.front().Kernel;
  units.Bind(*program, "Records", GL_TEXTURE_BUFFER, this->Records.GetTexture());
  units.Bind(*program, "RecordClipLines", GL_TEXTURE_BUFFER, this->ClipLines.GetTexture());
  units.Bind(*program, "RecordColours", GL_TEXTURE_BUFFER, this->Colours.GetTexture());
  units.Bind(*program, "RecordFactors", GL_TEXTURE_BUFFER, this->Factors.GetTexture());
  units.Bind(*program, "RecordCoordinates", GL_TEXTURE_BUFFER, this->Coordinates.GetTexture());
  units.Bind(*program, "RecordTangents", GL_TEXTURE_BUFFER, this->Tangents.GetTexture());
  units.Bind(*program, "RecordIds", GL_TEXTURE_BUFFER, this->Ids.GetTexture());
  units.Bind(*program, "Lists", GL_TEXTURE_BUFFER, this->Lists.GetTexture());
  units.Bind(*program, "ItemTable", GL_TEXTURE_BUFFER, this->Items.GetTexture());
  units.Bind(*program, "ValueTables", GL_TEXTURE_BUFFER, this->Items.GetValueTables());
  units.Bind(*program, "SceneDepth", GL_TEXTURE_2D, this->GetSceneDepth(request));
  program->Set("HasSceneDepth", request.SceneDepth != 0);
  program->Set("BucketScale", this->BucketScale);
  program->Set("DepthReach", this->DepthReach);
  program->Set("DepthUnit", static_cast<float>(request.GetDepthUnit()));
  program->Set("DiskReach", vtkPointSplatReach::Disk);
  program->Set("PrefilterRadius", vtkPointSplatReach::Prefilter);
  program->Set("Kernel",
    glm::vec4(kernel.Shape, static_cast<float>(kernel.Support), kernel.Plateau ? 1.0f : 0.0f));
  program->Set("ZNear", static_cast<float>(view.Near));
  program->Set("Parallel", view.Parallel);
  program->Set("DepthRange",
    glm::vec2(static_cast<float>(view.Near), static_cast<float>(view.Far - view.Near)));
  program->Set("PixelX", view.PixelX);
  program->Set("PixelY", view.PixelY);
  program->Set("PixelW", view.PixelW);
  program->Set("PixelZ", view.PixelZ);
  program->Set("TilesAcross", this->Grid.Tiles.x);
  program->Set("TilesInAll", this->Grid.GetCount());
  program->Set("TileWindow", part.Window);
  program->Set("ImageWidth", view.Size.x);
  program->Set("MaximumLayers", request.MaximumLayers);
  program->Set("LeastContribution", static_cast<float>(std::max(request.LeastContribution, 1e-6)));
  return program;
}

//------------------------------------------------------------------------------
bool vtkPointSplatTiles::Leave(const vtkPointSplatRequest& request, const vtkPointSplatPart& part,
  const Variant& variant, vtkPointSplatLayers& layers)
{
  if (variant.Lanes > 1)
  {
    layers.AddCovered({ part.Window });
    return true;
  }
  auto pixelsOf = [&](std::vector<glm::ivec4> tiles) {
    for (glm::ivec4& r : tiles)
    {
      r = { glm::max(glm::ivec2(r) * variant.TileSize, glm::ivec2(part.Window)),
        glm::min((glm::ivec2(r.z, r.w) + 1) * variant.TileSize - 1,
          glm::ivec2(part.Window.z, part.Window.w)) };
    }
    return tiles;
  };
  layers.AddCovered(pixelsOf(this->HostLists.GetCovered()));
  const std::vector<glm::ivec4> runs = this->HostLists.GetEmptyRuns();
  if (!layers.Clear(pixelsOf(runs), request.ShowsEach ? layers.GetCapacity() : 1))
  {
    this->Error = "layers cannot be written: out of memory?";
    return false;
  }
  if (request.Outlines && !runs.empty())
  {
    auto summaries =
      static_cast<glm::uvec4*>(this->Summaries.Map(this->GetSummaryBytes(), GL_MAP_WRITE_BIT));
    if (!summaries)
    {
      this->Error = "the tiles' summaries cannot be written: out of memory?";
      return false;
    }
    for (const glm::ivec4& run : runs)
    {
      std::fill_n(summaries + run.y * this->Grid.Tiles.x + run.x, run.z - run.x + 1,
        glm::uvec4(0u, 0u, 0u, EmptyTile));
    }
    this->Summaries.Unmap();
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatTiles::Band> vtkPointSplatTiles::MakeBands(
  const Variant& variant, const vtkPointSplatLayers& layers)
{
  std::vector<Band> bands;
  std::vector<uint32_t> table;
  constexpr size_t words = vtkPointSplatTileLists::TableWords;
  const int tileRows = layers.GetRowsPerBand() / variant.TileSize.y;
  const int across = this->Grid.Tiles.x;
  for (int row = this->Grid.Window.y / tileRows * tileRows; row <= this->Grid.Window.w;
       row += tileRows)
  {
    const glm::ivec2 rows(std::max(row, this->Grid.Window.y),
      std::min(row + tileRows - 1, this->Grid.Window.w));
    const int pixelRow = row * variant.TileSize.y;
    if (variant.Lanes > 1)
    {
      bands.push_back({ pixelRow, static_cast<size_t>(rows.x * across), 0,
        static_cast<size_t>((rows.y - rows.x + 1) * across) });
      continue;
    }
    const size_t first = table.size() / words;
    const size_t plain = this->HostLists.AddToTable(rows, static_cast<size_t>(vtkPointSplatProgram::GroupSize), table);
    bands.push_back({ pixelRow, first, plain, table.size() / words - first - plain });
  }
  if (variant.Lanes == 1)
  {
    this->Table.Upload(table);
  }
  return bands;
}

//------------------------------------------------------------------------------
vtkPointSplatTiles::Result vtkPointSplatTiles::DrawLayers(const vtkPointSplatRequest& request,
  const vtkPointSplatPart& part, const Variant& variant, vtkPointSplatLayers& layers)
{
  const int capacity = layers.GetCapacity();
  if (request.IsPeeled())
  {
    this->Counts.BindStorage(3);
  }
  if (request.Outlines && variant.Lanes == 1)
  {
    this->Summaries.Reserve(this->GetSummaryBytes());
    this->Summaries.BindStorage(4);
  }
  if (!this->Leave(request, part, variant, layers))
  {
    return Failed;
  }
  const std::vector<Band> bands = this->MakeBands(variant, layers);
  for (const bool curved : { false, true })
  {
    const auto count = [curved](const Band& band) { return curved ? band.Curved : band.Plain; };
    if (std::none_of(bands.begin(), bands.end(), count))
    {
      continue;
    }
    vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
    vtkPointSplatProgram* program = this->UseTiles(request, part, units,
      { "vtkPointSplatTileCS", variant.Tile, variant.Lines, curved });
    if (!program)
    {
      return Failed;
    }
    program->Set("LayerCapacity", capacity);
    program->Set("LayersToClear", request.ShowsEach ? capacity : 1);
    units.Bind(*program, "Tiles", GL_TEXTURE_BUFFER,
      variant.Lanes > 1 ? this->DeviceLists.GetStarts() : this->Table.GetTexture());
    for (const Band& band : bands)
    {
      layers.BindRows(band.Row);
      program->Set("FirstRow", band.Row);
      program->Set("FirstTile", static_cast<int>(band.First + (curved ? band.Plain : 0)));
      program->Set("TileCount", static_cast<int>(count(band)));
      vtkPointSplatProgram::Dispatch(variant.Lanes * static_cast<vtkIdType>(count(band)));
    }
  }
  return Made;
}

//------------------------------------------------------------------------------
size_t vtkPointSplatTiles::ListOutlines(
  const std::vector<uint32_t>& pixels, size_t first, const Variant& variant, int width)
{
  size_t end = first;
  const uint32_t* boxes =
    MapWords(this->Boxes, variant.BoxWords * static_cast<size_t>(this->Splats));
  const uint32_t* lists = MapWords(this->Lists, this->HostLists.GetNumberOfEntries());
  if (boxes && lists)
  {
    end = this->HostOutlineLists.Make(
      { this->HostLists, lists, boxes, static_cast<uint32_t>(width) }, pixels, first);
  }
  else
  {
    this->Error = "the splats' lists cannot be read: out of memory?";
  }
  if (boxes)
  {
    this->Boxes.Unmap();
  }
  if (lists)
  {
    this->Lists.Unmap();
  }
  this->OutlineLists.Upload(this->HostOutlineLists.GetEntries());
  this->Table.Upload(this->HostOutlineLists.GetTable());
  return end;
}

//------------------------------------------------------------------------------
vtkPointSplatTiles::Result vtkPointSplatTiles::SampleOutlines(const vtkPointSplatRequest& request,
  const vtkPointSplatPart& part, const Variant& variant, const vtkPointSplatLayers& layers,
  vtkPointSplatOutlines& outlines)
{
  const int first = outlines.GetCount();
  const bool device = variant.Lanes > 1;
  if (!outlines.Find(layers,
        { part.Window, variant.TileSize, this->Grid.Tiles.x,
          this->Items.GetTexture(), device ? 0 : this->Summaries.GetTexture() }))
  {
    this->Error = outlines.GetError();
    return Failed;
  }
  const int count = outlines.GetCount() - first;
  if (count == 0)
  {
    return Made;
  }
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  vtkPointSplatProgram* program = this->UseTiles(request, part, units,
    { "vtkPointSplatOutlineSamplesCS",
      variant.Walk + SizeDefines({ 2, 2 }, device ? 4 : 1) +
        "#define SAMPLES\n#define LAYER_BUFFERS\n",
      variant.Lines, this->Curved });
  if (!program)
  {
    return Failed;
  }
  layers.Bind(units, *program);
  outlines.Bind(units, *program);
  outlines.GetChoices().BindStorage(0);
  program->Set("TileShift", this->Grid.Shift);
  const size_t pixels = static_cast<size_t>(count);
  const std::vector<uint32_t> listed =
    device ? std::vector<uint32_t>() : outlines.DownloadPixels(first);
  for (size_t begin = 0, end = pixels; begin < pixels; begin = end)
  {
    end = device ? pixels : this->ListOutlines(listed, begin, variant, request.View.Size.x);
    if (end == begin)
    {
      return Failed;
    }
    units.Bind(*program, "Lists", GL_TEXTURE_BUFFER,
      (device ? this->Lists : this->OutlineLists).GetTexture());
    units.Bind(*program, "Tiles", GL_TEXTURE_BUFFER,
      device ? this->DeviceLists.GetStarts() : this->Table.GetTexture());
    program->Set("FirstOutline", first + static_cast<int>(begin));
    program->Set("OutlineCount", static_cast<int>(end - begin));
    vtkPointSplatProgram::Dispatch((device ? 4 : 1) * static_cast<vtkIdType>(end - begin));
  }
  return Made;
}

//------------------------------------------------------------------------------
vtkPointSplatTiles::Result vtkPointSplatTiles::Reconstruct(const vtkPointSplatRequest& given,
  const std::vector<vtkPointSplatPart>& parts, vtkPointSplatLayers& layers,
  vtkPointSplatOutlines& outlines)
{
  vtkPointSplatRequest request = given;
  const Variant variant = VariantOf(request);
  GLint texels = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  request.MaximumLayers = request.GetMostLayers(
    texels / std::max(variant.Looks, 1) /
    (static_cast<vtkIdType>(request.View.Size.x) * request.View.Size.y));
  this->Items.Upload(request.Items, request.View);
  int capacity = std::max(layers.GetCapacity(),
    std::min(FirstTileLayers[request.OnDevice ? 1 : 0], request.GetLayersThatCount()));
  capacity = std::min(capacity, request.MaximumLayers);
  Result result = Made;
  for (bool fits = false; !fits && result == Made;)
  {
    layers.AllocateBuffers(
      request.View.Size, capacity, variant.Factors, variant.Looks, variant.Ids);
    layers.SetNumberOfLayers(capacity);
    outlines.Clear();
    GLuint made = 1;
    if (request.IsPeeled())
    {
      const GLuint none = 0;
      this->Counts.Upload(&none, 4);
    }
    for (const vtkPointSplatPart& part : parts)
    {
      result = this->Prepare(request, part, variant);
      result = result == Made ? this->DrawLayers(request, part, variant, layers) : result;
      result = result == Made && request.Outlines
        ? this->SampleOutlines(request, part, variant, layers, outlines)
        : result;
      if (result != Made)
      {
        break;
      }
    }
    if (request.IsPeeled() && result == Made)
    {
      this->Counts.Download(&made, 4);
    }
    fits = static_cast<int>(made) <= capacity;
    capacity = std::min(request.MaximumLayers, static_cast<int>(made) + 2);
    layers.SetNumberOfLayers(static_cast<int>(made));
  }
  layers.SetGathered(request.Gather ? request.MaximumLayers - 1 : -1);
  glUseProgram(0);
  return result;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatTiles::GetMemorySize() const
{
  vtkIdType bytes = this->DeviceLists.GetMemorySize();
  for (const vtkPointSplatBuffer* buffer :
    { &this->Records, &this->Boxes, &this->ClipLines, &this->Colours, &this->Factors,
      &this->Coordinates, &this->Tangents, &this->Ids, &this->Lists, &this->OutlineLists,
      &this->Table, &this->Summaries })
  {
    bytes += buffer->GetSize();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatTiles::Release()
{
  this->ProjectPrograms.clear();
  this->TrianglePrograms.clear();
  this->TilePrograms.clear();
  this->Items.Release();
  this->DeviceLists.Release();
  this->NoDepth.Release();
  for (vtkPointSplatBuffer* buffer : { &this->Records, &this->Boxes, &this->ClipLines,
         &this->Colours, &this->Factors, &this->Coordinates, &this->Tangents, &this->Ids,
         &this->Blocks, &this->Lists, &this->OutlineLists, &this->Table, &this->Summaries,
         &this->Counts })
  {
    buffer->Release();
  }
}
