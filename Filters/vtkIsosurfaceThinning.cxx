// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfaceThinning.h"

#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

std::int64_t vtkIsosurfaceThinning::GetKey(const std::int64_t cube[3])
{
  const std::int64_t mask = (std::int64_t(1) << 21) - 1;
  return (cube[0] & mask) | (cube[1] & mask) << 21 | (cube[2] & mask) << 42;
}

std::size_t vtkIsosurfaceThinning::Locate(std::int64_t key) const
{
  const std::size_t mask = this->Table.size() - 1;
  std::uint64_t hash = static_cast<std::uint64_t>(key) * 0x9E3779B97F4A7C15ull;
  std::size_t at = static_cast<std::size_t>(hash >> 32) & mask;
  while (this->Table[at].First != End && this->Table[at].Key != key)
  {
    at = (at + 1) & mask;
  }
  return at;
}

void vtkIsosurfaceThinning::Grow()
{
  std::vector<Cube> old(this->Table.empty() ? 64 : 2 * this->Table.size(), Cube{ 0, End });
  old.swap(this->Table);
  for (const Cube& cube : old)
  {
    if (cube.First != End)
    {
      this->Table[this->Locate(cube.Key)] = cube;
    }
  }
}

bool vtkIsosurfaceThinning::HasNear(
  const Sample& sample, double distance, const std::int64_t cube[3]) const
{
  std::int32_t other = this->Table[this->Locate(GetKey(cube))].First;
  for (; other != End; other = this->Next[other])
  {
    const Sample& near = this->Samples[other];
    double squared = 0, side = 0;
    for (int c = 0; c < 3; ++c)
    {
      const double d = near.Position[c] - sample.Position[c];
      squared += d * d;
      side += near.Side[c] * sample.Side[c];
    }
    if (squared < distance * distance && side >= 0)
    {
      return true;
    }
  }
  return false;
}

bool vtkIsosurfaceThinning::HasNear(const Sample& sample, double distance) const
{
  if (this->Samples.empty())
  {
    return false;
  }
  // The cube that the sample lies in, most likely to have one, and those nearest to it.
  std::int64_t home[3], step[3], cube[3];
  for (int c = 0; c < 3; ++c)
  {
    const double at = sample.Position[c] / (2 * this->Distance);
    home[c] = static_cast<std::int64_t>(std::floor(at));
    step[c] = at - static_cast<double>(home[c]) < 0.5 ? -1 : 1;
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int c = 0; c < 3; ++c)
    {
      cube[c] = home[c] + (corner >> c & 1 ? step[c] : 0);
    }
    if (this->HasNear(sample, distance, cube))
    {
      return true;
    }
  }
  return false;
}

void vtkIsosurfaceThinning::Add(const Sample& sample)
{
  if (2 * (this->Used + 1) > this->Table.size())
  {
    this->Grow();
  }
  std::int64_t cube[3];
  for (int c = 0; c < 3; ++c)
  {
    cube[c] = static_cast<std::int64_t>(std::floor(sample.Position[c] / (2 * this->Distance)));
  }
  const std::int64_t key = GetKey(cube);
  Cube& entry = this->Table[this->Locate(key)];
  this->Used += entry.First == End;
  this->Next.push_back(entry.First);
  entry = { key, static_cast<std::int32_t>(this->Samples.size()) };
  this->Samples.push_back(sample);
}

VTK_ABI_NAMESPACE_END
