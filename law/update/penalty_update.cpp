// SPDX-License-Identifier: Apache-2.0
#include "law/update/penalty_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "law/base/slip_vector.hpp"
#include "law/definition/limit_function.hpp"
#include "law/update/axis_limits.hpp"
#include "law/update/ellipse_return.hpp"
#include "law/update/penalty_predictor.hpp"
#include "law/update/split_work.hpp"

namespace slipbench::law {
namespace {

/// The admissible forces of an increment: the ball |y| <= F_lim, or the ellipse of an orthotropic
/// law.
template <int D>
class Bound {
 public:
  Bound(const FrictionDefinition& definition, const ConnectorIncrement& increment,
        const Limit& limit, const Slip<D>& ds)
      : formulation_(*definition.formulation), limit_(limit) {
    if constexpr (D == 2) {
      if (formulation_.orthotropy) {
        axes_ = axis_limits(definition, increment, ds[0], ds[1], limit.contact_force);
      }
    }
  }

  const AxisLimits* axes() const { return axes_ ? &*axes_ : nullptr; }
  double widest() const {
    return axes_ ? std::max(axes_->bound[0], axes_->bound[1]) : limit_.force;
  }
  /// Entries along the axes of the ellipse.
  PlaneVector along(const Slip<D>& y) const {
    return along_axes(formulation_.orthotropy->first, y[0], y[D - 1]);
  }
  bool contains(const Slip<D>& y) const {
    return axes_ ? within_ellipse(along(y), axes_->bound)
                 : norm<D>(y) <= limit_.force * kLimitSlack;
  }
  /// The return of a force outside.
  Slip<D> returned(const Slip<D>& trial) const {
    if (!axes_) {
      const Slip<D> n = trial / norm<D>(trial);
      return limit_.force * n;
    }
    const auto return_to = uses_ratio_return(formulation_) ? ratio_on_ellipse : closest_on_ellipse;
    const PlaneVector f = return_to(along(trial), axes_->bound);
    const PlaneVector y = from_axes(formulation_.orthotropy->first, f);
    Slip<D> result = Slip<D>::Zero();
    result[0] = y[0];
    result[D - 1] = y[1];
    return result;
  }
  /// The coefficient and the limit in the direction of a vector.
  std::pair<double, double> towards(const Slip<D>& v) const {
    if (!axes_) return {limit_.mu, limit_.force};
    const double size = norm<D>(v);
    PlaneVector n{1.0, 0.0};
    if (size > 0.0) n = along(v / size);
    return {ellipse_radius(n, axes_->mu), ellipse_radius(n, axes_->bound)};
  }
  /// The fraction of a path from y0 to a trial outside that is over at the limit.
  double fraction(const Slip<D>& y0, const Slip<D>& trial) const {
    if (!axes_) return limit_fraction<D>(y0, trial, limit_.force);
    if (!(axes_->bound[0] > 0.0 && axes_->bound[1] > 0.0)) return 0.0;
    const auto on_circle = [&](const Slip<D>& y) {
      const PlaneVector part = along(y);
      return Slip<2>(part[0] / axes_->bound[0], part[1] / axes_->bound[1]);
    };
    return limit_fraction<2>(on_circle(y0), on_circle(trial), 1.0);
  }

 private:
  const Formulation& formulation_;
  const Limit& limit_;
  std::optional<AxisLimits> axes_;
};

template <int D>
FrictionUpdate update_in(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                         const FrictionState& old, PenaltyDetail* detail) noexcept {
  const Formulation& formulation = *definition.formulation;
  const auto* viscous = std::get_if<ViscousPenalty>(&formulation.penalty);
  FrictionUpdate result;
  result.state.accumulated_slip = old.accumulated_slip;

  // 1. Motion, limit and filter of the increment.
  Slip<D> ds;
  for (int i = 0; i < D; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int c = definition.slip.component[k];
    ds[i] = definition.slip.scale[k] * (increment.end.position[c] - increment.begin_position[c]);
  }
  const double motion = norm<D>(ds);
  const LimitFunction limit(definition, increment, old, motion);
  const Limit l = limit.at(0.0, limit.motion_rate(motion));
  const Bound<D> bound(definition, increment, l, ds);
  const double alpha =
      filter_coefficient(formulation.filter, increment.duration, formulation.convention);
  ViscousCoefficient coefficient;
  if (viscous != nullptr) {
    coefficient =
        viscous_coefficient(*viscous, formulation.convention, increment.end, l.normal_force);
  }
  result.contact_force = l.contact_force;
  result.normal_force = l.normal_force;
  result.slip_rate = l.slip_rate;
  std::tie(result.mu, result.limit) = bound.towards(ds);
  if (detail != nullptr) {
    *detail = {.speed = l.slip_rate, .alpha = alpha, .viscous_coefficient = coefficient.value};
    if (bound.axes() != nullptr) {
      detail->speeds = bound.axes()->speed;
      detail->mu = bound.axes()->mu;
    }
  }
  const Slip<D> given_before = load<D>(old.force);

  // 2. Nothing to hold on to: filter and memory start again. A coefficient that vanishes is no loss
  //    of contact, and the filter only forgets.
  const bool filtered = smooths(formulation);
  if (!(bound.widest() > 0.0) && !(filtered && l.normal_force > 0.0)) {
    result.state.regime = Regime::kOpen;
    // The force of a spring falls from its old value to 0; a viscous one goes with the speed.
    if (viscous == nullptr) result.work = 0.5 * given_before.dot(ds);
    return result;
  }

  // 3. Predictor and return.
  const double predictor = predictor_stiffness(formulation, coefficient.value, increment.duration,
                                               alpha, motion, bound.widest());
  Slip<D> base = Slip<D>::Zero();
  if (const auto* stiff = std::get_if<StiffnessPenalty>(&formulation.penalty)) {
    base = stiff->stiffness * load<D>(old.elastic_slip);
  } else if (!(increment.duration > 0.0) && motion == 0.0) {
    base = given_before;
  }
  const Slip<D> trial = base + predictor * ds;
  const bool outside = !bound.contains(trial);
  const Slip<D> y = outside ? bound.returned(trial) : trial;
  const double p = norm<D>(y);
  if (bound.axes() != nullptr) {
    result.trial = bound.along(trial);
    if (p > 0.0) {
      std::tie(result.mu, result.limit) = bound.towards(y);
      // A returned force is on the limit; the radius of an ellipse without or hardly with a width
      // does not say so.
      const double share = result.limit > 0.0 ? p / result.limit : 1.0;
      if (outside || share > 1.0) {
        result.mu *= share;
        result.limit = p;
      }
    }
  }

  // 4. Slip, energies of the force before the filter.
  result.phi = p - result.limit;
  if (viscous != nullptr) {
    result.state.regime = outside && motion > 0.0 ? Regime::kSlip : Regime::kStick;
    result.slip_increment = motion;
    result.dissipation = std::max(0.0, y.dot(ds));  // a rounding next to a right angle
  } else {
    const double stiffness = std::get_if<StiffnessPenalty>(&formulation.penalty)->stiffness;
    const Slip<D> elastic = y / stiffness;
    store<D>(elastic, &result.state.elastic_slip);
    result.stored_energy = 0.5 * y.dot(elastic);
    result.state.regime = outside ? Regime::kSlip : Regime::kStick;
    if (outside) {
      result.onset = bound.fraction(base, trial);
      if (bound.axes() == nullptr) {
        const double size = norm<D>(trial);
        result.slip_increment = (size - l.force) / stiffness;
        result.dissipation = l.force * result.slip_increment;
        result.phi = size - stiffness * result.slip_increment - l.force;
      } else {
        const Slip<D> plastic = (trial - y) / stiffness;
        result.slip_increment = norm<D>(plastic);
        result.dissipation = std::max(0.0, y.dot(plastic));
      }
    }
  }
  result.state.accumulated_slip += result.slip_increment;
  if (p > 0.0) store<D>(y / p, &result.direction);
  if (motion > 0.0) store<D>(ds / motion, &result.motion_direction);

  // 5. The filter, and what is given out.
  Slip<D> given = y;
  if (filtered) {
    given = alpha * y + (1.0 - alpha) * given_before;
    if (formulation.filter.clip && !bound.contains(given)) {
      result.tangent.clip = bound.towards(given).second / norm<D>(given);
      given *= result.tangent.clip;
    }
  }
  store<D>(given, &result.state.force);
  if (viscous != nullptr) {
    result.work = given.dot(ds);
  } else if (filtered && alpha != 1.0) {
    result.work = 0.5 * (given_before + given).dot(ds);
  } else {
    result.work = work_split_at<D>(outside ? result.onset : 1.0, given_before, trial, y, ds);
  }

  // 6. The tangent of the isotropic law; penalty_tangent makes the rest of it.
  const double weight = filtered ? alpha : 1.0;
  SlipTangent& t = result.tangent;
  if (bound.axes() == nullptr && outside) {
    t.transverse = weight * l.force * predictor / norm<D>(trial);
    t.rate = weight * l.to_rate * inverse_duration(increment.duration);
    t.contact = weight * l.to_contact;
  } else {
    t.transverse = t.radial = weight * predictor;
    const double sign = l.contact_force < 0.0 ? -1.0 : 1.0;
    t.contact = weight * sign * coefficient.to_normal_force * l.slip_rate;
  }
  if (detail != nullptr) {
    store<D>(trial, &detail->trial);
    store<D>(y, &detail->raw);
  }
  return result;
}

}  // namespace

FrictionUpdate update_penalty(const FrictionDefinition& definition,
                              const ConnectorIncrement& increment, const FrictionState& old,
                              PenaltyDetail* detail) noexcept {
  switch (definition.slip.dimension) {
    case 1:
      return update_in<1>(definition, increment, old, detail);
    case 2:
      return update_in<2>(definition, increment, old, detail);
    case 3:
      return update_in<3>(definition, increment, old, detail);
    case 4:
      return update_in<4>(definition, increment, old, detail);
    case 5:
      return update_in<5>(definition, increment, old, detail);
    default:
      return update_in<6>(definition, increment, old, detail);
  }
}

double limit_use(const FrictionDefinition& definition, const FrictionUpdate& update,
                 const PenaltyDetail& detail) noexcept {
  if (!definition.formulation) return 0.0;
  const Formulation& formulation = *definition.formulation;
  const auto over = [](double force, double bound) {
    if (force == 0.0) return 0.0;
    return bound > 0.0 ? force / bound : std::numeric_limits<double>::infinity();
  };
  // The reported limit is that in the direction of the force before the filter.
  if (!formulation.orthotropy || !smooths(formulation)) {
    return over(equivalent_force(definition, update.state), update.limit);
  }
  const auto& y = update.state.force;
  const PlaneVector along = along_axes(formulation.orthotropy->first, y[0], y[1]);
  const auto of_axis = [&](std::size_t i) {
    return over(along[i], std::min(detail.mu[i] * update.normal_force, definition.force_limit));
  };
  return std::hypot(of_axis(0), of_axis(1));
}

}  // namespace slipbench::law
