// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a case finds out of order, and the two kinds of cases.
#ifndef FuzzCase_h
#define FuzzCase_h

#include "FuzzRandom.h"

#include <memory>
#include <string>
#include <vector>

/**
 * A case throws this where something is not as promised.
 */
struct FuzzFinding
{
  std::string What;
};

inline void FuzzExpect(bool good, const std::string& what)
{
  if (!good)
  {
    throw FuzzFinding{ what };
  }
}

/**
 * What VTK and the module say in a case: taken, not printed.
 */
class FuzzMessages
{
public:
  virtual ~FuzzMessages() = default;
  /// Those of the module's classes since the last call.
  virtual std::vector<std::string> TakeOwn() = 0;
};

/**
 * Random properties of a filter, random data through it twice: outputs as promised and equal,
 * inputs untouched.
 */
void FuzzFilters(FuzzRandom& random);

/**
 * Windows with splat actors, drawn again and again while everything changes. A window serves
 * several cases, since making one takes longer than a case.
 */
class FuzzScenes
{
public:
  explicit FuzzScenes(FuzzMessages& messages);
  ~FuzzScenes();
  /// Forget the window; the next one follows from the seed.
  void Reset(std::uint64_t seed);
  void Run(FuzzRandom& random);

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};

#endif
