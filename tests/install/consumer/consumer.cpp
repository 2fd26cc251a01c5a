// SPDX-License-Identifier: Apache-2.0
// A solver of its own that links the law, and checks it against a closed form of the other room.
#include <array>
#include <cmath>
#include <cstdio>
#include <slipbench/law/update/return_mapping.hpp>
#include <slipbench/reference/catalogue.hpp>
#include <vector>

int main() {
  namespace law = slipbench::law;
  namespace reference = slipbench::reference;

  law::FrictionDefinition definition;
  definition.slip = law::slip_space({1});
  definition.contact_force = law::DerivedComponent{law::norm_term({2, 3}, 1.0)};
  definition.law = law::ConstantCoefficient{0.2};
  definition.stick = {law::StickStiffness::Mode::kStiffness, 1000.0};

  const reference::ClosedForm* form = reference::find("coulomb_slider");
  if (form == nullptr) return 2;
  std::vector<std::vector<double>> parameters;
  for (const reference::Parameter& parameter : form->parameters) {
    parameters.push_back({parameter.default_value.value_or(0.0)});
    if (parameter.name == "mu") parameters.back() = {0.2};
    if (parameter.name == "normal_force") parameters.back() = {500.0};
    if (parameter.name == "stick_stiffness") parameters.back() = {1000.0};
  }
  const reference::PathEvaluator slider = form->make(parameters);
  std::vector<double> expected(form->outputs.size());
  slider(std::array{0.0}, expected);

  law::FrictionState state;
  law::ConnectorIncrement increment;
  increment.force[1] = 300.0;
  increment.force[2] = 400.0;  // with f2 = 300: a contact force of 500 and a limit of 100
  for (const double motion : {0.05, 0.2, 0.15, -0.3}) {
    increment.begin_position = increment.end.position;
    increment.end.position[0] = motion;
    increment.end.motion[0] = motion;
    state = law::update(definition, increment, state).state;
    slider(std::array{motion}, expected);
    // Both are a handful of operations: rounding at 100 is 1e-14.
    if (std::abs(state.force[0] - expected[0]) > 1e-11) {
      std::printf("at motion %g: law %.17g, closed form %.17g\n", motion, state.force[0],
                  expected[0]);
      return 1;
    }
  }
  return 0;
}
