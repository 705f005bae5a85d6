// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCreases.h"

#include "vtkMath.h"

#include <algorithm>
#include <atomic>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// How many neighbours tell a strip where the point is in no row (Testing/Accuracy/fit_constants.py).
constexpr int FewestWithoutRow = 5;
}

/// Of the points here; where more neighbours are looked at, such a spacing that all of them are in reach.
float vtkPointSplatCreases::GetSpacing(const Neighborhood& around, int round)
{
  return round == 0
    ? vtkPointSplatSheet::GetSpacing(around)
    : std::sqrt(around.SquaredDistance[around.Count - 1]) / vtkPointSplatCrease::LargestReach;
}

/// What is wanted, and the neighbours of it that are of other faces: an edge that nobody looked at seems to be a face
/// with its points' averages of normals.
bool vtkPointSplatCreases::AddOthers(vtkAlgorithm* self, double progress,
  const std::vector<unsigned char>& wanted, std::vector<unsigned char>& all) const
{
  std::vector<std::atomic<unsigned char>> others(wanted.size());
  auto mark = [&](const Neighborhood& around, int) {
    const float* n = this->Faces.Normals + std::size_t(3) * around.Center;
    for (int i = 0; i < around.Count; ++i)
    {
      const Slot j = around.Slots[i];
      if (std::abs(vtkMath::Dot(n, this->Faces.Normals + std::size_t(3) * j)) < OwnCosine)
      {
        others[j].store(1, std::memory_order_relaxed);
      }
    }
    return true;
  };
  const bool finished = this->Neighbors.Visit(
    self, progress, progress, NumberOfNeighbors, mark, [&](Slot s) { return wanted[s] != 0; });
  all = wanted;
  for (Slot s = 0; s < wanted.size(); ++s)
  {
    all[s] |= others[s].load(std::memory_order_relaxed);
  }
  return finished;
}

/// Fits the faces of slots that are wanted and have none yet; those that do not end are not wanted. A row of points is
/// a strip where it is no edge of others' faces.
bool vtkPointSplatCreases::FitFaces(
  vtkAlgorithm* self, double from, double to, std::vector<unsigned char>& wanted)
{
  Slot number = static_cast<Slot>(this->Faces.Sound.size());
  const Slot first = number;
  for (Slot s = 0; s < wanted.size(); ++s)
  {
    if (wanted[s] && this->Faces.Numbers[s] == vtkPointSplatNeighbors::None)
    {
      this->Faces.Numbers[s] = number++;
    }
  }
  this->Faces.Fitted.resize(std::size_t(6) * number, 0.0f);
  this->Faces.Sound.resize(number, 0);
  this->Faces.Strips.resize(std::size_t(3) * number, 0.0f);
  std::vector<unsigned char> rows(number - first, 0);
  auto isNew = [&](Slot s) {
    const Slot own = this->Faces.Numbers[s];
    return own != vtkPointSplatNeighbors::None && own >= first;
  };
  auto fit = [&](const Neighborhood& around, int) {
    const Slot own = this->Faces.Numbers[around.Center];
    vtkPointSplatFace face;
    face.Fit(around, this->Faces.Normals, this->Faces.Normals + std::size_t(3) * around.Center,
      vtkPointSplatSheet::GetSpacing(around));
    std::copy_n(face.Tensor, 6, this->Faces.Fitted.data() + std::size_t(6) * own);
    this->Faces.Sound[own] = face.Sound;
    rows[own - first] = face.Row;
    if (face.Sound && face.NumberOfOthers < vtkPointSplatCrease::FewestVotes &&
      !this->HasTwins(around.Center))
    {
      wanted[around.Center] = 0;
    }
    return true;
  };
  if (!this->Neighbors.Visit(self, from, to, NumberOfNeighbors, fit, isNew))
  {
    return false;
  }
  return this->FindStrips(self, to, first, rows);
}

/// Tells strips from edges among rows, of numbers from first on. Where no face passes by a row it is a strip. Where one does, it
/// may be an edge, of that and of a strip, which are known then; or all points of the strip are on its edges. At the ends of
/// such strips too few neighbours make a row, and more must tell.
bool vtkPointSplatCreases::FindStrips(
  vtkAlgorithm* self, double progress, Slot first, const std::vector<unsigned char>& rows)
{
  enum
  {
    Strips,
    Edges,
    Ends
  };
  for (const int stage : { Strips, Edges, Ends })
  {
    std::vector<unsigned char> strips(rows.size(), 0);
    std::vector<float> planes(this->Faces.Strips.begin() + std::size_t(3) * first, this->Faces.Strips.end());
    auto look = [&](const Neighborhood& around, int round) {
      const float* n = this->Faces.Normals + std::size_t(3) * around.Center;
      const Slot own = this->Faces.Numbers[around.Center] - first;
      const float spacing = GetSpacing(around, round);
      vtkPointSplatCrease crease;
      bool edge = crease.FindMeeting(around, n, spacing, this->Faces);
      if (stage != Strips && !edge && crease.NumberOfMeeting == 1 &&
        crease.FindStrip(around, n, spacing, this->Faces) >=
          (stage == Edges ? vtkPointSplatCrease::FewestVotes : FewestWithoutRow))
      {
        edge = true;
        std::copy_n(crease.Meeting[1], 3, planes.data() + std::size_t(3) * own);
      }
      strips[own] = !edge && (stage == Edges || (stage == Strips && crease.NumberOfMeeting == 0));
      return edge || round > 0 || stage != Edges || !crease.HidesFace();
    };
    if (!this->Neighbors.Visit(self, progress, progress, NumberOfNeighbors, look, [&](Slot s) {
          const Slot own = this->Faces.Numbers[s];
          return own != vtkPointSplatNeighbors::None && own >= first && !this->Faces.Sound[own] &&
            (stage == Ends) != (rows[own - first] != 0);
        }))
    {
      return false;
    }
    for (std::size_t own = 0; own < strips.size(); ++own)
    {
      this->Faces.Sound[first + own] |= strips[own];
    }
    std::copy(planes.begin(), planes.end(), this->Faces.Strips.begin() + std::size_t(3) * first);
  }
  return true;
}

VTK_ABI_NAMESPACE_END
