// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Morton order: positions that follow one another lie close together, so that what is read for a
// tile, or left out for a block, lies together in memory.
#ifndef vtkPointSplatMorton_h
#define vtkPointSplatMorton_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPointSplatMorton
{
public:
  /// A cube about low to high is divided in 2^21 along each side.
  vtkPointSplatMorton(const std::array<double, 3>& low, const std::array<double, 3>& high);

  /// Where on the curve a position lies, 63 bits.
  uint64_t Key(const double position[3]) const;

  /// The order of records of some words each, of which the first three are floats: positions
  /// relative to an origin. Equal keys stay in the order they have.
  std::vector<uint32_t> Order(const uint32_t* records, size_t words, size_t count,
    const std::array<double, 3>& origin) const;

private:
  std::array<double, 3> Low;
  double Scale;
};

#endif
