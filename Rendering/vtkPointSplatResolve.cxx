// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatResolve.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatEnvironment.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatMapper.h"
#include "vtkPointSplatShadowCache.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSSAOPass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <vector>

namespace
{
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

/**
 * The level of detail that the lights need, as vtkOpenGLRenderer has it.
 */
int LightLevel(vtkRenderer* renderer, vtkActor* actor, int& count)
{
  int level = 0;
  count = 0;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch())
    {
      ++count;
      level = std::max(level, light->GetPositional()  ? 3
                              : light->LightTypeIsHeadlight() && count == 1 ? 1
                                                                             : 2);
    }
  }
  return actor->GetProperty()->GetLighting() ? level : 0;
}

glm::vec3 Multiply(const double colour[3], double intensity)
{
  return glm::vec3(glm::dvec3(colour[0], colour[1], colour[2]) * intensity);
}

using Vectors = const float (*)[3];
}

//------------------------------------------------------------------------------
void vtkPointSplatResolve::SetLights(vtkRenderer* renderer, const vtkPointSplatView& view,
  vtkShaderProgram* program, int level, int count, int factors)
{
  if (level == 0)
  {
    return;
  }
  std::vector<glm::vec3> colours;
  std::vector<glm::vec3> directions;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> attenuations;
  std::vector<int> positional;
  std::vector<int> components;
  int casting = 0;
  std::vector<glm::vec2> cones;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const double* p = light->GetTransformedPosition();
    const glm::dvec3 position(p[0], p[1], p[2]);
    const double* f = light->GetTransformedFocalPoint();
    const glm::dvec3 ray = glm::dvec3(f[0], f[1], f[2]) - position;
    colours.push_back(Multiply(light->GetDiffuseColor(), light->GetIntensity()));
    directions.emplace_back(glm::normalize(glm::dmat3(view.WCVC) * ray));
    positions.emplace_back(view.WCVC * glm::dvec4(position, 1.0));
    attenuations.push_back(Multiply(light->GetAttenuationValues(), 1.0));
    cones.emplace_back(light->GetConeAngle(), light->GetExponent());
    positional.push_back(light->GetPositional());
    const bool casts = vtkPointSplatShadowCache::Casts(light) && casting < factors;
    components.push_back(casts ? casting++ : -1);
  }
  program->SetUniform3fv("LightColour", count, reinterpret_cast<Vectors>(colours.data()));
  if (level > 1)
  {
    program->SetUniform3fv("LightDirection", count, reinterpret_cast<Vectors>(directions.data()));
    if (factors > 0)
    {
      program->SetUniform1iv("LightFactor", count, components.data());
    }
  }
  if (level > 2)
  {
    program->SetUniform3fv("LightPosition", count, reinterpret_cast<Vectors>(positions.data()));
    program->SetUniform3fv(
      "LightAttenuation", count, reinterpret_cast<Vectors>(attenuations.data()));
    program->SetUniform2fv(
      "LightCone", count, reinterpret_cast<const float(*)[2]>(cones.data()));
    program->SetUniform1iv("LightPositional", count, positional.data());
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatResolve::SetMaterial(vtkActor* actor, bool colours, vtkShaderProgram* program)
{
  glm::vec3 ambient[2];
  glm::vec3 diffuse[2];
  glm::vec3 specular[2];
  float power[2];
  float opacity[2];
  // VTK ignores the back-face property where scalars colour the surface.
  vtkProperty* front = actor->GetProperty();
  vtkProperty* back = actor->GetBackfaceProperty() && !colours ? actor->GetBackfaceProperty() : front;
  vtkProperty* sides[2] = { front, back };
  const double white[3] = { 1.0, 1.0, 1.0 };
  for (int side = 0; side < 2; ++side)
  {
    vtkProperty* p = sides[side];
    ambient[side] = Multiply(colours ? white : p->GetAmbientColor(), p->GetAmbient());
    diffuse[side] = Multiply(colours ? white : p->GetDiffuseColor(), p->GetDiffuse());
    specular[side] = Multiply(p->GetSpecularColor(), p->GetSpecular());
    power[side] = static_cast<float>(p->GetSpecularPower());
    opacity[side] = static_cast<float>(p->GetOpacity());
  }
  program->SetUniform3fv("Ambient", 2, reinterpret_cast<Vectors>(ambient));
  program->SetUniform3fv("Diffuse", 2, reinterpret_cast<Vectors>(diffuse));
  program->SetUniform3fv("Specular", 2, reinterpret_cast<Vectors>(specular));
  program->SetUniform1fv("SpecularPower", 2, power);
  program->SetUniform1fv("Opacity", 2, opacity);
  program->SetUniformi("HasColours", colours ? 1 : 0);
}

//------------------------------------------------------------------------------
std::string vtkPointSplatResolve::LightDefines(vtkRenderer* renderer, vtkActor* actor)
{
  int count = 0;
  const int level = LightLevel(renderer, actor, count);
  return "#define LIGHT_LEVEL " + std::to_string(level) + "\n#define LIGHT_COUNT " +
    std::to_string(count) + "\n";
}

//------------------------------------------------------------------------------
void vtkPointSplatResolve::SetShading(vtkRenderer* renderer, vtkActor* actor,
  const vtkPointSplatView& view, bool colours, vtkShaderProgram* program, int factors)
{
  int count = 0;
  const int level = LightLevel(renderer, actor, count);
  vtkPointSplatResolve::SetLights(renderer, view, program, level, count, factors);
  vtkPointSplatResolve::SetMaterial(actor, colours, program);
}

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::Present(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, const vtkPointSplatItem& item,
  vtkPointSplatImages& images, float depthUnit, Output output, int selectionShift, bool gathered)
{
  const bool shaded = output == Shaded || output == Flattened || output == Reflected;
  const bool reflects = shaded && item.Refracts && this->Environment;
  if (item.Window.x > item.Window.z || item.Window.y > item.Window.w)
  {
    return true; // off the screen
  }
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());

  std::string vertex = vtkPointSplatProgram::Source("vtkPointSplatResolveVS");
  std::string geometry;
  std::string fragment = vtkPointSplatProgram::Source("vtkPointSplatResolveFS");
  const std::vector<vtkOpenGLRenderPass*> passes =
    output == Flattened || output == Reflected ? std::vector<vtkOpenGLRenderPass*>() : PassesOf(actor);
  bool geometryBuffer = false;
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PreReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
    geometryBuffer = geometryBuffer || vtkSSAOPass::SafeDownCast(pass) != nullptr;
  }
  std::string defines = "#define OUTPUT " + std::to_string(static_cast<int>(output)) + "\n" +
    (shaded ? vtkPointSplatResolve::LightDefines(renderer, actor)
            : std::string("#define LIGHT_LEVEL 0\n#define LIGHT_COUNT 0\n"));
  defines += images.GetDefines();
  if (reflects)
  {
    defines += "#define REFLECTION\n" + this->Environment->GetDefines();
  }
  vtkShaderProgram::Substitute(fragment, "//PointSplat::Defines", defines);
  vtkShaderProgram::Substitute(fragment, "//PointSplat::GeometryBuffer",
    geometryBuffer && output == Shaded
      ? vtkPointSplatProgram::Source("vtkPointSplatGeometryBuffer")
      : std::string());
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PostReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  }
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
  {
    return false;
  }

  images.Bind(window, program, output == SelectionIds);
  const int origin[2] = { view.Origin.x, view.Origin.y };
  program->SetUniform2i("ImageOrigin", origin);
  program->SetUniformi("Slot", item.Slot);
  vtkPointSplatResolve::SetView(view, depthUnit, program);
  if (reflects)
  {
    program->SetUniformf("RefractiveIndex", static_cast<float>(mapper->GetRefractiveIndex()));
    this->Environment->Bind(view, program);
  }
  if (shaded)
  {
    vtkPointSplatResolve::SetShading(
      renderer, actor, view, item.Cloud->HasColours() || gathered, program,
      images.GetFactorCount());
    if (gathered)
    {
      // The points' opacities hold the actors' own.
      const float one[2] = { 1.0f, 1.0f };
      program->SetUniform1fv("Opacity", 2, one);
    }
  }
  else
  {
    float colour[4] = { 0.0f, 0.0f, 0.0f, 1.0f };
    if (vtkHardwareSelector* selector = renderer->GetSelector())
    {
      selector->GetPropColorValue(colour);
    }
    program->SetUniform4f("SelectionColour", colour);
    program->SetUniformi("SelectionShift", selectionShift);
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->SetShaderParameters(program, mapper, actor, nullptr);
  }

  this->DrawScreen(window, view, item.Window);
  images.Unbind(window);
  if (reflects)
  {
    this->Environment->Unbind();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatResolve::SetView(
  const vtkPointSplatView& view, float depthUnit, vtkShaderProgram* program)
{
  program->SetUniformf("DepthUnit", depthUnit);
  program->SetUniformf("NearDistance", static_cast<float>(view.Near));
  program->SetUniformi("Parallel", view.Parallel ? 1 : 0);
  program->SetUniform4f("PixelX", &view.PixelX.x);
  program->SetUniform4f("PixelY", &view.PixelY.x);
  program->SetUniform4f("PixelW", &view.PixelW.x);
  program->SetUniform4f("PixelZ", &view.PixelZ.x);
}

//------------------------------------------------------------------------------
void vtkPointSplatResolve::DrawScreen(
  vtkOpenGLRenderWindow* window, const vtkPointSplatView& view, const glm::ivec4& rectangle)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  // Within what the renderer, or an area selection, lets through.
  int clip[4];
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, clip);
  const bool clipped = state->GetEnumState(GL_SCISSOR_TEST);
  glm::ivec2 low = view.Origin + glm::ivec2(rectangle.x, rectangle.y);
  glm::ivec2 high = view.Origin + glm::ivec2(rectangle.z, rectangle.w) + 1;
  if (clipped)
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
    if (!this->VertexArray)
    {
      glGenVertexArrays(1, &this->VertexArray);
    }
    glBindVertexArray(this->VertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatResolve::PresentFlat(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, GLuint colour, GLuint depth)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  std::string vertex = vtkPointSplatProgram::Source("vtkPointSplatResolveVS");
  std::string geometry;
  std::string fragment = vtkPointSplatProgram::Source("vtkPointSplatFlatFS");
  const std::vector<vtkOpenGLRenderPass*> passes = PassesOf(actor);
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PreReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PostReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  }
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
  {
    return false;
  }
  const int origin[2] = { view.Origin.x, view.Origin.y };
  program->SetUniform2i("ImageOrigin", origin);
  const std::pair<const char*, GLuint> images[] = { { "Flattened", colour },
    { "NearestDepths", depth } };
  int units[2];
  for (int i = 0; i < 2; ++i)
  {
    units[i] = window->GetTextureUnitManager()->Allocate();
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(units[i]));
    glBindTexture(GL_TEXTURE_2D, images[i].second);
    program->SetUniformi(images[i].first, units[i]);
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->SetShaderParameters(program, mapper, actor, nullptr);
  }
  this->DrawScreen(window, view, glm::ivec4(0, 0, view.Size.x - 1, view.Size.y - 1));
  for (const int unit : units)
  {
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    glBindTexture(GL_TEXTURE_2D, 0);
    window->GetTextureUnitManager()->Free(unit);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatResolve::Release()
{
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
}
