// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace slipbench::test {

/// Returns what SLIPBENCH_TEST_SEED adds to the seeds of all random cases: 0 where it is not set.
inline std::uint64_t seed_of_the_night() {
  const char* text = std::getenv("SLIPBENCH_TEST_SEED");
  return text == nullptr ? 0 : std::strtoull(text, nullptr, 10) << 20;
}

/// Random numbers that are the same on every machine: std::mt19937_64 is fixed by the standard, the
/// distributions of the standard library are not. Which argument of a call draws first is up to the
/// compiler: clang makes other random definitions than g++.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed + seed_of_the_night()) {}

  /// Uniform in [low, high).
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  /// Uniform multiple of 2^-24 in [low, high]: sums and differences of such numbers are exact.
  double dyadic(double low, double high) {
    return std::round(between(low, high) * 0x1p24) * 0x1p-24;
  }
  /// 0 .. count-1
  int pick(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool chance(double probability) { return between(0.0, 1.0) < probability; }
  template <class T>
  const T& one_of(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(pick(static_cast<int>(list.size())))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace slipbench::test
