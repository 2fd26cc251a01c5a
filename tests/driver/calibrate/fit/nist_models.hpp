// SPDX-License-Identifier: Apache-2.0
// The models of the nonlinear regression problems of NIST's Statistical Reference Datasets.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>

namespace slipbench::nist {

/// A number with its derivatives to up to nine parameters.
struct Dual {
  double value = 0.0;
  std::array<double, 9> slope{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: constants take part in formulas

  /// f(this) with f' = `by`.
  Dual mapped(double result, double by) const {
    Dual mapped(result);
    for (std::size_t j = 0; j < slope.size(); ++j) mapped.slope[j] = by * slope[j];
    return mapped;
  }
  /// The result of two operands with the partial derivatives `by_a` and `by_b`.
  static Dual combined(double result, const Dual& a, double by_a, const Dual& b, double by_b) {
    Dual combined(result);
    for (std::size_t j = 0; j < a.slope.size(); ++j) {
      combined.slope[j] = by_a * a.slope[j] + by_b * b.slope[j];
    }
    return combined;
  }
};

inline Dual operator-(const Dual& a) { return a.mapped(-a.value, -1.0); }
inline Dual operator+(const Dual& a, const Dual& b) {
  return Dual::combined(a.value + b.value, a, 1.0, b, 1.0);
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return Dual::combined(a.value - b.value, a, 1.0, b, -1.0);
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return Dual::combined(a.value * b.value, a, b.value, b, a.value);
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return Dual::combined(quotient, a, 1.0 / b.value, b, -quotient / b.value);
}
inline Dual exp(const Dual& a) {
  const double e = std::exp(a.value);
  return a.mapped(e, e);
}
inline Dual sin(const Dual& a) { return a.mapped(std::sin(a.value), std::cos(a.value)); }
inline Dual cos(const Dual& a) { return a.mapped(std::cos(a.value), -std::sin(a.value)); }
inline Dual atan(const Dual& a) {
  return a.mapped(std::atan(a.value), 1.0 / (1.0 + a.value * a.value));
}
inline Dual pow(const Dual& a, const Dual& b) {
  const double p = std::pow(a.value, b.value);
  return Dual::combined(p, a, b.value * std::pow(a.value, b.value - 1.0), b, p * std::log(a.value));
}

/// The response the problem `name` models at the predictors x, for parameters b. Nelson's response
/// is the logarithm of the measured one.
template <class T>
T model(std::string_view name, std::span<const T> b, std::span<const double> predictors) {
  using std::atan;
  using std::cos;
  using std::exp;
  using std::pow;
  using std::sin;
  const double x = predictors[0];
  const auto peak = [&](const T& height, const T& middle, const T& width) {
    const T distance = (T(x) - middle) / width;
    return height * exp(-(distance * distance));
  };
  const auto polynomial = [&](std::size_t first, std::size_t last, const T& constant) {
    T sum = T(0.0);
    for (std::size_t j = last + 1; j-- > first;) sum = (sum + b[j]) * T(x);
    return sum + constant;
  };
  if (name == "Misra1a" || name == "BoxBOD") return b[0] * (T(1.0) - exp(-(b[1] * T(x))));
  if (name == "Chwirut1" || name == "Chwirut2") return exp(-(b[0] * T(x))) / (b[1] + b[2] * T(x));
  if (name.starts_with("Lanczos")) {
    return b[0] * exp(-(b[1] * T(x))) + b[2] * exp(-(b[3] * T(x))) + b[4] * exp(-(b[5] * T(x)));
  }
  if (name.starts_with("Gauss")) {
    return b[0] * exp(-(b[1] * T(x))) + peak(b[2], b[3], b[4]) + peak(b[5], b[6], b[7]);
  }
  if (name == "DanWood") return b[0] * pow(T(x), b[1]);
  if (name == "Misra1b") {
    const T root = T(1.0) + b[1] * T(0.5 * x);
    return b[0] * (T(1.0) - T(1.0) / (root * root));
  }
  if (name == "Kirby2") return polynomial(1, 2, b[0]) / polynomial(3, 4, T(1.0));
  if (name == "Hahn1" || name == "Thurber") {
    return polynomial(1, 3, b[0]) / polynomial(4, 6, T(1.0));
  }
  if (name == "Nelson") return b[0] - b[1] * T(x) * exp(-(b[2] * T(predictors[1])));
  if (name == "MGH17") return b[0] + b[1] * exp(-(b[3] * T(x))) + b[2] * exp(-(b[4] * T(x)));
  if (name == "Misra1c") {
    return b[0] * (T(1.0) - pow(T(1.0) + T(2.0 * x) * b[1], T(-0.5)));
  }
  if (name == "Misra1d") return b[0] * b[1] * T(x) / (T(1.0) + b[1] * T(x));
  if (name == "Roszman1") {
    return b[0] - b[1] * T(x) - atan(b[2] / (T(x) - b[3])) / T(std::numbers::pi);
  }
  if (name == "ENSO") {
    const double turn = 2.0 * std::numbers::pi * x;
    return b[0] + b[1] * T(std::cos(turn / 12.0)) + b[2] * T(std::sin(turn / 12.0)) +
           b[4] * cos(T(turn) / b[3]) + b[5] * sin(T(turn) / b[3]) + b[7] * cos(T(turn) / b[6]) +
           b[8] * sin(T(turn) / b[6]);
  }
  if (name == "MGH09") return b[0] * (T(x * x) + T(x) * b[1]) / (T(x * x) + T(x) * b[2] + b[3]);
  if (name == "Rat42") return b[0] / (T(1.0) + exp(b[1] - b[2] * T(x)));
  if (name == "MGH10") return b[0] * exp(b[1] / (T(x) + b[2]));
  if (name == "Eckerle4") {
    const T distance = (T(x) - b[2]) / b[1];
    return b[0] / b[1] * exp(T(-0.5) * distance * distance);
  }
  if (name == "Rat43") return b[0] / pow(T(1.0) + exp(b[1] - b[2] * T(x)), T(1.0) / b[3]);
  if (name == "Bennett5") return b[0] * pow(b[1] + T(x), T(-1.0) / b[2]);
  return T(std::nan(""));
}

}  // namespace slipbench::nist
