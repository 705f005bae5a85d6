// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Some words a splat, in another order.
#ifndef vtkPointSplatOrdered_h
#define vtkPointSplatOrdered_h

#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Those of the splats that order names, one after the other, and behind them zeros for as many as there is room for.
inline std::vector<uint32_t> vtkPointSplatOrdered(const std::vector<uint32_t>& data, size_t words,
  const std::vector<uint32_t>& order, size_t room)
{
  std::vector<uint32_t> ordered(words * room, 0u);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(order.size()), [&](vtkIdType begin, vtkIdType end) {
    for (size_t i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
    {
      std::copy_n(data.data() + words * order[i], words, ordered.data() + words * i);
    }
  });
  return ordered;
}

#endif
