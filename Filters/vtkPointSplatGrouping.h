// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatGrouping
 * @brief   divides splats into groups within which they do not overlap, or little
 *
 * Splats of a group that do not overlap can be drawn to one image with a plain depth test; blending
 * what overlaps becomes the compositing of the groups' images (Zhang, Pajarola 2006,
 * Single-Pass Point Rendering and Transparent Shading, section 3.2).
 *
 * Input: any vtkPointSet with points of any type and
 * - point normals (3 components), and `SplatRadius` (1 component, world units) or `SplatAxis1`
 *   and `SplatAxis2` (3 components each, world units), of which the longer one is the radius of
 *   the disk that bounds the ellipse. What is missing is estimated, as vtkPointSplatEstimation
 *   does;
 * - scalars of 3 or 4 components of unsigned char, if colours matter (CoplanarAngle).
 *
 * Output: a vtkPolyData with the same points in the same order, all of the input's point data and
 * field data, no cells, the normals and sizes used, and
 * - `SplatGroup` (1 int): 0 to GetNumberOfGroups() - 1, or -1 for a point that is no splat;
 * - with Coverage Duplicate: further points at the end, copies of others in another group;
 * - with Coverage Enlarge: sizes multiplied by GetGroupRadiusScale() of each group;
 * - `SplatClip`, if the input has it: copies have their points' lines, and enlarged splats end where
 *   they did;
 * - with either: the field array `SplatGroupCoverage` (1 double a group), the share of the
 *   surface that each group covers by itself with disks of its SplatRadius, whatever Reach is;
 *   without it, or below 0.95, groups are not taken for sorted transparency;
 * - with either: `vtkOriginalPointIds` (1 vtkIdType), the input's point that each point is,
 *   unless the input has this array already, which then goes on naming what it named.
 *
 * Stages:
 * 1. *Overlap.* Splats i and j share an edge where |p_i - p_j| < OverlapFactor Reach (r_i + r_j)
 *    (section 4.1, equation 5 and modification 3), unless their normals point in
 *    opposite directions (modification 2, if IgnoreOpposite) or they lie nearly in one plane
 *    and have nearly the same colour (modification 1, if CoplanarAngle is not 0).
 * 2. *Colouring.* LargestFirst: as many groups as it takes that no edge stays within one
 *    (section 4.1). Weighted: WantedNumberOfGroups of them, or the least number that leaves no more
 *    than MaximumOverlap, and as little overlap within groups as optimisation
 *    reaches (Zhang, Pajarola 2006, GPU-Accelerated Transparent Point-Based Rendering, section 2).
 * 3. *Coverage.* For transparency each group shall cover the whole surface (section 4.2.2).
 *    Duplicate adds to each group splats of others, by a priority queue on the area that the
 *    group clips of them, as long as that is no more than MaximumClipped of their disk (method
 *    1). Enlarge scales each group's radii such that it covers the surface's area (method 2,
 *    equation 8), which is found without the paper's iteration (vtkPointSplatCoverage.h says why).
 *    GetGroupCoverage() tells each group's share of the surface's area, before and after.
 *
 * The result does not depend on the number of threads. Time and memory are linear in points
 * and overlaps.
 *
 * Bad input: points that are ghosts or hidden, or whose coordinates, normal or size are not
 * finite and positive, get the group -1; their number is reported. Arrays without one tuple a point
 * are not used, and are not in the output. Where more than 128 splats
 * overlap each one on average (radii in another unit, heaps of duplicates) the filter
 * refuses with an error, and all groups are -1; of a few thousand points only the coverage is
 * refused, and the groups are given.
 *
 * @sa vtkPointSplatMapper vtkPointSplatEstimation
 */
#ifndef vtkPointSplatGrouping_h
#define vtkPointSplatGrouping_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"

#include <vector> // For the groups' figures

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatGrouping : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSplatGrouping* New();
  vtkTypeMacro(vtkPointSplatGrouping, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ColoringType
  {
    LargestFirst = 0,
    Weighted = 1
  };
  enum CoverageType
  {
    AsIs = 0,
    Duplicate = 1,
    Enlarge = 2
  };

  ///@{
  /**
   * How groups are found; LargestFirst by default.
   */
  vtkSetClampMacro(Coloring, int, LargestFirst, Weighted);
  vtkGetMacro(Coloring, int);
  void SetColoringToLargestFirst() { this->SetColoring(LargestFirst); }
  void SetColoringToWeighted() { this->SetColoring(Weighted); }
  ///@}

  ///@{
  /**
   * The factor c on the distance at which splats count as overlapping; 1, the default, leaves
   * no overlap, smaller ones give fewer groups. 0.01 to 1.
   */
  vtkPointSplatSetClampMacro(OverlapFactor, 0.01, 1.0);
  vtkGetMacro(OverlapFactor, double);
  ///@}

  ///@{
  /**
   * How many radii splats are drawn with; 1.5 by default, as vtkPointSplatMapper's
   * KernelSupport. 1 takes SplatRadius for the disk's edge.
   */
  vtkPointSplatSetClampMacro(Reach, 0.1, 10.0);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * On: splats whose normals make an angle of more than 90 degrees may share a group. Off by
   * default.
   */
  vtkSetMacro(IgnoreOpposite, bool);
  vtkGetMacro(IgnoreOpposite, bool);
  vtkBooleanMacro(IgnoreOpposite, bool);
  ///@}

  ///@{
  /**
   * Splats whose normals differ by no more than this angle (degrees), which lie no farther off
   * each other's plane, seen from the centre, and whose colours differ by no more than
   * ColorTolerance (of 255, in any component) may share a group. 0, the default: none may.
   */
  vtkPointSplatSetClampMacro(CoplanarAngle, 0.0, 90.0);
  vtkGetMacro(CoplanarAngle, double);
  vtkSetClampMacro(ColorTolerance, int, 0, 255);
  vtkGetMacro(ColorTolerance, int);
  ///@}

  ///@{
  /**
   * Of the weighted colouring: how many groups; 0, the default, the least number that leaves
   * no more than MaximumOverlap. At most 64.
   */
  vtkSetClampMacro(WantedNumberOfGroups, int, 0, 64);
  vtkGetMacro(WantedNumberOfGroups, int);
  ///@}

  ///@{
  /**
   * Of the weighted colouring: the area by which pairs within groups may overlap, as a share of
   * all splats' area;
   * 0.05 by default.
   */
  vtkPointSplatSetClampMacro(MaximumOverlap, 0.0, 1.0);
  vtkGetMacro(MaximumOverlap, double);
  ///@}

  ///@{
  /**
   * What is done that each group covers the surface; AsIs (nothing) by default.
   */
  vtkSetClampMacro(Coverage, int, AsIs, Enlarge);
  vtkGetMacro(Coverage, int);
  void SetCoverageToAsIs() { this->SetCoverage(AsIs); }
  void SetCoverageToDuplicate() { this->SetCoverage(Duplicate); }
  void SetCoverageToEnlarge() { this->SetCoverage(Enlarge); }
  ///@}

  ///@{
  /**
   * The share of a splat's disk that a group may clip for the splat to be added to it; 0.3 by
   * default.
   */
  vtkPointSplatSetClampMacro(MaximumClipped, 0.0, 1.0);
  vtkGetMacro(MaximumClipped, double);
  ///@}

  ///@{
  /**
   * What the last execution found: how many groups, the overlap graph's largest and mean degree
   * (the paper's Table 1), points that are no splats, copies added, and the area of overlaps
   * left within groups as a share of all splats' area (pairs along edges only).
   */
  vtkGetMacro(NumberOfGroups, int);
  vtkGetMacro(MaximumDegree, vtkIdType);
  vtkGetMacro(MeanDegree, double);
  vtkGetMacro(NumberOfSkippedPoints, vtkIdType);
  vtkGetMacro(NumberOfDuplicates, vtkIdType);
  vtkGetMacro(OverlapWithinGroups, double);
  ///@}

  ///@{
  /**
   * Of a group, if Coverage is not AsIs: the share of the surface's area that it covers, before
   * and after, by disks of the radius times Reach, and the factor on its radii. 0, 0 and 1
   * otherwise.
   */
  double GetGroupCoverageBefore(int group);
  double GetGroupCoverage(int group);
  double GetGroupRadiusScale(int group);
  ///@}

protected:
  vtkPointSplatGrouping();
  ~vtkPointSplatGrouping() override;

  int FillInputPortInformation(int, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPointSplatGrouping(const vtkPointSplatGrouping&) = delete;
  void operator=(const vtkPointSplatGrouping&) = delete;

  struct GroupFigures
  {
    double Before = 0;
    double After = 0;
    double Scale = 1;
  };
  struct Splats;

  bool Color(const Splats& splats, std::vector<int>& colors);
  void Cover(const Splats& splats, const std::vector<int>& colors, vtkPointSet* input,
    vtkPolyData* output);

  int Coloring = LargestFirst;
  double OverlapFactor = 1;
  double Reach = 1.5;
  bool IgnoreOpposite = false;
  double CoplanarAngle = 0;
  int ColorTolerance = 4;
  int WantedNumberOfGroups = 0;
  double MaximumOverlap = 0.05;
  int Coverage = AsIs;
  double MaximumClipped = 0.3;

  int NumberOfGroups = 0;
  vtkIdType MaximumDegree = 0;
  double MeanDegree = 0;
  vtkIdType NumberOfSkippedPoints = 0;
  vtkIdType NumberOfDuplicates = 0;
  double OverlapWithinGroups = 0;
  std::vector<GroupFigures> Figures;
};

VTK_ABI_NAMESPACE_END
#endif
