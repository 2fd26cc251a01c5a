// SPDX-License-Identifier: Apache-2.0
// Limits that are known before the slip of their increment is.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "law/definition/friction_definition.hpp"
#include "law/definition/friction_state.hpp"
#include "law/definition/increment.hpp"
#include "law/definition/limit_function.hpp"
#include "law/table/table_cursor.hpp"

namespace slipbench::law {

/// Tells whether F_lim of every increment is the same whatever its slip: its coefficient does not
/// see the rate of the slip, and its internal contact force not the slip of the increment.
inline bool has_known_limit(const FrictionDefinition& definition) noexcept {
  const bool sees_rate =
      definition.slip_rate == SlipRateMeasure::kSlip && depends_on_slip_rate(definition.law);
  const bool wears_within = definition.accumulated_slip == AccumulatedSlipTiming::kEnd &&
                            depends_on_accumulated_slip(definition.internal_contact_force);
  return !sees_rate && !wears_within;
}

/// F_lim of an increment of such a definition, in the shape of a LimitFunction.
class KnownLimit {
 public:
  /// \param rest the limit without slip, but for the rate
  /// \param duration of the increment [T]
  /// \param motion |ds| of the increment [L]
  KnownLimit(const Limit& rest, const FrictionDefinition& definition, double duration,
             double motion) noexcept
      : rest_(rest) {
    const double inverse_duration = duration > 0.0 ? 1.0 / duration : 0.0;
    const bool of_slip = definition.slip_rate == SlipRateMeasure::kSlip;
    rest_.slip_rate = of_slip ? 0.0 : motion * inverse_duration;
    slip_in_rate_ = of_slip ? inverse_duration : 0.0;
  }

  Limit operator()(double slip) const noexcept {
    Limit limit = rest_;
    limit.slip_rate = rate(slip);
    return limit;
  }
  /// The rate the coefficient is told [L/T].
  double rate(double slip) const { return rest_.slip_rate + slip * slip_in_rate_; }

  static constexpr bool depends_on_slip() { return false; }
  static constexpr double slope(const Limit&) { return 0.0; }
  static constexpr double motion_rate(double) { return 0.0; }
  Limit at(double slip, double) const noexcept { return (*this)(slip); }

 private:
  friend class KnownLimits;
  Limit rest_;
  double slip_in_rate_;  ///< [1/T]
};

/// The known limits of a history, one increment after another, in the bits of a LimitFunction. It
/// must not outlive its definition, which must stay as it is.
class KnownLimits {
 public:
  explicit KnownLimits(const FrictionDefinition& definition) noexcept : definition_(definition) {
    if (const auto* law = std::get_if<TabularCoefficient>(&definition.law)) mu_.emplace(law->table);
    if (const auto* table = std::get_if<TableFunction>(&definition.internal_contact_force)) {
      internal_.emplace(*table);
    }
  }

  /// \param motion |ds| of the increment [L]
  [[gnu::always_inline]] KnownLimit operator()(const ConnectorIncrement& increment,
                                               const FrictionState& old, double motion) noexcept {
    KnownLimit limit({}, definition_, increment.duration, motion);
    Limit& rest = limit.rest_;
    // Linear extrapolation may leave the physical range: neither table is ever negative.
    rest.contact_force =
        evaluate(definition_.contact_force, increment.force, increment.end) +
        (internal_
             ? std::max(internal_->value(increment.end, {.accumulated_slip = old.accumulated_slip}),
                        0.0)
             : *std::get_if<double>(&definition_.internal_contact_force));
    rest.normal_force = std::abs(rest.contact_force);
    const SlipArguments slip{.slip_rate = rest.slip_rate, .contact_force = rest.normal_force};
    const double mu = mu_ ? std::max(mu_->value(increment.end, slip), 0.0)
                          : evaluate(definition_.law, increment.end, slip).mu;
    rest.mu = blended(definition_.blend, {mu, 0.0, 0.0}).mu;
    rest.force = std::min(rest.mu * rest.normal_force, definition_.force_limit);
    return limit;
  }

 private:
  const FrictionDefinition& definition_;
  std::optional<TableCursor> mu_;
  std::optional<TableCursor> internal_;
};

/// The searches of first_root.hpp, which have nothing to search here.
inline double first_root(const KnownLimit& limit, double trial, double kappa) noexcept {
  return (trial - limit(0.0).force) / kappa;
}
inline bool has_later_root(const KnownLimit&, double, double, double) noexcept { return false; }
inline double first_zero(const KnownLimit&, double) noexcept { return 0.0; }

}  // namespace slipbench::law
