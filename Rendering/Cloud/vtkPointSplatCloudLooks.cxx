// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: colours, by scalars and by the looks of blocks, texture coordinates, and what is
// kept of hidden blocks.
#include "vtkPointSplatCloud.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatCoordinates.h"
#include "vtkPointSplatPieces.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

//------------------------------------------------------------------------------
vtkPointSplatCloud::Key vtkPointSplatCloud::KeptKey(
  const vtkPointSplatCloudInput& input, const std::vector<Block>& pieces)
{
  Key key = vtkPointSplatCloud::SplatKey(pieces);
  key.emplace_back(nullptr, input.NeedSizes);
  key.emplace_back(nullptr, input.ProjectNoise);
  key.emplace_back(nullptr, input.FillGaps + (input.FillGaps && input.FillMeshGaps));
  return key;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatPacking> vtkPointSplatCloud::CollectBlocks(
  const vtkPointSplatCloudInput& input, const std::vector<Block>& visible)
{
  const std::vector<Block> blocks = vtkPointSplatCloud::Gather(input.Data);
  std::vector<vtkPointSet*> data;
  for (const Block& block : blocks)
  {
    data.push_back(block.Data);
  }
  std::set<unsigned int> seen;
  for (const Block& block : visible)
  {
    seen.insert(block.FlatIndex);
  }
  const vtkPointSplatPacking::Wanted wanted{ input.NeedSizes, input.ProjectNoise, input.FillGaps,
    input.FillMeshGaps };
  std::map<Key, std::vector<vtkPointSplatPacking>> kept;
  std::vector<vtkPointSplatPacking> all(blocks.size());
  const Key pieceKey = vtkPointSplatCloud::KeptKey(input, blocks);
  if (pieceKey != this->PiecesMadeFrom)
  {
    this->Pieces = vtkPointSplatPieces::Find(data, wanted);
    this->PiecesMadeFrom = pieceKey;
  }
  for (const std::vector<size_t>& cloud : this->Pieces)
  {
    std::vector<Block> pieces;
    std::vector<vtkPointSet*> own;
    for (size_t b : cloud)
    {
      pieces.push_back(blocks[b]);
      own.push_back(data[b]);
    }
    const Key key = input.Looks.empty() ? Key() : vtkPointSplatCloud::KeptKey(input, pieces);
    const auto found = this->Kept.find(key);
    std::vector<vtkPointSplatPacking> packings;
    if (found != this->Kept.end())
    {
      packings = found->second;
    }
    else if (std::any_of(pieces.begin(), pieces.end(),
               [&seen](const Block& block) { return seen.count(block.FlatIndex) > 0; }))
    {
      packings = vtkPointSplatPieces::Collect(input.Owner, own, wanted);
    }
    for (size_t k = 0; k < packings.size(); ++k)
    {
      all[cloud[k]] = packings[k];
    }
    if (!packings.empty() && packings.front().Aborted)
    {
      return packings;
    }
    if (!packings.empty() && !input.Looks.empty())
    {
      kept[key] = std::move(packings);
    }
  }
  this->Kept = std::move(kept);
  std::vector<vtkPointSplatPacking> ofVisible;
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    if (seen.count(blocks[b].FlatIndex) > 0)
    {
      ofVisible.push_back(std::move(all[b]));
    }
  }
  return ofVisible;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildColours(const vtkPointSplatCloudInput& input)
{
  this->Colours.clear();
  this->ValueTable.clear();
  this->CellColours = this->OwnOpacity = this->MixedColours = false;
  const bool looks = std::any_of(input.Looks.begin(), input.Looks.end(),
    [](const auto& look) { return look.second.Colour || look.second.Opacity; });
  if (input.MapColours && input.MapValues && !looks && this->BuildValues(input))
  {
    return;
  }
  std::vector<bool> scalars(this->Blocks.size(), false);
  if (input.MapColours)
  {
    this->BuildScalarColours(input, scalars);
  }
  // As VTK has it, blocks without scalars are of the actor's colour beside those with.
  this->MixedColours = looks ||
    (std::find(scalars.begin(), scalars.end(), true) != scalars.end() &&
      std::find(scalars.begin(), scalars.end(), false) != scalars.end());
  if (this->MixedColours)
  {
    this->BuildLooks(input, scalars);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildScalarColours(
  const vtkPointSplatCloudInput& input, std::vector<bool>& scalars)
{
  const size_t words = this->GetWordsPerSplat();
  const std::vector<uint32_t>& splats = this->GetRestingSplats();
  for (size_t b = 0; b < this->Blocks.size(); ++b)
  {
    const Block& block = this->Blocks[b];
    const vtkPointSplatColours colours = input.MapColours(block.Data);
    if (!colours.Array || colours.Array->GetNumberOfComponents() != 4)
    {
      continue;
    }
    scalars[b] = true;
    if (this->Colours.empty())
    {
      this->Colours.assign(static_cast<size_t>(this->Count), 0xffffffffu);
    }
    const std::vector<vtkIdType> cells =
      colours.OfCells ? vtkPointSplatPacking::CellsOfPoints(block.Data) : std::vector<vtkIdType>();
    this->CellColours = this->CellColours || colours.OfCells;
    const bool ofPoints = !colours.OfCells && colours.Only < 0;
    const vtkSmartPointer<vtkUnsignedCharArray> array =
      ofPoints ? block.OfSplats(colours.Array.Get()) : colours.Array;
    const unsigned char* from = array->GetPointer(0);
    const vtkIdType tuples = array->GetNumberOfTuples();
    vtkPointSplatThreads::For(block.First, block.First + block.Count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType number = begin; number < end; ++number)
      {
        const size_t i = this->SplatOf(number);
        const vtkIdType point = splats[words * i + 7];
        const vtkIdType id = ofPoints ? this->NumberOf(block, i)
          : colours.OfCells           ? cells[static_cast<size_t>(point)]
                                      : colours.Only;
        this->Colours[i] = colours.WithoutCell;
        if (id >= 0 && id < tuples)
        {
          std::memcpy(&this->Colours[i], from + 4 * id, 4);
        }
      }
    });
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BuildLooks(
  const vtkPointSplatCloudInput& input, const std::vector<bool>& scalars)
{
  this->OwnOpacity = std::any_of(input.Looks.begin(), input.Looks.end(),
    [](const auto& look) { return look.second.Opacity.has_value(); });
  this->Colours.resize(static_cast<size_t>(this->Count), 0xffffffffu);
  auto byte = [](double value) {
    return static_cast<uint32_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  };
  const std::array<double, 4>& actor = input.ActorColour;
  for (size_t b = 0; b < this->Blocks.size(); ++b)
  {
    const Block& block = this->Blocks[b];
    const auto found = input.Looks.find(block.FlatIndex);
    static const vtkPointSplatBlockLook plainLook;
    const vtkPointSplatBlockLook& look =
      found == input.Looks.end() ? plainLook : found->second;
    const std::array<double, 3> colour = look.Colour.value_or(
      std::array<double, 3>{ { actor[0], actor[1], actor[2] } });
    const double opacity = this->OwnOpacity ? look.Opacity.value_or(actor[3]) : 1.0;
    const bool keeps = scalars[b] && !look.Colour;
    const uint32_t plain = byte(colour[0]) | byte(colour[1]) << 8 | byte(colour[2]) << 16;
    vtkPointSplatThreads::For(block.First, block.First + block.Count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType number = begin; number < end; ++number)
      {
        const size_t i = this->SplatOf(number);
        const uint32_t was = keeps ? this->Colours[i] : plain | 0xff000000u;
        this->Colours[i] = (was & 0xffffffu) | byte((was >> 24) / 255.0 * opacity) << 24;
      }
    });
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::UpdateCoordinates(const vtkPointSplatCloudInput& input)
{
  auto wanted = [](const Block& block, vtkDataArray* array, int components) {
    return array && array->GetNumberOfTuples() == block.Data->GetNumberOfPoints() &&
        array->GetNumberOfComponents() >= components
      ? array
      : nullptr;
  };
  Key key{ { nullptr, this->SplatTime.GetMTime() } };
  std::vector<std::array<vtkDataArray*, 2>> arrays;
  for (const Block& block : this->Blocks)
  {
    vtkPointData* data = block.Data->GetPointData();
    arrays.push_back({ { input.NeedCoordinates ? wanted(block, data->GetTCoords(), 1) : nullptr,
      input.NeedTangents ? wanted(block, data->GetTangents(), 3) : nullptr } });
    for (vtkDataArray* array : arrays.back())
    {
      key.emplace_back(array, array ? array->GetMTime() : 0);
    }
  }
  if (key == this->CoordinatesMadeFrom)
  {
    return;
  }
  this->CoordinatesMadeFrom = std::move(key);
  this->CoordinateTime.Modified();
  this->Coordinates.clear();
  this->Tangents.clear();
  constexpr size_t words = vtkPointSplatCoordinates::Words;
  const size_t count = static_cast<size_t>(this->Count);
  for (size_t b = 0; b < arrays.size(); ++b)
  {
    if (arrays[b][0] || arrays[b][1])
    {
      this->MoveAll();
    }
    const Block& block = this->Blocks[b];
    const size_t perSplat = this->GetWordsPerSplat();
    // One after the other, with fill points' own numbers.
    std::vector<uint32_t> numbered(
      arrays[b][0] || arrays[b][1] ? perSplat * static_cast<size_t>(block.Count) : 0);
    for (size_t at = 0; at < numbered.size(); at += perSplat)
    {
      const size_t i = this->SplatOf(block.First + static_cast<vtkIdType>(at / perSplat));
      std::copy_n(this->Splats.data() + perSplat * i, perSplat, numbered.data() + at);
      numbered[at + 7] = static_cast<uint32_t>(this->NumberOf(block, i));
    }
    const vtkPointSplatCoordinates::Splats splats{ numbered.data(), perSplat, block.Count,
      this->Circular };
    const auto extended = [&block](vtkDataArray* array) {
      return block.Fill ? block.Fill->Extend(array) : vtkSmartPointer<vtkDataArray>(array);
    };
    std::vector<uint32_t> made;
    const auto put = [&](std::vector<uint32_t>& all, size_t size) {
      for (size_t at = 0; at < made.size(); at += size)
      {
        const size_t i = this->SplatOf(block.First + static_cast<vtkIdType>(at / size));
        std::copy_n(made.data() + at, size, all.data() + size * i);
      }
    };
    if (arrays[b][0])
    {
      this->Coordinates.resize(words * count, vtkPointSplatCoordinates::None);
      made.assign(words * static_cast<size_t>(block.Count), vtkPointSplatCoordinates::None);
      vtkPointSplatCoordinates::Make(splats, extended(arrays[b][0]), made.data());
      put(this->Coordinates, words);
    }
    if (arrays[b][1])
    {
      this->Tangents.resize(count, 0u);
      made.assign(static_cast<size_t>(block.Count), 0u);
      vtkPointSplatCoordinates::MakeTangents(splats, extended(arrays[b][1]), made.data());
      put(this->Tangents, 1);
    }
  }
}
