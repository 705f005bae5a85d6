// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// splatfuzz [--seconds N] [--cases N] [--seed S] [--first K] [--case K] [--verbose]: throws
// random data, properties, cameras and windows at the filters and the mapper until the time is
// over or so many cases are done, and looks whether what they promise is kept. A case follows
// from the seed and its number alone; what is found is told with both. Windows serve
// RunsPerWindow cases: where a finding does not come again with --case, it does with --first
// and the multiple of that before it.
//
// ctest runs half a minute of seed 1, and no further than the cases that have been seen to pass: a
// faster machine finds nothing there that a slower one does not, and what fails there failed by
// a change. New cases are for runs by hand, over night say, with seeds of one's own and a
// build of PointSplatting_SANITIZE:
//   splatfuzz --seconds 28800 --seed $(date +%s)
//
// Ends with 0 where nothing is found; 1 after findings, each told; by the signal or the
// sanitizer's message after a crash, and by abort() when a case takes too long.
#include "FuzzCase.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

// The sanitizers' runtime, where it is linked in.
extern "C" void __sanitizer_set_death_callback(void (*)()) __attribute__((weak));

namespace
{
using Clock = std::chrono::steady_clock;
constexpr int RunsPerWindow = 64;
constexpr double SceneShare = 0.4;
// Of a case's processor time: under other load a minute of the clock is over with little done where
// OpenGL draws in software. Two lights among the points, each with six shadow maps of 4095 x 4095
// pixels, take 15 s of a core, a hundred layers of splats that each cover the window 40 s.
constexpr double MostProcessorSeconds = 120;
// Of the clock, with less than one of the processor: threads that wait for one another.
constexpr double MostIdleSeconds = 100;
constexpr int MostFindings = 20;

std::atomic<unsigned long long> CurrentCase{ 0 };
unsigned long long Seed = 1;

void TellCase()
{
  char line[100];
  const int length = std::snprintf(line, sizeof(line), "splatfuzz: --seed %llu --case %llu\n", Seed,
    static_cast<unsigned long long>(CurrentCase));
  std::fwrite(line, 1, static_cast<std::size_t>(length), stderr);
  std::fflush(stderr);
}

void OnSignal(int number)
{
  TellCase();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

/**
 * Ends the process when a case takes too long.
 */
class Watchdog
{
public:
  Watchdog()
    : Thread([this] {
      const auto processor = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
      unsigned long long last = ~0ull;
      double began = 0;
      double busy = 0;
      Clock::time_point seen;
      while (!this->Done)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        const double now = processor();
        if (CurrentCase != last)
        {
          last = CurrentCase;
          began = now;
          busy = -1;
        }
        if (now - busy >= 1)
        {
          busy = now;
          seen = Clock::now();
        }
        const double idle = std::chrono::duration<double>(Clock::now() - seen).count();
        if (now - began > MostProcessorSeconds || idle > MostIdleSeconds)
        {
          std::fprintf(stderr,
            "splatfuzz: a case has taken %g s of processors, and done nothing for %g s\n",
            now - began, idle);
          std::abort();
        }
      }
    })
  {
  }
  ~Watchdog()
  {
    this->Done = true;
    this->Thread.join();
  }

private:
  std::atomic<bool> Done{ false };
  std::thread Thread;
};

class Messages
  : public vtkOutputWindow
  , public FuzzMessages
{
public:
  static Messages* New() { return new Messages; }
  vtkTypeMacro(Messages, vtkOutputWindow);
  void DisplayText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ++this->Count;
    if (this->Verbose)
    {
      std::cerr << text;
    }
    if (std::strstr(text, "vtkPointSplat") || std::strstr(text, "vtkIsosurfacePoints"))
    {
      this->Own.emplace_back(text);
    }
  }
  std::vector<std::string> TakeOwn() override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return std::exchange(this->Own, {});
  }
  unsigned long Count = 0;
  bool Verbose = false;

private:
  std::mutex Mutex;
  std::vector<std::string> Own;
};
}

int main(int argc, char* argv[])
{
  double seconds = 10;
  unsigned long long most = ~0ull;
  unsigned long long first = 0;
  bool single = false;
  bool verbose = false;
  for (int a = 1; a < argc; ++a)
  {
    const std::string option = argv[a];
    const char* value = a + 1 < argc ? argv[a + 1] : "0";
    if (option == "--verbose")
    {
      verbose = true;
      continue;
    }
    if (option == "--seconds")
    {
      seconds = std::atof(value);
    }
    else if (option == "--seed")
    {
      Seed = std::strtoull(value, nullptr, 10);
    }
    else if (option == "--cases")
    {
      most = std::strtoull(value, nullptr, 10);
    }
    else if (option == "--case" || option == "--first")
    {
      first = std::strtoull(value, nullptr, 10);
      single = option == "--case";
    }
    else
    {
      std::cerr << "splatfuzz [--seconds N] [--cases N] [--seed S] [--first K] [--case K] "
                   "[--verbose]\n";
      return 2;
    }
    ++a;
  }

  if (__sanitizer_set_death_callback)
  {
    __sanitizer_set_death_callback(TellCase);
  }
  else
  {
    std::signal(SIGSEGV, OnSignal);
  }
  std::signal(SIGABRT, OnSignal);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Messages> messages;
  messages->Verbose = verbose;
  vtkOutputWindow::SetInstance(messages);

  int findings = 0;
  unsigned long long cases = 0;
  most = single ? 1 : most;
  double longest = 0;
  unsigned long long slowest = 0;
  const auto start = Clock::now();
  const auto elapsed = [start] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  {
    FuzzScenes scenes(*messages);
    // Not when a case is looked at alone, in a debugger say.
    const std::unique_ptr<Watchdog> watchdog(single ? nullptr : new Watchdog);
    for (unsigned long long k = first; cases < most && (single || elapsed() < seconds); ++k)
    {
      CurrentCase = k;
      FuzzRandom random(FuzzRandom::Mix(Seed, k));
      const std::uint64_t windowSeed = FuzzRandom::Mix(~Seed, k / RunsPerWindow);
      if (k % RunsPerWindow == 0 || k == first)
      {
        scenes.Reset(windowSeed);
      }
      const double began = elapsed();
      try
      {
        if (random.Chance(SceneShare))
        {
          scenes.Run(random);
        }
        else
        {
          FuzzFilters(random);
        }
      }
      catch (const FuzzFinding& finding)
      {
        std::cerr << "splatfuzz: FOUND " << finding.What << "\n";
        TellCase();
        scenes.Reset(windowSeed);
        if (++findings == MostFindings)
        {
          break;
        }
      }
      messages->TakeOwn();
      ++cases;
      const double took = elapsed() - began;
      slowest = took > longest ? k : slowest;
      longest = std::max(longest, took);
    }
  }
  vtkOutputWindow::SetInstance(nullptr);
  std::cout << "splatfuzz: " << cases << " cases in " << elapsed() << " s, " << messages->Count
            << " messages, " << findings << " findings; the slowest, case " << slowest << ", took "
            << longest << " s\n";
  return findings > 0 ? 1 : 0;
}
