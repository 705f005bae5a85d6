// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatFace
 * @brief   the smooth piece of surface that a point lies on, up to the creases around it
 *
 * An internal helper of vtkPointSplatCrease; see the stages there.
 *
 * Of the neighbours those lie on the point's face whose normals and heights are those of a surface
 * of second order through the point. Such a surface is found in two steps: neighbours whose normals
 * and heights are about those of the tangent plane say how it bends (vtkPointSplatCurvature.h);
 * then those count that are about on the bent surface, and say it again.
 */
#ifndef vtkPointSplatFace_h
#define vtkPointSplatFace_h

#include "vtkPointSplatSheet.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatFace
{
public:
  /// Faces are flat where normals deviate by less than this sine (2 degrees); where too few are near to say how one bends, it
  /// must be.
  static constexpr float FlatDeviation = 0.03f;

  /// The neighbours on the face.
  vtkPointSplatSheet Members;
  /// The second fundamental form, as in vtkPointSplatCurvature, and its greatest magnitude.
  float Tensor[6] = { 0, 0, 0, 0, 0, 0 };
  float Strongest = 0;
  /// Whether there are enough of them, and not all in a row, to tell that it is a face with this
  /// normal. Points whose normals are averages of two faces' have only such on the same edge.
  bool Sound = false;
  /// Else, whether there are some in a row, with one normal: on an edge whose normals are averages, or on a
  /// strip that is narrower than points are apart.
  bool Row = false;
  /// How many neighbours, as near as these, are not on the face.
  int NumberOfOthers = 0;
  /// By how much the members' normals are off the face's: the sine, root mean square.
  float Deviation = 0;

  /// normals: 3 floats a slot, unit length; n: of the centre's face; spacing: of the points here.
  void Fit(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals,
    const float n[3], float spacing);

  /// The product of the tensor and a vector.
  static void Multiply(const float tensor[6], const float d[3], float result[3]);

private:
  void Select(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals,
    const float n[3], float reach);
  bool IsSpread(const vtkPointSplatNeighbors::Neighborhood& around) const;
};

VTK_ABI_NAMESPACE_END
#endif
