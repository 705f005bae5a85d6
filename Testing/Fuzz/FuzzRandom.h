// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The random numbers of a case: all of it follows from its seed, on every machine.
#ifndef FuzzRandom_h
#define FuzzRandom_h

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

class FuzzRandom
{
public:
  explicit FuzzRandom(std::uint64_t seed)
    : State(seed)
  {
  }
  /// The seed of a case among many (SplitMix64).
  static std::uint64_t Mix(std::uint64_t seed, std::uint64_t index)
  {
    return FuzzRandom(seed + 0x632be59bd9b4e019ull * (index + 1)).Next();
  }
  std::uint64_t Next()
  {
    std::uint64_t z = (this->State += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// 0 to n - 1.
  int Below(int n) { return static_cast<int>(this->Next() % static_cast<std::uint64_t>(n)); }
  double Uniform() { return static_cast<double>(this->Next() >> 11) * 0x1p-53; }
  double Uniform(double a, double b) { return a + (b - a) * this->Uniform(); }
  bool Chance(double p) { return this->Uniform() < p; }
  template <typename T>
  T Pick(std::initializer_list<T> values)
  {
    return *(values.begin() + this->Below(static_cast<int>(values.size())));
  }
  /// From some decades.
  double Scale(double least, double most)
  {
    return std::pow(10.0, this->Uniform(std::log10(least), std::log10(most)));
  }
  /// A number that programs trip over.
  double Nasty()
  {
    constexpr double Inf = std::numeric_limits<double>::infinity();
    constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
    return this->Pick({ 0.0, -0.0, NaN, Inf, -Inf, 1e30, -1e30, 1e19, 3e38, -3e38, 1e300, -1e308,
      1e-30, 1e-45, 4e-320, 1.0, -1.0, 2147483648.0, 1e-7 });
  }
  /// A value for a property: what is usual, or an extreme.
  double Property(double least, double most)
  {
    return this->Chance(0.2) ? this->Nasty() : this->Uniform(least, most);
  }

private:
  std::uint64_t State;
};

#endif
