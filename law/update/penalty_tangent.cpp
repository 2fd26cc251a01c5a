// SPDX-License-Identifier: Apache-2.0
#include "law/update/penalty_tangent.hpp"

#include <algorithm>
#include <cmath>

#include "law/base/slip_vector.hpp"
#include "law/definition/limit_function.hpp"
#include "law/definition/motion.hpp"
#include "law/update/axis_limits.hpp"
#include "law/update/ellipse_return.hpp"
#include "law/update/penalty_predictor.hpp"

namespace slipbench::law {
namespace {

using SixVector = Eigen::Matrix<double, kComponents, 1>;
using SixMatrix = Eigen::Matrix<double, kComponents, kComponents>;

/// Slopes that the tangents of both kinds of limit are made of.
struct Slopes {
  SixMatrix to_slip;       ///< dy/ds
  SixVector to_contact;    ///< dy/d(F_C + F_int)
  SixVector to_stiffness;  ///< dy/dK
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
    slopes->to_slip.col(j) = turned(slopes->to_slip.col(j)) +
                             l.to_rate * inverse_duration(increment.duration) * m[j] * p;
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
  const Slip<2> ds(motion_along(space, increment, 0), motion_along(space, increment, 1));
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
  const double per_time = inverse_duration(increment.duration);
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
  PenaltyTangent tangent{SixMatrix::Zero(), SixVector::Zero(), SixMatrix::Zero()};
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
