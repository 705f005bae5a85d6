// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVPointSplatOrientation.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatNeighbors.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr vtkIdType NoPiece = -1; // of points that take no part
constexpr const char* NormalName = "EstimatedNormal";
constexpr const char* PieceName = "PieceOfSurface";

/// Sets that grow together, each with a representative; and whether each is turned against that.
class Sets
{
public:
  explicit Sets(size_t count)
    : Parent(count)
    , Sizes(count, 1)
    , Against(count, false)
  {
    for (size_t i = 0; i < count; ++i)
    {
      this->Parent[i] = i;
    }
  }
  size_t Find(size_t i, bool& against) const
  {
    against = false;
    while (this->Parent[i] != i)
    {
      against = against != this->Against[i];
      i = this->Parent[i];
    }
    return i;
  }
  void Join(size_t a, size_t b, bool turned)
  {
    bool againstA = false;
    bool againstB = false;
    a = this->Find(a, againstA);
    b = this->Find(b, againstB);
    if (a != b)
    {
      // The larger stays, so that ways are short.
      if (this->Sizes[a] < this->Sizes[b])
      {
        std::swap(a, b);
      }
      this->Sizes[a] += this->Sizes[b];
      this->Parent[b] = a;
      this->Against[b] = turned != (againstA != againstB);
    }
  }

private:
  std::vector<size_t> Parent;
  std::vector<size_t> Sizes; // of representatives
  std::vector<bool> Against;
};

/// What all processes have, in the order of their ranks.
std::vector<double> GatherAll(vtkMultiProcessController* controller, const std::vector<double>& own)
{
  const size_t ranks = static_cast<size_t>(controller->GetNumberOfProcesses());
  std::vector<vtkIdType> lengths(ranks);
  const vtkIdType length = static_cast<vtkIdType>(own.size());
  controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(ranks, 0);
  for (size_t rank = 1; rank < ranks; ++rank)
  {
    offsets[rank] = offsets[rank - 1] + lengths[rank - 1];
  }
  std::vector<double> all(static_cast<size_t>(offsets.back() + lengths.back()));
  if (!all.empty())
  {
    controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
  }
  return all;
}
}

//------------------------------------------------------------------------------
vtkPVPointSplatOrientation::vtkPVPointSplatOrientation(
  vtkAlgorithm* self, vtkPolyData* points, vtkDataArray* normals, vtkIdType own)
  : Points(points)
  , Normals(normals)
  , Own(own)
{
  this->PieceOf.assign(static_cast<size_t>(points->GetNumberOfPoints()), NoPiece);
  if (this->PieceOf.empty())
  {
    return;
  }
  std::vector<unsigned char> used;
  vtkPointSplatInput::MarkUsable(points, used);
  vtkPointSplatNeighbors neighbors;
  neighbors.Build(points->GetPoints()->GetData(), used.data());
  constexpr int edges = 10;
  using Slot = vtkPointSplatNeighbors::Slot;
  std::vector<Slot> graph(
    edges * size_t(neighbors.GetNumberOfSlots()), vtkPointSplatNeighbors::None);
  neighbors.Visit(self, 1.0, 1.0, edges,
    [&graph](const vtkPointSplatNeighbors::Neighborhood& around, int) {
      std::copy_n(around.Slots, around.Count, graph.data() + edges * size_t(around.Center));
      return true;
    });
  Sets sets(neighbors.GetNumberOfSlots());
  for (size_t e = 0; e < graph.size(); ++e)
  {
    if (graph[e] != vtkPointSplatNeighbors::None)
    {
      sets.Join(e / edges, graph[e], false);
    }
  }
  for (size_t i = 0; i < this->PieceOf.size(); ++i)
  {
    bool unused = false;
    const Slot slot = neighbors.GetSlots()[i];
    this->PieceOf[i] = slot == vtkPointSplatNeighbors::None
      ? NoPiece
      : static_cast<vtkIdType>(sets.Find(slot, unused));
  }
}

//------------------------------------------------------------------------------
void vtkPVPointSplatOrientation::AddTo(vtkPolyData* own, int rank) const
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName(NormalName);
  normals->SetNumberOfComponents(3);
  normals->InsertTuples(0, this->Own, 0, this->Normals);
  vtkNew<vtkIdTypeArray> pieces;
  pieces->SetName(PieceName);
  pieces->SetNumberOfComponents(2);
  pieces->SetNumberOfTuples(this->Own);
  for (vtkIdType i = 0; i < this->Own; ++i)
  {
    pieces->SetTypedComponent(i, 0, rank);
    pieces->SetTypedComponent(i, 1, this->PieceOf[static_cast<size_t>(i)]);
  }
  own->GetPointData()->AddArray(normals);
  own->GetPointData()->AddArray(pieces);
}

//------------------------------------------------------------------------------
vtkPVPointSplatOrientation::Votes vtkPVPointSplatOrientation::Vote(
  vtkMultiProcessController* controller, vtkPolyData* sent) const
{
  vtkDataArray* normals = sent->GetPointData()->GetArray(NormalName);
  vtkDataArray* pieces = sent->GetPointData()->GetArray(PieceName);
  Votes own;
  for (vtkIdType i = this->Own; i < sent->GetNumberOfPoints(); ++i)
  {
    double here[3];
    double there[3];
    double piece[2];
    this->Normals->GetTuple(i, here);
    normals->GetTuple(i, there);
    pieces->GetTuple(i, piece);
    std::array<Piece, 2> pair = { { { { controller->GetLocalProcessId(),
                                      this->PieceOf[static_cast<size_t>(i)] } },
      { { static_cast<vtkIdType>(piece[0]), static_cast<vtkIdType>(piece[1]) } } } };
    std::sort(pair.begin(), pair.end());
    if (pair[0][1] != NoPiece && pair[1][1] != NoPiece)
    {
      own[pair] += vtkMath::Dot(here, there);
    }
  }
  std::vector<double> told;
  for (const auto& vote : own)
  {
    for (const Piece& piece : vote.first)
    {
      told.insert(told.end(), piece.begin(), piece.end());
    }
    told.push_back(vote.second);
  }
  const std::vector<double> all = GatherAll(controller, told);
  Votes votes;
  for (size_t at = 0; at < all.size(); at += 5)
  {
    const auto number = [&all, at](size_t k) { return static_cast<vtkIdType>(all[at + k]); };
    votes[{ { { { number(0), number(1) } }, { { number(2), number(3) } } } }] += all[at + 4];
  }
  return votes;
}

//------------------------------------------------------------------------------
std::map<vtkPVPointSplatOrientation::Piece, vtkPVPointSplatOrientation::Outside>
vtkPVPointSplatOrientation::FindOutsides(
  vtkMultiProcessController* controller, const Votes& votes) const
{
  std::map<Piece, Outside> outsides;
  Outside nothing;
  nothing.Far.fill(-VTK_DOUBLE_MAX);
  nothing.Along.fill(0.0);
  for (const auto& vote : votes)
  {
    outsides.insert({ vote.first[0], nothing });
    outsides.insert({ vote.first[1], nothing });
  }
  std::map<vtkIdType, Outside*> own;
  for (auto& entry : outsides)
  {
    if (entry.first[0] == controller->GetLocalProcessId())
    {
      own[entry.first[1]] = &entry.second;
    }
  }
  for (vtkIdType i = 0; i < this->Own; ++i)
  {
    const auto found = own.find(this->PieceOf[static_cast<size_t>(i)]);
    double x[3];
    this->Points->GetPoint(i, x);
    for (size_t side = 0; side < 6 && found != own.end(); ++side)
    {
      const double sign = side < 3 ? 1.0 : -1.0;
      if (sign * x[side % 3] > found->second->Far[side]) // not where a coordinate is NaN
      {
        found->second->Far[side] = sign * x[side % 3];
        found->second->Along[side] =
          sign * this->Normals->GetComponent(i, static_cast<int>(side % 3));
      }
    }
  }
  std::vector<double> told;
  for (const auto& piece : own)
  {
    told.push_back(controller->GetLocalProcessId());
    told.push_back(static_cast<double>(piece.first));
    told.insert(told.end(), piece.second->Far.begin(), piece.second->Far.end());
    told.insert(told.end(), piece.second->Along.begin(), piece.second->Along.end());
  }
  const std::vector<double> all = GatherAll(controller, told);
  for (auto at = all.begin(); at != all.end(); at += 14)
  {
    const Piece piece = { { static_cast<vtkIdType>(at[0]), static_cast<vtkIdType>(at[1]) } };
    Outside& outside = outsides[piece];
    std::copy_n(at + 2, 6, outside.Far.begin());
    std::copy_n(at + 8, 6, outside.Along.begin());
  }
  return outsides;
}

//------------------------------------------------------------------------------
std::vector<bool> vtkPVPointSplatOrientation::FindTurned(
  vtkMultiProcessController* controller, vtkPolyData* sent) const
{
  const Votes votes = this->Vote(controller, sent);
  const std::map<Piece, Outside> outsides = this->FindOutsides(controller, votes);
  std::map<Piece, size_t> numbers;
  for (const auto& outside : outsides)
  {
    numbers.insert({ outside.first, numbers.size() });
  }
  std::vector<std::pair<double, std::array<Piece, 2>>> surest;
  for (const auto& vote : votes)
  {
    surest.emplace_back(-std::abs(vote.second), vote.first);
  }
  std::sort(surest.begin(), surest.end());
  Sets surfaces(numbers.size());
  for (const auto& vote : surest)
  {
    surfaces.Join(
      numbers[vote.second[0]], numbers[vote.second[1]], votes.at(vote.second) < 0.0);
  }

  std::map<size_t, Outside> wholes; // of surfaces, as their representatives are turned
  for (const auto& outside : outsides)
  {
    bool against = false;
    const size_t surface = surfaces.Find(numbers[outside.first], against);
    Outside& whole = wholes.insert({ surface, outside.second }).first->second;
    for (size_t side = 0; side < 6; ++side)
    {
      if (outside.second.Far[side] >= whole.Far[side])
      {
        whole.Far[side] = outside.second.Far[side];
        whole.Along[side] = (against ? -1.0 : 1.0) * outside.second.Along[side];
      }
    }
  }
  std::vector<bool> turned;
  for (vtkIdType i = 0; i < this->Own; ++i)
  {
    const auto piece =
      numbers.find({ { controller->GetLocalProcessId(), this->PieceOf[static_cast<size_t>(i)] } });
    bool against = false;
    if (piece != numbers.end())
    {
      const Outside& whole = wholes.at(surfaces.Find(piece->second, against));
      double clearest = 0.0;
      for (const size_t side : { 2, 1, 0, 5, 4, 3 })
      {
        constexpr double little = 1e-3;
        clearest = std::abs(whole.Along[side]) > std::abs(clearest) + little ? whole.Along[side]
                                                                              : clearest;
      }
      against = against != (clearest < 0.0);
    }
    turned.push_back(against);
  }
  return turned;
}
