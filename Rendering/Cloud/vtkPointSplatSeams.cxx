// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSeams.h"

#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
using Block = vtkPointSplatSeams::Block;

// Of those that touch a block of points so many are compared.
constexpr size_t MostTouching = 16;

bool Touch(const Block& a, const Block& b)
{
  const float reach = a.Radius + b.Radius;
  for (int k = 0; k < 3; ++k)
  {
    if (a.Low[k] > b.High[k] + reach || b.Low[k] > a.High[k] + reach)
    {
      return false;
    }
  }
  return true;
}

/// Means of what a word holds, in channels.
std::array<double, 4> MeanOf(const uint32_t* data, uint32_t count, bool values)
{
  std::array<double, 4> sums{};
  uint32_t known = 0;
  for (uint32_t i = 0; i < count; ++i)
  {
    if (values)
    {
      float value;
      std::memcpy(&value, data + i, sizeof(value));
      const bool has = (data[i] & 0x80000000u) == 0u;
      sums[0] += has ? value : 0.0;
      known += has ? 1 : 0;
      continue;
    }
    for (size_t channel = 0; channel < 4; ++channel)
    {
      sums[channel] += (data[i] >> (8 * channel) & 255u) / 255.0;
    }
    ++known;
  }
  for (double& sum : sums)
  {
    sum /= std::max(known, 1u);
  }
  // What has no value looks unlike all that have one.
  sums[3] = values && known == 0 ? 1.0 : sums[3];
  return sums;
}
}

/// Finds the runs of other parts that touch one.
class vtkPointSplatSeams::Search
{
public:
  Search(const std::vector<Block>& blocks, const std::vector<Run>& runs)
    : Blocks(blocks)
    , Runs(runs)
    , Parts(blocks.size(), { std::numeric_limits<uint32_t>::max(), 0 })
    , FirstRun(blocks.size(), 0)
  {
    for (size_t r = runs.size(); r-- > 0;)
    {
      this->Join(runs[r].Block, { { runs[r].Part, runs[r].Part } });
      this->FirstRun[runs[r].Block] = static_cast<uint32_t>(r);
    }
    vtkPointSplatHierarchy::JoinUpward(blocks,
      [this](size_t block, size_t child) { this->Join(block, this->Parts[child]); });
  }

  void Visit(uint32_t block, const Run& own, std::vector<uint32_t>& found) const
  {
    const std::array<uint32_t, 2>& parts = this->Parts[block];
    if ((parts[0] == own.Part && parts[1] == own.Part) || found.size() >= MostTouching ||
      !Touch(this->Blocks[block], this->Blocks[own.Block]))
    {
      return;
    }
    const Block& b = this->Blocks[block];
    for (uint32_t child = 0; b.Level > 0 && child < b.ChildCount; ++child)
    {
      this->Visit(b.FirstChild + child, own, found);
    }
    for (size_t r = this->FirstRun[block];
         b.Level == 0 && r < this->Runs.size() && this->Runs[r].Block == block; ++r)
    {
      if (this->Runs[r].Part != own.Part)
      {
        found.push_back(static_cast<uint32_t>(r));
      }
    }
  }

private:
  void Join(size_t block, const std::array<uint32_t, 2>& parts)
  {
    this->Parts[block][0] = std::min(this->Parts[block][0], parts[0]);
    this->Parts[block][1] = std::max(this->Parts[block][1], parts[1]);
  }

  const std::vector<Block>& Blocks;
  const std::vector<Run>& Runs;
  std::vector<std::array<uint32_t, 2>> Parts; // the first and the last one in each block
  std::vector<uint32_t> FirstRun;             // of each block of points
};

//------------------------------------------------------------------------------
void vtkPointSplatSeams::Make(
  const std::vector<Block>& blocks, size_t roots, const std::vector<uint32_t>& ends)
{
  this->Runs.clear();
  this->Touching.clear();
  if (ends.size() < 2)
  {
    return;
  }
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    const uint32_t end = blocks[b].First + blocks[b].Count;
    for (uint32_t i = blocks[b].First; blocks[b].Level == 0 && i < end;)
    {
      const auto part = std::upper_bound(ends.begin(), ends.end(), i);
      const uint32_t next = std::min(end, part == ends.end() ? end : *part);
      this->Runs.push_back({ static_cast<uint32_t>(b), i, next - i,
        static_cast<uint32_t>(part - ends.begin()) });
      i = next;
    }
  }
  const Search search(blocks, this->Runs);
  std::vector<std::vector<uint32_t>> found(this->Runs.size());
  vtkPointSplatThreads::For(
    0, static_cast<vtkIdType>(found.size()), 64, [&](vtkIdType begin, vtkIdType end) {
      for (size_t r = static_cast<size_t>(begin); r < static_cast<size_t>(end); ++r)
      {
        for (uint32_t root = 0; root < roots; ++root)
        {
          search.Visit(root, this->Runs[r], found[r]);
        }
      }
    });
  for (size_t r = 0; r < found.size(); ++r)
  {
    for (const uint32_t other : found[r])
    {
      this->Touching.emplace_back(static_cast<uint32_t>(r), other);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatSeams::Raise(const std::vector<Block>& blocks,
  const std::vector<uint32_t>& data, bool values, std::vector<float>& deviations) const
{
  if (this->Touching.empty())
  {
    return;
  }
  std::vector<bool> wanted(this->Runs.size(), false);
  for (const auto& [run, other] : this->Touching)
  {
    wanted[run] = wanted[other] = true;
  }
  std::vector<std::array<double, 4>> means(this->Runs.size());
  for (size_t r = 0; r < means.size(); ++r)
  {
    if (wanted[r])
    {
      means[r] = MeanOf(data.data() + this->Runs[r].First, this->Runs[r].Count, values);
    }
  }
  std::vector<float> differences(blocks.size(), 0.0f);
  for (const auto& [run, other] : this->Touching)
  {
    float& difference = differences[this->Runs[run].Block];
    for (size_t channel = 0; channel < 4; ++channel)
    {
      difference = std::max(difference,
        static_cast<float>(std::abs(means[run][channel] - means[other][channel])));
    }
  }
  vtkPointSplatHierarchy::JoinUpward(blocks, [&differences](size_t block, size_t child) {
    differences[block] = std::max(differences[block], differences[child]);
  });
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    deviations[b] = std::max(deviations[b], differences[b]);
  }
}
