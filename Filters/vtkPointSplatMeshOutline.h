// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMeshOutline
 * @brief   the border of a mesh near a place on it
 *
 * An internal helper of vtkPointSplatMeshBorders, for places that are no vertices, at which fill points lie, where there is much
 * of it.
 *
 * 1. Edges of the border that follow one another are pieces as long as a 32nd of what is looked for around a place, by powers
 *    of two, and longer ones stand alone: however fine an outline is, few are found (vtkStaticCellLocator).
 * 2. Each body, which are the triangles that connect, has its own: a face that was split from the next one ends where that
 *    does, a plate may lie on another one, and around each of a part's many faces all others are.
 */
#ifndef vtkPointSplatMeshOutline_h
#define vtkPointSplatMeshOutline_h

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSplatFans.h"
#include "vtkStaticCellLocator.h"

#include <limits>
#include <map>
#include <mutex>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatMeshOutline
{
public:
  explicit vtkPointSplatMeshOutline(const vtkPointSplatFans& fans)
    : Fans(fans)
  {
  }

  /// Of the border, from a vertex along an edge and on to another one.
  struct Piece
  {
    vtkIdType From;
    vtkPointSplatFans::BorderEdge First;
    vtkIdType To;
  };

  /// Gives the pieces of a vertex' body that may be so near to a place.
  void Find(vtkIdType vertex, const double place[3], double reach, std::vector<Piece>& pieces);

private:
  /// Pieces of about one length.
  struct Level
  {
    std::vector<Piece> Pieces;
    vtkNew<vtkStaticCellLocator> Locator;
  };
  struct Body
  {
    std::vector<Piece> Edges; // each once, as they follow one another
    double Shortest = std::numeric_limits<double>::max(); // edge's length
    std::map<int, Level> Levels;
  };
  void FindBodies();
  const Level& GetLevel(Body& body, int exponent) const;
  double GetLength(const Piece& edge) const;
  vtkIdType GetFirst(vtkIdType vertex);

  const vtkPointSplatFans& Fans;
  std::vector<vtkIdType> Firsts; // of each vertex one of its body's; of one of them itself; empty before they are asked for
  std::map<vtkIdType, Body> Bodies; // by these
  vtkNew<vtkIdList> Found;
  std::mutex Mutex; // of all but Fans
};

VTK_ABI_NAMESPACE_END
#endif
