// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <type_traits>

namespace slipbench::law {

/// A number with its derivatives to N others (forward mode): every operation carries them along by
/// the chain rule. Of T = Dual again they are the second derivatives. Numbers compare by their
/// value, so that a branch of a formula is that of the value.
template <class T, std::size_t N>
struct Dual {
  T value{};
  std::array<T, N> slope{};

  constexpr Dual() = default;
  constexpr Dual(double constant) : value(constant) {}  // NOLINT: a constant is a number
  /// The i-th of the N numbers themselves.
  static constexpr Dual variable(const T& value, std::size_t i) {
    Dual x;
    x.value = value;
    x.slope[i] = T(1.0);
    return x;
  }

  friend Dual operator-(const Dual& a) { return chain(a, -a.value, T(-1.0)); }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return chain(a, b, a.value + b.value, T(1.0), T(1.0));
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return chain(a, b, a.value - b.value, T(1.0), T(-1.0));
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return chain(a, b, a.value * b.value, b.value, a.value);
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const T quotient = a.value / b.value;
    return chain(a, b, quotient, T(1.0) / b.value, -quotient / b.value);
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend constexpr std::partial_ordering operator<=>(const Dual& a, const Dual& b) {
    return a.value <=> b.value;
  }

  friend Dual abs(const Dual& x) { return x < Dual() ? -x : x; }
  friend Dual exp(const Dual& x) {
    using std::exp;
    const T power = exp(x.value);
    return chain(x, power, power);
  }
  friend Dual log(const Dual& x) {
    using std::log;
    return chain(x, log(x.value), T(1.0) / x.value);
  }
  friend Dual log1p(const Dual& x) {
    using std::log1p;
    return chain(x, log1p(x.value), T(1.0) / (T(1.0) + x.value));
  }
  friend Dual sqrt(const Dual& x) {
    using std::sqrt;
    const T root = sqrt(x.value);
    return chain(x, root, T(0.5) / root);
  }
  friend Dual tanh(const Dual& x) {
    using std::tanh;
    const T ratio = tanh(x.value);
    return chain(x, ratio, T(1.0) - ratio * ratio);
  }
  friend Dual atan(const Dual& x) {
    using std::atan;
    return chain(x, atan(x.value), T(1.0) / (T(1.0) + x.value * x.value));
  }
  friend Dual asinh(const Dual& x) {
    using std::asinh;
    using std::sqrt;
    return chain(x, asinh(x.value), T(1.0) / sqrt(T(1.0) + x.value * x.value));
  }
  /// x^p of x >= 0. At x = 0 the slope to p counts as 0, that of x^0 to x too.
  friend Dual pow(const Dual& x, const Dual& p) {
    using std::log;
    using std::pow;
    const T power = pow(x.value, p.value);
    const T to_base = p.value == T() ? T() : p.value * pow(x.value, p.value - T(1.0));
    return chain(x, p, power, to_base, x.value > T() ? power * log(x.value) : T());
  }

 private:
  /// A number that does not change changes nothing, however steep the formula is there (sqrt at 0).
  static T product(const T& derivative, const T& slope) {
    if constexpr (std::is_same_v<T, double>) return slope == 0.0 ? 0.0 : derivative * slope;
    return derivative * slope;
  }
  static Dual chain(const Dual& a, const T& value, const T& to_a) {
    Dual result;
    result.value = value;
    for (std::size_t i = 0; i < N; ++i) result.slope[i] = product(to_a, a.slope[i]);
    return result;
  }
  static Dual chain(const Dual& a, const Dual& b, const T& value, const T& to_a, const T& to_b) {
    Dual result;
    result.value = value;
    for (std::size_t i = 0; i < N; ++i) {
      result.slope[i] = product(to_a, a.slope[i]) + product(to_b, b.slope[i]);
    }
    return result;
  }
};

}  // namespace slipbench::law
