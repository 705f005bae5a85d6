// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticePlanes
 * @brief   the planes of a lattice across an axis
 *
 * An internal helper of vtkPointSplatLattice. Planes are told by coordinates that many points have, but
 * for their rounding. Not all that many have are planes': points on flat faces across an axis have one in common, too, and so have those of bodies that are
 * symmetric, or of volumes of few values.
 *
 * 1. The distances that are tried are those that are most often found between coordinates that many points have, and twice
 *    these, from several such coordinates: of a mask more points may lie half way between planes than on these.
 * 2. The lattice's are the widest, along the three axes, by which two coordinates of each point are planes', or
 *    where the surface was cut of about as many points as by any.
 */
#ifndef vtkPointSplatLatticePlanes_h
#define vtkPointSplatLatticePlanes_h

#include "vtkPointSplattingABI.h"

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticePlanes
{
public:
  /// Of many points it does to look at one of so many.
  static std::size_t GetStride(std::size_t count);
  /// The coordinates along each axis of points with used[id] not 0, of one of GetStride().
  static void Sample(
    const std::vector<double>& positions, const std::vector<unsigned char>& used, std::vector<double> samples[3]);
  /// How far, at most, coordinates of one plane may be from one another, as they are rounded.
  static double GetTolerance(const std::vector<double> samples[3]);
  /// Calls visit(first, last) for the elements of one plane each. sorted: by getCoordinate(element).
  template <typename Element, typename Getter, typename Visitor>
  static void Visit(const std::vector<Element>& sorted, double tolerance, const Getter& getCoordinate, const Visitor& visit)
  {
    for (auto first = sorted.begin(); first != sorted.end();)
    {
      auto last = first + 1;
      while (last != sorted.end() && getCoordinate(*last) - getCoordinate(*(last - 1)) <= tolerance)
      {
        ++last;
      }
      visit(first, last);
      first = last;
    }
  }
  /// Points that are on no edge, at most, of all: those of a cut.
  static constexpr double MostOff = 0.25;

  /// Finds those across all axes. samples: coordinates of the same points along each; returns a voxel's volume, or 0 if there
  /// are none.
  static double Choose(const std::vector<double> samples[3], vtkPointSplatLatticePlanes axes[3]);

  double Distance = 0; // from one to the next

  /// The plane at a coordinate, or the last one before it.
  std::int64_t GetFloor(double x) const;
  /// How far a coordinate is from that, in distances.
  double GetPart(double x) const;
  /// Whether a coordinate is a plane's, and which.
  bool Has(double x, std::int64_t& plane) const;

private:
  static std::vector<vtkPointSplatLatticePlanes> Find(std::vector<double> sample, double tolerance);
  static std::size_t CountOff(
    const std::vector<double> samples[3], const vtkPointSplatLatticePlanes axes[3], std::size_t most);
  void Refine(std::vector<double> often);

  double First = 0;
  double Tolerance = 0;
  std::size_t Points = 0; // on them, of a sample
};

VTK_ABI_NAMESPACE_END
#endif
