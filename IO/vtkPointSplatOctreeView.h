// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the octree's reader: what a camera sees, and how large.
#ifndef vtkPointSplatOctreeView_h
#define vtkPointSplatOctreeView_h

#include <array>

class vtkBoundingBox;
class vtkCamera;

class vtkPointSplatOctreeView
{
public:
  /// Of a picture of so many pixels, as the camera is now.
  vtkPointSplatOctreeView(vtkCamera* camera, int width, int height);

  /// False: the camera has no place, no direction, or numbers that are none.
  bool IsValid() const;
  /// Whether nothing of the box is between the sides of the picture. The near and the far plane do not
  /// matter, since they follow what is drawn, and not what might be.
  bool IsOutside(const vtkBoundingBox& box) const;
  /// The radius, in pixels, where the box is nearest to the eye; infinite where the eye may be in it.
  double PixelsOf(const vtkBoundingBox& box, double radius) const;
  /// Where the camera comes to if it moves on as it has since another view: it turns, goes and zooms
  /// by the same once more.
  vtkPointSplatOctreeView After(const vtkPointSplatOctreeView& before) const;
  bool operator==(const vtkPointSplatOctreeView& other) const;

private:
  using Row = std::array<double, 4>;
  /// Makes the rows of both.
  void Combine();

  std::array<double, 16> Place; // from the world to the camera
  std::array<Row, 3> Lens;      // from there to x, y and w of the picture, whose sides are at w and -w
  std::array<Row, 3> Rows;      // from the world to x, y and w
  std::array<double, 2> Pixels; // half the picture's
};

#endif
