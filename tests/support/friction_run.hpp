// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "law/update/return_mapping.hpp"

namespace slipbench::test {

/// One friction definition driven increment by increment: set what the end of the next increment
/// shall be, then call step(). Starts at rest at position 0, stress-free.
class FrictionRun {
 public:
  explicit FrictionRun(law::FrictionDefinition friction) : definition(std::move(friction)) {}

  law::FrictionDefinition definition;
  law::RelativePosition position;   ///< at the end of the next increment
  law::RelativePosition reference;  ///< constitutive reference
  law::ConnectorForce force;        ///< constraint forces at the end of the next increment
  double temperature = 0.0;
  std::vector<double> fields;
  double duration = 1.0;

  law::FrictionState state;
  law::FrictionUpdate last;
  double dissipation = 0.0;  ///< sums over the run
  double work = 0.0;

  law::ConnectorIncrement increment() const {
    law::ConnectorIncrement next;
    next.duration = duration;
    next.begin_position = begin_;
    next.end = {position, law::constitutive_motion(position, reference), temperature, fields};
    next.force = force;
    return next;
  }

  const law::FrictionUpdate& step() {
    last = law::update(definition, increment(), state);
    state = last.state;
    dissipation += last.dissipation;
    work += last.work;
    begin_ = position;
    return last;
  }

  /// The next increment ends with component `number` (1..6) at `value`.
  const law::FrictionUpdate& move_to(int number, double value) {
    position[number - 1] = value;
    return step();
  }
  /// From here to `value` in `count` equal increments.
  const law::FrictionUpdate& ramp_to(int number, double value, int count) {
    const double from = position[number - 1];
    for (int i = 1; i < count; ++i) {
      move_to(number, from + (value - from) * static_cast<double>(i) / count);
    }
    return move_to(number, value);
  }
  double friction(int number) const { return law::friction_force(definition, state)[number - 1]; }

 private:
  law::RelativePosition begin_;
};

/// One slip component of scale 1 under a constant normal force.
inline law::FrictionDefinition slider(double mu, double normal_force, law::StickStiffness stick,
                                      std::initializer_list<int> number = {1}) {
  law::FrictionDefinition definition;
  definition.slip = law::slip_space(number);
  definition.internal_contact_force = normal_force;
  definition.law = law::ConstantCoefficient{mu};
  definition.stick = stick;
  return definition;
}

constexpr law::StickStiffness fixed_stiffness(double kappa) {
  return {law::StickStiffness::Mode::kStiffness, kappa};
}
constexpr law::StickStiffness allowable_slip(double g_c) {
  return {law::StickStiffness::Mode::kElasticSlip, g_c};
}

}  // namespace slipbench::test
