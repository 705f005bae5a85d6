// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadows.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr GLuint GroupSize = 64;     // as in vtkPointSplatShadowProjectCS.glsl
constexpr GLuint MostGroups = 32768; // in one dimension; OpenGL promises 65535
constexpr int LargestMap = 4096;     // pixels along a side, of automatic resolutions
// An automatic map's pixel: in splat radii, and in the distance that the shadows' outlines of
// neighbouring samples of a light are apart. Calibrated on spheres over a plane, by the least error
// in the time that maps and samples take.
constexpr double FinestPixel = 0.5;
constexpr double CoarsestPixel = 1.0;
constexpr double OutlinePixel = 0.1;

// The automatic d~: in splat radii, and in pixels.
constexpr double LayerRadii = 1.0;
constexpr double LayerPixels = 1.5;

void Dispatch(vtkIdType count)
{
  const GLuint groups = static_cast<GLuint>((count + GroupSize - 1) / GroupSize);
  glDispatchCompute(std::min(groups, MostGroups), (groups + MostGroups - 1) / MostGroups, 1);
}

// What an automatic map's pixel should measure among the points, world units.
double PixelSizeFor(const vtkPointSplatShadowLight& light, int samples,
  const std::vector<glm::dvec3>& corners, double radius)
{
  glm::dvec3 low = corners[0];
  glm::dvec3 high = corners[0];
  for (const glm::dvec3& corner : corners)
  {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  // Half the points' extent is how far they may be behind what casts a shadow on them.
  const double tangent = light.Positional
    ? light.Radius / std::max(glm::distance(light.Position, 0.5 * (low + high)), light.Radius)
    : light.Radius;
  const double penumbra = light.Radius > 0.0 ? tangent * glm::distance(low, high) : 0.0;
  const double apart = penumbra / std::sqrt(static_cast<double>(std::max(samples, 1)));
  return std::min(std::max(OutlinePixel * apart, FinestPixel * radius), CoarsestPixel * radius);
}

int TexelsPerSplat(const vtkPointSplatCloud& cloud)
{
  return cloud.IsCircular() ? 2 : 4;
}
}

/// A map to draw, and what its tests need.
struct vtkPointSplatShadows::Face
{
  const vtkPointSplatShadowView* View;
  int Index; // of a cube's; -1: there is none
  double LayerDistance;
  double LayerPixels;
};

//------------------------------------------------------------------------------
bool vtkPointSplatShadowCloud::operator==(const vtkPointSplatShadowCloud& other) const
{
  return this->Cloud == other.Cloud && this->MCWC == other.MCWC &&
    this->ClipPlanes == other.ClipPlanes && this->Casts == other.Casts &&
    this->Receives == other.Receives;
}

//------------------------------------------------------------------------------
double vtkPointSplatShadowCloud::GetStretch() const
{
  const glm::dmat3 linear(this->MCWC);
  double stretch = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    stretch += glm::dot(linear[k], linear[k]) / 3.0;
  }
  return std::sqrt(stretch);
}

//------------------------------------------------------------------------------
double vtkPointSplatShadowCloud::GetRadius() const
{
  // Points that are drawn as single pixels have no sizes.
  const double median = this->Cloud->GetMedianRadius();
  return this->GetStretch() * (median > 0.0 ? median : this->Cloud->GetSpacing());
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowSettings::operator==(const vtkPointSplatShadowSettings& other) const
{
  return this->Samples == other.Samples && this->Seed == other.Seed &&
    this->LayerDistance == other.LayerDistance && this->Resolution == other.Resolution &&
    this->Compute == other.Compute;
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatShadows::Use(Program which)
{
  static const struct
  {
    const char* Vertex;
    const char* Other;
    const char* Feedback;
  } files[NumberOfPrograms] = { { nullptr, "vtkPointSplatShadowProjectCS", nullptr },
    { nullptr, "vtkPointSplatShadowTestCS", nullptr },
    { "vtkPointSplatShadowPointVS", "vtkPointSplatShadowPointFS", nullptr },
    { "vtkPointSplatShadowTestVS", nullptr, "count" },
    { "vtkPointSplatShadowMeshVS", "vtkPointSplatShadowMeshFS", nullptr },
    { "vtkPointSplatResolveVS", "vtkPointSplatShadowFillFS", nullptr } };
  vtkPointSplatProgram& program = this->Programs[which];
  if (!program.IsBuilt())
  {
    std::vector<std::pair<GLenum, std::string>> stages;
    if (files[which].Vertex)
    {
      stages.emplace_back(GL_VERTEX_SHADER, files[which].Vertex);
    }
    if (files[which].Other)
    {
      stages.emplace_back(
        files[which].Vertex ? GL_FRAGMENT_SHADER : GL_COMPUTE_SHADER, files[which].Other);
    }
    if (!program.Build(stages, std::string(), files[which].Feedback))
    {
      this->Error = program.GetLog();
      return nullptr;
    }
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size)
{
  // Samples of one light have maps of slightly different sizes: images only grow.
  if (this->Framebuffer && size.x <= this->Size.x && size.y <= this->Size.y)
  {
    return;
  }
  const glm::ivec2 larger = glm::max(size, this->Size);
  if (!this->Framebuffer)
  {
    glGenTextures(2, this->Maps);
    glGenTextures(1, &this->Depth);
    glGenFramebuffers(1, &this->Framebuffer);
    glGenVertexArrays(1, &this->VertexArray);
  }
  this->Size = larger;
  vtkOpenGLState::ScopedglActiveTexture active(window->GetState());
  const int unit = window->GetTextureUnitManager()->Allocate();
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
  const struct
  {
    GLuint Texture;
    GLenum Internal;
    GLenum Format;
    GLenum Type;
  } images[] = { { this->Maps[0], GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT },
    { this->Maps[1], GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT },
    { this->Depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT } };
  for (const auto& image : images)
  {
    glBindTexture(GL_TEXTURE_2D, image.Texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(image.Internal), larger.x, larger.y, 0,
      image.Format, image.Type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  window->GetTextureUnitManager()->Free(unit);
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::SetMap(vtkPointSplatProgram& program, const Face& face) const
{
  const vtkPointSplatShadowView& view = *face.View;
  program.Set("MapSize", view.Size);
  program.Set("Parallel", view.Parallel);
  program.Set("DepthRange", static_cast<float>(view.Depth));
  program.Set("LayerDistance", static_cast<float>(face.LayerDistance));
  program.Set("LayerPixels", static_cast<float>(face.LayerPixels));
  program.Set("PixelSize", static_cast<float>(view.PixelSize));
  program.Set("Face", face.Index);
  program.Set("MapScale", glm::vec2(view.Scale));
  program.Set("MapOffset", glm::vec2(view.Offset));
  program.Set("NearDistance", static_cast<float>(view.NearDistance));
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::SetPlacement(vtkPointSplatProgram& program, const Face& face,
  const glm::dmat4& MCWC, const double origin[3], const std::vector<glm::dvec4>& clipPlanes)
{
  // In double precision up to here, and about the data's middle.
  glm::dmat4 toWorld = MCWC;
  toWorld[3] = MCWC * glm::dvec4(origin[0], origin[1], origin[2], 1.0);
  const glm::dmat4 MCLC = face.View->WCLC * toWorld;
  program.Set("MCLC", glm::mat4(MCLC));
  program.Set("NormalMatrix", glm::mat3(glm::transpose(glm::inverse(glm::dmat3(MCLC)))));
  std::vector<glm::vec4> planes;
  for (const glm::dvec4& plane : clipPlanes)
  {
    planes.emplace_back(glm::transpose(toWorld) * plane);
  }
  program.Set("ClipPlaneCount", static_cast<int>(planes.size()));
  program.Set("ClipPlanes", planes);
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::DrawMeshes(vtkOpenGLRenderWindow* window, const Face& face,
  const std::vector<vtkPointSplatShadowMesh>& meshes)
{
  vtkOpenGLState* state = window->GetState();
  const GLuint none[4] = { 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu };
  const GLfloat farthest = 1.0f;
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Maps[0], 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Depth, 0);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  glClearBufferuiv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (meshes.empty())
  {
    return true;
  }
  vtkPointSplatProgram* program = this->Use(Meshes);
  if (!program)
  {
    return false;
  }
  this->SetMap(*program, face);
  for (const vtkPointSplatShadowMesh& mesh : meshes)
  {
    const vtkPointSplatShadowMeshes::Buffers& buffers = this->Triangles.Get(mesh.Data);
    vtkPointSplatShadows::SetPlacement(
      *program, face, mesh.MCWC, buffers.Origin, mesh.ClipPlanes);
    glBindVertexArray(buffers.VertexArray);
    glDrawElements(GL_TRIANGLES, buffers.Count, GL_UNSIGNED_INT, nullptr);
  }
  glBindVertexArray(0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::DrawPoints(vtkOpenGLRenderWindow* window, const Face& face,
  const std::vector<vtkPointSplatShadowCloud>& clouds, bool compute)
{
  vtkPointSplatProgram* program = this->Use(compute ? ProjectCompute : ProjectPoints);
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(window);
  this->SetMap(*program, face);
  if (compute)
  {
    glBindImageTexture(0, this->Maps[0], 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  }
  else
  {
    glBindVertexArray(this->VertexArray);
    glEnable(GL_PROGRAM_POINT_SIZE);
  }
  for (const vtkPointSplatShadowCloud& cloud : clouds)
  {
    const vtkIdType count = cloud.Cloud->GetNumberOfSplats();
    if (!cloud.Casts || count == 0)
    {
      continue;
    }
    units.Bind(
      *program, "Splats", GL_TEXTURE_BUFFER, cloud.Cloud->Upload(window).SplatTexture);
    vtkPointSplatShadows::SetPlacement(
      *program, face, cloud.MCWC, cloud.Cloud->GetOrigin().data(), cloud.ClipPlanes);
    program->Set("TexelsPerSplat", TexelsPerSplat(*cloud.Cloud));
    program->Set("RadiusScale", static_cast<float>(cloud.GetStretch()));
    program->Set("UsualRadius", static_cast<float>(cloud.GetRadius()));
    if (compute)
    {
      program->Set("SplatCount", static_cast<unsigned int>(count));
      Dispatch(count);
    }
    else
    {
      glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
    }
  }
  if (compute)
  {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  }
  else
  {
    glBindVertexArray(0);
    glDisable(GL_PROGRAM_POINT_SIZE);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::FillHoles(vtkOpenGLRenderWindow* window, const Face& face)
{
  vtkPointSplatProgram* program = this->Use(Fill);
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(window);
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
  this->SetMap(*program, face);
  glBindVertexArray(this->VertexArray);
  // A single step: disks leave few holes, and no large ones.
  units.Bind(*program, "Map", GL_TEXTURE_2D, this->Maps[0]);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Maps[1], 0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::swap(this->Maps[0], this->Maps[1]);
  glBindVertexArray(0);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::BeginCounting(const std::vector<vtkPointSplatShadowCloud>& clouds)
{
  this->CloudCounts.resize(clouds.size());
  for (size_t i = 0; i < clouds.size(); ++i)
  {
    if (!clouds[i].Receives)
    {
      continue;
    }
    const std::vector<GLuint> zeros(
      static_cast<size_t>(std::max<vtkIdType>(clouds[i].Cloud->GetNumberOfSplats(), 1)), 0u);
    glGenBuffers(2, this->CloudCounts[i].Buffers);
    for (const GLuint buffer : this->CloudCounts[i].Buffers)
    {
      glBindBuffer(GL_ARRAY_BUFFER, buffer);
      glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * zeros.size()), zeros.data(),
        GL_DYNAMIC_COPY);
    }
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::TestAll(vtkOpenGLRenderWindow* window, const Face& face,
  const std::vector<vtkPointSplatShadowCloud>& clouds, bool compute)
{
  vtkPointSplatProgram* program = this->Use(compute ? TestCompute : TestPoints);
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(window);
  this->SetMap(*program, face);
  units.Bind(*program, "Map", GL_TEXTURE_2D, this->Maps[0]);
  for (size_t i = 0; i < clouds.size(); ++i)
  {
    const vtkPointSplatShadowCloud& cloud = clouds[i];
    const vtkIdType count = cloud.Cloud->GetNumberOfSplats();
    if (!cloud.Receives || count == 0)
    {
      continue;
    }
    GLuint* buffers = this->CloudCounts[i].Buffers;
    units.Bind(
      *program, "Splats", GL_TEXTURE_BUFFER, cloud.Cloud->Upload(window).SplatTexture);
    vtkPointSplatShadows::SetPlacement(
      *program, face, cloud.MCWC, cloud.Cloud->GetOrigin().data(), {});
    program->Set("TexelsPerSplat", TexelsPerSplat(*cloud.Cloud));
    if (compute)
    {
      program->Set("SplatCount", static_cast<unsigned int>(count));
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers[0]);
      Dispatch(count);
      glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
      continue;
    }
    glBindVertexArray(this->VertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glVertexAttribIPointer(0, 1, GL_UNSIGNED_INT, 4, nullptr);
    glEnableVertexAttribArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[1]);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glDisableVertexAttribArray(0);
    glBindVertexArray(0);
    std::swap(buffers[0], buffers[1]);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::Cast(vtkOpenGLRenderWindow* window,
  const vtkPointSplatShadowLight& light, const std::vector<vtkPointSplatShadowCloud>& clouds,
  const std::vector<vtkPointSplatShadowMesh>& meshes, const vtkPointSplatShadowSettings& settings,
  std::vector<std::vector<float>>& factors)
{
  factors.assign(clouds.size(), std::vector<float>());
  std::vector<glm::dvec3> corners;
  double radius = 0.0; // of median splats, of the coarsest cloud
  for (const vtkPointSplatShadowCloud& cloud : clouds)
  {
    if (cloud.Cloud->GetNumberOfSplats() == 0)
    {
      continue;
    }
    const std::array<double, 6>& bounds = cloud.Cloud->GetBounds();
    for (size_t k = 0; cloud.Receives && k < 8; ++k)
    {
      corners.emplace_back(cloud.MCWC *
        glm::dvec4(bounds[k & 1], bounds[2 + (k >> 1 & 1)], bounds[4 + (k >> 2 & 1)], 1.0));
    }
    radius = std::max(radius, cloud.GetRadius());
  }
  if (corners.empty())
  {
    return true;
  }
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  largest = std::min(largest, settings.Resolution > 0 ? largest : LargestMap);
  const double pixel = PixelSizeFor(light, settings.Samples, corners, radius);
  std::vector<vtkPointSplatShadowView> views;
  for (const vtkPointSplatShadowLight& sample : light.Sample(settings.Samples, settings.Seed))
  {
    views.push_back(vtkPointSplatShadowView::Fit(
      sample, corners, pixel, settings.Resolution, static_cast<int>(largest)));
    if (views.back().Size.x < 1)
    {
      return true; // by an actor's matrix the points are nowhere: all are lit
    }
  }

  window->GetShaderCache()->ReleaseCurrentShader();
  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  this->Triangles.Upload(meshes);
  this->BeginCounting(clouds);

  bool good = true;
  for (const vtkPointSplatShadowView& view : views)
  {
    this->Allocate(window, view.Size);
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    GLenum target = GL_COLOR_ATTACHMENT0;
    state->vtkglDrawBuffers(1, &target);
    state->vtkglViewport(0, 0, view.Size.x, view.Size.y);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_BLEND);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const bool automatic = settings.LayerDistance <= 0.0;
    Face face{ &view, -1, automatic ? LayerRadii * radius : settings.LayerDistance,
      automatic ? LayerPixels : 0.0 };
    for (int k = 0; k < (view.Cube ? 6 : 1) && good; ++k)
    {
      face.Index = view.Cube ? k : -1;
      good = this->DrawMeshes(window, face, meshes) &&
        this->DrawPoints(window, face, clouds, settings.Compute) &&
        this->FillHoles(window, face) && this->TestAll(window, face, clouds, settings.Compute);
    }
    this->PixelSizeUsed = view.PixelSize;
    this->LayerDistanceUsed =
      std::max(face.LayerDistance, face.LayerPixels * view.PixelSize * view.Distance);
    this->ResolutionUsed = std::max(view.Size.x, view.Size.y);
  }
  this->SamplesUsed = static_cast<int>(views.size());

  if (settings.Compute)
  {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  }
  std::vector<GLuint> counts;
  for (size_t i = 0; i < clouds.size(); ++i)
  {
    if (!clouds[i].Receives)
    {
      continue;
    }
    counts.resize(static_cast<size_t>(clouds[i].Cloud->GetNumberOfSplats()));
    glBindBuffer(GL_ARRAY_BUFFER, this->CloudCounts[i].Buffers[0]);
    glGetBufferSubData(
      GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(4 * counts.size()), counts.data());
    factors[i].resize(counts.size());
    const float share = 1.0f / static_cast<float>(views.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(counts.size()), [&](vtkIdType first, vtkIdType last) {
      for (size_t k = static_cast<size_t>(first); k < static_cast<size_t>(last); ++k)
      {
        factors[i][k] = share * static_cast<float>(counts[k]);
      }
    });
    glDeleteBuffers(2, this->CloudCounts[i].Buffers);
  }
  this->CloudCounts.clear();
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::Release()
{
  for (vtkPointSplatProgram& program : this->Programs)
  {
    program.Release();
  }
  this->Triangles.Release();
  if (this->Framebuffer)
  {
    glDeleteTextures(2, this->Maps);
    glDeleteTextures(1, &this->Depth);
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->Maps[0] = this->Maps[1] = this->Depth = this->Framebuffer = this->VertexArray = 0;
  this->Size = glm::ivec2(0);
}
