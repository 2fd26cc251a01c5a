// SPDX-License-Identifier: Apache-2.0
#include "law/penalty_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "law/ellipse_return.hpp"
#include "law/limit_function.hpp"
#include "law/slip_vector.hpp"
#include "law/split_work.hpp"

namespace slipbench::law {

ViscousCoefficient viscous_coefficient(const ViscousPenalty& penalty, Convention convention,
                                       const Ambient& end, double normal_force) noexcept {
  ViscousCoefficient c;
  if (penalty.coefficient) {
    c.value = *penalty.coefficient;
    return c;
  }
  const double factor =
      convention == Convention::kDocumented ? penalty.visf : std::sqrt(penalty.visf);
  const auto* table = std::get_if<TableFunction>(&penalty.stiffness);
  if (table == nullptr) {
    const double stiffness = *std::get_if<double>(&penalty.stiffness);
    c.value = factor * std::sqrt(2.0 * stiffness * penalty.mass);
    return c;
  }
  SlipArguments slopes;
  const double stiffness = table->value_and_slopes(end, {.contact_force = normal_force}, &slopes);
  // Linear extrapolation may leave the physical range: K is never negative.
  if (!(stiffness > 0.0)) return c;
  c.value = factor * std::sqrt(2.0 * stiffness * penalty.mass);
  c.to_stiffness = 0.5 * c.value / stiffness;
  c.to_normal_force = c.to_stiffness * slopes.contact_force;
  return c;
}

namespace {

double inverse(double duration) { return duration > 0.0 ? 1.0 / duration : 0.0; }

/// Whether the filter smooths the output: as coded a stiffness penalty scales its increment
/// instead.
bool smooths(const Formulation& formulation) {
  return formulation.filter.kind != Filter::Kind::kNone &&
         (formulation.convention == Convention::kDocumented ||
          std::holds_alternative<ViscousPenalty>(formulation.penalty));
}

/// As coded an orthotropic stiffness penalty does not return to the closest point.
bool uses_ratio_return(const Formulation& formulation) {
  return formulation.convention == Convention::kAsCoded &&
         std::holds_alternative<StiffnessPenalty>(formulation.penalty);
}

/// dF*/ds [F/L]: C/dt or K_t, as coded alpha K_t.
/// \param widest the largest limit, > 0 [F]
double predictor_stiffness(const Formulation& formulation, double viscous, double duration,
                           double alpha, double motion, double widest) {
  if (const auto* penalty = std::get_if<StiffnessPenalty>(&formulation.penalty)) {
    return formulation.convention == Convention::kAsCoded ? alpha * penalty->stiffness
                                                          : penalty->stiffness;
  }
  if (duration > 0.0 || !(viscous > 0.0)) return viscous * inverse(duration);
  // Motion in no time is so fast that the limit alone decides.
  constexpr double kFarOutside = 1e16;
  return motion > 0.0 ? kFarOutside * widest / motion : 0.0;
}

/// The two limits of an orthotropic law along its axes.
struct AxisLimits {
  PlaneVector motion{};                          ///< ds along the axes [L]
  PlaneVector speed{};                           ///< V_1, V_2 [L/T]
  PlaneVector mu{};                              ///< [1]
  PlaneVector bound{};                           ///< a_i [F]
  PlaneVector to_contact{};                      ///< da_i/d(F_C + F_int)
  PlaneVector to_speed{};                        ///< da_i/dV_i [F T/L]
  std::array<PlaneVector, 2> speed_to_motion{};  ///< dV_i/d(ds_j) [1/T]
};

/// Entries of the slip space along the axes d1, d2, and back. An entry of the size of the rounding
/// counts as none: along an axis that hardly holds anything it would be far outside.
PlaneVector along_axes(const PlaneVector& d, double x, double y) {
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double rounding = kRounding * std::max(std::abs(x), std::abs(y));
  PlaneVector v{d[0] * x + d[1] * y, -d[1] * x + d[0] * y};
  for (double& entry : v) {
    if (std::abs(entry) <= rounding) entry = 0.0;
  }
  return v;
}
PlaneVector from_axes(const PlaneVector& d, const PlaneVector& v) {
  return {d[0] * v[0] - d[1] * v[1], d[1] * v[0] + d[0] * v[1]};
}

AxisLimits axis_limits(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                       double ds0, double ds1, double contact_force) {
  const Formulation& formulation = *definition.formulation;
  const Orthotropy& orthotropy = *formulation.orthotropy;
  const double per_time = inverse(increment.duration);
  const double normal_force = std::abs(contact_force);
  const double sign = contact_force < 0.0 ? -1.0 : 1.0;

  AxisLimits axes;
  axes.motion = along_axes(orthotropy.first, ds0, ds1);
  const double motion = std::sqrt(ds0 * ds0 + ds1 * ds1);
  for (std::size_t i = 0; i < 2; ++i) {
    const double velocity = axes.motion[i] * per_time;
    if (orthotropy.speed == Orthotropy::Speed::kTotal) {
      axes.speed[i] = motion * per_time;
      for (std::size_t j = 0; j < 2; ++j) {
        if (motion > 0.0) axes.speed_to_motion[i][j] = axes.motion[j] / motion * per_time;
      }
    } else if (formulation.convention == Convention::kDocumented) {
      axes.speed[i] = std::abs(velocity);
      axes.speed_to_motion[i][i] = velocity < 0.0 ? -per_time : per_time;
    } else {
      constexpr double kLeastSpeed = 1e-30;  // in whatever unit the case has
      axes.speed[i] = std::max(kLeastSpeed, velocity);
      axes.speed_to_motion[i][i] = velocity > kLeastSpeed ? per_time : 0.0;
    }
    const CoefficientPoint c = blended(
        definition.blend, evaluate(i == 0 ? definition.law : orthotropy.second, increment.end,
                                   {.slip_rate = axes.speed[i], .contact_force = normal_force}));
    axes.mu[i] = c.mu;
    axes.bound[i] = c.mu * normal_force;
    if (axes.bound[i] >= definition.force_limit) {
      axes.bound[i] = definition.force_limit;
      continue;
    }
    axes.to_contact[i] = sign * (c.mu + normal_force * c.to_contact_force);
    axes.to_speed[i] = normal_force * c.to_slip_rate;
  }
  return axes;
}

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

  // 2. Nothing to hold on to: filter and memory start again.
  if (!(bound.widest() > 0.0)) {
    result.state.regime = Regime::kOpen;
    // The force of a spring falls from its old value to 0; a viscous one goes with the speed.
    if (viscous == nullptr) result.work = 0.5 * given_before.dot(ds);
    return result;
  }

  // 3. Predictor and return.
  const double predictor = predictor_stiffness(formulation, coefficient.value, increment.duration,
                                               alpha, motion, bound.widest());
  // As coded, what the filter leaves of an increment acts as a spring of alpha K_t: all motion is
  // then elastic slip or slip, and the energies balance. Its memory is the force, which nothing
  // smooths.
  const double spring = predictor > 0.0 || viscous != nullptr
                            ? predictor
                            : std::get_if<StiffnessPenalty>(&formulation.penalty)->stiffness;
  Slip<D> base = Slip<D>::Zero();
  if (viscous == nullptr) {
    const bool coded = formulation.convention == Convention::kAsCoded;
    base = coded ? given_before : Slip<D>(spring * load<D>(old.elastic_slip));
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
    const Slip<D> elastic = y / spring;
    store<D>(elastic, &result.state.elastic_slip);
    result.stored_energy = 0.5 * y.dot(elastic);
    result.state.regime = outside ? Regime::kSlip : Regime::kStick;
    if (outside) {
      result.onset = bound.fraction(base, trial);
      if (bound.axes() == nullptr) {
        const double size = norm<D>(trial);
        result.slip_increment = (size - l.force) / spring;
        result.dissipation = l.force * result.slip_increment;
        result.phi = size - spring * result.slip_increment - l.force;
      } else {
        const Slip<D> plastic = (trial - y) / spring;
        result.slip_increment = norm<D>(plastic);
        result.dissipation = std::max(0.0, y.dot(plastic));
      }
    }
  }
  result.state.accumulated_slip += result.slip_increment;
  if (p > 0.0) store<D>(y / p, &result.direction);
  if (motion > 0.0) store<D>(ds / motion, &result.motion_direction);

  // 5. The filter, and what is given out.
  const bool filtered = smooths(formulation);
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
    t.rate = weight * l.to_rate * inverse(increment.duration);
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

namespace {

using SixVector = Eigen::Matrix<double, kComponents, 1>;

/// What the tangents of both kinds of limit are made of.
struct Slopes {
  Eigen::Matrix<double, kComponents, kComponents> to_slip;  ///< dy/ds
  SixVector to_contact;                                     ///< dy/d(F_C + F_int)
  SixVector to_stiffness;                                   ///< dy/dK
};

/// The isotropic law: the SlipTangent written out, and clipping to F_lim behind the filter.
void add_isotropic(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                   const FrictionUpdate& update, double by_stiffness, Slopes* slopes) {
  const SlipTangent& t = update.tangent;
  const int d = definition.slip.dimension;
  const SixVector n = load<kComponents>(update.direction);
  const SixVector m = load<kComponents>(update.motion_direction);
  auto to_slip = slopes->to_slip.topLeftCorner(d, d);
  to_slip.diagonal().setConstant(t.transverse);
  to_slip += (t.radial - t.transverse) * n.head(d) * n.head(d).transpose() +
             t.rate * n.head(d) * m.head(d).transpose();
  slopes->to_contact = t.contact * n;
  slopes->to_stiffness = by_stiffness * n;
  if (!(t.clip < 1.0)) return;

  FrictionState begin;
  begin.accumulated_slip = update.state.accumulated_slip - update.slip_increment;
  const Limit l = LimitFunction(definition, increment, begin, 0.0).at(0.0, update.slip_rate);
  const SixVector y = load<kComponents>(update.state.force);
  const SixVector p = y / y.norm();
  const auto turned = [&](const SixVector& change) -> SixVector {
    return t.clip * (change - p.dot(change) * p);
  };
  for (int j = 0; j < d; ++j) {
    slopes->to_slip.col(j) =
        turned(slopes->to_slip.col(j)) + l.to_rate * inverse(increment.duration) * m[j] * p;
  }
  slopes->to_contact = turned(slopes->to_contact) + l.to_contact * p;
  slopes->to_stiffness = turned(slopes->to_stiffness);
}

/// The orthotropic law: the return differentiated along the axes.
/// \param weight of the returned force behind the filter
void add_orthotropic(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                     const FrictionUpdate& update, const ViscousCoefficient& coefficient,
                     double alpha, double weight, Slopes* slopes) {
  const Formulation& formulation = *definition.formulation;
  const SlipSpace& space = definition.slip;
  const PlaneVector& d = formulation.orthotropy->first;
  Slip<2> ds;
  for (std::size_t i = 0; i < 2; ++i) {
    const int c = space.component[i];
    ds[static_cast<int>(i)] =
        space.scale[i] * (increment.end.position[c] - increment.begin_position[c]);
  }
  const AxisLimits axes = axis_limits(definition, increment, ds[0], ds[1], update.contact_force);
  const double widest = std::max(axes.bound[0], axes.bound[1]);
  const double predictor = predictor_stiffness(formulation, coefficient.value, increment.duration,
                                               alpha, ds.norm(), widest);
  const auto return_change =
      uses_ratio_return(formulation) ? ratio_on_ellipse_change : closest_on_ellipse_change;
  const PlaneVector given = along_axes(d, update.state.force[0], update.state.force[1]);
  const double clip = update.tangent.clip;
  // The force given out, for changes of the trial and of the bounds.
  const auto change = [&](const PlaneVector& trial_change, const PlaneVector& bounds_change) {
    PlaneVector dy = return_change(update.trial, axes.bound, trial_change, bounds_change);
    for (double& x : dy) x *= weight;
    if (!(clip < 1.0)) return dy;
    // Clipped, y = z/rho with rho^2 = sum (z_i/a_i)^2 = 1/clip^2.
    double growth = 0.0;  // d(ln rho)
    for (std::size_t i = 0; i < 2; ++i) {
      if (!(axes.bound[i] > 0.0)) continue;
      const double part = given[i] / axes.bound[i];
      growth += part * (clip * dy[i] - part * bounds_change[i]) / axes.bound[i];
    }
    return PlaneVector{clip * dy[0] - growth * given[0], clip * dy[1] - growth * given[1]};
  };
  const auto in_slip_space = [&](const PlaneVector& v) {
    const PlaneVector y = from_axes(d, v);
    SixVector result = SixVector::Zero();
    result[0] = y[0];
    result[1] = y[1];
    return result;
  };

  for (std::size_t j = 0; j < 2; ++j) {
    PlaneVector trial_change{};
    trial_change[j] = predictor;
    PlaneVector bounds_change{};
    for (std::size_t i = 0; i < 2; ++i) {
      bounds_change[i] = axes.to_speed[i] * axes.speed_to_motion[i][j];
    }
    const SixVector column = in_slip_space(change(trial_change, bounds_change));
    const PlaneVector axis = j == 0 ? PlaneVector{d[0], d[1]} : PlaneVector{-d[1], d[0]};
    slopes->to_slip.col(0) += column * axis[0];
    slopes->to_slip.col(1) += column * axis[1];
  }
  const double per_time = inverse(increment.duration);
  const double sign = update.contact_force < 0.0 ? -1.0 : 1.0;
  const auto with_coefficient = [&](double slope) {
    return PlaneVector{slope * axes.motion[0] * per_time, slope * axes.motion[1] * per_time};
  };
  slopes->to_contact =
      in_slip_space(change(with_coefficient(sign * coefficient.to_normal_force), axes.to_contact));
  slopes->to_stiffness =
      in_slip_space(change(with_coefficient(coefficient.to_stiffness), PlaneVector{}));
}

}  // namespace

PenaltyTangent penalty_tangent(const FrictionDefinition& definition,
                               const ConnectorIncrement& increment,
                               const FrictionUpdate& update) noexcept {
  PenaltyTangent tangent;
  tangent.to_slip.setZero();
  tangent.to_contact.setZero();
  tangent.to_position.setZero();
  if (update.state.regime == Regime::kOpen || update.tangent.clip == 0.0) return tangent;

  const Formulation& formulation = *definition.formulation;
  const double alpha =
      filter_coefficient(formulation.filter, increment.duration, formulation.convention);
  const double weight = smooths(formulation) ? alpha : 1.0;
  const auto* viscous = std::get_if<ViscousPenalty>(&formulation.penalty);
  ViscousCoefficient coefficient;
  if (viscous != nullptr) {
    coefficient =
        viscous_coefficient(*viscous, formulation.convention, increment.end, update.normal_force);
  }
  Slopes slopes;
  slopes.to_slip.setZero();
  if (formulation.orthotropy) {
    add_orthotropic(definition, increment, update, coefficient, alpha, weight, &slopes);
  } else {
    const bool below = update.state.regime == Regime::kStick;
    const double by_stiffness = below ? weight * coefficient.to_stiffness * update.slip_rate : 0.0;
    add_isotropic(definition, increment, update, by_stiffness, &slopes);
  }
  tangent.to_slip = slopes.to_slip;
  tangent.to_contact = slopes.to_contact;

  const auto* table =
      viscous != nullptr ? std::get_if<TableFunction>(&viscous->stiffness) : nullptr;
  if (table != nullptr && !viscous->coefficient) {
    RelativePosition by_position;
    table->add_motion_slopes(increment.end, {.contact_force = update.normal_force}, 1.0,
                             &by_position);
    for (int c = 0; c < kComponents; ++c) {
      tangent.to_position.col(c) = slopes.to_stiffness * by_position[c];
    }
  }
  return tangent;
}

}  // namespace slipbench::law
