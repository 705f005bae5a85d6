// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfacePoints
 * @brief   oriented points on isosurfaces of a volume, without triangles
 *
 * Input: a vtkImageData with at least two samples along each axis, and a point array of any
 * scalar type, set by SetInputArrayToProcess (the active scalars by default); of an array with
 * more components ArrayComponent is taken.
 *
 * Output: a vtkPolyData without cells, or a vtkMultiBlockDataSet with one for each isovalue
 * (BlockPerIsovalue), with
 * - points, isovalue after isovalue in the order given: float, or double where floats would
 *   not resolve a thousandth of a voxel because the volume lies far from the origin;
 * - active normals (3 floats, unit length) against the gradient, as vtkFlyingEdges3D has them;
 * - `Isovalue` (1 double), in the unit of the scalars.
 *
 * Stages without PointSpacing:
 * 1. *Sweep.* Each sample's class is the number of isovalues that it reaches, one byte. Slices
 *    in parallel, rows are compared eight samples at a time with themselves one further on, with
 *    the next row and the next slice: all isovalues are found in one sweep. (The trimming of
 *    rows in Schroeder, Maynard, Geveci 2015, Flying Edges, section 3, has the same end.)
 * 2. *Count.* Each slice's points get their place in the output, so that the order does not
 *    depend on the number of threads.
 * 3. *Write.* On each crossed edge of the grid the point by linear interpolation, and the
 *    normal from central differences at the edge's ends, interpolated alike. These are the
 *    points and normals of vtkFlyingEdges3D.
 *
 * Stages with PointSpacing s (world units):
 * 1. *Candidates.* Each crossed cell is divided until sub-cells are no larger than s / 2.5, and
 *    the crossings of the sub-cells' edges with the trilinear interpolant are collected. A voxel
 *    is divided by at most 64 along an axis.
 * 2. *Thinning.* A candidate stays if no earlier one of the same side of the same surface
 *    is nearer than 0.8 s, which gives about one point per s * s of surface, no gap wider than
 *    0.8 s, and no clumps; it thins where the grid is finer than s. Slabs of the volume
 *    are thinned in two turns, every second one in parallel.
 * 3. *Placing.* Newton steps along the gradient move what is left onto the isosurface of the
 *    tricubic (Catmull-Rom) interpolant, whose derivatives at the samples are the central
 *    differences; the normal is its gradient. It is trilinear in a cell that has an
 *    unusable sample around, and where the steps do not settle within half a voxel.
 *
 * Bad input: no edge (with PointSpacing: no cell) that touches a sample that is hidden
 * (vtkGhostType has HIDDENPOINT) or not finite gives points, nor one whose cells are all hidden
 * or another process' (HIDDENCELL, DUPLICATECELL). Such samples are left out of gradients.
 * Isovalues that are not finite are left out and reported. A missing array, or an image that is
 * no volume, is an error, and the output empty.
 *
 * The filter reports progress and can be aborted, with an empty output then.
 */
#ifndef vtkIsosurfacePoints_h
#define vtkIsosurfacePoints_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkContourValues;
class vtkDataArray;
class vtkImageData;
struct vtkIsosurfaceGrid;

class VTKFILTERSPOINTSPLATTING_EXPORT vtkIsosurfacePoints : public vtkPolyDataAlgorithm
{
public:
  static vtkIsosurfacePoints* New();
  vtkTypeMacro(vtkIsosurfacePoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The isovalues, as of vtkContourFilter; none by default.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  double* GetValues() VTK_SIZEHINT(GetNumberOfContours());
  void GetValues(double* values);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int number, double range[2]);
  void GenerateValues(int number, double rangeStart, double rangeEnd);
  ///@}

  ///@{
  /**
   * The wanted distance between neighbouring points in world units; 0, the default, gives one
   * point for each grid edge that is crossed.
   */
  vtkSetClampMacro(PointSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PointSpacing, double);
  ///@}

  ///@{
  /**
   * Off (default): the output is one vtkPolyData. On: it is a vtkMultiBlockDataSet with a
   * block for each isovalue, named "Isovalue" and the value.
   */
  vtkSetMacro(BlockPerIsovalue, bool);
  vtkGetMacro(BlockPerIsovalue, bool);
  vtkBooleanMacro(BlockPerIsovalue, bool);
  ///@}

  ///@{
  /**
   * The component of the array that is contoured; 0 by default.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

protected:
  vtkIsosurfacePoints();
  ~vtkIsosurfacePoints() override;

  int FillInputPortInformation(int, vtkInformation* info) override;
  int FillOutputPortInformation(int, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*);
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIsosurfacePoints(const vtkIsosurfacePoints&) = delete;
  void operator=(const vtkIsosurfacePoints&) = delete;

  vtkDataArray* GetScalars(vtkInformationVector** inputs, vtkImageData* image);
  void Extract(const vtkIsosurfaceGrid& grid, vtkDataArray* scalars, bool precise,
    vtkDataObject* output);

  vtkContourValues* ContourValues;
  double PointSpacing = 0;
  bool BlockPerIsovalue = false;
  int ArrayComponent = 0;
};

VTK_ABI_NAMESPACE_END
#endif
