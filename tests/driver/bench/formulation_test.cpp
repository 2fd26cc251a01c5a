// SPDX-License-Identifier: Apache-2.0
// Formulations in a run: columns, failures at a row, warnings, a run that was cut.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/analysis/converge.hpp"
#include "driver/analysis/explain.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/read/read_case.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/events.hpp"
#include "driver/results/summary.hpp"
#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::bench {
namespace {

cases::Case read(const std::string& text) {
  read::ReadCase result = read::read_case_text(base::SourceText("case.yaml", text), ".", {});
  INFO(base::render(result.diagnostics, result.sources));
  REQUIRE(result.value.has_value());
  return std::move(*result.value);
}

std::string contact(const std::string& friction, const std::string& steps) {
  return "slipbench: 1\n"
         "units: {length: mm, force: N, time: s}\n"
         "connector: {type: CONTACT}\n"
         "friction:\n"
         "  - {predefined: {}, " +
         friction + "}\nhistory:\n" + steps;
}

const std::string kGo =
    "  - {step: go, increments: 100, force: {f1: 100}, motion: {CP2: {to: 10}, CP3: {to: 5}}}\n";

double value(const cases::Case& problem, const Row& row, const std::string& name) {
  INFO(name);
  const auto column = results::find_column(problem, results::result_columns(problem), name);
  REQUIRE(column);
  return results::column_value(*column, problem, row);
}
bool has(const cases::Case& problem, const std::string& name) {
  return results::find_column(problem, results::result_columns(problem), name).has_value();
}

results::Summary summary_of(const cases::Case& problem) {
  results::Summary summary(problem);
  for (const Row& row : rows_of(problem)) summary.add(row);
  return summary;
}

/// Returns why a run ends early.
SimulationFailure failure_of(const cases::Case& problem) {
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  while (true) {
    auto more = simulation->advance();
    if (!more) return more.error();
    REQUIRE(*more);
  }
}

TEST_CASE("a formulation has columns for each of its stages") {
  const cases::Case problem = read(contact(
      "coefficient: 0.3, formulation: {penalty: viscous, C: 2}, filter: {simple: 0.5}", kGo));
  const Row row = rows_of(problem).back();
  const double speed = std::sqrt(125.0);
  // Speeds are differences of positions: a few roundings of 10 over 0.01.
  CHECK(value(problem, row, "SPEED") == Approx(speed).epsilon(1e-12));
  CHECK(value(problem, row, "VISC_C") == 2.0);
  CHECK(value(problem, row, "CSF2_TRIAL") == Approx(20.0).epsilon(1e-12));
  CHECK(value(problem, row, "CSF3_TRIAL") == Approx(10.0).epsilon(1e-12));
  CHECK(value(problem, row, "CSF2_RAW") == Approx(20.0).epsilon(1e-12));
  CHECK(value(problem, row, "ALPHA") == 0.5);
  CHECK(value(problem, row, "UTILISATION") == Approx(2.0 * speed / 30.0).epsilon(1e-12));
  CHECK_FALSE(has(problem, "MU1"));
  CHECK_FALSE(has(problem, "MU_RAW"));
  CHECK_FALSE(has(problem, "PRESSURE"));
}

TEST_CASE("without a formulation there are none of its columns") {
  const cases::Case problem = read(contact("coefficient: 0.3, stick: {stiffness: 1000}", kGo));
  for (const char* name : {"SPEED", "VISC_C", "CSF2_TRIAL", "CSF2_RAW", "ALPHA", "UTILISATION"}) {
    INFO(name);
    CHECK_FALSE(has(problem, name));
  }
}

TEST_CASE("two directions have their coefficients and speeds") {
  const cases::Case problem = read(contact(
      "coefficient: {orthotropic: {direction1: 0.3, direction2: 0.1, axis: [0, 1]}}, formulation: "
      "{penalty: stiffness, K_t: 1.0e4}",
      kGo));
  const Row row = rows_of(problem).back();
  CHECK(value(problem, row, "MU1") == 0.3);
  CHECK(value(problem, row, "MU2") == 0.1);
  // Direction 1 is that of CP3.
  CHECK(value(problem, row, "V1") == Approx(5.0).epsilon(1e-12));
  CHECK(value(problem, row, "V2") == Approx(10.0).epsilon(1e-12));
  // F_i = N mu_i^2 v_i / sqrt(sum mu_j^2 v_j^2) in steady sliding.
  const double root = std::hypot(0.3 * 5.0, 0.1 * 10.0);
  CHECK(value(problem, row, "CSF3") == Approx(100.0 * 0.09 * 5.0 / root).epsilon(1e-9));
  CHECK(value(problem, row, "CSF2") == Approx(100.0 * 0.01 * 10.0 / root).epsilon(1e-9));
  CHECK(value(problem, row, "UTILISATION") == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("increments with a coefficient at its floor are counted and told") {
  const cases::Case problem = read(contact(
      "coefficient: {generalized_viscous: {Fric: 0.1, C2: -0.01, area: 2}}, stick: {stiffness: "
      "1.0e4}",
      "  - {step: slow, increments: 10, force: {f1: 100}, motion: {CP2: {to: 5}}}\n"
      "  - {step: fast, increments: 10, motion: {CP2: {to: 25}}}\n"));
  const std::vector<Row> rows = rows_of(problem);
  CHECK(value(problem, rows[5], "CLAMPED") == 0.0);
  CHECK(value(problem, rows[5], "MU_RAW") == Approx(0.05).epsilon(1e-9));
  CHECK(value(problem, rows.back(), "CLAMPED") == 1.0);
  CHECK(value(problem, rows.back(), "MU_RAW") == Approx(-0.1).epsilon(1e-9));
  CHECK(value(problem, rows.back(), "MU") == 1e-30);
  CHECK(value(problem, rows.back(), "PRESSURE") == 50.0);
  const results::Summary summary = summary_of(problem);
  CHECK(summary.definitions()[0].clamped == 10);
  bool told = false;
  for (const std::string& warning : summary.warnings({})) {
    told = told ||
           warning.find("not above 0 in 10 of 20 increments, down to -0.1") != std::string::npos;
  }
  CHECK(told);
}

TEST_CASE("a row farther from the last than a filter's period allows ends the run as bad input") {
  cases::Case problem = read(contact(
      "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 10}, filter: {period: 0.1}", kGo));
  problem.steps[0].increments = 10;  // the rows of a measured history are not known before the run
  const SimulationFailure failure = failure_of(problem);
  CHECK(failure.kind == SimulationFailure::Kind::kInput);
  CHECK(failure.message.find("alpha = 2 pi dt/T = 6.28319") != std::string::npos);
  CHECK(failure.message.find("dt = 0.1, T = 0.1") != std::string::npos);
}

TEST_CASE("an exponent beyond 700 names its coefficient and the speed") {
  const cases::Case problem = read(contact(
      "coefficient: {modified_darmstad: {Fric: 0.1, C5: 0.1, C6: 100}}, formulation: {penalty: "
      "stiffness, K_t: 10}",
      kGo));
  const SimulationFailure failure = failure_of(problem);
  CHECK(failure.kind == SimulationFailure::Kind::kNumerical);
  CHECK(failure.message.find("the exponent C6 V of the coefficient passes 700 at V = 11.18") !=
        std::string::npos);
}

TEST_CASE("a frequency above what the increments resolve is limited, counted and told") {
  const cases::Case problem = read(contact(
      "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 10}, filter: {frequency: 100}",
      kGo));
  const results::Summary summary = summary_of(problem);
  CHECK(summary.definitions()[0].alpha_limited == 100);
  CHECK(summary.definitions()[0].largest_alpha == Approx(2.0 * std::acos(-1.0)).epsilon(1e-9));
  CHECK(summary.warnings({}).size() == 1);
}

TEST_CASE("the largest overshoot of a filter is told with its time") {
  const cases::Case problem = read(contact(
      "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 1.0e5}, filter: {simple: 0.5}",
      kGo + "  - {step: drop, increments: 10, force: {f1: 10}, motion: {CP2: {to: 20}}}\n"));
  const results::Summary summary = summary_of(problem);
  // alpha + (1 - alpha) 100/10; the force before has settled to 2^-100, its direction to less
  // than the turn of one increment.
  CHECK(summary.definitions()[0].largest_use == Approx(5.5).epsilon(0.02));
  CHECK(summary.definitions()[0].largest_use_time == Approx(1.1).epsilon(1e-12));
  CHECK(summary.text().find("of its limit at t = 1.1 s (overshoot by the filter)") !=
        std::string::npos);
}

TEST_CASE("a run with a filter that was cut goes on with the same bytes") {
  const cases::Case problem = read(
      contact("coefficient: {renard: {C1: 0.15, C2: 0.10, C3: 0.25, C4: 0.05, C5: 10, C6: 100}}, "
              "formulation: {penalty: stiffness, K_t: 1000}, filter: {simple: 0.1}",
              kGo));
  auto whole = Simulation::start(problem);
  REQUIRE(whole);
  for (int i = 0; i < 40; ++i) REQUIRE(whole->advance());
  auto resumed = Simulation::resume(problem, whole->state());
  REQUIRE(resumed);
  REQUIRE(whole->advance());
  REQUIRE(resumed->advance());
  for (const results::Column& column : results::result_columns(problem)) {
    INFO(column.name);
    CHECK(results::column_value(column, problem, whole->row()) ==
          results::column_value(column, problem, resumed->row()));
  }
}

TEST_CASE("the arithmetic of a formulation is told") {
  const cases::Case problem = read(contact(
      "coefficient: 0.3, formulation: {penalty: viscous, VISF: 4, K: 5100, m: 1.0e-3, convention: "
      "as_coded}, filter: {simple: 0.5}",
      kGo));
  const auto text = analysis::explain(problem, 0.5);
  REQUIRE(text);
  INFO(*text);
  CHECK(text->find("C = sqrt(VISF 4.0) x sqrt(2 x K 5100.0 x m 0.001)") != std::string::npos);
  CHECK(text->find("filter alpha 0.5: ") != std::string::npos);
  const auto plain =
      analysis::explain(read(contact("coefficient: {orthotropic: {direction1: 0.3, direction2: "
                                     "0.1}}, stick: {stiffness: 1000}",
                                     kGo)),
                        0.5);
  REQUIRE(plain);
  INFO(*plain);
  CHECK(plain->find("formulation stiffness: trial (") != std::string::npos);
  CHECK(plain->find("mu1 0.3") != std::string::npos);
}

TEST_CASE("two equal coefficients at right angles are one, whatever the connector") {
  struct Connector {
    std::string type, friction, drives;
  };
  const std::vector<Connector> all = {
      {"CYLINDRICAL", "predefined: {R: 8}",
       "force: {f2: 30, f3: 40}, motion: {CP1: {to: 3}, CPR1: "},
      {"SLIDE-PLANE", "predefined: {}", "force: {f1: 50}, motion: {CP3: {to: 3}, CP2: "},
      {"[SLIDE-PLANE, CARDAN]", "predefined: {}", "force: {f1: 50}, motion: {CP3: {to: 3}, CP2: "},
      {"PLANAR", "potential: {terms: [{component: 2}, {component: 3}]}, contact_force: 1",
       "force: {f1: 50}, motion: {CP3: {to: 3}, CP2: "},
      {"CARTESIAN",
       "potential: {terms: [{component: 1}, {component: 3}]}, internal_contact_force: 50",
       "motion: {CP1: {to: 3}, CP3: "},
      {"[JOIN, CARDAN]",
       "potential: {terms: [{component: 4, scale: 2}, {component: 6, scale: 5}]}, contact_force: 2",
       "force: {f2: 50}, motion: {CPR1: {to: 3}, CPR3: "}};
  for (const Connector& one : all) {
    const auto rows = [&](const std::string& coefficient) {
      return rows_of(
          read("slipbench: 1\nconnector: {type: " + one.type + "}\nfriction:\n  - {" +
               one.friction + ", coefficient: " + coefficient +
               ", formulation: {penalty: stiffness, K_t: 500}}\nhistory:\n  - {step: go, "
               "increments: 40, " +
               one.drives + "{sine: {amplitude: 0.5, period: 0.4}}}}\n"));
    };
    INFO(one.type);
    const std::vector<Row> plain = rows("0.2");
    const std::vector<Row> two = rows("{orthotropic: {direction1: 0.2, direction2: 0.2}}");
    REQUIRE(plain.size() == two.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const law::FrictionUpdate& a = plain[i].definitions[0].update;
      const law::FrictionUpdate& b = two[i].definitions[0].update;
      for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::abs(a.state.force[k] - b.state.force[k]) <= 1e-14 * 10.0);  // the limit is 10
      }
      CHECK(std::abs(a.slip_increment - b.slip_increment) <= 1e-14);
    }
    CHECK(plain.back().definitions[0].update.state.accumulated_slip > 1.0);
  }
}

/// Two directions of which the second holds nothing: its coefficient is below 0 from 10 mm/s on.
const std::string kDeadAxis =
    "coefficient: {orthotropic: {direction1: 0.3, direction2: {generalized_viscous: {Fric: 0.1, "
    "C2: -0.01, area: 2}}, axis: [1.63, 2.52], speed: total}}, formulation: {penalty: stiffness, "
    "K_t: 4525";
const std::string kZigzag =
    "  - {step: a, increments: 17, force: {f1: 100}, motion: {CP2: {to: 50}, CP3: {to: 118}}}\n"
    "  - {step: b, increments: 17, force: {f1: 40}, motion: {CP2: {to: -110}, CP3: {to: 131}}}\n"
    "  - {step: c, increments: 17, force: {f1: 80}, motion: {CP2: {to: -45}, CP3: {to: 107}}}\n";

bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}
std::string warnings_of(const cases::Case& problem) {
  std::string all;
  for (const std::string& warning : summary_of(problem).warnings({})) all += warning + "\n";
  return all;
}

TEST_CASE("the rounding along a direction that holds nothing is no overshoot") {
  for (const char* rest :
       {", convention: as_coded}", "}", "}, filter: {simple: 0.5, clip: true}"}) {
    INFO(rest);
    const cases::Case problem = read(contact(kDeadAxis + rest, kZigzag));
    const results::Summary summary = summary_of(problem);
    CHECK(summary.definitions()[0].clamped > 0);
    CHECK(summary.definitions()[0].largest_use > 0.99);
    CHECK(summary.definitions()[0].largest_use < 1.0 + 1e-9);
    CHECK_FALSE(contains(summary.text(), "overshoot"));
  }
}

TEST_CASE("a filtered force beside a limit of 0 is beyond any share of it") {
  const std::string falls =
      "{columns: [mu, slip_rate], rows: [[0.3, 0], [0.3, 10], [0, 20], [0, 30]]}";
  const std::string steps =
      "  - {step: slow, increments: 10, force: {f1: 100}, motion: {CP2: {to: 5}}}\n"
      "  - {step: fast, increments: 10, motion: {CP2: {to: 30}}}\n";
  const std::string rest = ", formulation: {penalty: stiffness, K_t: 1000}, filter: {simple: 0.5}";
  for (const std::string& coefficient :
       {falls, "{orthotropic: {direction1: " + falls + ", direction2: 0.2}}"}) {
    INFO(coefficient);
    const cases::Case problem = read(contact("coefficient: " + coefficient + rest, steps));
    const results::Summary summary = summary_of(problem);
    CHECK(std::isinf(summary.definitions()[0].largest_use));
    CHECK(summary.definitions()[0].largest_use_time == Approx(1.1).epsilon(1e-12));
    CHECK(contains(summary.text(), " limit is 0, at t = 1.1 s"));
    const auto told = analysis::explain(problem, 1.1);
    REQUIRE(told);
    CHECK(contains(*told, " limit is 0: overshoot\n"));
  }
}

TEST_CASE("a stiffness penalty as coded is not said to smooth or to overshoot") {
  const cases::Case problem = read(contact(
      "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 10, convention: as_coded}, filter: "
      "{frequency: 100}",
      kGo));
  const results::Summary summary = summary_of(problem);
  CHECK(summary.definitions()[0].alpha_overshoots == 100);
  const std::string warnings = warnings_of(problem);
  CHECK(contains(warnings, "above 1 in 100 of 100 increments, up to 6.283: the spring is stiffer"));
  CHECK_FALSE(contains(warnings, "overshoots"));
  CHECK_FALSE(contains(warnings, "diverges"));
  CHECK(contains(summary.to_json().dump(), "\"increments_alpha_above_1\": 100"));
  const auto told = analysis::explain(problem, 0.5);
  REQUIRE(told);
  CHECK(contains(*told, " = force before + alpha 6.28319 x K_t 10.0 x ds"));
  CHECK_FALSE(contains(*told, "before the filter"));
}

TEST_CASE("a load on a stiffness penalty as coded stretches the softer spring of its filter") {
  const cases::Case problem = read(contact(
      "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 1000, convention: as_coded}, "
      "filter: {simple: 0.1}",
      "  - {step: go, increments: 20, force: {f1: 100, f2: {to: 20}}}\n"
      "  - {step: turn, increments: 20, force: {f2: {to: 0}, f3: {to: 29}}}\n"));
  const std::vector<Row> rows = rows_of(problem);
  // The equilibrium is found to 1e-9 of the forces.
  CHECK(value(problem, rows[20], "CSF2") == Approx(20.0).epsilon(1e-8));
  CHECK(value(problem, rows[20], "CP2") == Approx(20.0 / (0.1 * 1000.0)).epsilon(1e-8));
  CHECK(value(problem, rows.back(), "CP3") == Approx(29.0 / (0.1 * 1000.0)).epsilon(1e-8));
  CHECK(value(problem, rows.back(), "CP2") == Approx(0.0).margin(1e-8));
}

const std::string kUnload =
    "  - {step: slide, increments: 100, force: {f1: 100}, motion: {CP2: {to: 10}}}\n"
    "  - {step: unload, increments: 10, duration: 0.1, force: {f1: 40}, motion: {CP2: {to: 11}}}\n"
    "  - {step: back, increments: 10, duration: 0.1, motion: {CP2: {to: 10.98}}}\n"
    "  - {step: lift, increments: 10, duration: 0.1, force: {f1: 0}, motion: {CP2: {to: 11}}}\n";
const std::string kFiltered =
    "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 1000}, filter: {simple: 0.1}";

TEST_CASE("the events of a filtered force are those of the force before the filter") {
  const cases::Case problem = read(contact(kFiltered, kUnload));
  results::EventDetector detector(problem);
  std::vector<results::Event> events;
  for (const Row& row : rows_of(problem)) {
    for (const results::Event& event : detector.take(row)) events.push_back(event);
  }
  REQUIRE(events.size() == 3);
  CHECK(events[0].to == law::Regime::kSlip);
  CHECK(events[0].force == Approx(30.0).epsilon(1e-12));
  CHECK(events[1].to == law::Regime::kStick);
  CHECK(events[1].force == Approx(12.0).epsilon(1e-12));
  CHECK(events[2].to == law::Regime::kOpen);
  CHECK(events[2].force == 0.0);
  CHECK(contains(summary_of(problem).text(), ") at 30.0 N"));
}

TEST_CASE("what is told of a filtered force keeps both sides of the filter apart") {
  const cases::Case problem = read(contact(kFiltered, kUnload));
  const auto slides = analysis::explain(problem, 0.02);
  REQUIRE(slides);
  INFO(*slides);
  CHECK(contains(*slides, "slip   CSF2 +5.7 N"));
  CHECK(contains(*slides, "  P 30.0 N before the filter = "));
  CHECK(contains(*slides, "given out at 19 % of the limit\n"));
  const auto sticks = analysis::explain(problem, 1.15);
  REQUIRE(sticks);
  INFO(*sticks);
  CHECK(contains(*sticks, "  P 2.0 N before the filter = "));
  CHECK(contains(*sticks, "  Phi -10.0 N = P - limit   at 16.67 % of the limit\n"));
  CHECK(contains(*sticks, "given out at 109 % of the limit: overshoot\n"));
  const auto open = analysis::explain(problem, 1.3);
  REQUIRE(open);
  INFO(*open);
  CHECK(contains(*open, "  open: filter and memory start again from 0\n"));
  CHECK_FALSE(contains(*open, "trial"));
  CHECK_FALSE(contains(*open, "filter alpha"));
}

TEST_CASE("a coefficient of 0 is not called negative, and directions are told apart") {
  const cases::Case zero = read(contact(
      "coefficient: {generalized_viscous: {Fric: 0, area: 2}}, stick: {stiffness: 1000}", kGo));
  CHECK(contains(warnings_of(zero),
                 "the coefficient is not above 0 in 100 of 100 increments, and "
                 "kept at 1e-30 there: no friction;"));
  const std::string two = warnings_of(read(contact(kDeadAxis + "}", kZigzag)));
  INFO(two);
  CHECK(contains(two, "the coefficient of direction 2 is not above 0 in 51 of 51 increments"));
  CHECK(contains(two, "no friction along it"));
  CHECK(contains(two, "(column CLAMPED)"));
  CHECK_FALSE(contains(two, "direction 1"));
}

TEST_CASE("a coefficient below its floor in a blend is not said to leave no friction") {
  const cases::Case problem = read(
      contact("name: pad, coefficient: 0.3, stick: {stiffness: 1000}",
              "  - {step: go, increments: 10, force: {f1: 100}, motion: {CP2: {to: 10}}}\n"
              "  - {step: change, increments: 10, motion: {CP2: {to: 20}}, change_friction: {pad: "
              "{coefficient: {generalized_viscous: {Fric: -0.1, area: 2}}}}}\n"));
  const std::string told = warnings_of(problem);
  INFO(told);
  CHECK(contains(told, "no friction, but 9 of them blend it with another coefficient"));
}

TEST_CASE("a filter that counts increments is another one with other increments") {
  const std::string words = "its filter counts increments";
  const auto counts = analysis::converge(read(contact(kFiltered, kGo)));
  REQUIRE(counts);
  CHECK(contains(*counts, words));
  const auto by_time = analysis::converge(read(contact(
      "coefficient: 0.3, formulation: {penalty: stiffness, K_t: 1000}, filter: {period: 1}", kGo)));
  REQUIRE(by_time);
  CHECK_FALSE(contains(*by_time, words));
}

}  // namespace
}  // namespace slipbench::driver::bench
