// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCloud.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCells.h"
#include "vtkPointSplatCoordinates.h"
#include "vtkPointSplatMorton.h"
#include "vtkPointSplatPacking.h"
#include "vtkPointSplatSpacing.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>

//------------------------------------------------------------------------------
std::vector<vtkPointSplatCloud::Block> vtkPointSplatCloud::Gather(vtkDataObject* input)
{
  std::vector<Block> blocks;
  auto add = [&blocks](vtkDataObject* object, unsigned int flatIndex) {
    vtkPointSet* data = vtkPointSet::SafeDownCast(object);
    if (data && data->GetPoints() && data->GetNumberOfPoints() > 0)
    {
      blocks.push_back({ data, flatIndex, 0, 0, nullptr, nullptr });
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
vtkPointSplatCloud::Key vtkPointSplatCloud::SplatKey(const std::vector<Block>& blocks)
{
  Key key;
  for (const Block& block : blocks)
  {
    key.emplace_back(nullptr, block.FlatIndex);
    vtkPoints* points = block.Data->GetPoints();
    key.emplace_back(points->GetData(), std::max(points->GetMTime(), points->GetData()->GetMTime()));
    vtkPointData* arrays = block.Data->GetPointData();
    const auto add = [&key](vtkDataArray* array) {
      key.emplace_back(array, array ? array->GetMTime() : 0);
    };
    add(arrays->GetNormals());
    add(arrays->GetArray(vtkDataSetAttributes::GhostArrayName()));
    for (const char* name : vtkPointSplatArrays::Geometry)
    {
      add(arrays->GetArray(name));
    }
    // Triangles say how large splats are, and all cells which points are shown.
    for (vtkCellArray* cells : vtkPointSplatCells::GetLists(block.Data))
    {
      if (cells && cells->GetNumberOfCells() > 0)
      {
        key.emplace_back(cells, cells->GetMTime());
      }
    }
    vtkUnsignedCharArray* ghosts = vtkPointSplatCells::GetGhosts(block.Data);
    key.emplace_back(ghosts, ghosts ? ghosts->GetMTime() : 0);
  }
  return key;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Update(const vtkPointSplatCloudInput& input)
{
  std::vector<Block> blocks = vtkPointSplatCloud::Gather(input.Data);
  blocks = vtkPointSplatCloud::VisibleOf(input, std::move(blocks));
  this->Composite = vtkCompositeDataSet::SafeDownCast(input.Data) != nullptr;
  this->Whole = input.Whole;
  this->WholeIds = input.WholeIds;
  Key splatKey = vtkPointSplatCloud::SplatKey(blocks);
  if (!this->AreCopiesSame(blocks) || !this->Follow(input, blocks, splatKey))
  {
    this->Levels.Clear();
    this->Motion.End();
    const bool whole = this->BuildSplats(input, blocks);
    this->Blocks = std::move(blocks);
    // What was aborted is made the next time.
    this->SplatsMadeFrom = whole ? std::move(splatKey) : Key();
    this->StaysFrom = vtkPointSplatCloud::StayingKey(this->Blocks);
    this->SplatTime.Modified();
    this->OrderTime.Modified();
  }
  else
  {
    // The same arrays, perhaps in data sets that are copies.
    for (size_t b = 0; b < blocks.size(); ++b)
    {
      this->Blocks[b].Data = blocks[b].Data;
    }
    if (this->TakeLevels(false) && this->Motion.HasBegun())
    {
      this->MoveTo(this->Blocks);
    }
  }

  Key colourKey{ { nullptr, this->OrderTime.GetMTime() } };
  Key factorKey = colourKey;
  for (const Block& block : this->Blocks)
  {
    int cellFlag = 0;
    vtkAbstractArray* scalars =
      input.FindScalars ? input.FindScalars(block.Data, cellFlag) : nullptr;
    colourKey.emplace_back(scalars, scalars ? scalars->GetMTime() : 0);
    colourKey.emplace_back(nullptr, cellFlag ? block.Data->GetMTime() : 0); // of its cells
    vtkDataArray* factors = block.Data->GetPointData()->GetArray(vtkPointSplatArrays::Shadow);
    factorKey.emplace_back(factors, factors ? factors->GetMTime() : 0);
  }
  auto wanted = [&input] { return input.ColourKey ? input.ColourKey() : std::string(); };
  const bool looks = input.Looks != this->Looks ||
    (this->MixedColours && input.ActorColour != this->ActorColour);
  if (colourKey != this->ColoursMadeFrom || wanted() != this->ColourKey || looks)
  {
    this->Looks = input.Looks;
    this->ActorColour = input.ActorColour;
    this->BuildColours(input);
    this->HasValues()         ? this->Levels.AppendValues(this->Colours)
      : this->HasCellColours() ? this->Levels.AppendFirst(this->Colours)
                               : this->Levels.AppendBytes(this->Colours);
    this->ColourDeviations = this->Levels.MeasureDeviations(this->Colours, this->HasValues());
    this->ColoursMadeFrom = std::move(colourKey);
    this->ColourKey = wanted(); // to map colours may change the lookup table's range
    this->ColourTime.Modified();
  }
  if (factorKey != this->FactorsMadeFrom)
  {
    this->BuildFactors(input.Owner);
    this->Levels.AppendBytes(this->Factors);
    this->FactorDeviations = this->Levels.MeasureDeviations(this->Factors, false);
    this->FactorsMadeFrom = std::move(factorKey);
    this->FactorTime.Modified();
  }
  this->UpdateCoordinates(input);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatCloud::BuildBlock(
  const vtkPointSplatCloudInput& input, Block& block, const vtkPointSplatPacking& packing)
{
  const size_t words = this->GetWordsPerSplat();
  const size_t n = static_cast<size_t>(packing.GetNumberOfPoints());
  if (!packing.Normals || (input.NeedSizes && !(packing.Radius || packing.Axis1)) ||
    static_cast<size_t>(packing.Normals->GetNumberOfTuples()) != n ||
    packing.Normals->GetNumberOfComponents() != 3)
  {
    vtkErrorWithObjectMacro(input.Owner,
      << "A block of " << n
      << " points has no usable normals: give it point normals of 3 components, one a point.");
    this->Skipped += static_cast<vtkIdType>(n);
    return 0;
  }
  std::vector<uint32_t> packed(words * n);
  std::vector<unsigned char> valid(n, 0);
  packing.Pack(this->Origin, this->Circular, packed.data(), valid.data());
  if (!packing.Fill.empty())
  {
    auto fill = std::make_shared<vtkPointSplatFillPoints>();
    fill->Make(block.Data->GetNumberOfPoints(), packing.Fill, packed.data(), words);
    block.Fill = std::move(fill);
  }
  size_t kept = 0;
  for (size_t i = 0; i < n; ++i)
  {
    if (valid[i])
    {
      if (kept != i)
      {
        std::copy_n(packed.data() + words * i, words, packed.data() + words * kept);
      }
      ++kept;
    }
  }
  // Nobody expects to see those that no cell uses.
  this->Skipped += static_cast<vtkIdType>(n - kept) - packing.Unused;
  this->Unused += packing.Unused;
  if (this->Circular && packing.Fold)
  {
    kept = packing.PackFolds(packed, kept);
  }
  // Folds make splats more than points, of this block or of those before.
  this->Splats.resize(
    std::max(this->Splats.size(), words * (static_cast<size_t>(block.First) + kept)));
  const std::vector<uint32_t> order =
    vtkPointSplatMorton(this->Low, this->High).Order(packed.data(), words, kept, this->Origin);
  uint32_t* to = this->Splats.data() + words * static_cast<size_t>(block.First);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(kept), [&](vtkIdType begin, vtkIdType end) {
    for (size_t i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
    {
      std::copy_n(packed.data() + words * order[i], words, to + words * i);
    }
  });
  auto copies = std::make_shared<vtkPointSplatCopies>();
  kept = copies->TakeOut(to, words, kept, block.Data, packing.Clip);
  if (!copies->Get().empty())
  {
    block.Copies = std::move(copies);
  }
  return static_cast<vtkIdType>(kept);
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::BuildSplats(
  const vtkPointSplatCloudInput& input, std::vector<Block>& blocks)
{
  if (vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(input.Owner))
  {
    algorithm->SetAbortExecute(0); // of a time before, as executives do
  }
  this->Splats.clear();
  this->ClipLines.clear();
  this->CopiesToldBy.clear();
  this->Mixed.clear();
  this->ForgetRange();
  this->Count = this->Points = this->Skipped = this->Unused = 0;
  this->Circular = true;
  this->Sized = true;
  this->MayProject = input.ProjectNoise;
  this->MayFill = input.FillGaps;
  this->MayFillMeshes = input.FillMeshGaps;
  this->Projected = false;
  std::vector<vtkPointSplatPacking> packings = this->CollectBlocks(input, blocks);
  if (std::any_of(packings.begin(), packings.end(),
        [](const vtkPointSplatPacking& packing) { return packing.Aborted; }))
  {
    blocks.clear();
    this->Measure();
    return false;
  }
  bool given = !blocks.empty();
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    const vtkPointSplatPacking& packing = packings[b];
    given = given && packing.HasGivenRadii;
    this->Projected = this->Projected || packing.Projected;
    this->Circular = this->Circular && !packing.Axis1;
    this->Sized = this->Sized && (packing.Radius || packing.Axis1);
    this->Points += blocks[b].Data->GetNumberOfPoints();
    this->AddRange(packing.Points);
  }
  this->SetOriginToMiddle();
  this->LeaveOutFar(packings);
  this->Splats.resize(this->GetWordsPerSplat() * static_cast<size_t>(this->Points));
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    blocks[b].First = this->Count;
    blocks[b].Count = this->BuildBlock(input, blocks[b], packings[b]);
    this->BuildClipLines(blocks[b], packings[b]);
    this->NumberFillPoints(blocks[b], packings[b]);
    this->Count += blocks[b].Count;
  }
  this->Splats.resize(this->GetWordsPerSplat() * static_cast<size_t>(this->Count));
  if (!this->ClipLines.empty())
  {
    this->ClipLines.resize(4 * static_cast<size_t>(this->Count), 0u);
  }
  this->Measure();
  if (this->Skipped > 0)
  {
    vtkWarningWithObjectMacro(input.Owner, << this->Skipped << " of " << this->Points
                                           << " points are not drawn: ghosts, or coordinates, "
                                              "normals or splat sizes that are not finite, "
                                              "normals that are zero, sizes that are not "
                                              "positive (estimated ones are zero where no "
                                              "surface lies between points), or points farther "
                                              "off than a million times what the middle half of "
                                              "all spans.");
  }
  if (given && this->Circular)
  {
    this->CheckRadii(input.Owner);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildClipLines(const Block& block, const vtkPointSplatPacking& packing)
{
  if (!packing.HasClipLines())
  {
    return;
  }
  // Blocks without lines stay whole beside those with.
  this->ClipLines.resize(4 * static_cast<size_t>(block.First + block.Count), 0u);
  const size_t first = static_cast<size_t>(block.First);
  packing.PackClipLines(this->Splats.data() + this->GetWordsPerSplat() * first, block.Count,
    this->Circular, this->ClipLines.data() + 4 * first);
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Measure()
{
  this->MedianRadius = this->MaximumRadius = 0.0;
  this->Bounds = { { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
  std::vector<float> radii(static_cast<size_t>(this->Count));
  for (size_t i = 0; i < radii.size(); ++i)
  {
    float splat[4];
    std::memcpy(splat, this->Splats.data() + this->GetWordsPerSplat() * i, sizeof(splat));
    radii[i] = splat[3];
    for (size_t k = 0; k < 3; ++k)
    {
      const double x = splat[k] + this->Origin[k];
      this->Bounds[2 * k] = i ? std::min(this->Bounds[2 * k], x) : x;
      this->Bounds[2 * k + 1] = i ? std::max(this->Bounds[2 * k + 1], x) : x;
    }
  }
  if (!radii.empty())
  {
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    this->MedianRadius = *middle;
    this->MaximumRadius = *std::max_element(middle, radii.end());
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::BuildValues(const vtkPointSplatCloudInput& input)
{
  std::vector<vtkPointSplatValues> all;
  double low = VTK_DOUBLE_MAX;
  double high = -VTK_DOUBLE_MAX;
  for (const Block& block : this->Blocks)
  {
    all.push_back(input.MapValues(block.Data));
    vtkFloatArray* coordinates = all.back().Coordinates;
    if (!coordinates || coordinates->GetNumberOfTuples() < block.Data->GetNumberOfPoints())
    {
      return false;
    }
    double range[2];
    coordinates->GetFiniteRange(range, 0);
    low = std::min(low, range[0]);
    high = std::max(high, range[1]);
  }
  vtkImageData* image = all.empty() ? nullptr : all.back().Table.Get();
  auto colours = image
    ? vtkArrayDownCast<vtkUnsignedCharArray>(image->GetPointData()->GetScalars())
    : nullptr;
  const int entries = image ? image->GetDimensions()[0] : 0;
  if (!colours || colours->GetNumberOfComponents() != 4 ||
    colours->GetNumberOfTuples() < 2 * vtkIdType(entries) || low > high)
  {
    return false;
  }
  // The first row, and one of the second.
  this->ValueTable.resize(static_cast<size_t>(entries) + 1);
  std::memcpy(this->ValueTable.data(), colours->GetPointer(0), 4 * this->ValueTable.size());
  this->ValueScale = { { (high - low) * entries, low * entries } };
  this->Colours.resize(static_cast<size_t>(this->Count));
  const double scale = high > low ? 1.0 / (high - low) : 0.0;
  for (size_t b = 0; b < all.size(); ++b)
  {
    const Block& block = this->Blocks[b];
    const vtkSmartPointer<vtkFloatArray> places = block.OfSplats(all[b].Coordinates.Get());
    const float* from = places->GetPointer(0);
    vtkPointSplatThreads::For(block.First, block.First + block.Count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType number = begin; number < end; ++number)
      {
        const size_t i = this->SplatOf(number);
        const float* at = from + 2 * static_cast<size_t>(this->NumberOf(block, i));
        const float value =
          static_cast<float>(std::clamp((double(at[0]) - low) * scale, 0.0, 1.0));
        // NaN compares false.
        const bool known = value >= 0.0f && at[1] < 0.5f;
        std::memcpy(&this->Colours[i], &value, 4);
        this->Colours[i] = known ? this->Colours[i] : 0x80000000u;
      }
    });
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildFactors(vtkObject* owner)
{
  this->Factors.clear();
  this->FactorCount = 0;
  for (const Block& block : this->Blocks)
  {
    vtkDataArray* factors = block.Data->GetPointData()->GetArray(vtkPointSplatArrays::Shadow);
    const int count = factors ? std::min(factors->GetNumberOfComponents(), 4) : 0;
    if (factors && factors->GetNumberOfTuples() != block.Data->GetNumberOfPoints())
    {
      vtkErrorWithObjectMacro(owner, << "The point array " << vtkPointSplatArrays::Shadow << " has "
                                     << factors->GetNumberOfTuples() << " tuples for "
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
    this->FactorCount = std::max(this->FactorCount, count);
    const vtkSmartPointer<vtkDataArray> extended = block.OfSplats(factors);
    vtkPointSplatThreads::For(block.First, block.First + block.Count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType number = begin; number < end; ++number)
      {
        const size_t i = this->SplatOf(number);
        const vtkIdType id = this->NumberOf(block, i);
        for (int k = 0; k < count; ++k)
        {
          const double factor = extended->GetComponent(id, k);
          const double lit = std::isnan(factor) ? 1.0 : std::clamp(factor, 0.0, 1.0);
          this->Factors[i] &= ~(255u << (8 * k));
          this->Factors[i] |= static_cast<uint32_t>(std::lround(255.0 * lit)) << (8 * k);
        }
      }
    });
  }
}

//------------------------------------------------------------------------------
double vtkPointSplatCloud::GetSpacing()
{
  if (this->SplatTime > this->SpacingTime)
  {
    this->Spacing = this->MeasureSpacing();
    this->SpacingTime.Modified();
  }
  return this->Spacing;
}

//------------------------------------------------------------------------------
double vtkPointSplatCloud::MeasureSpacing() const
{
  const bool rests = this->Motion.HasBegun();
  const std::array<double, 6> bounds = rests ? this->RestingBounds : this->GetLocalBounds();
  double size = 0.0;
  for (size_t k = 0; k < 3; ++k)
  {
    size = std::max(size, bounds[2 * k + 1] - bounds[2 * k]);
  }
  return this->Count > 0
    ? (rests ? this->Stretch : 1.0) *
      vtkPointSplatSpacing::Estimate(this->GetRestingSplats(), this->GetWordsPerSplat(),
        static_cast<size_t>(this->Count), { { bounds[0], bounds[2], bounds[4] } }, size)
    : 0.0;
}

//------------------------------------------------------------------------------
std::array<double, 6> vtkPointSplatCloud::GetLocalBounds() const
{
  std::array<double, 6> bounds = this->Bounds;
  for (size_t k = 0; k < 6; ++k)
  {
    bounds[k] -= this->Origin[k / 2];
  }
  return bounds;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatCloud::GetMTime() const
{
  return std::max({ this->SplatTime.GetMTime(), this->ColourTime.GetMTime(),
    this->FactorTime.GetMTime(), this->CoordinateTime.GetMTime() });
}

//------------------------------------------------------------------------------
const vtkPointSplatBlocks& vtkPointSplatCloud::GetBlocks()
{
  if (this->SplatTime > this->BlockTime)
  {
    this->MoveAll();
    this->SplatBlocks.Make(this->Splats, this->GetWordsPerSplat(), this->Count);
    this->BlockTime.Modified();
  }
  return this->SplatBlocks;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::MakeGroups(const vtkPointSplatGroups::Request& request)
{
  this->MoveAll();
  vtkPointSplatGroups::Splats splats{ this->Splats, this->GetWordsPerSplat(), this->Origin, {} };
  for (const Block& block : this->Blocks)
  {
    splats.Blocks.push_back({ block.Data, block.First, block.Count });
  }
  vtkPointSplatGroups::Request whole = request;
  whole.Alike = !this->HasColours() && !this->HasValues() && this->FactorCount == 0 &&
    !this->HasClipLines() && !this->HasCoordinates();
  return this->Groups.Make(splats, this->SplatTime, whole);
}
