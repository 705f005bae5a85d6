// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatCrease
 * @brief   the lines at which a point's face ends, where others meet it
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 *
 * A surface that is smooth turns from point to point; at a crease it turns at once. So each
 * neighbour that is not on the point's own face (vtkPointSplatFace) is asked where its face meets
 * the point's, and how much is left there of the angle between them:
 * 1. With a neighbour at q, its normal m and its second fundamental form C, its face is where
 *    m . (x - q) + (x - q) . C (x - q) / 2 = 0, and the point's own is the same with its normal n
 *    and form, at its position. Newton steps from where both tangent planes meet, along m's
 *    direction in the point's tangent plane, find the foot of the common line.
 * 2. There the normals are m + C (x - q) and the like. If 20 degrees are left between the two, the
 *    neighbour votes for that line, else against lines in this direction: a fillet bends all
 *    the way, and its points turn towards the face as they come near it.
 * 3. Votes for about the same line are averaged, each weighted by how near the neighbour is to the
 *    line. A line needs three votes, three times as many as are against it, and a neighbour on
 *    either side of its foot, unless the point's face ends at it everywhere: a face with a reflex
 *    corner goes on past the ends of its edges. The two nearest lines are kept.
 *
 * Where a mesh was split at an edge its points are there twice, with both faces' normals, and these alone tell the line:
 * neighbours need not vote, but show on which side of it their face is.
 *
 * A point with an average of faces' normals has no face of its own that is spread. It lies on those
 * of its neighbours' faces whose surfaces pass by it; these are told apart by their normals there, and its own is about
 * their mean. Where it is not, or no two such faces are there, and others have its normal, it lies on a strip that is narrower
 * than points are apart, as on the rim of a plate: then that is its face. A strip all of whose points lie on its edges,
 * with averages of its normal and its sides', is the plane through both edges (FindStrip()).
 * Where such a surface leaves a height at the point, the face bends by so much more on the way there that it ends at
 * the point: its normal turns by twice the height over the distance. A face's normal is the mean of what its points
 * say: the nearest one's own may be an average, too.
 *
 * Whether the edge is convex or concave makes no difference, nor which side normals point to.
 */
#ifndef vtkPointSplatCrease_h
#define vtkPointSplatCrease_h

#include "vtkPointSplatFace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// What is known of the faces of all points.
struct vtkPointSplatFaces
{
  using Slot = vtkPointSplatNeighbors::Slot;

  const float* Normals = nullptr; // 3 a slot, unit length
  const float* Tensors = nullptr; // 6 a slot, or null: none is known
  const float* Spacings = nullptr; // a slot: of the nearest ones, of whatever face
  /// Of the slots that were looked at closely: their numbers, in order of slots.
  std::vector<Slot> Numbers; // a slot; None for others
  std::vector<float> Fitted; // 6 a number
  std::vector<unsigned char> Sound; // a number
  std::vector<float> Strips; // 3 a number: the normal of the strip that ends at it, or 0 (vtkPointSplatCrease::FindStrip)

  bool IsSound(Slot s) const
  {
    return this->Numbers[s] == vtkPointSplatNeighbors::None || this->Sound[this->Numbers[s]];
  }
  /// A slot's face: its normal and its second fundamental form; null of one without.
  const float* GetFace(Slot s, float tensor[6]) const;
};

class vtkPointSplatCrease
{
public:
  static constexpr int MaximumNumberOfLines = 2;
  /// The fewest neighbours that must say the same line.
  static constexpr int FewestVotes = 3;
  /// How far, in spacings, lines and the neighbours that vote for them are looked for.
  static constexpr float LargestReach = 4.0f;

  /// What of the plane through the centre is kept has Direction . x <= Distance.
  struct Line
  {
    float Direction[3]; // unit length, across the face's normal
    float Distance;     // at least 0
  };
  /// Whether x lies on a line, or by its distance on the edge that bends away from it.
  static bool IsOn(const Line& line, const float x[3], float spacing);

  Line Lines[MaximumNumberOfLines]; // the nearer one first
  int Count = 0;

  /// Whether points at the same position with these normals, of unit length or 0, are of two faces.
  static bool Parts(const float n[3], const float m[3]);

  /**
   * Whether there may be a line so near that a few neighbours are behind it: a cheap question for
   * all points, to look closely only around those where it is so. The normals of some neighbours
   * must be about the centre's, and those of three or more others about the same one, which has
   * turned by more than the former deviate. On a surface that bends they turn by and by; where normals
   * contradict one another, to anywhere. Beside a flat face, which may be a narrow one, two others need to agree.
   */
  static bool IsLikely(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals,
    const float n[3], float spacing);

  /// Finds the lines of the centre, with the face that was fitted to it across the normal n.
  void Find(const vtkPointSplatNeighbors::Neighborhood& around, const vtkPointSplatFace& face,
    const float n[3], const vtkPointSplatFaces& faces);

  /**
   * Adds a line through the centre, after Find(), where points at its position have another face's normal m: the face
   * across n ends there, if its points are to one side. Nothing is added to two lines, or to one of that direction.
   */
  void AddSplit(
    const vtkPointSplatNeighbors::Neighborhood& around, const float n[3], const float m[3]);

  /// Whether Find(), or FindMeeting(), met points of no face, as those on an edge with averaged normals are, and
  /// else those of one face, and of others too few to say a line.
  bool HidesFace() const { return this->Hides; }

  ///@{
  /**
   * Finds the faces that meet at the centre itself, if there are two or three, and if n is between
   * their normals: then it is an average of them.
   */
  bool FindMeeting(const vtkPointSplatNeighbors::Neighborhood& around, const float n[3],
    float spacing, const vtkPointSplatFaces& faces);
  static constexpr int MaximumNumberOfMeeting = 4;
  float Meeting[MaximumNumberOfMeeting][3]; // their normals, on the side of n
  float Ways[MaximumNumberOfMeeting][3];    // the sums of the offsets of their points
  int NumberOfMeeting = 0;
  /// Whether such a face, with its normal on the side of n, goes on behind a line of that direction to where its points
  /// are. It does not where it turns by more than a right angle from n, which is no average then: on a sharp edge a
  /// point of one face with few of its neighbours looks like one with an average.
  bool GoesOn(int meeting, const float n[3], const float direction[3]) const;
  /**
   * After FindMeeting() met just one face: adds the plane of a strip through the points along that face's edge and those of
   * another edge beside it, and returns how many neighbours tell it; 0 if there is none. On a strip that is one spacing
   * wide, as on the top of a rib, all points are on its edges, and have averages of its normal and their sides'. n must be
   * between the face's normal and the strip's.
   */
  int FindStrip(const vtkPointSplatNeighbors::Neighborhood& around, const float n[3], float spacing,
    const vtkPointSplatFaces& faces);
  ///@}

private:
  /// Nearer than this, in spacings, a point is on a line, or on a face, itself.
  static constexpr float OnLine = 0.15f;
  /// The cosine (15 degrees) of directions of one line, and of normals of one face.
  static constexpr float SameDirection = 0.966f;

  static bool IsSame(const Line& a, const Line& b, float spacing);

  struct Vote
  {
    Line At;
    float Weight;
    float Along[3]; // to the neighbour
    float Normal[3]; // its own
    bool For;
    bool Open; // of no line yet
  };
  bool GetVote(const float q[3], const float m[3], const float C[6], const float n[3],
    const vtkPointSplatFace& face, Vote& vote) const;
  bool IsBehind(const Line& line, const vtkPointSplatFace& face) const;
  int GetBest() const;
  /// A line that several votes say.
  struct Candidate
  {
    Line At;
    int Votes;
  };
  Candidate GetMean(const Vote& best) const;
  bool IsBetween(const float n[3]) const;
  bool IsLine(const Candidate& candidate, const vtkPointSplatNeighbors::Neighborhood& around,
    const vtkPointSplatFace& face, const float n[3], int unsound) const;

  bool Hides = false;
  float Spacing = 0;
  const vtkPointSplatNeighbors::Neighborhood* Around = nullptr; // that Find() looks at
  Vote Votes[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  int NumberOfVotes = 0;
  int Unsound[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  int NumberOfUnsound = 0;
};

VTK_ABI_NAMESPACE_END
#endif
