// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatResolve.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatUnits.h"
#include "vtkRenderer.h"
#include "vtkSSAOPass.h"
#include "vtkShaderProgram.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

#include <algorithm>
#include <vector>

namespace
{
/// Values of OUTLINES in vtkPointSplatOutline.glsl.
constexpr int OutlineMeans = 1;
constexpr int OutlinesAlone = 3;

/// How outlines are drawn to the framebuffer that is bound, one draw after another.
std::vector<int> StepsFor(const vtkPointSplatOutlines& outlines)
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return outlines.GetCount() == 0 ? std::vector<int>{ 0 }
    : samples > 1                 ? std::vector<int>{ 2, OutlinesAlone }
                                  : std::vector<int>{ OutlineMeans };
}

/// all: that of a draw over all pixels.
const char* VertexFile(int outlines, const char* all)
{
  return outlines == OutlinesAlone ? "vtkPointSplatOutlineVS" : all;
}

std::string Define(int outlines)
{
  return "#define OUTLINES " + std::to_string(outlines) + "\n";
}

std::vector<vtkOpenGLRenderPass*> PassesOf(vtkActor* actor)
{
  std::vector<vtkOpenGLRenderPass*> passes;
  vtkInformation* info = actor->GetPropertyKeys();
  if (info && info->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    const int count = info->Length(vtkOpenGLRenderPass::RenderPasses());
    for (int i = 0; i < count; ++i)
    {
      if (auto pass = vtkOpenGLRenderPass::SafeDownCast(
            info->Get(vtkOpenGLRenderPass::RenderPasses(), i)))
      {
        passes.push_back(pass);
      }
    }
  }
  return passes;
}

/// What a pass that draws shadow maps writes of a pixel. The code is a mesh's, whose fragments have
/// coordinates of their own.
std::string ShadowMapCode(vtkOpenGLRenderPass* baker, vtkMapper* mapper, vtkActor* actor)
{
  std::string vertex;
  std::string geometry;
  std::string code = "//VTK::Light::Impl";
  baker->PreReplaceShaderValues(vertex, geometry, code, mapper, actor);
  vtkShaderProgram::Substitute(code, "gl_FragCoord", "coordinate");
  return code;
}

/// Hands a shadow map pass's factors on, by the lights' places among those that are on, as
/// vtkOpenGLPolyDataMapper takes them.
std::string PassFactorsCode(size_t lights)
{
  std::string code;
  for (size_t i = 0; i < lights; ++i)
  {
    const std::string index = std::to_string(i);
    code += "passFactors[" + index + "] = factor" + index + ".r;\n";
  }
  return code;
}
}

/**
 * What render passes add to shaders.
 */
struct vtkPointSplatResolve::Hooks
{
  explicit Hooks(vtkActor* actor)
    : Passes(PassesOf(actor))
  {
  }
  bool WantGeometryBuffer() const
  {
    return std::any_of(this->Passes.begin(), this->Passes.end(),
      [](vtkOpenGLRenderPass* pass) { return vtkSSAOPass::SafeDownCast(pass) != nullptr; });
  }
  /// Of VTK's shadow maps: the pass that draws them, and that whose light they take away; or null.
  vtkOpenGLRenderPass* GetShadowBaker() const { return this->Find("vtkShadowMapBakerPass"); }
  vtkOpenGLRenderPass* GetShadowPass() const { return this->Find("vtkShadowMapPass"); }

  vtkOpenGLRenderPass* Find(const char* name) const
  {
    const auto found = std::find_if(this->Passes.begin(), this->Passes.end(),
      [name](vtkOpenGLRenderPass* pass) { return pass->IsA(name) != 0; });
    return found == this->Passes.end() ? nullptr : *found;
  }
  std::vector<vtkOpenGLRenderPass*> Passes;
};

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::AreHooksShared(vtkActor* actor)
{
  const std::vector<vtkOpenGLRenderPass*> passes = PassesOf(actor);
  const char* const shared[] = { "vtkDualDepthPeelingPass", "vtkDepthPeelingPass",
    "vtkOrderIndependentTranslucentPass", "vtkSSAOPass", "vtkShadowMapBakerPass",
    "vtkShadowMapPass", "vtkPointSplatShadowPass" };
  return std::all_of(passes.begin(), passes.end(), [&shared](vtkOpenGLRenderPass* pass) {
    return std::any_of(std::begin(shared), std::end(shared),
      [pass](const char* name) { return pass->IsA(name) != 0; });
  });
}

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::AreOutlinesSmooth(vtkActor* actor)
{
  const Hooks hooks(actor);
  return !hooks.GetShadowBaker() && !hooks.GetShadowPass();
}

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::Use(const Target& target, const char* vertexFile, const char* file,
  const std::string& defines, vtkPointSplatProgram& program)
{
  const Hooks hooks(target.Actor);
  std::string vertex = vtkPointSplatProgram::Source(vertexFile);
  std::string geometry;
  std::string fragment = vtkPointSplatProgram::Source(file);
  for (vtkOpenGLRenderPass* pass : hooks.Passes)
  {
    pass->PreReplaceShaderValues(vertex, geometry, fragment, target.Mapper, target.Actor);
  }
  const auto shadows = vtkShadowMapPass::SafeDownCast(hooks.GetShadowPass());
  vtkOpenGLRenderPass* baker = hooks.GetShadowBaker();
  vtkShaderProgram::Substitute(fragment, "//PointSplat::Defines",
    defines + (shadows ? "#define PASS_FACTORS\n" : "") + (baker ? "#define SHADOW_MAP\n" : ""));
  if (shadows)
  {
    vtkShaderProgram::Substitute(fragment, "//PointSplat::PassFactors",
      PassFactorsCode(std::min(shadows->GetShadowMapTextureUnits().size(),
        vtkPointSplatLights::Of(target.Renderer, false).size())));
  }
  if (baker)
  {
    vtkShaderProgram::Substitute(
      fragment, "//PointSplat::ShadowMap", ShadowMapCode(baker, target.Mapper, target.Actor));
  }
  vtkShaderProgram::Substitute(fragment, "//PointSplat::GeometryBuffer",
    hooks.WantGeometryBuffer() ? vtkPointSplatProgram::Source("vtkPointSplatGeometryBuffer")
                               : std::string());
  for (vtkOpenGLRenderPass* pass : hooks.Passes)
  {
    pass->PostReplaceShaderValues(vertex, geometry, fragment, target.Mapper, target.Actor);
  }
  auto window = static_cast<vtkOpenGLRenderWindow*>(target.Renderer->GetRenderWindow());
  vtkShaderProgram* ready =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!ready)
  {
    this->Error = "the shaders that present layers do not build.";
    return false;
  }
  program.Borrow(static_cast<GLuint>(ready->GetHandle()));
  for (vtkOpenGLRenderPass* pass : hooks.Passes)
  {
    pass->SetShaderParameters(ready, target.Mapper, target.Actor, nullptr);
  }
  return true;
}

//------------------------------------------------------------------------------
template <typename Function>
void vtkPointSplatResolve::Draw(
  const Target& target, const vtkPointSplatView& view, const Function& draw)
{
  vtkOpenGLState* state =
    static_cast<vtkOpenGLRenderWindow*>(target.Renderer->GetRenderWindow())->GetState();
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  // Within what the renderer, or an area selection, lets through.
  int clip[4];
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, clip);
  glm::ivec2 low = view.Origin + glm::ivec2(target.Window);
  glm::ivec2 high = view.Origin + glm::ivec2(target.Window.z, target.Window.w) + 1;
  if (state->GetEnumState(GL_SCISSOR_TEST))
  {
    low = glm::max(low, glm::ivec2(clip[0], clip[1]));
    high = glm::min(high, glm::ivec2(clip[0] + clip[2], clip[1] + clip[3]));
  }
  if (low.x < high.x && low.y < high.y)
  {
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(low.x, low.y, high.x - low.x, high.y - low.y);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglEnable(GL_DEPTH_TEST);
    // What is drawn has its place in the images, which may be of a part of the window.
    vtkOpenGLState::ScopedglViewport viewport(state);
    state->vtkglViewport(view.Origin.x, view.Origin.y, view.Size.x, view.Size.y);
    draw();
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::Present(const Target& target, const vtkPointSplatShading& shading,
  const Source& source, int layer, int slot)
{
  const vtkPointSplatLayers& layers = source.Layers;
  for (const int outlines : StepsFor(source.Outlines))
  {
    if (outlines == OutlineMeans &&
      !this->Means.Shade(shading, layers, source.Outlines, { layer, slot, target.Blends }))
    {
      this->Error = this->Means.GetError();
      return false;
    }
    vtkPointSplatProgram program;
    if (!this->Use(target, VertexFile(outlines, "vtkPointSplatLayersVS"), "vtkPointSplatLayerFS",
          "#define OUTPUT 0\n" + Define(outlines) + layers.GetDefines() +
            shading.GetDefines(layers.GetGathered() >= 0),
          program))
    {
      return false;
    }
    vtkPointSplatUnits units(
      static_cast<vtkOpenGLRenderWindow*>(target.Renderer->GetRenderWindow()));
    layers.Bind(units, program);
    source.Outlines.Bind(units, program);
    this->Means.Bind(units, program);
    shading.Bind(units, program, layers.GetFactorCount());
    program.Set("ImageOrigin", shading.View.Origin);
    program.Set("Layer", layer);
    program.Set("OnlySlot", slot);
    program.Set("KeepsDepth", target.KeepsDepth);
    this->Draw(target, shading.View, [&]() {
      outlines == OutlinesAlone
        ? this->Screen.DrawPoints(source.Outlines.GetCount())
        : this->Screen.DrawRectangles(layers.GetNumberOfRectangles());
    });
    shading.Unbind();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::PresentSelection(const Target& target, const vtkPointSplatView& view,
  const vtkPointSplatLayers& layers, int slot, const Selection& selection)
{
  vtkPointSplatProgram program;
  if (!this->Use(target, "vtkPointSplatLayersVS", "vtkPointSplatLayerFS",
        std::string("#define OUTPUT ") + (selection.Ids ? "2\n" : "1\n") + Define(0) +
          layers.GetDefines(),
        program))
  {
    return false;
  }
  vtkPointSplatUnits units(
    static_cast<vtkOpenGLRenderWindow*>(target.Renderer->GetRenderWindow()));
  layers.Bind(units, program);
  vtkPointSplatShading::SetRay(view, program);
  program.Set("ImageOrigin", view.Origin);
  program.Set("Layer", 0);
  program.Set("OnlySlot", slot);
  glm::vec4 colour(0.0f, 0.0f, 0.0f, 1.0f);
  target.Renderer->GetSelector()->GetPropColorValue(&colour.x);
  program.Set("SelectionColour", colour);
  program.Set("SelectionShift", selection.Shift);
  program.Set("SelectionNearer", static_cast<float>(selection.Nearer) * view.GetPixelSize());
  this->Draw(target, view, [&]() {
    this->Screen.DrawRectangles(layers.GetNumberOfRectangles());
  });
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::PresentFlat(const Target& target, const vtkPointSplatView& view,
  const vtkPointSplatFlatImages& images, const vtkPointSplatOutlines& outlines)
{
  for (const int step : StepsFor(outlines))
  {
    if (step == OutlineMeans && !this->Means.Flatten(images, outlines))
    {
      this->Error = this->Means.GetError();
      return false;
    }
    vtkPointSplatProgram program;
    if (!this->Use(target, VertexFile(step, "vtkPointSplatScreenVS"), "vtkPointSplatFlatFS",
          Define(step), program))
    {
      return false;
    }
    vtkPointSplatUnits units(
      static_cast<vtkOpenGLRenderWindow*>(target.Renderer->GetRenderWindow()));
    units.Bind(program, "Flattened", GL_TEXTURE_2D, images.Colour.Get());
    units.Bind(program, "NearestDepths", GL_TEXTURE_2D, images.Depth.Get());
    outlines.Bind(units, program);
    this->Means.Bind(units, program);
    program.Set("ImageOrigin", view.Origin);
    this->Draw(target, view, [&]() {
      step == OutlinesAlone ? this->Screen.DrawPoints(outlines.GetCount()) : this->Screen.Draw();
    });
  }
  return true;
}
