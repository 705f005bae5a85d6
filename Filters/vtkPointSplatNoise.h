// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatNoise.h
 * @brief whether points and normals agree on one surface
 *
 * An internal helper of vtkPointSplatEstimation and vtkPointSplatProjection.
 */
#ifndef vtkPointSplatNoise_h
#define vtkPointSplatNoise_h

#include "vtkPointSplatNeighbors.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkAlgorithm;

namespace vtkPointSplatNoise
{
/// Neighbours that deviate from a point's surface by more than this, in their mean distance, are
/// noise: those of clean data that turn by half a radian within that distance deviate by less.
inline constexpr float Noisy = 0.15f;

/// Shares of a cloud's points.
struct Shares
{
  /// Those whose neighbours do not lie on one surface by their normals, nor on a plane without these; but those of small
  /// bodies, of whose neighbours many face the other way.
  double Noisy = 0;
  /// Those that have a neighbour above or below them: the normals of both agree within 60 degrees,
  /// and the line from one to the other is nearer to these than to the surface, with no neighbour between that faces the
  /// other way. No surface goes through both. Relief, however rough, has none such: where points come nearer to one another, so do
  /// their heights. Vertices of an isosurface with given normals, of parts of one as well, count as none, as a noisy
  /// volume's surface has this relief itself.
  double Contradicted = 0;
  /// Whether so few are noisy, of estimated normals as well, that these tell where the surface bends.
  bool Clean = true;
};

/**
 * Looks at a sample of the slots, one leaf of the search tree in 32. normals: 3 floats a slot. guessed:
 * whether most of these were estimated; then shares are 0 that do not tell noise from where the surface turns.
 */
Shares Measure(vtkAlgorithm* self, const vtkPointSplatNeighbors& neighbors, const float* normals, bool guessed);
}

VTK_ABI_NAMESPACE_END
#endif
