// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNeighbors.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
struct Item
{
  double X[3];
  vtkIdType Id;
};

struct Gather
{
  template <typename Array>
  void operator()(Array* points, const std::vector<vtkIdType>& ids, vtkPointSplatLargeArray<Item>& items) const
  {
    const auto range = vtk::DataArrayTupleRange<3>(points);
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(ids.size()), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto x = range[ids[i]];
        items[i] = { { static_cast<double>(x[0]), static_cast<double>(x[1]),
                       static_cast<double>(x[2]) },
          ids[i] };
      }
    });
  }
};

void GetBounds(const Item* begin, const Item* end, double bounds[6])
{
  for (int c = 0; c < 3; ++c)
  {
    bounds[c] = bounds[c + 3] = begin->X[c];
  }
  for (const Item* item = begin + 1; item < end; ++item)
  {
    for (int c = 0; c < 3; ++c)
    {
      bounds[c] = std::min(bounds[c], item->X[c]);
      bounds[c + 3] = std::max(bounds[c + 3], item->X[c]);
    }
  }
}

/**
 * Which coordinates are the same: cells of a grid whose spacing is about that of floats as large as the cloud,
 * and so less than a 16th of that of four thousand million points all over it. Few far outliers do not widen it.
 */
class Grid
{
public:
  void Fit(const vtkPointSplatLargeArray<Item>& items)
  {
    const std::size_t stride = std::max<std::size_t>(1, items.size() / MostSamples);
    double side = 0;
    std::vector<double> values;
    for (int c = 0; c < 3; ++c)
    {
      values.clear();
      for (std::size_t i = 0; i < items.size(); i += stride)
      {
        values.push_back(items[i].X[c]);
      }
      const auto low = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
      const auto high = values.begin() + static_cast<std::ptrdiff_t>(3 * values.size() / 4);
      std::nth_element(values.begin(), low, values.end());
      std::nth_element(low, high, values.end());
      side = std::max(side, *high - *low);
    }
    this->PerUnit = side > 0 ? CellsPerSide / side : 0.0;
  }

  /// The cell of a coordinate; itself where there is no grid that holds it.
  double GetCell(double x) const
  {
    const double cell = std::floor(x * this->PerUnit + 0.5);
    return this->PerUnit > 0 && std::isfinite(cell) ? cell : x;
  }

  /// Whether a coordinate's cell is below `cell`, which is another's. What is rounded down is below a whole number
  /// if it was so before.
  bool IsBelow(double x, double cell) const
  {
    const double place = x * this->PerUnit + 0.5;
    return this->PerUnit > 0 && std::isfinite(place) ? place < cell : x < cell;
  }

  void GetCells(const double x[3], double cells[3]) const
  {
    std::transform(x, x + 3, cells, [this](double c) { return this->GetCell(c); });
  }

  bool IsSame(const double a[3], const double b[3]) const
  {
    return std::equal(
      a, a + 3, b, [this](double x, double y) { return this->GetCell(x) == this->GetCell(y); });
  }

private:
  static constexpr std::size_t MostSamples = 4096;
  static constexpr double CellsPerSide = 1 << 21;
  double PerUnit = 0;
};
}

/// Splits the items into leaves: the first levels by tasks side by side, the rest within a task.
struct vtkPointSplatNeighbors::Builder
{
  struct Range
  {
    vtkIdType Begin, End;
  };
  struct Task
  {
    Range Items;
    double Bounds[6];
    int Children = -1; // index of the first of two, -1 for none
    std::vector<Node> Nodes;
    std::vector<Range> Leaves;
  };

  vtkPointSplatLargeArray<Item> Items;
  std::vector<Task> Tasks;
  Grid Places;

  /// Where the items of one range part: all of one place stay on one side.
  vtkIdType Split(const Range& range, const double bounds[6])
  {
    int axis = 0;
    for (int c = 1; c < 3; ++c)
    {
      if (bounds[c + 3] - bounds[c] > bounds[axis + 3] - bounds[axis])
      {
        axis = c;
      }
    }
    Item* begin = this->Items.data() + range.Begin;
    Item* end = this->Items.data() + range.End;
    Item* middle = begin + (end - begin) / 2;
    std::nth_element(
      begin, middle, end, [axis](const Item& a, const Item& b) { return a.X[axis] < b.X[axis]; });
    const double value = this->Places.GetCell(middle->X[axis]);
    // Of the two ways to keep equal coordinates together take one that leaves no side empty.
    Item* cut = value > this->Places.GetCell(bounds[axis])
      ? std::partition(begin, middle,
          [=](const Item& a) { return this->Places.IsBelow(a.X[axis], value); })
      : std::partition(middle, end,
          [=](const Item& a) { return this->Places.GetCell(a.X[axis]) <= value; });
    return cut - this->Items.data();
  }

  bool IsLeaf(const Range& range, const double bounds[6]) const
  {
    return range.End - range.Begin <= LeafSize || this->Places.IsSame(bounds, bounds + 3);
  }

  void Recurse(Task& task, const Range& range)
  {
    const std::size_t index = task.Nodes.size();
    task.Nodes.emplace_back();
    Node& node = task.Nodes.back();
    GetBounds(this->Items.data() + range.Begin, this->Items.data() + range.End, node.Bounds);
    node.Leaf = None;
    if (IsLeaf(range, node.Bounds))
    {
      node.Leaf = static_cast<std::uint32_t>(task.Leaves.size());
      task.Leaves.push_back(range);
    }
    else
    {
      const vtkIdType cut = this->Split(range, node.Bounds);
      this->Recurse(task, { range.Begin, cut });
      this->Recurse(task, { cut, range.End });
    }
    task.Nodes[index].Skip = static_cast<std::uint32_t>(task.Nodes.size());
  }

  void Run()
  {
    const vtkIdType smallest = 4096;
    this->Tasks.resize(1);
    this->Tasks[0].Items = { 0, static_cast<vtkIdType>(this->Items.size()) };
    GetBounds(this->Items.data(), this->Items.data() + this->Items.size(), this->Tasks[0].Bounds);
    std::size_t first = 0;
    for (int level = 0; level < 6; ++level)
    {
      const std::size_t last = this->Tasks.size();
      for (std::size_t t = first; t < last; ++t)
      {
        const Range range = this->Tasks[t].Items;
        if (range.End - range.Begin > smallest && !IsLeaf(range, this->Tasks[t].Bounds))
        {
          this->Tasks[t].Children = static_cast<int>(this->Tasks.size());
          this->Tasks.resize(this->Tasks.size() + 2);
        }
      }
      vtkPointSplatThreads::For(first, last, 1, [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType t = begin; t < end; ++t)
        {
          Task& task = this->Tasks[t];
          if (task.Children >= 0)
          {
            const vtkIdType cut = this->Split(task.Items, task.Bounds);
            Task* child = &this->Tasks[task.Children];
            child[0].Items = { task.Items.Begin, cut };
            child[1].Items = { cut, task.Items.End };
            for (int c = 0; c < 2; ++c)
            {
              GetBounds(this->Items.data() + child[c].Items.Begin,
                this->Items.data() + child[c].Items.End, child[c].Bounds);
            }
          }
        }
      });
      first = last;
    }
    vtkPointSplatThreads::For(0, this->Tasks.size(), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType t = begin; t < end; ++t)
      {
        if (this->Tasks[t].Children < 0)
        {
          this->Recurse(this->Tasks[t], this->Tasks[t].Items);
        }
      }
    });
  }

  /// Strings the tasks' nodes together in depth-first order.
  void Emit(const Task& task, std::vector<Node>& nodes, std::vector<Range>& leaves) const
  {
    const std::size_t index = nodes.size();
    if (task.Children < 0)
    {
      const std::uint32_t leaf = static_cast<std::uint32_t>(leaves.size());
      for (Node node : task.Nodes)
      {
        node.Skip += static_cast<std::uint32_t>(index);
        node.Leaf = node.Leaf == None ? None : node.Leaf + leaf;
        nodes.push_back(node);
      }
      leaves.insert(leaves.end(), task.Leaves.begin(), task.Leaves.end());
      return;
    }
    nodes.emplace_back();
    std::copy(task.Bounds, task.Bounds + 6, nodes.back().Bounds);
    nodes.back().Leaf = None;
    this->Emit(this->Tasks[task.Children], nodes, leaves);
    this->Emit(this->Tasks[task.Children + 1], nodes, leaves);
    nodes[index].Skip = static_cast<std::uint32_t>(nodes.size());
  }
};

void vtkPointSplatNeighbors::Build(vtkDataArray* points, const unsigned char* used)
{
  const vtkIdType numberOfPoints = points->GetNumberOfTuples();
  std::vector<vtkIdType> ids;
  ids.reserve(numberOfPoints);
  for (vtkIdType id = 0; id < numberOfPoints; ++id)
  {
    if (used[id])
    {
      ids.push_back(id);
    }
  }
  this->Nodes.clear();
  this->Leaves = {};
  this->Ids = {};
  this->SlotOfPoint.assign(numberOfPoints, None);
  if (ids.empty())
  {
    return;
  }

  Builder builder;
  builder.Items = vtkPointSplatLargeArray<Item>(ids.size());
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(
        points, Gather{}, ids, builder.Items))
  {
    Gather{}(points, ids, builder.Items);
  }
  builder.Places.Fit(builder.Items);
  builder.Run();
  std::vector<Builder::Range> ranges;
  builder.Emit(builder.Tasks[0], this->Nodes, ranges);

  this->Leaves = vtkPointSplatLargeArray<Leaf>(ranges.size());
  this->Ids = vtkPointSplatLargeArray<vtkIdType>(ranges.size() * LeafSize, -1);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(ranges.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType l = begin; l < end; ++l)
    {
      Item* items = builder.Items.data() + ranges[l].Begin;
      const vtkIdType count = ranges[l].End - ranges[l].Begin;
      std::sort(items, items + count, [](const Item& a, const Item& b) { return a.Id < b.Id; });
      Leaf& leaf = this->Leaves[l];
      const Item* lanes[LeafSize];
      double cells[LeafSize][3];
      leaf.Count = 0;
      for (vtkIdType i = 0; i < count; ++i)
      {
        double cell[3];
        builder.Places.GetCells(items[i].X, cell);
        int lane = 0;
        while (lane < leaf.Count && !std::equal(cell, cell + 3, cells[lane]))
        {
          ++lane;
        }
        const Slot slot = static_cast<Slot>(l * LeafSize + lane);
        if (lane == leaf.Count)
        {
          std::copy(cell, cell + 3, cells[lane]);
          lanes[leaf.Count++] = items + i;
          this->Ids[slot] = items[i].Id;
        }
        this->SlotOfPoint[items[i].Id] = slot;
      }
      // The median, since the box's centre would follow a far outlier and cost the others
      // their precision.
      for (int c = 0; c < 3; ++c)
      {
        double values[LeafSize] = {};
        for (int lane = 0; lane < leaf.Count; ++lane)
        {
          values[lane] = lanes[lane]->X[c];
        }
        std::nth_element(values, values + leaf.Count / 2, values + leaf.Count);
        leaf.Origin[c] = values[leaf.Count / 2];
        float* local = c == 0 ? leaf.X : c == 1 ? leaf.Y : leaf.Z;
        leaf.Bounds[c] = std::numeric_limits<float>::infinity();
        leaf.Bounds[c + 3] = -leaf.Bounds[c];
        for (int lane = 0; lane < LeafSize; ++lane)
        {
          local[lane] = lane < leaf.Count
            ? static_cast<float>(lanes[lane]->X[c] - leaf.Origin[c])
            : std::numeric_limits<float>::infinity();
          if (lane < leaf.Count)
          {
            leaf.Bounds[c] = std::min(leaf.Bounds[c], local[lane]);
            leaf.Bounds[c + 3] = std::max(leaf.Bounds[c + 3], local[lane]);
          }
        }
      }
    }
  });
}

VTK_ABI_NAMESPACE_END
