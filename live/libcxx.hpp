// SPDX-License-Identifier: Apache-2.0
// What the C++ library of emscripten 3.1.6 (libc++ 13) leaves out of C++20 and the bench uses,
// included before everything else.
#pragma once

#include <algorithm>
#include <cfenv>
#include <charconv>
#include <iterator>
#include <thread>
#include <utility>

#include "live/number_text.hpp"

// WebAssembly has no flags of floating point: a formula that divides by zero is told by its result.
#ifndef FE_DIVBYZERO
#define FE_DIVBYZERO 4
#define FE_INVALID 1
#endif

namespace std {

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  return slipbench::live::read_number(first, last, value);
}
inline to_chars_result to_chars(char* first, char* last, double value) {
  return slipbench::live::write_number(first, last, value);
}

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

/// A thread that is waited for at its end.
class jthread {
 public:
  jthread() = default;
  template <class Function>
  explicit jthread(Function&& function) : thread_(std::forward<Function>(function)) {}
  jthread(jthread&&) = default;
  jthread& operator=(jthread&& other) noexcept {
    if (thread_.joinable()) thread_.join();
    thread_ = std::move(other.thread_);
    return *this;
  }
  ~jthread() {
    if (thread_.joinable()) thread_.join();
  }

 private:
  thread thread_;
};

}  // namespace std

namespace std::ranges {

template <class One, class Other>
constexpr bool equal(One&& one, Other&& other) {
  return std::equal(std::begin(one), std::end(one), std::begin(other), std::end(other));
}
template <class Range, class Test, class Value>
constexpr void replace_if(Range&& range, Test test, const Value& value) {
  std::replace_if(std::begin(range), std::end(range), test, value);
}

}  // namespace std::ranges
