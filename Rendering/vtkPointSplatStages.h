// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages that project splats to the images of one surface layer, in either
// of two ways: compute shaders that loop over each splat's pixels, or quads
// through the rasteriser. What is drawn is the same.
//
// Rasterising a splat costs a few hundred nanoseconds of set-up before its first
// pixel, on CPUs and GPUs alike; a splat of a dozen pixels is drawn sooner by a
// loop. Compute shaders need OpenGL 4.3 and image sizes within the driver's
// bound for storage buffers; quads need OpenGL 3.3.
#ifndef vtkPointSplatStages_h
#define vtkPointSplatStages_h

#include "vtkPointSplatCloud.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatView.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
VTK_ABI_NAMESPACE_END
class vtkPointSplatImages;
class vtkPointSplatUnits;

/**
 * How far apart points are in a view.
 */
struct vtkPointSplatSpacing
{
  double World = 0.0;        // world units
  double Pixels = 0.0;       // where they are nearest to the eye
  double LargestPixel = 0.0; // of their bounding box, world units
  double Curvature = 0.0;    // the mean of the surface's mean curvatures, over world units
};

/**
 * One cloud to draw, with all that its projection depends on.
 */
struct vtkPointSplatItem
{
  vtkPointSplatCloud* Cloud = nullptr;
  glm::dmat4 MCWC{ 1.0 };
  int Slot = 0;               // names the cloud in the images' tags
  int Culling = 0;            // 1 back faces, 2 front faces
  double RadiusScale = 1.0;
  double LayerDistance = 0.0; // world units; negative: a fraction of each radius
  double LargestLayer = 0.0;  // an upper bound of it, world units
  int KernelType = 0;
  glm::vec2 KernelShape{ 0.0f };
  double KernelSupport = 1.5;
  std::vector<glm::dvec4> ClipPlanes; // world coordinates
  glm::ivec4 Window{ 0 };             // pixels that it can cover
  GLuint Factors = 0;                 // a buffer: RGBA, 8 bits each, of as many lights, a splat
  int FactorCount = 0;                // the lights
  unsigned long FactorVersion = 0;    // counts what was in the buffer
  double CoveringScale = 1.0;         // how much larger group-sorted splats are drawn
  bool Points = false;                // projected as single pixels, holes filled in the image
  double PointLayer = 0.0;            // the least layer distance of such points, world units ...
  double PointLayerPixels = 0.0;      // ... and in pixels; the larger counts
  double Spacing = 0.0;               // of such points, world units
  double SpacingPixels = 0.0;         // the same where they are nearest to the eye, pixels
  bool Silhouettes = false;           // of such points, anti-aliased
  std::shared_ptr<const vtkPointSplatBatches::List> Batches; // of such points in view; null: all
  glm::vec4 Colour{ 1.0f };           // and opacity, where layers of several items are gathered
  bool Refracts = false;              // the environment

  /// From the coordinates in the cloud's buffers to view coordinates.
  glm::dmat4 GetMCVC(const vtkPointSplatView& view) const;
  std::vector<glm::dvec4> GetClipPlanesVC(const vtkPointSplatView& view) const;

  /// But for Batches, which follow from the view and the others.
  bool operator==(const vtkPointSplatItem& other) const;
};

/**
 * What is peeled off before a layer is reconstructed.
 */
struct vtkPointSplatPeel
{
  /// The layers before, the last one first; the next ones repeat the last there is.
  std::vector<const vtkPointSplatImages*> Previous;
  /// The opaque scene's depth (a texture with the images' pixels), or 0.
  GLuint SceneDepth = 0;
  /// All that is left makes one layer, weighted by opacity.
  bool Gather = false;
  /// How many layers were peeled before; splats that have nothing left are skipped.
  int Layer = 0;
};

class vtkPointSplatStages
{
public:
  /**
   * Slots that the tags of coded depths can tell apart.
   */
  static constexpr int MaximumSlots = 64;

  ///@{
  /**
   * How far disks reach in the visibility pass, in radii; the least radius, in pixels, of a
   * disk's image there; and the prefilter's radius, in pixels, in the accumulation pass.
   */
  // Disks that cover their neighbours' Voronoi cells in the tangent plane leave cracks where the
  // surface bends and is seen at a flat angle.
  static constexpr float DiskReach = 1.15f;
  // Splats cover the surface together; widening each to a pixel would widen silhouettes.
  static constexpr float CoverageRadius = 0.1f;
  // Guennebaud, section 4.1, has the square root of two; the Gaussian of sigma 0.6 is then as
  // wide as a pixel is, which blurs more than the pixels of a supersampled picture do.
  static constexpr float PrefilterRadius = 0.8f;
  ///@}

  /**
   * Whether the context has what compute shaders need.
   */
  static bool ComputeSupported(vtkOpenGLRenderWindow* window);

  /**
   * Depths and sums of the layer nearest to the eye, of all items together.
   * depthUnit: the unit of depths in the sums, world units. With a peel, the layer behind
   * those before; empty gets whether there is nothing left, and the layer then is void.
   * False, with GetError(), where a shader does not compile.
   */
  bool Reconstruct(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images, float depthUnit,
    const vtkPointSplatPeel* peel = nullptr, bool* empty = nullptr);

  /**
   * Ids of the splats with the greatest weights in that layer.
   */
  bool Identify(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images,
    vtkPointSplatCloud::IdKind kind);

  const std::string& GetError() const { return this->Error; }
  void Release();

  ///@{
  /**
   * What other ways to reconstruct a layer share: all uniforms of an item; the state in which
   * quads are drawn, nearest first with nothing else in the way; the draw itself, of count splats
   * from first on (all of them if count is negative), with an id map or 0.
   */
  static void SetItem(vtkPointSplatProgram& program, const vtkPointSplatView& view,
    const vtkPointSplatItem& item, const glm::ivec2& imageSize);
  static void SetStateForQuads(vtkOpenGLState* state, const glm::ivec2& imageSize);
  static void DrawQuads(const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers,
    GLuint idMap, vtkIdType first = 0, vtkIdType count = -1);
  /// Draws points that are projected as single pixels.
  static void DrawPoints(
    const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers, GLuint idMap);
  /// Binds the vertex array for such a draw; divisor: 1 with one instance a splat.
  static void BindQuads(const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers,
    GLuint idMap, vtkIdType first, GLuint divisor = 1);
  ///@}

private:
  enum Stage
  {
    Visibility,
    Accumulation,
    Identification
  };
  /// The program of a stage for an item, in use. sums: the images that the stage adds to.
  vtkPointSplatProgram* Use(Stage stage, bool compute, const vtkPointSplatItem& item,
    const vtkPointSplatPeel* peel = nullptr, const vtkPointSplatImages* sums = nullptr);
  /// What the layers before and the scene are to a stage.
  static void SetPeel(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
    const vtkPointSplatView& view, const vtkPointSplatPeel* peel, bool compute);
  static void Dispatch(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
    vtkIdType splats, vtkPointSplatCloud::Buffers& buffers);
  /// Of points: count of them, of those that are listed or else in the item's batches.
  void DispatchPoints(vtkPointSplatProgram& program, vtkPointSplatUnits& units, size_t index,
    const vtkPointSplatItem& item, vtkIdType count, bool listed,
    vtkPointSplatCloud::Buffers& buffers) const;
  void UploadBatches(const std::vector<vtkPointSplatItem>& items);
  void PrepareLists(const std::vector<vtkPointSplatItem>& items, int layer);
  bool ReconstructByCompute(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images, float depthUnit,
    const vtkPointSplatPeel* peel, bool* empty);
  bool ReconstructByQuads(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images, float depthUnit,
    const vtkPointSplatPeel* peel, bool* empty);
  bool IdentifyByQuads(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images,
    vtkPointSplatCloud::IdKind kind);

  std::map<std::string, vtkPointSplatProgram> Programs; // by files and defines
  GLuint Found = 0; // a buffer: whether compute shaders found anything

  /**
   * Of one item while layers are peeled: buffers with a count and the indices of splats that
   * may have a part in this layer, and in the next one.
   */
  struct Lists
  {
    GLuint Buffers[2] = { 0, 0 };
    vtkIdType Capacity = 0;
    vtkIdType Count = 0; // of those in this layer
  };
  std::vector<Lists> ItemLists;
  std::vector<GLuint> BatchBuffers; // of items, the numbers of batches in view
  std::string Error;
};

#endif
