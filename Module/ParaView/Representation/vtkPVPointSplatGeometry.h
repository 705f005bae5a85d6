// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVPointSplatGeometry
 * @brief   the points that the representation Point Splats draws, of any data set
 *
 * Input: any vtkDataSet, or a tree of them (multi-block, partitioned data sets and collections).
 *
 * Output: a vtkPolyData, or a vtkMultiBlockDataSet of the same structure, with
 * - the points and their data. Polygonal data are passed as they are. Of other data sets each point
 *   is a vertex with the data of the point's cell of least id, or NaN, or 0, without a cell;
 * - `vtkOriginalPointIds`, `vtkOriginalCellIds` (vtkIdType, of points and of vertices) and
 *   `vtkCompositeIndex`, `vtkProcessId` (unsigned int, of points): what hardware selection answers
 *   with, where points are not where they were;
 * - the field array `vtkBlockColors`, as vtkPVGeometryFilter makes it, where the input is a tree;
 * - `SplatRadius`, with SizeArray: the lengths of that array's tuples.
 *
 * With many processes the stages are
 * 1. Points that are copies of other processes' (DUPLICATEPOINT) are left out, polygons become
 *    vertices, and pieces of one partitioned data set one data set.
 * 2. Sizes, curvature and normals are estimated with the points of other processes
 *    (vtkPVPointSplatEstimation), where any process misses them. The arrays travel with the points
 *    from then on. With one process the mapper does that. Fill points, with FillGaps, are vertices with the
 *    ids of the points that they are nearest to, and data between those of up to three.
 * Leaves are the same on all processes: where any has points, the others have empty data.
 *
 * Bad input: data sets without points give empty blocks. A SizeArray that is missing has no effect.
 */
#ifndef vtkPVPointSplatGeometry_h
#define vtkPVPointSplatGeometry_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkPVPointSplattingModule.h" // For export macro

#include "vtkPointSplattingABI.h"

#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObjectTree;
class vtkDataSet;
class vtkMultiProcessController;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class VTKPVPOINTSPLATTING_EXPORT vtkPVPointSplatGeometry : public vtkDataObjectAlgorithm
{
public:
  static vtkPVPointSplatGeometry* New();
  vtkTypeMacro(vtkPVPointSplatGeometry, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The point array that says how large splats are, or an empty name, the default: sizes are
   * `SplatRadius` or are estimated.
   */
  void SetSizeArray(const std::string& name);
  const std::string& GetSizeArray() const { return this->SizeArray; }
  ///@}

  ///@{
  /**
   * After how many blocks `vtkBlockColors` begins anew. Default: 7.
   */
  vtkSetClampMacro(BlockColorsDistinctValues, int, 1, VTK_INT_MAX);
  vtkGetMacro(BlockColorsDistinctValues, int);
  ///@}

  ///@{
  /**
   * Whether there are fill points where sizes are estimated here (vtkPointSplatEstimation). Default: on.
   */
  vtkSetMacro(FillGaps, bool);
  vtkGetMacro(FillGaps, bool);
  vtkBooleanMacro(FillGaps, bool);
  ///@}

protected:
  vtkPVPointSplatGeometry() = default;
  ~vtkPVPointSplatGeometry() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPVPointSplatGeometry(const vtkPVPointSplatGeometry&) = delete;
  void operator=(const vtkPVPointSplatGeometry&) = delete;

  void MakePoints(vtkDataSet* input, unsigned int index, vtkPolyData* output);
  void MakeTree(vtkDataObjectTree* input, vtkDataObjectTree* output);
  void Estimate(vtkPolyData* points);

  std::string SizeArray;
  int BlockColorsDistinctValues = 7;
  bool FillGaps = true;
};

#endif
