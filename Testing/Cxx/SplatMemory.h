// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What tests of memory share: what the process and the OpenGL context hold, and whether that grows.
#ifndef SplatMemory_h
#define SplatMemory_h

#include "SplatScene.h"

#include "vtkPointSplattingOpenGL.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace SplatMemory
{
// The address sanitizer keeps what was freed, and is for other faults.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool MeasureMemory = false;
#else
constexpr bool MeasureMemory = true;
#endif
constexpr GLuint MostNames = 3000;

/**
 * KiB that are resident, without what the allocator keeps for later. -1 where that is not told.
 */
inline long Resident()
{
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
  {
    if (line.compare(0, 6, "VmRSS:") == 0)
    {
      return std::stol(line.substr(6));
    }
  }
  return -1;
}

/**
 * Bytes in use by allocations, which does not depend on what pages they lie on; -1 where
 * that is not told.
 */
inline long Allocated()
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const struct mallinfo2 info = mallinfo2();
  return static_cast<long>((info.uordblks + info.hblkhd) / 1024);
#else
  return -1;
#endif
}

/**
 * The context's objects.
 */
struct Objects
{
  int Buffers = 0;
  int Textures = 0;
  int Programs = 0;
  int Framebuffers = 0;
  int Arrays = 0;

  explicit Objects(vtkRenderWindow* window)
  {
    window->MakeCurrent();
    for (GLuint name = 1; name < MostNames; ++name)
    {
      this->Buffers += glIsBuffer(name);
      this->Textures += glIsTexture(name);
      this->Programs += glIsProgram(name);
      this->Framebuffers += glIsFramebuffer(name);
      this->Arrays += glIsVertexArray(name);
    }
  }
  bool NoMoreThan(const Objects& other) const
  {
    return this->Buffers <= other.Buffers && this->Textures <= other.Textures &&
      this->Programs <= other.Programs && this->Framebuffers <= other.Framebuffers &&
      this->Arrays <= other.Arrays;
  }
  std::string Text() const
  {
    return std::to_string(this->Buffers) + " buffers, " + std::to_string(this->Textures) +
      " textures, " + std::to_string(this->Programs) + " programs, " +
      std::to_string(this->Framebuffers) + " framebuffers, " + std::to_string(this->Arrays) +
      " vertex arrays";
  }
};

/**
 * What is held at moments between which as much is drawn, always in the same state.
 */
class Record
{
public:
  void Add(const std::string& name, vtkRenderWindow* window)
  {
    this->Held.emplace_back(new Objects(window));
    this->AllResident.push_back(Resident());
    this->AllAllocated.push_back(Allocated());
    std::cout << name << ": " << this->AllResident.back() << " KiB resident, "
              << this->AllAllocated.back() << " KiB allocated, " << this->Held.back()->Text() << "\n";
  }
  /// Whether memory grew by more than so many KiB from one moment to the next. Whoever measures that again
  /// tells a leak, which is there each time, from what the system's allocators and other threads do.
  bool Grew(long most) const
  {
    return MeasureMemory && (Growth(this->AllResident) > most || Growth(this->AllAllocated) > most);
  }
  /// most: KiB from one moment to the next.
  void Check(SplatScene::Checks& checks, long most) const
  {
    checks.Expect(this->Held.back()->NoMoreThan(*this->Held.front()),
      "OpenGL objects: " + this->Held.back()->Text() + ", more than " + this->Held.front()->Text());
    if (MeasureMemory)
    {
      checks.AtMost(Growth(this->AllResident), most, "KiB resident more");
      checks.AtMost(Growth(this->AllAllocated), most, "KiB allocated more");
    }
  }

private:
  /// From one moment to the next: the median of the slopes between any two moments but those of the first
  /// third, in which libraries and drivers still allocate what they keep for good. A leak is in all
  /// slopes; what allocators hold at one moment and not at the next, is in few.
  static long Growth(const std::vector<long>& all)
  {
    std::vector<double> slopes;
    for (size_t i = all.size() / 3; i < all.size(); ++i)
    {
      for (size_t j = i + 1; j < all.size(); ++j)
      {
        slopes.push_back(static_cast<double>(all[j] - all[i]) / static_cast<double>(j - i));
      }
    }
    std::nth_element(slopes.begin(), slopes.begin() + slopes.size() / 2, slopes.end());
    return std::lround(slopes[slopes.size() / 2]);
  }

  std::vector<std::unique_ptr<Objects>> Held;
  std::vector<long> AllResident;
  std::vector<long> AllAllocated;
};
}

#endif
