// SPDX-License-Identifier: Apache-2.0
#include "law/update/first_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::law {
namespace {

/// Root of h(x) = trial - kappa x - F_lim(x) in [low, high] with h(low) > 0 >= h(high), by Newton's
/// method held inside a shrinking bracket; bisection wherever Newton leaves it or stalls.
template <class LimitOf>
double bracketed_root(const LimitOf& limit, double trial, double kappa, double low,
                      double high) noexcept {
  double x = high;
  double previous_width = high - low;
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Limit here = limit(x);
    const double h = trial - kappa * x - here.force;
    // Below this h is its own rounding, and Newton would be led about by it.
    if (std::abs(h) <= std::numeric_limits<double>::epsilon() * trial) return x;
    if (h > 0.0) {
      low = x;
    } else {
      high = x;
    }
    const double width = high - low;
    if (width <= 2.0 * std::numeric_limits<double>::epsilon() * high) break;
    const double slope = -kappa - limit.slope(here);
    double next = x - h / slope;
    const bool stalled = iteration > 2 && width > 0.5 * previous_width && iteration % 3 == 0;
    if (!(next > low && next < high) || stalled) next = low + 0.5 * width;
    if (iteration % 3 == 0) previous_width = width;
    // Newton has converged when its step is below the last digit of x.
    if (std::abs(next - x) <= std::numeric_limits<double>::epsilon() * high) return next;
    x = next;
  }
  // The side where the force lies on or below the limit.
  return high;
}

/// The slip x in [low, high] where h is smallest, h' changing sign from - to + inside: bisection.
template <class LimitOf>
double lowest_point(const LimitOf& limit, double kappa, double low, double high) noexcept {
  for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
    const double middle = low + 0.5 * (high - low);
    (-kappa - limit.slope(limit(middle)) < 0.0 ? low : high) = middle;
  }
  return low + 0.5 * (high - low);
}

/// Finds the slip in [low, high] that parts convex from concave where F_lim is cubic: F_lim' is a
/// parabola through three of its points, this its vertex. Without one inside, `high`.
template <class LimitOf>
double vertex_or_end(const LimitOf& limit, double low, double high) noexcept {
  const double margin = margin_inside(low, high, limit.begin_slip());
  const double half = 0.5 * (high - low);
  const auto slope_at = [&](double x) { return limit.slope(limit(x)); };
  const double slope_low = slope_at(low + margin);
  const double slope_high = slope_at(high - margin);
  const double bend = 0.5 * (slope_low + slope_high) - slope_at(low + half);
  // Without a bend it is infinite, or no number: in no piece either way.
  const double vertex = -0.25 * (slope_high - slope_low) / bend;
  if (!(std::abs(vertex) < 1.0 - 1e-6)) return high;
  const double slip = low + half + vertex * half;
  return slip > low ? slip : high;
}

}  // namespace

template <class LimitOf>
double first_root(const LimitOf& limit, double trial, double kappa) noexcept {
  const double end = trial / kappa;
  double low = 0.0;
  // Before trial - kappa x has come down to the cap there is no root, and behind that point the cap
  // is above every root: its corners need no search.
  const double at_cap = (trial - limit.cap()) / kappa;
  if (at_cap > 0.0) {
    if (limit(at_cap).force >= limit.cap()) return at_cap;
    low = at_cap;
  }
  const auto slope_at = [&](double x) { return -kappa - limit.slope(limit(x)); };
  double knot = low;
  while (low < end) {
    // Behind a vertex the rest of its piece follows, undivided: a parabola has no second one.
    double high = knot;
    if (low >= knot) {
      knot = std::min(limit.next_knot(low, end), end);
      high = limit.is_cubic() ? vertex_or_end(limit, low, knot) : knot;
    }
    const double margin = margin_inside(low, high, limit.begin_slip());
    const double h = trial - kappa * high - limit(high).force;
    if (h < -1e-12 * trial) {  // far above its rounding
      return bracketed_root(limit, trial, kappa, low, high);
    }
    // No h < 0 at either end: a dip between them could still hide a root, or an earlier one.
    if (slope_at(low + margin) < 0.0 && slope_at(high - margin) > 0.0) {
      const double dip = lowest_point(limit, kappa, low, high);
      if (trial - kappa * dip - limit(dip).force <= 0.0) {
        return bracketed_root(limit, trial, kappa, low, dip);
      }
    }
    if (h <= 0.0) return bracketed_root(limit, trial, kappa, low, high);
    low = high;
  }
  return end;
}

template <class LimitOf>
bool has_later_root(const LimitOf& limit, double trial, double kappa, double root) noexcept {
  const double end = trial / kappa;
  double x = limit.next_knot(root, end);
  while (x < end) {
    if (trial - kappa * x - limit(x).force > 0.0) return true;
    x = limit.next_knot(x, end);
  }
  return false;
}

template <class LimitOf>
double first_zero(const LimitOf& limit, double slip) noexcept {
  if (!(limit(0.0).force > 0.0)) return 0.0;
  double low = 0.0;
  double high = slip;
  for (int i = 0; i < 200 && high - low > std::numeric_limits<double>::epsilon() * high; ++i) {
    const double middle = low + 0.5 * (high - low);
    (limit(middle).force > 0.0 ? low : high) = middle;
  }
  return high;
}

template double first_root(const LimitFunction&, double, double) noexcept;
template bool has_later_root(const LimitFunction&, double, double, double) noexcept;
template double first_zero(const LimitFunction&, double) noexcept;
template double first_root(const CapstanLimit&, double, double) noexcept;
template bool has_later_root(const CapstanLimit&, double, double, double) noexcept;
template double first_zero(const CapstanLimit&, double) noexcept;

}  // namespace slipbench::law
