// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/sprague_geers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "driver/check/criteria/ascending.hpp"
#include "driver/check/criteria/bounds.hpp"

namespace slipbench::driver::check {
namespace {

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// The integral over a piece of the square of what runs linearly from `a` to `b`.
double square_integral(double width, double a, double b) {
  return width / 3.0 * (a * a + a * b + b * b);
}

Measure error(std::string name, double value, double tolerance) {
  return {.name = std::move(name),
          .unit = MeasureUnit::kNone,
          .value = value,
          .reference = 0.0,
          .deviation = std::abs(value),
          .scale = 1.0,
          .tolerance = tolerance,
          .where = {}};
}

}  // namespace

CurveComparison compare_sprague_geers(const Series& result, const Series& reference,
                                      const cases::Tolerance& tolerance) {
  const AscendingCurves curves = ascending_curves(result, reference);
  CurveComparison out;
  out.fault = curves.fault;
  if (!out.fault.empty()) return out;
  out.compared = curves.compared;

  // Squares of the values themselves might leave the range of a double.
  const double f_size = largest_magnitude(curves.result.value);
  const double r_size = largest_magnitude(curves.reference.value);
  const double f_unit = f_size > 0.0 ? 1.0 / f_size : 0.0;
  const double r_unit = r_size > 0.0 ? 1.0 / r_size : 0.0;
  double ff = 0.0, rr = 0.0;
  for_each_piece(curves, [&](double width, double f0, double f1, double r0, double r1) {
    ff += square_integral(width, f0 * f_unit, f1 * f_unit);
    rr += square_integral(width, r0 * r_unit, r1 * r_unit);
  });
  if (rr == 0.0) {
    out.fault = "the reference is zero throughout: its errors of magnitude and phase are undefined";
    return out;
  }
  const double f_norm = std::sqrt(ff), r_norm = std::sqrt(rr);
  const double magnitude = f_size / r_size * (f_norm / r_norm) - 1.0;

  // The angle between two unit vectors by their difference and sum: an arccosine of nearly 1 would
  // lose half of the digits.
  double phase = 0.5;
  if (ff > 0.0) {
    double apart = 0.0, together = 0.0;
    for_each_piece(curves, [&](double width, double f0, double f1, double r0, double r1) {
      const double u0 = f0 * f_unit / f_norm, u1 = f1 * f_unit / f_norm;
      const double v0 = r0 * r_unit / r_norm, v1 = r1 * r_unit / r_norm;
      apart += square_integral(width, u0 - v0, u1 - v1);
      together += square_integral(width, u0 + v0, u1 + v1);
    });
    phase = 2.0 / std::numbers::pi * std::atan2(std::sqrt(apart), std::sqrt(together));
  }

  constexpr double kOnlyReported = std::numeric_limits<double>::infinity();
  out.measures.push_back(
      error("comprehensive error", std::hypot(magnitude, phase), value_bound(tolerance, 1.0)));
  out.measures.push_back(error("magnitude error", magnitude, kOnlyReported));
  out.measures.push_back(error("phase error", phase, kOnlyReported));
  return out;
}

}  // namespace slipbench::driver::check
