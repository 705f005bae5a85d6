// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeFrame
 * @brief   the way in which a volume's lattice is turned, told by an isosurface's vertices
 *
 * An internal helper of vtkPointSplatMesh: volumes of oblique scans, and surfaces that were moved, are not along the axes.
 *
 * 1. *Windows.* Of the points that are nearest to some of them, all over the cloud, three are taken at random many times. The
 *    plane through these is one of the lattice's if many others share planes that are parallel to it.
 * 2. *Directions* across such planes are fitted to all points on them: first to those of the window, then to more and more that
 *    are farther off, as long as these are on such planes, too.
 * 3. *Frames.* Two such directions that are perpendicular to one another, and a third, are the axes of a lattice if each point has
 *    coordinates of planes along two of them (vtkPointSplatLatticePlanes). Of several the one that has the largest voxels is
 *    it: where points lie half way between samples they lie on planes across diagonals, too. Its first axis is
 *    that along x rather than y or z, and so on: which diagonal marching cubes' triangles have depends on it.
 *
 * Nothing is found if voxels along the axes are as large, whose lattice is tried before; or where a window has no such
 * planes, as in most clouds the first one.
 */
#ifndef vtkPointSplatLatticeFrame_h
#define vtkPointSplatLatticeFrame_h

#include "vtkPointSplattingABI.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeFrame
{
public:
  /// positions: 3 a point, of which those with used[id] not 0 count. Returns whether there is a frame other than the axes'.
  bool Find(const std::vector<double>& positions, const std::vector<unsigned char>& used);

  /// Vectors, or positions, of 3 components each, along the frame's axes.
  template <typename Number>
  std::vector<Number> Turn(const std::vector<Number>& vectors) const;

private:
  struct Vector
  {
    double X[3];
    double Dot(const Vector& other) const;
    Vector Cross(const Vector& other) const;
  };
  /// Across parallel planes that points lie on.
  struct Direction
  {
    Direction(const Vector& across, const Vector& near)
      : Across(across)
      , Near(near)
    {
    }
    bool IsLike(const Vector& other) const;
    bool HasPlanes(double least) const;
    /// Counts points on planes.
    void Count(const std::vector<Vector>& points, double tolerance);
    /// Turns it to where the counted points are nearest to their planes.
    void Fit();

    Vector Across;           // of unit length
    Vector Near;             // where it was found
    std::size_t Shared = 0;  // points on planes with others, but those that are by chance
    std::size_t Planes = 0;  // these
    std::size_t Largest = 0; // points on one of them
    double Score = 0;        // of all windows
    double Products[3][3];   // sums of those of points' offsets from the middles of their planes
  };

  static std::vector<Vector> GetWindow(
    const std::vector<double>& positions, const std::vector<unsigned char>& used, const Vector& center);
  bool LookAt(const Vector& center, const std::vector<Vector>& window);
  bool FitToAll(Direction& direction, const std::vector<Direction>& known) const;
  double GetVoxel(const Vector axes[3]) const;
  bool Choose();
  void Order();

  Vector Axes[3] = {};
  double Tolerance = 0;
  int Windows = 0; // that have directions
  std::vector<Vector> Sample; // of all points
  std::vector<Direction> Directions;
};

VTK_ABI_NAMESPACE_END
#endif
