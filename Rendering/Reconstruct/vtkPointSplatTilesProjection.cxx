// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the tiles: from splats and triangles to records.
#include "vtkPointSplatReach.h"
#include "vtkPointSplatTiles.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>
#include <iterator>

namespace
{
constexpr GLsizeiptr RecordBytes = 80;
constexpr GLsizeiptr LineBytes = 16;
constexpr GLsizeiptr CoordinateBytes = 16;
constexpr vtkIdType SplatsPerDispatch = vtkIdType(1) << 20;

/// Records of an item's splats, or triangles: whole blocks, so that those of each begin where storage
/// blocks may.
vtkIdType RecordsOf(const vtkPointSplatItem& item, vtkIdType count)
{
  constexpr vtkIdType size = vtkPointSplatBlocks::Size;
  return item.IsInView() ? (count + size - 1) / size * size : 0;
}

vtkIdType SplatRecordsOf(const vtkPointSplatItem& item)
{
  return RecordsOf(item, item.GetNumberOfInvocations());
}

vtkIdType TriangleRecordsOf(const vtkPointSplatItem& item)
{
  return RecordsOf(item, item.GetNumberOfTriangles());
}

/// The distances from the near plane between which an item's splats lie.
glm::dvec2 DepthsOf(const vtkPointSplatItem& item, const vtkPointSplatView& view, double reach)
{
  const glm::dmat4 MCVC = view.WCVC * item.MCWC;
  const std::array<double, 6>& b = item.Cloud->GetBounds();
  glm::dvec2 depths(1e300, -1e300);
  for (size_t corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 p = MCVC *
      glm::dvec4(b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2 & 1)], 1.0);
    depths.x = std::min(depths.x, -p.z - view.Near);
    depths.y = std::max(depths.y, -p.z - view.Near);
  }
  return depths + glm::dvec2(-reach, reach);
}
}

//------------------------------------------------------------------------------
void vtkPointSplatTiles::Measure(
  const vtkPointSplatRequest& request, const vtkPointSplatPart& part)
{
  const vtkPointSplatView& view = request.View;
  this->Splats = 0;
  this->HasTriangles = false;
  this->DepthReach = 0.0f;
  glm::dvec2 depths(1e300, -1e300);
  for (const vtkPointSplatItem& item : part.Items)
  {
    const vtkIdType records = SplatRecordsOf(item) + TriangleRecordsOf(item);
    if (records == 0)
    {
      continue;
    }
    this->Splats += records;
    // Bent at 45 degrees at the rim, a splat is half its squared support high.
    const double support = item.Kernel.Support + 0.5 * item.Kernel.Support * item.Kernel.Support;
    const double reach = support * item.RadiusScale * item.GetStrideScale() * item.GetStretch() *
      item.GetLargestRadius();
    const glm::dvec2 own = DepthsOf(item, view, reach);
    depths = { std::min(depths.x, own.x), std::max(depths.y, own.y) };
    this->DepthReach = std::max(this->DepthReach, static_cast<float>(2.0 * reach));
    if (TriangleRecordsOf(item) > 0)
    {
      this->HasTriangles = true;
      this->DepthReach = std::max(this->DepthReach,
        static_cast<float>(item.GetStretch() * item.Cloud->GetTriangles().GetLongestEdge()));
    }
  }
  depths = glm::clamp(depths, glm::dvec2(0.0), glm::dvec2(view.Far - view.Near));
  const double range = std::max(depths.y - depths.x, 1e-30);
  this->BucketScale = glm::vec2(depths.x, vtkPointSplatTileLists::Buckets / range);
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatTiles::Share> vtkPointSplatTiles::SharesOf(const Variant& variant)
{
  // Where there are ids there are no tangents.
  const Share all[] = { { true, &this->Records, 0, RecordBytes },
    { true, &this->Boxes, 1, 4 * static_cast<GLsizeiptr>(variant.BoxWords) },
    { variant.Colours, &this->Colours, 2, 4 },
    { variant.Factors > 0, &this->Factors, 3, 4 }, { variant.Ids, &this->Ids, 4, 4 },
    { variant.Tangents, &this->Tangents, 4, 4 },
    { variant.ClipLines, &this->ClipLines, 5, LineBytes },
    { variant.Coordinates, &this->Coordinates, 6, CoordinateBytes } };
  std::vector<Share> wanted;
  std::copy_if(std::begin(all), std::end(all), std::back_inserter(wanted),
    [](const Share& share) { return share.IsWanted; });
  return wanted;
}

//------------------------------------------------------------------------------
bool vtkPointSplatTiles::Project(
  const vtkPointSplatRequest& request, const vtkPointSplatPart& part, const Variant& variant)
{
  vtkPointSplatProgram* program =
    this->Use(this->ProjectPrograms, "vtkPointSplatProjectCS", variant.Project);
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  program->Set("DiskReach", vtkPointSplatReach::Disk);
  program->Set("CoverageRadius", vtkPointSplatReach::Coverage);
  program->Set("CoverageDot", vtkPointSplatReach::CoverageDot);
  program->Set("PrefilterRadius", vtkPointSplatReach::Prefilter);
  program->Set("TileShift", this->Grid.Shift);
  program->Set("TileReach",
    variant.Lanes > 1 ? 0.0f : 0.5f * glm::length(glm::vec2(variant.TileSize - 1)));
  program->Set("BucketScale", this->BucketScale);
  vtkIdType first = 0;
  for (const vtkPointSplatItem& item : part.Items)
  {
    const vtkIdType count = SplatRecordsOf(item);
    if (count == 0)
    {
      continue;
    }
    vtkPointSplatCloud::Buffers& buffers =
      item.Upload(variant.Ids ? &request.Ids : nullptr);
    program->Use(); // another one may have filled the buffers
    item.SetUniforms(*program, request.View);
    program->Set("RecordCount", static_cast<unsigned int>(count));
    item.SetBlockUniforms(*program);
    program->Set("HasClipLines", item.Cloud->HasClipLines());
    program->Set("HasColours", item.Cloud->HasColours());
    program->Set("HasFactors", item.Factors != nullptr);
    units.Bind(*program, "Splats", GL_TEXTURE_BUFFER, buffers.Splats.GetTexture());
    units.Bind(*program, "ClipLineTexels", GL_TEXTURE_BUFFER,
      item.Cloud->HasClipLines() ? buffers.ClipLines.GetTexture() : 0);
    units.Bind(*program, "Colours", GL_TEXTURE_BUFFER, buffers.Colours.GetTexture());
    units.Bind(*program, "Factors", GL_TEXTURE_BUFFER,
      item.Factors ? item.Factors->GetTexture() : 0);
    program->Set("HasCoordinates", item.Look.Coordinates);
    program->Set("HasTangents", item.Look.Tangents);
    units.Bind(*program, "Coordinates", GL_TEXTURE_BUFFER,
      item.Look.Coordinates ? buffers.Coordinates.GetTexture() : 0);
    units.Bind(*program, "Tangents", GL_TEXTURE_BUFFER,
      item.Look.Tangents ? buffers.Tangents.GetTexture() : 0);
    units.Bind(*program, "Ids", GL_TEXTURE_BUFFER, variant.Ids ? buffers.Ids.GetTexture() : 0);
    if (item.Runs)
    {
      this->Blocks.Upload(item.GetRunsIn(buffers));
      this->Blocks.BindStorage(7);
    }
    this->DispatchRecords(*program, variant, first, count);
    first += count;
  }
  return !this->HasTriangles || this->ProjectTriangles(request, part, variant, first);
}

//------------------------------------------------------------------------------
bool vtkPointSplatTiles::ProjectTriangles(const vtkPointSplatRequest& request,
  const vtkPointSplatPart& part, const Variant& variant, vtkIdType first)
{
  vtkPointSplatProgram* program = this->Use(this->TrianglePrograms, "vtkPointSplatTrianglesCS",
    variant.Project + (request.HasFacets() ? "#define FACETS\n" : ""));
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  program->Set("TileShift", this->Grid.Shift);
  program->Set("BucketScale", this->BucketScale);
  for (const vtkPointSplatItem& item : part.Items)
  {
    const vtkIdType count = TriangleRecordsOf(item);
    if (count == 0)
    {
      continue;
    }
    const vtkPointSplatBuffer& corners = item.Cloud->UploadTriangles();
    vtkPointSplatCloud::Buffers& buffers =
      item.Upload(variant.Ids ? &request.Ids : nullptr);
    item.SetUniforms(*program, request.View);
    program->Set("RecordCount", static_cast<unsigned int>(count));
    program->Set("TriangleCount", static_cast<unsigned int>(item.GetNumberOfTriangles()));
    program->Set("HasColours", item.Cloud->HasColours());
    program->Set("HasFactors", item.Factors != nullptr);
    program->Set("NamesCells", request.Ids == vtkPointSplatCloud::CellIds);
    units.Bind(*program, "Splats", GL_TEXTURE_BUFFER, buffers.Splats.GetTexture());
    units.Bind(*program, "Corners", GL_TEXTURE_BUFFER, corners.GetTexture());
    units.Bind(*program, "Colours", GL_TEXTURE_BUFFER, buffers.Colours.GetTexture());
    units.Bind(*program, "Factors", GL_TEXTURE_BUFFER,
      item.Factors ? item.Factors->GetTexture() : 0);
    units.Bind(*program, "Ids", GL_TEXTURE_BUFFER, variant.Ids ? buffers.Ids.GetTexture() : 0);
    this->Blocks.Upload(item.Runs->Triangles);
    this->Blocks.BindStorage(7);
    this->DispatchRecords(*program, variant, first, count);
    first += count;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatTiles::DispatchRecords(
  vtkPointSplatProgram& program, const Variant& variant, vtkIdType first, vtkIdType count)
{
  const std::vector<Share> shares = this->SharesOf(variant);
  for (vtkIdType begin = 0; begin < count; begin += SplatsPerDispatch)
  {
    const vtkIdType records = std::min(SplatsPerDispatch, count - begin);
    const GLintptr at = static_cast<GLintptr>(first + begin);
    for (const Share& share : shares)
    {
      share.Buffer->BindStorage(share.Binding, share.Bytes * at, share.Bytes * records);
    }
    program.Set("FirstInvocation", static_cast<unsigned int>(begin));
    vtkPointSplatProgram::Dispatch(records);
  }
}
