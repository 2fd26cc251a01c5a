// SPDX-License-Identifier: Apache-2.0
#include "law/return_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::law {
namespace {

/// Slack of the comparison |y| <= F_lim, so that a force returned to the limit and left alone does
/// not slip again by its own rounding: a state may flip at >, never at =.
constexpr double kSlack = 1.0 + 8.0 * std::numeric_limits<double>::epsilon();

/// The limit F_lim = min(mu F_N, force_limit) at one slip of the increment, with its slopes.
struct Limit {
  double force = 0.0;  ///< F_lim
  double mu = 0.0;
  double normal_force = 0.0;   ///< F_N
  double contact_force = 0.0;  ///< F_C + F_int, signed
  double slip_rate = 0.0;
  double to_contact = 0.0;  ///< dF_lim/d(F_C + F_int)
  double to_rate = 0.0;     ///< dF_lim/d(slip rate)
  double to_slip = 0.0;     ///< dF_lim/d(dL) through the accumulated slip
};

/// F_lim as a function of the slip increment, all else of the increment given.
class LimitFunction {
 public:
  LimitFunction(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                const FrictionState& old, double motion)
      : definition_(definition),
        increment_(increment),
        accumulated_(old.accumulated_slip),
        contact_(evaluate(definition.contact_force, increment.force, increment.end)),
        inverse_duration_(increment.duration > 0.0 ? 1.0 / increment.duration : 0.0),
        slip_in_rate_(definition.slip_rate == SlipRateMeasure::kSlip ? inverse_duration_ : 0.0),
        motion_rate_(definition.slip_rate == SlipRateMeasure::kRelativeMotion
                         ? motion * inverse_duration_
                         : 0.0),
        slip_in_wear_(definition.accumulated_slip == AccumulatedSlipTiming::kEnd ? 1.0 : 0.0) {}

  Limit operator()(double slip) const noexcept { return at(slip, rate(slip)); }

  /// The rate the coefficient sees.
  double rate(double slip) const { return motion_rate_ + slip * slip_in_rate_; }

  /// The force limit; infinity if there is none.
  double cap() const { return definition_.force_limit; }

  /// Whether F_lim changes with the slip of this increment at all.
  bool depends_on_slip() const {
    return (slip_in_rate_ > 0.0 && depends_on_slip_rate(definition_.law)) ||
           (slip_in_wear_ > 0.0 && depends_on_accumulated_slip(definition_.internal_contact_force));
  }

  Limit at(double slip, double rate) const noexcept {
    Limit limit;
    const auto internal = evaluate(definition_.internal_contact_force, increment_.end,
                                   accumulated_ + slip_in_wear_ * slip);
    limit.contact_force = contact_ + internal.value;
    limit.normal_force = std::abs(limit.contact_force);
    limit.slip_rate = rate;
    const CoefficientPoint c = evaluate(definition_.law, increment_.end,
                                        {.slip_rate = rate, .contact_force = limit.normal_force});
    limit.mu = c.mu;
    limit.force = c.mu * limit.normal_force;
    if (limit.force >= definition_.force_limit) {
      limit.force = definition_.force_limit;  // the cap is a plateau: all slopes vanish
      return limit;
    }
    const double sign = limit.contact_force < 0.0 ? -1.0 : 1.0;
    limit.to_contact = sign * (c.mu + limit.normal_force * c.to_contact_force);
    limit.to_rate = limit.normal_force * c.to_slip_rate;
    limit.to_slip = limit.to_contact * internal.to_accumulated_slip * slip_in_wear_;
    return limit;
  }

  /// dF_lim/d(dL), rate and wear together.
  double slope(const Limit& limit) const { return limit.to_rate * slip_in_rate_ + limit.to_slip; }
  /// d(rate)/d|ds|.
  double motion_in_rate() const {
    return definition_.slip_rate == SlipRateMeasure::kRelativeMotion ? inverse_duration_ : 0.0;
  }
  double motion_rate(double motion) const { return motion * inverse_duration_; }

  /// The next slip after `slip` at which F_lim has a kink or changes its curvature: knots of tables
  /// over rate, accumulated slip and contact force, a change of sign of F_C + F_int, the inflection
  /// of an exponential coefficient times a normal force that wears. Between two of them F_lim is
  /// convex or concave, apart from the cubic of a table over both rate and contact force.
  double next_knot(double slip) const noexcept {
    double next = std::numeric_limits<double>::infinity();
    const auto* law = std::get_if<TabularCoefficient>(&definition_.law);
    if (slip_in_rate_ > 0.0 && law != nullptr) {
      const int k = law->table.column_of(IndependentKind::kSlipRate);
      if (k >= 0) next = first_above(law->table.table().knots(k), slip, 0.0, slip_in_rate_, next);
    }
    const auto* wear = std::get_if<TableFunction>(&definition_.internal_contact_force);
    if (slip_in_wear_ == 0.0 || wear == nullptr) return next;
    const int s = wear->column_of(IndependentKind::kAccumulatedSlip);
    if (s < 0) return next;
    next = first_above(wear->table().knots(s), slip, accumulated_, 1.0, next);

    const auto internal =
        evaluate(definition_.internal_contact_force, increment_.end, accumulated_ + slip);
    const double force = contact_ + internal.value;
    const double fall = internal.to_accumulated_slip;
    if (fall == 0.0) return next;
    // A point that rounding puts just ahead is the one the search stands on.
    const auto candidate = [&](double x) {
      if (x > slip + 1e-14 * x) next = std::min(next, x);
    };
    if (force * fall < 0.0) candidate(slip - force / fall);
    const double normal = std::abs(force);
    const double growth = force < 0.0 ? -fall : (force > 0.0 ? fall : std::abs(fall));
    if (law != nullptr) {
      const int k = law->table.column_of(IndependentKind::kContactForce);
      if (k < 0) return next;
      // F_N moves one way within a piece of the wear table: the next knot lies on that side.
      for (const double knot : law->table.table().knots(k))
        candidate(slip + (knot - normal) / growth);
    } else if (const auto* decay = std::get_if<ExponentialDecay>(&definition_.law)) {
      const double per_slip = decay->decay * slip_in_rate_;
      if (per_slip > 0.0) candidate(slip + 2.0 / per_slip - normal / growth);
    }
    return next;
  }

  /// Whether F_lim is cubic between knots: mu linear in the rate and in F_N, times F_N.
  bool is_cubic() const {
    const auto* law = std::get_if<TabularCoefficient>(&definition_.law);
    return law != nullptr && slip_in_rate_ > 0.0 && slip_in_wear_ > 0.0 &&
           law->depends_on_slip_rate() && law->depends_on_contact_force();
  }

 private:
  /// Smallest slip > `slip` with offset + factor * slip on a knot, at most `best`.
  static double first_above(std::span<const double> knots, double slip, double offset,
                            double factor, double best) noexcept {
    auto knot = std::upper_bound(knots.begin(), knots.end(), offset + factor * slip);
    // A slip that stands on a knot may be rounded back before it: that knot is past.
    while (knot != knots.end() && (*knot - offset) / factor <= slip) ++knot;
    return knot == knots.end() ? best : std::min((*knot - offset) / factor, best);
  }

  const FrictionDefinition& definition_;
  const ConnectorIncrement& increment_;
  double accumulated_;
  double contact_;
  double inverse_duration_;
  double slip_in_rate_;
  double motion_rate_;
  double slip_in_wear_;
};

/// Root of h(x) = trial - kappa x - F_lim(x) in [low, high] with h(low) > 0 >= h(high), by Newton's
/// method held inside a shrinking bracket; bisection wherever Newton leaves it or stalls.
double bracketed_root(const LimitFunction& limit, double trial, double kappa, double low,
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
double lowest_point(const LimitFunction& limit, double kappa, double low, double high) noexcept {
  for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
    const double middle = low + 0.5 * (high - low);
    (-kappa - limit.slope(limit(middle)) < 0.0 ? low : high) = middle;
  }
  return low + 0.5 * (high - low);
}

/// Smallest positive root of h(x) = trial - kappa x - F_lim(x), given h(0) > 0. One exists in
/// (0, trial/kappa] since F_lim >= 0. The search walks from knot to knot
/// (LimitFunction::next_knot); between two of them h is convex or concave, so that one sign change
/// means one root, and a dip shows in the slopes at the ends: no earlier root is passed over.
double first_root(const LimitFunction& limit, double trial, double kappa) noexcept {
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
  while (low < end) {
    double high = std::min(limit.next_knot(low), end);
    // Just inside the piece: at its ends the slopes may belong to the neighbours.
    const double margin = 1e-9 * (high - low);
    const double slope_low = slope_at(low + margin);
    double slope_high = slope_at(high - margin);
    if (limit.is_cubic()) {
      // h' is a parabola through three of its points; its vertex parts convex from concave.
      const double half = 0.5 * (high - low);
      const double slope_middle = slope_at(low + half);
      const double bend = 0.5 * (slope_low + slope_high) - slope_middle;
      const double vertex = bend != 0.0 ? -0.25 * (slope_high - slope_low) / bend : 1.0;
      if (vertex > -1.0 + 1e-6 && vertex < 1.0 - 1e-6) {
        high = low + half + vertex * half;
        slope_high = slope_at(high);
      }
    }
    const Limit there = limit(high);
    if (trial - kappa * high - there.force <= 0.0 || high >= end) {
      return bracketed_root(limit, trial, kappa, low, high);
    }
    // h > 0 at both ends: a dip between them could still hide a root.
    if (slope_low < 0.0 && slope_high > 0.0) {
      const double dip = lowest_point(limit, kappa, low, high);
      if (trial - kappa * dip - limit(dip).force <= 0.0) {
        return bracketed_root(limit, trial, kappa, low, dip);
      }
    }
    low = high;
  }
  return end;
}

/// True if h is positive at a knot after `root`, where it is not: then there are (more) roots.
bool has_later_root(const LimitFunction& limit, double trial, double kappa, double root) noexcept {
  const double end = trial / kappa;
  for (double x = limit.next_knot(root); x < end; x = limit.next_knot(x)) {
    if (trial - kappa * x - limit(x).force > 0.0) return true;
  }
  return false;
}

/// The first slip in [0, slip] from which on F_lim is 0, given that it is 0 at `slip`; 0 if it is 0
/// at rest already. The limit wears away once: bisection.
double first_zero(const LimitFunction& limit, double slip) noexcept {
  if (!(limit(0.0).force > 0.0)) return 0.0;
  double low = 0.0;
  double high = slip;
  for (int i = 0; i < 200 && high - low > std::numeric_limits<double>::epsilon() * high; ++i) {
    const double middle = low + 0.5 * (high - low);
    (limit(middle).force > 0.0 ? low : high) = middle;
  }
  return high;
}

template <int D>
using Slip = Eigen::Matrix<double, D, 1>;

template <int D>
Slip<D> load(const std::array<double, kComponents>& a) {
  return Eigen::Map<const Slip<D>>(a.data());
}
template <int D>
void store(const Slip<D>& v, std::array<double, kComponents>* a) {
  Eigen::Map<Slip<D>>(a->data()) = v;
}

template <int D>
double norm(const Slip<D>& v) {
  if constexpr (D == 1) {
    return std::abs(v[0]);
  } else {
    return std::sqrt(v.squaredNorm());
  }
}

/// Work of the force going from y0 to y1 over ds. The force first rises along the straight line to
/// the predictor `trial`; where that meets the limit the increment is split, so that the trapezoid
/// is exact for an elastic-plastic path in one dimension (reference cases, section 10, property 3).
template <int D>
double split_work(const Slip<D>& y0, const Slip<D>& trial, const Slip<D>& y1, const Slip<D>& ds,
                  double limit) {
  const Slip<D> rise = trial - y0;
  const double a = rise.squaredNorm();
  const double b = y0.dot(rise);
  // A force returned to the limit may lie above it by its rounding; it counts as on the limit.
  const double square = limit * limit;
  const double excess = y0.squaredNorm() - square;
  const double c = excess <= 2.0 * (kSlack - 1.0) * square ? std::min(excess, 0.0) : excess;
  double lambda = 0.0;
  if (a > 0.0 && c <= 0.0) {
    // The stable form of the positive root of a x^2 + 2 b x + c = 0.
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    lambda = b > 0.0 ? -c / (b + root) : (root - b) / a;
    lambda = std::clamp(lambda, 0.0, 1.0);
  }
  const Slip<D> split = y0 + lambda * rise;
  return 0.5 * (lambda * (y0 + split).dot(ds) + (1.0 - lambda) * (split + y1).dot(ds));
}

template <int D>
FrictionUpdate update_in(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                         const FrictionState& old) noexcept {
  FrictionUpdate result;
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;

  // 1. The motion in the scaled slip space.
  Slip<D> ds;
  for (int i = 0; i < D; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int c = definition.slip.component[k];
    ds[i] = definition.slip.scale[k] * (increment.end.position[c] - increment.begin_position[c]);
  }
  const double motion = norm<D>(ds);
  const LimitFunction limit(definition, increment, old, motion);

  // 2. Predictor: all motion elastic; the limit without slip.
  const Slip<D> elastic = load<D>(old.elastic_slip);
  const Slip<D> y_old = load<D>(old.force);
  const Slip<D> s_trial = elastic + ds;
  const Limit at_rest = limit(0.0);
  result.state.accumulated_slip = old.accumulated_slip;

  const auto report = [&](const Limit& l) {
    result.contact_force = l.contact_force;
    result.normal_force = l.normal_force;
    result.mu = l.mu;
    result.limit = l.force;
    result.slip_rate = l.slip_rate;
  };

  // 3. Nothing to hold on to: start again from a stress-free state (section 10.6). A coefficient
  //    that vanishes only at rest still grips as soon as there is slip.
  if (!(at_rest.force > 0.0) &&
      (!(at_rest.normal_force > 0.0) || !(limit.at(0.0, limit.motion_rate(motion)).force > 0.0))) {
    report(at_rest);
    result.state.regime = Regime::kOpen;
    result.work = 0.5 * y_old.dot(ds);  // the force falls from y_old to 0
    return result;
  }

  const double kappa_or_g = definition.stick.value;
  Slip<D> y, s_elastic, y_trial;
  Slip<D> n = Slip<D>::Zero();
  Limit l = at_rest;
  double slip = 0.0;
  bool slips = false;
  double trial = 0.0;

  if (fixed) {
    // 4a. Admissibility and return mapping with constant kappa (section 10.3).
    const double kappa = kappa_or_g;
    y_trial = y_old + kappa * ds;
    trial = norm<D>(y_trial);
    slips = trial > at_rest.force * kSlack;
    if (slips) {
      const double slope = limit.slope(at_rest);
      const bool implicit = limit.depends_on_slip();
      if (implicit) {
        slip = first_root(limit, trial, kappa);
        l = limit(slip);
      } else {
        slip = (trial - at_rest.force) / kappa;
        l.slip_rate = limit.rate(slip);
      }
      // The force is put on the limit; with the root at rounding accuracy both agree.
      result.multiple_roots =
          -slope > kappa || (implicit && has_later_root(limit, trial, kappa, slip));
      n = y_trial / trial;
      y = l.force * n;
      s_elastic = y / kappa;
    } else {
      result.multiple_roots = -limit.slope(at_rest) > kappa ||
                              (limit.depends_on_slip() && has_later_root(limit, trial, kappa, 0.0));
      y = y_trial;
      s_elastic = y / kappa;
    }
  } else {
    // 4b. The same with the allowable elastic slip g_c: dL does not depend on F_lim, so the
    //     return is closed (section 10.2).
    const double g = kappa_or_g;
    const double q = norm<D>(s_trial);
    slips = q > g * kSlack;
    if (slips) {
      slip = q - g;
      l = limit(slip);
      n = s_trial / q;
      s_elastic = g * n;
      y = l.force * n;
      trial = q;
    } else {
      s_elastic = s_trial;
      y = (l.force / g) * s_trial;
    }
    y_trial = (l.force / g) * s_trial;
  }

  // 4c. The slip has worn the limit away: the grip is lost at the first slip without limit, and
  //     what follows is no friction any more (section 10.6).
  bool opens = false;
  if (slips && !(l.force > 0.0)) {
    opens = true;
    slip = first_zero(limit, slip);
    y.setZero();
    s_elastic.setZero();
  }

  // 5. The new state, bookkeeping and energy (section 10.8).
  report(l);
  store<D>(y, &result.state.force);
  store<D>(s_elastic, &result.state.elastic_slip);
  result.state.regime = opens ? Regime::kOpen : (slips ? Regime::kSlip : Regime::kStick);
  result.slip_increment = slip;
  result.state.accumulated_slip += slip;
  result.dissipation = l.force * slip;
  result.stored_energy = 0.5 * y.dot(s_elastic);
  result.work = slips ? split_work<D>(y_old, y_trial, y, ds, l.force) : 0.5 * (y_old + y).dot(ds);
  const double p = norm<D>(y);
  result.phi = (slips && fixed && !opens ? trial - kappa_or_g * slip : p) - l.force;
  if (!slips && p > 0.0) n = y / p;
  if (slips || p > 0.0) store<D>(n, &result.direction);
  if (motion > 0.0) store<D>(ds / motion, &result.motion_direction);

  // 6. Consistent tangent (section 10.7, with wear and the rate of the relative motion).
  if (opens) return result;
  SlipTangent& t = result.tangent;
  const double by_rate = l.to_rate * limit.motion_in_rate();
  if (slips) {
    const double slope = limit.slope(l);
    if (fixed) {
      const double sum = kappa_or_g + slope;
      const double follow = sum != 0.0 ? kappa_or_g / sum : 0.0;
      t.transverse = l.force * kappa_or_g / trial;
      t.radial = slope * follow;
      t.rate = by_rate * follow;
      t.contact = l.to_contact * follow;
    } else {
      t.transverse = l.force / trial;
      t.radial = slope;
      t.rate = by_rate;
      t.contact = l.to_contact;
    }
  } else if (fixed) {
    t.transverse = t.radial = kappa_or_g;
  } else {
    t.transverse = t.radial = l.force / kappa_or_g;
    // y = (F_lim / g_c) s_trial also follows the limit, in proportion to |y| / F_lim.
    const double share = l.force > 0.0 ? p / l.force : 0.0;
    t.rate = by_rate * share;
    t.contact = l.to_contact * share;
  }
  return result;
}

}  // namespace

FrictionUpdate update(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                      const FrictionState& old) noexcept {
  switch (definition.slip.dimension) {
    case 1:
      return update_in<1>(definition, increment, old);
    case 2:
      return update_in<2>(definition, increment, old);
    case 3:
      return update_in<3>(definition, increment, old);
    case 4:
      return update_in<4>(definition, increment, old);
    case 5:
      return update_in<5>(definition, increment, old);
    default:
      return update_in<6>(definition, increment, old);
  }
}

ConnectorForce friction_force(const FrictionDefinition& definition, const FrictionState& state) {
  ConnectorForce force;
  for (int i = 0; i < definition.slip.dimension; ++i) {
    const auto k = static_cast<std::size_t>(i);
    force[definition.slip.component[k]] = definition.slip.scale[k] * state.force[k];
  }
  return force;
}

ConnectorTangent connector_tangent(const FrictionDefinition& definition,
                                   const ConnectorIncrement& increment,
                                   const FrictionUpdate& update) {
  ConnectorTangent tangent;
  tangent.to_motion.setZero();
  tangent.to_force.setZero();
  if (update.state.regime == Regime::kOpen) return tangent;

  ConnectorForce contact_to_force;
  RelativePosition contact_to_position;
  add_gradient(definition.contact_force, increment.force, increment.end, &contact_to_force,
               &contact_to_position);
  if (const auto* f = std::get_if<TableFunction>(&definition.internal_contact_force)) {
    // At the accumulated slip the increment's internal contact force was taken at.
    const bool at_end = definition.accumulated_slip == AccumulatedSlipTiming::kEnd;
    const double slip = update.state.accumulated_slip - (at_end ? 0.0 : update.slip_increment);
    if (f->value(increment.end, {.accumulated_slip = slip}) >= 0.0) {
      f->add_motion_slopes(increment.end, {.accumulated_slip = slip}, 1.0, &contact_to_position);
    }
  }

  const SlipSpace& space = definition.slip;
  const SlipTangent& t = update.tangent;
  for (int i = 0; i < space.dimension; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const int ci = space.component[a];
    const double n = update.direction[a];
    for (int j = 0; j < space.dimension; ++j) {
      const auto b = static_cast<std::size_t>(j);
      const double slip_tangent = (i == j ? t.transverse : 0.0) +
                                  (t.radial - t.transverse) * n * update.direction[b] +
                                  t.rate * n * update.motion_direction[b];
      tangent.to_motion(ci, space.component[b]) += space.scale[a] * slip_tangent * space.scale[b];
    }
    for (int c = 0; c < kComponents; ++c) {
      const double to_contact = space.scale[a] * n * t.contact;
      tangent.to_motion(ci, c) += to_contact * contact_to_position[c];
      tangent.to_force(ci, c) += to_contact * contact_to_force[c];
    }
  }
  return tangent;
}

}  // namespace slipbench::law
