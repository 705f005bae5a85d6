// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPointSums.h"

#include "vtkPointSplatQuads.h"

#include <algorithm>

namespace
{
constexpr vtkIdType PointsPerGroup = 8 * 64; // as in vtkPointSplatPointsCS.glsl
constexpr GLint64 LargestSumBytes = 32;      // a pixel

const char* const DepthFile = "vtkPointSplatPointDepthCS";
const char* const PointAccumulateFile = "vtkPointSplatPointAccumulateCS";
const char* const PointIdentifyFile = "vtkPointSplatPointIdentifyCS";
}

//------------------------------------------------------------------------------
bool vtkPointSplatPointSums::Fits(const glm::ivec2& size)
{
  GLint64 block = 0;
  GLint texels = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  const GLint64 pixels = static_cast<GLint64>(size.x) * size.y;
  return pixels * LargestSumBytes <= block && pixels * 2 <= texels;
}

//------------------------------------------------------------------------------
void vtkPointSplatPointSums::PrepareLists(const vtkPointSplatRequest& request, int layer)
{
  this->ItemLists.resize(std::max(this->ItemLists.size(), request.Items.size()));
  for (size_t i = 0; i < request.Items.size(); ++i)
  {
    Lists& lists = this->ItemLists[i];
    lists.Count = request.Items[i].GetNumberOfInvocations();
    if (layer > 0)
    {
      GLuint count = 0;
      lists.Buffers[(layer + 1) % 2].Download(&count, 4);
      lists.Count = static_cast<vtkIdType>(count);
    }
    lists.Buffers[layer % 2].Reserve(4 * (request.Items[i].GetNumberOfInvocations() + 1));
    lists.Buffers[layer % 2].Fill(0, 4, 0u);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatPointSums::DrawAll(const vtkPointSplatRequest& request,
  const vtkPointSplatPeel& peel, const vtkPointSplatSums& sums, const std::string& file)
{
  const bool identifies = file == PointIdentifyFile;
  const bool ofCells = identifies && request.HasCellColours();
  const bool listed = peel.Peels && !identifies;
  const unsigned int tagMask = request.GetTagMask();
  const int factors = sums.GetContent().Factors;
  const std::string common = (identifies ? std::string() : peel.GetDefines()) +
    (file == PointAccumulateFile && sums.GetContent().Colours ? "#define COLOURS\n" : "") +
    (file == PointAccumulateFile && factors > 0 ? "#define FACTORS " + std::to_string(factors) + "\n"
                                           : "");
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  for (size_t i = 0; i < request.Items.size(); ++i)
  {
    const vtkPointSplatItem& item = request.Items[i];
    const vtkIdType count =
      listed ? this->ItemLists[i].Count : item.GetNumberOfInvocations();
    if (!item.IsInView() || count == 0 || (ofCells && !item.Cloud->HasCellColours()))
    {
      continue;
    }
    const std::string defines = common +
      (file == PointAccumulateFile && item.Cloud->HasValues() ? "#define VALUES\n" : "") +
      (item.ClipPlanes.empty() ? "" : "#define CLIPPING\n");
    vtkPointSplatProgram& program = this->Programs[file + defines];
    if (!program.Build({ { GL_COMPUTE_SHADER, file } }, defines))
    {
      this->Error = program.GetLog();
      return false;
    }
    vtkPointSplatCloud::Buffers& buffers =
      item.Upload(identifies && !ofCells ? &request.Ids : nullptr);
    program.Use();
    vtkPointSplatQuads::SetUniforms(program, item, request.View, tagMask);
    units.Bind(program, "Splats", GL_TEXTURE_BUFFER, buffers.Splats.GetTexture());
    program.Set("ImageWidth", request.View.Size.x);
    item.SetBlockUniforms(program);
    program.Set("DrawListed", peel.Layer > 0);
    if (item.Runs)
    {
      this->Blocks.Upload(item.GetRunsIn(buffers));
      this->Blocks.BindStorage(7);
    }
    if (listed)
    {
      peel.Bind(units, program, request.View.PixelZ);
      this->ItemLists[i].Buffers[(peel.Layer + 1) % 2].BindStorage(4);
      this->ItemLists[i].Buffers[peel.Layer % 2].BindStorage(5);
    }
    if (file != DepthFile)
    {
      units.Bind(program, "Depths", GL_TEXTURE_BUFFER, sums.DepthBuffer.GetTexture());
      units.Bind(program, "SplatIds", GL_TEXTURE_BUFFER,
        ofCells ? buffers.Colours.GetTexture() : identifies ? buffers.Ids.GetTexture() : 0);
      units.Bind(program, "Colours", GL_TEXTURE_BUFFER, buffers.Colours.GetTexture());
      units.Bind(program, "Factors", GL_TEXTURE_BUFFER,
        item.Factors ? item.Factors->GetTexture() : 0);
      units.Bind(
        program, "ValueTables", GL_TEXTURE_BUFFER, buffers.ValueTable.GetTexture());
      program.Set("ValueMap", item.GetValueMap());
      program.Set("ItemColour", peel.Gather ? item.Colour : glm::vec4(1.0f));
      program.Set("DepthUnit", static_cast<float>(request.GetDepthUnit()));
      program.Set("SumStride", sums.GetSumStride());
    }
    vtkPointSplatProgram::Dispatch((count + 7) / 8, PointsPerGroup / 8);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatPointSums::Project(const vtkPointSplatRequest& request,
  const vtkPointSplatPeel& peel, vtkPointSplatSums& sums, bool& empty)
{
  empty = false;
  if (peel.Peels)
  {
    const GLuint nothing = 0;
    this->Found.Upload(&nothing, 4);
    this->Found.BindStorage(3);
    this->PrepareLists(request, peel.Layer);
  }
  sums.DepthBuffer.BindStorage(0);
  bool good = this->DrawAll(request, peel, sums, DepthFile);
  if (good && peel.Peels)
  {
    GLuint found = 0;
    this->Found.Download(&found, 4);
    empty = found == 0;
  }
  if (good && !empty)
  {
    sums.SumBuffer.BindStorage(0);
    good = this->DrawAll(request, peel, sums, PointAccumulateFile);
    if (good && sums.GetContent().Ids)
    {
      sums.IdBuffer.BindStorage(0);
      good = this->DrawAll(request, peel, sums, PointIdentifyFile);
    }
  }
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatPointSums::GetMemorySize() const
{
  vtkIdType bytes = this->Blocks.GetSize();
  for (const Lists& lists : this->ItemLists)
  {
    bytes += lists.Buffers[0].GetSize() + lists.Buffers[1].GetSize();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatPointSums::Release()
{
  this->Programs.clear();
  this->ItemLists.clear();
  this->Blocks.Release();
  this->Found.Release();
}
