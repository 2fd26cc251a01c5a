// SPDX-License-Identifier: Apache-2.0
// Belts (SLIPRING): from the text to the columns.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "driver/results/columns.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::bench {
namespace {

using std::numbers::pi;

double value(const cases::Case& problem, const Row& row, const std::string& name) {
  const auto column = results::find_column(problem, results::result_columns(problem), name);
  INFO(name);
  REQUIRE(column);
  return results::column_value(*column, problem, row);
}

std::string belt(const std::string& connector, const std::string& history,
                 const std::string& coefficient = "0.2") {
  return "slipbench: 1\nconnector: {type: SLIPRING, " + connector +
         "}\nfriction:\n  - {predefined: {}, coefficient: " + coefficient +
         ", stick: {elastic_slip: 0.01}}\nhistory:\n" + history;
}

const std::string kNodes = "nodes: {a: [-3, 0, 0], b: [0, 0, 0], c: [0, 2, 0]}";

std::vector<std::string> names(const cases::Case& problem) {
  std::vector<std::string> all;
  for (const results::Column& column : results::result_columns(problem)) all.push_back(column.name);
  return all;
}

bool has(const std::vector<std::string>& all, const std::string& name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

TEST_CASE("a belt has the columns of what is known of it, each once") {
  const std::string pull = "  - {step: s, increments: 2, force: {f1: 9}, motion: {CP2: {to: 1}}}\n";
  const auto plain = names(read::sound(belt("wrap_angle: 2", pull)));
  for (const char* name : {"CP2", "CP3", "CSF2", "CNF2", "CASU2", "f_bc", "CTF1", "CSF2_MAX"}) {
    INFO(name);
    CHECK(has(plain, name));
  }
  // Without the distance of the nodes there is neither strain nor reference length.
  for (const char* name : {"CP1", "CU1", "reference_length", "wrap_angle", "UTILISATION", "CSF1"}) {
    INFO(name);
    CHECK_FALSE(has(plain, name));
  }
  const auto length = names(read::sound(belt("wrap_angle: 2, initial: {CP1: 4}", pull)));
  for (const char* name : {"CP1", "CU1", "reference_length"}) CHECK(has(length, name));
  CHECK_FALSE(has(length, "wrap_angle"));
  const auto moving =
      names(read::sound(belt(kNodes,
                             "  - {step: s, increments: 2, force: {f1: 9}, nodes: {c: [{to: 1}, 2, "
                             "0]}}\n")));
  CHECK(has(moving, "wrap_angle"));
  auto chain = names(read::sound(belt("wrap_angle: [1, 2]", pull)));
  for (const char* name : {"CSF2", "CSF2.ring1", "f_bc", "f_bc.ring1", "CNF2.ring2", "STATUS.ring2",
                           "CASU2.ring1", "CSF2_MIN.ring2"}) {
    INFO(name);
    CHECK(has(chain, name));
  }
  std::sort(chain.begin(), chain.end());
  CHECK(std::adjacent_find(chain.begin(), chain.end()) == chain.end());
}

TEST_CASE("distance, strain and wrap angle follow from nodes that move") {
  const cases::Case problem = read::sound(
      belt(kNodes + ", initial_strain: 0.5",
           "  - {step: s, increments: 4, force: {f1: 10}, motion: {CP2: {to: 1}, CP3: {to: 0.5}},"
           " nodes: {a: [{to: -4}, 0, 0], c: [{to: 2}, {to: 0}, 0]}}\n"));
  const std::vector<Row> rows = rows_of(problem);
  CHECK(value(problem, rows[0], "CP1") == 3.0);
  CHECK(value(problem, rows[0], "reference_length") == 2.0);
  CHECK(value(problem, rows[0], "CU1") == 0.5);
  CHECK(value(problem, rows[0], "wrap_angle") == Approx(pi / 2).epsilon(1e-15));
  const Row& middle = rows[2];
  CHECK(value(problem, middle, "CP1") == 3.5);
  CHECK(value(problem, middle, "CV1") == 1.0);
  CHECK(value(problem, middle, "reference_length") == 1.75);
  CHECK(value(problem, middle, "CU1") == 1.0);
  CHECK(value(problem, middle, "wrap_angle") == Approx(pi / 4).epsilon(1e-15));
  CHECK(value(problem, middle, "f_bc") == Approx(10.0 * std::exp(0.05 * pi)).epsilon(1e-14));
  CHECK(value(problem, rows[4], "wrap_angle") == 0.0);
  CHECK(value(problem, rows[4], "f_bc") == 10.0);
  CHECK(value(problem, rows[4], "STATUS") == 0.0);
}

TEST_CASE("the tension a ring leaves is the one the next meets, increment by increment") {
  const cases::Case problem = read::sound(
      belt("wrap_angle: [1, 0.5, 2]",
           "  - {step: s, increments: 7, force: {f1: 10}, motion: {CP2: {to: 0.02}}}\n"
           "  - {step: r, increments: 9, force: {f1: {to: 25}}, motion: {CP2: {to: -0.02}}}\n"));
  for (const Row& row : rows_of(problem)) {
    CHECK(value(problem, row, "CNF2.ring1") == value(problem, row, "CTF1"));
    CHECK(value(problem, row, "CNF2.ring2") == value(problem, row, "f_bc.ring1"));
    CHECK(value(problem, row, "CNF2.ring3") == value(problem, row, "f_bc.ring2"));
    CHECK(value(problem, row, "f_bc") == value(problem, row, "f_bc.ring3"));
    CHECK(value(problem, row, "CSF2") ==
          Approx(value(problem, row, "f_bc") - value(problem, row, "CTF1")).margin(1e-14));
    for (const char* ring : {".ring1", ".ring2", ".ring3"}) {
      const double force = value(problem, row, std::string("CSF2") + ring);
      CHECK(force <= value(problem, row, std::string("CSF2_MAX") + ring) * (1.0 + 1e-14));
      CHECK(force >= value(problem, row, std::string("CSF2_MIN") + ring) * (1.0 + 1e-14));
    }
  }
}

TEST_CASE("a belt's run cut anywhere and resumed gives the same rows") {
  for (const char* connector : {"wrap_angle: [1, 0.5], initial: {CP1: 3}", kNodes.c_str()}) {
    const bool nodes = connector == kNodes;
    const std::string move = nodes ? ", nodes: {c: [{sine: {amplitude: 1, period: 0.7}}, 2, 0]}"
                                   : ", motion: {CP1: {to: 4}}";
    const cases::Case problem = read::sound(belt(
        connector,
        "  - {step: s, increments: 9, force: {f1: {to: 20}}" + move +
            "}\n"
            "  - {step: r, increments: 9, force: {f1: {to: 5}}, motion: {CP2: {to: 0.2}, CP3: {to: "
            "0.1}}}\n"));
    const std::vector<Row> whole = rows_of(problem);
    const auto columns = results::result_columns(problem);
    for (std::size_t cut = 0; cut < whole.size(); ++cut) {
      auto first = Simulation::start(problem);
      REQUIRE(first);
      for (std::size_t i = 0; i < cut; ++i) REQUIRE(first->advance().value());
      auto second = Simulation::resume(problem, first->state());
      REQUIRE(second);
      for (std::size_t i = cut + 1; i < whole.size(); ++i) {
        REQUIRE(second->advance().value());
        for (const results::Column& column : columns) {
          INFO(column.name << " in row " << i << " after a cut at " << cut);
          CHECK(results::column_value(column, problem, second->row()) ==
                results::column_value(column, problem, whole[i]));
        }
      }
    }
  }
}

TEST_CASE("both tensions judge the belt without a flow") {
  const cases::Case problem = read::sound(
      belt("wrap_angle: = pi",
           "  - {step: s, increments: 3, force: {f1: 10, f_bc: {columns: [value, t], rows: "
           "[[10, 0], [40, 1]]}}}\n"));
  const std::vector<Row> rows = rows_of(problem);
  const std::vector<double> status = {1.0, 2.0, 2.0, 2.0};  // the limit is 18.7
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double behind = 10.0 + 10.0 * static_cast<double>(i);
    CHECK(value(problem, rows[i], "f_bc") == Approx(behind).epsilon(1e-15));
    CHECK(value(problem, rows[i], "STATUS") == status[i]);
    CHECK(value(problem, rows[i], "UTILISATION") ==
          Approx(std::log(behind / 10.0) / (0.2 * pi)).epsilon(1e-14));
    CHECK(value(problem, rows[i], "CASU2") == 0.0);
  }
}

std::string failure_of(const std::string& text) {
  const cases::Case problem = read::sound(text);
  auto simulation = Simulation::start(problem);
  while (simulation) {
    const auto more = simulation->advance();
    if (!more) {
      CHECK(more.error().kind == SimulationFailure::Kind::kInput);
      return more.error().message;
    }
    if (!*more) return "";
  }
  return simulation.error().message;
}

TEST_CASE("a belt that cannot be there ends the run with its place and reason") {
  const std::string ring = "wrap_angle: 2, initial: {CP1: 1}";
  CHECK_THAT(failure_of(belt(ring,
                             "  - {step: s, increments: 4, force: {f1: 9}, motion: {CP2: "
                             "{to: 2}}}\n")),
             Catch::StartsWith("step 's', t = 0.5 (total time 0.5): no material is left") &&
                 Catch::Contains("reference length is 0"));
  CHECK_THAT(failure_of(belt(ring,
                             "  - {step: s, increments: 4, force: {f1: 9}, motion: {CP1: "
                             "{to: -1}}}\n")),
             Catch::Contains("the distance CP1 of the nodes is 0"));
  CHECK_THAT(failure_of(belt(kNodes,
                             "  - {step: s, increments: 4, force: {f1: 9}, nodes: {c: [0, "
                             "{to: 0}, 0]}}\n")),
             Catch::Contains("t = 1 (total time 1): node c lies on node b"));
  CHECK_THAT(failure_of(belt("wrap_angle: 2",
                             "  - {step: s, increments: 4, force: {f1: 9, f_bc: "
                             "{to: -4}}}\n")),
             Catch::Contains("the tension f_bc is -1: a belt pulls"));
}

TEST_CASE("a measured history drives tension and flow of a belt") {
  TemporaryFolder folder;
  folder.write("rig.csv", "time,load,flow\n0,10,0\n1,10,1\n2,20,0\n");
  const cases::Case problem = read::sound(
      "slipbench: 1\nconnector: {type: SLIPRING, wrap_angle: = pi}\nfriction:\n"
      "  - {predefined: {}, coefficient: 0.2, stick: {elastic_slip: 0.01}}\n"
      "history: {csv: rig.csv, time: time, columns: {f1: load, CP2: flow}}\n",
      {}, folder.path().string());
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 3);
  CHECK(value(problem, rows[1], "f_bc") == Approx(10.0 * std::exp(0.2 * pi)).epsilon(1e-14));
  CHECK(value(problem, rows[2], "f_bc") == Approx(20.0 * std::exp(-0.2 * pi)).epsilon(1e-14));
}

TEST_CASE("an angle in degrees, and a belt without tension, are warned of") {
  const std::string pull = "  - {step: s, increments: 2, force: {f1: 9}, motion: {CP2: {to: 1}}}\n";
  const auto degrees = read::messages(belt("wrap_angle: [1, 90]", pull));
  REQUIRE(degrees.size() == 1);
  CHECK_THAT(degrees[0], Catch::Contains("2:45: warning: connector.wrap_angle[1]: 90 rad is more "
                                         "than two turns of the belt (radians?)"));
  CHECK(read::messages(belt("wrap_angle: = 4*pi", pull)).empty());
  const auto slack = read::messages(
      belt("wrap_angle: 2", "  - {step: s, increments: 2, motion: {CP2: {to: 1}}}\n"));
  REQUIRE(slack.size() == 1);
  CHECK_THAT(slack[0], Catch::Contains("warning: history: the belt has no tension"));
}

TEST_CASE("a node may stay where an earlier step has put it, and nowhere else") {
  const std::string first =
      "  - {step: s, increments: 2, force: {f1: 9}, nodes: {c: [{to: 5}, 2, 0]}}\n";
  CHECK(read::messages(
            belt(kNodes, first + "  - {step: r, increments: 2, nodes: {c: [5, {to: 3}, 0]}}\n"))
            .empty());
  const auto wrong = read::messages(
      belt(kNodes, first + "  - {step: r, increments: 2, nodes: {c: [0, {to: 3}, 0]}}\n"));
  REQUIRE(wrong.size() == 1);
  CHECK_THAT(wrong[0],
             Catch::Contains("history[1].nodes.c[0]: a number is a coordinate that stays, "
                             "and node c is at 5 there"));
  // Whatever steps lie in between; behind a table the text does not tell where it is.
  const std::string table = "{columns: [y, t], rows: [[2, 0], [4, 1]]}";
  const auto later = read::messages(
      belt(kNodes, first + "  - {step: q, increments: 2, nodes: {c: [{smooth_to: 6}, " + table +
                       ", 0]}}\n  - {step: p, increments: 2}\n"
                       "  - {step: r, increments: 2, nodes: {a: [-3, 0, 1], c: [5, 9, 0]}}\n"));
  REQUIRE(later.size() == 2);
  CHECK_THAT(later[0],
             Catch::Contains("history[3].nodes.a[2]: a number is a coordinate that stays, "
                             "and node a is at 0 there"));
  CHECK_THAT(later[1],
             Catch::Contains("history[3].nodes.c[0]: a number is a coordinate that stays, "
                             "and node c is at 6 there"));
}

}  // namespace
}  // namespace slipbench::driver::bench
