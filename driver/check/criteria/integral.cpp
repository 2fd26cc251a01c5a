// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/integral.hpp"

#include <cmath>

namespace slipbench::driver::check {
namespace {

double step(const Series& curve, std::size_t i) {
  return curve.abscissa[i] - curve.abscissa[i - 1];
}

double mean(const Series& curve, std::size_t i) {
  return 0.5 * (curve.value[i] + curve.value[i - 1]);
}

/// The mean magnitude of a straight piece: two triangles if it changes its sign.
double mean_magnitude(double a, double b) {
  if ((a < 0.0) == (b < 0.0)) return 0.5 * (std::abs(a) + std::abs(b));
  return 0.5 * (a * a + b * b) / (std::abs(a) + std::abs(b));
}

}  // namespace

double work(const Series& curve, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t i = first + 1; i <= last; ++i) sum += mean(curve, i) * step(curve, i);
  return sum;
}

double integral_over_way(const Series& curve) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) sum += mean(curve, i) * std::abs(step(curve, i));
  return sum;
}

double magnitude_integral(const Series& curve) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    sum += mean_magnitude(curve.value[i - 1], curve.value[i]) * std::abs(step(curve, i));
  }
  return sum;
}

double way(const Series& curve) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) sum += std::abs(step(curve, i));
  return sum;
}

}  // namespace slipbench::driver::check
