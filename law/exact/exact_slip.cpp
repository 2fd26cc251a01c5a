// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "law/base/runge_kutta.hpp"
#include "law/exact/exact_walk.hpp"

namespace slipbench::law {
namespace {

/// Parts in which a step is looked at for events.
constexpr int kSamples = 4;

/// Place of the first maximum of f in [from, to]; `to` where f does not fall.
/// \param size what the rounding of f is measured by
template <class Function>
double first_peak(Function&& f, double from, double to, double size) {
  const auto peak = [&](double low, double high) {
    return lowest([&](double t) { return -f(t); }, low, high,
                  -std::numeric_limits<double>::infinity());
  };
  double before = from;
  double at = from;
  double value = f(from);
  for (int k = 1; k <= kSamples; ++k) {
    const double next = k == kSamples ? to : from + (to - from) * k / kSamples;
    const double there = f(next);
    if (there < value - 16.0 * std::numeric_limits<double>::epsilon() * size) {
      return peak(before, next);
    }
    before = at;
    at = next;
    value = there;
  }
  // It may have begun to fall since the last look.
  const double step = 1e-5 * (to - from);
  const double fall = 4.0 * f(to - step) - 3.0 * value - f(to - 2.0 * step);
  return fall > 2e-15 * size ? peak(before, to) : to;
}

/// Returns the larger of `known` and the largest value of a smooth function in [from, to]: at an
/// end, or where a parabola through both and the middle has a top that is beyond `known`.
template <class Function>
double largest_on(Function&& f, double from, double to, double known) {
  const double begin = f(from);
  const double middle = f(0.5 * (from + to));
  const double end = f(to);
  known = std::max({known, begin, middle, end});
  const double rise = 4.0 * middle - 3.0 * begin - end;
  const double fall = 4.0 * middle - 3.0 * end - begin;
  // Slopes of the parabola at both ends; of a function that is constant they are rounding.
  const double flat = 1e-10 * std::abs(middle);
  if (!(rise > flat) || !(fall > flat)) return known;
  const double top = middle + 0.5 * (end - begin) * (end - begin) / (rise + fall);
  if (top < known) return known;
  const auto below = [&](double t) { return -f(t); };
  return std::max(known, f(lowest(below, from, to, -std::numeric_limits<double>::infinity())));
}

}  // namespace

double ExactWalk::slip_at_varying_radius(double begin, double to) noexcept {
  const double ratio = wear_ratio(begin, slip_ + kNoLimit * largest_slip_);
  if (ratio >= 1.0) {
    // The limit falls faster than the spring: the force drops without any motion.
    jump(begin);
    return begin;
  }
  note(Regime::kSlip, begin);
  const HalfAngle angle = half_angle(slip_at_);
  const double start = slip_;
  const double before = radius(begin, start);
  const double sum = start + before;
  // x: integral of |du|/R, of cos(psi) |du|, work, and dissipation.
  using State = std::array<double, 4>;
  const auto follow_to = [&](double tau, const State& x) { return follow(tau, sum + x[1], start); };
  const auto slip_of = [&](double tau, const State& x) { return follow_to(tau, x).slip; };
  // A stage of a step may miss by more than the turn itself.
  const auto cosine_of = [&](const State& x) {
    return turned(angle, std::max(x[0], 0.0)).cosine_of_angle();
  };
  const auto rates = [&](double tau, const State& x) -> State {
    const double slip = slip_of(tau, x);
    const double r = radius(tau, slip);
    const double cosine = cosine_of(x);
    const double force = limit(tau, slip, slip_rate(cosine)).force;
    // A radius of 0 turns the force at once; the largest number does.
    const double turn = r > 0.0 ? length_ / r : std::numeric_limits<double>::max();
    return {std::min(turn, 1e300), length_ * cosine, force * length_ * cosine,
            fixed_ ? 0.0 : force * (length_ * cosine - radius_rate_)};
  };

  double tau = begin;
  State x{};
  const auto at = [&](double t) {
    return t > tau ? runge_kutta_step(rates, tau, x, t - tau).end : x;
  };
  const auto way = [&](double t) {
    const State there = at(t);
    return point(t, slip_of(t, there), slip_rate(cosine_of(there)));
  };
  if (piece_) enter_piece(way, begin, to);

  // A limit that comes from 0 is measured by what the segment has.
  const double force = std::max(largest_limit(begin, to), 1e-3 * force_scale_);
  const double size = std::max(fixed_ ? force / points_.stick(begin) : points_.stick(begin),
                               points_.stick(to) * (fixed_ ? 0.0 : 1.0));
  double shortest = 1e-12 * (to - begin);
  double step = to - begin;
  const bool turns = angle.sine > 0.0 && angle.cosine > 0.0;
  if (turns && length_ > 0.0) step = std::min(0.5 * step, before / length_);
  bool ends = false;
  int steps = 0;
  while (tau < to && !ends) {
    // No piece is known to need a third as many.
    if (++steps > kMostPieces) {
      converged_ = false;
      shortest = std::max(shortest, 0.1 * (to - begin));
    }
    step = std::max(std::min(step, to - tau), std::min(shortest, to - tau));
    const double aim = step >= to - tau ? to : tau + step;
    double next = piece_ ? piece_->end_of(way, tau, aim, kSamples) : aim;
    bool leaves = next < aim;
    const auto falls = [&](double t) { return follow_to(t, at(t)).falls ? -1.0 : 1.0; };
    if (wears_ && falls(next) < 0.0) {
      // Wear takes the limit faster than the spring follows: from there on it jumps.
      next = first_negative(falls, tau, next);
      leaves = true;
    }
    const double peak =
        first_peak([&](double t) { return slip_of(t, at(t)); }, tau, next, sum + std::abs(x[1]));
    const bool rests = peak < next;
    if (rests) next = peak;

    const auto trial = runge_kutta_step(rates, tau, x, next - tau);
    const double turning =
        turned(angle, std::max(trial.end[0], 0.0)).sine_of_angle() * radius(next, start);
    const double error =
        std::max({turns ? std::abs(trial.error[0]) * turning : 0.0, std::abs(trial.error[1]),
                  std::abs(trial.error[2]) / force, std::abs(trial.error[3]) / force}) /
        (tolerance_ * size + 16.0 * kEpsilon * (std::abs(x[1]) + length_ * (next - tau)));
    // The end of a step is rounded.
    if (error > 1.0 && next - tau > (1.0 + 1e-6) * shortest + kEpsilon) {
      step = (next - tau) * std::max(0.2, 0.9 * std::pow(error, -0.2));
      continue;
    }
    // Where even that is not enough, as beside a limit that vanishes, it is not for long.
    if (error > 1.0) shortest *= 2.0;
    step = (next - tau) * std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
    if (wears_) {
      // Just inside: where a piece ends it is another one's already.
      const double low = slip_of(tau, x);
      const double high = std::max(slip_of(next, trial.end), low);
      const double inside = margin_inside(low, high, begin_slip_);
      const double margin = margin_inside(tau, next, 0.0);
      snap_back_ = largest_on(
          [&](double t) {
            const double slip = slip_of(t, t < next - margin ? at(t) : trial.end);
            return wear_ratio(t, std::clamp(slip, low + inside, high - inside));
          },
          tau + margin, next - margin, snap_back_);
    }
    x = trial.end;
    tau = next;
    ends = leaves || rests;
    must_stick_ = rests;
  }

  const double end = std::max(slip_of(tau, x), start);
  const double r = radius(tau, end);
  work_ += x[2];
  dissipation_ += std::max(fixed_ ? x[2] - (stored(r * r) - stored(before * before)) : x[3], 0.0);
  slip_ = end;
  slip_at_ = on_radius(turned(angle, std::max(x[0], 0.0)), r);
  return tau;
}

}  // namespace slipbench::law
