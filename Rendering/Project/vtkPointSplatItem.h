// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One cloud to draw, with all that its projection depends on.
#ifndef vtkPointSplatItem_h
#define vtkPointSplatItem_h

#include "vtkPointSplatCloud.h"
#include "vtkPointSplatView.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
VTK_ABI_NAMESPACE_END
class vtkPointSplatProgram;

/**
 * The kernel that weights splats (vtkPointSplatKernel.glsl).
 */
struct vtkPointSplatKernel
{
  bool Plateau = false;
  glm::vec2 Shape{ 0.0f }; // Gaussian: 1 / (2 sigma^2); plateau: a and n
  double Support = 1.5;    // radii
  bool operator==(const vtkPointSplatKernel& other) const
  {
    return this->Plateau == other.Plateau && this->Shape == other.Shape &&
      this->Support == other.Support;
  }
};

/**
 * How points are projected as single pixels.
 */
struct vtkPointSplatPoints
{
  double Layer = 0.0;         // the least layer distance, world units ...
  double LayerPixels = 0.0;   // ... and in pixels; the larger counts
  double Spacing = 0.0;       // world units
  double SpacingPixels = 0.0; // the same where they are nearest to the eye, pixels
  bool Silhouettes = false;   // are anti-aliased
  bool operator==(const vtkPointSplatPoints& other) const
  {
    return this->Layer == other.Layer && this->LayerPixels == other.LayerPixels &&
      this->Spacing == other.Spacing && this->SpacingPixels == other.SpacingPixels &&
      this->Silhouettes == other.Silhouettes;
  }
};

/**
 * Where splats may be drawn that stand for others (vtkPointSplatLevels.h).
 */
struct vtkPointSplatLevelBounds
{
  double Pixels = 0.0;       // of their radii, whatever the surface is like; 0: nowhere
  double SmoothPixels = 0.0; // the same, where normals deviate by no more than this
  double Deviation = 0.0;
  bool operator==(const vtkPointSplatLevelBounds& other) const
  {
    return this->Pixels == other.Pixels && this->SmoothPixels == other.SmoothPixels &&
      this->Deviation == other.Deviation;
  }
};

/**
 * What of an item's look is blended beside colours, for textures, tangents and edges.
 */
struct vtkPointSplatItemLook
{
  bool Coordinates = false; // of textures
  bool Repeats = false;     // that differ by whole numbers mean the same
  bool Tangents = false;
  bool HasMore = false;     // than textures of colours
  float EdgeWidth = 0.0f;   // pixels; 0: there are none
  vtkMTimeType Time = 0;    // of textures, and of how they are taken
  bool IsPlain() const { return !this->Coordinates && !this->Tangents && this->EdgeWidth == 0.0f; }
  /// How many texels a pixel takes beside a layer's (vtkPointSplatLook.glsl).
  int GetTexels() const
  {
    const bool more = this->HasMore || this->Tangents || this->EdgeWidth > 0.0f;
    return more ? 2 : this->Coordinates ? 1 : 0;
  }
  bool operator==(const vtkPointSplatItemLook& other) const
  {
    return this->Coordinates == other.Coordinates && this->Repeats == other.Repeats &&
      this->Tangents == other.Tangents && this->HasMore == other.HasMore &&
      this->EdgeWidth == other.EdgeWidth && this->Time == other.Time;
  }
};

struct vtkPointSplatItem
{
  /// As many as the shaders take; VTK's own mappers take six.
  static constexpr int MostClipPlanes = 6;

  vtkPointSplatCloud* Cloud = nullptr;
  glm::dmat4 MCWC{ 1.0 };
  int Slot = 0;               // names the cloud in tags
  int Culling = 0;            // 1 back faces, 2 front faces
  double RadiusScale = 1.0;
  double UsualRadius = 0.0;   // of points that have none, in the cloud's coordinates
  int StrideShift = 0;        // every 2^StrideShift-th splat is drawn
  double LayerDistance = 0.0; // world units; 0: by LayerRadii
  double LayerRadii = 0.0;    // a fraction of each radius; 0: by LayerDistance
  double LargestLayer = 0.0;  // an upper bound of it, world units
  vtkPointSplatKernel Kernel;
  std::vector<glm::dvec4> ClipPlanes;         // world coordinates
  glm::ivec4 Window{ 0 };                     // pixels that it can cover
  const vtkPointSplatBuffer* Factors = nullptr; // RGBA, 8 bits each, of as many lights, a splat
  int FactorCount = 0;                        // the lights
  vtkPointSplatLevels::Deviations FactorDeviations; // of the levels' blocks, or null
  unsigned long FactorVersion = 0;            // counts what was in the buffer
  bool IsFlat = false;                        // a pixel has the normal of one splat
  vtkPointSplatItemLook Look;
  double CoveringScale = 1.0;                 // how much larger group-sorted splats are drawn at most
  bool IsPoints = false;                      // projected as single pixels
  vtkPointSplatPoints Points;
  vtkPointSplatLevelBounds Levels;
  bool IsStreamed = false;     // buffers hold only splats that were selected
  double TrianglePixels = 0.0; // where edges are longer, triangles are drawn; 0: nowhere
  /// Splats in view, which follow from the rest; null: those of all points.
  std::shared_ptr<const vtkPointSplatRuns> Runs;
  glm::vec4 Colour{ 1.0f }; // and opacity, where layers of several items are gathered
  glm::vec2 Opacities{ 1.0f }; // of front and back faces

  /// A mapper's, in world coordinates, up to the most that can be.
  static std::vector<glm::dvec4> ClipPlanesOf(vtkMapper* mapper);

  /**
   * How values are mapped, by a table that begins at this entry, or what is done with colours
   * (vtkPointSplatValue.glsl).
   */
  glm::vec4 GetValueMap(size_t first = 0) const;
  /// From the coordinates in the cloud's buffers to view coordinates.
  glm::dmat4 GetMCVC(const vtkPointSplatView& view) const;
  std::vector<glm::dvec4> GetClipPlanesVC(const vtkPointSplatView& view) const;
  /// By which matrices stretch lengths: the root of the sum of squares, and the mean.
  double GetStretch() const;
  double GetMeanStretch() const;
  /// By which splats grow, of which only every 2^StrideShift-th is drawn.
  double GetStrideScale() const;
  bool IsInView() const
  {
    return this->Window.x <= this->Window.z && this->Window.y <= this->Window.w;
  }
  /// Whether splats are selected in the tree of the levels' blocks, be it of points alone.
  bool IsSelectedByLevels() const
  {
    return this->Levels.Pixels > 0.0 ||
      (this->TrianglePixels > 0.0 && this->Cloud->GetLevels().AreMade());
  }
  ///@{
  /// The cloud's buffers, with ids of a kind, or without; and where in them the selected splats are, if some are selected.
  vtkPointSplatCloud::Buffers& Upload(const vtkPointSplatCloud::IdKind* ids = nullptr) const;
  const std::vector<vtkPointSplatRuns::Run>& GetRunsIn(const vtkPointSplatCloud::Buffers& buffers) const
  {
    return buffers.Runs ? buffers.Resident : this->Runs->Runs;
  }
  ///@}
  /// Splats of a block, as a power of two.
  int GetBlockShift() const
  {
    return this->IsSelectedByLevels() ? vtkPointSplatBlocks::PieceShift
                                      : vtkPointSplatBlocks::Shift;
  }
  /// Of those that are drawn, in the cloud's coordinates.
  double GetLargestRadius() const;
  /// Splats that are projected: of the blocks, by the stride.
  vtkIdType GetNumberOfInvocations() const;
  /// Triangles that are drawn in the place of splats.
  vtkIdType GetNumberOfTriangles() const
  {
    return this->Runs ? static_cast<vtkIdType>(this->Runs->Triangles.size()) : 0;
  }

  /// But for Runs.
  bool operator==(const vtkPointSplatItem& other) const;

  /// Sets the uniforms of vtkPointSplatBlockList.glsl.
  void SetBlockUniforms(vtkPointSplatProgram& program) const;
  /// Sets the uniforms of vtkPointSplatProjection.glsl.
  void SetUniforms(vtkPointSplatProgram& program, const vtkPointSplatView& view) const;
};

/**
 * A part of the window (first x, y, last x, y), and the items with the blocks that it shows.
 */
struct vtkPointSplatPart
{
  glm::ivec4 Window;
  std::vector<vtkPointSplatItem> Items;
};

#endif
