// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMotion.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkPointSplatMotionTurn.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

namespace
{
using namespace vtkPointSplatMotionTurn;

constexpr size_t Words = 8; // of circular splats
constexpr size_t JudgedPoints = size_t(1) << 15;
constexpr vtkIdType LookedAtOnce = vtkIdType(1) << 13; // no threads for less
// Fitted with Testing/Benchmark/moving.py --strain: up to here pictures are as near to the surface's as with new sizes.
constexpr float LargestStrain = 0.2f;
constexpr double MostStrained = 0.01;
// Beside a point, where to look for its neighbours; and how far off these are, in its radii.
constexpr int SortedWindow = 8;
constexpr float FarthestNeighbour = 4.0f;
constexpr float LeastNormalsCosine = 0.5f; // of the angle between neighbours' normals
// Of single points whose neighbours disagree; beyond, they left their surface.
constexpr float LeastStretch = 0.5f;
constexpr float MostStretch = 2.0f;

bool IsGood(float x)
{
  return std::abs(x) <= VTK_FLOAT_MAX; // NaN compares false
}

/// Whether all points can be drawn.
struct Look
{
  template <typename PointArray, typename NormalArray>
  void operator()(PointArray* pointArray, NormalArray* normalArray, vtkDataArray* radii)
  {
    const auto points = vtk::DataArrayTupleRange<3>(pointArray);
    const auto normals = vtk::DataArrayTupleRange<3>(normalArray);
    std::atomic<bool> good{ true };
    vtkPointSplatThreads::For(0, points.size(), LookedAtOnce, [&](vtkIdType begin, vtkIdType end) {
      bool all = true;
      for (vtkIdType i = begin; i < end; ++i)
      {
        float squares = 0.0f;
        for (int k = 0; k < 3; ++k)
        {
          const float n = static_cast<float>(normals[i][k]);
          squares += n * n;
          all = all && IsGood(static_cast<float>(points[i][k]));
        }
        all = all && squares > 0.0f && IsGood(squares);
        if (radii)
        {
          const float radius = static_cast<float>(radii->GetComponent(i, 0));
          all = all && radius > 0.0f && IsGood(radius);
        }
      }
      if (!all)
      {
        good = false;
      }
    });
    this->Good = good;
  }

  bool Good = false;
};
}

/**
 * What came of the parts that a thread moved.
 */
struct vtkPointSplatMotion::Sums
{
  double Stretch = 0.0;
  double Growth = 0.0; // of radii
  float LargestGrowth = 0.0f;
  size_t Count = 0;
  size_t Strained = 0;

  void Add(const Sums& other)
  {
    this->Stretch += other.Stretch;
    this->Growth += other.Growth;
    this->LargestGrowth = std::max(this->LargestGrowth, other.LargestGrowth);
    this->Count += other.Count;
    this->Strained += other.Strained;
  }
};

/**
 * Moves parts, where the arrays' types are known.
 */
class vtkPointSplatMotion::Worker
{
public:
  Worker(vtkPointSplatMotion& motion, Splats& moved)
    : Motion(motion)
    , Rest(motion.Rest.Words.data())
    , RestLines(motion.Rest.Lines.empty() ? nullptr : motion.Rest.Lines.data())
    , Now(moved.Words.data())
    , Lines(moved.Lines.data())
  {
  }

  template <typename PointArray, typename NormalArray>
  void operator()(PointArray* points, NormalArray* normals, const std::vector<uint32_t>& parts,
    vtkDataArray* radii)
  {
    vtkSMPThreadLocal<Sums> sums;
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(parts.size()), 16, [&](vtkIdType begin, vtkIdType end) {
      Anchored anchored;
      Sums& own = sums.Local();
      for (vtkIdType i = begin; i < end; ++i)
      {
        const uint32_t number = parts[static_cast<size_t>(i)];
        const Part& part = this->Motion.Parts[number];
        if (this->Motion.Known[number] == 0)
        {
          this->Motion.FindNeighbours(part);
          this->Motion.Known[number] = 1;
        }
        this->Place(part, points, normals, anchored);
        for (uint32_t k = 0; k < part.Count; ++k)
        {
          this->Move(part, k, anchored, radii, own);
        }
      }
    });
    for (const Sums& own : sums)
    {
      this->All.Add(own);
    }
  }

  Sums All;

private:
  /// The anchors of a part's splats: at rest, and now.
  struct Anchored
  {
    std::vector<glm::vec3> Rest;
    std::vector<glm::vec3> Now;
    std::vector<glm::vec3> Normal; // now

    void Resize(size_t count)
    {
      for (std::vector<glm::vec3>* all : { &this->Rest, &this->Now, &this->Normal })
      {
        all->resize(count);
      }
    }
  };

  template <typename PointArray, typename NormalArray>
  void Place(const Part& part, PointArray* pointArray, NormalArray* normalArray, Anchored& anchored) const
  {
    const auto points = vtk::DataArrayTupleRange<3>(pointArray);
    const auto normals = vtk::DataArrayTupleRange<3>(normalArray);
    const std::array<double, 3>& origin = this->Motion.Origin;
    anchored.Resize(part.Count);
    for (uint32_t k = 0; k < part.Count; ++k)
    {
      const size_t i = part.First + k;
      anchored.Rest[k] = PositionOf(this->Rest + Words * this->Motion.Anchors[i]);
      const vtkIdType id = this->Rest[Words * i + 7];
      const auto point = points[id];
      const auto normal = normals[id];
      glm::vec3 n;
      for (int c = 0; c < 3; ++c)
      {
        anchored.Now[k][c] =
          static_cast<float>(static_cast<double>(point[c]) - origin[static_cast<size_t>(c)]);
        n[c] = static_cast<float>(normal[c]);
      }
      anchored.Normal[k] = n * (1.0f / std::sqrt(glm::dot(n, n)));
    }
  }

  void Move(const Part& part, uint32_t k, const Anchored& anchored, vtkDataArray* radii, Sums& sums) const
  {
    const size_t i = part.First + k;
    const size_t anchor = this->Motion.Anchors[i];
    const uint32_t* own = this->Rest + Words * i;
    uint32_t* to = this->Now + Words * i;
    const Basis old(Decode(this->Rest[Words * anchor + 5]));
    const Basis current(anchored.Normal[k]);
    glm::vec2 product(0.0f); // z' conj(z)
    float squares = 0.0f, newSquares = 0.0f;
    float heights = 0.0f, newHeights = 0.0f, mixed = 0.0f;
    for (int8_t offset : this->Motion.Neighbours[i])
    {
      if (offset == 0)
      {
        break;
      }
      const size_t j = static_cast<size_t>(static_cast<int>(k) + offset);
      const glm::vec3 z = old.In(anchored.Rest[j] - anchored.Rest[k]);
      const glm::vec3 w = current.In(anchored.Now[j] - anchored.Now[k]);
      product += glm::vec2(w.x * z.x + w.y * z.y, w.y * z.x - w.x * z.y);
      squares += z.x * z.x + z.y * z.y;
      newSquares += w.x * w.x + w.y * w.y;
      heights += z.z * z.z;
      newHeights += w.z * w.z;
      mixed += w.z * z.z;
    }
    glm::vec2 turning(1.0f, 0.0f);
    float enlarged = 1.0f;
    if (squares > 0.0f)
    {
      // Squared first, what is as small as atoms in metres would be none, and what is as large as stars infinite.
      const glm::vec2 fitted = product / squares;
      const float stretch = std::sqrt(glm::dot(fitted, fitted));
      const float across = std::max(newSquares - stretch * stretch * squares, 0.0f);
      const float along = newHeights - 2.0f * stretch * mixed + stretch * stretch * heights;
      // NaN compares false. Points that fell on one another have no turn.
      const bool follows = stretch > 0.0f && newSquares > 0.0f &&
        across + along <= LargestStrain * LargestStrain * newSquares;
      turning = follows ? fitted : this->TurnOfOne(i, k, old, current, anchored);
      enlarged = follows ? 1.0f + std::sqrt(across / newSquares) : 1.0f;
      sums.Strained += follows ? 0 : 1;
    }
    else
    {
      // All others lie where it lies: nothing tells whether they will.
      sums.Strained += part.Count > 1 ? 1 : 0;
    }
    const Turn turn(old, current, turning);
    // Points' own splats lie where these are.
    const glm::vec3 p = anchored.Now[k] + turn.Stretch * turn(PositionOf(own) - anchored.Rest[k]);
    std::memcpy(to, anchor == i ? &anchored.Now[k] : &p, sizeof(p));
    to[5] = Code(anchor == i ? anchored.Normal[k] : turn(Decode(own[5])));
    float larger = turn.Stretch * enlarged;
    if (radii)
    {
      larger = static_cast<float>(radii->GetComponent(own[7], 0)) / FloatOf(this->Rest[Words * anchor + 3]);
    }
    to[3] = BitsOf(FloatOf(own[3]) * larger);
    MoveShape(own, this->RestLines ? this->RestLines + 4 * i : nullptr, turn, enlarged, to,
      this->RestLines ? this->Lines + 4 * i : nullptr);
    sums.Stretch += turn.Stretch;
    sums.Growth += radii ? larger : turn.Stretch;
    sums.LargestGrowth = std::max(sums.LargestGrowth, larger);
    ++sums.Count;
  }

  /// Where neighbours disagree, as beside a point that jumped: the turn and stretch of the way to the one whose stretch is the
  /// median, and no stretch where that is none of a surface.
  glm::vec2 TurnOfOne(
    size_t i, uint32_t k, const Basis& old, const Basis& current, const Anchored& anchored) const
  {
    std::array<glm::vec2, MostNeighbours> turns;
    size_t count = 0;
    for (int8_t offset : this->Motion.Neighbours[i])
    {
      const size_t j = static_cast<size_t>(static_cast<int>(k) + offset);
      const glm::vec3 z = old.In(anchored.Rest[j] - anchored.Rest[k]);
      const glm::vec3 w = current.In(anchored.Now[j] - anchored.Now[k]);
      const float squares = z.x * z.x + z.y * z.y;
      if (offset == 0 || !(squares > 0.0f))
      {
        continue;
      }
      glm::vec2 turn = glm::vec2(w.x * z.x + w.y * z.y, w.y * z.x - w.x * z.y) / squares;
      for (size_t n = 0; n < count; ++n)
      {
        if (glm::dot(turn, turn) < glm::dot(turns[n], turns[n]))
        {
          std::swap(turn, turns[n]);
        }
      }
      turns[count++] = turn;
    }
    const glm::vec2 turn = count > 0 ? turns[(count - 1) / 2] : glm::vec2(1.0f, 0.0f);
    const float stretch = std::sqrt(glm::dot(turn, turn));
    return stretch >= LeastStretch && stretch <= MostStretch ? turn
      : stretch > 0.0f && stretch <= VTK_FLOAT_MAX           ? turn / stretch
                                                             : glm::vec2(1.0f, 0.0f);
  }

  vtkPointSplatMotion& Motion;
  const uint32_t* Rest;
  const uint32_t* RestLines; // or null
  uint32_t* Now;
  uint32_t* Lines;
};

//------------------------------------------------------------------------------
void vtkPointSplatMotion::Begin(Splats splats, std::vector<uint32_t> anchors, std::vector<Part> parts)
{
  this->Rest = std::move(splats);
  this->Anchors = std::move(anchors);
  this->Parts = std::move(parts);
  this->Moved.assign(this->Parts.size(), 0);
  this->Known.assign(this->Parts.size(), 0);
  this->Neighbours.assign(this->Anchors.size(), {});
}

//------------------------------------------------------------------------------
void vtkPointSplatMotion::End()
{
  *this = vtkPointSplatMotion();
}

//------------------------------------------------------------------------------
vtkPointSplatMotion::Splats vtkPointSplatMotion::Take()
{
  Splats rest = std::move(this->Rest);
  this->End();
  return rest;
}

//------------------------------------------------------------------------------
void vtkPointSplatMotion::FindNeighbours(const Part& part)
{
  const uint32_t* rest = this->Rest.Words.data();
  const int count = static_cast<int>(part.Count);
  std::vector<glm::vec3> positions(part.Count);
  std::vector<glm::vec3> normals(part.Count);
  for (uint32_t k = 0; k < part.Count; ++k)
  {
    const uint32_t* anchor = rest + Words * this->Anchors[part.First + k];
    positions[k] = PositionOf(anchor);
    normals[k] = Decode(anchor[5]);
  }
  for (int k = 0; k < count; ++k)
  {
    const size_t own = static_cast<size_t>(k);
    const float radius = FloatOf(rest[Words * (part.First + own) + 3]);
    const float far = radius > 0.0f ? FarthestNeighbour * FarthestNeighbour * radius * radius : VTK_FLOAT_MAX;
    std::array<int8_t, MostNeighbours>& nearest = this->Neighbours[part.First + own];
    std::array<float, MostNeighbours> distances;
    distances.fill(VTK_FLOAT_MAX);
    int8_t any = 0; // the nearest of all, where none is such a neighbour: how all turns it tells as well
    float least = VTK_FLOAT_MAX;
    for (int other = std::max(k - SortedWindow, 0); other <= std::min(k + SortedWindow, count - 1); ++other)
    {
      const glm::vec3 d = positions[static_cast<size_t>(other)] - positions[own];
      float squares = glm::dot(d, d);
      int8_t offset = static_cast<int8_t>(other - k);
      if (!(squares > 0.0f))
      {
        continue;
      }
      any = squares < least ? offset : any;
      least = std::min(least, squares);
      if (squares > far || glm::dot(normals[own], normals[static_cast<size_t>(other)]) < LeastNormalsCosine)
      {
        continue;
      }
      // Insertion into the few that are nearest.
      for (size_t n = 0; n < MostNeighbours; ++n)
      {
        if (squares < distances[n])
        {
          std::swap(squares, distances[n]);
          std::swap(offset, nearest[n]);
        }
      }
    }
    nearest[0] = nearest[0] == 0 ? any : nearest[0];
  }
}

//------------------------------------------------------------------------------
vtkPointSplatMotion::Outcome vtkPointSplatMotion::MoveTo(
  std::vector<Block> blocks, const std::array<double, 3>& origin, Splats& moved)
{
  this->Blocks = std::move(blocks);
  this->Origin = origin;
  std::fill(this->Moved.begin(), this->Moved.end(), 0);
  moved.Words.resize(this->Rest.Words.size());
  moved.Lines.resize(this->Rest.Lines.size());
  using Reals = vtkArrayDispatch::Reals;
  using Dispatcher = vtkArrayDispatch::Dispatch2ByValueType<Reals, Reals>;
  for (Block& block : this->Blocks)
  {
    Look look;
    if (!Dispatcher::Execute(block.Points.Get(), block.Normals.Get(), look, block.Radii.Get()))
    {
      look(block.Points.Get(), block.Normals.Get(), block.Radii.Get());
    }
    if (!look.Good)
    {
      return Outcome();
    }
    block.Count = block.Points->GetNumberOfTuples();
  }
  std::vector<uint32_t> some;
  const size_t step = std::max<size_t>(1, this->Rest.Words.size() / Words / JudgedPoints);
  for (size_t part = 0; part < this->Parts.size(); part += step)
  {
    if (this->Parts[part].OfPoints)
    {
      some.push_back(static_cast<uint32_t>(part));
    }
  }
  const Sums sums = this->MoveParts(some, moved);
  const double count = static_cast<double>(std::max<size_t>(sums.Count, 1));
  Outcome outcome;
  outcome.Followed = static_cast<double>(sums.Strained) <= MostStrained * count;
  outcome.Stretch = sums.Stretch / count;
  outcome.Growth = sums.Growth / count;
  outcome.LargestGrowth = sums.LargestGrowth;
  return outcome;
}

//------------------------------------------------------------------------------
void vtkPointSplatMotion::Move(const std::vector<uint32_t>& parts, Splats& moved)
{
  std::vector<uint32_t> missing;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(missing),
    [this](uint32_t part) { return this->Moved[part] == 0; });
  this->MoveParts(missing, moved);
  for (uint32_t part : missing)
  {
    this->Moved[part] = 1;
  }
}

//------------------------------------------------------------------------------
vtkPointSplatMotion::Sums vtkPointSplatMotion::MoveParts(
  const std::vector<uint32_t>& parts, Splats& moved)
{
  using Reals = vtkArrayDispatch::Reals;
  using Dispatcher = vtkArrayDispatch::Dispatch2ByValueType<Reals, Reals>;
  Worker worker(*this, moved);
  // Block by block: there may be thousands of both.
  std::vector<uint32_t> sorted = parts;
  std::stable_sort(sorted.begin(), sorted.end(),
    [this](uint32_t a, uint32_t b) { return this->Parts[a].Block < this->Parts[b].Block; });
  for (auto first = sorted.begin(), last = first; first != sorted.end(); first = last)
  {
    const uint32_t number = this->Parts[*first].Block;
    last = std::find_if(first, sorted.end(),
      [this, number](uint32_t part) { return this->Parts[part].Block != number; });
    const Block& block = this->Blocks[number];
    const std::vector<uint32_t> own(first, last);
    // Arrays that were shortened since, without a word, are for the next update to see.
    if (block.Points->GetNumberOfTuples() < block.Count ||
      block.Normals->GetNumberOfTuples() < block.Count ||
      (block.Radii && block.Radii->GetNumberOfTuples() < block.Count))
    {
      continue;
    }
    if (!Dispatcher::Execute(block.Points.Get(), block.Normals.Get(), worker, own, block.Radii.Get()))
    {
      worker(block.Points.Get(), block.Normals.Get(), own, block.Radii.Get());
    }
  }
  return worker.All;
}
