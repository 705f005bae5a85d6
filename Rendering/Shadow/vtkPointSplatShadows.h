// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Point cloud shadow textures (Dobrev, Rosenthal, Linsen 2010, section 6): which points a light
// reaches. For each sample of the light:
//
// 1. Meshes that stand in the light, and hybrids' own (vtkPointSplatTriangles.h), are drawn to a
//    shadow map by their triangles.
// 2. Other splats are projected to it as disks, most of them two pixels in radius; the nearest stays.
//    Single pixels, which the paper has, need coarser maps and four steps of filling, by
//    which shadows grow: of random points on spheres over a plane, 3.2 % got the wrong answer
//    in all, and 0.09 % farther than a pixel from a shadow's edge; by disks 2.0 %, most of them
//    where light grazes, and none. Near a light, where points are pixels apart, 1.6 % farther
//    than a pixel from edges, and 0.09 %. By compute shaders, with an atomic minimum for each of
//    the few pixels, or by the rasteriser where these are missing: the map is the same. By tiles
//    (vtkPointSplatTiles.h) it took 0.95 to 1.9 times as long.
// 3. Points are projected again, and those no farther than d~ / |n_z| behind the map are lit, where
//    the map's holes are filled as in image space rendering (sections 3.2 and 3.3): one step each
//    for empty and occluded pixels, for the pixels that points ask for and no others. Not until
//    nothing changes: at the steps of a slanting outline pixels would go on being filled, until
//    outlines are octagons. The normal's sign does not matter: nor does it to VTK's shading, which
//    gives no diffuse light to a side that is turned away.
// 4. The lit samples of each point are counted, by blending, in an image with a pixel a splat.
//
// The map: R32UI, see vtkPointSplatShadowMap.glsl, and a depth buffer of 32-bit float. Counts:
// R32F, an image a cloud, up to 4096 pixels wide.
#ifndef vtkPointSplatShadows_h
#define vtkPointSplatShadows_h

#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatItem.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatScreen.h"
#include "vtkPointSplatShadowMeshes.h"
#include "vtkPointSplatShadowView.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

/**
 * Points that cast shadows, or that they fall on, or both: of the item the cloud, its place and
 * the clipping planes, and what these cut away casts none.
 */
struct vtkPointSplatShadowCloud : public vtkPointSplatItem
{
  bool Casts = true;
  bool CastsTriangles = false; // where it has some, in the place of their corners' disks
  bool Receives = true;

  bool operator==(const vtkPointSplatShadowCloud& other) const;
  double GetRadius() const; // of a median splat, world units
  bool HasTriangles() const;
};

struct vtkPointSplatShadowScene
{
  std::vector<vtkPointSplatShadowLight> Lights;
  std::vector<vtkPointSplatShadowCloud> Clouds;
  std::vector<vtkPointSplatShadowMesh> Meshes;

  /// When clouds and meshes changed.
  std::vector<vtkMTimeType> GetTimes() const;
  bool operator==(const vtkPointSplatShadowScene& other) const
  {
    return this->Lights == other.Lights && this->Clouds == other.Clouds &&
      this->Meshes == other.Meshes;
  }
};

struct vtkPointSplatShadowSettings
{
  int Samples = 1;            // of each light with a radius
  unsigned int Seed = 1;
  double LayerDistance = 0.0; // d~, world units; 0: automatic
  int Resolution = 0;         // pixels along the map's longer side; 0: automatic
  bool Compute = true;        // where OpenGL has it

  bool operator==(const vtkPointSplatShadowSettings& other) const;
};

class vtkPointSplatShadows
{
public:
  /**
   * The factors of one light: for each cloud that receives, a number from 0 to 1 for each splat,
   * in the order of its buffers; for others nothing. False, with GetError(), where OpenGL
   * refuses.
   */
  bool Cast(const vtkPointSplatShadowLight& light, const vtkPointSplatShadowScene& scene,
    const vtkPointSplatShadowSettings& settings, std::vector<std::vector<float>>& factors);

  /**
   * Draws the map of all that casts, by steps 1 and 2, to a layer of an array (R32UI) with its
   * holes filled. index: the face of the view's cube, or -1.
   */
  bool DrawTo(const vtkPointSplatFramebuffer::Target& target, const vtkPointSplatShadowView& view,
    int index, const vtkPointSplatShadowScene& scene,
    const vtkPointSplatShadowSettings& settings);

  ///@{
  /**
   * How large a pixel of an automatic map should be among points in a box; a box's corners, those of a cloud's, if it
   * has splats, and the box about some, its least corner first; the radius of median splats of the coarsest cloud; d~, and pixels that it measures at least.
   */
  static double PixelSizeFor(const vtkPointSplatShadowLight& light, int samples,
    const std::vector<glm::dvec3>& corners, double radius);
  static void AddCorners(
    const glm::dmat4& MCWC, const double bounds[6], std::vector<glm::dvec3>& corners);
  static void AddCorners(
    const vtkPointSplatShadowCloud& cloud, std::vector<glm::dvec3>& corners);
  static std::pair<glm::dvec3, glm::dvec3> BoxOf(const std::vector<glm::dvec3>& corners);
  static double RadiusOf(const vtkPointSplatShadowScene& scene);
  static glm::dvec2 LayerDistanceFor(const vtkPointSplatShadowSettings& settings, double radius);
  ///@}

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
    ProjectPoints,
    ProjectMeshes,
    ProjectTriangles,
    Test,
    ProjectComputeClipped,
    ProjectPointsClipped,
    Fill,
    NumberOfPrograms
  };
  struct Face;
  vtkPointSplatProgram* Use(Program which);
  static void SetMap(vtkPointSplatProgram& program, const Face& face);
  static void SetPlacement(vtkPointSplatProgram& program, const Face& face,
    const glm::dmat4& MCWC, const double origin[3], const std::vector<glm::dvec4>& clipPlanes);
  static void SetCloud(
    vtkPointSplatProgram& program, const Face& face, const vtkPointSplatShadowCloud& cloud);
  bool DrawMap(const Face& face, const vtkPointSplatShadowScene& scene, bool compute);
  void Clear(const Face& face);
  bool DrawMeshes(const Face& face, const std::vector<vtkPointSplatShadowMesh>& meshes);
  bool DrawTriangles(const Face& face, const std::vector<vtkPointSplatShadowCloud>& clouds);
  /// Of those clouds that have clip lines, or of those that have none; by compute shaders, or those
  /// that are for the rasteriser.
  struct Kind
  {
    bool Clipped;
    bool Compute;
  };
  bool DrawPoints(
    Kind kind, const Face& face, const std::vector<vtkPointSplatShadowCloud>& clouds, bool compute);
  bool TestPoints(
    const Face& face, const std::vector<vtkPointSplatShadowCloud>& clouds, bool first);
  void ReadCounts(const std::vector<vtkPointSplatShadowCloud>& clouds,
    std::vector<std::vector<float>>& factors);

  vtkPointSplatProgram Programs[NumberOfPrograms];
  vtkPointSplatShadowMeshes Triangles;
  vtkPointSplatImage Map{ GL_R32UI };
  vtkPointSplatImage Depth{ GL_DEPTH_COMPONENT32F };
  std::map<size_t, vtkPointSplatImage> Counts; // of the clouds that receive
  vtkPointSplatFramebuffer MapFramebuffer;
  vtkPointSplatFramebuffer CountFramebuffer;
  vtkPointSplatScreen Screen;
  int SamplesUsed = 0;
  int ResolutionUsed = 0;
  double LayerDistanceUsed = 0.0;
  double PixelSizeUsed = 0.0;
  std::string Error;
};

#endif
