// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of a splat behind its clip lines, on the other faces that meet at its point
// (vtkPointSplatArrays.h: SplatFold). Each part ends where the other parts' planes meet its own.
#ifndef vtkPointSplatFolds_h
#define vtkPointSplatFolds_h

class vtkPointSplatFolds
{
public:
  /// Of a point without any.
  vtkPointSplatFolds() = default;
  /// Of a point's SplatFold, SplatClip, normal and SplatPlaneNormal.
  vtkPointSplatFolds(const double fold[6], const double clip[6], const double normal[3],
    const double plane[3]);

  /// The clip lines of a part, as in the array SplatClip.
  void GetLines(int part, double c[6]) const;

  bool Has[2] = { false, false };
  double Normals[2][3]; // of the parts' planes, unit length, on the side of the point's

private:
  static bool Turn(double n[3], const double side[3]);
  void Meet(int part, const double other[3], int like, double c[3]) const;

  double Plane[3]; // of the first part
  double Clip[6];
  bool Convex[2] = { false, false }; // the edges between the first part and the others
};

#endif
