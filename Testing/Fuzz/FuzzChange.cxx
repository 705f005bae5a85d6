// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzChange.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace
{
constexpr int Rounding = 2;
constexpr int Sample = 64; // of four
constexpr int MostSamples = 2;
}

FuzzChange::FuzzChange(const std::vector<unsigned char>& alone,
  const std::vector<unsigned char>& together, int width, int first)
{
  const int height = static_cast<int>(alone.size()) / (3 * width);
  const auto at = [width](int x, int y) { return static_cast<std::size_t>(3 * (y * width + x)); };
  const auto isBlack = [&](int x, int y) {
    const unsigned char* p = &alone[at(x, y)];
    return p[0] + p[1] + p[2] == 0;
  };
  int samples = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < first; ++x)
    {
      int most = 0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        most = std::max(most, std::abs(int(alone[at(x, y) + c]) - int(together[at(x, y) + c])));
      }
      this->Worst = std::max(this->Worst, most);
      if (most <= Rounding)
      {
        continue;
      }
      const bool outline = !isBlack(x, y) &&
        (isBlack(std::max(x - 1, 0), y) || isBlack(std::min(x + 1, width - 1), y) ||
          isBlack(x, std::max(y - 1, 0)) || isBlack(x, std::min(y + 1, height - 1)));
      this->Pixels += !(outline && most <= Sample && ++samples <= MostSamples);
    }
  }
}
