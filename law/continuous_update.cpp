// SPDX-License-Identifier: Apache-2.0
#include "law/continuous_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/exact_segment.hpp"
#include "law/extrapolated_update.hpp"
#include "law/first_negative.hpp"
#include "law/quadrature.hpp"
#include "law/runge_kutta.hpp"

namespace slipbench::law {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// R^2 - |s_el|^2 as a part of R^2 that is rounding: the state is on the radius.
constexpr double kOnRadius = 64.0 * kEpsilon;
/// Times closer than this part of the segment are one.
constexpr double kSameFraction = 1e-13;
/// A limit below this part of the segment's is 0, up to the rounding of where it vanishes.
constexpr double kNoLimit = 1e-12;
/// Step of the difference quotients of R as a part of a smooth piece.
constexpr double kDifference = 1e-5;
/// Steps or pieces after which an integration takes what it has: rounding is in its way.
constexpr int kMostPieces = 2000;

bool depends_on_motion(const FrictionDefinition& definition) {
  if (std::holds_alternative<UniversalJointContact>(definition.contact_force)) return true;
  const auto* internal = std::get_if<TableFunction>(&definition.internal_contact_force);
  if (internal != nullptr && internal->depends_on_motion()) return true;
  const auto* derived = std::get_if<DerivedComponent>(&definition.contact_force);
  return derived != nullptr &&
         std::any_of(derived->begin(), derived->end(), [](const DerivedTerm& term) {
           return term.weight_table && term.weight_table->depends_on_motion();
         });
}

/// Whether nothing that the limit depends on changes over the segment, apart from wear.
bool is_constant(const FrictionDefinition& definition, const PathSegment& segment) {
  const ConnectorIncrement& to = segment.increment;
  const auto* belt = std::get_if<Capstan>(&definition.criterion);
  return segment.begin_force == to.force && segment.begin.temperature == to.end.temperature &&
         std::equal(segment.begin.fields.begin(), segment.begin.fields.end(), to.end.fields.begin(),
                    to.end.fields.end()) &&
         segment.begin_blend.weight == definition.blend.weight &&
         segment.begin_stick == definition.stick.value &&
         (belt == nullptr || segment.begin_wrap_angle == belt->wrap_angle) &&
         !depends_on_motion(definition);
}

/// Place of the minimum of f in [low, high], which has one: golden section, as far as f is not
/// below `enough`.
template <class Function>
double lowest(Function&& f, double low, double high, double enough) {
  constexpr double kGolden = 0.61803398874989484820;
  double a = high - kGolden * (high - low);
  double b = low + kGolden * (high - low);
  double fa = f(a);
  double fb = f(b);
  for (int i = 0; i < 60 && fa >= enough && fb >= enough; ++i) {
    if (fa < fb) {
      high = b;
      b = a;
      fb = fa;
      a = high - kGolden * (high - low);
      fa = f(a);
    } else {
      low = a;
      a = b;
      fa = fb;
      b = low + kGolden * (high - low);
      fb = f(b);
    }
  }
  return fa < fb ? a : b;
}

/// One segment on its way from tau = 0 to tau = 1. `slip` is counted from the begin.
class Walk {
 public:
  Walk(const FrictionDefinition& definition, const PathSegment& segment, const FrictionState& old,
       double length, double sign, double tolerance, RegimeChanges* changes)
      : definition_(definition),
        segment_(segment),
        points_(definition, segment, length),
        length_(length),
        sign_(sign),
        inverse_duration_(segment.increment.duration > 0.0 ? 1.0 / segment.increment.duration
                                                           : 0.0),
        tolerance_(std::max(0.1 * tolerance, 1e-14)),
        fixed_(definition.stick.mode == StickStiffness::Mode::kStiffness),
        belt_(std::holds_alternative<Capstan>(definition.criterion)),
        wears_(depends_on_accumulated_slip(definition.internal_contact_force)),
        by_rate_(definition.slip_rate == SlipRateMeasure::kSlip &&
                 depends_on_slip_rate(definition.law)),
        constant_(is_constant(definition, segment)),
        radius_rate_(fixed_ ? 0.0 : definition.stick.value - segment.begin_stick),
        begin_slip_(old.accumulated_slip),
        regime_(old.regime),
        changes_(changes) {}

  void run(const PlaneSlip& begin) noexcept {
    slip_at_ = begin;
    scale_ = largest_limit(0.0, 1.0);
    settle_jump();
    double tau = 0.0;
    while (tau < 1.0) {
      double next = next_break(tau);
      if (belt_ && slip_at_.along < 0.0 && length_ > 0.0) {
        // The other side of a belt's band begins where its elastic slip passes 0.
        const double crossing = tau - slip_at_.along / length_;
        if (crossing <= tau + kSameFraction) {
          slip_at_.along = 0.0;
        } else {
          next = std::min(next, crossing);
        }
      }
      if (1.0 - next < kSameFraction) next = 1.0;
      advance(tau, next);
      tau = next;
    }
    if (!grips(1.0)) open(1.0);
  }

  const PlaneSlip& elastic_slip() const { return slip_at_; }
  double slip() const { return slip_; }
  double dissipation() const { return dissipation_; }
  double work() const { return work_; }
  double onset() const { return onset_; }
  Regime regime() const { return regime_; }
  bool converged() const { return converged_; }

  /// The limit at the end, with the rate that the coefficient sees there.
  Limit end_limit() noexcept {
    double rate = 0.0;
    if (regime_ == Regime::kSlip) {
      rate = (length_ * half_angle(slip_at_).cosine_of_angle() - radius_rate_) * inverse_duration_;
    }
    return limit(1.0, slip_, std::max(rate, 0.0));
  }

 private:
  double sense() const { return slip_at_.along < 0.0 ? -sign_ : sign_; }
  Limit limit(double tau, double slip, double rate = 0.0) noexcept {
    return points_.limit(tau, begin_slip_ + slip, rate, sense());
  }
  /// F_lim at its strongest: a coefficient that vanishes only at rest still grips.
  double strength(double tau) noexcept {
    const double at_rest = limit(tau, slip_).force;
    return by_rate_ ? std::max(at_rest, limit(tau, slip_, length_ * inverse_duration_).force)
                    : at_rest;
  }
  bool grips(double tau) noexcept { return strength(tau) > 0.0; }
  double radius(double tau, double slip) noexcept {
    const double stick = points_.stick(tau);
    return fixed_ ? limit(tau, slip).force / stick : stick;
  }

  void note(Regime to, double tau) noexcept {
    if (to == regime_) return;
    regime_ = to;
    if (to == Regime::kSlip) onset_ = tau;
    if (changes_ == nullptr) return;
    if (changes_->count == static_cast<int>(changes_->at.size())) {
      changes_->overflow = true;
      return;
    }
    const double lim = limit(tau, slip_).force;
    const double held = std::sqrt(slip_at_.square());
    double force = to == Regime::kSlip ? lim
                   : to == Regime::kOpen
                       ? 0.0
                       : held * (fixed_ ? points_.stick(tau) : lim / points_.stick(tau));
    if (definition_.slip.dimension == 1) force *= sense();
    changes_->at[static_cast<std::size_t>(changes_->count++)] = {tau, to, force, lim,
                                                                 begin_slip_ + slip_};
  }
  void open(double tau) noexcept {
    slip_at_ = {};
    note(Regime::kOpen, tau);
  }
  /// Takes the rounding out of an elastic slip that is on the radius.
  void put_on(double radius) noexcept {
    const double held = std::sqrt(slip_at_.square());
    if (!(held > 0.0)) return;
    slip_at_ = {slip_at_.along * (radius / held), slip_at_.across * (radius / held)};
  }
  /// Energy of the spring [F L], of a constant stick stiffness.
  double stored(double square) const { return 0.5 * definition_.stick.value * square; }

  /// The total slip x > = `least` at which x + R(tau, x) = sum: where the slip ends that has moved
  /// the spring's end by `sum` - R. Unique, since the limit falls less steeply than the spring.
  double slip_for(double tau, double sum, double least) noexcept {
    if (!fixed_ || !wears_) return sum - radius(tau, least);
    double low = least;
    double high = std::max(sum, least);
    double x = least;
    const double stick = points_.stick(tau);
    for (int i = 0; i < 100; ++i) {
      const Limit l = limit(tau, x);
      const double excess = x + l.force / stick - sum;
      (excess > 0.0 ? high : low) = x;
      const double step = excess / (1.0 + l.to_slip / stick);
      double next = x - step;
      if (std::abs(step) <= kEpsilon * sum) return next;
      if (!(next > low && next < high)) next = low + 0.5 * (high - low);
      if (next == x || high - low <= 2.0 * kEpsilon * high) break;
      x = next;
    }
    return x;
  }

  /// A limit that has jumped below the force when the segment begins: the spring relaxes at once,
  /// as it does under a limit that falls fast.
  void settle_jump() noexcept {
    const double held = std::sqrt(slip_at_.square());
    if (!(held > 0.0) || !grips(0.0)) return;
    const double before = radius(0.0, slip_);
    if (held * held - before * before <= kOnRadius * before * before) return;
    const double end = slip_for(0.0, slip_ + held, slip_);
    const double r = radius(0.0, end);
    note(Regime::kSlip, 0.0);
    dissipation_ +=
        fixed_ ? stored(held * held) - stored(r * r) : limit(0.0, end).force * (end - slip_);
    slip_ = end;
    put_on(r);
  }

  /// The end of the smooth piece that begins at tau: the next knot of a table, change of sign of a
  /// force, or place where the limit meets its cap, vanishes or passes a knot over F_N.
  double next_break(double tau) noexcept {
    if (constant_) return 1.0;
    double next = 1.0;
    const auto candidate = [&](double x) {
      if (x > tau + kSameFraction) next = std::min(next, x);
    };
    const ConnectorIncrement& to = segment_.increment;
    const auto knots_of = [&](const TableFunction& function) {
      for (int k = 0; k < function.table().independents(); ++k) {
        const Independent& independent = function.independents()[static_cast<std::size_t>(k)];
        const auto i = static_cast<std::size_t>(independent.index);
        double a = 0.0;
        double b = 0.0;
        switch (independent.kind) {
          case IndependentKind::kTemperature:
            a = segment_.begin.temperature;
            b = to.end.temperature;
            break;
          case IndependentKind::kField:
            a = segment_.begin.fields[i];
            b = to.end.fields[i];
            break;
          case IndependentKind::kPosition:
            a = segment_.begin.position.values[i];
            b = to.end.position.values[i];
            break;
          case IndependentKind::kConstitutiveMotion:
            a = segment_.begin.motion.values[i];
            b = to.end.motion.values[i];
            break;
          default:
            continue;
        }
        if (a == b) continue;
        const auto knots = function.table().knots(k);
        const double here = (1.0 - tau) * a + tau * b;
        // The knots on either side of here; rounding may have put one of them behind.
        const auto above = std::lower_bound(knots.begin(), knots.end(), here) - knots.begin();
        for (auto n = above - 2; n < above + 2; ++n) {
          if (n < 0 || n >= static_cast<std::ptrdiff_t>(knots.size())) continue;
          candidate((knots[static_cast<std::size_t>(n)] - a) / (b - a));
        }
      }
    };
    if (const auto* derived = std::get_if<DerivedComponent>(&definition_.contact_force)) {
      for (const DerivedTerm& term : *derived) {
        if (term.weight_table) knots_of(*term.weight_table);
      }
    }
    if (const auto* f = std::get_if<TableFunction>(&definition_.internal_contact_force)) {
      knots_of(*f);
    }
    if (const auto* f = std::get_if<TabularCoefficient>(&definition_.law)) knots_of(f->table);
    for (int c = 0; c < kComponents; ++c) {
      const double a = segment_.begin_force[c];
      const double b = to.force[c];
      if ((a < 0.0) != (b < 0.0)) candidate(a / (a - b));
    }
    // What is found by asking: the first change between samples, by bisection. So many are noise.
    if (++breaks_ > 100) return next;
    constexpr std::array kSamples{0.25, 0.5, 0.75, 1.0 - 1e-9};
    const double width = next - tau;
    double low = tau + 1e-9 * width;
    const Kind kind = kind_at(low);
    for (const double sample : kSamples) {
      double high = tau + sample * width;
      if (kind_at(high) == kind) {
        low = high;
        continue;
      }
      while (high - low > kSameFraction) {
        const double middle = low + 0.5 * (high - low);
        (kind_at(middle) == kind ? low : high) = middle;
      }
      return high;
    }
    return next;
  }

  /// What a smooth piece has in common.
  struct Kind {
    bool negative = false;  ///< F_C + F_int
    bool grips = false;
    bool capped = false;
    bool floored = false;     ///< the coefficient, by its floor
    std::ptrdiff_t cell = 0;  ///< of the coefficient's table over F_N
    friend bool operator==(const Kind&, const Kind&) = default;
  };
  Kind kind_at(double tau) noexcept {
    const Limit l = limit(tau, slip_);
    Kind kind{l.contact_force<0.0, l.force> 0.0, l.force >= definition_.force_limit,
              is_clamped(definition_.law, points_.increment(tau).end,
                         {.slip_rate = l.slip_rate, .contact_force = l.normal_force}),
              0};
    if (const auto* law = std::get_if<TabularCoefficient>(&definition_.law)) {
      const int k = law->table.column_of(IndependentKind::kContactForce);
      if (k >= 0) {
        const auto knots = law->table.table().knots(k);
        kind.cell = std::upper_bound(knots.begin(), knots.end(), l.normal_force) - knots.begin();
      }
    }
    return kind;
  }

  /// One smooth piece.
  void advance(double from, double to) noexcept {
    const double middle = from + 0.5 * (to - from);
    const double typical = strength(middle);
    if (!(typical > 0.0)) return open(from);
    if (regime_ != Regime::kOpen && !(strength(from) > kNoLimit * scale_)) open(from);
    if (regime_ == Regime::kOpen) slip_at_ = {};
    // Judged at five points: the piece is smooth.
    bool constant = fixed_ ? !wears_ : radius_rate_ == 0.0;
    if (constant && fixed_ && !constant_) {
      const double first = radius(from, slip_);
      for (const double x : {0.25, 0.5, 0.75, 1.0}) {
        constant = constant && radius(from + x * (to - from), slip_) == first;
      }
    }
    if (constant) {
      advance_closed(from, to);
    } else {
      advance_varying(from, to);
    }
  }

  /// A piece with one slip radius.
  void advance_closed(double from, double to) noexcept {
    const double r = radius(from, slip_);
    const double travel = length_ * (to - from);
    const double reserve = r * r - slip_at_.square();
    double w = 0.0;
    // At a right angle the root of the rounding would be a stick length.
    if (slip_at_.along > -4.0 * kEpsilon * r && reserve <= kOnRadius * r * r) {
      put_on(r);
    } else {
      w = stick_length(slip_at_, r);
    }
    const bool slips = travel > w;
    if (w > 0.0 || !slips) {
      note(Regime::kStick, from);
      const double end = slips ? from + w / length_ : to;
      stick(from, end, slips ? w : travel);
      if (!slips) return;
      from = end;
    }
    note(Regime::kSlip, from);
    const double rest = travel - w;
    const HalfAngle onset = half_angle(slip_at_);
    const double slip = segment_slip(onset, rest, r);
    if (fixed_) {
      // A constant limit: the spring keeps its energy.
      dissipation_ += limit(from, slip_).force * slip;
      work_ += limit(from, slip_).force * slip;
    } else {
      const double begin = slip_;
      const auto power = [&](double tau) {
        const double r_travel = length_ * (tau - from);
        const double cosine = turned(onset, r_travel / r).cosine_of_angle();
        const double so_far = begin + segment_slip(onset, r_travel, r);
        return limit(tau, so_far, length_ * cosine * inverse_duration_).force * cosine * length_;
      };
      int budget = kMostPieces;
      const double spent =
          constant_ && !wears_ && !by_rate_
              ? limit(from, slip_).force * slip
              : integral(power, from, to, tolerance_ * largest_limit(from, to) * rest, &budget);
      dissipation_ += spent;
      work_ += spent;
    }
    slip_ += slip;
    slip_at_ = on_radius(turned(onset, rest / r), r);
  }

  /// What errors of energies are measured by [F].
  double largest_limit(double from, double to) noexcept {
    return std::max({strength(from), strength(from + 0.5 * (to - from)), strength(to)});
  }

  /// Stick from `from` to `to` over the motion `travel`: s_el takes all of it.
  void stick(double from, double to, double travel) noexcept {
    const double before = slip_at_.along;
    slip_at_.along += travel;
    if (!(travel > 0.0)) return;
    if (fixed_) {
      work_ += definition_.stick.value * travel * (before + 0.5 * travel);
      return;
    }
    if (constant_) {
      work_ +=
          limit(from, slip_).force / definition_.stick.value * travel * (before + 0.5 * travel);
      return;
    }
    const auto power = [&](double tau) {
      return limit(tau, slip_).force / points_.stick(tau) * (before + length_ * (tau - from)) *
             length_;
    };
    int budget = kMostPieces;
    work_ += integral(power, from, to, tolerance_ * largest_limit(from, to) * travel, &budget);
  }

  /// dR/dtau at tau in the smooth piece [from, to], wear held: differences, one-sided at its ends.
  double radius_rate(double tau, double slip, double from, double to) noexcept {
    if (!fixed_) return radius_rate_;
    if (constant_) return 0.0;
    const double step = kDifference * (to - from);
    if (tau - from < step) {
      return (4.0 * radius(tau + step, slip) - 3.0 * radius(tau, slip) -
              radius(tau + 2.0 * step, slip)) /
             (2.0 * step);
    }
    if (to - tau < step) {
      return (3.0 * radius(tau, slip) - 4.0 * radius(tau - step, slip) +
              radius(tau - 2.0 * step, slip)) /
             (2.0 * step);
    }
    return (radius(tau + step, slip) - radius(tau - step, slip)) / (2.0 * step);
  }

  /// A piece whose slip radius changes.
  void advance_varying(double from, double to) noexcept {
    double tau = from;
    bool must_slip = false;
    bool must_stick = false;
    for (int phase = 0; tau < to; ++phase) {
      // Each phase ends at an event; so many cannot be in a smooth piece.
      if (phase > 60) {
        converged_ = false;
        return;
      }
      const double r = radius(tau, slip_);
      bool slips = must_slip;
      if (must_slip || r * r - slip_at_.square() <= kOnRadius * r * r) {
        put_on(r);
        // Below the rounding of the difference quotients, growth is none.
        const double floor = 1e-10 * r / (to - from);
        // What comes decides, not what was: the difference looks ahead.
        const double growth =
            length_ * half_angle(slip_at_).cosine_of_angle() - radius_rate(tau, slip_, tau, to);
        slips = slips || (!must_stick && growth > floor);
      }
      must_slip = must_stick = false;
      if (slips) {
        tau = slip_from(tau, from, to);
        if (regime_ == Regime::kOpen) return;
        must_stick = true;
        continue;
      }
      const double end = stick_end(tau, to);
      must_slip = end < to;
      if (end > tau) {
        note(Regime::kStick, tau);
        stick(tau, end, length_ * (end - tau));
        tau = end;
      }
    }
  }

  /// Where stick that begins at `from` meets the radius; `to` if it does not, `from` if it is at
  /// once outside.
  double stick_end(double from, double to) noexcept {
    const PlaneSlip begin = slip_at_;
    const auto reserve = [&](double tau) {
      const double r = radius(tau, slip_);
      const PlaneSlip s{begin.along + length_ * (tau - from), begin.across};
      return r * r - s.square();
    };
    constexpr int kCells = 8;
    std::array<double, kCells + 1> time;
    std::array<double, kCells + 1> value;
    for (int i = 0; i <= kCells; ++i) {
      const auto n = static_cast<std::size_t>(i);
      time[n] = i == kCells ? to : from + (to - from) * i / kCells;
      value[n] = reserve(time[n]);
      if (i == 0) continue;
      if (value[n] < 0.0) {
        double low = time[n - 1];
        if (i == 1 && !(value[0] > 4.0 * kOnRadius * begin.square())) {
          // It begins on the radius: step inside first.
          double step = 0.1 * (time[1] - from);
          while (step > kSameFraction && !(reserve(from + step) > 0.0)) step *= 0.1;
          if (step <= kSameFraction) return from;
          low = from + step;
        }
        return first_negative(reserve, low, time[n]);
      }
      // A reserve that is smallest in between may pass below 0 and come back.
      if (i >= 2 && value[n - 1] < value[n] && value[n - 1] <= value[n - 2]) {
        const double dip = lowest(reserve, time[n - 2], time[n], 0.0);
        if (reserve(dip) < 0.0 && value[n - 2] > 0.0) {
          return first_negative(reserve, time[n - 2], dip);
        }
      }
    }
    return to;
  }

  /// Slip from `begin` on, in the smooth piece [from, to]; returns where it ends.
  double slip_from(double begin, double from, double to) noexcept {
    note(Regime::kSlip, begin);
    const HalfAngle angle = half_angle(slip_at_);
    const double before = radius(begin, slip_);
    const double sum = slip_ + before;
    // x: integral of |du|/R, of cos(psi) |du|, work, and dissipation.
    using State = std::array<double, 4>;
    const auto rates = [&](double tau, const State& x) -> State {
      const double slip = slip_for(tau, sum + x[1], slip_);
      const double r = radius(tau, slip);
      const double along = length_ * turned(angle, x[0]).cosine_of_angle();
      const double growth = along - radius_rate_;
      const double force = limit(tau, slip, std::max(growth, 0.0) * inverse_duration_).force;
      // A radius of 0 turns the force at once; the largest number does.
      const double turn = r > 0.0 ? length_ / r : std::numeric_limits<double>::max();
      return {std::min(turn, 1e300), along, force * along, fixed_ ? 0.0 : force * growth};
    };
    const auto growth = [&](double tau, const State& x) {
      return length_ * turned(angle, x[0]).cosine_of_angle() -
             radius_rate(tau, slip_for(tau, sum + x[1], slip_), from, to);
    };
    const double middle = begin + 0.5 * (to - begin);
    const double size = std::max({before, radius(middle, slip_), radius(to, slip_)});
    const double force = largest_limit(begin, to);
    const double floor = 1e-10 * size / (to - from);
    double shortest = 1e-12 * (to - begin);

    double tau = begin;
    State x{};
    double step = 0.5 * (to - begin);
    bool ends = false;
    bool worn = false;
    while (tau < to && !ends) {
      // A limit that wears towards 0, with ever shorter steps, must not take for ever.
      if (++steps_ > kMostPieces) shortest = std::max(shortest, 0.1 * (to - begin));
      step = std::max(std::min(step, to - tau), std::min(shortest, to - tau));
      const bool last = step >= to - tau;
      const auto trial = runge_kutta_step(rates, tau, x, step);
      const double next = last ? to : tau + step;
      const double turning = turned(angle, trial.end[0]).sine_of_angle() * radius(next, slip_);
      const double error =
          std::max(
              {angle.sine == 0.0 || angle.cosine == 0.0 ? 0.0 : std::abs(trial.error[0]) * turning,
               std::abs(trial.error[1]), std::abs(trial.error[2]) / force,
               std::abs(trial.error[3]) / force}) /
          (tolerance_ * size + 16.0 * kEpsilon * (x[1] + length_ * step));
      if (error > 1.0 && step > shortest) {
        step *= std::max(0.2, 0.9 * std::pow(error, -0.2));
        continue;
      }
      // Where even that is not enough, as beside a limit that vanishes, it is not for long.
      if (error > 1.0) shortest *= 2.0;
      State end = trial.end;
      double reached = next;
      if (growth(next, end) < -floor) {
        // The slip comes to rest in this step.
        ends = true;
        State at_end = x;
        const auto still_grows = [&](double t) {
          at_end = t > tau ? runge_kutta_step(rates, tau, x, t - tau).end : x;
          return growth(t, at_end);
        };
        // It need not have grown at the begin, where it had to slip to stay inside.
        if (still_grows(tau + 1e-6 * step) >= 0.0) {
          reached = first_negative(still_grows, tau + 1e-6 * step, next);
          // The differences see a corner of R from some way off; the slip itself is largest there.
          const double about = 3.0 * kDifference * (to - from);
          const auto lacking = [&](double t) {
            const State at = t > tau ? runge_kutta_step(rates, tau, x, t - tau).end : x;
            return -slip_for(t, sum + at[1], slip_);
          };
          reached = lowest(lacking, std::max(tau, reached - about), std::min(next, reached + about),
                           -std::numeric_limits<double>::infinity());
          end = runge_kutta_step(rates, tau, x, reached - tau).end;
        } else {
          ends = false;
        }
      }
      if (wears_ && !(radius(reached, slip_for(reached, sum + end[1], slip_)) > kNoLimit * size)) {
        // The slip has worn the limit away; what follows is no friction any more.
        const auto left = [&](double t) {
          const State at = t > tau ? runge_kutta_step(rates, tau, x, t - tau).end : x;
          return radius(t, slip_for(t, sum + at[1], slip_)) - kNoLimit * size;
        };
        reached = first_negative(left, tau, reached);
        end = runge_kutta_step(rates, tau, x, reached - tau).end;
        ends = worn = true;
      }
      x = end;
      tau = reached;
      step *= std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
    }

    const double end_slip = std::max(slip_for(tau, sum + x[1], slip_), slip_);
    const double r = radius(tau, end_slip);
    work_ += x[2];
    dissipation_ += std::max(fixed_ ? x[2] - (stored(r * r) - stored(before * before)) : x[3], 0.0);
    slip_ = end_slip;
    slip_at_ = on_radius(turned(angle, x[0]), r);
    if (worn) open(tau);
    return tau;
  }

  const FrictionDefinition& definition_;
  const PathSegment& segment_;
  SegmentPoints points_;
  double length_;  ///< |ds| [L]
  double sign_;    ///< of ds in one dimension
  double inverse_duration_;
  double tolerance_;
  bool fixed_;
  bool belt_;
  bool wears_;
  bool by_rate_;        ///< the coefficient sees the rate of the slip
  bool constant_;       ///< nothing but wear changes the limit
  double radius_rate_;  ///< dg_c/dtau of an allowable elastic slip that changes
  double begin_slip_;

  PlaneSlip slip_at_;
  double slip_ = 0.0;
  double dissipation_ = 0.0;
  double work_ = 0.0;
  double onset_ = 0.0;
  Regime regime_;
  double scale_ = 0.0;  ///< of the limit [F]
  int breaks_ = 0;
  int steps_ = 0;
  bool converged_ = true;
  RegimeChanges* changes_;
};

}  // namespace

std::optional<NoContinuousSolution> no_continuous_solution(const FrictionDefinition& definition) {
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;
  if (fixed && definition.slip_rate == SlipRateMeasure::kSlip &&
      steepest_weakening(definition.law) > 0.0) {
    return NoContinuousSolution::kWeakening;
  }
  if (definition.accumulated_slip == AccumulatedSlipTiming::kStart &&
      depends_on_accumulated_slip(definition.internal_contact_force)) {
    return NoContinuousSolution::kWearAtStart;
  }
  return std::nullopt;
}

ContinuousMethod continuous_method(const FrictionDefinition& definition) {
  const bool viscous = definition.stick.mode == StickStiffness::Mode::kStiffness &&
                       definition.slip_rate == SlipRateMeasure::kSlip &&
                       depends_on_slip_rate(definition.law);
  return viscous || std::holds_alternative<Potential>(definition.criterion)
             ? ContinuousMethod::kExtrapolation
             : ContinuousMethod::kEvents;
}

FrictionUpdate continuous_update(const FrictionDefinition& definition, const PathSegment& segment,
                                 const FrictionState& old, double tolerance,
                                 RegimeChanges* changes) noexcept {
  if (changes != nullptr) {
    changes->count = 0;
    changes->overflow = false;
  }
  if (continuous_method(definition) == ContinuousMethod::kExtrapolation) {
    return extrapolated_update(definition, segment, old, tolerance, changes);
  }
  const ConnectorIncrement& increment = segment.increment;
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;
  const auto dimension = static_cast<std::size_t>(definition.slip.dimension);

  // The motion, and the plane it spans with the elastic slip.
  std::array<double, kComponents> direction{};
  std::array<double, kComponents> begin{};
  double square = 0.0;
  double held = 0.0;
  for (std::size_t i = 0; i < dimension; ++i) {
    const int c = definition.slip.component[i];
    direction[i] =
        definition.slip.scale[i] * (increment.end.position[c] - increment.begin_position[c]);
    begin[i] = fixed ? old.force[i] / definition.stick.value : old.elastic_slip[i];
    square += direction[i] * direction[i];
    held += begin[i] * begin[i];
  }
  const double length = dimension == 1 ? std::abs(direction[0]) : std::sqrt(square);
  // Without motion the elastic slip itself is the direction.
  const bool moves = length > 0.0;
  const double unit = moves ? length : std::sqrt(held);
  PlaneSlip slip;
  std::array<double, kComponents> across{};
  if (unit > 0.0) {
    for (std::size_t i = 0; i < dimension; ++i) {
      direction[i] = moves ? direction[i] / unit : begin[i] / unit;
      slip.along += begin[i] * direction[i];
    }
    if (dimension > 1 && moves) {
      double rest = 0.0;
      for (std::size_t i = 0; i < dimension; ++i) {
        across[i] = begin[i] - slip.along * direction[i];
        rest += across[i] * across[i];
      }
      slip.across = std::sqrt(rest);
      // What is left of a parallel one is the rounding of the projection.
      if (slip.across <= 4.0 * kEpsilon * std::sqrt(held)) slip.across = 0.0;
    }
  } else {
    direction[0] = 1.0;
  }

  Walk walk(definition, segment, old, length, direction[0] < 0.0 ? -1.0 : 1.0, tolerance, changes);
  walk.run(slip);

  FrictionUpdate result;
  const Limit l = walk.end_limit();
  result.contact_force = l.contact_force;
  result.normal_force = l.normal_force;
  result.mu = l.mu;
  result.limit = l.force;
  result.slip_rate = l.slip_rate;
  const PlaneSlip& end = walk.elastic_slip();
  const double stiffness = fixed ? definition.stick.value : l.force / definition.stick.value;
  const double share = slip.across > 0.0 ? end.across / slip.across : 0.0;
  double p = 0.0;
  for (std::size_t i = 0; i < dimension; ++i) {
    const double s = end.along * direction[i] + share * across[i];
    result.state.elastic_slip[i] = s;
    result.state.force[i] = stiffness * s;
    p += result.state.force[i] * result.state.force[i];
    result.stored_energy += 0.5 * result.state.force[i] * s;
    if (moves) result.motion_direction[i] = direction[i];
  }
  p = std::sqrt(p);
  if (p > 0.0) {
    for (std::size_t i = 0; i < dimension; ++i) result.direction[i] = result.state.force[i] / p;
  }
  result.state.regime = walk.regime();
  result.state.accumulated_slip = old.accumulated_slip + walk.slip();
  result.slip_increment = walk.slip();
  result.dissipation = walk.dissipation();
  result.work = walk.work();
  result.phi = p - l.force;
  result.onset = walk.regime() == Regime::kSlip ? walk.onset() : 0.0;
  result.converged = walk.converged();
  result.tangent = update(definition, increment, old).tangent;
  return result;
}

}  // namespace slipbench::law
