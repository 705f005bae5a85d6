// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfaceScatterField.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkPointSplatCholesky.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatThreads.h"

#include <array>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Slot = vtkPointSplatNeighbors::Slot;
using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

/// A sample hides another one behind it if their angle at it is this (cosine) less than right;
/// not 0, so that a grid's diagonals are hidden however it is rounded.
constexpr float HidingTolerance = 1e-3f;
/// Directions are open where no sample is within this cosine.
constexpr float OpenCosine = 0.2f;
/// The part of the neighbours, by rank, that a fit's weight in the field reaches.
constexpr double ReachRank = 0.5;
/// As many neighbours measure the spacing, ...
constexpr int SpacingRank = 26;
/// ... and tell whether a position is surrounded.
constexpr std::size_t SurroundingRank = 32;
/// Samples whose leaf has no isovalue within so many diagonals of its box are not looked at;
/// SpacingRank neighbours are within about half of that.
constexpr double QuietDiagonals = 0.75;
/// Penalties of the fit, in the sum of its weights, in units of the neighbours' farthest distance.
constexpr double LinearPenalty = 1e-7;
constexpr double QuadraticPenalty = 1e-4;

/// The directions of a cube's faces, edges and corners.
struct Directions
{
  static constexpr int Number = 26;
  static constexpr unsigned int All = (1u << Number) - 1;
  std::array<std::array<float, 3>, Number> Units;

  Directions()
  {
    int d = 0;
    for (int code = 0; code < 27; ++code)
    {
      const int v[3] = { code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1 };
      if (code != 13)
      {
        const float length = std::sqrt(static_cast<float>(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
        this->Units[d++] = { { v[0] / length, v[1] / length, v[2] / length } };
      }
    }
  }

  static const Directions& Get()
  {
    static const Directions directions;
    return directions;
  }
};

/// The directions in which no offset points, one bit each.
unsigned int GetOpen(const float* x, const float* y, const float* z, const float* squared,
  int count, unsigned int among = Directions::All)
{
  for (int d = 0; d < Directions::Number; ++d)
  {
    const auto& u = Directions::Get().Units[d];
    for (int i = 0; i < count && (among >> d & 1u); ++i)
    {
      const float along = u[0] * x[i] + u[1] * y[i] + u[2] * z[i];
      if (along > 0 && along * along > OpenCosine * OpenCosine * squared[i])
      {
        among &= ~(1u << d);
      }
    }
  }
  return among;
}

int CountWithin(const Neighborhood& around, float limit)
{
  return static_cast<int>(
    std::upper_bound(around.SquaredDistance, around.SquaredDistance + around.Count, limit) -
    around.SquaredDistance);
}

struct ReadWorker
{
  template <typename Array>
  void operator()(Array* scalars, int component, std::vector<double>& all) const
  {
    const auto range = vtk::DataArrayTupleRange(scalars);
    vtkPointSplatThreads::For(0, range.size(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        all[id] = static_cast<double>(range[id][component]);
      }
    });
  }
};
}

vtkIsosurfaceScatterField::Skipped vtkIsosurfaceScatterField::SetSamples(
  vtkDataArray* points, vtkDataArray* scalars, int component, const unsigned char* ghosts)
{
  Skipped skipped;
  const vtkIdType number = points->GetNumberOfTuples();
  std::vector<unsigned char> used(number);
  std::vector<double> values(number);
  vtkPointSplatInput::MarkFinite(points, used);
  vtkPointSplatInput::Dispatch<ReadWorker>(scalars, component, values);
  vtkIdType count = 0;
  for (vtkIdType id = 0; id < number; ++id)
  {
    if (ghosts && (ghosts[id] & vtkDataSetAttributes::HIDDENPOINT))
    {
      used[id] = 0;
      ++skipped.Hidden;
    }
    else if (!used[id])
    {
      ++skipped.Points;
    }
    else if (!std::isfinite(values[id]))
    {
      used[id] = 0;
      ++skipped.Values;
    }
    count += used[id];
  }
  this->Ghosts = ghosts;
  this->Neighbors.Build(points, used.data());
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Values.assign(slots, 0.0);
  this->NumberOfSamples = 0;
  for (Slot slot = 0; slot < slots; ++slot)
  {
    const vtkIdType id = this->Neighbors.GetId(slot);
    if (id >= 0)
    {
      this->Values[slot] = values[id];
      ++this->NumberOfSamples;
    }
  }
  skipped.Duplicates = count - this->NumberOfSamples;
  return skipped;
}

/// Marks samples whose leaf has an isovalue within `diagonals` of its box, and not less than `least`.
template <typename Classifier>
void vtkIsosurfaceScatterField::MarkLeaves(const Classifier& getClass, double diagonals,
  double least, std::vector<unsigned char>& marks) const
{
  struct Range
  {
    std::ptrdiff_t Low = std::numeric_limits<std::ptrdiff_t>::max(), High = -1;
  };
  const Slot size = vtkPointSplatNeighbors::LeafSize;
  const vtkIdType leaves = this->Neighbors.GetNumberOfSlots() / size;
  std::vector<Range> ranges(leaves);
  vtkPointSplatThreads::For(0, leaves, [&](vtkIdType begin, vtkIdType end) {
    for (Slot slot = static_cast<Slot>(begin) * size; slot < static_cast<Slot>(end) * size; ++slot)
    {
      if (this->Neighbors.GetId(slot) >= 0)
      {
        Range& range = ranges[slot / size];
        const std::ptrdiff_t sampleClass = getClass(this->Values[slot]);
        range.Low = std::min(range.Low, sampleClass);
        range.High = std::max(range.High, sampleClass);
      }
    }
  });
  vtkPointSplatThreads::For(0, leaves, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType l = begin; l < end; ++l)
    {
      const Slot leaf = static_cast<Slot>(l);
      int count;
      const double distance = std::max(diagonals * this->Neighbors.GetDiagonal(leaf, count), least);
      // The size of a leaf of few does not tell how far their neighbours are.
      bool quiet = 2 * count >= vtkPointSplatNeighbors::LeafSize && ranges[l].Low == ranges[l].High;
      if (quiet)
      {
        this->Neighbors.VisitLeaves(leaf, distance, [&](Slot other) {
          return quiet = ranges[other].Low == ranges[l].Low && ranges[other].High == ranges[l].Low;
        });
      }
      for (Slot slot = leaf * size; slot < (leaf + 1) * size; ++slot)
      {
        marks[slot] = !quiet && this->Neighbors.GetId(slot) >= 0;
      }
    }
  });
}

bool vtkIsosurfaceScatterField::Connect(vtkAlgorithm* self, double from, double to,
  const std::vector<double>& isovalues, int k, double radius)
{
  const bool byRadius = radius > 0;
  const float limit = byRadius
    ? static_cast<float>(std::min(radius * radius, 0.99 * VTK_FLOAT_MAX))
    : std::numeric_limits<float>::max();
  // Fourfold in the next round, which is as many as there can be.
  const int first = byRadius ? vtkPointSplatNeighbors::MaximumNumberOfNeighbors / 4 : k;
  auto getClass = [&isovalues](double value) {
    return std::upper_bound(isovalues.begin(), isovalues.end(), value) - isovalues.begin();
  };

  // Where whole leaves around have values on one side there is no need to look at each.
  std::vector<unsigned char> beside(this->Values.size(), 0);
  this->MarkLeaves(getClass, QuietDiagonals * std::cbrt(static_cast<double>(first) / SpacingRank),
    byRadius ? radius : 0, beside);
  auto mark = [&](const Neighborhood& around, int round) {
    const int count = CountWithin(around, limit);
    double low = this->Values[around.Center], high = low;
    for (int i = 0; i < count; ++i)
    {
      low = std::min(low, this->Values[around.Slots[i]]);
      high = std::max(high, this->Values[around.Slots[i]]);
    }
    beside[around.Center] = getClass(low) != getClass(high);
    const bool enough = byRadius
      ? count < around.Count
      : !GetOpen(around.X, around.Y, around.Z, around.SquaredDistance, count);
    return beside[around.Center] || enough || round > 0;
  };
  const double middle = 0.5 * (from + to);
  if (!this->Neighbors.Visit(
        self, from, middle, first, mark, [&](Slot slot) { return beside[slot] != 0; }))
  {
    return false;
  }

  this->NodeOf.assign(this->Values.size(), None);
  Node nodes = 0;
  for (std::size_t slot = 0; slot < beside.size(); ++slot)
  {
    if (beside[slot])
    {
      this->NodeOf[slot] = nodes++;
    }
  }
  this->Nodes.assign(nodes, NodeData());
  auto connect = [&](const Neighborhood& around, int round) {
    return this->MakeNode(around, round, limit, this->Nodes[this->NodeOf[around.Center]]) ||
      (byRadius && round == 1);
  };
  if (!this->Neighbors.Visit(
        self, middle, to, first, connect, [&](Slot slot) { return beside[slot] != 0; }))
  {
    return false;
  }
  // A sparse sample sees dense ones that do not see it.
  for (const NodeData& node : this->Nodes)
  {
    for (const Slot slot : node.Links)
    {
      if (this->NodeOf[slot] != None)
      {
        std::vector<Slot>& back = this->Nodes[this->NodeOf[slot]].Links;
        if (std::find(back.begin(), back.end(), node.Center) == back.end())
        {
          back.push_back(node.Center);
        }
      }
    }
  }
  return true;
}

/// True if more neighbours are not needed.
bool vtkIsosurfaceScatterField::MakeNode(
  const Neighborhood& around, int round, float limit, NodeData& node) const
{
  const int count = CountWithin(around, limit);
  const bool surrounded =
    !GetOpen(around.X, around.Y, around.Z, around.SquaredDistance, count);
  const bool all = count < around.Count;
  // More neighbours than needed would only blur the fit.
  if (round == 0 || (surrounded && !node.Surrounded) || (limit < VTK_FLOAT_MAX && round == 1))
  {
    this->MakeFit(around, count, node);
    node.Surrounded = surrounded;
  }
  if (round < 2)
  {
    node.Links.clear();
  }
  Link(around, count, node.Links);
  return all || round == 2 || node.Surrounded;
}

/// Adds those that are not hidden.
void vtkIsosurfaceScatterField::Link(
  const Neighborhood& around, int count, std::vector<Slot>& links)
{
  const float *x = around.X, *y = around.Y, *z = around.Z, *squared = around.SquaredDistance;
  for (int j = 0; j < count; ++j)
  {
    bool hidden = false;
    for (int k = 0; k < j && !hidden; ++k)
    {
      hidden = squared[k] - (x[k] * x[j] + y[k] * y[j] + z[k] * z[j]) <=
        HidingTolerance * squared[j];
    }
    if (!hidden && std::find(links.begin(), links.end(), around.Slots[j]) == links.end())
    {
      links.push_back(around.Slots[j]);
    }
  }
}

void vtkIsosurfaceScatterField::MakeFit(
  const Neighborhood& around, int count, NodeData& node) const
{
  node.Center = around.Center;
  this->GetPosition(around.Center, node.Position);
  node.Near.assign(around.Slots, around.Slots + count);
  node.Usable = false;
  std::fill(node.Fit, node.Fit + Terms, 0.0);
  if (count == 0)
  {
    return;
  }
  const int rank = std::min(count, SpacingRank);
  node.Spacing = static_cast<float>(
    std::sqrt(around.SquaredDistance[rank - 1]) * std::cbrt(4 * vtkMath::Pi() / 3 / rank));
  node.Reach =
    std::sqrt(around.SquaredDistance[static_cast<int>(ReachRank * static_cast<double>(count))]);

  const double farthest = std::sqrt(static_cast<double>(around.SquaredDistance[count - 1]));
  const double own = this->Values[around.Center];
  double matrix[Terms][Terms] = {}, right[Terms] = {}, sum = 1;
  matrix[0][0] = 1; // the sample itself
  for (int i = 0; i < count; ++i)
  {
    const double x = around.X[i] / farthest, y = around.Y[i] / farthest,
                 z = around.Z[i] / farthest;
    const double falling = 1 - 0.9 * (x * x + y * y + z * z);
    const double weight = falling * falling;
    const double terms[Terms] = { 1, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z };
    const double difference = this->Values[around.Slots[i]] - own;
    for (int r = 0; r < Terms; ++r)
    {
      const double weighted = weight * terms[r];
      right[r] += weighted * difference;
      for (int c = 0; c <= r; ++c)
      {
        matrix[r][c] += weighted * terms[c];
      }
    }
    sum += weight;
  }
  for (int r = 1; r < Terms; ++r)
  {
    matrix[r][r] += sum * (r < 4 ? LinearPenalty : QuadraticPenalty);
  }
  if (!vtkPointSplatCholesky::Factor(matrix))
  {
    return;
  }
  vtkPointSplatCholesky::SolveForward(matrix, right);
  vtkPointSplatCholesky::SolveBackward(matrix, right);
  node.Usable = true;
  for (int r = 0; r < Terms; ++r)
  {
    node.Fit[r] = right[r] / (r == 0 ? 1 : r < 4 ? farthest : farthest * farthest);
    node.Usable = node.Usable && std::isfinite(node.Fit[r]);
  }
  if (!node.Usable)
  {
    std::fill(node.Fit, node.Fit + Terms, 0.0);
  }
}

bool vtkIsosurfaceScatterField::IsOwn(Node node) const
{
  return !this->Ghosts ||
    !(this->Ghosts[this->Neighbors.GetId(this->Nodes[node].Center)] &
      vtkDataSetAttributes::DUPLICATEPOINT);
}

void vtkIsosurfaceScatterField::Approach(const double x[3], Node& node) const
{
  auto squared = [x](const double p[3]) {
    const double d[3] = { p[0] - x[0], p[1] - x[1], p[2] - x[2] };
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  };
  double best = squared(this->Nodes[node].Position);
  for (Node from = None; from != node;)
  {
    from = node;
    for (const Slot slot : this->Nodes[from].Near)
    {
      const Node other = this->NodeOf[slot];
      if (other != None)
      {
        const double distance = squared(this->Nodes[other].Position);
        if (distance < best)
        {
          best = distance;
          node = other;
        }
      }
    }
  }
}

bool vtkIsosurfaceScatterField::Evaluate(
  double isovalue, const double x[3], Node node, Value& value) const
{
  double sum = 0, slope[3] = {}, mean = 0, gradient[3] = {}, hessian[6] = {};
  bool below = false, above = false;
  auto add = [&](const NodeData& data) {
    const double d[3] = { x[0] - data.Position[0], x[1] - data.Position[1],
      x[2] - data.Position[2] };
    const double reach = static_cast<double>(data.Reach) * data.Reach;
    const double t = 1 - (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / reach;
    if (!(t > 0) || !data.Usable)
    {
      return;
    }
    const double own = this->Values[data.Center];
    (own >= isovalue ? above : below) = true;
    const double* f = data.Fit;
    const double fitGradient[3] = { f[1] + 2 * f[4] * d[0] + f[7] * d[1] + f[8] * d[2],
      f[2] + 2 * f[5] * d[1] + f[7] * d[0] + f[9] * d[2],
      f[3] + 2 * f[6] * d[2] + f[8] * d[0] + f[9] * d[1] };
    double fit = own - isovalue + f[0];
    for (int c = 0; c < 3; ++c)
    {
      fit += 0.5 * (f[1 + c] + fitGradient[c]) * d[c];
    }
    const double weight = t * t;
    sum += weight;
    mean += weight * fit;
    for (int c = 0; c < 3; ++c)
    {
      const double change = -4 * t * d[c] / reach;
      slope[c] += change;
      gradient[c] += weight * fitGradient[c] + change * fit;
      hessian[c] += 2 * weight * f[4 + c];
    }
    hessian[3] += weight * f[7];
    hessian[4] += weight * f[9];
    hessian[5] += weight * f[8];
  };
  add(this->Nodes[node]);
  for (const Slot slot : this->Nodes[node].Near)
  {
    if (this->NodeOf[slot] != None)
    {
      add(this->Nodes[this->NodeOf[slot]]);
    }
  }
  if (!(sum > 0))
  {
    return false;
  }
  value.Difference = mean / sum;
  for (int c = 0; c < 6; ++c)
  {
    value.Hessian[c] = hessian[c] / sum;
  }
  bool finite = std::isfinite(value.Difference);
  for (int c = 0; c < 3; ++c)
  {
    value.Gradient[c] = (gradient[c] - value.Difference * slope[c]) / sum;
    finite = finite && std::isfinite(value.Gradient[c]);
  }
  // Those linked may be beyond the reach of the weights.
  for (const Slot slot : this->Nodes[node].Links)
  {
    (this->Values[slot] >= isovalue ? above : below) = true;
  }
  value.Straddled = below && above;
  return finite;
}

bool vtkIsosurfaceScatterField::Surrounds(Node node, const double x[3]) const
{
  unsigned int open = Directions::All;
  auto look = [&](const NodeData& data) {
    float offsets[3][SurroundingRank + 1], squared[SurroundingRank + 1];
    const std::size_t count = std::min(data.Near.size(), SurroundingRank);
    for (std::size_t i = 0; i <= count; ++i)
    {
      double p[3];
      this->GetPosition(i < count ? data.Near[i] : data.Center, p);
      squared[i] = 0;
      for (int c = 0; c < 3; ++c)
      {
        offsets[c][i] = static_cast<float>(p[c] - x[c]);
        squared[i] += offsets[c][i] * offsets[c][i];
      }
    }
    open = GetOpen(
      offsets[0], offsets[1], offsets[2], squared, static_cast<int>(count) + 1, open);
  };
  const NodeData& data = this->Nodes[node];
  look(data);
  // Between a dense and a sparse side the sparse ones' neighbours tell more.
  for (std::size_t i = 0; i < data.Links.size() && open; ++i)
  {
    const Node other = this->NodeOf[data.Links[i]];
    if (other != None)
    {
      look(this->Nodes[other]);
    }
  }
  return !open;
}

VTK_ABI_NAMESPACE_END
