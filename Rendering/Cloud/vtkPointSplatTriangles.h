// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a cloud whose points are a mesh's, in patches that are drawn either as triangles
// or as splats (Guennebaud, Barthe, Paulin 2006, section 5.2, has leaves of an octree for that).
//
// 1. Polygons and strips of all blocks become triangles of splats: concave polygons as VTK cuts them
//    up, others about their first corner. Cells that are ghosts, or have points that are no splats,
//    are left out.
// 2. Patches are runs of splats: blocks of the selection, or the blocks of points where the cloud has
//    levels. Triangles are ordered by the first of their corners' patches. Those within one patch
//    come first there; the others cross from patch to patch and are known to each.
// 3. Each patch has the box about all its triangles, and how long their edges are: the root of the
//    mean square, or a third of the longest if that is more, so that no large triangle is lost among
//    small ones. Levels' blocks have the box about the patches below, and the longest of their edges.
// 4. Splats without a triangle are listed, in runs: they are drawn whatever becomes of the triangles
//    about them, as where a scan is patched by a mesh.
//
// Words of a triangle: the three splats, and the cell that it is of.
#ifndef vtkPointSplatTriangles_h
#define vtkPointSplatTriangles_h

#include "vtkPointSplatBlocks.h"
#include "vtkPointSplatCopies.h"
#include "vtkPointSplatLevels.h"

#include <array>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkPointSplatTriangles
{
public:
  /**
   * A block of the input, and its splats. Data that is no poly data: null.
   */
  struct Mesh
  {
    vtkPolyData* Data;
    vtkIdType First;
    vtkIdType Count;
    const vtkPointSplatCopies* Copies; // points whose triangles have other points' splats as corners; or null
  };

  /**
   * All splats as they are packed, of some words each, and the levels' blocks if there are some.
   */
  struct Splats
  {
    const std::vector<uint32_t>& Words;
    size_t WordsPerSplat;
    vtkIdType Count;
    const vtkPointSplatLevels& Levels;
  };

  /**
   * What a part of the surface takes in the buffers' coordinates.
   */
  struct Extent
  {
    std::array<float, 3> Low;
    std::array<float, 3> High;
    float Edge; // how long edges are; 0: there are no triangles
  };

  struct Patch
  {
    Extent Size;
    uint32_t First;     // triangles, of which those from Crossing on cross to other patches
    uint32_t Crossing;
    uint32_t End;
    uint32_t FirstShared; // in GetShared(): all that cross from or to this patch
    uint32_t FirstLoose;  // in GetLoose()
  };

  /**
   * A triangle of several patches, in the order of these; two are the same where it has two.
   */
  struct Shared
  {
    uint32_t Triangle;
    std::array<uint32_t, 3> Patches;
  };

  void Make(const std::vector<Mesh>& meshes, const Splats& splats);

  bool AreMade() const { return !this->Corners.empty(); }
  /// Four words a triangle.
  const std::vector<uint32_t>& GetCorners() const { return this->Corners; }
  /// Of points without levels the selection's blocks, in their order; and one behind the last.
  const std::vector<Patch>& GetPatches() const { return this->Patches; }
  size_t GetNumberOfPatches() const { return this->Patches.empty() ? 0 : this->Patches.size() - 1; }
  const std::vector<Shared>& GetShared() const { return this->Crossings; }
  const std::vector<vtkPointSplatRuns::Run>& GetLoose() const { return this->Loose; }
  /// Of a block of levels; and the patch that one of points is.
  const Extent& GetExtent(size_t block) const { return this->Extents[block]; }
  uint32_t GetPatch(size_t block) const { return this->PatchOfBlock[block]; }
  /// The longest edge of all.
  float GetLongestEdge() const { return this->LongestEdge; }

private:
  void Collect(const Mesh& mesh, const Splats& splats, std::vector<bool>& used);
  std::vector<uint32_t> DividePatches(const Splats& splats);
  void Order(const std::vector<uint32_t>& patchOf);
  void Measure(const Splats& splats);
  void FindLoose(const std::vector<bool>& used, const std::vector<uint32_t>& patchOf);

  std::vector<uint32_t> Corners;
  std::vector<Patch> Patches;
  std::vector<Shared> Crossings;
  std::vector<vtkPointSplatRuns::Run> Loose;
  std::vector<Extent> Extents;
  std::vector<uint32_t> PatchOfBlock;
  float LongestEdge = 0.0f;
};

#endif
