// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Splats of points that move: their sizes, curvature and lines are those of an earlier frame.
//
// To estimate sizes takes some 3 microseconds a point and core, longer than to draw them; and a surface that moves and
// bends keeps its points' neighbours. So splats rest as they were estimated, and are moved along:
// 1. Begin() takes the splats at rest, in the cloud's order and form, in parts that lie together. Each splat has an anchor,
//    the splat of a point that it moves with: a point's is its own, what lies between points (fill points) or stands
//    for some (levels) has one of these.
// 2. MoveTo() is told where points are. All are looked at, since what is not finite cannot be drawn; nothing else is
//    done for all of them. A part is moved where it is asked for, as those that a frame shows. When that is first done,
//    up to three neighbours are found for each of its splats: the nearest of those beside it in its part whose anchors lie on
//    its anchor's side of the surface.
// 3. A splat's anchor gets its point's new position and normal. From the tangential parts z of the ways to the neighbours'
//    anchors at rest and z' of those now, as complex numbers, follow the turn about the normal and the
//    stretch, S = sum z' conj(z) / sum |z|^2, that leave the least squares. The way from the anchor to the splat, its plane,
//    bend and lines turn by S; its radius stretches by |S|, and by the strain across it, so that the disk still covers
//    what is stretched more one way than the other.
// 4. The strain of a point, sqrt(sum |z' - S z|^2 + sum (h' - |S| h)^2) / sqrt(sum |z'|^2) with the ways h along the normals,
//    tells what a turn and a stretch do not: shear, new bends, and points that went apart. Where, of thirty thousand
//    points in parts here and there, more than one in a hundred is strained by more than LargestStrain, the motion is
//    none that sizes can follow. The few that are, as a point that jumps, take turn and stretch of the neighbour whose
//    stretch is the median.
//
// Strain is measured from where splats rest, however many frames ago that was, so that errors do not add up.
// Circular splats only. Memory: the splats at rest, and 8 bytes for each.
#ifndef vtkPointSplatMotion_h
#define vtkPointSplatMotion_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPointSplatMotion
{
public:
  /// Splats, packed, and their clip lines, if any has one (vtkPointSplatCloud.h).
  struct Splats
  {
    std::vector<uint32_t> Words;
    std::vector<uint32_t> Lines;
  };

  /// Splats that lie together, of points of one block of the input.
  struct Part
  {
    uint32_t First;
    uint32_t Count;
    uint32_t Block;
    bool OfPoints; // not of levels
  };

  /// A block of the input: where its points are now. Without radii these follow.
  struct Block
  {
    vtkSmartPointer<vtkDataArray> Points;
    vtkSmartPointer<vtkDataArray> Normals;
    vtkSmartPointer<vtkDataArray> Radii;
    vtkIdType Count = 0; // points, when they were told
  };

  /// What the parts that were judged tell.
  struct Outcome
  {
    bool Followed = false;
    double Stretch = 1.0; // mean
    double Growth = 1.0;  // of radii, mean
    double LargestGrowth = 1.0;
  };

  /// anchors: of each splat the splat of a point.
  void Begin(Splats splats, std::vector<uint32_t> anchors, std::vector<Part> parts);
  void End();
  bool HasBegun() const { return !this->Rest.Words.empty(); }
  const Splats& GetRest() const { return this->Rest; }
  /// Takes the splats at rest, and ends.
  Splats Take();
  size_t GetNumberOfParts() const { return this->Parts.size(); }

  /**
   * Says where the blocks' points are now, relative to an origin. Not followed: they cannot be, since some
   * coordinates, normals or radii are not finite or zero, or by strain, be it that the same points come in another order.
   * moved gets room for all splats.
   */
  Outcome MoveTo(std::vector<Block> blocks, const std::array<double, 3>& origin, Splats& moved);
  /// Moves those of some parts that were not.
  void Move(const std::vector<uint32_t>& parts, Splats& moved);
  bool IsMoved(size_t part) const { return this->Moved[part] != 0; }

private:
  static constexpr size_t MostNeighbours = 3;
  class Worker;
  struct Sums;

  void FindNeighbours(const Part& part);
  Sums MoveParts(const std::vector<uint32_t>& parts, Splats& moved);

  Splats Rest;
  std::vector<uint32_t> Anchors;
  std::vector<std::array<int8_t, MostNeighbours>> Neighbours; // where in the order; 0: none
  std::vector<Part> Parts;
  std::vector<unsigned char> Known; // parts, whose neighbours are found
  std::vector<unsigned char> Moved; // parts
  std::vector<Block> Blocks;
  std::array<double, 3> Origin{ { 0.0, 0.0, 0.0 } };
};

#endif
