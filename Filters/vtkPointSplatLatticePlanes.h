// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticePlanes
 * @brief   the planes of a lattice across an axis
 *
 * An internal helper of vtkPointSplatLattice. Planes are told by coordinates that many points have to the bit. Not all that
 * many have are planes': points on flat faces across an axis have one in common, too, and so have those of bodies that are
 * symmetric, or of volumes of few values.
 *
 * 1. The distances that are tried are those that are most often found between coordinates that many points have, and twice
 *    these, from several such coordinates: of a mask more points may lie half way between planes than on these.
 * 2. The lattice's are the widest, along the three axes, by which two coordinates of each point are planes'.
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
  /// Finds those across all axes. samples: coordinates of the same points along each; returns whether there are such.
  static bool Choose(const std::vector<double> samples[3], vtkPointSplatLatticePlanes axes[3]);

  double Distance = 0; // from one to the next

  /// The plane at a coordinate, or the last one before it.
  std::int64_t GetFloor(double x) const;
  /// How far a coordinate is from that, in distances.
  double GetPart(double x) const;
  /// Whether a coordinate is a plane's, and which.
  bool Has(double x, std::int64_t& plane) const;

private:
  static std::vector<vtkPointSplatLatticePlanes> Find(std::vector<double> sample);
  static bool AreOnEdges(const std::vector<double> samples[3], const vtkPointSplatLatticePlanes axes[3]);
  void Refine(std::vector<double> often);

  double First = 0;
  double Tolerance = 0;
  std::size_t Points = 0; // on them, of a sample
};

VTK_ABI_NAMESPACE_END
#endif
