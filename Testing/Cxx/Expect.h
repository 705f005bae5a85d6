// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a test without a window expects, counted where it fails.
#ifndef Expect_h
#define Expect_h

#include <iostream>
#include <string>

inline int failures = 0;

inline void Expect(bool good, const std::string& what)
{
  if (!good)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
}

inline void AtMost(double value, double bound, const std::string& what)
{
  // NaN compares false.
  Expect(value <= bound,
    what + ": " + std::to_string(value) + " is more than " + std::to_string(bound));
}

inline void AtLeast(double value, double bound, const std::string& what)
{
  Expect(value >= bound,
    what + ": " + std::to_string(value) + " is less than " + std::to_string(bound));
}

#endif
