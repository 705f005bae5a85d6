// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCloud.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatMapper.h"
#include "vtkPointSplatPacking.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
/**
 * For each point the first cell that uses it, or -1. Cells may name points that are not there.
 */
std::vector<vtkIdType> CellsOfPoints(vtkPointSet* data)
{
  std::vector<vtkIdType> cells(static_cast<size_t>(data->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = data->GetNumberOfCells() - 1; c >= 0; --c)
  {
    data->GetCellPoints(c, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType id = ids->GetId(k);
      if (id >= 0 && id < data->GetNumberOfPoints())
      {
        cells[static_cast<size_t>(id)] = c;
      }
    }
  }
  return cells;
}
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatCloud::Block> vtkPointSplatCloud::Gather(vtkDataObject* input)
{
  std::vector<Block> blocks;
  auto add = [&blocks](vtkDataObject* object, unsigned int flatIndex) {
    vtkPointSet* data = vtkPointSet::SafeDownCast(object);
    if (data && data->GetPoints() && data->GetNumberOfPoints() > 0)
    {
      blocks.push_back({ data, flatIndex, 0, 0 });
    }
  };
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      add(it->GetCurrentDataObject(), it->GetCurrentFlatIndex());
    }
  }
  else
  {
    add(input, 0);
  }
  return blocks;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Update(vtkPointSplatMapper* mapper, vtkDataObject* input)
{
  std::vector<Block> blocks = vtkPointSplatCloud::Gather(input);
  vtkMTimeType changed = input ? input->GetMTime() : 0;
  for (const Block& block : blocks)
  {
    changed = std::max(changed, block.Data->GetMTime());
  }
  const bool same = input == this->Input && blocks.size() == this->Blocks.size() &&
    std::equal(blocks.begin(), blocks.end(), this->Blocks.begin(),
      [](const Block& a, const Block& b) { return a.Data == b.Data; });
  // Points that are projected as single pixels need no sizes.
  const bool needSizes = mapper->GetMethod() != vtkPointSplatMapper::IMAGE_SPACE;
  if (!same || changed > this->SplatTime || (needSizes && !this->Sized))
  {
    this->BuildSplats(mapper, blocks, needSizes);
    this->BuildFactors(mapper, blocks);
    this->Input = input;
    this->Blocks = std::move(blocks);
    this->SplatTime.Modified();
  }
  if (std::max<vtkMTimeType>(mapper->GetMTime(), this->SplatTime) > this->ColourTime)
  {
    this->BuildColours(mapper, this->Blocks);
    this->ColourTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildSplats(
  vtkPointSplatMapper* mapper, std::vector<Block>& blocks, bool needSizes)
{
  this->Splats.clear();
  this->Count = 0;
  this->Points = 0;
  this->Skipped = 0;
  this->Order.clear();
  this->GroupStarts.clear();
  this->Circular = true;
  this->Sized = true;
  this->Spacing = 0.0;
  this->MeanCurvature = -1.0;
  this->MedianRadius = this->MaximumRadius = 0.0;
  this->Bounds = { { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };

  std::vector<vtkPointSplatPacking> packings;
  double low[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (const Block& block : blocks)
  {
    packings.push_back(vtkPointSplatPacking::Collect(mapper, block.Data, needSizes));
    this->Circular = this->Circular && !packings.back().Axis1;
    this->Sized = this->Sized && (packings.back().Radius || packings.back().Axis1);
    this->Points += block.Data->GetNumberOfPoints();
    double range[2];
    for (int k = 0; k < 3; ++k)
    {
      // Of finite coordinates: vtkPointSet's own bounds swallow NaN and infinity.
      block.Data->GetPoints()->GetData()->GetFiniteRange(range, k);
      if (range[0] <= range[1])
      {
        low[k] = std::min(low[k], range[0]);
        high[k] = std::max(high[k], range[1]);
      }
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    this->Origin[k] = low[k] <= high[k] ? 0.5 * low[k] + 0.5 * high[k] : 0.0;
  }

  const vtkIdType words = this->Circular ? 8 : 16;
  this->Splats.resize(static_cast<size_t>(words * this->Points));
  std::vector<unsigned char> valid;
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    Block& block = blocks[b];
    const vtkIdType n = block.Data->GetNumberOfPoints();
    block.First = this->Count;
    block.Count = 0;
    const vtkPointSplatPacking& a = packings[b];
    if (!a.Normals || (needSizes && !(a.Radius || a.Axis1)) || a.Normals->GetNumberOfTuples() != n ||
      a.Normals->GetNumberOfComponents() != 3)
    {
      vtkErrorWithObjectMacro(mapper, << "A block of " << n
                                      << " points has no usable normals: give it point normals of "
                                         "3 components, one a point.");
      this->Skipped += n;
      continue;
    }
    valid.assign(static_cast<size_t>(n), 0);
    uint32_t* to = this->Splats.data() + words * this->Count;
    a.Pack(this->Origin, this->Circular, to, valid.data());
    vtkIdType kept = 0;
    for (vtkIdType i = 0; i < n; ++i)
    {
      if (valid[static_cast<size_t>(i)])
      {
        if (kept != i)
        {
          std::copy_n(to + words * i, words, to + words * kept);
        }
        ++kept;
      }
    }
    block.Count = kept;
    this->Count += kept;
    this->Skipped += n - kept;
  }
  this->Splats.resize(static_cast<size_t>(words * this->Count));

  std::vector<float> radii;
  radii.reserve(static_cast<size_t>(this->Count));
  for (vtkIdType i = 0; i < this->Count; ++i)
  {
    const float* splat = reinterpret_cast<const float*>(this->Splats.data() + words * i);
    radii.push_back(splat[3]);
    for (int k = 0; k < 3; ++k)
    {
      const double x = splat[k] + this->Origin[k];
      this->Bounds[2 * k] = i ? std::min(this->Bounds[2 * k], x) : x;
      this->Bounds[2 * k + 1] = i ? std::max(this->Bounds[2 * k + 1], x) : x;
    }
  }
  if (!radii.empty())
  {
    auto middle = radii.begin() + radii.size() / 2;
    std::nth_element(radii.begin(), middle, radii.end());
    this->MedianRadius = *middle;
    this->MaximumRadius = *std::max_element(middle, radii.end());
  }
  if (this->Skipped > 0)
  {
    vtkWarningWithObjectMacro(mapper, << this->Skipped << " of " << this->Points
                                      << " points are not drawn: ghosts, or coordinates, normals "
                                         "or splat sizes that are not finite and not zero.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildColours(
  vtkPointSplatMapper* mapper, const std::vector<Block>& blocks)
{
  this->Colours.clear();
  if (!mapper->GetScalarVisibility())
  {
    return;
  }
  const size_t words = this->GetWordsPerSplat();
  for (const Block& block : blocks)
  {
    int cellFlag = 0;
    vtkSmartPointer<vtkUnsignedCharArray> colours = mapper->MapPointColours(block.Data, cellFlag);
    if (!colours || colours->GetNumberOfComponents() != 4)
    {
      continue;
    }
    if (this->Colours.empty())
    {
      // Blocks without scalars stay white beside those with.
      this->Colours.assign(static_cast<size_t>(this->Count), 0xffffffffu);
    }
    const std::vector<vtkIdType> cells =
      cellFlag == 1 ? CellsOfPoints(block.Data) : std::vector<vtkIdType>();
    const unsigned char* from = colours->GetPointer(0);
    for (vtkIdType i = block.First; i < block.First + block.Count; ++i)
    {
      vtkIdType id = this->Splats[words * static_cast<size_t>(i) + 7];
      if (cellFlag == 1)
      {
        id = cells[static_cast<size_t>(id)];
      }
      if (id >= 0 && id < colours->GetNumberOfTuples())
      {
        std::memcpy(&this->Colours[static_cast<size_t>(i)], from + 4 * id, 4);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildFactors(
  vtkPointSplatMapper* mapper, const std::vector<Block>& blocks)
{
  this->Factors.clear();
  this->FactorCount = 0;
  const size_t words = this->GetWordsPerSplat();
  for (const Block& block : blocks)
  {
    vtkDataArray* factors = block.Data->GetPointData()->GetArray(vtkPointSplatArrays::Shadow);
    const int count = factors ? factors->GetNumberOfComponents() : 0;
    if (factors && factors->GetNumberOfTuples() != block.Data->GetNumberOfPoints())
    {
      vtkErrorWithObjectMacro(mapper, << "The point array " << vtkPointSplatArrays::Shadow
                                      << " has " << factors->GetNumberOfTuples() << " tuples for "
                                      << block.Data->GetNumberOfPoints()
                                      << " points. It is not used: rename or remove it.");
      continue;
    }
    if (count == 0)
    {
      continue;
    }
    if (this->Factors.empty())
    {
      // Blocks without factors stay lit beside those with.
      this->Factors.assign(static_cast<size_t>(this->Count), 0xffffffffu);
    }
    this->FactorCount = std::max(this->FactorCount, std::min(count, 4));
    vtkSMPTools::For(block.First, block.First + block.Count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType id = this->Splats[words * static_cast<size_t>(i) + 7];
        uint32_t& packed = this->Factors[static_cast<size_t>(i)];
        for (int k = 0; k < std::min(count, 4); ++k)
        {
          const double factor = factors->GetComponent(id, k);
          const double lit = factor >= 0.0 ? std::min(factor, 1.0) : factor < 0.0 ? 0.0 : 1.0;
          packed &= ~(255u << (8 * k));
          packed |= static_cast<uint32_t>(std::lround(255.0 * lit)) << (8 * k);
        }
      }
    });
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatCloud::GetGeometryMTime() const
{
  return std::max(this->SplatTime.GetMTime(), this->GroupTime.GetMTime());
}

//------------------------------------------------------------------------------
const vtkPointSplatBatches& vtkPointSplatCloud::GetBatches()
{
  if (this->GetGeometryMTime() > this->BatchTime)
  {
    this->Batches.Make(this->Splats, this->GetWordsPerSplat(), this->Count, this->Order);
    this->BatchTime.Modified();
  }
  return this->Batches;
}

//------------------------------------------------------------------------------
double vtkPointSplatCloud::GetSpacing()
{
  if (this->Spacing > 0.0 || this->Count == 0)
  {
    return this->Spacing;
  }
  // From the surface's area, which is that of the grid cells that it passes through: some
  // ten points each, and by a half more cells than it would fill.
  constexpr double PointsPerCell = 10.0;
  constexpr double CellsPerFilledCell = 1.5;
  constexpr int MostCells = 256;
  // Holes are widest where points are sparsest: the share of the area that may be sparser yet, and
  // the side, in cells, of the blocks that are compared.
  constexpr int CellsPerBlock = 4;
  constexpr double SparserShare = 0.1;
  // By which evenly random points are fewer there by chance alone.
  constexpr double Scatter = 1.4;
  constexpr double LeastPointsPerCell = 0.2;
  double size = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    size = std::max(size, this->Bounds[2 * k + 1] - this->Bounds[2 * k]);
  }
  const int cells = std::clamp(
    static_cast<int>(std::sqrt(static_cast<double>(this->Count) / PointsPerCell)), 1, MostCells);
  const double cell = size / cells;
  if (!(cell > 0.0) || !std::isfinite(cell))
  {
    return 0.0; // all points in one place
  }
  struct Block
  {
    vtkIdType Points = 0;
    vtkIdType Filled = 0;
    double PointsPerCell() const { return static_cast<double>(this->Points) / this->Filled; }
  };
  const auto sizeOf = [](int n) { return static_cast<size_t>(n); };
  const int side = (cells + CellsPerBlock - 1) / CellsPerBlock;
  std::vector<bool> occupied(sizeOf(cells) * sizeOf(cells) * sizeOf(cells), false);
  std::vector<Block> blocks(sizeOf(side) * sizeOf(side) * sizeOf(side));
  const size_t words = this->GetWordsPerSplat();
  vtkIdType filled = 0;
  for (vtkIdType i = 0; i < this->Count; ++i)
  {
    const float* p =
      reinterpret_cast<const float*>(this->Splats.data() + words * static_cast<size_t>(i));
    size_t at = 0;
    size_t of = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double x = (p[k] + this->Origin[k] - this->Bounds[2 * k]) / cell;
      const int c = std::clamp(static_cast<int>(x), 0, cells - 1);
      at = at * sizeOf(cells) + sizeOf(c);
      of = of * sizeOf(side) + sizeOf(c / CellsPerBlock);
    }
    ++blocks[of].Points;
    if (!occupied[at])
    {
      occupied[at] = true;
      ++blocks[of].Filled;
      ++filled;
    }
  }
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [](const Block& block) { return block.Filled == 0; }),
    blocks.end());
  std::sort(blocks.begin(), blocks.end(), [](const Block& a, const Block& b) {
    return a.PointsPerCell() < b.PointsPerCell();
  });
  vtkIdType sparser = 0;
  size_t quantile = 0;
  while (quantile + 1 < blocks.size() &&
    sparser + blocks[quantile].Filled < SparserShare * filled)
  {
    sparser += blocks[quantile++].Filled;
  }
  // Of L points a cell by chance, 1 - exp(-L) of the cells are filled.
  const double found = blocks[quantile].PointsPerCell();
  double sparse = found;
  for (int i = 0; i < 30; ++i)
  {
    sparse = std::max(LeastPointsPerCell, found * (1.0 - std::exp(-sparse)));
  }
  const double mean = static_cast<double>(this->Count) / filled;
  this->Spacing = cell / std::sqrt(CellsPerFilledCell * std::min(mean, Scatter * sparse));
  return this->Spacing;
}

//------------------------------------------------------------------------------
double vtkPointSplatCloud::GetMeanCurvature()
{
  if (this->MeanCurvature >= 0.0)
  {
    return this->MeanCurvature;
  }
  constexpr vtkIdType Sampled = 10000;
  const vtkIdType step = std::max<vtkIdType>(1, this->Count / Sampled);
  double sum = 0.0;
  double magnitudes = 0.0;
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < this->Count && this->Circular; i += step)
  {
    const uint32_t* words = this->Splats.data() + 8 * static_cast<size_t>(i);
    float radius;
    std::memcpy(&radius, words + 3, sizeof(radius));
    if (radius > 0.0f)
    {
      const double curvature = vtkPointSplatPacking::MeanBend(words[6]) / radius;
      sum += curvature;
      magnitudes += std::abs(curvature);
      ++count;
    }
  }
  this->MeanCurvature =
    count > 0 ? 0.5 * (std::abs(sum) + magnitudes) / static_cast<double>(count) : 0.0;
  return this->MeanCurvature;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatCloud::GetMTime() const
{
  return std::max(
    { this->SplatTime.GetMTime(), this->ColourTime.GetMTime(), this->GroupTime.GetMTime() });
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatCloud::Ordered(
  const std::vector<uint32_t>& data, size_t words) const
{
  if (this->Order.empty() || data.empty())
  {
    return data;
  }
  std::vector<uint32_t> ordered(data.size());
  for (size_t i = 0; i < this->Order.size(); ++i)
  {
    std::copy_n(data.begin() + static_cast<long>(words * this->Order[i]), words,
      ordered.begin() + static_cast<long>(words * i));
  }
  return ordered;
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Buffers& vtkPointSplatCloud::Upload(vtkWindow* window)
{
  auto* current = vtkOpenGLRenderWindow::SafeDownCast(window);
  std::unique_ptr<Buffers>& buffers = this->PerWindow[window];
  if (!buffers || !buffers->Context.IsOf(current))
  {
    buffers.reset(new Buffers);
    buffers->Context.Set(current);
    glGenBuffers(1, &buffers->Splats);
    glGenTextures(1, &buffers->SplatTexture);
    glGenBuffers(1, &buffers->Colours);
    glGenBuffers(1, &buffers->Factors);
    glGenBuffers(1, &buffers->Large);
    glGenVertexArrays(1, &buffers->VertexArray);
  }
  if (this->SplatTime > buffers->SplatTime || this->GroupTime > buffers->SplatTime)
  {
    const std::vector<uint32_t> splats = this->Ordered(this->Splats, this->GetWordsPerSplat());
    glBindBuffer(GL_ARRAY_BUFFER, buffers->Splats);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * splats.size()), splats.data(),
      GL_STATIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, buffers->SplatTexture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, buffers->Splats);
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    glBindBuffer(GL_ARRAY_BUFFER, buffers->Large);
    glBufferData(
      GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * (this->Count + 1)), nullptr, GL_DYNAMIC_COPY);
    const std::vector<uint32_t> factors = this->Ordered(this->Factors, 1);
    glBindBuffer(GL_ARRAY_BUFFER, buffers->Factors);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * factors.size()), factors.data(),
      GL_STATIC_DRAW);
    for (GLuint& map : buffers->IdMaps)
    {
      glDeleteBuffers(1, &map);
      map = 0;
    }
    buffers->SplatTime.Modified();
  }
  if (this->ColourTime > buffers->ColourTime || this->GroupTime > buffers->ColourTime)
  {
    const std::vector<uint32_t> colours = this->Ordered(this->Colours, 1);
    glBindBuffer(GL_ARRAY_BUFFER, buffers->Colours);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * colours.size()), colours.data(),
      GL_STATIC_DRAW);
    buffers->ColourTime.Modified();
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return *buffers;
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatCloud::MakeIdMap(IdKind kind) const
{
  std::vector<uint32_t> map(static_cast<size_t>(this->Count));
  const size_t words = this->GetWordsPerSplat();
  for (const Block& block : this->Blocks)
  {
    // A cloud without cells: the cell id that VTK's selections carry is the point's.
    const bool cells = kind == CellIds && block.Data->GetNumberOfCells() > 0;
    const std::vector<vtkIdType> cellOf =
      cells ? CellsOfPoints(block.Data) : std::vector<vtkIdType>();
    for (vtkIdType i = block.First; i < block.First + block.Count; ++i)
    {
      const uint32_t id = this->Splats[words * static_cast<size_t>(i) + 7];
      map[static_cast<size_t>(i)] = kind == CompositeIds ? block.FlatIndex
        : cells ? static_cast<uint32_t>(cellOf[id] < 0 ? 0xffffffffu : cellOf[id])
                : id;
    }
  }
  return map;
}

//------------------------------------------------------------------------------
GLuint vtkPointSplatCloud::UploadIdMap(vtkWindow* window, IdKind kind)
{
  Buffers& buffers = this->Upload(window);
  if (kind != PointIds && !buffers.IdMaps[kind])
  {
    const std::vector<uint32_t> map = this->Ordered(this->MakeIdMap(kind), 1);
    glGenBuffers(1, &buffers.IdMaps[kind]);
    glBindBuffer(GL_ARRAY_BUFFER, buffers.IdMaps[kind]);
    glBufferData(
      GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * map.size()), map.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  return buffers.IdMaps[kind];
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Release(vtkWindow* window)
{
  auto found = this->PerWindow.find(window);
  if (found == this->PerWindow.end())
  {
    return;
  }
  if (found->second->Context.IsOf(vtkOpenGLRenderWindow::SafeDownCast(window)))
  {
    found->second->Delete();
  }
  this->PerWindow.erase(found);
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Buffers::Delete()
{
  const GLuint all[] = { this->Splats, this->Colours, this->Factors, this->Large,
    this->IdMaps[1], this->IdMaps[2] };
  glDeleteBuffers(6, all);
  glDeleteTextures(1, &this->SplatTexture);
  glDeleteVertexArrays(1, &this->VertexArray);
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::~vtkPointSplatCloud()
{
  for (auto& entry : this->PerWindow)
  {
    Buffers& buffers = *entry.second;
    buffers.Context.Use([&buffers] { buffers.Delete(); });
  }
}
