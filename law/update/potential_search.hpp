// SPDX-License-Identifier: Apache-2.0
// The search for the slip after which a force rests on the limit of a potential (theory 11.7).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// Start of the return of an increment; `limit` gives F_lim at a slip, and its slope there.
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
