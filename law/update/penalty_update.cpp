// SPDX-License-Identifier: Apache-2.0
#include "law/update/penalty_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "law/update/axis_limits.hpp"
#include "law/update/ellipse_return.hpp"
#include "law/update/penalty_predictor.hpp"
#include "law/update/six_steps.hpp"
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
  /// Those of a y1 + b y2, turned before they cancel: rounding across a thin ellipse stays none.
  PlaneVector along(double a, const Slip<D>& y1, double b, const Slip<D>& y2) const {
    const PlaneVector first = along(y1), second = along(y2);
    return {a * first[0] + b * second[0], a * first[1] + b * second[1]};
  }
  /// The force that has such entries.
  Slip<D> from(const PlaneVector& on_axes) const {
    const PlaneVector y = from_axes(formulation_.orthotropy->first, on_axes);
    Slip<D> result = Slip<D>::Zero();
    result[0] = y[0];
    result[D - 1] = y[1];
    return result;
  }
  bool contains(const Slip<D>& y) const { return norm<D>(y) <= limit_.force * kLimitSlack; }
  bool contains(const PlaneVector& on_axes) const { return within_ellipse(on_axes, axes_->bound); }
  /// The return of a force outside.
  Slip<D> returned(const Slip<D>& trial) const {
    const Slip<D> n = trial / norm<D>(trial);
    return limit_.force * n;
  }
  PlaneVector returned(const PlaneVector& trial) const {
    const auto return_to = uses_ratio_return(formulation_) ? ratio_on_ellipse : closest_on_ellipse;
    return return_to(trial, axes_->bound);
  }
  /// The coefficient and the limit in the direction of a vector.
  std::pair<double, double> towards(const Slip<D>& v) const {
    return axes_ ? towards(along(v)) : std::pair{limit_.mu, limit_.force};
  }
  /// Those of a vector along the axes of the ellipse. A thin one needs it as the return gave it:
  /// turned to the slip and back, rounding across it counts by as much as it is thin.
  std::pair<double, double> towards(const PlaneVector& v) const {
    const double size = std::hypot(v[0], v[1]);
    PlaneVector n{1.0, 0.0};
    if (size > 0.0) n = {v[0] / size, v[1] / size};
    return {ellipse_radius(n, axes_->mu), ellipse_radius(n, axes_->bound)};
  }
  /// The factor, at most 1, that brings a y1 + b y2 back to the limit.
  double clip(double a, const Slip<D>& y1, double b, const Slip<D>& y2) const {
    const Slip<D> y = a * y1 + b * y2;
    if (!axes_) return contains(y) ? 1.0 : std::min(limit_.force / norm<D>(y), 1.0);
    const PlaneVector on_axes = along(a, y1, b, y2);
    return contains(on_axes) ? 1.0 : std::min(towards(on_axes).second / norm<D>(y), 1.0);
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

/// The return of a contact penalty; its limit is that of the speed of the motion.
template <int D>
struct PenaltyReturn : ReturnSteps<Slip<D>, LimitFunction> {
  using Base = ReturnSteps<Slip<D>, LimitFunction>;
  using Base::begin, Base::rest;
  using typename Base::Begin, typename Base::End, typename Base::Vector;

  PenaltyReturn(const Begin& b, const LimitFunction& l, PenaltyDetail* to) noexcept
      : Base(b, l, l.at(0.0, l.motion_rate(b.motion))), detail(to) {
    if (spring == nullptr) {
      coefficient = viscous_coefficient(*std::get_if<ViscousPenalty>(&formulation.penalty),
                                        formulation.convention, b.increment.end, rest.normal_force);
    }
    if (detail == nullptr) return;
    *detail = {.speed = rest.slip_rate, .alpha = alpha, .viscous_coefficient = coefficient.value};
    if (bound.axes() != nullptr) {
      detail->speeds = bound.axes()->speed;
      detail->mu = bound.axes()->mu;
    }
  }

  /// Tells whether it grips; else filter and memory start again. A coefficient that vanishes is no
  /// loss of contact, and the filter only forgets.
  bool grips() const noexcept {
    return bound.widest() > 0.0 || (filtered && rest.normal_force > 0.0);
  }
  Limit open_limit() const noexcept {
    Limit l = rest;
    std::tie(l.mu, l.force) = bound.towards(begin.ds);
    return l;
  }
  /// A viscous force goes with the speed.
  bool is_spring() const noexcept { return spring != nullptr; }

  End end(FrictionUpdate* result) noexcept {
    const double duration = begin.increment.duration;
    predictor = predictor_stiffness(formulation, coefficient.value, duration, alpha, begin.motion,
                                    bound.widest());
    if (spring != nullptr) {
      base = spring->stiffness * load<D>(begin.old.elastic_slip);
    } else if (!(duration > 0.0) && begin.motion == 0.0) {
      base = begin.force;
    }
    trial = base + predictor * begin.ds;
    PlaneVector on_axes{};
    if (bound.axes() == nullptr) {
      outside = !bound.contains(trial);
      raw = outside ? bound.returned(trial) : trial;
    } else {
      result->trial = bound.along(1.0, base, predictor, begin.ds);
      outside = !bound.contains(result->trial);
      on_axes = outside ? bound.returned(result->trial) : result->trial;
      raw = outside ? bound.from(on_axes) : trial;
    }
    const double p = norm<D>(raw);
    End end;
    end.limit = rest;
    if (bound.axes() != nullptr) {
      std::tie(end.limit.mu, end.limit.force) =
          bound.towards(p > 0.0 ? on_axes : bound.along(begin.ds));
      if (p > 0.0) {
        // A returned force is on the limit; the radius of an ellipse without or hardly with a width
        // does not say so.
        const double share = end.limit.force > 0.0 ? p / end.limit.force : 1.0;
        if (outside || share > 1.0) {
          end.limit.mu *= share;
          end.limit.force = p;
        }
      }
    }
    end.direction = p > 0.0 ? Vector(raw / p) : Vector(Vector::Zero());
    phi = p - end.limit.force;
    const bool slips = outside && (spring != nullptr || begin.motion > 0.0);
    end.regime = slips ? Regime::kSlip : Regime::kStick;
    if (spring == nullptr) {
      end.elastic_slip.setZero();
      end.slip = begin.motion;
    } else {
      end.elastic_slip = raw / spring->stiffness;
      if (outside && bound.axes() == nullptr) {
        const double size = norm<D>(trial);
        end.slip = (size - rest.force) / spring->stiffness;
        phi = size - spring->stiffness * end.slip - rest.force;
      } else if (outside) {
        plastic = (trial - raw) / spring->stiffness;
        end.slip = norm<D>(plastic);
      }
    }
    end.force = raw;
    if (filtered) {
      end.force = alpha * raw + (1.0 - alpha) * begin.force;
      if (formulation.filter.clip) {
        clip = bound.clip(alpha, raw, 1.0 - alpha, begin.force);
        end.force *= clip;
      }
    }
    if (detail != nullptr) {
      store<D>(trial, &detail->trial);
      store<D>(raw, &detail->raw);
    }
    return end;
  }

  /// Dissipation and stored energy of the force before the filter.
  void take_energies(const End& end, FrictionUpdate* result) const noexcept {
    result->phi = phi;
    if (spring == nullptr) {
      result->dissipation = std::max(0.0, raw.dot(begin.ds));  // a rounding next to a right angle
      result->work = end.force.dot(begin.ds);
      return;
    }
    result->stored_energy = 0.5 * raw.dot(end.elastic_slip);
    if (outside) {
      result->onset = bound.fraction(base, trial);
      result->dissipation =
          bound.axes() == nullptr ? rest.force * end.slip : std::max(0.0, raw.dot(plastic));
    }
    if (filtered && alpha != 1.0) {
      result->work = 0.5 * (begin.force + end.force).dot(begin.ds);
    } else {
      result->work =
          work_split_at<D>(outside ? result->onset : 1.0, begin.force, trial, raw, begin.ds);
    }
  }

  /// That of the isotropic law; penalty_tangent makes the rest of it.
  SlipTangent tangent(const End& /*end*/) const noexcept {
    const double weight = filtered ? alpha : 1.0;
    SlipTangent t;
    t.clip = clip;
    if (bound.axes() == nullptr && outside) {
      t.transverse = weight * rest.force * predictor / norm<D>(trial);
      t.rate = weight * rest.to_rate * inverse_duration(begin.increment.duration);
      t.contact = weight * rest.to_contact;
    } else {
      t.transverse = t.radial = weight * predictor;
      const double sign = rest.contact_force < 0.0 ? -1.0 : 1.0;
      t.contact = weight * sign * coefficient.to_normal_force * rest.slip_rate;
    }
    return t;
  }

  const Formulation& formulation = *begin.definition.formulation;
  const StiffnessPenalty* spring =  ///< null: a viscous penalty
      std::get_if<StiffnessPenalty>(&formulation.penalty);
  const Bound<D> bound{begin.definition, begin.increment, rest, begin.ds};
  const double alpha =
      filter_coefficient(formulation.filter, begin.increment.duration, formulation.convention);
  const bool filtered = smooths(formulation);
  ViscousCoefficient coefficient;
  PenaltyDetail* detail;
  double predictor = 0.0;        ///< dF*/ds [F/L]
  Vector base = Vector::Zero();  ///< F* without motion
  Vector trial;                  ///< F*
  bool outside = false;          ///< F* is beyond the limit
  Vector raw;                    ///< the force before the filter
  Vector plastic;                ///< (F* - F)/K_t of an orthotropic law that slips
  double phi = 0.0;
  double clip = 1.0;
};

}  // namespace

FrictionUpdate update_penalty(const FrictionDefinition& definition,
                              const ConnectorIncrement& increment, const FrictionState& old,
                              PenaltyDetail* detail) noexcept {
  return in_dimension(definition.slip.dimension, [&](auto d) {
    return in_six_steps<PenaltyReturn<d>>(definition, increment, old, detail);
  });
}

double limit_use(const FrictionDefinition& definition, const FrictionUpdate& update,
                 const PenaltyDetail& detail) noexcept {
  if (!definition.formulation) return 0.0;
  const Formulation& formulation = *definition.formulation;
  const auto over = [](double force, double bound) -> double {
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
