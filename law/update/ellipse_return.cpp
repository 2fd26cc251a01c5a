// SPDX-License-Identifier: Apache-2.0
#include "law/update/ellipse_return.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/definition/limit_function.hpp"

namespace slipbench::law {
namespace {

constexpr PlaneVector kNothing{};

double length(const PlaneVector& v) { return std::hypot(v[0], v[1]); }

/// A force bounded alone along the one axis of an ellipse without width.
PlaneVector on_the_other_axis(const PlaneVector& trial, const PlaneVector& bounds) {
  PlaneVector force{};
  for (std::size_t i = 0; i < 2; ++i) {
    if (bounds[i] > 0.0) force[i] = std::clamp(trial[i], -bounds[i], bounds[i]);
  }
  return force;
}
PlaneVector on_the_other_axis_change(const PlaneVector& trial, const PlaneVector& bounds,
                                     const PlaneVector& trial_change,
                                     const PlaneVector& bounds_change) {
  PlaneVector change{};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!(bounds[i] > 0.0)) continue;
    const bool outside = std::abs(trial[i]) > bounds[i] * kLimitSlack;
    change[i] =
        outside ? std::copysign(bounds_change[i], trial[i] * bounds_change[i]) : trial_change[i];
  }
  return change;
}

bool has_no_width(const PlaneVector& bounds) { return !(bounds[0] > 0.0 && bounds[1] > 0.0); }

/// h_i = b_i f_i / (b_i^2 + L) and the divisors.
struct Projected {
  PlaneVector h{};
  PlaneVector divisor{};
  double size = 0.0;  ///< |h|
};
Projected projected(const PlaneVector& f, const PlaneVector& b, double multiplier) {
  Projected p;
  for (std::size_t i = 0; i < 2; ++i) {
    p.divisor[i] = b[i] * b[i] + multiplier;
    p.h[i] = f[i] * (b[i] / p.divisor[i]);
  }
  p.size = length(p.h);
  return p;
}

/// The multiplier L of a trial f outside the ellipse of half axes b > 0, the larger of them 1.
double multiplier_of(const PlaneVector& f, const PlaneVector& b) {
  // Neither |h_i| may exceed 1.
  double multiplier =
      std::max({0.0, b[0] * (std::abs(f[0]) - b[0]), b[1] * (std::abs(f[1]) - b[1])});
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps; ++step) {
    const Projected p = projected(f, b, multiplier);
    if (!(p.size > 1.0)) break;
    const double x = p.h[0] / p.size, y = p.h[1] / p.size;
    const double next = multiplier + (p.size - 1.0) / (x * x / p.divisor[0] + y * y / p.divisor[1]);
    if (!(next > multiplier)) break;
    multiplier = next;
  }
  return multiplier;
}

}  // namespace

bool within_ellipse(const PlaneVector& force, const PlaneVector& bounds) noexcept {
  PlaneVector part{};
  for (std::size_t i = 0; i < 2; ++i) {
    if (force[i] == 0.0) continue;
    if (!(bounds[i] > 0.0)) return false;
    part[i] = force[i] / bounds[i];
  }
  return part[0] * part[0] + part[1] * part[1] <= kLimitSlack * kLimitSlack;
}

PlaneVector steady_on_ellipse(const PlaneVector& motion, const PlaneVector& bounds) noexcept {
  const double largest = std::max(std::abs(motion[0]), std::abs(motion[1]));
  const double widest = std::max(bounds[0], bounds[1]);
  if (!(largest > 0.0) || !(widest > 0.0)) return kNothing;
  PlaneVector h{};
  for (std::size_t i = 0; i < 2; ++i) h[i] = (bounds[i] / widest) * (motion[i] / largest);
  const double size = length(h);
  if (!(size > 0.0)) return kNothing;
  return {bounds[0] * (h[0] / size), bounds[1] * (h[1] / size)};
}

double ellipse_radius(const PlaneVector& direction, const PlaneVector& bounds) noexcept {
  double inverse = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (direction[i] == 0.0) continue;
    if (!(bounds[i] > 0.0)) return 0.0;
    inverse = std::hypot(inverse, direction[i] / bounds[i]);
  }
  return inverse > 0.0 ? 1.0 / inverse : 0.0;
}

PlaneVector closest_on_ellipse(const PlaneVector& trial, const PlaneVector& bounds) noexcept {
  if (within_ellipse(trial, bounds)) return trial;
  if (has_no_width(bounds)) return on_the_other_axis(trial, bounds);
  const double scale = std::max(bounds[0], bounds[1]);
  const PlaneVector b{bounds[0] / scale, bounds[1] / scale};
  const PlaneVector f{trial[0] / scale, trial[1] / scale};
  // So far out that the closest point is the steady one.
  if (!std::isfinite(f[0]) || !std::isfinite(f[1])) return steady_on_ellipse(trial, bounds);
  const Projected p = projected(f, b, multiplier_of(f, b));
  // |h| = 1 up to rounding; made exact, so that the force lies on the ellipse.
  return {bounds[0] * (p.h[0] / p.size), bounds[1] * (p.h[1] / p.size)};
}

PlaneVector closest_on_ellipse_change(const PlaneVector& trial, const PlaneVector& bounds,
                                      const PlaneVector& trial_change,
                                      const PlaneVector& bounds_change) noexcept {
  if (within_ellipse(trial, bounds)) return trial_change;
  if (has_no_width(bounds)) {
    return on_the_other_axis_change(trial, bounds, trial_change, bounds_change);
  }
  const double scale = std::max(bounds[0], bounds[1]);
  const PlaneVector b{bounds[0] / scale, bounds[1] / scale};
  const PlaneVector f{trial[0] / scale, trial[1] / scale};
  const PlaneVector df{trial_change[0] / scale, trial_change[1] / scale};
  const PlaneVector db{bounds_change[0] / scale, bounds_change[1] / scale};
  const Projected p = projected(f, b, multiplier_of(f, b));
  // d|h|^2 = 0 gives dL.
  PlaneVector fixed{};  // dh at a fixed L
  double numerator = 0.0;
  double denominator = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    fixed[i] = (db[i] * f[i] + b[i] * df[i] - 2.0 * p.h[i] * b[i] * db[i]) / p.divisor[i];
    numerator += p.h[i] * fixed[i];
    denominator += p.h[i] * p.h[i] / p.divisor[i];
  }
  const double dl = numerator / denominator;
  PlaneVector change{};
  for (std::size_t i = 0; i < 2; ++i) {
    change[i] = scale * (db[i] * p.h[i] + b[i] * (fixed[i] - p.h[i] * dl / p.divisor[i]));
  }
  return change;
}

namespace {

/// The ratio return in the coordinates p_i = (F*_i/a_i)/sqrt e of the unit circle, for half axes
/// over the larger one. Without the difference of large terms G has the entries, up to a common
/// factor, b_i p_i s_i with
///   s_i = b_j^2/sqrt e + p_j^2 (b_i^2 - b_j^2),   j the other entry,
/// and the force at the angle of |G| has F_i/a_i in proportion to p_i |s_i|.
struct RatioPoint {
  PlaneVector b{};
  PlaneVector p{};
  PlaneVector s{};
  double inverse_root = 0.0;  ///< 1/sqrt e
};
RatioPoint ratio_point(const PlaneVector& trial, const PlaneVector& bounds) {
  RatioPoint point;
  const double scale = std::max(bounds[0], bounds[1]);
  const double largest = std::max(std::abs(trial[0]), std::abs(trial[1]));
  for (std::size_t i = 0; i < 2; ++i) {
    point.b[i] = bounds[i] / scale;
    point.p[i] = (trial[i] / largest) / point.b[i];
  }
  const double size = length(point.p);
  for (double& p : point.p) p /= size;
  point.inverse_root = (scale / largest) / size;
  for (std::size_t i = 0; i < 2; ++i) {
    const double own = point.b[i], other = point.b[1 - i], p = point.p[1 - i];
    point.s[i] = other * other * point.inverse_root + p * p * (own - other) * (own + other);
  }
  return point;
}

}  // namespace

PlaneVector ratio_on_ellipse(const PlaneVector& trial, const PlaneVector& bounds) noexcept {
  if (within_ellipse(trial, bounds)) return trial;
  if (has_no_width(bounds)) return on_the_other_axis(trial, bounds);
  const RatioPoint point = ratio_point(trial, bounds);
  const PlaneVector h{point.p[0] * std::abs(point.s[0]), point.p[1] * std::abs(point.s[1])};
  const double size = length(h);
  if (!(size > 0.0)) return kNothing;
  return {bounds[0] * (h[0] / size), bounds[1] * (h[1] / size)};
}

PlaneVector ratio_on_ellipse_change(const PlaneVector& trial, const PlaneVector& bounds,
                                    const PlaneVector& trial_change,
                                    const PlaneVector& bounds_change) noexcept {
  if (within_ellipse(trial, bounds)) return trial_change;
  if (has_no_width(bounds)) {
    return on_the_other_axis_change(trial, bounds, trial_change, bounds_change);
  }
  const RatioPoint point = ratio_point(trial, bounds);
  const double scale = std::max(bounds[0], bounds[1]);
  const PlaneVector db{bounds_change[0] / scale, bounds_change[1] / scale};
  PlaneVector relative{};  // d(F*_i/a_i) / sqrt e
  for (std::size_t i = 0; i < 2; ++i) {
    relative[i] = trial_change[i] / bounds[i] * point.inverse_root -
                  point.p[i] * bounds_change[i] / bounds[i];
  }
  const double growth = point.p[0] * relative[0] + point.p[1] * relative[1];  // d(ln sqrt e)
  const PlaneVector dp{relative[0] - growth * point.p[0], relative[1] - growth * point.p[1]};
  PlaneVector h{}, dh{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t j = 1 - i;
    const double own = point.b[i], other = point.b[j], p = point.p[j];
    const double ds = other * point.inverse_root * (2.0 * db[j] - other * growth) +
                      2.0 * p * dp[j] * (own - other) * (own + other) +
                      2.0 * p * p * (own * db[i] - other * db[j]);
    h[i] = point.p[i] * std::abs(point.s[i]);
    dh[i] = dp[i] * std::abs(point.s[i]) + point.p[i] * std::copysign(1.0, point.s[i]) * ds;
  }
  const double size = length(h);
  if (!(size > 0.0)) return kNothing;
  const double dsize = (h[0] * dh[0] + h[1] * dh[1]) / size;
  PlaneVector change{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double unit = h[i] / size;
    change[i] = bounds_change[i] * unit + bounds[i] * (dh[i] - unit * dsize) / size;
  }
  return change;
}

}  // namespace slipbench::law
