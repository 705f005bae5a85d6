// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The splats of one mapper's input, in the form in which the stages read them,
// in main memory and in the buffers of each OpenGL context that drew them.
//
// Splats, 32-bit words, in the order of the points (ids tell which, since points
// that cannot be drawn are left out). Coordinates are relative to an origin in
// the middle of the data, so that single precision keeps millimetres in UTM.
//   circular:   x y z radius | plane's normal, normal, bend, point id
//   elliptical: x y z longer axis | plane's normal, normal, 0, point id | axis 1, 0 | axis 2, 0
// Normals are coded in two times 16 bits on an octahedron; the bend, the matrix K
// of vtkPointSplatProjection.glsl, in three times 10.
// Colours: RGBA, 8 bits each, one a splat, where scalars colour the points.
// Factors: of up to four lights, 8 bits each, one a splat, where the input has `ShadowFactor`.
#ifndef vtkPointSplatCloud_h
#define vtkPointSplatCloud_h

#include "vtkPointSplatBatches.h"
#include "vtkPointSplatContext.h"
#include "vtkPointSplattingOpenGL.h"

#include "vtkTimeStamp.h"
#include "vtkType.h"

#include "vtkPointSplattingABI.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkPointSet;
class vtkPointSplatMapper;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class vtkPointSplatCloud
{
public:
  /**
   * What a hardware selection wants to know of a splat beside the point's id.
   */
  enum IdKind
  {
    PointIds,
    CellIds,
    CompositeIds
  };

  /**
   * The buffers of one context.
   */
  struct Buffers
  {
    GLuint Splats = 0;
    GLuint SplatTexture = 0; // the buffer as RGBA32UI texels
    GLuint Colours = 0;
    GLuint Factors = 0;
    GLuint IdMaps[3] = { 0, 0, 0 }; // by IdKind; that of point ids stays 0
    GLuint Large = 0;               // a count, then indices of splats of many pixels
    GLuint VertexArray = 0;
    vtkTimeStamp SplatTime;
    vtkTimeStamp ColourTime;
    vtkPointSplatContext Context;

    void Delete();
  };

  vtkPointSplatCloud() = default;
  /// Deletes the buffers of the current context.
  ~vtkPointSplatCloud();
  vtkPointSplatCloud(const vtkPointSplatCloud&) = delete;
  void operator=(const vtkPointSplatCloud&) = delete;

  /**
   * Follows the input and the mapper's colouring, doing anew only what changed.
   */
  void Update(vtkPointSplatMapper* mapper, vtkDataObject* input);

  /**
   * A run of splats in the buffers that lie close together, and their middle in the cloud's
   * coordinates.
   */
  struct Leaf
  {
    vtkIdType First;
    vtkIdType Count;
    double Centre[3];
  };

  /**
   * Divides the splats into groups, those of the input's array or, where it has none, such
   * that splats nearer than factor * reach times their radii are apart; or into a number of
   * groups with the least overlap. Done anew only when splats or arguments change. False where
   * that cannot be done. Buffers then hold splats group by group, in Morton order within each.
   */
  bool MakeGroups(double factor, double reach, int number = 0);
  bool HasGivenGroups() const { return this->GroupsGiven; }
  /// A group's splats, in leaves.
  std::vector<Leaf> const& GetLeaves(int group) const;
  int GetNumberOfGroups() const
  {
    return this->GroupStarts.empty() ? 0 : static_cast<int>(this->GroupStarts.size()) - 1;
  }
  vtkMTimeType GetGroupMTime() const { return this->GroupTime.GetMTime(); }
  /// The first splat of a group in the buffers, and how many it has.
  std::pair<vtkIdType, vtkIdType> GetGroup(int group) const;

  /**
   * The buffers of the current context, which belongs to the window, filled.
   */
  Buffers& Upload(vtkWindow* window);

  /**
   * Makes the id map of a kind for Upload()'s buffers, if it is wanted at all:
   * 0 where the splats' own ids serve.
   */
  GLuint UploadIdMap(vtkWindow* window, IdKind kind);

  /**
   * Deletes the window's buffers. Its context must be current.
   */
  void Release(vtkWindow* window);

  /**
   * Batches of points in the order of the buffers, made anew only when splats or their order
   * changed.
   */
  const vtkPointSplatBatches& GetBatches();

  vtkIdType GetNumberOfSplats() const { return this->Count; }
  vtkIdType GetNumberOfSkippedPoints() const { return this->Skipped; }
  vtkIdType GetNumberOfPoints() const { return this->Points; }
  /// The point, of its block, that a splat was made from.
  vtkIdType GetPointId(vtkIdType splat) const
  {
    return this->Splats[this->GetWordsPerSplat() * static_cast<size_t>(splat) + 7];
  }
  /// Splats as the buffers have them, but in the order of the points.
  const std::vector<uint32_t>& GetSplats() const { return this->Splats; }
  size_t GetWordsPerSplat() const { return this->Circular ? 8 : 16; }
  bool IsCircular() const { return this->Circular; }
  bool HasColours() const { return !this->Colours.empty(); }
  /// Of how many lights the input has factors.
  int GetFactorCount() const { return this->FactorCount; }
  double GetMedianRadius() const { return this->MedianRadius; }
  double GetMaximumRadius() const { return this->MaximumRadius; }
  /// The mean distance of neighbouring points, world units, roughly; where the sampling changes over
  /// the surface, their distance where it is sparsest but for a tenth of the area.
  double GetSpacing();

  /**
   * The mean of the splats' mean curvatures, as far as these are known, over the input's unit of
   * length: the outline of a convex body is on average half its surface times that (Minkowski,
   * Cauchy). Dents, which hide some of the outlines that bumps have, count half.
   */
  double GetMeanCurvature();
  const std::array<double, 3>& GetOrigin() const { return this->Origin; }
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }
  vtkMTimeType GetMTime() const;
  /// When splats, or their order in the buffers, changed.
  vtkMTimeType GetGeometryMTime() const;

private:
  struct Block
  {
    vtkPointSet* Data;
    unsigned int FlatIndex;
    vtkIdType First;
    vtkIdType Count;
  };
  static std::vector<Block> Gather(vtkDataObject* input);
  void BuildSplats(vtkPointSplatMapper* mapper, std::vector<Block>& blocks, bool needSizes);
  void BuildColours(vtkPointSplatMapper* mapper, const std::vector<Block>& blocks);
  void BuildFactors(vtkPointSplatMapper* mapper, const std::vector<Block>& blocks);
  std::vector<uint32_t> MakeIdMap(IdKind kind) const;
  bool GivenGroups(std::vector<int>& groups) const;
  bool FindGroups(std::vector<int>& groups, double factor, double reach, int number) const;
  void MakeLeaves();
  /// As the buffers hold them: data of some words a splat, in the groups' order.
  std::vector<uint32_t> Ordered(const std::vector<uint32_t>& data, size_t words) const;

  std::vector<uint32_t> Splats;
  std::vector<uint32_t> Colours;
  std::vector<uint32_t> Factors;
  int FactorCount = 0;
  std::vector<Block> Blocks; // of the input that Splats came from
  vtkIdType Count = 0;
  vtkIdType Points = 0;
  vtkIdType Skipped = 0;
  bool Circular = true;
  bool Sized = true;    // whether all splats have a radius
  double Spacing = 0.0; // 0: not yet found
  double MeanCurvature = -1.0; // less than 0: not yet found
  double MedianRadius = 0.0;
  double MaximumRadius = 0.0;
  std::array<double, 3> Origin{ { 0.0, 0.0, 0.0 } };
  std::array<double, 6> Bounds{ { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
  std::vector<uint32_t> Order;        // of splats in the buffers; empty: as they are
  std::vector<vtkIdType> GroupStarts; // of groups in the buffers, and the end
  double GroupFactor = 0.0;
  double GroupReach = 0.0;
  int GroupNumber = 0;
  bool GroupsGiven = false;
  std::vector<std::vector<Leaf>> Leaves; // of each group
  vtkTimeStamp GroupTime;
  vtkPointSplatBatches Batches;
  vtkTimeStamp BatchTime;
  vtkDataObject* Input = nullptr; // compared only
  vtkTimeStamp SplatTime;
  vtkTimeStamp ColourTime;
  std::map<vtkWindow*, std::unique_ptr<Buffers>> PerWindow;
};

#endif
