// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

namespace slipbench::reference::masing {

/// Force [F] on the branch that left (u_r, F_r) and has reached `motion` [L] without another
/// reversal (Masing 1926): the backbone, doubled in both directions. `backbone` must be odd.
template <typename Backbone>
double branch(const Backbone& backbone, double reversal_motion, double reversal_force,
              double motion) {
  return reversal_force + 2.0 * backbone(0.5 * (motion - reversal_motion));
}

struct State {
  double motion = 0.0;       ///< u [L], from the relaxed start
  double force = 0.0;        ///< f [F]
  double dissipation = 0.0;  ///< [F L]
  double work = 0.0;         ///< integral of f du [F L]
};

/// Any path of a model that keeps Masing's rule, with return-point memory.
///
/// `Model` gives, found by argument-dependent lookup: backbone(model, u) [F], odd; backbone_work
/// (model, u), its integral from 0 [F L], even; loop_energy(model, A) for every A >= 0 [F L].
///
/// The turning points not yet passed again are kept. A branch that reaches the turning point before
/// the one it left has closed a loop: both are forgotten, and the older branch goes on. The first
/// branch ends on the backbone, at the mirror image of its own turning point (Iwan 1966). A branch
/// that has gone d from its turning point has dissipated half a loop of amplitude d/2, the backbone
/// a quarter loop of u: every slider that slips on a branch was slipping the other way when the
/// branch began.
template <typename Model>
class Path {
 public:
  explicit Path(const Model& model) : model_(model) {}

  [[nodiscard]] const State& state() const { return state_; }

  /// Straight on to `motion` [L], measured from the relaxed start.
  void advance(double motion) {
    if (motion == state_.motion) return;
    const double sense = motion > state_.motion ? 1.0 : -1.0;
    if (sense_ != 0.0 && sense != sense_) turns_.push_back({state_.motion, state_.force});
    sense_ = sense;
    while (!turns_.empty() && sense * (motion - end_of_branch()) >= 0.0) {
      follow(end_of_branch());
      turns_.pop_back();
      if (!turns_.empty()) turns_.pop_back();
    }
    follow(motion);
  }

 private:
  struct Turn {
    double motion;
    double force;
  };

  /// Returns where the present branch meets an older one.
  [[nodiscard]] double end_of_branch() const {
    return turns_.size() == 1 ? -turns_.front().motion : turns_[turns_.size() - 2].motion;
  }

  /// Along the present branch, which must not end before `motion`.
  void follow(double motion) {
    const bool first_loading = turns_.empty();
    const Turn origin = first_loading ? Turn{0.0, 0.0} : turns_.back();
    const double scale = first_loading ? 1.0 : 2.0;
    const double from = (state_.motion - origin.motion) / scale;
    const double to = (motion - origin.motion) / scale;
    state_.work += origin.force * (motion - state_.motion) +
                   scale * scale * (backbone_work(model_, to) - backbone_work(model_, from));
    state_.dissipation +=
        0.25 * scale * (loop_energy(model_, std::abs(to)) - loop_energy(model_, std::abs(from)));
    state_.force = origin.force + scale * backbone(model_, to);
    state_.motion = motion;
  }

  Model model_;
  State state_;
  std::vector<Turn> turns_;
  double sense_ = 0.0;
};

/// The evaluator of a closed form that is such a model: input the motion [L], outputs force,
/// dissipation, stored energy and work, all from the first row on.
template <typename Model>
PathEvaluator evaluator(const Model& model) {
  return [path = Path(model), origin = 0.0, started = false](std::span<const double> inputs,
                                                             std::span<double> outputs) mutable {
    if (!started) origin = inputs[0];
    started = true;
    path.advance(inputs[0] - origin);
    outputs[0] = path.state().force;
    outputs[1] = path.state().dissipation;
    outputs[2] = path.state().work - path.state().dissipation;
    outputs[3] = path.state().work;
  };
}

}  // namespace slipbench::reference::masing
