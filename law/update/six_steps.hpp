// SPDX-License-Identifier: Apache-2.0
// The six steps of an increment, which all updates share (docs/theory, section 11).
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "law/base/slip_vector.hpp"
#include "law/definition/limit_function.hpp"
#include "law/definition/motion.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

template <int D>
double dot(const Slip<D>& a, const Slip<D>& b) noexcept {
  return a.dot(b);
}
template <int D>
Slip<D> over(const Slip<D>& a, double divisor) noexcept {
  return a / divisor;
}
inline SlipVector over(const SlipVector& a, double divisor) noexcept {
  return scaled(a, 1.0 / divisor);
}
inline double norm(const SlipVector& a) noexcept { return std::sqrt(dot(a, a)); }
inline void store(const SlipVector& a, SlipVector* to) noexcept { *to = a; }

/// Parts of a FrictionUpdate that are wanted; the others stay as they are.
enum class Wanted : std::uint8_t {
  kForce,  ///< state and tangent
  kRow,    ///< all but tangent and direction of the motion
  kAll
};

/// Begin of an increment in the slip space, with the predictor: all motion elastic. `Vector` is a
/// Slip<D>, or the SlipVector of potentials. References are kept, here and below.
template <class Vector>
struct IncrementBegin {
  IncrementBegin(const FrictionDefinition& d, const ConnectorIncrement& i,
                 const FrictionState& o) noexcept
      : definition(d),
        increment(i),
        old(o),
        fixed(d.stick.mode == StickStiffness::Mode::kStiffness),
        stick(d.stick.value) {
    if constexpr (std::is_same_v<Vector, SlipVector>) {
      force = old.force;
      ds = motion_in(d.slip, i);
      trial = fixed ? sum_of(force, stick, ds) : sum_of(old.elastic_slip, 1.0, ds);
    } else {
      constexpr int kD = Vector::RowsAtCompileTime;
      force = load<kD>(old.force);
      for (int k = 0; k < kD; ++k) ds[k] = motion_along(d.slip, i, static_cast<std::size_t>(k));
      trial = fixed ? Vector(force + stick * ds) : Vector(load<kD>(old.elastic_slip) + ds);
    }
    motion = norm(ds);
  }

  const FrictionDefinition& definition;
  const ConnectorIncrement& increment;
  const FrictionState& old;
  bool fixed;     ///< constant kappa
  double stick;   ///< kappa [F/L], or g_c [L]
  Vector force;   ///< y of the old state [F]
  Vector ds;      ///< motion [L]
  double motion;  ///< |ds| [L]
  Vector trial;   ///< y_trial with a constant kappa, else s_trial
};

/// End of an increment that has a limit: where stick or slip leave the force.
template <class Vector>
struct IncrementEnd {
  Limit limit;
  Vector force{};         ///< y [F]
  Vector elastic_slip{};  ///< s_el [L]
  Vector direction{};     ///< see FrictionUpdate
  double slip = 0.0;      ///< dL [L]
  Regime regime = Regime::kStick;
};

/// Parts of a return in the six steps; updates derive from it, and put their own in place of what
/// is not theirs. They add
///   end(&result)                   step 4: stick, or slip to the limit;
///   take_energies(end, &result)    of step 5: dissipation, stored energy, work, onset, phi;
///   tangent(end)                   step 6: dy/ds of an end that is not open.
template <class VectorOf, class LimitOf, Wanted kWants = Wanted::kAll>
struct ReturnSteps {
  using Vector = VectorOf;
  using Begin = IncrementBegin<Vector>;
  using End = IncrementEnd<Vector>;
  static constexpr Wanted kWanted = kWants;

  ReturnSteps(const Begin& b, const LimitOf& l) noexcept : ReturnSteps(b, l, l(0.0)) {}
  ReturnSteps(const Begin& b, const LimitOf& l, const Limit& at_rest) noexcept
      : begin(b), limit(l), rest(at_rest) {}

  /// The limit as a function of the slip of the increment.
  static LimitOf limit_of(const Begin& b) noexcept {
    return {b.definition, b.increment, b.old, b.motion};
  }
  /// Tells whether there is something to hold on to. A coefficient that vanishes only at rest still
  /// grips as soon as there is slip.
  bool grips() const noexcept {
    return rest.force > 0.0 ||
           (rest.normal_force > 0.0 && limit.at(0.0, limit.motion_rate(begin.motion)).force > 0.0);
  }
  /// The limit that is told where nothing grips.
  Limit open_limit() const noexcept { return rest; }
  /// Tells whether the old force falls over the motion; else it is gone with its cause.
  static constexpr bool is_spring() noexcept { return true; }

  const Begin& begin;
  const LimitOf& limit;
  const Limit rest;  ///< without slip
};

/// Tells whether slip goes on where its limit is 0: an elastic slip stays, if it is but the rate of
/// the slip that takes the coefficient (docs/theory, section 11.5).
/// \param at_slip the limit of a slip [L]
template <class LimitOf>
bool slips_without_force(bool fixed, const LimitOf& limit, const Limit& at_slip,
                         double slip) noexcept {
  return !fixed && at_slip.normal_force > 0.0 && limit.at(slip, limit.rate(0.0)).force > 0.0;
}

/// Puts a limit and all that led to it into a result.
inline void report(const Limit& limit, FrictionUpdate* result) noexcept {
  result->contact_force = limit.contact_force;
  result->normal_force = limit.normal_force;
  result->mu = limit.mu;
  result->limit = limit.force;
  result->slip_rate = limit.slip_rate;
  result->wear = limit.wear;
}

/// Steps 3 to 6 of an increment that `steps` has begun.
/// \param[in,out] result as a FrictionUpdate is by default
template <class Steps>
[[gnu::always_inline]] inline void take_steps(Steps& steps, FrictionUpdate* result) noexcept {
  const auto& begin = steps.begin;
  result->state.accumulated_slip = begin.old.accumulated_slip;

  // 3. Nothing to hold on to: start again from a stress-free state (docs/theory, section 11.5).
  if (!steps.grips()) {
    report(steps.open_limit(), result);
    result->state.regime = Regime::kOpen;
    if (Steps::kWanted != Wanted::kForce && steps.is_spring()) {
      result->work = 0.5 * dot(begin.force, begin.ds);
    }
    return;
  }

  // 4. Admissibility and return mapping.
  const auto end = steps.end(result);

  // 5. The new state, bookkeeping and energies (docs/theory, section 13).
  report(end.limit, result);
  store(end.force, &result->state.force);
  store(end.elastic_slip, &result->state.elastic_slip);
  store(end.direction, &result->direction);
  result->state.regime = end.regime;
  result->state.accumulated_slip += end.slip;
  result->slip_increment = end.slip;
  if constexpr (Steps::kWanted == Wanted::kAll) {
    if (begin.motion > 0.0) store(over(begin.ds, begin.motion), &result->motion_direction);
  }
  if constexpr (Steps::kWanted != Wanted::kForce) steps.take_energies(end, result);

  // 6. Consistent tangent (docs/theory, section 12).
  if constexpr (Steps::kWanted != Wanted::kRow) {
    if (end.regime != Regime::kOpen) result->tangent = steps.tangent(end);
  }
}

/// One increment of a definition by the ReturnSteps `Steps`; flattened, so that a return in parts
/// costs what one in a piece does.
/// \param more for its constructor
template <class Steps, class... More>
[[gnu::flatten]] FrictionUpdate in_six_steps(const FrictionDefinition& definition,
                                             const ConnectorIncrement& increment,
                                             const FrictionState& old, More... more) noexcept {
  FrictionUpdate result;
  // 1. Motion and predictor in the scaled slip space.
  const typename Steps::Begin begin(definition, increment, old);
  // 2. The limit, over the slip and without it.
  const auto limit = Steps::limit_of(begin);
  Steps steps(begin, limit, more...);
  take_steps(steps, &result);
  return result;
}

}  // namespace slipbench::law
