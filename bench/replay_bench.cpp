// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/bench/connector_increment.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/calibrate/replay.hpp"
#include "driver/case/quantity.hpp"
#include "driver/history/profile.hpp"
#include "law/connection/connection_type.hpp"
#include "law/sensitivity/sensitivity.hpp"

// Work of a calibration: a SLIDE-PLANE on a growing Lissajous path, 10,000
// increments, both forces compared at every increment. The law alone, its forces at the compared
// points, these with exact derivatives; over the forces' time, differences would take one run an
// unknown more. Every timed run checks where it ended.
namespace {

using namespace slipbench;

constexpr int kIncrements = 10000;

/// Problem of a fit: a definition, and how its numbers depend on the unknowns.
struct Problem {
  law::FrictionDefinition definition;
  law::DefinitionSlopes slopes;
};

law::TableFunction table(const std::vector<std::vector<double>>& rows, law::IndependentKind kind) {
  law::Table built;
  law::TableError error;
  law::Table::build(rows, 1, 1, law::Extrapolation::kConstant, &built, &error);
  return {built, {{kind, 0}}};
}

law::FrictionDefinition slide_plane() {
  const law::PredefinedFriction plane = law::SlidePlane{}.predefined().front();
  law::FrictionDefinition definition;
  definition.slip = plane.slip;
  definition.contact_force = plane.contact_force;
  definition.slip_rate = law::SlipRateMeasure::kRelativeMotion;
  definition.accumulated_slip = law::AccumulatedSlipTiming::kStart;
  definition.stick = {law::StickStiffness::Mode::kStiffness, 2000.0};
  return definition;
}

/// Stiffness, static and kinetic coefficient, decay.
Problem four_numbers() {
  Problem problem{slide_plane(), {}};
  problem.definition.internal_contact_force = 50.0;
  problem.definition.law = law::ExponentialDecay{0.30, 0.18, 0.5};
  std::vector<law::FrictionDefinition> above(4, problem.definition);
  above[0].stick.value += 1.0;
  std::get<law::ExponentialDecay>(above[1].law).mu_static += 1.0;
  std::get<law::ExponentialDecay>(above[2].law).kinetic += 1.0;
  std::get<law::ExponentialDecay>(above[3].law).decay += 1.0;
  for (std::size_t j = 0; j < above.size(); ++j) {
    law::add_slopes(problem.definition, above[j], 1.0, j, &problem.slopes);
  }
  return problem;
}

/// 12 ordinates of mu over the slip rate, 8 of F_int over the accumulated slip.
Problem twenty_ordinates() {
  std::vector<std::vector<double>> mu;
  for (const double v : {0.0, 0.3, 0.6, 1.0, 1.5, 2.0, 2.7, 3.5, 4.5, 5.5, 6.5, 8.0}) {
    mu.push_back({0.18 + 0.12 * std::exp(-v / 2.0), v});
  }
  std::vector<std::vector<double>> force;
  for (const double s : {0.0, 2.0, 4.0, 8.0, 12.0, 18.0, 25.0, 40.0}) {
    force.push_back({100.0 - 40.0 * (1.0 - std::exp(-s / 10.0)), s});
  }
  Problem problem{slide_plane(), {}};
  const law::FrictionDefinition base = [&] {
    law::FrictionDefinition definition = problem.definition;
    definition.law = law::TabularCoefficient{table(mu, law::IndependentKind::kSlipRate)};
    definition.internal_contact_force = table(force, law::IndependentKind::kAccumulatedSlip);
    return definition;
  }();
  for (std::size_t j = 0; j < mu.size() + force.size(); ++j) {
    law::FrictionDefinition above = base;
    law::Table& varied = j < mu.size()
                             ? std::get<law::TabularCoefficient>(above.law).table.table()
                             : std::get<law::TableFunction>(above.internal_contact_force).table();
    const std::size_t row = j < mu.size() ? j : j - mu.size();
    varied.set_ordinate(row, 0, varied.ordinate(row) + 1.0);
    law::add_slopes(base, above, 1.0, j, &problem.slopes);
  }
  problem.definition = base;
  return problem;
}

driver::cases::Case path(const law::FrictionDefinition& definition) {
  const auto formula = [](const std::string& text) -> driver::history::Profile {
    return *driver::history::compile_profile(text, {});
  };
  driver::cases::Case problem;
  problem.connection = law::find_connection("SLIDE-PLANE").value();
  problem.definitions = {{"plane", true, definition}};
  driver::cases::Step step{"path", 10.0, kIncrements, 1, {}};
  step.drives.push_back({1, formula("(0.3 + 0.07*t)*sin(2*pi*t)")});
  step.drives.push_back({2, formula("(0.15 + 0.035*t)*sin(2.74*pi*t + 0.3)")});
  step.drives.push_back({driver::cases::kFirstForce, formula("500 + 200*sin(0.62*pi*t)")});
  problem.initial[2] = 0.15 * std::sin(0.3);
  problem.steps.push_back(std::move(step));
  return problem;
}

void count_increments(benchmark::State& state) {
  state.counters["increment"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kIncrements,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The increments of a case as its run gives them.
std::vector<law::ConnectorIncrement> increments_of(const driver::cases::Case& path) {
  std::vector<law::ConnectorIncrement> increments;
  auto run = driver::bench::Simulation::start(path);
  while (run && *run->advance()) {
    increments.push_back(driver::bench::connector_increment(path, run->row()));
    increments.back().end.fields = {};
  }
  return increments;
}

law::FrictionState end_of(const law::FrictionDefinition& definition,
                          const std::vector<law::ConnectorIncrement>& increments) {
  law::FrictionState now;
  for (const law::ConnectorIncrement& increment : increments) {
    now = law::update(definition, increment, now).state;
  }
  return now;
}

std::vector<driver::calibrate::Replay::Response> both_forces() {
  std::vector<driver::calibrate::Replay::Response> responses = {{1, 1.0, {}}, {2, 1.0, {}}};
  for (driver::calibrate::Replay::Response& response : responses) {
    for (std::size_t row = 1; row <= kIncrements; ++row) response.points.push_back({row, 0.0});
  }
  return responses;
}

void law_alone(benchmark::State& state, const Problem& problem) {
  const auto increments = increments_of(path(problem.definition));
  const double slip = end_of(problem.definition, increments).accumulated_slip;
  for (auto _ : state) {
    const law::FrictionState now = end_of(problem.definition, increments);
    if (now.accumulated_slip != slip || !(slip > 1.0)) {
      state.SkipWithError("wrong end state");
      break;
    }
  }
  count_increments(state);
}

/// \param derivatives of all unknowns besides
void replayed(benchmark::State& state, const Problem& problem, bool derivatives) {
  const driver::cases::Case history = path(problem.definition);
  const auto replay = driver::calibrate::Replay::record(history);
  if (!replay) {
    state.SkipWithError("not recorded");
    return;
  }
  const law::FrictionState end = end_of(problem.definition, increments_of(history));
  const auto responses = both_forces();
  const std::size_t unknowns = problem.slopes.unknowns;
  std::vector<double> values(std::size_t{2} * kIncrements);
  std::vector<double> jacobian(values.size() * unknowns);
  for (auto _ : state) {
    const std::span<const law::FrictionDefinition> definitions(&problem.definition, 1);
    const bool done = derivatives ? replay->run(definitions, {&problem.slopes, 1}, unknowns,
                                                responses, values, jacobian)
                                  : replay->run(definitions, responses, values);
    if (!done || values[kIncrements - 1] != end.force[0] || values.back() != end.force[1] ||
        (derivatives && jacobian.back() == 0.0)) {
      state.SkipWithError("wrong end state");
      break;
    }
  }
  count_increments(state);
}

bool register_rows() {
  for (const auto& [name, problem] : {std::pair<std::string, Problem>{"4 numbers", four_numbers()},
                                      {"20 ordinates", twenty_ordinates()}}) {
    const auto add = [&, &of = name](const std::string& what, const auto& row) {
      benchmark::RegisterBenchmark(("calibration, " + of + ", " + what).c_str(), row)
          ->Unit(benchmark::kMillisecond);
    };
    add("law alone", [p = problem](benchmark::State& state) { law_alone(state, p); });
    add("forces", [p = problem](benchmark::State& state) { replayed(state, p, false); });
    add("forces and derivatives",
        [p = problem](benchmark::State& state) { replayed(state, p, true); });
  }
  return true;
}
const bool kRegistered = register_rows();

}  // namespace
