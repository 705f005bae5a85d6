// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMorton.h"

#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace
{
constexpr double Cells = 2097151.0; // 2^21 - 1

/// A 21-bit number's bits, two zeros between each.
uint64_t Spread(uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffffull;
  x = (x | x << 16) & 0x001f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  x = (x | x << 2) & 0x1249249249249249ull;
  return x;
}
}

//------------------------------------------------------------------------------
vtkPointSplatMorton::vtkPointSplatMorton(
  const std::array<double, 3>& low, const std::array<double, 3>& high)
  : Low(low)
{
  double size = 0.0;
  for (size_t k = 0; k < 3; ++k)
  {
    size = std::max(size, high[k] - low[k]);
  }
  this->Scale = size > 0.0 ? Cells / size : 0.0;
}

//------------------------------------------------------------------------------
uint64_t vtkPointSplatMorton::Key(const double position[3]) const
{
  uint64_t key = 0;
  for (size_t k = 0; k < 3; ++k)
  {
    const double cell = std::clamp((position[k] - this->Low[k]) * this->Scale, 0.0, Cells);
    key |= Spread(static_cast<uint64_t>(cell)) << k;
  }
  return key;
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatMorton::Order(const uint32_t* records, size_t words,
  size_t count, const std::array<double, 3>& origin) const
{
  std::vector<std::pair<uint64_t, uint32_t>> keys(count);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(count), [&](vtkIdType begin, vtkIdType end) {
    for (size_t i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
    {
      float p[3];
      std::memcpy(p, records + words * i, sizeof(p));
      const double position[3] = { p[0] + origin[0], p[1] + origin[1], p[2] + origin[2] };
      keys[i] = { this->Key(position), static_cast<uint32_t>(i) };
    }
  });
  if (!std::is_sorted(keys.begin(), keys.end()))
  {
    vtkSMPTools::Sort(keys.begin(), keys.end());
  }
  std::vector<uint32_t> order(count);
  std::transform(keys.begin(), keys.end(), order.begin(),
    [](const std::pair<uint64_t, uint32_t>& key) { return key.second; });
  return order;
}
