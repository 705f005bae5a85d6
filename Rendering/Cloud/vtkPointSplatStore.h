// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What splats have, some words each, of more splats than shaders can read from one buffer. It is on the
// card in parts, each of which a compute shader can read, and from these a frame's own splats are put into
// one buffer there: the bus carries their runs, not them.
//
// 1. Keep() puts whole splats into buffers of Part bytes, or of what the driver lets a shader read.
// 2. Gather() runs vtkPointSplatGatherCS.glsl once a part over all runs, each of which lies in one part
//    or in two; the others' work groups end at once.
#ifndef vtkPointSplatStore_h
#define vtkPointSplatStore_h

#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatProgram.h"

#include "vtkTimeStamp.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <vector>

class vtkPointSplatStore
{
public:
  /// Of a part, where drivers allow so much.
  static constexpr size_t Part = size_t(1) << 30;
  /// part: bytes of one.
  explicit vtkPointSplatStore(size_t part = Part)
    : PartBytes(part)
  {
  }

  /// Whether the entered context can have one of so many bytes: with compute shaders, in the memory of a
  /// card that tells how much of it is free, of which it takes no more than half.
  static bool CanKeep(size_t bytes);

  /// Data of so many words a splat; nothing is done where it is kept since it changed. False where there is no memory
  /// for it, or no program to gather it by: then nothing is kept.
  bool Keep(const std::vector<uint32_t>& data, size_t words, vtkMTimeType changed);
  /**
   * Fills a buffer of so many splats with those of runs, of which each has four words: its first splat,
   * that one's place in the buffer, how many there are, and 0. The program in use is another one then,
   * and storage of the indices 1, 2 and 7.
   */
  void Gather(const vtkPointSplatBuffer& runs, size_t numberOfRuns, size_t splats, vtkPointSplatBuffer& to);
  bool IsKept() const { return !this->Parts.empty(); }
  bool IsKept(vtkMTimeType changed) const { return this->IsKept() && this->Kept > changed; }
  void Release();

private:
  size_t PartBytes;
  size_t Words = 0;    // a splat
  size_t PerPart = 0;  // splats
  size_t Splats = 0;
  std::list<vtkPointSplatBuffer> Parts;
  vtkTimeStamp Kept;
  vtkPointSplatProgram Program;
};

#endif
