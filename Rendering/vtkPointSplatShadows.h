// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Point cloud shadow textures (Dobrev, Rosenthal, Linsen 2010, section 6): which points a light
// reaches. For each sample of the light:
//
// 1. Meshes that stand in the light are drawn to a shadow map by their triangles.
// 2. Splats are projected to it as disks, most of them two pixels in radius; the nearest stays.
//    Single pixels, which the paper has, need coarser maps and four steps of filling, by
//    which shadows grow: of random points on spheres over a plane, 3.2 % got the wrong answer
//    in all, and 0.09 % farther than a pixel from a shadow's edge; by disks 2.0 %, most of them where
//    light grazes, and none. Near a light, where points are pixels apart, 1.6 % farther than a
//    pixel from edges, and 0.09 %. By compute shaders, or by the
//    rasteriser where these are missing: the map is the same.
// 3. Holes are filled, as in image space rendering (sections 3.2 and 3.3): one step each for empty
//    and occluded pixels. Not until nothing changes: at the steps of a slanting outline pixels
//    go on being filled, until outlines are octagons.
// 4. Points are projected again, and those no farther than d~ / |n_z| behind the map are lit.
//    Their number of lit samples is counted. The normal's sign does not matter: nor does it to
//    VTK's shading, which gives no diffuse light to a side that is turned away.
//
// The map: R32UI, see vtkPointSplatShadowMap.glsl; besides a second one, to fill from one to the
// other, and a depth buffer of 32-bit float.
#ifndef vtkPointSplatShadows_h
#define vtkPointSplatShadows_h

#include "vtkPointSplatCloud.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatShadowMeshes.h"
#include "vtkPointSplatShadowView.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

/**
 * Points that cast shadows, or that they fall on, or both.
 */
struct vtkPointSplatShadowCloud
{
  vtkPointSplatCloud* Cloud = nullptr;
  glm::dmat4 MCWC{ 1.0 };
  std::vector<glm::dvec4> ClipPlanes; // world coordinates; what they cut away casts none
  bool Casts = true;
  bool Receives = true;

  bool operator==(const vtkPointSplatShadowCloud& other) const;
  double GetStretch() const; // of lengths, by the matrix, in the mean
  double GetRadius() const;  // of a median splat, world units
};

struct vtkPointSplatShadowSettings
{
  int Samples = 1;            // of each light with a radius
  unsigned int Seed = 1;
  double LayerDistance = 0.0; // d~, world units; 0: automatic
  int Resolution = 0;         // pixels along the map's longer side; 0: automatic
  bool Compute = true;

  bool operator==(const vtkPointSplatShadowSettings& other) const;
};

class vtkPointSplatShadows
{
public:
  vtkPointSplatShadows() = default;
  ~vtkPointSplatShadows() = default;
  vtkPointSplatShadows(const vtkPointSplatShadows&) = delete;
  void operator=(const vtkPointSplatShadows&) = delete;

  /**
   * The factors of one light: for each cloud that receives, a number from 0 to 1 for each splat,
   * in the order of its buffers; for others nothing. False, with GetError(), where OpenGL
   * refuses. The window's context must be current.
   */
  bool Cast(vtkOpenGLRenderWindow* window, const vtkPointSplatShadowLight& light,
    const std::vector<vtkPointSplatShadowCloud>& clouds,
    const std::vector<vtkPointSplatShadowMesh>& meshes, const vtkPointSplatShadowSettings& settings,
    std::vector<std::vector<float>>& factors);

  ///@{
  /**
   * Of the last light: the samples taken, the map's longer side, d~ (world units; where it grows
   * with the distance from the light, the least) and a pixel's size (world units, of a positional
   * light at a distance of 1).
   */
  int GetSamplesUsed() const { return this->SamplesUsed; }
  int GetResolutionUsed() const { return this->ResolutionUsed; }
  double GetLayerDistanceUsed() const { return this->LayerDistanceUsed; }
  double GetPixelSizeUsed() const { return this->PixelSizeUsed; }
  ///@}

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  enum Program
  {
    ProjectCompute,
    TestCompute,
    ProjectPoints,
    TestPoints,
    Meshes,
    Fill,
    NumberOfPrograms
  };
  struct Face;
  vtkPointSplatProgram* Use(Program which);
  void Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size);
  void SetMap(vtkPointSplatProgram& program, const Face& face) const;
  static void SetPlacement(vtkPointSplatProgram& program, const Face& face,
    const glm::dmat4& MCWC, const double origin[3], const std::vector<glm::dvec4>& clipPlanes);
  bool DrawMeshes(vtkOpenGLRenderWindow* window, const Face& face,
    const std::vector<vtkPointSplatShadowMesh>& meshes);
  bool DrawPoints(vtkOpenGLRenderWindow* window, const Face& face,
    const std::vector<vtkPointSplatShadowCloud>& clouds, bool compute);
  bool FillHoles(vtkOpenGLRenderWindow* window, const Face& face);
  bool TestAll(vtkOpenGLRenderWindow* window, const Face& face,
    const std::vector<vtkPointSplatShadowCloud>& clouds, bool compute);
  void BeginCounting(const std::vector<vtkPointSplatShadowCloud>& clouds);

  vtkPointSplatProgram Programs[NumberOfPrograms];
  vtkPointSplatShadowMeshes Triangles;
  struct Counts
  {
    GLuint Buffers[2] = { 0, 0 }; // the first has the counts; the other is to write to
  };
  std::vector<Counts> CloudCounts;
  glm::ivec2 Size{ 0, 0 };
  GLuint Maps[2] = { 0, 0 };
  GLuint Depth = 0;
  GLuint Framebuffer = 0;
  GLuint VertexArray = 0;
  int SamplesUsed = 0;
  int ResolutionUsed = 0;
  double LayerDistanceUsed = 0.0;
  double PixelSizeUsed = 0.0;
  std::string Error;
};

#endif
