// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatOctree
 * @brief   a multiresolution point octree: levels of fewer, larger splats that stand for points
 *
 * Pajarola, Sainz, Guidotti 2004, Confetti: Object-Space Point Blending and Splatting, sections 3
 * and 4: each level has about a quarter of the splats of the level below, and a tree of blocks,
 * some hundred splats each, says which stand for which. This filter is for who wants such a
 * hierarchy: to draw a cloud's coarse version, to choose blocks by a view, to write levels to files.
 *
 * vtkPointSplatMapper makes one by itself (its LevelOfDetail): in a thread, of a cloud of one block
 * and half a million points or more, that is drawn twice unchanged in a view for which it is dense
 * enough; until it is there all points are drawn. The cloud's memory grows by a third. At full
 * quality splats that stand for others have radii of at most 0.6 pixels, which a pixel's own filter
 * averages, or of 2.5 where normals and colours show that the surface is smooth, 1.25 along outlines;
 * with a greater TargetError they are larger, and with 0 there are none. All points are drawn where
 * points are selected, shadows are on, textures or edges are shown, by quads, and by methods other
 * than two passes with peeling. Of points that change from frame to frame none is made.
 *
 * Input: any vtkPointSet with points of any type and
 * - point normals (3 components), and `SplatRadius` (1 component, world units) or `SplatAxis1`
 *   and `SplatAxis2` (3 components each, world units). What is missing is estimated, as
 *   vtkPointSplatEstimation does without fill points: run that filter with FillGaps on first for these;
 * - `SplatCurvature` (6 components), if it is known;
 * - `SplatPlaneNormal` (3 components) and `SplatFold` (6 components), if they are known: a point with
 *   folds is of the face in whose plane it lies;
 * - any other point data.
 *
 * Output 0, the points: a vtkPolyData with the input's points in the hierarchy's order, with all
 * of their point data untouched (clip lines and groups among it), the normals and sizes used,
 * `vtkOriginalPointIds` (1 vtkIdType) unless the input has it already, and the input's field data.
 * Output 1, the levels: a vtkPolyData with the splats of level 1, then those of level 2, and so on.
 * - points of the input's type, point normals (3 floats), and `SplatRadius` (1 float), or
 *   `SplatAxis1` and `SplatAxis2` (3 floats each) if the input has these;
 * - `SplatCurvature` (6 floats): such that a splat bends as the points' normals do;
 * - `SplatLevel` (1 unsigned char), `SplatFirstChild` (1 vtkIdType) and `SplatChildCount` (1 int):
 *   those that it stands for, counted from the level's first one;
 * - `SplatNormalDeviation` (1 float): rms, of the points' normals from their linear change;
 * - where points have clip lines, `SplatClip` (6 components) as the splats below tell
 *   (vtkPointSplatLevelLines.h), and `SplatPlaneNormal`, the splat's normal, and `SplatFold`, which is
 *   0, if points have these;
 * - numeric point data of floats and unsigned chars: means by area. Names of points (ids, groups,
 *   integers) have no mean and are left out.
 * Field data of output 1, one tuple a block, those of the coarsest level first:
 * - `SplatBlockRange` (3 vtkIdType): level, first splat in it, number of splats;
 * - `SplatBlockChildren` (2 vtkIdType): the first of the blocks below, their number;
 * - `SplatBlockBounds` (6 floats): the box about the centres, relative to `SplatBlockOrigin` (1
 *   tuple of 3 doubles); a sphere about it has half its diagonal;
 * - `SplatBlockCone` (4 floats): axis and half angle, radians, of a cone about all normals;
 * - `SplatBlockSize` (3 floats): the largest and the mean radius, the deviation of normals as above.
 * A block and those below it hold the same points: who goes from the first blocks down, taking a
 * block or those below it, has each point once.
 *
 * Stages: those of vtkPointSplatHierarchy.h (division, levels, splats, blocks), then the point data.
 * The result does not depend on the number of threads. Progress is reported, and the filter can be
 * aborted; then its outputs are empty.
 *
 * Bad input: points that are ghosts or hidden, or whose coordinates, normal or size are not finite
 * and positive are in no output; their number is reported. Of points on no surface there are no
 * levels, and output 1 is empty.
 *
 * @sa vtkPointSplatMapper vtkPointSplatEstimation
 */
#ifndef vtkPointSplatOctree_h
#define vtkPointSplatOctree_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatOctree : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSplatOctree* New();
  vtkTypeMacro(vtkPointSplatOctree, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// With that of the points; 1 if there is no other.
  vtkGetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfBlocks, vtkIdType);
  vtkGetMacro(NumberOfSkippedPoints, vtkIdType);

protected:
  vtkPointSplatOctree();
  ~vtkPointSplatOctree() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPointSplatOctree(const vtkPointSplatOctree&) = delete;
  void operator=(const vtkPointSplatOctree&) = delete;

  int NumberOfLevels = 0;
  vtkIdType NumberOfBlocks = 0;
  vtkIdType NumberOfSkippedPoints = 0;
};

VTK_ABI_NAMESPACE_END
#endif
