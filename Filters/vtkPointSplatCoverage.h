// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatCoverage
 * @brief   how much of a surface a group of splats covers, and how to make it cover more
 *
 * An internal helper of vtkPointSplatGrouping: the extended grouping of Zhang, Pajarola 2006,
 * Single-Pass Point Rendering, section 4.2.2.
 *
 * Areas are found by points spread evenly over each disk, 256 of them (64 where there are so many
 * splats that errors average out). Whether another disk covers a point is told in the plane of
 * the first one: the point goes along its normal to the other's plane, and is covered where it
 * arrives within the other's radius. Disks whose normals differ by more than 72 degrees, and such
 * as lie farther along the normal than both radii, belong to other sheets and cover nothing.
 *
 * Where m disks of a set cover a point, each counts 1/m of it. So the disks' shares add up to the
 * area that they cover together, which equation 7, taken literally, would count too small
 * wherever three disks meet.
 */
#ifndef vtkPointSplatCoverage_h
#define vtkPointSplatCoverage_h

#include "vtkPointSplatOverlap.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatCoverage
{
public:
  using Index = vtkPointSplatOverlap::Index;

  /**
   * The cloud: positions and unit normals (3 doubles each), radii, count of them; kept by
   * reference.
   */
  vtkPointSplatCoverage(
    const double* positions, const double* normals, const double* radii, Index count);

  /// The area that all splats cover together.
  double GetSurfaceArea() const { return this->SurfaceArea; }

  /// The area that these splats cover together, their radii scaled.
  double CoveredArea(const std::vector<Index>& group, double scale) const;

  /**
   * The scale of the group's radii at which it covers the surface's area within a quarter of a
   * percent, by equation 9; at most mostScale.
   */
  double Enlarge(const std::vector<Index>& group, double mostScale) const;

  /**
   * Splats of other groups that fill this one's gaps, by the priority queue of section 4.2.2,
   * method 1, of which this group's splats clip no more than the given share each. graph: all
   * overlaps.
   */
  std::vector<Index> Fill(const std::vector<Index>& group, const vtkPointSplatOverlap& graph,
    double mostClipped) const;

private:
  template <typename Visit>
  void EachCovered(Index i, Index j, double scale, const double axes[2][3], const Visit& visit) const;
  void Axes(Index i, double axes[2][3]) const;

  const double* Positions;
  const double* Normals;
  const double* Radii;
  Index Count;
  std::vector<double> Samples; // in the unit disk, two coordinates each
  double SurfaceArea = 0;
};

VTK_ABI_NAMESPACE_END
#endif
