// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeshOutline.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// What part of what is looked for around a place pieces are long.
constexpr double PiecesPerReach = 32;
}

void vtkPointSplatMeshOutline::FindBodies()
{
  this->Firsts.resize(this->Fans.GetNumberOfPoints());
  std::iota(this->Firsts.begin(), this->Firsts.end(), vtkIdType(0));
  const std::vector<vtkIdType>& corners = this->Fans.GetCorners();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const auto [first, second] = std::minmax(
      { this->GetFirst(corners[i]), this->GetFirst(corners[i % 3 < 2 ? i + 1 : i - 2]) });
    this->Firsts[second] = first;
  }

  std::set<std::pair<vtkIdType, vtkIdType>> followed;
  for (const vtkIdType begin : this->Fans.GetBorder())
  {
    Body& body = this->Bodies[this->GetFirst(begin)];
    for (const vtkPointSplatFans::BorderEdge& edge : this->Fans.GetBorderEdges(begin))
    {
      Piece piece{ begin, edge, edge.Next };
      while (followed.insert(std::minmax(piece.From, piece.To)).second)
      {
        body.Edges.push_back(piece);
        const double length = this->GetLength(piece);
        body.Shortest = length > 0 ? std::min(body.Shortest, length) : body.Shortest;
        const vtkPointSplatFans::BorderEdges next = this->Fans.GetBorderEdges(piece.To);
        if (next.Count != 2)
        {
          break;
        }
        const vtkPointSplatFans::BorderEdge& on = next.First[next.First[0].Next == piece.From ? 1 : 0];
        piece = { piece.To, on, on.Next };
      }
    }
  }
}

double vtkPointSplatMeshOutline::GetLength(const Piece& edge) const
{
  return std::sqrt(
    vtkMath::Distance2BetweenPoints(this->Fans.GetPosition(edge.From), this->Fans.GetPosition(edge.To)));
}

vtkIdType vtkPointSplatMeshOutline::GetFirst(vtkIdType vertex)
{
  while (this->Firsts[vertex] != vertex)
  {
    vertex = this->Firsts[vertex] = this->Firsts[this->Firsts[vertex]];
  }
  return vertex;
}

/// Pieces up to two to that power long.
const vtkPointSplatMeshOutline::Level& vtkPointSplatMeshOutline::GetLevel(Body& body, int exponent) const
{
  const auto [at, isNew] = body.Levels.try_emplace(exponent);
  Level& level = at->second;
  if (!isNew)
  {
    return level;
  }
  const double most = std::ldexp(1.0, exponent);
  double along = 0;
  for (const Piece& edge : body.Edges)
  {
    const double length = this->GetLength(edge);
    along += length;
    if (!level.Pieces.empty() && level.Pieces.back().To == edge.From && along <= most)
    {
      level.Pieces.back().To = edge.To;
    }
    else
    {
      level.Pieces.push_back(edge);
      along = length;
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const Piece& piece : level.Pieces)
  {
    lines->InsertNextCell(2);
    lines->InsertCellPoint(points->InsertNextPoint(this->Fans.GetPosition(piece.From)));
    lines->InsertCellPoint(points->InsertNextPoint(this->Fans.GetPosition(piece.To)));
  }
  vtkNew<vtkPolyData> border;
  border->SetPoints(points);
  border->SetLines(lines);
  level.Locator->SetDataSet(border);
  level.Locator->BuildLocator();
  return level;
}

void vtkPointSplatMeshOutline::Find(
  vtkIdType vertex, const double place[3], double reach, std::vector<Piece>& pieces)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  pieces.clear();
  if (this->Firsts.empty())
  {
    this->FindBodies();
  }
  double bounds[6];
  for (int c = 0; c < 3; ++c)
  {
    bounds[2 * c] = place[c] - reach;
    bounds[2 * c + 1] = place[c] + reach;
  }
  const auto body = this->Bodies.find(this->GetFirst(vertex));
  if (body == this->Bodies.end())
  {
    return; // it is closed
  }
  const int finest = std::ilogb(body->second.Shortest);
  const Level& level = this->GetLevel(body->second, std::max(finest, std::ilogb(reach / PiecesPerReach)));
  level.Locator->FindCellsWithinBounds(bounds, this->Found);
  for (const vtkIdType found : *this->Found)
  {
    pieces.push_back(level.Pieces[found]);
  }
}

VTK_ABI_NAMESPACE_END
