// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which way estimated normals point, for processes that share a cloud. Each has oriented the pieces
// of surface that it has consistently, and turned each piece outward by itself, which need not be
// the way of the piece that goes on behind the border.
//
// 1. *Pieces.* A process' points, and those of others that it has for neighbours, make one piece
//    where they are joined by the ten nearest neighbours (vtkPointSplatNeighbors), as
//    vtkPointSplatNormals carries orientation on.
// 2. *Votes.* Where two processes have estimated the same point its two normals say whether their
//    two pieces are turned the same way.
// 3. *Turn.* All processes have all votes, and join pieces, those first that most votes join, as a
//    minimum spanning tree does. Each surface so joined is turned outward by the rule of
//    vtkPointSplatNormals: at the points farthest out along the axes, of which the one counts whose
//    normal is most along its axis.
#ifndef vtkPVPointSplatOrientation_h
#define vtkPVPointSplatOrientation_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include "vtkPointSplattingABI.h"

#include <array>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
class vtkMultiProcessController;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkPVPointSplatOrientation
{
public:
  /// Of points with normals that `self` estimated; the first `own` of them are this process'.
  vtkPVPointSplatOrientation(
    vtkAlgorithm* self, vtkPolyData* points, vtkDataArray* normals, vtkIdType own);

  /// Adds normals and the numbers of pieces to this process' own points, to vote with elsewhere.
  void AddTo(vtkPolyData* own, int rank) const;

  /**
   * Which own points are to be turned, by what others have sent: the points that this was made of,
   * with what AddTo() added where they came from. All processes must call.
   */
  std::vector<bool> FindTurned(vtkMultiProcessController* controller, vtkPolyData* sent) const;

private:
  /// A piece, by its process and its number there.
  using Piece = std::array<vtkIdType, 2>;
  /// Of two pieces by how much normals say that they are turned the same way, or less than 0.
  using Votes = std::map<std::array<Piece, 2>, double>;
  /// How far out a piece comes along x, y, z, -x, -y, -z, and its normal along the axis there.
  struct Outside
  {
    std::array<double, 6> Far;
    std::array<double, 6> Along;
  };

  Votes Vote(vtkMultiProcessController* controller, vtkPolyData* sent) const;
  std::map<Piece, Outside> FindOutsides(
    vtkMultiProcessController* controller, const Votes& votes) const;

  vtkSmartPointer<vtkPolyData> Points;
  vtkSmartPointer<vtkDataArray> Normals;
  vtkIdType Own;
  std::vector<vtkIdType> PieceOf;
};

#endif
