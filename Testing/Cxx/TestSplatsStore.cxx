// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Splats that are kept on the card in parts are gathered from there run by run, as a processor would
// copy them: runs across parts, of all numbers of words that splats have, in any order, and more of them than
// there is room for. The mapper does so with more points than a test can have. And buffers' sizes are none for which
// drivers for processors compile programs anew.
#include "Expect.h"

#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkPointSplatShaders.h"
#include "vtkPointSplatStore.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

// The test has parts of the module of its own, which find their shader where it lies.
const char* vtkPointSplatShaderText(const std::string& name)
{
  static std::map<std::string, std::string> texts;
  std::string& text = texts[name];
  std::ifstream file(std::string(PointSplatting_SHADERS) + "/" + name + ".glsl");
  std::ostringstream all;
  all << file.rdbuf();
  text = all.str();
  return text.empty() ? nullptr : text.c_str();
}

namespace
{
struct Run
{
  uint32_t First;
  uint32_t Place;
  uint32_t Count;
  uint32_t Unused;
};

constexpr uint32_t Splats = 1000;
constexpr size_t Part = 100 * 8 * sizeof(uint32_t); // of some splats
constexpr uint32_t Nothing = 0xabcdef01u;

std::vector<uint32_t> MakeData(size_t words, std::mt19937& random)
{
  std::vector<uint32_t> data(words * Splats);
  std::generate(data.begin(), data.end(), random);
  return data;
}

std::vector<Run> MakeRuns(size_t number, uint32_t longest, std::mt19937& random)
{
  std::vector<Run> runs;
  uint32_t place = 0;
  for (size_t i = 0; i < number; ++i)
  {
    const uint32_t count = 1 + random() % longest;
    runs.push_back({ static_cast<uint32_t>(random() % (Splats - count + 1)), place, count, 0 });
    place += count;
  }
  return runs;
}

void Check(vtkPointSplatStore& store, const std::vector<uint32_t>& data, size_t words,
  const std::vector<Run>& runs, uint32_t room, const std::string& what)
{
  vtkPointSplatBuffer table;
  table.Upload(runs);
  std::vector<uint32_t> expected(words * room + 8, Nothing);
  vtkPointSplatBuffer gathered;
  gathered.Upload(expected);
  for (const Run& run : runs)
  {
    for (uint32_t i = 0; i < run.Count && run.Place + i < room; ++i)
    {
      std::copy_n(data.begin() + static_cast<std::ptrdiff_t>(words * (run.First + i)), words,
        expected.begin() + static_cast<std::ptrdiff_t>(words * (run.Place + i)));
    }
  }
  store.Gather(table, runs.size(), room, gathered);
  std::vector<uint32_t> found(expected.size());
  gathered.Download(found.data(), static_cast<GLsizeiptr>(sizeof(uint32_t) * found.size()));
  const auto differs = std::mismatch(found.begin(), found.end(), expected.begin());
  Expect(differs.first == found.end(),
    what + ": word " + std::to_string(differs.first - found.begin()) + " of " +
      std::to_string(found.size()));
}

void CheckWords(size_t words)
{
  std::mt19937 random(static_cast<unsigned int>(words));
  const std::string what = std::to_string(words) + " words a splat, ";
  std::vector<uint32_t> data = MakeData(words, random);
  vtkTimeStamp changed;
  changed.Modified();
  vtkPointSplatStore store(Part);
  Expect(!store.IsKept(), what + "kept before it was");
  Expect(store.Keep(data, words, changed) && store.IsKept(changed), what + "not kept");

  const std::vector<Run> runs = MakeRuns(300, 30, random);
  const uint32_t all = runs.back().Place + runs.back().Count;
  Check(store, data, words, runs, all, what + "short runs");
  Check(store, data, words, MakeRuns(5, Splats, random), 5 * Splats, what + "runs over several parts");
  Check(store, data, words, { { 0, 0, Splats, 0 } }, Splats, what + "one run of all");
  Check(store, data, words, runs, all / 2, what + "half of the room");
  Check(store, data, words, {}, 0, what + "no runs");

  // What did not change is not brought again; what did is.
  std::vector<uint32_t> other = MakeData(words, random);
  store.Keep(other, words, changed);
  Check(store, data, words, runs, all, what + "kept before");
  changed.Modified();
  Expect(!store.IsKept(changed), what + "kept after it changed");
  store.Keep(other, words, changed);
  Check(store, other, words, runs, all, what + "changed");

  store.Release();
  store.Release();
  Expect(!store.IsKept(), what + "kept after it was released");
}

void CheckSizes()
{
  for (const GLsizeiptr bytes : { 1, 48, 192, 255, 256, 4096, 32768, 65536, 65600, 262144, 262160, 1 << 20 })
  {
    vtkPointSplatBuffer buffer(GL_RGBA32UI);
    buffer.Reserve(bytes);
    const GLsizeiptr size = buffer.GetSize();
    const std::string what = std::to_string(bytes) + " bytes are " + std::to_string(size);
    Expect(size >= bytes && size <= bytes + 320, what);
    Expect((size & (size - 1)) != 0, what + ", a power of two");
    Expect((size & 0xff00) != 0, what + ", whose second lowest byte is 0");
    buffer.Release();
  }
}
}

int TestSplatsStore(int, char*[])
{
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  window->SetSize(16, 16);
  window->Render();
  window->MakeCurrent();
  {
    vtkPointSplatContextScope scope(window);
    for (const size_t words : { 1, 4, 8, 16 })
    {
      CheckWords(words);
    }
    CheckSizes();
    // Main memory is the card's where Mesa draws: nothing is kept twice there.
    Expect(!vtkPointSplatContext::IsSoftware() || !vtkPointSplatStore::CanKeep(1),
      "a software renderer keeps splats twice");
    Expect(!vtkPointSplatStore::CanKeep(size_t(1) << 60), "more than any card has is kept");
    Expect(glGetError() == GL_NO_ERROR, "OpenGL has an error");
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
