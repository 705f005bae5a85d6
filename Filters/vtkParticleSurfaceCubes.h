// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleSurfaceCubes
 * @brief   cubes of space by the number of particles in them, to tell which lie deep in the fluid
 *
 * Internal to vtkParticleSurfaceKernels.
 */
#ifndef vtkParticleSurfaceCubes_h
#define vtkParticleSurfaceCubes_h

#include "vtkPointSplatThreads.h"
#include "vtkPointSplattingABI.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkParticleSurfaceCubes
{
public:
  /// Numbers of cubes along an axis have so many bits.
  static constexpr int Bits = 21;

  vtkParticleSurfaceCubes(const double origin[3], double side)
    : Side(side)
  {
    std::copy_n(origin, 3, this->Origin);
  }

  std::uint64_t GetKey(const double x[3]) const
  {
    std::uint64_t key = 0;
    for (int c = 0; c < 3; ++c)
    {
      // From 1 on, so that there is a cube before the first.
      key = key << Bits |
        (static_cast<std::uint64_t>(std::floor((x[c] - this->Origin[c]) / this->Side)) + 1);
    }
    return key;
  }

  /// keys: of all particles.
  void Count(std::vector<std::uint64_t> keys)
  {
    vtkSMPTools::Sort(keys.begin(), keys.end());
    for (const std::uint64_t key : keys)
    {
      if (this->Keys.empty() || this->Keys.back() != key)
      {
        this->Keys.push_back(key);
        this->Counts.push_back(0);
      }
      ++this->Counts.back();
    }
  }

  /// full: how many particles a cube has at the usual spacing.
  void MarkDeep(double full)
  {
    this->Deep.resize(this->Keys.size());
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Keys.size()), [&](vtkIdType i, vtkIdType end) {
      for (; i < end; ++i)
      {
        bool deep = true;
        double sum = 0;
        for (int around = 0; around < 27 && deep; ++around)
        {
          const std::uint64_t one = 1;
          const std::uint64_t offset = (around % 3) + ((around / 3 % 3) * (one << Bits)) +
            ((around / 9) * (one << 2 * Bits));
          const std::uint64_t centre = 1 + (one << Bits) + (one << 2 * Bits);
          const std::size_t at = this->Find(this->Keys[i] + offset - centre);
          deep = at < this->Keys.size() && this->Counts[at] >= DeepLeast * full;
          sum += deep ? this->Counts[at] : 0;
        }
        this->Deep[i] = deep && sum >= DeepSum * 27 * full;
      }
    });
  }

  bool IsDeep(std::uint64_t key) const { return this->Deep[this->Find(key)] != 0; }

private:
  /// A cube with a kernel's reach as side is deep inside the fluid if it and those around have
  /// together at least this part of the particles that they would have at the usual spacing, ...
  static constexpr double DeepSum = 0.9;
  /// ... and each of them this part; some have a half, as lattices fall. Then the surface is about
  /// two spacings away at least.
  static constexpr double DeepLeast = 0.3;

  /// The number of cubes where there is none.
  std::size_t Find(std::uint64_t key) const
  {
    const auto at = std::lower_bound(this->Keys.begin(), this->Keys.end(), key);
    return at != this->Keys.end() && *at == key ? at - this->Keys.begin() : this->Keys.size();
  }

  double Origin[3];
  double Side;
  std::vector<std::uint64_t> Keys;
  std::vector<std::uint32_t> Counts;
  std::vector<unsigned char> Deep;
};

VTK_ABI_NAMESPACE_END
#endif
