// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points whose splats are the same as that of another point: corners of triangles that share their place
// but not their point, as readers of files with texture coordinates leave them. One splat is drawn for all.
//
// 1. Of packed splats (vtkPointSplatCloud.h) in an order in which those at one place are neighbours, each is
//    compared with those before it at its place: all but the point's id and its normal to shade with must be the
//    same to the bit, and so must what says where a point is drawn and to what it belongs: its clip lines, texture
//    coordinates, tangent, and group. Fill points are nobody's copies.
// 2. What points have beside that may differ, as normals do that are those of triangles, and colours that cells gave
//    to their corners. The splat then has the mean, which is what splats at one place are blended to.
#ifndef vtkPointSplatCopies_h
#define vtkPointSplatCopies_h

#include "vtkSmartPointer.h"

#include "vtkPointSplattingABI.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPointSet;
VTK_ABI_NAMESPACE_END

class vtkPointSplatCopies
{
public:
  /// A point that has no splat, and the one whose splat is drawn for it.
  struct Copy
  {
    uint32_t Of;
    uint32_t Point;
    bool operator==(const Copy& other) const { return this->Of == other.Of && this->Point == other.Point; }
    bool operator<(const Copy& other) const
    {
      return this->Of != other.Of ? this->Of < other.Of : this->Point < other.Point;
    }
  };

  /// The arrays of a data set's points that copies must have the same of, but for what splats are made from; or nulls.
  static std::array<vtkDataArray*, 3> GetTelling(vtkPointSet* data);

  /**
   * Takes copies out of so many sorted splats of `words` words each, and returns how many are left. data: the
   * block, of whose points they are. clip: SplatClip of these, or null.
   */
  std::size_t TakeOut(
    uint32_t* splats, std::size_t words, std::size_t count, vtkPointSet* data, vtkDataArray* clip);

  /// In the order of the points that have splats.
  const std::vector<Copy>& Get() const { return this->Copies; }

  /// Whether they still have the same of the telling arrays.
  bool AreSame(vtkPointSet* data) const;

  /// Whether copies are still where the points are that have splats, with the same given radii.
  bool AreTogether(vtkPointSet* data) const;

  /// An array of points, in which those that have copies have the mean of theirs; it itself if there are none.
  template <typename Array>
  vtkSmartPointer<Array> Average(Array* array) const
  {
    return !array || this->Copies.empty()
      ? vtkSmartPointer<Array>(array)
      : vtkSmartPointer<Array>(Array::SafeDownCast(this->MakeAverage(array).Get()));
  }

private:
  void Sort();
  bool HaveSame(vtkDataArray* array) const;
  vtkSmartPointer<vtkDataArray> MakeAverage(vtkDataArray* array) const;

  std::vector<Copy> Copies;
};

#endif
