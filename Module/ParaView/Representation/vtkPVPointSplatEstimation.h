// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVPointSplatEstimation
 * @brief   vtkPointSplatEstimation of clouds that many processes share
 *
 * Input and output are those of vtkPointSplatEstimation, or trees of them (multi-block, partitioned
 * data sets and collections) with the input's structure. With one process this is that filter.
 * With many, which all have to update it, each leaf is estimated by all of them together:
 * 1. *Halo.* The points near another process' bounding box go there (vtkPVPointSplatBorders), with
 *    their normals and the places of the sensors that saw them; copies of other processes' points
 *    (DUPLICATEPOINT) and hidden points do not.
 * 2. *Estimation* of a process' own points and those that came.
 * 3. Those that came are dropped, and fill points that are nearest to them, which their process has: the output
 *    has the points of the input, in their order, and behind them the other fill points. Their arrays are of those of
 *    their ends that are this process'. Which places between the same points they have depends on what else is near, so
 *    that those of two processes do not fit everywhere: of a disc's area 0.01 % beside their border is not covered.
 * 4. *Orientation*, where normals are to be consistent and no process has any, or sensors: pieces
 *    of surface that go on on other processes are turned the way that one process would turn the
 *    whole (vtkPVPointSplatOrientation).
 * So sizes, normals, curvature and clip lines are those that one process finds, but for what
 * depends on a statistic of the whole cloud, as its median spacing, which is that of the points at
 * hand; and of pieces that stage 4 turns some points at the ends of surfaces have other sizes (of
 * 14400 points of a sheet 11). `SplatClip` and `SplatFold` are on all processes if they are on any.
 *
 * Meshes (a vtkPolyData with polygons or strips, on any process) have their sizes from their
 * triangles, and are estimated by each process alone. ParaView's filter Ghost Cells before this one
 * gives them the triangles of other processes.
 *
 * Bad input: as vtkPointSplatEstimation has it. What GetNoise(), GetContradiction(), GetNumberOfMendedNormals() and
 * GetNumberOfPointsAlone() tell is of the last leaf, with the points that came.
 */
#ifndef vtkPVPointSplatEstimation_h
#define vtkPVPointSplatEstimation_h

#include "vtkPVPointSplattingModule.h" // For export macro
#include "vtkPointSplatEstimation.h"

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObjectTree;
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class VTKPVPOINTSPLATTING_EXPORT vtkPVPointSplatEstimation : public vtkPointSplatEstimation
{
public:
  static vtkPVPointSplatEstimation* New();
  vtkTypeMacro(vtkPVPointSplatEstimation, vtkPointSplatEstimation);

protected:
  vtkPVPointSplatEstimation() = default;
  ~vtkPVPointSplatEstimation() override = default;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPVPointSplatEstimation(const vtkPVPointSplatEstimation&) = delete;
  void operator=(const vtkPVPointSplatEstimation&) = delete;

  /// What vtkPointSplatEstimation makes of some points.
  void EstimateAlone(vtkPointSet* input, vtkPolyData* output);
  /// The same with other processes' points, of which all must call.
  void EstimateTogether(vtkPointSet* input, vtkPolyData* output);
};

#endif
