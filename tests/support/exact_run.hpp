// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "law/exact/continuous_update.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::test {

/// Ends of the straight pieces of a history.
struct Waypoint {
  law::RelativePosition position;
  law::ConnectorForce force;
  double temperature = 0.0;
  std::vector<double> fields;
  double duration = 1.0;
};

/// One friction definition driven along straight pieces by exact integration, or by backward Euler
/// to compare with. Starts at `begin`, stress-free.
class ExactRun {
 public:
  explicit ExactRun(law::FrictionDefinition friction, Waypoint begin = {}, double exactness = 1e-12)
      : definition(std::move(friction)), tolerance(exactness), here_(std::move(begin)) {}

  law::FrictionDefinition definition;
  double tolerance;
  bool backward_euler = false;
  law::FrictionState state;
  law::FrictionUpdate last;
  law::RegimeChanges changes;
  double dissipation = 0.0;  ///< sums over the run
  double work = 0.0;

  /// Goes straight to `to` in `count` equal increments.
  const law::FrictionUpdate& go(const Waypoint& to, int count = 1) {
    const Waypoint from = here_;
    for (int i = 1; i <= count; ++i) step(i == count ? to : between(from, to, i, count), count);
    return last;
  }
  double friction(int number) const { return law::friction_force(definition, state)[number - 1]; }
  const Waypoint& here() const { return here_; }

 private:
  static double mix(double a, double b, int i, int count) {
    return a == b ? b : a + (b - a) * i / count;
  }
  static Waypoint between(const Waypoint& from, const Waypoint& to, int i, int count) {
    Waypoint point = to;
    for (int c = 0; c < law::kComponents; ++c) {
      point.position[c] = mix(from.position[c], to.position[c], i, count);
      point.force[c] = mix(from.force[c], to.force[c], i, count);
    }
    point.temperature = mix(from.temperature, to.temperature, i, count);
    for (std::size_t f = 0; f < point.fields.size(); ++f) {
      point.fields[f] = mix(from.fields[f], to.fields[f], i, count);
    }
    return point;
  }
  static law::Ambient ambient(const Waypoint& at) {
    return {at.position, law::constitutive_motion(at.position, {}), at.temperature, at.fields};
  }
  void step(const Waypoint& to, int count) {
    law::ConnectorIncrement increment;
    increment.duration = to.duration / count;
    increment.begin_position = here_.position;
    increment.end = ambient(to);
    increment.force = to.force;
    const auto segment = law::path_segment(definition, increment, ambient(here_), here_.force);
    last = backward_euler ? law::update(definition, increment, state)
                          : law::continuous_update(definition, segment, state, tolerance, &changes);
    state = last.state;
    dissipation += last.dissipation;
    work += last.work;
    here_ = to;
  }

  Waypoint here_;
};

/// A waypoint at which component 1 (and 2) and constraint force 3 are given.
inline Waypoint at(double u1, double f3 = 0.0, double u2 = 0.0) {
  Waypoint point;
  point.position[0] = u1;
  point.position[1] = u2;
  point.force[2] = f3;
  return point;
}

}  // namespace slipbench::test
