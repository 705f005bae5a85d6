// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatHierarchy.h"

#include "vtkPointSplatMoments.h"

#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Points that a splat of level 1 stands for, about.
constexpr double PointsPerSplat = 4.0;
// Splats of the coarsest level, about: so many cells are worked on in parallel.
constexpr double CoarsestSplats = 256.0;
// Cells of more points than this are divided at the median of a sample.
constexpr size_t MostExact = 4096;
constexpr size_t SampleSize = 255;
// Normals of one sheet: the diagonal of the box about them. Those 74 degrees apart have 1.2.
constexpr double SheetNormals = 1.2;
// Of points without a gap: their box' longest side, in roots of the sum of squared radii. A square
// patch, whose points' disks just cover it, has 1.4.
constexpr double SheetLength = 3.0;
constexpr float NormalScale = 127.0f;
}

/// A point as it is sorted.
struct vtkPointSplatHierarchy::Item
{
  float Position[3];
  float Radius;
  signed char Normal[4];
  Index Id;
};

class vtkPointSplatHierarchy::Builder
{
public:
  Builder(const Source& source, bool ellipses)
    : From(source)
    , Ellipses(ellipses)
  {
  }

  std::vector<Item> Items;
  std::vector<std::vector<Splat>> Levels;

  void Read(const std::vector<Index>& ends);
  bool Build(const std::function<bool(double)>& progress);

private:
  /// What lies about a run of items.
  struct Extent
  {
    float Low[3];
    float High[3];
    int LowNormal[3];
    int HighNormal[3];
    double Area;

    int GetLongest() const;
    double GetLength(int k) const { return double(this->High[k]) - this->Low[k]; }
    double GetNormals() const;
    bool IsSheet(size_t count) const;
  };
  /// A run of items that is worked on by itself.
  struct Cell
  {
    size_t Begin;
    size_t End;
    int Depth;
    int Cut;
    std::vector<std::vector<Splat>> Levels;
  };

  void ChooseLevels();
  std::vector<Cell> MakeCells();
  /// whole: with normals and area, of which a cell that is only divided needs none.
  Extent Measure(size_t begin, size_t end, bool whole) const;
  size_t SplitInHalves(size_t begin, size_t end, const Extent& extent);
  size_t SplitSheets(size_t begin, size_t end, const Extent& extent);
  vtkPointSplatMoments Divide(
    size_t begin, size_t end, int top, int depth, int cut, Cell& cell);
  vtkPointSplatMoments Sum(size_t begin, size_t end) const;
  void Emit(int level, const std::array<size_t, 2>& below, const vtkPointSplatMoments& moments,
    int cut, Cell& cell);
  void Join(std::vector<Cell>& cells);

  const Source& From;
  bool Ellipses;
  std::vector<double> Caps; // of each level, the most points of a splat
  std::vector<size_t> Ends; // of the parts, in Items
};

//------------------------------------------------------------------------------
vtkPointSplatHierarchy::Source::~Source() = default;

//------------------------------------------------------------------------------
int vtkPointSplatHierarchy::Builder::Extent::GetLongest() const
{
  int longest = 0;
  for (int k = 1; k < 3; ++k)
  {
    longest = this->GetLength(k) > this->GetLength(longest) ? k : longest;
  }
  return longest;
}

//------------------------------------------------------------------------------
double vtkPointSplatHierarchy::Builder::Extent::GetNormals() const
{
  double squares = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double length = (this->HighNormal[k] - this->LowNormal[k]) / NormalScale;
    squares += length * length;
  }
  return std::sqrt(squares);
}

//------------------------------------------------------------------------------
bool vtkPointSplatHierarchy::Builder::Extent::IsSheet(size_t count) const
{
  // Of points without sizes nothing is known of gaps.
  return count < 2 ||
    (this->GetNormals() <= SheetNormals &&
      (this->Area <= 0.0 ||
        this->GetLength(this->GetLongest()) <= SheetLength * std::sqrt(this->Area)));
}

//------------------------------------------------------------------------------
void vtkPointSplatHierarchy::Builder::Read(const std::vector<Index>& ends)
{
  this->Items.resize(ends.empty() ? 0 : ends.back());
  constexpr Index none = std::numeric_limits<Index>::max();
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Items.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      Item& item = this->Items[static_cast<size_t>(i)];
      Point point;
      item.Id = this->From.Read(static_cast<Index>(i), point) ? static_cast<Index>(i) : none;
      for (int k = 0; k < 3 && item.Id != none; ++k)
      {
        item.Position[k] = point.Position[k];
        item.Normal[k] = static_cast<signed char>(std::lround(NormalScale * point.Normal[k]));
      }
      item.Normal[3] = 0;
      item.Radius = point.Radius;
    }
  });
  this->Items.erase(std::remove_if(this->Items.begin(), this->Items.end(),
                      [](const Item& item) { return item.Id == none; }),
    this->Items.end());
  for (const Index end : ends)
  {
    const auto found = std::lower_bound(this->Items.begin(), this->Items.end(), end,
      [](const Item& item, Index id) { return item.Id < id; });
    this->Ends.push_back(static_cast<size_t>(found - this->Items.begin()));
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatHierarchy::Builder::ChooseLevels()
{
  // Halving n points gives cells of n / 2^k: bounds on their numbers lie in the middle between two.
  const double n = static_cast<double>(this->Items.size());
  this->Caps.assign(1, 1.0);
  if (n < CoarsestSplats)
  {
    return;
  }
  const double halvings = std::round(std::log2(n / PointsPerSplat));
  double cap = std::sqrt(2.0) * n / std::exp2(halvings);
  for (; cap < 2.0 * n / CoarsestSplats; cap *= 4.0)
  {
    this->Caps.push_back(cap);
  }
}

//------------------------------------------------------------------------------
vtkPointSplatHierarchy::Builder::Extent vtkPointSplatHierarchy::Builder::Measure(
  size_t begin, size_t end, bool whole) const
{
  constexpr float most = std::numeric_limits<float>::max();
  Extent x{ { most, most, most }, { -most, -most, -most }, { 127, 127, 127 },
    { -127, -127, -127 }, 0.0 };
  for (size_t i = begin; i < end; ++i)
  {
    const Item& item = this->Items[i];
    for (int k = 0; k < 3; ++k)
    {
      x.Low[k] = std::min(x.Low[k], item.Position[k]);
      x.High[k] = std::max(x.High[k], item.Position[k]);
    }
  }
  for (size_t i = begin; whole && i < end; ++i)
  {
    const Item& item = this->Items[i];
    for (int k = 0; k < 3; ++k)
    {
      x.LowNormal[k] = std::min<int>(x.LowNormal[k], item.Normal[k]);
      x.HighNormal[k] = std::max<int>(x.HighNormal[k], item.Normal[k]);
    }
    x.Area += double(item.Radius) * item.Radius;
  }
  return x;
}

//------------------------------------------------------------------------------
size_t vtkPointSplatHierarchy::Builder::SplitInHalves(
  size_t begin, size_t end, const Extent& extent)
{
  const int k = extent.GetLongest();
  const auto first = this->Items.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = this->Items.begin() + static_cast<std::ptrdiff_t>(end);
  const size_t count = end - begin;
  if (count > MostExact)
  {
    std::array<float, SampleSize> sample;
    for (size_t i = 0; i < SampleSize; ++i)
    {
      sample[i] = this->Items[begin + i * (count - 1) / (SampleSize - 1)].Position[k];
    }
    std::nth_element(sample.begin(), sample.begin() + SampleSize / 2, sample.end());
    const float middle = sample[SampleSize / 2];
    const auto cut = std::partition(
      first, last, [k, middle](const Item& item) { return item.Position[k] < middle; });
    const size_t lower = static_cast<size_t>(cut - first);
    if (lower > count / 4 && lower < count - count / 4)
    {
      return begin + lower;
    }
  }
  // Where many lie in one plane, by numbers alone.
  const auto middle = first + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(first, middle, last,
    [k](const Item& a, const Item& b) { return a.Position[k] < b.Position[k]; });
  return begin + count / 2;
}

//------------------------------------------------------------------------------
size_t vtkPointSplatHierarchy::Builder::SplitSheets(size_t begin, size_t end, const Extent& extent)
{
  const auto first = this->Items.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = this->Items.begin() + static_cast<std::ptrdiff_t>(end);
  auto cut = first;
  if (extent.GetNormals() > SheetNormals)
  {
    int k = 0;
    for (int j = 1; j < 3; ++j)
    {
      const int length = extent.HighNormal[j] - extent.LowNormal[j];
      k = length > extent.HighNormal[k] - extent.LowNormal[k] ? j : k;
    }
    const int middle = extent.LowNormal[k] + extent.HighNormal[k];
    cut = std::partition(
      first, last, [k, middle](const Item& item) { return 2 * item.Normal[k] < middle; });
  }
  else
  {
    const int k = extent.GetLongest();
    const double middle = 0.5 * (double(extent.Low[k]) + extent.High[k]);
    cut = std::partition(
      first, last, [k, middle](const Item& item) { return item.Position[k] < middle; });
  }
  return cut == first || cut == last ? this->SplitInHalves(begin, end, extent)
                                     : begin + static_cast<size_t>(cut - first);
}

//------------------------------------------------------------------------------
vtkPointSplatMoments vtkPointSplatHierarchy::Builder::Sum(size_t begin, size_t end) const
{
  vtkPointSplatMoments moments;
  for (size_t i = begin; i < end; ++i)
  {
    Point point;
    this->From.Read(this->Items[i].Id, point);
    moments.Add(point);
  }
  return moments;
}

//------------------------------------------------------------------------------
void vtkPointSplatHierarchy::Builder::Emit(int level, const std::array<size_t, 2>& below,
  const vtkPointSplatMoments& moments, int cut, Cell& cell)
{
  Splat splat;
  const bool ofPoints = level == 1;
  const std::vector<Splat>* splats =
    ofPoints ? nullptr : &cell.Levels[static_cast<size_t>(level) - 2];
  float fallback[3];
  for (int k = 0; k < 3; ++k)
  {
    fallback[k] = ofPoints ? this->Items[below[0]].Normal[k] / NormalScale
                           : (*splats)[below[0]].Normal[k];
  }
  moments.Describe(splat, this->Ellipses, fallback);
  // Those below in terms of the ellipse's axes; their disks are as large as their longer ones.
  double radius = 0.0;
  for (size_t i = below[0]; i < below[1]; ++i)
  {
    const float* p = ofPoints ? this->Items[i].Position : (*splats)[i].Position;
    const float own = ofPoints ? this->Items[i].Radius : (*splats)[i].Radius;
    double squares = 0.0;
    double along = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double offset = double(p[k]) - splat.Position[k];
      squares += offset * offset;
      along += offset * splat.Axis[k];
    }
    const double across = std::sqrt(std::max(0.0, squares - along * along)) / splat.Shorter;
    radius = std::max(radius, std::hypot(along, across) + own / splat.Shorter);
  }
  splat.Radius = static_cast<float>(radius);
  splat.First = static_cast<Index>(below[0]);
  splat.Cut = static_cast<unsigned char>(std::min(cut, 255));
  cell.Levels[static_cast<size_t>(level) - 1].push_back(splat);
}

//------------------------------------------------------------------------------
vtkPointSplatMoments vtkPointSplatHierarchy::Builder::Divide(
  size_t begin, size_t end, int top, int depth, int cut, Cell& cell)
{
  // Splats of the levels first to top are to be made of these items as a whole.
  const size_t count = end - begin;
  const bool small = static_cast<double>(count) <= this->Caps[static_cast<size_t>(top)];
  const Extent extent = this->Measure(begin, end, small);
  const bool sheet = !small || extent.IsSheet(count);
  int first = top + 1;
  while (first > 1 &&
    static_cast<double>(count) <= this->Caps[static_cast<size_t>(sheet ? first - 1 : first - 2)])
  {
    --first;
  }
  std::vector<size_t> below;
  for (int level = first - 1; level < top; ++level)
  {
    below.push_back(level == 0 ? begin : cell.Levels[static_cast<size_t>(level) - 1].size());
  }
  vtkPointSplatMoments moments;
  if (first == 1)
  {
    moments = this->Sum(begin, end);
  }
  else
  {
    const size_t middle = sheet ? this->SplitInHalves(begin, end, extent)
                                : this->SplitSheets(begin, end, extent);
    moments = this->Divide(begin, middle, first - 1, depth + 1, cut, cell);
    moments.Add(this->Divide(middle, end, first - 1, depth + 1, depth, cell));
  }
  for (int level = first; level <= top; ++level)
  {
    const size_t from = below[static_cast<size_t>(level - first)];
    const size_t to = level == 1 ? end : cell.Levels[static_cast<size_t>(level) - 2].size();
    this->Emit(level, { { from, to } }, moments, cut, cell);
  }
  return moments;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatHierarchy::Builder::Cell> vtkPointSplatHierarchy::Builder::MakeCells()
{
  std::vector<Cell> cells;
  size_t begin = 0;
  for (const size_t end : this->Ends)
  {
    if (end > begin)
    {
      cells.push_back({ begin, end, 1, 0, {} });
      begin = end;
    }
  }
  const auto large = [this](const Cell& cell) {
    return static_cast<double>(cell.End - cell.Begin) > this->Caps.back();
  };
  while (std::any_of(cells.begin(), cells.end(), large))
  {
    std::vector<size_t> middles(cells.size(), 0);
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(cells.size()), 1, [&](vtkIdType from, vtkIdType to) {
      for (size_t c = static_cast<size_t>(from); c < static_cast<size_t>(to); ++c)
      {
        const Cell& cell = cells[c];
        middles[c] = large(cell)
          ? this->SplitInHalves(cell.Begin, cell.End, this->Measure(cell.Begin, cell.End, false))
          : 0;
      }
    });
    std::vector<Cell> next;
    for (size_t c = 0; c < cells.size(); ++c)
    {
      const Cell& cell = cells[c];
      if (middles[c] == 0)
      {
        next.push_back(cell);
        continue;
      }
      next.push_back({ cell.Begin, middles[c], cell.Depth + 1, cell.Cut, {} });
      next.push_back({ middles[c], cell.End, cell.Depth + 1, cell.Depth, {} });
    }
    cells = std::move(next);
  }
  return cells;
}

//------------------------------------------------------------------------------
bool vtkPointSplatHierarchy::Builder::Build(const std::function<bool(double)>& progress)
{
  this->ChooseLevels();
  const int top = static_cast<int>(this->Caps.size()) - 1;
  if (top == 0)
  {
    return true;
  }
  std::vector<Cell> cells = this->MakeCells();
  constexpr vtkIdType batches = 16;
  const vtkIdType count = static_cast<vtkIdType>(cells.size());
  for (vtkIdType batch = 0; batch < batches; ++batch)
  {
    if (!progress(0.2 + 0.7 * static_cast<double>(batch) / batches))
    {
      return false;
    }
    vtkPointSplatThreads::For(count * batch / batches, count * (batch + 1) / batches, 1,
      [&](vtkIdType from, vtkIdType to) {
        for (size_t c = static_cast<size_t>(from); c < static_cast<size_t>(to); ++c)
        {
          cells[c].Levels.resize(static_cast<size_t>(top));
          this->Divide(
            cells[c].Begin, cells[c].End, top, cells[c].Depth, cells[c].Cut, cells[c]);
        }
      });
  }
  this->Join(cells);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatHierarchy::Builder::Join(std::vector<Cell>& cells)
{
  this->Levels.resize(this->Caps.size() - 1);
  for (size_t level = 0; level < this->Levels.size(); ++level)
  {
    size_t count = 0;
    for (const Cell& cell : cells)
    {
      count += cell.Levels[level].size();
    }
    this->Levels[level].reserve(count);
  }
  std::vector<size_t> below(this->Levels.size());
  for (Cell& cell : cells)
  {
    // Points are counted through already, the others from the cell's first one on.
    for (size_t level = 0; level < this->Levels.size(); ++level)
    {
      below[level] = level == 0 ? 0 : this->Levels[level - 1].size();
    }
    for (size_t level = 0; level < this->Levels.size(); ++level)
    {
      for (Splat& splat : cell.Levels[level])
      {
        splat.First += static_cast<Index>(below[level]);
        this->Levels[level].push_back(splat);
      }
    }
    cell.Levels.clear();
    cell.Levels.shrink_to_fit();
  }
  // A level that is not much less than the one below it, as of noise, is of no use.
  size_t useful = 0;
  size_t before = this->Items.size();
  while (useful < this->Levels.size() && 5 * this->Levels[useful].size() < 3 * before)
  {
    before = this->Levels[useful].size();
    ++useful;
  }
  this->Levels.resize(useful);
}

//------------------------------------------------------------------------------
bool vtkPointSplatHierarchy::Make(const Source& source, const std::vector<Index>& ends,
  bool ellipses, const std::function<bool(double)>& progress)
{
  this->Order.clear();
  this->Levels.clear();
  this->Blocks.clear();
  this->Roots = 0;
  Builder builder(source, ellipses);
  if (!progress(0.0))
  {
    return false;
  }
  builder.Read(ends);
  if (!builder.Build(progress))
  {
    return false;
  }
  this->Levels = std::move(builder.Levels);
  this->Order.resize(builder.Items.size());
  std::transform(builder.Items.begin(), builder.Items.end(), this->Order.begin(),
    [](const Item& item) { return item.Id; });
  builder.Items = std::vector<Item>();
  return this->MakeBlocks(source, progress);
}

VTK_ABI_NAMESPACE_END
