// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceThinning
 * @brief   points of one isosurface of which no two are nearer than a distance
 *
 * Internal to vtkIsosurfaceSamples and vtkIsosurfaceScatter. A hash table of cubes, with twice
 * that distance as their side, finds what is near in eight of them.
 */
#ifndef vtkIsosurfaceThinning_h
#define vtkIsosurfaceThinning_h

#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <cstdint>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceThinning
{
public:
  struct Sample
  {
    double Position[3]; // world units along the volume's axes
    float Side[3];      // the gradient's direction, of any length
  };

  explicit vtkIsosurfaceThinning(double distance)
    : Distance(distance)
  {
  }

  /// Whether one that was added lies near, on the same side of the surface.
  bool HasNear(const Sample& sample) const { return this->HasNear(sample, this->Distance); }
  /// The same with a lesser distance.
  bool HasNear(const Sample& sample, double distance) const;
  void Add(const Sample& sample);

  const std::vector<Sample>& GetSamples() const { return this->Samples; }

  /// The same random order for the same number, everywhere.
  template <typename T>
  static void Shuffle(std::vector<T>& items)
  {
    std::uint64_t state = 0x2545F4914F6CDD1Dull;
    for (std::size_t i = items.size(); i > 1; --i)
    {
      state = state * 6364136223846793005ull + 1442695040888963407ull;
      std::swap(items[i - 1], items[(state >> 33) % i]);
    }
  }

private:
  static constexpr std::int32_t End = -1;
  struct Cube
  {
    std::int64_t Key;
    std::int32_t First; // End if the entry is free
  };

  static std::int64_t GetKey(const std::int64_t cube[3]);
  bool HasNear(const Sample& sample, double distance, const std::int64_t cube[3]) const;
  /// The entry with a key, or the free one where it would be.
  std::size_t Locate(std::int64_t key) const;
  void Grow();

  double Distance;
  std::vector<Sample> Samples;
  std::vector<std::int32_t> Next; // in the same cube
  std::vector<Cube> Table;        // open addressing, a power of 2
  std::size_t Used = 0;
};

VTK_ABI_NAMESPACE_END
#endif
