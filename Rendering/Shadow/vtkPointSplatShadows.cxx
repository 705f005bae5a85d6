// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadows.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatPointSizes.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int CountWidth = 4096;    // as in vtkPointSplatShadowTestFS.glsl
constexpr int LargestTexture = 4096; // pixels along a side, of automatic resolutions
// An automatic map's pixel: in splat radii, and in the distance that the shadows' outlines of
// neighbouring samples of a light are apart. Calibrated on spheres over a plane, by the least error
// in the time that maps and samples take.
constexpr double FinestPixel = 0.5;
constexpr double CoarsestPixel = 1.0;
constexpr double OutlinePixel = 0.1;

// The automatic d~: in splat radii, and in pixels.
constexpr double LayerRadii = 1.0;
constexpr double LayerPixels = 1.5;

/// Of a cloud's counts.
glm::ivec2 CountSize(const vtkPointSplatCloud& cloud)
{
  const int splats = static_cast<int>(cloud.GetNumberOfSplats());
  return { std::min(splats, CountWidth), (splats + CountWidth - 1) / CountWidth };
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
  return vtkPointSplatItem::operator==(other) && this->Casts == other.Casts &&
    this->CastsTriangles == other.CastsTriangles && this->Receives == other.Receives;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowCloud::HasTriangles() const
{
  return this->CastsTriangles && this->Cloud->GetTriangles().AreMade();
}

//------------------------------------------------------------------------------
double vtkPointSplatShadowCloud::GetRadius() const
{
  // Points that are drawn as single pixels have no sizes.
  const double median = this->Cloud->GetMedianRadius();
  return this->GetMeanStretch() * (median > 0.0 ? median : this->Cloud->GetSpacing());
}

//------------------------------------------------------------------------------
std::vector<vtkMTimeType> vtkPointSplatShadowScene::GetTimes() const
{
  std::vector<vtkMTimeType> times;
  for (const vtkPointSplatShadowCloud& cloud : this->Clouds)
  {
    times.push_back(cloud.Cloud->GetSplatTime());
    times.push_back(cloud.HasTriangles() ? cloud.Cloud->GetTriangleTime() : 0);
  }
  for (const vtkPointSplatShadowMesh& mesh : this->Meshes)
  {
    times.push_back(mesh.Data->GetMTime());
  }
  return times;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowSettings::operator==(const vtkPointSplatShadowSettings& other) const
{
  return this->Samples == other.Samples && this->Seed == other.Seed &&
    this->LayerDistance == other.LayerDistance && this->Resolution == other.Resolution &&
    this->Compute == other.Compute;
}

//------------------------------------------------------------------------------
std::pair<glm::dvec3, glm::dvec3> vtkPointSplatShadows::BoxOf(
  const std::vector<glm::dvec3>& corners)
{
  glm::dvec3 low = corners[0];
  glm::dvec3 high = corners[0];
  for (const glm::dvec3& corner : corners)
  {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  return { low, high };
}

//------------------------------------------------------------------------------
double vtkPointSplatShadows::PixelSizeFor(const vtkPointSplatShadowLight& light, int samples,
  const std::vector<glm::dvec3>& corners, double radius)
{
  const auto [low, high] = vtkPointSplatShadows::BoxOf(corners);
  // Half the points' extent is how far they may be behind what casts a shadow on them.
  const double penumbra = light.GetTangent(0.5 * (low + high)) * glm::distance(low, high);
  const double apart = penumbra / std::sqrt(static_cast<double>(std::max(samples, 1)));
  return std::min(std::max(OutlinePixel * apart, FinestPixel * radius), CoarsestPixel * radius);
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::AddCorners(
  const vtkPointSplatShadowCloud& cloud, std::vector<glm::dvec3>& corners)
{
  if (cloud.Cloud->GetNumberOfSplats() > 0)
  {
    vtkPointSplatShadows::AddCorners(cloud.MCWC, cloud.Cloud->GetBounds().data(), corners);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::AddCorners(
  const glm::dmat4& MCWC, const double b[6], std::vector<glm::dvec3>& corners)
{
  for (size_t k = 0; k < 8; ++k)
  {
    corners.emplace_back(
      MCWC * glm::dvec4(b[k & 1], b[2 + (k >> 1 & 1)], b[4 + (k >> 2 & 1)], 1.0));
  }
}

//------------------------------------------------------------------------------
double vtkPointSplatShadows::RadiusOf(const vtkPointSplatShadowScene& scene)
{
  double radius = 0.0;
  double ofTriangles = 0.0; // whose depth is exact between points, however coarse they are
  for (const vtkPointSplatShadowCloud& cloud : scene.Clouds)
  {
    if (cloud.Cloud->GetNumberOfSplats() > 0)
    {
      const bool exact = cloud.HasTriangles() && cloud.Cloud->GetTriangles().GetLoose().empty();
      double& largest = exact ? ofTriangles : radius;
      largest = std::max(largest, cloud.GetRadius());
    }
  }
  return radius > 0.0 ? radius : ofTriangles;
}

//------------------------------------------------------------------------------
glm::dvec2 vtkPointSplatShadows::LayerDistanceFor(
  const vtkPointSplatShadowSettings& settings, double radius)
{
  return settings.LayerDistance > 0.0 ? glm::dvec2(settings.LayerDistance, 0.0)
                                      : glm::dvec2(LayerRadii * radius, LayerPixels);
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatShadows::Use(Program which)
{
  static const std::vector<vtkPointSplatProgram::Stage> stages[NumberOfPrograms] = {
    { { GL_COMPUTE_SHADER, "vtkPointSplatShadowProjectCS" } },
    { { GL_VERTEX_SHADER, "vtkPointSplatShadowPointVS" },
      { GL_FRAGMENT_SHADER, "vtkPointSplatShadowPointFS" } },
    { { GL_VERTEX_SHADER, "vtkPointSplatShadowMeshVS" },
      { GL_FRAGMENT_SHADER, "vtkPointSplatShadowMeshFS" } },
    { { GL_VERTEX_SHADER, "vtkPointSplatShadowMeshVS" },
      { GL_FRAGMENT_SHADER, "vtkPointSplatShadowMeshFS" } },
    { { GL_VERTEX_SHADER, "vtkPointSplatScreenVS" },
      { GL_FRAGMENT_SHADER, "vtkPointSplatShadowTestFS" } },
    { { GL_COMPUTE_SHADER, "vtkPointSplatShadowProjectCS" } },
    { { GL_VERTEX_SHADER, "vtkPointSplatShadowPointVS" },
      { GL_FRAGMENT_SHADER, "vtkPointSplatShadowPointFS" } },
    { { GL_VERTEX_SHADER, "vtkPointSplatScreenVS" },
      { GL_FRAGMENT_SHADER, "vtkPointSplatShadowFillFS" } }
  };
  const bool clipped = which == ProjectComputeClipped || which == ProjectPointsClipped;
  vtkPointSplatProgram& program = this->Programs[which];
  if (!program.Build(stages[which],
        clipped                     ? "#define CLIP_LINES\n"
          : which == ProjectTriangles ? "#define CORNERS\n"
                                      : ""))
  {
    this->Error = program.GetLog();
    return nullptr;
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::SetMap(vtkPointSplatProgram& program, const Face& face)
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
void vtkPointSplatShadows::SetCloud(
  vtkPointSplatProgram& program, const Face& face, const vtkPointSplatShadowCloud& cloud)
{
  vtkPointSplatShadows::SetPlacement(
    program, face, cloud.MCWC, cloud.Cloud->GetOrigin().data(), cloud.ClipPlanes);
  program.Set("TexelsPerSplat", cloud.Cloud->IsCircular() ? 2 : 4);
  program.Set("SplatCount", static_cast<int>(cloud.Cloud->GetNumberOfSplats()));
  program.Set("RadiusScale", static_cast<float>(cloud.GetMeanStretch()));
  program.Set("UsualRadius", static_cast<float>(cloud.GetRadius()));
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::Clear(const Face& face)
{
  vtkOpenGLState* state = vtkPointSplatContext::Entered().GetWindow()->GetState();
  // Samples of one light have maps of slightly different sizes: images only grow.
  const glm::ivec2 size = glm::max(this->Map.GetSize(), face.View->Size);
  this->Map.Allocate(size);
  this->Depth.Allocate(size);
  this->MapFramebuffer.Bind(state, { this->Map }, this->Depth);
  state->vtkglViewport(0, 0, face.View->Size.x, face.View->Size.y);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  const GLuint none[4] = { 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu };
  const GLfloat farthest = 1.0f;
  glClearBufferuiv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::DrawMeshes(
  const Face& face, const std::vector<vtkPointSplatShadowMesh>& meshes)
{
  if (meshes.empty())
  {
    return true;
  }
  vtkPointSplatProgram* program = this->Use(ProjectMeshes);
  if (!program)
  {
    return false;
  }
  vtkPointSplatShadows::SetMap(*program, face);
  for (const vtkPointSplatShadowMesh& mesh : meshes)
  {
    const vtkPointSplatShadowMeshes::Buffers& buffers = this->Triangles.Get(mesh.Data);
    vtkPointSplatShadows::SetPlacement(
      *program, face, mesh.MCWC, buffers.Origin, mesh.ClipPlanes);
    glBindVertexArray(buffers.VertexArray.Get());
    glDrawElements(GL_TRIANGLES, buffers.Count, GL_UNSIGNED_INT, nullptr);
  }
  glBindVertexArray(0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::DrawTriangles(
  const Face& face, const std::vector<vtkPointSplatShadowCloud>& clouds)
{
  const auto isMine = [](const vtkPointSplatShadowCloud& cloud) {
    return cloud.Casts && cloud.HasTriangles();
  };
  if (std::none_of(clouds.begin(), clouds.end(), isMine))
  {
    return true;
  }
  vtkPointSplatProgram* program = this->Use(ProjectTriangles);
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  vtkPointSplatShadows::SetMap(*program, face);
  for (const vtkPointSplatShadowCloud& cloud : clouds)
  {
    if (!isMine(cloud))
    {
      continue;
    }
    // Buffers are uploaded before any is bound: a new one's texture takes the unit that is active.
    const vtkPointSplatBuffer& corners = cloud.Cloud->UploadTriangles();
    const vtkPointSplatCloud::Buffers& buffers = cloud.Cloud->Upload();
    units.Bind(*program, "Splats", GL_TEXTURE_BUFFER, buffers.Splats.GetTexture());
    units.Bind(*program, "Corners", GL_TEXTURE_BUFFER, corners.GetTexture());
    vtkPointSplatShadows::SetCloud(*program, face, cloud);
    glBindVertexArray(buffers.VertexArray.Get());
    // A triangle has four words.
    glDrawArrays(GL_TRIANGLES, 0,
      static_cast<GLsizei>(3 * (cloud.Cloud->GetTriangles().GetCorners().size() / 4)));
  }
  glBindVertexArray(0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::DrawPoints(Kind kind, const Face& face,
  const std::vector<vtkPointSplatShadowCloud>& clouds, bool compute)
{
  // Where triangles are, the few splats that belong to none are for the rasteriser.
  const auto isMine = [kind, compute](const vtkPointSplatShadowCloud& cloud) {
    return cloud.Casts && cloud.Cloud->GetNumberOfSplats() > 0 &&
      cloud.Cloud->HasClipLines() == kind.Clipped &&
      (compute && !cloud.HasTriangles()) == kind.Compute;
  };
  if (std::none_of(clouds.begin(), clouds.end(), isMine))
  {
    return true;
  }
  vtkPointSplatProgram* program =
    this->Use(kind.Clipped ? (kind.Compute ? ProjectComputeClipped : ProjectPointsClipped)
                           : (kind.Compute ? ProjectCompute : ProjectPoints));
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  const vtkPointSplatPointSizes sizes;
  vtkPointSplatShadows::SetMap(*program, face);
  if (kind.Compute)
  {
    glBindImageTexture(0, this->Map.Get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  }
  for (const vtkPointSplatShadowCloud& cloud : clouds)
  {
    const vtkIdType count = cloud.Cloud->GetNumberOfSplats();
    if (!isMine(cloud))
    {
      continue;
    }
    const vtkPointSplatCloud::Buffers& buffers = cloud.Cloud->Upload();
    units.Bind(*program, "Splats", GL_TEXTURE_BUFFER, buffers.Splats.GetTexture());
    units.Bind(*program, "ClipLineTexels", GL_TEXTURE_BUFFER, buffers.ClipLines.GetTexture());
    vtkPointSplatShadows::SetCloud(*program, face, cloud);
    if (kind.Compute)
    {
      vtkPointSplatProgram::Dispatch(count);
      continue;
    }
    glBindVertexArray(buffers.VertexArray.Get());
    if (!cloud.HasTriangles())
    {
      glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
      continue;
    }
    for (const vtkPointSplatRuns::Run& run : cloud.Cloud->GetTriangles().GetLoose())
    {
      glDrawArrays(GL_POINTS, static_cast<GLint>(run.First), static_cast<GLsizei>(run.Count));
    }
  }
  if (kind.Compute)
  {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  }
  else
  {
    glBindVertexArray(0);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::TestPoints(
  const Face& face, const std::vector<vtkPointSplatShadowCloud>& clouds, bool first)
{
  vtkPointSplatProgram* program = this->Use(Test);
  if (!program)
  {
    return false;
  }
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  vtkOpenGLState* state = window->GetState();
  vtkPointSplatUnits units(window);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  vtkPointSplatShadows::SetMap(*program, face);
  for (size_t i = 0; i < clouds.size(); ++i)
  {
    const vtkPointSplatShadowCloud& cloud = clouds[i];
    const glm::ivec2 size = CountSize(*cloud.Cloud);
    if (!cloud.Receives || size.x == 0)
    {
      continue;
    }
    vtkPointSplatImage& counts = this->Counts.emplace(i, GL_R32F).first->second;
    if (first)
    {
      counts.Allocate(size);
      state->vtkglDisable(GL_BLEND);
    }
    else
    {
      state->vtkglEnable(GL_BLEND);
    }
    this->CountFramebuffer.Bind(state, { counts });
    state->vtkglViewport(0, 0, size.x, size.y);
    units.Bind(*program, "Map", GL_TEXTURE_2D, this->Map.Get());
    units.Bind(
      *program, "Splats", GL_TEXTURE_BUFFER, cloud.Cloud->Upload().Splats.GetTexture());
    vtkPointSplatShadows::SetCloud(*program, face, cloud);
    this->Screen.Draw();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadows::ReadCounts(const std::vector<vtkPointSplatShadowCloud>& clouds,
  std::vector<std::vector<float>>& factors)
{
  vtkOpenGLState* state = vtkPointSplatContext::Entered().GetWindow()->GetState();
  for (const auto& image : this->Counts)
  {
    const glm::ivec2& size = image.second.GetSize();
    std::vector<float> counts(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
    this->CountFramebuffer.Bind(state, { image.second });
    glReadPixels(0, 0, size.x, size.y, GL_RED, GL_FLOAT, counts.data());
    counts.resize(static_cast<size_t>(clouds[image.first].Cloud->GetNumberOfSplats()));
    const float share = 1.0f / static_cast<float>(this->SamplesUsed);
    vtkSMPTools::Transform(counts.begin(), counts.end(), counts.begin(),
      [share](float count) { return share * count; });
    factors[image.first] = std::move(counts);
  }
  this->Counts.clear();
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::DrawMap(
  const Face& face, const vtkPointSplatShadowScene& scene, bool compute)
{
  this->Clear(face);
  // What compute shaders write is not in the depth buffer, by which the rasteriser tells the nearest.
  bool good = this->DrawMeshes(face, scene.Meshes) && this->DrawTriangles(face, scene.Clouds);
  for (const Kind& kind : { Kind{ false, false }, { true, false }, { false, true }, { true, true } })
  {
    good = good && this->DrawPoints(kind, face, scene.Clouds, compute);
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::DrawTo(const vtkPointSplatFramebuffer::Target& target,
  const vtkPointSplatShadowView& view, int index, const vtkPointSplatShadowScene& scene,
  const vtkPointSplatShadowSettings& settings)
{
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  const vtkPointSplatSavedState saved(window->GetState());
  saved.SetForImages(view.Size);
  this->Triangles.Upload(scene.Meshes);
  const glm::dvec2 layer =
    vtkPointSplatShadows::LayerDistanceFor(settings, vtkPointSplatShadows::RadiusOf(scene));
  const Face face{ &view, index, layer.x, layer.y };
  if (!this->DrawMap(
        face, scene, settings.Compute && vtkPointSplatProgram::IsComputeSupported()))
  {
    return false;
  }
  vtkPointSplatProgram* program = this->Use(Fill);
  if (!program)
  {
    return false;
  }
  window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  this->CountFramebuffer.Bind(window->GetState(), { target });
  vtkPointSplatUnits units(window);
  vtkPointSplatShadows::SetMap(*program, face);
  units.Bind(*program, "Map", GL_TEXTURE_2D, this->Map.Get());
  this->Screen.Draw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadows::Cast(const vtkPointSplatShadowLight& light,
  const vtkPointSplatShadowScene& scene, const vtkPointSplatShadowSettings& settings,
  std::vector<std::vector<float>>& factors)
{
  factors.assign(scene.Clouds.size(), std::vector<float>());
  std::vector<glm::dvec3> corners; // of what receives
  for (const vtkPointSplatShadowCloud& cloud : scene.Clouds)
  {
    if (cloud.Receives)
    {
      vtkPointSplatShadows::AddCorners(cloud, corners);
    }
  }
  const double radius = vtkPointSplatShadows::RadiusOf(scene);
  if (corners.empty())
  {
    return true;
  }
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  largest = std::min(largest, settings.Resolution > 0 ? largest : LargestTexture);
  const double pixel = vtkPointSplatShadows::PixelSizeFor(light, settings.Samples, corners, radius);
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

  vtkOpenGLState* state = vtkPointSplatContext::Entered().GetWindow()->GetState();
  const vtkPointSplatSavedState saved(state);
  saved.SetForImages(views[0].Size);
  this->Triangles.Upload(scene.Meshes);
  const glm::dvec2 layer = vtkPointSplatShadows::LayerDistanceFor(settings, radius);
  Face face{ nullptr, -1, layer.x, layer.y };
  const bool compute = settings.Compute && vtkPointSplatProgram::IsComputeSupported();
  bool good = true;
  for (const vtkPointSplatShadowView& view : views)
  {
    face.View = &view;
    for (int k = 0; k < (view.Cube ? 6 : 1) && good; ++k)
    {
      face.Index = view.Cube ? k : -1;
      good = this->DrawMap(face, scene, compute) &&
        this->TestPoints(face, scene.Clouds, &view == &views[0] && k == 0);
    }
    this->PixelSizeUsed = view.PixelSize;
    this->LayerDistanceUsed =
      std::max(face.LayerDistance, face.LayerPixels * view.PixelSize * view.Distance);
    this->ResolutionUsed = std::max(view.Size.x, view.Size.y);
  }
  this->SamplesUsed = static_cast<int>(views.size());
  this->ReadCounts(scene.Clouds, factors);
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
  this->Map.Release();
  this->Depth.Release();
  this->Counts.clear();
  this->MapFramebuffer.Release();
  this->CountFramebuffer.Release();
  this->Screen.Release();
}
