// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfacePoints
 * @brief   oriented points on isosurfaces of a volume or of scattered samples, without triangles
 *
 * Input: a vtkImageData with at least two samples along each axis, or scattered samples, which
 * are the points of any vtkPointSet (its cells do not matter); and a point array of any
 * scalar type, set by SetInputArrayToProcess (the active scalars by default); of an array with
 * more components ArrayComponent is taken.
 *
 * Output: a vtkPolyData without cells, or a vtkMultiBlockDataSet with one for each isovalue
 * (BlockPerIsovalue), with
 * - points, isovalue after isovalue in the order given, those of each before its fill points:
 *   float, or double where floats would not resolve a thousandth of a voxel because the volume lies far from the origin (of
 *   scattered samples, a thousandth of what would be their spacing if their bounds were full);
 * - active normals (3 floats, unit length) against the gradient, as vtkFlyingEdges3D has them;
 * - `Isovalue` (1 double), in the unit of the scalars;
 * - `SplatRadius` (1 float, world units) and `SplatCurvature` (6 floats, XX, YY, ZZ, XY, YZ, XZ,
 *   1 / world units), as vtkPointSplatEstimation has them, unless SplatSizes is off, or Correction
 *   for scattered samples. With these nothing is estimated when the points are drawn;
 * - `SplatClip` (6 floats, 1 / world units, as vtkPointSplatEstimation has it), with sizes, where a volume's faces cut
 *   off parts of splats: the isosurface ends there.
 *
 * Stages of volumes without PointSpacing:
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
 * Stages of volumes with PointSpacing s (world units):
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
 * Sizes of volumes' points, with the last stage.
 * 1. *Radius.* Without PointSpacing: in each cell the isosurface crosses the faces in closed
 *    outlines of three points or more (vtkIsosurfaceOutline.h). A point's radius is 0.87 of its
 *    distance to the farthest centroid, weighted by length, of its outlines in the four cells around
 *    its edge. So what is drawn of the disks of an outline's points, 1.15 radii, covers the fan of
 *    triangles around its centroid, whatever the voxels' shape, and no disk reaches farther than a
 *    cell. With PointSpacing: 1.1 times the distance that points keep, at most half of the volume's
 *    diagonal.
 * 2. *Curvature.* B = s P H P / |g| by gradient g and Hessian H, P = I - n n^T, and the normal's
 *    side s (vtkIsosurfaceSplat.h). H is made of differences of second order at the samples,
 *    along an axis the mean of those one and two samples wide, interpolated as the gradient is.
 *    Where B is strong radii are smaller, by a quarter at most; its eigenvalues are held within 1 / radius.
 * 3. *Fill points*, without PointSpacing (FillGaps). Where the normals of an outline's points turn by
 *    14 degrees or more, at edges and in thin parts, disks as large as the voxel stand out over one
 *    another. A fill point at the outline's centroid, with the mean of the normals and bent as they
 *    turn (vtkIsosurfaceFill.h), has 0.8 of the distance to the farthest point as its radius, and
 *    the points reach 0.65 of the way to it. That is worth 2 dB for a twentieth to four fifths more points.
 * 4. *Borders.* Splats that reach past a face of the whole volume are clipped at it (vtkIsosurfaceBorders.h); pieces
 *    of a volume go on in others.
 *
 * Stages of scattered samples (after Rosenthal, Linsen 2006, Direct isosurface extraction from
 * scattered volume data: points by linear interpolation between pairs of neighbours):
 * 1. *Links.* Around each sample its nearest neighbours (NumberOfNeighbors, or those within
 *    NeighborRadius) are looked up; where an isovalue lies among their values, the sample is
 *    linked to those that no third sample hides (the Gabriel graph; a grid's edges).
 * 2. *Fits.* To the same samples' neighbours a polynomial of second degree is fitted by least
 *    squares with weights falling with distance; the field is the fits' mean with smooth weights
 *    of compact support. (Moving least squares, but solved once a sample and not once a point.)
 * 3. *Pairs.* On each link that the isovalue separates the point by linear interpolation,
 *    and the gradient of the fits at the link's ends interpolated alike. With Correction, Newton
 *    steps move the point onto the field's isosurface and the gradient is the field's, unless
 *    they leave half the link's length or the field's samples on either side.
 * 4. *Thinning.* As of volumes, in a random but always equal order, at 0.8 s; without PointSpacing
 *    s is the edge of a sample's share of space (density to the power of -1/3) and varies
 *    with it. s is at least a sixteenth of it.
 * 5. *Growing*, with Correction. Around each point, at s, ten places in the tangent plane
 *    are moved onto the field's isosurface by Newton steps, and are kept if no other point is
 *    nearer than 0.8 s, until there is none left: this closes the gaps between links, and makes
 *    points denser than the samples if s is less than their spacing. Places not surrounded by
 *    samples on all sides, or without samples on either side of the isovalue, are left out.
 * 6. *Sizes*, with Correction. The radius is 1.1 times the distance that a point keeps to others,
 *    and a quarter more where stage 5 left a place beside it empty; the curvature is as of volumes,
 *    by the field's gradient and the mean Hessian of the fits around.
 * Without Correction there are only the points of stage 3 as thinned by stage 4, without sizes.
 *
 * Bad input of volumes: no edge (with PointSpacing: no cell) that touches a sample that is hidden
 * (vtkGhostType has HIDDENPOINT) or not finite gives points, nor one whose cells are all hidden
 * or another process' (HIDDENCELL, DUPLICATECELL); such cells have no fill points. Such samples are
 * left out of gradients and of Hessians; a point with no usable cell around gets the radius of half a
 * voxel's shortest side, and where derivatives are zero or not finite splats are flat.
 *
 * Bad input of scattered samples: those that are hidden, have coordinates or a value that is not
 * finite, or lie where an earlier one lies, take no part and are counted in one warning. Of points
 * only those are given whose nearest sample is this process' own (not DUPLICATEPOINT). Samples in a
 * plane or on a line give points on their pairs only. Where samples are much denser along one
 * direction than along another, as in a boundary layer, gaps are as wide as the wider spacing.
 *
 * Isovalues that are not finite are left out and reported. A missing array, or an image that is
 * no volume (of less than two samples along an axis, or whose origin, spacing or direction is not
 * finite or leaves voxels without volume), is an error, and the output empty; less than two samples
 * are a warning.
 *
 * The filter reports progress and can be aborted, with an empty output then.
 */
#ifndef vtkIsosurfacePoints_h
#define vtkIsosurfacePoints_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For arguments of private functions

#include <functional> // For arguments of private functions
#include <memory>     // For arguments of private functions
#include <vector>     // For arguments of private functions

VTK_ABI_NAMESPACE_BEGIN

class vtkContourValues;
class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkIsosurfaceExtraction;
class vtkPointSet;
struct vtkIsosurfaceOutput;

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
   * point for each grid edge that is crossed, or points about as dense as the scattered samples.
   */
  vtkPointSplatSetClampMacro(PointSpacing, 0.0, VTK_DOUBLE_MAX);
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

  ///@{
  /**
   * How many of the nearest scattered samples are a sample's neighbours, 6 to 128; 26 by default.
   * Four times as many are looked up (up to 128) where these leave directions open. More neighbours
   * smooth noise away, and small features as well.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 6, 128);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * If not 0 (default), a scattered sample's neighbours are those within this radius (world units)
   * instead, of more than 128 the nearest: isosurfaces then do not bridge wider gaps between
   * samples. For particles, the radius of their smoothing kernel.
   */
  vtkPointSplatSetClampMacro(NeighborRadius, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NeighborRadius, double);
  ///@}

  ///@{
  /**
   * Whether points between scattered samples are moved onto the field fitted to them, and gaps
   * filled on it; on by default. Off, points lie where values along pairs of samples
   * are the isovalue by linear interpolation.
   */
  vtkSetMacro(Correction, bool);
  vtkGetMacro(Correction, bool);
  vtkBooleanMacro(Correction, bool);
  ///@}

  ///@{
  /**
   * Whether the points get `SplatRadius` and `SplatCurvature`; on by default. Switch it off where a
   * filter that comes after this one takes points away or moves them: what draws them then
   * estimates sizes that fit what is left.
   */
  vtkSetMacro(SplatSizes, bool);
  vtkGetMacro(SplatSizes, bool);
  vtkBooleanMacro(SplatSizes, bool);
  ///@}

  ///@{
  /**
   * Whether there is a fill point in each voxel in which the isosurface of a volume bends by much; on
   * by default. Off, or without SplatSizes, all points are those of vtkFlyingEdges3D; with PointSpacing,
   * and of scattered samples, there are no fill points.
   */
  vtkSetMacro(FillGaps, bool);
  vtkGetMacro(FillGaps, bool);
  vtkBooleanMacro(FillGaps, bool);
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

  /// Makes what finds the points for isovalues that are sorted ascending.
  using Factory =
    std::function<std::unique_ptr<vtkIsosurfaceExtraction>(const std::vector<double>&)>;

  vtkSmartPointer<vtkDataArray> GetScalars(vtkInformationVector** inputs, vtkDataSet* input);
  void ExtractVolume(vtkInformationVector** inputs, vtkImageData* image, vtkDataObject* output);
  void ExtractScatter(vtkInformationVector** inputs, vtkPointSet* samples, vtkDataObject* output);
  /// As many isovalues at once as `most`.
  std::vector<vtkIsosurfaceOutput> Extract(
    const Factory& make, std::size_t most, bool precise, vtkDataSet* input);
  void MoveTo(const std::vector<vtkIsosurfaceOutput>& surfaces, vtkDataObject* output);

  vtkContourValues* ContourValues;
  double PointSpacing = 0;
  bool BlockPerIsovalue = false;
  int ArrayComponent = 0;
  int NumberOfNeighbors = 26;
  double NeighborRadius = 0;
  bool Correction = true;
  bool SplatSizes = true;
  bool FillGaps = true;
};

VTK_ABI_NAMESPACE_END
#endif
