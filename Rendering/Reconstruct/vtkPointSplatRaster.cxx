// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRaster.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatPointSizes.h"
#include "vtkPointSplatQuads.h"
#include "vtkPointSplatReach.h"
#include "vtkPointSplatSavedState.h"

namespace
{
const GLuint NoDepth[4] = { 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu };
const GLfloat Zero[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
const GLfloat Farthest = 1.0f;

const char* const VisibilityFile = "vtkPointSplatVisibilityFS";
const char* const AccumulateFile = "vtkPointSplatAccumulateFS";
const char* const IdentifyFile = "vtkPointSplatIdentifyFS";
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatRaster::Use(
  const vtkPointSplatItem& item, const std::string& file, const std::string& common)
{
  const std::string defines = common +
    (file == AccumulateFile && item.Cloud->HasValues() ? "#define VALUES\n" : "") +
    (item.ClipPlanes.empty() ? "" : "#define CLIPPING\n") +
    (item.IsPoints          ? "#define POINTS\n"
        : item.Kernel.Plateau ? "#define PLATEAU\n"
                              : "") +
    (item.Cloud->HasClipLines() && !item.IsPoints ? "#define CLIP_LINES\n" : "");
  vtkPointSplatProgram& program = this->Programs[file + defines];
  if (!program.Build({ { GL_VERTEX_SHADER,
                         item.IsPoints ? "vtkPointSplatPointVS" : "vtkPointSplatQuadVS" },
                       { GL_FRAGMENT_SHADER, file } },
        defines))
  {
    this->Error = program.GetLog();
    return nullptr;
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
bool vtkPointSplatRaster::DrawAll(const vtkPointSplatRequest& request,
  const vtkPointSplatPeel& peel, const vtkPointSplatSums& sums, const vtkPointSplatImage& codes,
  const std::string& file)
{
  const bool sees = file == VisibilityFile;
  const bool identifies = file == IdentifyFile;
  const bool factors = file == AccumulateFile && sums.GetContent().Factors > 0;
  const bool shows = identifies && request.ShowsGreatest();
  const std::string defines =
    (identifies && !shows ? std::string() : peel.GetDefines()) +
    (factors ? "#define FACTORS\n" : "");
  const unsigned int tagMask = request.GetTagMask();
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  const vtkPointSplatPointSizes sizes;
  for (const vtkPointSplatItem& item : request.Items)
  {
    const bool facets = shows && item.IsFlat && !item.Cloud->HasCellColours();
    if (!item.IsInView() || (shows && !facets && !item.Cloud->HasCellColours()))
    {
      continue;
    }
    // A program of its own may fill them.
    vtkPointSplatCloud::Buffers& buffers =
      item.Upload(identifies && !shows ? &request.Ids : nullptr);
    vtkPointSplatProgram* program = this->Use(item, file, defines + (facets ? "#define FACETS\n" : ""));
    if (!program)
    {
      return false;
    }
    vtkPointSplatQuads::SetUniforms(*program, item, request.View, tagMask);
    program->Set(
      "Reach", sees ? vtkPointSplatReach::Disk : static_cast<float>(item.Kernel.Support));
    program->Set("LeastRadii",
      sees ? glm::vec2(vtkPointSplatReach::Coverage, vtkPointSplatReach::CoverageDot)
           : glm::vec2(vtkPointSplatReach::Prefilter));
    program->Set("DepthUnit", static_cast<float>(request.GetDepthUnit()));
    program->Set("ItemColour", peel.Gather ? item.Colour : glm::vec4(1.0f));
    program->Set("ValueMap", item.GetValueMap());
    if (!identifies || shows)
    {
      peel.Bind(units, *program, request.View.PixelZ);
    }
    if (!sees)
    {
      units.Bind(*program, "Depths", GL_TEXTURE_2D, codes.Get());
      units.Bind(*program, "ValueTables", GL_TEXTURE_BUFFER, buffers.ValueTable.GetTexture());
    }
    vtkPointSplatQuads::Draw(
      item, buffers, facets ? nullptr
        : shows     ? &buffers.Colours
        : identifies ? &buffers.Ids
                     : nullptr);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatRaster::Project(const vtkPointSplatRequest& request,
  const vtkPointSplatPeel& peel, vtkPointSplatSums& sums, const vtkPointSplatImage& codes,
  bool& empty)
{
  vtkOpenGLState* state = vtkPointSplatContext::Entered().GetWindow()->GetState();
  const vtkPointSplatSavedState saved(state);
  saved.SetForImages(request.View.Size);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);

  this->Visibility.Bind(state, { codes }, sums.DepthTest);
  glClearBufferuiv(GL_COLOR, 0, NoDepth);
  glClearBufferfv(GL_DEPTH, 0, &Farthest);
  if (peel.Peels)
  {
    this->Samples.Make();
    glBeginQuery(GL_SAMPLES_PASSED, this->Samples.Get());
  }
  const bool seen = this->DrawAll(request, peel, sums, codes, VisibilityFile);
  empty = false;
  if (peel.Peels)
  {
    GLuint samples = 0;
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(this->Samples.Get(), GL_QUERY_RESULT, &samples);
    empty = samples == 0;
  }
  if (!seen || empty)
  {
    return seen;
  }

  std::vector<vtkPointSplatFramebuffer::Target> targets{ sums.WeightAndNormal, sums.DepthAndColour,
    sums.Opacities };
  if (sums.GetContent().Factors > 0)
  {
    targets.emplace_back(sums.Factors);
  }
  this->Accumulation.Bind(state, targets);
  for (size_t k = 0; k < targets.size(); ++k)
  {
    glClearBufferfv(GL_COLOR, static_cast<GLint>(k), Zero);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD); // depth peeling takes maxima
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  bool good = this->DrawAll(request, peel, sums, codes, AccumulateFile);
  state->vtkglDisable(GL_BLEND);
  if (good && sums.GetContent().Ids)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_TRUE);
    this->Identification.Bind(state, { sums.Ids }, sums.DepthTest);
    glClearBufferuiv(GL_COLOR, 0, NoDepth);
    glClearBufferfv(GL_DEPTH, 0, &Farthest);
    good = this->DrawAll(request, peel, sums, codes, IdentifyFile);
  }
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatRaster::Release()
{
  this->Programs.clear();
  this->Visibility.Release();
  this->Accumulation.Release();
  this->Identification.Release();
  this->Samples.Release();
}
