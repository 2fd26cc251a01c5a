// SPDX-License-Identifier: Apache-2.0
// A mass that rubs on a second one: a clutch.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/results/columns.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::bench {
namespace {

std::string clutch(const std::string& dynamics, const std::string& steps,
                   const std::string& more = "") {
  return "slipbench: 1\n"
         "units: {length: m, force: N, time: s}\n"
         "connector: {type: REVOLUTE}\n"
         "friction: [{component: 4, internal_contact_force: 12, coefficient: 1}]\n" +
         more + "dynamics: {" + dynamics + "}\nhistory:\n" + steps;
}
const std::string kBoth = "mass: 0.6, initial_velocity: 20, driver: {mass: 0.4, velocity: 100}";

double value(const cases::Case& problem, const Row& row, const std::string& name) {
  INFO(name);
  const auto column = results::find_column(problem, results::result_columns(problem), name);
  REQUIRE(column);
  return results::column_value(*column, problem, row);
}

TEST_CASE("speeds and heat of a clutch do not depend on the increments") {
  const std::string more =
      "elasticity: [{component: 4, stiffness: 3}]\ndamping: [{component: 4, coefficient: 0.05}]\n";
  const auto end = [&](int increments) {
    return read::sound(
        clutch(kBoth,
               "  - {step: close, duration: 3, increments: " + std::to_string(increments) +
                   ", force: {driver: {to: 30}, m1: -2}}\n",
               more));
  };
  const cases::Case one = end(1), many = end(70);
  const Row a = rows_of(one).back(), b = rows_of(many).back();
  for (const char* name : {"CPR1", "CVR1", "MASS_V", "DRIVER_V", "DISS", "VISCOUS_DISS",
                           "ELASTIC_E", "KINETIC_E", "EXTERNAL_WORK", "CSM1"}) {
    CHECK(value(one, a, name) == Approx(value(many, b, name)).epsilon(1e-9));
  }
  const double start = 0.5 * (0.4 * 1e4 + 0.6 * 400.0);
  for (const Row& row : rows_of(many)) {
    const double gap = row.forces.kinetic_energy + row.forces.elastic_energy +
                       row.forces.viscous_dissipation + row.definitions[0].dissipation -
                       row.forces.external_work;
    CHECK(gap == Approx(start).epsilon(1e-11));
    // The loads alone change the momentum: 30 t^2/6 - 2 t of the ramp and the brake.
    CHECK(0.4 * value(many, row, "DRIVER_V") + 0.6 * value(many, row, "MASS_V") ==
          Approx(52.0 + 5.0 * row.time * row.time - 2.0 * row.time).epsilon(1e-12));
  }
}

TEST_CASE("a driver that nothing moves is a belt") {
  const std::string steps = "  - {step: go, duration: 9, increments: 90}\n";
  const cases::Case belt = read::sound(
      clutch("mass: 0.6, initial_velocity: 0, belt_velocity: 7, static_coefficient: 1.5", steps));
  const cases::Case heavy =
      read::sound(clutch("mass: 0.6, initial_velocity: 0, driver: {mass: 1.0e15, velocity: 7}, "
                         "static_coefficient: 1.5",
                         steps));
  const std::vector<Row> a = rows_of(belt), b = rows_of(heavy);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(value(belt, a[i], "CVR1") == Approx(value(heavy, b[i], "MASS_V")).margin(1e-11));
    CHECK(value(belt, a[i], "DISS") == Approx(value(heavy, b[i], "DISS")).margin(1e-10));
    CHECK(value(belt, a[i], "CSM1") == Approx(value(heavy, b[i], "CSM1")).margin(1e-11));
  }
}

TEST_CASE("two masses on the spring between them swing with their reduced mass") {
  const cases::Case problem = read::sound(
      read::changed({{"coefficient: 1", "coefficient: 0"}},
                    clutch("mass: 3, initial_velocity: 2, driver: {mass: 6, velocity: 2}",
                           "  - {step: swing, duration: 5, increments: 50}\n",
                           "elasticity: [{component: 4, stiffness: 50}]\n")));
  cases::Case bent = problem;
  bent.initial[3] = 0.1;
  for (const Row& row : rows_of(bent)) {
    CHECK(row.quantities[3] == Approx(0.1 * std::cos(5.0 * row.time)).margin(1e-11));
    CHECK(value(bent, row, "DRIVER_V") ==
          Approx(2.0 + 0.1 * 5.0 * std::sin(5.0 * row.time) / 3.0).margin(1e-10));
  }
}

TEST_CASE("a driver is told apart from a belt, and its load from that of the mass") {
  const auto error = [](const std::string& text) {
    const std::vector<std::string> all = read::messages(text);
    REQUIRE(all.size() == 1);
    return all[0];
  };
  const std::string steps = "  - {step: go, increments: 1, force: {driver: 5 N*m}}\n";
  CHECK(error(clutch("mass: 1, belt_velocity: 3, driver: {mass: 2}", steps)) ==
        "5:36: error: dynamics.belt_velocity: a mass rubs on a belt or on a driver, not on both; "
        "the driver's velocity at the start is 'driver: {velocity: ..}'");
  CHECK(error(clutch("mass: 1", steps)).find("history[0].force.driver: ") != std::string::npos);
  CHECK(error(clutch("mass: 1, driver: {velocity: 2}", "  - {step: go, increments: 1}\n"))
            .find("missing key 'mass'") != std::string::npos);
  CHECK(error(clutch("mass: 1, driver: {mass: 2}",
                     "  - {step: go, increments: 1, force: {driver: 5 N}}\n"))
            .find("force.driver") != std::string::npos);
  CHECK(read::messages(clutch("mass: 1, driver: {mass: 2}", steps)).empty());
}

TEST_CASE("a run of a clutch that was cut goes on with the same bytes") {
  const cases::Case problem =
      read::sound(clutch(kBoth, "  - {step: close, duration: 2, increments: 20}\n"));
  auto whole = Simulation::start(problem);
  REQUIRE(whole);
  for (int i = 0; i < 8; ++i) REQUIRE(whole->advance());
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

TEST_CASE("a load on a driver that is not there is told how to have one") {
  const std::string said = read::complaint(
      clutch("mass: 0.6, initial_velocity: 3", "  - {step: a, force: {driver: 3}}\n"));
  INFO(said);
  CHECK(said.find("history[0].force.driver: the mass has no driver that a load could act on; "
                  "'dynamics: {driver: {mass: .., velocity: ..}}' gives it one\n") !=
        std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::bench
