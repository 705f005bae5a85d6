// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPieces.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCells.h"
#include "vtkPointSplatPieceVotes.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <list>
#include <numeric>
#include <utility>

namespace
{
// What a block of points alone does not have, beside sizes.
constexpr const char* Known[] = { vtkPointSplatArrays::Group, vtkPointSplatArrays::Sensor,
  vtkPointSplatArrays::Scan };

constexpr double CellSpacings = 2.0;

bool HasDuplicates(vtkPointSet* data)
{
  vtkUnsignedCharArray* ghosts = vtkPointSplatPacking::GivenGhostsOf(data);
  for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfTuples(); ++i)
  {
    if (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT)
    {
      return true;
    }
  }
  return false;
}

/// Whether nothing is known of the block but points, and perhaps normals.
bool IsPiece(vtkPointSet* data, bool sizes)
{
  vtkPointData* arrays = data->GetPointData();
  vtkDataArray* normals = arrays->GetNormals();
  const bool good = normals ? normals->GetNumberOfComponents() == 3 &&
      normals->GetNumberOfTuples() == data->GetNumberOfPoints()
                            : !data->GetCellData()->GetNormals();
  const auto has = [arrays](const char* name) { return arrays->HasArray(name) != 0; };
  return (sizes || !normals) && good && !vtkPointSplatCells::HasFaces(data) &&
    !data->GetFieldData()->HasArray(vtkPointSplatArrays::Sensor) &&
    std::none_of(std::begin(vtkPointSplatArrays::Geometry), std::end(vtkPointSplatArrays::Geometry), has) &&
    std::none_of(std::begin(Known), std::end(Known), has) &&
    !HasDuplicates(data);
}

/// Of the points whose coordinates can be used.
vtkBoundingBox BoxOf(vtkPointSet* data)
{
  const auto isUsable = [](double x) { return std::abs(x) <= vtkPointSplatPacking::LargestLength; };
  double bounds[6];
  data->GetBounds(bounds);
  if (std::all_of(bounds, bounds + 6, isUsable))
  {
    return vtkBoundingBox(bounds);
  }
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (std::all_of(p, p + 3, isUsable))
    {
      box.AddPoint(p);
    }
  }
  return box;
}

vtkBoundingBox WidenedBoxOf(vtkPointSet* data)
{
  vtkBoundingBox box = BoxOf(data);
  double size[3] = { 0.0, 0.0, 0.0 };
  if (box.IsValid())
  {
    box.GetLengths(size);
    const double area = 2.0 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
    box.Inflate(0.5 * std::sqrt(area / static_cast<double>(data->GetNumberOfPoints())));
  }
  return box;
}

/// An array's tuples of a piece, and of the fill points that are its own.
vtkSmartPointer<vtkDataArray> PartOf(
  vtkDataArray* all, vtkIdType first, vtkIdType count, const std::vector<vtkIdType>& fill)
{
  if (!all)
  {
    return nullptr;
  }
  auto part = vtkSmartPointer<vtkDataArray>::Take(all->NewInstance());
  part->SetName(all->GetName());
  part->SetNumberOfComponents(all->GetNumberOfComponents());
  part->SetNumberOfTuples(count + static_cast<vtkIdType>(fill.size()));
  part->InsertTuples(0, count, first, all);
  for (size_t i = 0; i < fill.size(); ++i)
  {
    part->SetTuple(count + static_cast<vtkIdType>(i), fill[i], all);
  }
  return part;
}

/// The same fill point, of the ends in one piece alone.
vtkPointSplatEstimation::FillPoint PartOf(
  const vtkPointSplatEstimation::FillPoint& whole, vtkIdType first, vtkIdType count)
{
  vtkPointSplatEstimation::FillPoint part = whole;
  part.Count = 0;
  float sum = 0.0f;
  for (int k = 0; k < whole.Count; ++k)
  {
    const vtkIdType end = whole.Ends[k] - first;
    if (end >= 0 && end < count)
    {
      part.Ends[part.Count] = end;
      part.Weights[part.Count++] = whole.Weights[k];
      sum += whole.Weights[k];
    }
  }
  for (int k = 0; k < part.Count; ++k)
  {
    // The nearest end's weight is not zero, but for one end alone.
    part.Weights[k] = sum > 0.0f ? part.Weights[k] / sum : 1.0f / static_cast<float>(part.Count);
  }
  return part;
}

/// All points, normals and ghosts, one block's after the other's.
vtkSmartPointer<vtkPolyData> Append(const std::vector<vtkPointSet*>& blocks, vtkIdType count)
{
  auto all = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  const bool precise = std::any_of(blocks.begin(), blocks.end(),
    [](vtkPointSet* block) { return block->GetPoints()->GetDataType() != VTK_FLOAT; });
  points->SetDataType(precise ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(count);
  vtkDataArray* normals = blocks.front()->GetPointData()->GetNormals();
  vtkSmartPointer<vtkDataArray> allNormals;
  if (normals)
  {
    allNormals.TakeReference(vtkDataArray::CreateDataArray(normals->GetDataType()));
    allNormals->SetName("Normals");
    allNormals->SetNumberOfComponents(3);
    allNormals->SetNumberOfTuples(count);
    all->GetPointData()->SetNormals(allNormals);
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(count);
  ghosts->FillValue(0);
  bool hidden = false;
  vtkIdType first = 0;
  for (vtkPointSet* block : blocks)
  {
    const vtkIdType own = block->GetNumberOfPoints();
    points->InsertPoints(first, own, 0, block->GetPoints());
    if (allNormals)
    {
      allNormals->InsertTuples(first, own, 0, block->GetPointData()->GetNormals());
    }
    if (const vtkSmartPointer<vtkUnsignedCharArray> given = vtkPointSplatPacking::GhostsOf(block))
    {
      ghosts->InsertTuples(first, own, 0, given);
      hidden = true;
    }
    first += own;
  }
  all->SetPoints(points);
  if (hidden)
  {
    all->GetPointData()->AddArray(ghosts);
  }
  return all;
}

/// Sets of numbers from 0 on, each alone at first.
class Unions
{
public:
  explicit Unions(size_t count)
    : Firsts(count)
  {
    std::iota(this->Firsts.begin(), this->Firsts.end(), size_t(0));
  }
  void Join(size_t a, size_t b)
  {
    a = this->FirstOf(a);
    b = this->FirstOf(b);
    this->Firsts[std::max(a, b)] = std::min(a, b);
  }
  /// By their first numbers; ascending.
  std::vector<std::vector<size_t>> GetSets()
  {
    std::vector<std::vector<size_t>> sets;
    std::vector<size_t> numbers(this->Firsts.size());
    for (size_t i = 0; i < this->Firsts.size(); ++i)
    {
      const size_t first = this->FirstOf(i);
      if (first == i)
      {
        numbers[i] = sets.size();
        sets.emplace_back();
      }
      sets[numbers[first]].push_back(i);
    }
    return sets;
  }

private:
  size_t FirstOf(size_t i)
  {
    while (this->Firsts[i] != i)
    {
      i = this->Firsts[i] = this->Firsts[this->Firsts[i]];
    }
    return i;
  }
  std::vector<size_t> Firsts; // towards the first of the same set
};
}

//------------------------------------------------------------------------------
bool vtkPointSplatPieces::MayMix(vtkPointSet* block)
{
  return !vtkPointSplatCells::HasFaces(block) && !block->GetPointData()->HasArray(vtkPointSplatArrays::Group);
}

//------------------------------------------------------------------------------
bool vtkPointSplatPieces::AreMixed(const std::vector<uint32_t>& splats, size_t words,
  const std::vector<uint32_t>& ends, double spacing)
{
  // One cell of CellsApart, with all that is in it.
  constexpr uint64_t CellsApart = 16;
  const double scale = 1.0 / (CellSpacings * spacing);
  std::vector<std::pair<uint64_t, size_t>> found; // cells, and the blocks of their splats
  size_t block = 0;
  for (size_t i = 0; ends.size() > 1 && i < ends.back(); ++i)
  {
    while (i >= ends[block])
    {
      ++block;
    }
    float p[3];
    std::memcpy(p, splats.data() + words * i, sizeof(p));
    uint64_t cell = 0;
    for (float x : p)
    {
      // Multiplied by an odd constant, and its upper half brought down: cells' numbers without order.
      cell = (cell ^ static_cast<uint64_t>(static_cast<int64_t>(std::floor(x * scale)))) * 0x9e3779b97f4a7c15u;
      cell ^= cell >> 32;
    }
    if (cell % CellsApart == 0)
    {
      found.emplace_back(cell, block);
    }
  }
  std::sort(found.begin(), found.end());
  size_t cells = 0;
  size_t mixed = 0;
  for (size_t first = 0, next = 0; first < found.size(); first = next)
  {
    while (next < found.size() && found[next].first == found[first].first)
    {
      ++next;
    }
    // One splat alone tells nothing.
    cells += next - first > 1 ? 1 : 0;
    mixed += found[next - 1].second != found[first].second ? 1 : 0;
  }
  return 2 * mixed > cells;
}

//------------------------------------------------------------------------------
std::vector<std::vector<size_t>> vtkPointSplatPieces::Find(
  const std::vector<vtkPointSet*>& blocks, const vtkPointSplatPacking::Wanted& wanted)
{
  const size_t n = blocks.size();
  std::vector<vtkBoundingBox> boxes(n);
  std::vector<size_t> byLeft;
  for (size_t i = 0; n > 1 && i < n; ++i)
  {
    if (IsPiece(blocks[i], wanted.Sizes))
    {
      boxes[i] = WidenedBoxOf(blocks[i]);
      if (boxes[i].IsValid())
      {
        byLeft.push_back(i);
      }
    }
  }
  std::sort(byLeft.begin(), byLeft.end(), [&boxes](size_t a, size_t b) {
    return boxes[a].GetBound(0) < boxes[b].GetBound(0);
  });
  Unions meeting(n);
  auto hasNormals = [&blocks](size_t i) {
    return blocks[i]->GetPointData()->GetNormals() != nullptr;
  };
  // Sets that still go on to the right, each by one of its blocks and the box about all.
  std::list<std::pair<size_t, vtkBoundingBox>> open;
  for (size_t i : byLeft)
  {
    vtkBoundingBox box = boxes[i];
    for (auto it = open.begin(); it != open.end();)
    {
      const bool past = it->second.GetBound(1) < boxes[i].GetBound(0);
      const bool meets = !past && hasNormals(i) == hasNormals(it->first) && it->second.Intersects(boxes[i]);
      if (meets)
      {
        meeting.Join(i, it->first);
        box.AddBox(it->second);
      }
      it = past || meets ? open.erase(it) : std::next(it);
    }
    open.emplace_back(i, box);
  }
  std::vector<std::vector<size_t>> clouds;
  for (const std::vector<size_t>& met : meeting.GetSets())
  {
    Unions pieces(met.size());
    if (met.size() > 1)
    {
      std::vector<vtkPointSet*> own;
      for (size_t i : met)
      {
        own.push_back(blocks[i]);
      }
      for (const auto& pair : vtkPointSplatPieceVotes(own).Count())
      {
        pieces.Join(pair.first, pair.second);
      }
    }
    for (std::vector<size_t>& cloud : pieces.GetSets())
    {
      for (size_t& i : cloud)
      {
        i = met[i];
      }
      clouds.push_back(std::move(cloud));
    }
  }
  return clouds;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatPacking> vtkPointSplatPieces::Collect(vtkObject* owner,
  const std::vector<vtkPointSet*>& blocks, const vtkPointSplatPacking::Wanted& wanted)
{
  if (blocks.size() == 1)
  {
    return { vtkPointSplatPacking::Collect(owner, blocks.front(), wanted) };
  }
  std::vector<vtkIdType> firsts(1, 0);
  for (vtkPointSet* block : blocks)
  {
    firsts.push_back(firsts.back() + block->GetNumberOfPoints());
  }
  const vtkSmartPointer<vtkPolyData> all = Append(blocks, firsts.back());
  const vtkPointSplatPacking whole = vtkPointSplatPacking::Collect(owner, all, wanted);
  std::vector<std::vector<vtkIdType>> fill(blocks.size());
  for (size_t i = 0; i < whole.Fill.size(); ++i)
  {
    const auto end = std::upper_bound(firsts.begin(), firsts.end(), whole.Fill[i].Ends[0]);
    fill[static_cast<size_t>(end - firsts.begin()) - 1].push_back(
      firsts.back() + static_cast<vtkIdType>(i));
  }
  std::vector<vtkPointSplatPacking> packings(blocks.size());
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    const vtkIdType count = firsts[b + 1] - firsts[b];
    vtkPointSplatPacking& part = packings[b];
    part.Reach = whole.Reach;
    part.Aborted = whole.Aborted;
    part.Projected = whole.Projected;
    part.Ghosts = vtkPointSplatPacking::GhostsOf(blocks[b], &part.Unused);
    for (vtkIdType number : fill[b])
    {
      part.Fill.push_back(
        PartOf(whole.Fill[static_cast<size_t>(number - firsts.back())], firsts[b], count));
    }
    auto take = [&](vtkDataArray* array) { return PartOf(array, firsts[b], count, fill[b]); };
    part.Points = part.Projected || !fill[b].empty()
      ? take(whole.Points)
      : vtkSmartPointer<vtkDataArray>(blocks[b]->GetPoints()->GetData());
    part.Normals = take(whole.Normals);
    part.Radius = take(whole.Radius);
    part.Plane = take(whole.Plane);
    part.Curvature = take(whole.Curvature);
    part.Clip = take(whole.Clip);
    part.Fold = take(whole.Fold);
  }
  return packings;
}
