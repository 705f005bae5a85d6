// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLevels.h"

#include "vtkMath.h"
#include "vtkPointSplatCodes.h"
#include "vtkPointSplatLevelLines.h"
#include "vtkPointSplatOrdered.h"
#include "vtkPointSplatRims.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

namespace
{
constexpr float RimDeviation = 1.0f; // none is smooth

double BendOf(uint32_t code, int shift)
{
  // Ten bits with a sign.
  return static_cast<double>(static_cast<int32_t>(code << (22 - shift)) >> 22) / vtkPointSplatCodes::BendSteps;
}

/// All but the curvature; radius: of those that have none.
void ReadPlace(const uint32_t* splat, float radius, vtkPointSplatHierarchy::Point& point)
{
  std::memcpy(point.Position, splat, sizeof(point.Position));
  std::memcpy(&point.Radius, splat + 3, sizeof(float));
  point.Radius = point.Radius > 0.0f ? point.Radius : radius;
  double n[3];
  vtkPointSplatCodes::DecodeNormal(splat[5], n);
  std::copy_n(n, 3, point.Normal);
}

/// Splats in a cloud's form.
class Packed : public vtkPointSplatHierarchy::Source
{
public:
  Packed(const uint32_t* splats, size_t words, float radius)
    : Splats(splats)
    , Words(words)
    , Radius(radius)
  {
  }

  bool Read(vtkPointSplatHierarchy::Index id, vtkPointSplatHierarchy::Point& point) const override
  {
    const uint32_t* splat = this->Splats + this->Words * id;
    ReadPlace(splat, this->Radius, point);
    const uint32_t code = splat[6] & vtkPointSplatCodes::BendMask;
    point.HasCurvature = this->Words == 8 && code != 0u;
    if (point.HasCurvature)
    {
      double axes[2][3];
      vtkPointSplatCodes::TangentsOf(splat[4], axes[0], axes[1]);
      const double k[3] = { BendOf(code, 0) / point.Radius, BendOf(code, 10) / point.Radius,
        BendOf(code, 20) / point.Radius };
      const int index[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
      for (int m = 0; m < 6; ++m)
      {
        const int i = index[m][0];
        const int j = index[m][1];
        point.Curvature[m] = static_cast<float>(k[0] * axes[0][i] * axes[0][j] +
          k[1] * (axes[0][i] * axes[1][j] + axes[1][i] * axes[0][j]) +
          k[2] * axes[1][i] * axes[1][j]);
      }
    }
    return true;
  }

private:
  const uint32_t* Splats;
  size_t Words;
  float Radius; // of splats without one
};

void Pack(const vtkPointSplatHierarchy::Splat& splat, uint32_t id, size_t words, uint32_t* to)
{
  const double n[3] = { splat.Normal[0], splat.Normal[1], splat.Normal[2] };
  std::memcpy(to, splat.Position, sizeof(splat.Position));
  to[3] = vtkPointSplatCodes::Bits(splat.Radius);
  to[4] = to[5] = vtkPointSplatCodes::CodeNormal(n);
  to[7] = id;
  if (words == 8)
  {
    double bend[6];
    std::copy_n(splat.Curvature, 6, bend);
    to[6] = vtkPointSplatCodes::CodeBend(to[4], bend, splat.Radius);
    return;
  }
  const double longer[3] = { splat.Axis[0], splat.Axis[1], splat.Axis[2] };
  double shorter[3];
  vtkMath::Cross(n, longer, shorter);
  to[6] = to[11] = to[15] = 0u;
  for (int k = 0; k < 3; ++k)
  {
    to[8 + k] = vtkPointSplatCodes::Bits(splat.Radius * longer[k]);
    to[12 + k] = vtkPointSplatCodes::Bits(splat.Radius * splat.Shorter * shorter[k]);
  }
}

/// A splat's place and lines, for those that stand for it.
vtkPointSplatLevelLines::Splat ReadLines(const uint32_t* splat, size_t words, const uint32_t* lines)
{
  float place[3];
  std::memcpy(place, splat, sizeof(place));
  float products[4];
  std::memcpy(products, lines, sizeof(products));
  vtkPointSplatLevelLines::Splat result{};
  std::copy_n(place, 3, result.Position);
  double s[3];
  double t[3];
  vtkPointSplatCodes::AxesOf(splat, words == 8, s, t);
  double across[3];
  vtkMath::Cross(s, t, across);
  // The basis that is dual to the axes.
  double dual[2][3];
  vtkMath::Cross(t, across, dual[0]);
  vtkMath::Cross(across, s, dual[1]);
  const double square = vtkMath::Dot(across, across);
  for (int k = 0; k < 6 && square > 0.0; ++k)
  {
    const float* line = products + (k < 3 ? 0 : 2);
    result.Lines[k] = (line[0] * dual[0][k % 3] + line[1] * dual[1][k % 3]) / square;
  }
  return result;
}

/// Sets the lines of what stands for some splats, one after the other, with lines of four words each.
void PackLines(const vtkPointSplatHierarchy::Splat& above, const uint32_t* splat, size_t words,
  const std::vector<vtkPointSplatLevelLines::Splat>& below, uint32_t* lines)
{
  vtkPointSplatLevelLines::Disk disk{ {}, {}, above.Radius };
  std::copy_n(above.Position, 3, disk.Position);
  std::copy_n(above.Normal, 3, disk.Normal);
  double c[6];
  vtkPointSplatLevelLines::Find(below, disk, c);
  double s[3];
  double t[3];
  vtkPointSplatCodes::AxesOf(splat, words == 8, s, t);
  vtkPointSplatCodes::CodeLine(c, s, t, lines);
  vtkPointSplatCodes::CodeLine(c + 3, s, t, lines + 2);
}
}

//------------------------------------------------------------------------------
vtkPointSplatLevels::~vtkPointSplatLevels()
{
  this->Clear();
}

//------------------------------------------------------------------------------
void vtkPointSplatLevels::Clear()
{
  if (this->Work.valid())
  {
    this->Stop = true;
    this->Work.get();
  }
  this->Hierarchy = vtkPointSplatHierarchy();
  this->Seams = vtkPointSplatSeams();
  this->Rims.clear();
  this->Blocks.clear();
  this->Starts.clear();
  this->Firsts.clear();
  this->Roots = this->Points = 0;
}

//------------------------------------------------------------------------------
void vtkPointSplatLevels::Begin(
  const std::vector<uint32_t>& splats, size_t words, std::vector<uint32_t> ends, float radius)
{
  this->Clear();
  this->Stop = false;
  const uint32_t* from = splats.data();
  this->Work = std::async(std::launch::async, [this, from, words, parts = std::move(ends), radius] {
    const bool made = this->Hierarchy.Make(
      Packed(from, words, radius), parts, words != 8, [this](double) { return !this->Stop; });
    if (made && this->Hierarchy.GetNumberOfLevels() > 1)
    {
      this->Rims = vtkPointSplatRims::Find({ from, words, this->Hierarchy.GetOrder() },
        this->Hierarchy.GetBlocks(), this->Hierarchy.GetNumberOfRoots());
      this->Seams.Make(this->Hierarchy.GetBlocks(), this->Hierarchy.GetNumberOfRoots(), parts);
    }
    return made;
  });
}

//------------------------------------------------------------------------------
bool vtkPointSplatLevels::IsReady() const
{
  return this->Work.valid() &&
    this->Work.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatLevels::Take(
  std::vector<uint32_t>& splats, std::vector<uint32_t>& lines, size_t words)
{
  const bool good = this->Work.get() && this->Hierarchy.GetNumberOfLevels() > 1;
  if (!good)
  {
    this->Clear();
    return {};
  }
  std::vector<uint32_t> order = this->Hierarchy.GetOrder();
  this->Points = order.size();
  const int levels = this->Hierarchy.GetNumberOfLevels();
  this->Starts.assign(1, 0);
  for (int level = 0; level < levels; ++level)
  {
    this->Starts.push_back(this->Starts.back() + this->Hierarchy.GetNumberOfSplats(level));
  }
  splats = vtkPointSplatOrdered(splats, words, order, this->Starts.back());
  if (!lines.empty())
  {
    lines = vtkPointSplatOrdered(lines, 4, order, this->Starts.back());
  }
  this->Firsts.reserve(this->Starts.back() - this->Points);
  for (int level = 1; level < levels; ++level)
  {
    const uint32_t below = this->Starts[static_cast<size_t>(level) - 1];
    for (const vtkPointSplatHierarchy::Splat& splat : this->Hierarchy.GetSplats(level))
    {
      this->Firsts.push_back(below + splat.First);
    }
  }
  this->AppendSplats(splats, lines, words);
  this->Blocks = this->Hierarchy.GetBlocks();
  this->Roots = this->Hierarchy.GetNumberOfRoots();
  for (size_t b = 0; b < this->Blocks.size(); ++b)
  {
    Block& block = this->Blocks[b];
    block.First += this->Starts[static_cast<size_t>(block.Level)];
    block.Deviation = this->Rims[b] ? std::max(block.Deviation, RimDeviation) : block.Deviation;
  }
  this->Rims = std::vector<bool>();
  this->Hierarchy = vtkPointSplatHierarchy();
  return order;
}

//------------------------------------------------------------------------------
void vtkPointSplatLevels::AppendSplats(
  std::vector<uint32_t>& splats, std::vector<uint32_t>& lines, size_t words)
{
  for (size_t level = 1; level + 1 < this->Starts.size(); ++level)
  {
    const std::vector<vtkPointSplatHierarchy::Splat>& from =
      this->Hierarchy.GetSplats(static_cast<int>(level));
    const uint32_t start = this->Starts[level];
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(from.size()), [&](vtkIdType begin, vtkIdType end) {
      for (size_t i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
      {
        const uint32_t own = start + static_cast<uint32_t>(i);
        const size_t first = this->Firsts[own - this->Points];
        const size_t count = this->GetEnd(static_cast<int>(level), own) - first;
        const uint32_t* below = splats.data() + words * first;
        uint32_t* to = splats.data() + words * own;
        const uint32_t* linesBelow = lines.empty() ? nullptr : lines.data() + 4 * first;
        if (count == 1)
        {
          // What stands for one splat is that one, be it a body that faces the viewer.
          std::copy_n(below, words, to);
          if (linesBelow)
          {
            std::copy_n(linesBelow, 4, lines.data() + 4 * own);
          }
          continue;
        }
        Pack(from[i], below[7], words, to);
        const bool ends = linesBelow &&
          std::any_of(linesBelow, linesBelow + 4 * count, [](uint32_t word) { return word != 0u; });
        if (ends)
        {
          std::vector<vtkPointSplatLevelLines::Splat> clipped;
          for (size_t c = 0; c < count; ++c)
          {
            clipped.push_back(ReadLines(below + words * c, words, linesBelow + 4 * c));
          }
          PackLines(from[i], to, words, clipped, lines.data() + 4 * own);
        }
      }
    });
  }
}

//------------------------------------------------------------------------------
uint32_t vtkPointSplatLevels::GetEnd(int level, uint32_t splat) const
{
  // The last one's end is where its own level begins.
  return splat + 1 < this->Starts[static_cast<size_t>(level) + 1]
    ? this->Firsts[splat + 1 - this->Points]
    : this->Starts[static_cast<size_t>(level)];
}

//------------------------------------------------------------------------------
vtkPointSplatLevels::Deviations vtkPointSplatLevels::MeasureDeviations(
  const std::vector<uint32_t>& data, bool values) const
{
  if (data.empty() || this->Blocks.empty())
  {
    return nullptr;
  }
  auto square = [values](uint32_t a, uint32_t b) {
    double sum = 0.0;
    if (values)
    {
      float x;
      float y;
      std::memcpy(&x, &a, sizeof(x));
      std::memcpy(&y, &b, sizeof(y));
      return double(x - y) * (x - y);
    }
    for (int shift = 0; shift < 32; shift += 8)
    {
      const double d = (double(a >> shift & 255u) - double(b >> shift & 255u)) / 255.0;
      sum = std::max(sum, d * d);
    }
    return sum;
  };
  auto deviations = std::make_shared<std::vector<float>>(this->Blocks.size(), 0.0f);
  vtkPointSplatThreads::For(
    0, static_cast<vtkIdType>(this->Blocks.size()), 64, [&](vtkIdType begin, vtkIdType end) {
      for (size_t b = static_cast<size_t>(begin); b < static_cast<size_t>(end); ++b)
      {
        const Block& block = this->Blocks[b];
        double sum = 0.0;
        uint32_t count = 0;
        for (uint32_t i = block.First; block.Level > 0 && i < block.First + block.Count; ++i)
        {
          for (uint32_t c = this->Firsts[i - this->Points]; c < this->GetEnd(block.Level, i); ++c)
          {
            sum += square(data[i], data[c]);
            ++count;
          }
        }
        (*deviations)[b] = static_cast<float>(std::sqrt(sum / std::max(count, 1u)));
      }
    });
  this->Seams.Raise(this->Blocks, data, values, *deviations);
  return deviations;
}

//------------------------------------------------------------------------------
template <typename Mean>
void vtkPointSplatLevels::Append(std::vector<uint32_t>& data, const Mean& mean) const
{
  if (data.empty() || this->Starts.empty())
  {
    return;
  }
  data.resize(this->Starts.back());
  for (size_t level = 1; level + 1 < this->Starts.size(); ++level)
  {
    vtkPointSplatThreads::For(this->Starts[level], this->Starts[level + 1],
      [&](vtkIdType begin, vtkIdType end) {
        for (uint32_t i = static_cast<uint32_t>(begin); i < static_cast<uint32_t>(end); ++i)
        {
          const uint32_t first = this->Firsts[i - this->Points];
          data[i] = mean(data.data() + first, this->GetEnd(static_cast<int>(level), i) - first);
        }
      });
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatLevels::AppendBytes(std::vector<uint32_t>& data) const
{
  this->Append(data, [](const uint32_t* from, uint32_t count) {
    uint32_t word = 0;
    for (int shift = 0; shift < 32; shift += 8)
    {
      uint32_t sum = count / 2;
      for (uint32_t i = 0; i < count; ++i)
      {
        sum += from[i] >> shift & 255u;
      }
      word |= sum / count << shift;
    }
    return word;
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatLevels::AppendValues(std::vector<uint32_t>& data) const
{
  this->Append(data, [](const uint32_t* from, uint32_t count) {
    double sum = 0.0;
    uint32_t known = 0;
    for (uint32_t i = 0; i < count; ++i)
    {
      float value;
      std::memcpy(&value, from + i, sizeof(value));
      if (!(from[i] & 0x80000000u))
      {
        sum += value;
        ++known;
      }
    }
    return known ? vtkPointSplatCodes::Bits(sum / known) : 0x80000000u;
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatLevels::AppendFirst(std::vector<uint32_t>& data) const
{
  this->Append(data, [](const uint32_t* from, uint32_t) { return from[0]; });
}

//------------------------------------------------------------------------------
void vtkPointSplatLevels::Refit(
  size_t number, const std::vector<uint32_t>& splats, size_t words, float radius)
{
  Block& block = this->Blocks[number];
  vtkPointSplatHierarchy::Fit(block, [&](uint32_t i, vtkPointSplatHierarchy::Point& point) {
    ReadPlace(splats.data() + words * (block.First + i), radius, point);
  });
}
