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
 * The surface is what all disks cover, told by the points on all of them, or on 4096 of them where
 * there are more: where m disks cover a point, it counts 1/m of its disk's share of the area, so that
 * no area counts twice. (Equation 7, taken literally, would count too little wherever three disks
 * meet.) Of each point it is found by how much a group's disks must grow until one of them covers it.
 * So what a group covers at any scale is the share of points that need no more, and the scale at
 * which equation 8 holds is a quantile. The paper has an iteration, equation 9: it takes the
 * disks' clipped areas anew in each step, which took four times as long for four groups of 137 thousand
 * splats, and it counts as covered what large disks cover outside the surface's border.
 */
#ifndef vtkPointSplatCoverage_h
#define vtkPointSplatCoverage_h

#include "vtkPointSplatOverlap.h"

#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatCoverage
{
public:
  using Index = vtkPointSplatOverlap::Index;

  /**
   * How much of the surface a group covers, its radii scaled.
   */
  class Cover
  {
  public:
    /// The share of the surface's area at a scale.
    double GetShare(double scale) const;
    /// The scale at which all but a quarter of a percent is covered; from 1 to mostScale.
    double GetFullScale(double mostScale) const;

  private:
    friend class vtkPointSplatCoverage;
    // The scale from which a point is covered, ascending, and the share of those up to there.
    std::vector<std::pair<double, double>> Shares;
  };

  /**
   * The cloud: positions and unit normals (3 doubles each), radii, as many as graph has splats, which
   * is that of all overlaps; kept by reference.
   */
  vtkPointSplatCoverage(const double* positions, const double* normals, const double* radii,
    const vtkPointSplatOverlap& graph);

  Cover Measure(const std::vector<Index>& group) const;

  /**
   * Splats of other groups that fill this one's gaps, by the priority queue of section 4.2.2,
   * method 1, of which this group's splats clip no more than the given share each.
   */
  std::vector<Index> Fill(const std::vector<Index>& group, double mostClipped) const;

private:
  template <typename Visit>
  void EachDistance(Index i, Index j, const double axes[2][3], const Visit& visit) const;
  void Axes(Index i, double axes[2][3]) const;

  const double* Positions;
  const double* Normals;
  const double* Radii;
  const vtkPointSplatOverlap& Graph;
  Index Count;
  std::vector<double> Samples;  // in the unit disk, two coordinates each
  std::vector<Index> Measured;  // splats on whose points the surface is measured
  std::vector<double> Weights;  // of their points, by area
  double Area = 0.0;            // the sum of these
};

VTK_ABI_NAMESPACE_END
#endif
