// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatProjection
 * @brief   moves noisy points onto one smooth surface with sharp features, and finds outliers
 *
 * The surface is the robust implicit moving-least-squares surface (RIMLS) of A. C. Oeztireli,
 * G. Guennebaud, M. Gross 2009, Feature Preserving Point Set Surfaces based on Non-Linear Kernel
 * Regression, Computer Graphics Forum 28(2). Scans that lie within their noise of one another
 * become one surface, and a cube keeps its edges.
 *
 * Input: any vtkPointSet with points of any type; only points and point data are used. With point
 * normals that point to the same side within each sheet, or without; the arrays of sensors'
 * positions that vtkPointSplatEstimation's header describes are used for those that are missing.
 *
 * Output: a vtkPolyData without cells, with all of the input's point data and field data but the
 * sizes of an earlier estimation (`SplatRadius`, `SplatAxis1`, `SplatAxis2`, `SplatPlaneNormal`),
 * which are those of the old places, and
 * - the points, moved, of the input's type (double where that holds whole numbers). What is
 *   added to a coordinate is found from differences, so that coordinates in double are as exact
 *   far from the origin as near it;
 * - the active normals (3 floats, unit length): the surface's;
 * - `SplatCurvature` (6 floats, XX, YY, ZZ, XY, YZ, XZ, 1 / world units), the surface's second
 *   fundamental form, as vtkPointSplatEstimation's header describes it;
 * - `ProjectionDistance` (1 float, world units) if ComputeDistance: how far a point moved;
 * - `Outlier` (1 unsigned char, 0 or 1) if Outliers is Mark.
 *
 * Stages:
 * 1. *Neighbours*, NumberOfNeighbors (k) for each point: those of the initial points serve all
 *    iterations. The kernel's support h is 1.1 times the distance to the k-th: so it is chosen
 *    by the local spacing s, 3 s for 24 neighbours of an even sampling; the paper advises 1.4 s
 *    to 4 s.
 * 2. *Normals*, where the input has none: as in vtkPointSplatEstimation, stages 2 and 3, by k
 *    neighbours; where these are off a surface of second order by noise, the normals of planes.
 * 3. *Normals that are wrong*, as those of scans at grazing angles are, or averages over a
 *    crease. Where less than a quarter of the neighbours have a normal within 60 degrees of the
 *    point's, it takes that of a neighbour which most of them agree with; so, too, where less
 *    than 60 % do, and more with another, of a sheet that the point lies in the middle of (the
 *    sides of a thin sheet stay apart, and a crease's other face lies to one side). Near
 *    creases, where the neighbours' normals cancel one another, it takes the normal of the
 *    neighbour whose plane has the most of them in it: the face's, even where the normals given
 *    are averages over the crease.
 * 4. *Projection.* With residuals r_i = (x - p_i) . (n_i + g) / 2 of the neighbours p_i, their
 *    normals n_i and the gradient g of the step before,
 *      f(x) = sum w_i r_i / sum w_i,   w_i = phi(|x - p_i|) a(r_i / sigma_r) a(|n_i - g| / sigma_n)
 *    (the paper's RIMLS, by iteratively reweighted least squares), whose gradient, a held fixed, is
 *      g = (sum n_i w_i + sum r_i dw_i - f sum dw_i) / sum w_i,
 *    with phi(d) = (1 - (d / h)^2)^4 and the robust weight a(x) = exp(-x^2), for which
 *    (1 - x^2 / 4)^4 serves. Steps x - f g (the paper's projection by steepest descent) and
 *    the weights' iteration go on together until |f| < 1e-3 h. The paper's residuals are
 *    (x - p_i) . n_i, by which a sphere grows by about s^2 / 2 R; half of n_i replaced by g, they
 *    are 0 for any two points of a sphere, as in S. Rusinkiewicz 2019, A Symmetric Objective
 *    Function for ICP.
 * 5. *Noise.* Where the neighbours' residuals deviate by more than 0.15 s, the scene is one of
 *    noise or of scans that contradict one another, and stage 4 is done again with all points
 *    within two to three times the support, the more the noisier. Elsewhere detail of three
 *    spacings is kept.
 * 6. *Curvature* by least squares from the projected neighbours (vtkPointSplatCurvature.h), without
 *    those within a quarter of h, whose differences are noise.
 * 7. *Outliers*: points without support, whose mean distance to their eight nearest is more than
 *    OutlierFactor times the upper quartile of that of their neighbours', which takes strays and
 *    clumps of up to five, or 2.5 OutlierFactor times the median of all, which takes strays among
 *    strays; and ones that lie off the surface by more than OutlierFactor standard
 *    deviations of their neighbours' moves, and by a spacing. Both are measured locally: by
 *    the global deviation of vtkStatisticalOutlierRemoval the sparse parts of uneven samplings are
 *    outliers, and vtkRadiusOutlierRemoval takes one radius for all.
 * Points that have fewer than three neighbours, or that no surface is within h of, do not move.
 *
 * Bad input: points with a coordinate that is not finite (or beyond 1e37), and hidden ones
 * (vtkGhostType has HIDDENPOINT), take no part; they stay in the output as they are, with normals
 * as given and no curvature, and their number is reported once. Normals that are zero or not
 * finite are estimated. Points at the same position move together. Duplicate ghost points move,
 * too: with the same neighbours, as they do in the process that owns them. An empty input gives an
 * empty output.
 *
 * Results do not depend on the number of threads. The filter reports progress and can be
 * aborted, with an empty output then.
 *
 * @sa vtkPointSplatEstimation vtkPointSplatMapper
 */
#ifndef vtkPointSplatProjection_h
#define vtkPointSplatProjection_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatProjection : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSplatProjection* New();
  vtkTypeMacro(vtkPointSplatProjection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutliersType
  {
    Keep = 0,
    Mark = 1,
    Remove = 2
  };

  ///@{
  /**
   * How many neighbours of a point are in the kernel's support; 8 to 32, 24 by default. Four
   * times as many are where there is noise. More smooth more.
   */
  vtkSetClampMacro(NumberOfNeighbors, int, 8, 32);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /**
   * sigma_n: how far unit normals may differ (by the length of their difference) to count as of the
   * same face; 0.1 to 10, 0.5 by default: creases of 60 degrees and more are sharp. The paper
   * takes 0.5 (sharp) to 1.5 (smooth).
   */
  vtkPointSplatSetClampMacro(NormalBandwidth, 0.1, 10.0);
  vtkGetMacro(NormalBandwidth, double);
  ///@}

  ///@{
  /**
   * sigma_r, in supports h: how far off the surface a neighbour may lie to count; 0.05 to 10, 0.5
   * by default, as in the paper.
   */
  vtkPointSplatSetClampMacro(ResidualBandwidth, 0.05, 10.0);
  vtkGetMacro(ResidualBandwidth, double);
  ///@}

  ///@{
  /**
   * Whether outliers are left out (Remove, the default), told by the array `Outlier` (Mark), or not
   * looked for (Keep). Points that take no part are no outliers.
   */
  vtkSetClampMacro(Outliers, int, Keep, Remove);
  vtkGetMacro(Outliers, int);
  void SetOutliersToKeep() { this->SetOutliers(Keep); }
  void SetOutliersToMark() { this->SetOutliers(Mark); }
  void SetOutliersToRemove() { this->SetOutliers(Remove); }
  ///@}

  ///@{
  /**
   * What makes an outlier: see stage 7. 1 to 1000, 4 by default.
   */
  vtkPointSplatSetClampMacro(OutlierFactor, 1.0, 1000.0);
  vtkGetMacro(OutlierFactor, double);
  ///@}

  ///@{
  /**
   * Whether the output says how far each point moved, by `ProjectionDistance`; off by default.
   */
  vtkSetMacro(ComputeDistance, vtkTypeBool);
  vtkGetMacro(ComputeDistance, vtkTypeBool);
  vtkBooleanMacro(ComputeDistance, vtkTypeBool);
  ///@}

  /**
   * How many outliers the last update found.
   */
  vtkGetMacro(NumberOfOutliers, vtkIdType);

protected:
  vtkPointSplatProjection();
  ~vtkPointSplatProjection() override;

  int FillInputPortInformation(int, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPointSplatProjection(const vtkPointSplatProjection&) = delete;
  void operator=(const vtkPointSplatProjection&) = delete;

  struct Run;

  int NumberOfNeighbors = 24;
  double NormalBandwidth = 0.5;
  double ResidualBandwidth = 0.5;
  int Outliers = Remove;
  double OutlierFactor = 4;
  vtkTypeBool ComputeDistance = false;
  vtkIdType NumberOfOutliers = 0;
};

VTK_ABI_NAMESPACE_END
#endif
