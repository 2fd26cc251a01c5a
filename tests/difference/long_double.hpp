// SPDX-License-Identifier: Apache-2.0
// Read before everything else by what is compiled with 64 bits of mantissa: the law's own sources,
// without a change, where `double` is `long double` and the namespace `law` is `law_long`. The
// standard library and Eigen come first and keep their doubles.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// Literals keep their type, and the templates of std do not take two types.
namespace std {  // NOLINT(cert-dcl58-cpp)
constexpr long double max(long double a, long double b) { return a < b ? b : a; }
constexpr long double min(long double a, long double b) { return b < a ? b : a; }
constexpr long double max(initializer_list<long double> all) {
  return *max_element(all.begin(), all.end());
}
constexpr long double min(initializer_list<long double> all) {
  return *min_element(all.begin(), all.end());
}
constexpr long double clamp(long double x, long double low, long double high) {
  return x < low ? low : high < x ? high : x;
}
/// Tells the rounding and the range of double, whatever the number: how near to its limit a force
/// counts as on it, and where a search ends, belongs to the law, and both are to decide alike.
template <class Number>
struct limits_of_double : numeric_limits<Number> {};
template <>
struct limits_of_double<long double> {
  static constexpr long double epsilon() { return numeric_limits<double>::epsilon(); }
  static constexpr long double infinity() { return numeric_limits<double>::infinity(); }
  static constexpr long double quiet_NaN() { return numeric_limits<double>::quiet_NaN(); }
  static constexpr long double max() { return numeric_limits<double>::max(); }
  static constexpr long double lowest() { return numeric_limits<double>::lowest(); }
  static constexpr long double min() { return numeric_limits<double>::min(); }
};
/// Vanishes where that of double does: a coefficient that is 0 is another case than a small one.
inline long double exp_of_double(long double x) {
  const long double y = exp(x);
  return y < 0.5L * numeric_limits<double>::denorm_min() ? 0.0L : y;
}
}  // namespace std

// One word: double(x) and double{x} stay valid.
using SlipbenchLongDouble = long double;
#define double SlipbenchLongDouble
#define exp exp_of_double
#define numeric_limits limits_of_double
#define law law_long
