// SPDX-License-Identifier: Apache-2.0
// The search for the slip after which a force rests on the limit of a potential (theory 11.7).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "law/base/bisection.hpp"
#include "law/definition/limit_function.hpp"
#include "law/definition/motion.hpp"
#include "law/update/potential_projection.hpp"

namespace slipbench::law {

/// Tells whether P <= F_lim up to rounding: P rounds more often than a norm does, and where forces
/// that do not count cancel in it, by a part of these.
inline bool within(const Potential& potential, const SlipVector& y, double limit) noexcept {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  return value(potential, y) <=
         limit * (1.0 + 32.0 * kEpsilon) + 4.0 * kEpsilon * std::sqrt(dot(y, y));
}

/// Start of the return of an increment; `limit` gives F_lim at a slip, and its slope there, and for
/// first_slip() the knots that LimitFunction has.
template <class LimitOf>
struct Start {
  const Potential& potential;
  const LimitOf& limit;
  SlipVector trial;     ///< y_tr with a fixed stiffness, s_tr with an elastic slip
  double stick = 0.0;   ///< kappa or g_c
  double least = 0.0;   ///< P(0): a limit has to exceed it
  bool fixed = false;   ///< constant kappa
  bool closed = false;  ///< the slip does not depend on F_lim: elastic slip without shifts
};

/// The projection that belongs to one slip dL.
struct Scale {
  double limit = 0.0;  ///< T, of {P <= T}
  double kappa = 0.0;  ///< x = kappa dL
  SlipVector trial;
};

/// Without shifts the return with an elastic slip is done on the slips themselves, T = g_c: P
/// measures them as it does the forces.
template <class LimitOf>
Scale scale_at(const Start<LimitOf>& start, double limit) {
  if (start.fixed) return {limit, start.stick, start.trial};
  if (start.closed) return {start.stick, 1.0, start.trial};
  const double kappa = limit / start.stick;
  return {limit, kappa, scaled(start.trial, kappa)};
}

/// Distance of the force from the limit after the slip dL: positive before it comes to rest.
struct Distance {
  double value = 0.0;  ///< relative to the limit
  double slope = 0.0;  ///< to dL; without the part that shifts have in it
};

template <class LimitOf>
Distance distance(const Start<LimitOf>& start, double slip) noexcept {
  Limit l;
  double fall = 0.0;
  if (!start.closed) {
    l = start.limit(slip);
    // Where the limit vanishes the force is beyond it. With shifts the grip is lost there for good:
    // to come back, the force would have to jump to where it is held.
    if (!(l.force > start.least)) return {start.potential.homogeneous ? 1.0 : -1.0, 0.0};
    if (start.fixed) fall = start.limit.slope(l);
  }
  const Scale scale = scale_at(start, l.force);
  const Potential& potential = start.potential;
  const Projection projection(potential, scale.trial);
  const double x = scale.kappa * slip;
  const double limit = scale.limit;
  if (potential.combine == PotentialOperator::kMax) {
    double needed = 0.0;
    double slope = 0.0;
    for (const PartReturn& part : projection.max_parts(limit)) {
      needed += part.pull;
      if (part.pull > 0.0 && part.stiffness > 0.0) slope -= fall / part.stiffness;
    }
    if (!(needed > 0.0)) {
      // Inside a limit that has risen with the rate: by how much, not only that.
      const double p = value(potential, scale.trial);
      return {(p - limit - x) / limit, -(fall + scale.kappa) / limit};
    }
    return {(needed - x) / limit, (slope - scale.kappa) / limit};
  }
  const double power = potential.exponent - 1.0;
  const auto parts = projection.sum_parts(x, limit);
  std::array<double, kComponents> magnitudes;
  for (std::size_t i = 0; i < parts.size(); ++i) magnitudes[i] = parts[i].magnitude;
  const double p = combine(potential, magnitudes);
  if (!(p > 0.0)) return {-1.0, 0.0};
  double slope = 0.0;  // of p
  for (const PartReturn& part : parts) {
    if (!(part.magnitude > 0.0)) continue;
    const double k = part.stiffness * x * power * part.share / part.magnitude;
    slope += std::pow(part.magnitude / p, power) / (1.0 + k) *
             (-part.stiffness * part.share * scale.kappa + k * part.magnitude * fall / limit);
  }
  // The form in which the Euclidean case, and that of soft thresholds, are straight lines.
  if (power == 0.0) return {p / limit - 1.0, slope / limit - p * fall / (limit * limit)};
  return {1.0 - limit / p, limit * slope / (p * p) - fall / p};
}

/// Root in [low, high], the distance positive at `low` and not at `high`: Newton's method from
/// `guess` in a shrinking bracket.
template <class LimitOf>
double bracketed(const Start<LimitOf>& start, double low, double high, double guess,
                 double rounding = std::numeric_limits<double>::epsilon()) noexcept {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  double x = guess > low && guess < high ? guess : low + 0.5 * (high - low);
  double checked = high - low;
  for (int i = 0; i < 400; ++i) {
    const Distance here = distance(start, x);
    (here.value > 0.0 ? low : high) = x;
    if (std::abs(here.value) <= rounding) return x;
    if (high - low <= 2.0 * kEpsilon * high) break;
    double next = x - here.value / here.slope;
    const bool stalled = i % 4 == 3 && high - low > 0.25 * checked;
    if (i % 4 == 3) checked = high - low;
    if (!(next > low && next < high) || stalled) next = low + 0.5 * (high - low);
    if (std::abs(next - x) <= kEpsilon * x) {
      // Converged, or at the jump where the limit wears away: that one needs its far side.
      if (here.value <= 0.0) return x;
      next = std::min(x * (1.0 + 4.0 * kEpsilon), high);
    }
    x = next;
  }
  return high;
}

/// A limit that no slip changes.
struct ConstantLimit {
  double force = 0.0;
  Limit operator()(double /*slip*/) const noexcept { return {.force = force}; }
  double slope(const Limit& /*limit*/) const noexcept { return 0.0; }
};

/// The slip that a constant stick stiffness needs on the cap of the limit, before which no force is
/// on a lower one; infinity without a cap.
template <class LimitOf>
double slip_at_cap(const Start<LimitOf>& start, double end, double guess) noexcept {
  const ConstantLimit cap{start.limit.cap()};
  const Start<ConstantLimit> capped{start.potential, cap,         start.trial, start.stick,
                                    start.least,     start.fixed, start.closed};
  const bool reaches = start.fixed && cap.force > start.least && std::isfinite(cap.force) &&
                       distance(capped, 0.0).value > 0.0 && distance(capped, end).value <= 0.0;
  return reaches ? bracketed(capped, 0.0, end, guess) : std::numeric_limits<double>::infinity();
}

/// The smallest slip at which the force rests on its limit. Between knots of the limit the search
/// goes in steps of a sixteenth of the way and looks into every dip it sees; two roots within one
/// step that show no dip at its ends are not told apart.
/// \return false if none was found
template <class LimitOf>
bool first_slip(const Start<LimitOf>& start, double* slip) noexcept {
  const Scale at_rest = scale_at(start, start.limit(0.0).force);
  const double kappa = at_rest.kappa > 0.0 ? at_rest.kappa : 1.0;
  double end = Projection(start.potential, at_rest.trial).longest() / kappa;
  // The slip that would do if the force came straight back; with b = 2 it does.
  const SlipVector m = gradient(start.potential, at_rest.trial);
  const double radial =
      (value(start.potential, at_rest.trial) - at_rest.limit) / (kappa * dot(m, m));
  if (!(end > 0.0)) {
    *slip = 0.0;
    return !(start.limit(0.0).force > start.least);
  }
  if (start.closed || !start.limit.depends_on_slip()) {
    for (int i = 0; i < 200 && distance(start, end).value > 0.0; ++i) end *= 2.0;
    *slip = bracketed(start, 0.0, end, radial);
    return distance(start, end).value <= 0.0;
  }
  constexpr int kSteps = 16;
  // On its way there the limit may vanish, so that place is a knot like others.
  const double at_cap = slip_at_cap(start, end, radial);
  double low = 0.0;
  for (int i = 0; i < 200; ++i) {  // an end that shifts push out is followed
    const double step = (end - low) / kSteps;
    while (low < end) {
      double high = std::min({start.limit.next_knot(low, end), low + step, end});
      if (low < at_cap && high >= at_cap) {
        high = at_cap;
        if (start.limit(high).force >= start.limit.cap()) {
          *slip = high;
          return true;
        }
      }
      if (distance(start, high).value <= 0.0) {
        *slip = bracketed(start, low, high, radial);
        return true;
      }
      const double margin = margin_inside(low, high, start.limit.begin_slip());
      // Without a limit the force is beyond it; equilibrium may lie before the place where it
      // vanishes.
      const auto has_limit = [&](double x) { return start.limit(x).force > start.least; };
      const double last = has_limit(high) ? high - margin : turn(low, high, has_limit).low;
      const Distance before = distance(start, last);
      if (before.value <= 0.0) {
        *slip = bracketed(start, low, last, radial);
        return true;
      }
      if (before.slope > 0.0 && distance(start, low + margin).slope < 0.0) {
        double left = low, right = last;
        for (int k = 0; k < 60 && right - left > 1e-15 * right; ++k) {
          const double middle = left + 0.5 * (right - left);
          (distance(start, middle).slope < 0.0 ? left : right) = middle;
        }
        if (distance(start, right).value <= 0.0) {
          *slip = bracketed(start, low, right, radial);
          return true;
        }
      }
      low = high;
    }
    *slip = end;
    if (!(start.limit(end).force > start.least)) return true;
    end *= 2.0;
  }
  return false;
}

/// Projects the rounding of a return away: P(y) = limit.
inline SlipVector put_on_limit(const Potential& potential, const SlipVector& y,
                               double limit) noexcept {
  const double p = value(potential, y);
  // Scaling is good for every corner, but moves forces the limit does not hold, too.
  const auto holds = [](const PotentialLeaf& leaf) {
    return leaf.kind == PotentialLeaf::Kind::kNorm ||
           (leaf.kind == PotentialLeaf::Kind::kLine && leaf.factor == 1.0);
  };
  if (potential.homogeneous &&
      std::all_of(potential.leaf.begin(), potential.leaf.begin() + potential.leaves, holds)) {
    return p > 0.0 ? scaled(y, limit / p) : y;
  }
  SlipVector result = y;
  for (int i = 0; i < 2; ++i) {
    const SlipVector m = gradient(potential, result);
    const double square = dot(m, m);
    if (!(square > 0.0)) break;
    result = sum_of(result, (limit - value(potential, result)) / square, m);
  }
  return result;
}

}  // namespace slipbench::law
