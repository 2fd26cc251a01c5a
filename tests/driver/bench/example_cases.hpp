// SPDX-License-Identifier: Apache-2.0
// Cases built by hand, so that these tests do not depend on the reader.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/case/quantity.hpp"
#include "law/definition/potential_terms.hpp"

namespace slipbench::driver::bench {

/// mu = 0.2, N = 100 N, k = 1000 N/mm in SLOT: the limit is 20 N, the elastic slip 0.02 mm. The
/// normal force is an internal one, so nothing but the motion has to be driven.
inline cases::Case slider_case(std::vector<cases::Step> steps) {
  cases::Case problem;
  problem.file = "folder/slider.yaml";
  problem.title = "Slider";
  problem.units = {"mm", "N", "s", ""};
  problem.parameters = {{"mu", 0.2}};
  problem.connection = law::find_connection("SLOT").value();
  law::FrictionDefinition definition;
  definition.slip = law::slip_space({1});
  definition.internal_contact_force = 100.0;
  definition.law = law::ConstantCoefficient{0.2};
  definition.stick = {law::StickStiffness::Mode::kStiffness, 1000.0};
  problem.definitions = {{"sleeve", false, definition}};
  problem.steps = std::move(steps);
  return problem;
}

/// The contributions of components 1 and 2, and the slip space they make.
inline law::BuiltPotential both_axes(law::PotentialOperator op, double exponent) {
  std::vector<law::PotentialContribution> axes(2);
  axes[0].of = 0;
  axes[1].of = 1;
  return law::build_potential(axes, op, exponent);
}

/// A step that drives one quantity.
inline cases::Step step(std::string name, int increments, int quantity, history::Profile profile,
                        double duration = 1.0, int repeat = 1) {
  return {std::move(name), duration, increments, repeat, {{quantity, std::move(profile)}}};
}

/// PLANAR with predefined friction: R = 0.5, F_int = 20, M_int = 3, mu = 0.2, a known
/// example, pressed by f1 = -100, m2 = 6, m3 = 8.
inline cases::Case puck_case(std::vector<cases::Step> steps) {
  cases::Case problem;
  problem.file = "puck.yaml";
  problem.connection = law::find_connection("PLANAR").value();
  law::Planar planar;
  planar.R = 0.5;
  planar.internal_contact_force = 20.0;
  planar.internal_contact_moment = 3.0;
  for (const law::PredefinedFriction& check : planar.predefined()) {
    law::FrictionDefinition definition;
    definition.slip = check.slip;
    definition.contact_force = check.contact_force;
    definition.internal_contact_force = check.internal_contact_force;
    definition.law = law::ConstantCoefficient{0.2};
    problem.definitions.push_back(
        {std::string(check.suffix), check.slip.dimension > 1, definition});
  }
  problem.steps = std::move(steps);
  for (cases::Step& one : problem.steps) {
    one.drives.push_back({cases::kFirstForce + 0, history::Constant{-100.0}});
    one.drives.push_back({cases::kFirstForce + 4, history::Constant{6.0}});
    one.drives.push_back({cases::kFirstForce + 5, history::Constant{8.0}});
  }
  return problem;
}

/// All rows of a run; throws if it ends early.
inline std::vector<Row> rows_of(const cases::Case& problem) {
  auto simulation = Simulation::start(problem);
  if (!simulation) throw std::runtime_error(simulation.error().message);
  std::vector<Row> rows = {simulation->row()};
  while (true) {
    const auto more = simulation->advance();
    if (!more) throw std::runtime_error(more.error().message);
    if (!*more) return rows;
    rows.push_back(simulation->row());
  }
}

}  // namespace slipbench::driver::bench
