// SPDX-License-Identifier: Apache-2.0
#include "law/extrapolated_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace slipbench::law {
namespace {

/// What is extrapolated: values at the end of a piece, and sums over it.
struct Sums {
  std::array<double, kComponents> elastic_slip{};
  double contact_force = 0.0;
  double mu = 0.0;
  double limit = 0.0;
  double slip_rate = 0.0;
  double slip = 0.0;
  double dissipation = 0.0;
  double work = 0.0;
};

template <class Function>
Sums combined(const Sums& a, const Sums& b, Function&& f) {
  Sums sum;
  for (std::size_t i = 0; i < sum.elastic_slip.size(); ++i) {
    sum.elastic_slip[i] = f(a.elastic_slip[i], b.elastic_slip[i]);
  }
  sum.contact_force = f(a.contact_force, b.contact_force);
  sum.mu = f(a.mu, b.mu);
  sum.limit = f(a.limit, b.limit);
  sum.slip_rate = f(a.slip_rate, b.slip_rate);
  sum.slip = f(a.slip, b.slip);
  sum.dissipation = f(a.dissipation, b.dissipation);
  sum.work = f(a.work, b.work);
  return sum;
}

/// Sub-increments of one piece.
struct Run {
  Sums end;
  FrictionUpdate last;
  bool same_regime = true;  ///< all of them have that of the piece's begin
};

class Pieces {
 public:
  Pieces(const FrictionDefinition& definition, const PathSegment& segment, double tolerance,
         RegimeChanges* changes)
      : definition_(definition),
        segment_(segment),
        points_(definition, segment, motion(definition, segment.increment)),
        tolerance_(tolerance),
        shortest_(0.1 * std::sqrt(tolerance)),
        fixed_(definition.stick.mode == StickStiffness::Mode::kStiffness),
        changes_(changes) {}

  FrictionUpdate advance(const FrictionState& old) noexcept {
    FrictionState state = old;
    regime_ = old.regime;
    if (fixed_) {
      for (std::size_t i = 0; i < kComponents; ++i) {
        state.elastic_slip[i] = old.force[i] / definition_.stick.value;
      }
    }
    FrictionUpdate last;
    double slip = 0.0;
    double dissipation = 0.0;
    double work = 0.0;
    double tau = 0.0;
    double step = 1.0;
    double onset = 0.0;
    while (tau < 1.0) {
      step = std::min(step, 1.0 - tau);
      const double end = 1.0 - tau - step < shortest_ ? 1.0 : tau + step;
      Run run;
      const bool settled = extrapolate(state, tau, end, &run);
      if (!settled && step > shortest_) {
        step *= 0.5;
        continue;
      }
      last = run.last;
      last.contact_force = run.end.contact_force;
      last.normal_force = std::abs(run.end.contact_force);
      last.mu = run.end.mu;
      last.limit = run.end.limit;
      last.slip_rate = run.end.slip_rate;
      const double before = state.accumulated_slip;
      state = last.state;
      state.elastic_slip = run.end.elastic_slip;
      state.accumulated_slip = before + run.end.slip;
      keep_admissible(last, &state);
      note(state, last, tau, &onset);
      slip += run.end.slip;
      dissipation += run.end.dissipation;
      work += run.end.work;
      tau = end;
      step *= 2.0;
    }
    last.state = state;
    last.slip_increment = slip;
    last.dissipation = dissipation;
    last.work = work;
    last.phi = potential_of(state.force) - last.limit;
    last.stored_energy = 0.0;
    for (std::size_t i = 0; i < kComponents; ++i) {
      last.stored_energy += 0.5 * state.force[i] * state.elastic_slip[i];
    }
    last.onset = state.regime == Regime::kSlip ? onset : 0.0;
    last.tangent = update(definition_, segment_.increment, old).tangent;
    return last;
  }

 private:
  static constexpr int kRows = 8;

  static double motion(const FrictionDefinition& definition, const ConnectorIncrement& increment) {
    double square = 0.0;
    for (int i = 0; i < definition.slip.dimension; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const int c = definition.slip.component[k];
      const double ds =
          definition.slip.scale[k] * (increment.end.position[c] - increment.begin_position[c]);
      square += ds * ds;
    }
    return std::sqrt(square);
  }

  /// `count` equal sub-increments of [from, to].
  Run sub_increments(const FrictionState& begin, double from, double to, int count) noexcept {
    Run run;
    FrictionState state = begin;
    ConnectorIncrement increment = segment_.increment;
    increment.begin_position = points_.increment(from).end.position;
    for (int i = 1; i <= count; ++i) {
      const double tau = i == count ? to : from + (to - from) * i / count;
      const ConnectorIncrement& here = points_.increment(tau);
      increment.end = here.end;
      increment.force = here.force;
      increment.duration = segment_.increment.duration * (to - from) / count;
      run.last = update(definition_, increment, state);
      state = run.last.state;
      run.same_regime = run.same_regime && state.regime == begin.regime;
      increment.begin_position = here.end.position;
      run.end.slip += run.last.slip_increment;
      run.end.dissipation += run.last.dissipation;
      run.end.work += run.last.work;
    }
    run.end.elastic_slip = state.elastic_slip;
    run.end.contact_force = run.last.contact_force;
    run.end.mu = run.last.mu;
    run.end.limit = run.last.limit;
    run.end.slip_rate = run.last.slip_rate;
    return run;
  }

  /// The table of Aitken and Neville over 1, 2, 3, ... sub-increments; true if its corner settles.
  bool extrapolate(const FrictionState& begin, double from, double to, Run* result) noexcept {
    std::array<Sums, kRows> table;  // the last row
    for (int j = 0; j < kRows; ++j) {
      Run run = sub_increments(begin, from, to, j + 1);
      result->last = run.last;
      // The row grows from its first entry; `above` are the entries of the row before.
      Sums entry = run.end;
      Sums previous = entry;
      for (int k = 0; k < j; ++k) {
        const auto n = static_cast<std::size_t>(k);
        const Sums above = table[n];
        table[n] = entry;
        const double weight = 1.0 / ((j + 1.0) / (j - k) - 1.0);
        previous = entry;
        entry =
            combined(entry, above, [weight](double a, double b) { return a + weight * (a - b); });
      }
      table[static_cast<std::size_t>(j)] = entry;
      const Sums corner = result->end;  // of the row before
      result->end = entry;
      // A change of regime inside may hide from the table in the first sub-increment of every row.
      if (!run.same_regime) return false;
      if (j == 0) continue;
      const auto difference = [](double a, double b) { return a - b; };
      if (small(combined(entry, previous, difference), run.last) &&
          small(combined(entry, corner, difference), run.last)) {
        return true;
      }
    }
    return false;
  }

  bool small(const Sums& error, const FrictionUpdate& at) const noexcept {
    const double elastic = fixed_ ? at.limit / definition_.stick.value : definition_.stick.value;
    double worst = std::abs(error.slip);
    for (const double e : error.elastic_slip) worst = std::max(worst, std::abs(e));
    worst = std::max({worst * at.limit, std::abs(error.dissipation), std::abs(error.work),
                      std::abs(error.limit) * elastic});
    return worst <= tolerance_ * at.limit * elastic;
  }

  /// Puts the force that goes with the extrapolated elastic slip into `state`, inside the limit.
  void keep_admissible(const FrictionUpdate& last, FrictionState* state) const noexcept {
    if (state->regime == Regime::kOpen) {
      state->elastic_slip = {};
      state->force = {};
      return;
    }
    const double stiffness =
        fixed_ ? definition_.stick.value : last.limit / definition_.stick.value;
    for (std::size_t i = 0; i < kComponents; ++i) {
      state->force[i] = stiffness * state->elastic_slip[i];
    }
    const double p = potential_of(state->force);
    if (p > last.limit) {
      for (std::size_t i = 0; i < kComponents; ++i) {
        state->force[i] *= last.limit / p;
        state->elastic_slip[i] *= last.limit / p;
      }
    }
  }

  double potential_of(const std::array<double, kComponents>& force) const noexcept {
    const auto* potential = std::get_if<Potential>(&definition_.criterion);
    return potential != nullptr ? value(*potential, force) : std::sqrt(dot(force, force));
  }

  void note(const FrictionState& state, const FrictionUpdate& last, double tau,
            double* onset) noexcept {
    if (state.regime == regime_) return;
    regime_ = state.regime;
    if (regime_ == Regime::kSlip) *onset = tau;
    if (changes_ == nullptr) return;
    if (changes_->count == static_cast<int>(changes_->at.size())) {
      changes_->overflow = true;
      return;
    }
    double force = std::sqrt(dot(state.force, state.force));
    if (definition_.slip.dimension == 1) force = state.force[0];
    changes_->at[static_cast<std::size_t>(changes_->count++)] = {tau, regime_, force, last.limit,
                                                                 state.accumulated_slip};
  }

  const FrictionDefinition& definition_;
  const PathSegment& segment_;
  SegmentPoints points_;
  double tolerance_;
  /// The shortest piece, as a part of the segment. What a change of regime inside of it does to the
  /// end goes with its square: a force that turns a corner at another place of it.
  double shortest_;
  bool fixed_;
  RegimeChanges* changes_;
  Regime regime_ = Regime::kStick;
};

}  // namespace

FrictionUpdate extrapolated_update(const FrictionDefinition& definition, const PathSegment& segment,
                                   const FrictionState& old, double tolerance,
                                   RegimeChanges* changes) noexcept {
  return Pieces(definition, segment, tolerance, changes).advance(old);
}

}  // namespace slipbench::law
