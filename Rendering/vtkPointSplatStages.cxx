// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatStages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>

namespace
{
constexpr GLuint GroupSize = 64;     // as in vtkPointSplatSplatsCS.glsl and PointsCS
constexpr GLuint PointsPerGroup = 8 * GroupSize; // as in PointsCS
constexpr GLuint MostGroups = 32768;  // in one dimension; OpenGL promises 65535
constexpr GLuint LargeGroups = 256;   // share the listed splats of many pixels

/// Sets the count at a buffer's beginning to 0.
void ClearCount(GLuint buffer)
{
  const GLuint zero = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glClearBufferSubData(
    GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, 4, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatItem::operator==(const vtkPointSplatItem& other) const
{
  return this->Cloud == other.Cloud && this->MCWC == other.MCWC && this->Slot == other.Slot &&
    this->Culling == other.Culling && this->RadiusScale == other.RadiusScale &&
    this->LayerDistance == other.LayerDistance && this->KernelType == other.KernelType &&
    this->KernelShape == other.KernelShape && this->KernelSupport == other.KernelSupport &&
    this->ClipPlanes == other.ClipPlanes && this->Colour == other.Colour &&
    this->CoveringScale == other.CoveringScale && this->Refracts == other.Refracts &&
    this->Factors == other.Factors && this->FactorCount == other.FactorCount &&
    this->FactorVersion == other.FactorVersion && this->Points == other.Points &&
    this->PointLayer == other.PointLayer && this->PointLayerPixels == other.PointLayerPixels &&
    this->Silhouettes == other.Silhouettes;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkPointSplatItem::GetMCVC(const vtkPointSplatView& view) const
{
  // In double precision: only the product of a far camera and a far cloud is small.
  const auto& origin = this->Cloud->GetOrigin();
  glm::dmat4 MCVC = view.WCVC * this->MCWC;
  MCVC[3] = MCVC * glm::dvec4(origin[0], origin[1], origin[2], 1.0);
  return MCVC;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkPointSplatItem::GetClipPlanesVC(const vtkPointSplatView& view) const
{
  std::vector<glm::dvec4> planes;
  const glm::dmat4 VCWCTransposed = glm::transpose(glm::inverse(view.WCVC));
  for (const glm::dvec4& plane : this->ClipPlanes)
  {
    planes.emplace_back(VCWCTransposed * plane);
  }
  return planes;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::ComputeSupported(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  return major > 4 || (major == 4 && minor >= 3);
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatStages::Use(
  Stage stage, bool compute, const vtkPointSplatItem& item, const vtkPointSplatPeel* peel,
  const vtkPointSplatImages* sums)
{
  static const char* const names[3] = { "Visibility", "Accumulate", "Identify" };
  static const char* const pointNames[3] = { "PointDepth", "PointAccumulate", "PointIdentify" };
  // What the whole frame has in common is decided before, where it costs each splat nothing.
  std::string defines = peel ? "#define PEELING\n" : "";
  defines += sums && sums->HasColours() ? "#define COLOURS\n" : "";
  defines += sums && sums->GetFactorCount() > 0
    ? "#define FACTORS " + std::to_string(sums->GetFactorCount()) + "\n"
    : "";
  defines += item.ClipPlanes.empty() ? "" : "#define CLIPPING\n";
  const std::string name =
    std::string("vtkPointSplat") + (item.Points ? pointNames[stage] : names[stage]);
  vtkPointSplatProgram& program = this->Programs[(compute ? "CS" : "FS") + name + defines];
  if (!program.IsBuilt())
  {
    std::vector<std::pair<GLenum, std::string>> files;
    if (compute)
    {
      files.emplace_back(GL_COMPUTE_SHADER, name + "CS");
    }
    else
    {
      files.emplace_back(
        GL_VERTEX_SHADER, item.Points ? "vtkPointSplatPointVS" : "vtkPointSplatQuadVS");
      files.emplace_back(GL_FRAGMENT_SHADER, name + "FS");
    }
    if (!program.Build(files, defines))
    {
      this->Error = program.GetLog();
      return nullptr;
    }
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::SetPeel(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
  const vtkPointSplatView& view, const vtkPointSplatPeel* peel, bool compute)
{
  static const char* const names[] = { "Previous0", "Previous1", "Previous2" };
  if (!peel)
  {
    return;
  }
  const size_t count = peel->Previous.size();
  program.Set("PreviousCount", static_cast<int>(count));
  for (size_t k = 0; k < 3; ++k)
  {
    const vtkPointSplatImages* images = count ? peel->Previous[std::min(k, count - 1)] : nullptr;
    units.Bind(program, names[k], compute ? GL_TEXTURE_BUFFER : GL_TEXTURE_2D,
      images ? images->GetDepthTexture() : 0);
  }
  program.Set("HasSceneDepth", peel->SceneDepth != 0);
  units.Bind(program, "SceneDepth", GL_TEXTURE_2D, peel->SceneDepth);
  program.Set("PixelZ", view.PixelZ);
  program.Set("Gather", peel->Gather);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::SetItem(vtkPointSplatProgram& program, const vtkPointSplatView& view,
  const vtkPointSplatItem& item, const glm::ivec2& imageSize)
{
  const glm::dmat4 MCVC = item.GetMCVC(view);
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(MCVC)));
  const std::vector<glm::dvec4> clip = item.GetClipPlanesVC(view);
  const std::vector<glm::vec4> planes(clip.begin(), clip.end());
  program.Set("MCVC", glm::mat4(MCVC));
  program.Set("NormalMatrix", glm::mat3(normals));
  program.Set("PixelX", view.PixelX);
  program.Set("PixelY", view.PixelY);
  program.Set("PixelW", view.PixelW);
  program.Set("Window", item.Window);
  program.Set("DepthRange",
    glm::vec2(static_cast<float>(view.Near), static_cast<float>(view.Far - view.Near)));
  program.Set("Parallel", view.Parallel);
  program.Set("Circular", item.Cloud->IsCircular());
  program.Set("RadiusScale", static_cast<float>(item.RadiusScale));
  program.Set("Culling", item.Culling);
  program.Set("Tag", static_cast<unsigned int>(item.Slot) << 1);
  program.Set("LayerDistance", static_cast<float>(item.LayerDistance));
  program.Set("PointLayer", static_cast<float>(item.PointLayer));
  program.Set("PointLayerPixels", static_cast<float>(item.PointLayerPixels));
  program.Set("ClipPlaneCount", static_cast<int>(planes.size()));
  program.Set("ClipPlanes", planes);
  program.Set("KernelType", item.KernelType);
  program.Set("KernelShape", item.KernelShape);
  program.Set("KernelSupport", static_cast<float>(item.KernelSupport));
  program.Set("HasColours", item.Cloud->HasColours());
  program.Set("HasFactors", item.Factors != 0);
  program.Set("ItemColour", glm::vec4(1.0f));
  program.Set("ImageWidth", imageSize.x);
  program.Set("ImageSize", imageSize);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::Dispatch(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
  vtkIdType splats, vtkPointSplatCloud::Buffers& buffers)
{
  units.Bind(program, "Splats", GL_TEXTURE_BUFFER, buffers.SplatTexture);
  const GLuint groups = static_cast<GLuint>((splats + GroupSize - 1) / GroupSize);
  program.Set("SplatCount", static_cast<unsigned int>(splats));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers.Large);
  ClearCount(buffers.Large);
  program.Set("ListLarge", true);
  program.Set("DrawLarge", false);
  glDispatchCompute(std::min(groups, MostGroups), (groups + MostGroups - 1) / MostGroups, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  program.Set("DrawLarge", true);
  glDispatchCompute(LargeGroups, 1, 1);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::DispatchPoints(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
  size_t index, const vtkPointSplatItem& item, vtkIdType count, bool listed,
  vtkPointSplatCloud::Buffers& buffers) const
{
  const bool batches = !listed && item.Batches;
  const vtkIdType points = batches
    ? static_cast<vtkIdType>(item.Batches->size()) * vtkPointSplatBatches::Size
    : count;
  if (points == 0)
  {
    return;
  }
  units.Bind(program, "Splats", GL_TEXTURE_BUFFER, buffers.SplatTexture);
  program.Set("SplatCount", static_cast<unsigned int>(count));
  program.Set("DrawBatches", batches);
  program.Set("BatchCount", static_cast<unsigned int>(batches ? item.Batches->size() : 0));
  if (batches)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 7, this->BatchBuffers[index]);
  }
  const GLuint groups = static_cast<GLuint>((points + PointsPerGroup - 1) / PointsPerGroup);
  glDispatchCompute(std::min(groups, MostGroups), (groups + MostGroups - 1) / MostGroups, 1);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::UploadBatches(const std::vector<vtkPointSplatItem>& items)
{
  this->BatchBuffers.resize(std::max(this->BatchBuffers.size(), items.size()), 0);
  for (size_t i = 0; i < items.size(); ++i)
  {
    if (!items[i].Batches)
    {
      continue;
    }
    GLuint& buffer = this->BatchBuffers[i];
    if (!buffer)
    {
      glGenBuffers(1, &buffer);
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(4 * items[i].Batches->size()),
      items[i].Batches->data(), GL_STREAM_DRAW);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::PrepareLists(const std::vector<vtkPointSplatItem>& items, int layer)
{
  this->ItemLists.resize(std::max(this->ItemLists.size(), items.size()));
  for (size_t i = 0; i < items.size(); ++i)
  {
    Lists& lists = this->ItemLists[i];
    const vtkIdType splats = items[i].Cloud->GetNumberOfSplats();
    if (lists.Capacity < splats)
    {
      glDeleteBuffers(2, lists.Buffers);
      glGenBuffers(2, lists.Buffers);
      lists.Capacity = splats;
      for (const GLuint buffer : lists.Buffers)
      {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
        glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(4 * (splats + 1)), nullptr,
          GL_DYNAMIC_COPY);
      }
    }
    lists.Count = splats;
    if (layer > 0)
    {
      GLuint count = 0;
      glBindBuffer(GL_SHADER_STORAGE_BUFFER, lists.Buffers[(layer - 1) % 2]);
      glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, 4, &count);
      lists.Count = static_cast<vtkIdType>(count);
    }
    ClearCount(lists.Buffers[layer % 2]);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::ReconstructByCompute(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, const vtkPointSplatPeel* peel, bool* empty)
{
  vtkPointSplatUnits units(window);
  vtkPointSplatProgram* program = nullptr;
  if (!this->Found)
  {
    glGenBuffers(1, &this->Found);
  }
  const GLuint nothing = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Found);
  glBufferData(GL_SHADER_STORAGE_BUFFER, 4, &nothing, GL_STREAM_READ);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, this->Found);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, images.GetDepths());
  // Draws an item's splats: all of them, or those that earlier layers have left.
  auto draw = [&](size_t i, bool listNext) {
    vtkIdType splats = items[i].Cloud->GetNumberOfSplats();
    program->Set("DrawListed", peel && peel->Layer > 0);
    program->Set("ListNext", peel && listNext);
    if (peel)
    {
      const Lists& lists = this->ItemLists[i];
      splats = lists.Count;
      glBindBufferBase(
        GL_SHADER_STORAGE_BUFFER, 4, lists.Buffers[(peel->Layer + 1) % 2]);
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, lists.Buffers[peel->Layer % 2]);
    }
    if (items[i].Points)
    {
      this->DispatchPoints(*program, units, i, items[i], splats, peel && peel->Layer > 0,
        items[i].Cloud->Upload(window));
    }
    else if (splats > 0)
    {
      vtkPointSplatStages::Dispatch(*program, units, splats, items[i].Cloud->Upload(window));
    }
  };
  if (!peel || peel->Layer == 0)
  {
    this->UploadBatches(items);
  }
  if (peel)
  {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    this->PrepareLists(items, peel->Layer);
  }
  for (size_t i = 0; i < items.size(); ++i)
  {
    program = this->Use(Visibility, true, items[i], peel);
    if (!program)
    {
      return false;
    }
    SetPeel(*program, units, view, peel, true);
    this->SetItem(*program, view, items[i], images.GetSize());
    program->Set("DiskReach", DiskReach);
    program->Set("CoverageRadius", CoverageRadius);
    draw(i, false);
  }
  if (empty)
  {
    GLuint found = 0;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Found);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, 4, &found);
    *empty = found == 0;
    if (*empty)
    {
      return true;
    }
  }
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, images.GetSums());
  for (size_t i = 0; i < items.size(); ++i)
  {
    const vtkPointSplatItem& item = items[i];
    program = this->Use(Accumulation, true, item, peel, &images);
    if (!program)
    {
      return false;
    }
    SetPeel(*program, units, view, peel, true);
    units.Bind(*program, "Depths", GL_TEXTURE_BUFFER, images.GetDepthTexture());
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("PrefilterRadius", PrefilterRadius);
    program->Set("DepthUnit", depthUnit);
    program->Set("SumStride", images.GetSumStride());
    program->Set("FactorWord", images.GetFactorWord());
    if (peel && peel->Gather)
    {
      program->Set("ItemColour", item.Colour);
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, item.Cloud->Upload(window).Colours);
    if (images.GetFactorCount() > 0)
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, item.Factors);
    }
    draw(i, true);
  }
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::Reconstruct(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, const vtkPointSplatPeel* peel, bool* empty)
{
  window->GetShaderCache()->ReleaseCurrentShader();
  bool good = false;
  if (images.IsCompute())
  {
    good = this->ReconstructByCompute(window, view, items, images, depthUnit, peel, empty);
  }
  else
  {
    vtkOpenGLState* state = window->GetState();
    const vtkPointSplatSavedState saved(state);
    good = this->ReconstructByQuads(window, view, items, images, depthUnit, peel, empty);
  }
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::Identify(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
  const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images,
  vtkPointSplatCloud::IdKind kind)
{
  window->GetShaderCache()->ReleaseCurrentShader();
  bool good = false;
  if (images.IsCompute())
  {
    vtkPointSplatUnits units(window);
    images.ClearIdBuffer({ 0, 0, images.GetSize().x - 1, images.GetSize().y - 1 });
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, images.GetIds());
    this->UploadBatches(items);
    good = true;
    for (const bool findWeight : { true, false })
    {
      for (size_t i = 0; i < items.size(); ++i)
      {
        const vtkPointSplatItem& item = items[i];
        if (vtkPointSplatProgram* program = this->Use(Identification, true, item))
        {
          units.Bind(*program, "Depths", GL_TEXTURE_BUFFER, images.GetDepthTexture());
          const GLuint idMap = item.Cloud->UploadIdMap(window, kind);
          this->SetItem(*program, view, item, images.GetSize());
          program->Set("PrefilterRadius", PrefilterRadius);
          program->Set("FindWeight", findWeight);
          program->Set("UseIdMap", idMap != 0);
          glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, idMap);
          program->Set("DrawListed", false);
          program->Set("ListNext", false);
          const vtkIdType splats = item.Cloud->GetNumberOfSplats();
          if (item.Points)
          {
            this->DispatchPoints(
              *program, units, i, item, splats, false, item.Cloud->Upload(window));
          }
          else
          {
            vtkPointSplatStages::Dispatch(*program, units, splats, item.Cloud->Upload(window));
          }
        }
        else
        {
          good = false;
        }
      }
      glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
  }
  else
  {
    vtkOpenGLState* state = window->GetState();
    const vtkPointSplatSavedState saved(state);
    good = this->IdentifyByQuads(window, view, items, images, kind);
  }
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::Release()
{
  for (auto& program : this->Programs)
  {
    program.second.Release();
  }
  if (this->Found)
  {
    glDeleteBuffers(1, &this->Found);
    this->Found = 0;
  }
  for (Lists& lists : this->ItemLists)
  {
    glDeleteBuffers(2, lists.Buffers);
  }
  this->ItemLists.clear();
  glDeleteBuffers(static_cast<GLsizei>(this->BatchBuffers.size()), this->BatchBuffers.data());
  this->BatchBuffers.clear();
}
