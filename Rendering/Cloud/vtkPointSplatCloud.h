// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The splats of one input, in the form in which the stages read them, in main memory and in the
// buffers of each OpenGL context that drew them.
//
// 1. The arrays of each block (a leaf of a composite data set, or the input itself) are packed;
//    what is missing is estimated, of blocks that are pieces of one cloud together
//    (vtkPointSplatPieces.h). Points that cannot be drawn are left out and counted.
// 2. Each block's splats are put into Morton order, once: tiles, blocks and caches live on
//    neighbours that lie together. Of those that are the same one is left (vtkPointSplatCopies.h).
// 3. Colours, factors of lights and groups are made for them, in the same order.
// 4. Of large clouds that stay as they are levels are made, of splats that stand for those below
//    them (vtkPointSplatLevels.h); then splats are in the order of these, in which those of several blocks may be
//    mixed.
// 5. Where triangles are to be drawn in the place of splats, they are found (vtkPointSplatTriangles.h).
// 6. Where nothing but positions and normals changed, splats are moved along, if sizes can follow
//    (vtkPointSplatMotion.h).
// Each of these is made anew only when an array that it is made from is another one or was
// modified; a data set that was copied shallowly, or whose scalars alone changed, keeps its splats.
//
// Splats, 32-bit words. Coordinates are relative to an origin in the middle of the data, so that
// single precision keeps millimetres in UTM.
//   circular:   x y z radius | plane's normal, normal, bend, point id
//   elliptical: x y z longer axis | plane's normal, normal, 0, point id | axis 1, 0 | axis 2, 0
// Normals are coded in two times 16 bits on an octahedron; the bend, the matrix K of
// vtkPointSplatProjection.glsl, in three times 10, and bit 30 is set for a body alone, whose plane is
// across the ray that sees it. Without sizes the radius is 0.
// Clip lines (`SplatClip`): four floats a splat, where any point has some, (c1 . s, c1 . t, c2 . s,
// c2 . t) with its axes s and t, of circular ones the tangents of vtkPointSplatProjection.glsl: of
// s u + t v is kept what has dot(c, (u, v)) <= 1.
// Colours: RGBA, 8 bits each, one a splat, where scalars colour the points; or values (see below).
// Factors: of up to four lights, 8 bits each, one a splat, where the input has `ShadowFactor`.
// Coordinates, of textures, where they are needed: four words a splat
// (vtkPointSplatCoordinates.h), and tangents, coded as normals, one word. Blocks without them have
// none beside those with.
//
// Colours of cells: a splat has that of the first cell, by its id, that uses the point, as of a
// point's vertex; points of a block without cells have the table's colour of NaN. They are not
// blended: a pixel has the colour of the splat with the greatest weight.
// Looks of blocks: hidden ones have no splats. Where some block has a colour or an opacity of its own,
// colours hold for all blocks what is to be seen, opacities those of actor and scalars multiplied.
// Values: where scalars are to be interpolated before they are mapped, there are values in the
// place of colours. Stages blend these, and map the mean of each pixel through the cloud's table, so that
// no colour appears that the table has not (vtkPointSplatValue.glsl). A value is a float from 0, the
// least of the cloud, to 1, the greatest; its sign bit is set where there is none, as of NaN. The
// table is vtkMapper's, with the colours below and above the range at its ends, and behind them that
// of NaN. All blocks must have values, or colours are blended, as they are of direct colours, of cell
// scalars and by indexed tables, which have nothing between two of their colours.
#ifndef vtkPointSplatCloud_h
#define vtkPointSplatCloud_h

#include "vtkPointSplatBlocks.h"
#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatCloudInput.h"
#include "vtkPointSplatCopies.h"
#include "vtkPointSplatFillPoints.h"
#include "vtkPointSplatGroups.h"
#include "vtkPointSplatLevels.h"
#include "vtkPointSplatMotion.h"
#include "vtkPointSplatPacking.h"
#include "vtkPointSplatStore.h"
#include "vtkPointSplatTriangles.h"

#include "vtkTimeStamp.h"

#include <array>
#include <list>
#include <map>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkPointSplatCloud
{
public:
  /**
   * What a hardware selection wants to know of a splat.
   */
  enum IdKind
  {
    PointIds,
    CellIds,
    CompositeIds
  };

  /**
   * The buffers of one context: in Morton order, or group by group.
   */
  struct Buffers
  {
    vtkPointSplatBuffer Splats{ GL_RGBA32UI };
    vtkPointSplatBuffer ClipLines{ GL_RGBA32F };
    vtkPointSplatBuffer Colours{ GL_R32UI };
    vtkPointSplatBuffer ValueTable{ GL_R32UI };
    vtkPointSplatBuffer Factors{ GL_R32UI };
    vtkPointSplatBuffer Coordinates{ GL_RGBA32UI };
    vtkPointSplatBuffer Tangents{ GL_R32UI };
    vtkPointSplatBuffer Ids{ GL_R32UI };
    vtkPointSplatBuffer Triangles{ GL_RGBA32UI };
    IdKind IdsAre = PointIds;
    vtkPointSplatHandle VertexArray{ vtkPointSplatHandle::VertexArray };
    // Of which splats all this is, one after another, and where they are in it; null: of all.
    std::shared_ptr<const vtkPointSplatRuns> Runs;
    std::vector<vtkPointSplatRuns::Run> Resident;
    vtkPointSplatBuffer RunTable; // of vtkPointSplatStore
    std::array<vtkPointSplatStore, 6> Stores; // of all that some of which is in buffers: see GetArrays()
    vtkTimeStamp StoreTime;
    vtkTimeStamp RunTime;
    vtkTimeStamp SplatTime;
    vtkTimeStamp ClipLineTime;
    vtkTimeStamp ColourTime;
    vtkTimeStamp ValueTime;
    vtkTimeStamp FactorTime;
    vtkTimeStamp CoordinateTime;
    vtkTimeStamp TangentTime;
    vtkTimeStamp IdTime;
    vtkTimeStamp TriangleTime;
  };

  vtkPointSplatCloud() = default;
  ~vtkPointSplatCloud() = default;
  vtkPointSplatCloud(const vtkPointSplatCloud&) = delete;
  void operator=(const vtkPointSplatCloud&) = delete;

  /// The objects that something was made from, and their times.
  using Key = std::vector<std::pair<const vtkObject*, vtkMTimeType>>;

  /**
   * Follows the input, doing anew only what changed.
   */
  void Update(const vtkPointSplatCloudInput& input);

  /**
   * Moves the splats to where the input's points are now, if that can be done without estimating anything, or
   * if they are there. What Update() does beside it is left to that.
   */
  bool Follow(const vtkPointSplatCloudInput& input);
  /// Whether sizes are those of an earlier frame.
  bool IsFollowing() const { return this->Motion.HasBegun(); }

  ///@{
  /**
   * What splats are made from: an input with another key gets other splats. IsMadeFrom(): Update()
   * would keep these. StayingKeyOf(): what must stay for them to be moved along. Adopt() says that they
   * were made from a copy of what has these keys.
   */
  static Key KeyOf(const vtkPointSplatCloudInput& input);
  static Key StayingKeyOf(const vtkPointSplatCloudInput& input);
  bool IsMadeFrom(const vtkPointSplatCloudInput& input) const;
  void Adopt(Key key, Key staying)
  {
    this->SplatsMadeFrom = std::move(key);
    this->StaysFrom = std::move(staying);
  }
  ///@}

  /**
   * Of one data set's points, as they are given: the bounds of those that can be drawn, which
   * nothing must be estimated for.
   */
  static std::array<double, 6> BoundsOf(vtkPointSet* data);

  ///@{
  /**
   * The buffers of the entered context, filled: in Morton order, or in that of the groups. With
   * ids of a kind, which are made at need.
   */
  Buffers& Upload() { return this->Fill(this->PerContext, false); }
  Buffers& UploadGrouped() { return this->Fill(this->GroupedPerContext, true); }
  Buffers& UploadIds(IdKind kind);
  ///@}
  ///@{
  /**
   * Whether buffers rather hold only those splats that a frame shows: all, with the levels', are more than a buffer holds, or
   * only those are moved to where points are now. UploadRuns(): such buffers of the entered context, with ids of
   * a kind, or of none; the program in use, and storage of the indices 1, 2 and 7, are others then.
   * GetRunBuffers(): the same, whatever is in them.
   */
  bool AreStreamed() const;
  Buffers& UploadRuns(const std::shared_ptr<const vtkPointSplatRuns>& runs, const IdKind* ids);
  Buffers& GetRunBuffers() { return vtkPointSplatCloud::Find(this->RunsPerContext); }
  ///@}
  /// Whether buffers hold so many splats: shaders read two gigabytes of them, 67 million circles, and so do drivers.
  bool Fits(vtkIdType splats) const;
  /// Brings the splats of some of the levels' blocks, and these blocks, to where points were moved to.
  void MoveBlocks(const std::vector<uint32_t>& blocks);

  /// Makes the triangles between the splats, if that is not done.
  void MakeTriangles();
  const vtkPointSplatTriangles& GetTriangles() const { return this->Triangles; }
  vtkMTimeType GetTriangleTime() const { return this->TriangleTime; }
  /// Their corners, in the entered context.
  const vtkPointSplatBuffer& UploadTriangles();

  /// Deletes the window's buffers.
  void Release(vtkOpenGLRenderWindow* window);

  /// The groups of the splats, which belong to who asked for them last.
  vtkPointSplatGroups& GetGroups() { return this->Groups; }
  /**
   * Divides the splats into groups: see vtkPointSplatGroups. False where that cannot be done.
   */
  bool MakeGroups(const vtkPointSplatGroups::Request& request);

  const vtkPointSplatBlocks& GetBlocks();

  /**
   * Says that levels would be of use: they are made in the background, of splats that stay as they
   * are from one time that they are wanted to the next, and taken by Update().
   */
  void WantLevels();
  bool AreLevelsWanted() const { return this->LevelsAskedFor != 0; }
  ///@{
  /**
   * Of which splats, by their time, levels were asked for and not begun; 0: of none. BeginLevels()
   * does that, where there can be some. Whether they are being made; and are ready for Update().
   */
  vtkMTimeType GetLevelsPending() const;
  bool BeginLevels();
  bool AreLevelsUnderWay() const { return this->Levels.IsUnderWay(); }
  bool AreLevelsReady() const { return this->Levels.IsReady(); }
  ///@}
  /// Makes levels, if there can be some, and waits for them; until another thread says not to.
  void MakeLevels();
  void AbortLevels() { this->Levels.Abort(); }
  /// Of splats that stand for others, which lie behind those of points: see vtkPointSplatLevels.
  const vtkPointSplatLevels& GetLevels() const { return this->Levels; }
  /// Of the levels' blocks how much colours differ from their means, and factors; or null.
  const vtkPointSplatLevels::Deviations& GetColourDeviations() const
  {
    return this->ColourDeviations;
  }
  const vtkPointSplatLevels::Deviations& GetFactorDeviations() const
  {
    return this->FactorDeviations;
  }

  /**
   * The points that splats were made from, a vertex each, for what draws no splats: in the input's
   * order, with normals where all blocks have them, and colours (RGBA) where splats have some.
   */
  void MakeVertices(vtkPolyData* vertices) const;

  vtkIdType GetNumberOfSplats() const { return this->Count; }
  /// With those of levels.
  vtkIdType GetNumberOfStoredSplats() const
  {
    return this->Count + static_cast<vtkIdType>(this->Levels.GetNumberOfSplats());
  }
  vtkIdType GetNumberOfSkippedPoints() const { return this->Skipped; }
  /// Those of no cell but ghosts, where there are cells; they are not among the skipped ones.
  vtkIdType GetNumberOfUnusedPoints() const { return this->Unused; }
  /// Whether points of some block are drawn where they were projected to.
  bool IsProjected() const { return this->Projected; }
  /// With those that the input's Whole has beside its own.
  vtkIdType GetNumberOfPoints() const;
  /// Those that are drawn by other points' splats, which are the same.
  vtkIdType GetNumberOfCopies() const;
  /// Them, of one block after another.
  std::vector<vtkPointSplatCopies::Copy> GetCopies() const;
  /// Of those points, how many splats are made from.
  double GetShare() const;
  /// The point, of its block, that a splat was made from.
  vtkIdType GetPointId(vtkIdType splat) const
  {
    return this->GetRestingSplats()[this->GetWordsPerSplat() * static_cast<size_t>(splat) + 7];
  }
  size_t GetWordsPerSplat() const { return this->Circular ? 8 : 16; }
  bool IsCircular() const { return this->Circular; }
  /// Whether the input has several blocks, or might have.
  bool IsComposite() const { return this->Composite; }
  /// Whether any splat has a clip line.
  bool HasClipLines() const { return !this->ClipLines.empty(); }
  /// Whether splats have colours, or values in their place.
  bool HasColours() const { return !this->Colours.empty(); }
  bool HasValues() const { return !this->ValueTable.empty(); }
  /// Whether colours are of cells, and a pixel has that of one splat.
  bool HasCellColours() const { return this->CellColours; }
  /// Whether the actor's opacity is in the colours already.
  bool HasOwnOpacity() const { return this->OwnOpacity; }
  /// Colours, packed as those of splats: the table's, and last that of NaN.
  const std::vector<uint32_t>& GetValueTable() const { return this->ValueTable; }
  /// From a value to its place in the table, in entries: its factor, and what is added.
  const std::array<double, 2>& GetValueScale() const { return this->ValueScale; }
  /// Of how many lights the input has factors.
  int GetFactorCount() const { return this->FactorCount; }
  /// Whether splats have texture coordinates, of which those were asked for; and tangents.
  bool HasCoordinates() const { return !this->Coordinates.empty(); }
  bool HasTangents() const { return !this->Tangents.empty(); }
  double GetMedianRadius() const { return this->MedianRadius; }
  /// The same; of points without sizes, such that their disks would cover the surface.
  double GetUsualRadius();
  double GetMaximumRadius() const { return this->MaximumRadius; }
  /// The distance of neighbouring points, world units (vtkPointSplatSpacing.h).
  double GetSpacing();
  const std::array<double, 3>& GetOrigin() const { return this->Origin; }
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }
  /// When splats, colours, factors, coordinates or tangents changed.
  vtkMTimeType GetMTime() const;
  /// When splats changed.
  vtkMTimeType GetSplatTime() const { return this->SplatTime; }

private:
  /// A block, and its splats.
  struct Block
  {
    vtkPointSet* Data;
    unsigned int FlatIndex;
    vtkIdType First;
    vtkIdType Count;
    std::shared_ptr<const vtkPointSplatFillPoints> Fill; // or none
    std::shared_ptr<const vtkPointSplatCopies> Copies;   // or none

    /// What splats have of an array of the points: by their numbers, fill points' behind the points'.
    template <typename Array>
    vtkSmartPointer<Array> OfSplats(Array* array) const
    {
      const vtkSmartPointer<Array> means =
        this->Copies ? this->Copies->Average(array) : vtkSmartPointer<Array>(array);
      return this->Fill ? this->Fill->Extend(means.Get()) : means;
    }
  };
  using ContextBuffers = std::list<std::pair<vtkPointSplatContext, Buffers>>;

  static std::vector<Block> Gather(vtkDataObject* input);
  static Key SplatKey(const std::vector<Block>& blocks);
  static std::vector<Block> VisibleOf(
    const vtkPointSplatCloudInput& input, std::vector<Block> blocks);
  bool IsMadeFrom(const vtkPointSplatCloudInput& input, const Key& key) const;
  /// False where the estimation of what is missing was aborted: then there are no splats.
  bool BuildSplats(const vtkPointSplatCloudInput& input, std::vector<Block>& blocks);
  /**
   * The arrays of the visible blocks, what is missing estimated, of pieces of one cloud together
   * with their hidden ones. Where blocks have looks they are kept, so that hidden ones come back at once.
   * One may be aborted; then so is all.
   */
  std::vector<vtkPointSplatPacking> CollectBlocks(
    const vtkPointSplatCloudInput& input, const std::vector<Block>& visible);
  static Key KeptKey(const vtkPointSplatCloudInput& input, const std::vector<Block>& pieces);
  vtkIdType BuildBlock(const vtkPointSplatCloudInput& input, Block& block,
    const vtkPointSplatPacking& packing);
  void BuildClipLines(const Block& block, const vtkPointSplatPacking& packing);
  void NumberFillPoints(const Block& block, const vtkPointSplatPacking& packing);
  /// The number of a splat's point among those of a block and its fill points.
  vtkIdType NumberOf(const Block& block, size_t splat) const;
  /**
   * Where some points are so far off that floats about the middle of the bounding box hold no
   * detail of the others: an origin among these, and points beyond the others' reach left out.
   */
  void LeaveOutFar(std::vector<vtkPointSplatPacking>& packings);
  /// Warns where given radii cannot be those of points with this spacing.
  void CheckRadii(vtkObject* owner) const;
  double MeasureSpacing() const;
  std::array<double, 6> GetLocalBounds() const;
  void Measure();
  void BuildColours(const vtkPointSplatCloudInput& input);
  void BuildScalarColours(const vtkPointSplatCloudInput& input, std::vector<bool>& scalars);
  void BuildLooks(const vtkPointSplatCloudInput& input, const std::vector<bool>& scalars);
  bool BuildValues(const vtkPointSplatCloudInput& input);
  void BuildFactors(vtkObject* owner);
  void UpdateCoordinates(const vtkPointSplatCloudInput& input);
  std::vector<uint32_t> MakeIds(IdKind kind) const;
  /// RGBA, 8 bits each, whether splats have colours or values.
  uint32_t ColourOf(vtkIdType splat) const;
  /// Those of the entered context, which are made at need.
  static Buffers& Find(ContextBuffers& all);
  Buffers& Fill(ContextBuffers& all, bool grouped);
  static void UploadSome(const std::vector<uint32_t>& data, size_t words, const Buffers& buffers,
    vtkPointSplatBuffer& to);
  /// What splats have, some words each, and where it goes.
  struct Array
  {
    const std::vector<uint32_t>& Data;
    size_t Words;
    vtkMTimeType Changed;
    vtkPointSplatBuffer& To;
    vtkPointSplatStore& Store;
  };
  std::array<Array, 6> GetArrays(Buffers& buffers);
  /// Whether all of them are on the card, where they are brought if they stay as they are.
  bool KeepOnDevice(Buffers& buffers);
  /// Fills buffers from there with the splats of their runs.
  void Gather(Buffers& buffers);
  static constexpr size_t MostWords = size_t(1) << 29; // of a buffer that shaders read
  /// Widens Low and High by points' finite coordinates; the middle is the origin then.
  void AddRange(vtkDataArray* points);
  void ForgetRange();
  void SetOriginToMiddle();
  bool CanHaveLevels();
  /// Whether there are levels that were not there before.
  bool TakeLevels(bool wait);
  /// Where a splat is; i: from a block's First on.
  size_t SplatOf(vtkIdType i) const
  {
    return this->Mixed.empty() ? static_cast<size_t>(i) : this->Mixed[static_cast<size_t>(i)];
  }
  /// Brings the blocks' splats together again, without levels.
  void Unmix();
  static Key StayingKey(const std::vector<Block>& blocks);
  /// The same of the input's visible blocks, and their key.
  bool Follow(
    const vtkPointSplatCloudInput& input, const std::vector<Block>& blocks, const Key& key);
  /// False where some block has points that are not drawn, or what is given says more than radii.
  static bool CanMove(const std::vector<Block>& blocks);
  bool AreCopiesTogether(const std::vector<Block>& blocks) const;
  /// Whether splats that were left out as copies, of blocks that were there before, still are some.
  bool AreCopiesSame(const std::vector<Block>& blocks);
  void BeginMotion(vtkPointSplatMotion::Splats splats);
  std::vector<uint32_t> FindAnchors(const std::vector<uint32_t>& splats) const;
  std::vector<vtkPointSplatMotion::Part> MakeParts(const std::vector<uint32_t>& anchors);
  bool MoveTo(const std::vector<Block>& blocks);
  /// Moves what was not asked for; all splats are where points are then.
  void MoveAll();
  void MoveParts(const std::vector<uint32_t>& parts);
  /// The splats as their levels and fill points know them: where they were estimated.
  const std::vector<uint32_t>& GetRestingSplats() const
  {
    return this->Motion.HasBegun() ? this->Motion.GetRest().Words : this->Splats;
  }

  std::vector<uint32_t> Splats;
  std::vector<uint32_t> ClipLines; // floats, as their bits
  std::vector<uint32_t> Colours;
  bool CellColours = false;
  bool OwnOpacity = false;
  bool MixedColours = false; // of the actor beside others
  std::vector<uint32_t> ValueTable;
  std::array<double, 2> ValueScale{ { 0.0, 0.0 } };
  std::vector<uint32_t> Factors;
  int FactorCount = 0;
  std::vector<uint32_t> Coordinates;
  std::vector<uint32_t> Tangents;
  std::vector<Block> Blocks;
  std::vector<uint32_t> Mixed; // where the blocks' splats are that were next to one another; empty: they are
  bool Mixes = false; // the levels that are made: they stand for splats of several blocks
  vtkIdType Count = 0;
  vtkIdType Points = 0;
  vtkPointSet* Whole = nullptr; // as the input has them
  const std::vector<vtkIdType>* WholeIds = nullptr;
  vtkIdType Skipped = 0;
  vtkIdType Unused = 0;
  bool Circular = true;
  bool Sized = true;
  bool MayProject = true; // as asked when splats were made
  bool MayFill = false;
  bool MayFillMeshes = true;
  bool Projected = false;
  bool Composite = false;
  double Spacing = 0.0;
  vtkTimeStamp SpacingTime;
  double MedianRadius = 0.0;
  double MaximumRadius = 0.0;
  std::array<double, 3> Low{ { 0.0, 0.0, 0.0 } };
  std::array<double, 3> High{ { 0.0, 0.0, 0.0 } };
  std::array<double, 3> Origin{ { 0.0, 0.0, 0.0 } };
  std::array<double, 6> Bounds{ { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
  std::vector<std::vector<size_t>> Pieces; // of the input's clouds, by the blocks' numbers
  Key PiecesMadeFrom;
  std::map<Key, std::vector<vtkPointSplatPacking>> Kept; // by the pieces of a cloud
  vtkPointSplatGroups Groups;
  vtkPointSplatBlocks SplatBlocks;
  vtkPointSplatMotion Motion;
  std::vector<uint32_t> PartsOfBlocks; // of the levels: the first one of each, and the end
  bool AllMoved = true;
  double RestingRadius = 0.0; // the median
  double LargestRestingRadius = 0.0;
  std::array<double, 6> RestingBounds{ { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } }; // about the origin
  double Stretch = 1.0;
  Key StaysFrom; // see StayingKey()
  vtkPointSplatLevels Levels; // of the resting splats, which must be there longer
  vtkPointSplatLevels::Deviations ColourDeviations;
  vtkPointSplatLevels::Deviations FactorDeviations;
  vtkMTimeType LevelsAskedFor = 0; // the splats' time
  vtkMTimeType LevelsTriedFor = 0;
  vtkPointSplatTriangles Triangles;
  Key TrianglesMadeFrom;
  vtkTimeStamp TriangleTime;
  vtkTimeStamp BlockTime;
  Key SplatsMadeFrom;
  Key CopiesToldBy;
  Key ColoursMadeFrom;
  std::string ColourKey;
  std::map<unsigned int, vtkPointSplatBlockLook> Looks;
  std::array<double, 4> ActorColour{ { 1.0, 1.0, 1.0, 1.0 } };
  Key FactorsMadeFrom;
  Key CoordinatesMadeFrom;
  vtkTimeStamp SplatTime;
  vtkTimeStamp OrderTime; // when splats became others, or were put in another order; not where they moved
  vtkTimeStamp ColourTime;
  vtkTimeStamp FactorTime;
  vtkTimeStamp CoordinateTime;
  ContextBuffers PerContext;
  ContextBuffers GroupedPerContext;
  ContextBuffers RunsPerContext;
};

#endif
