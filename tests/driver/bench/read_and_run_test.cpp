// SPDX-License-Identifier: Apache-2.0
// What a case file says must be what is run: read from text, run, looked at through the columns.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "driver/read/read_case.hpp"
#include "driver/results/columns.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::bench {
namespace {

cases::Case read(const std::string& text, const std::filesystem::path& folder = ".") {
  read::ReadCase result =
      read::read_case_text(base::SourceText("case.yaml", text), folder.string(), {});
  INFO(base::render(result.diagnostics, result.sources));
  REQUIRE(result.value.has_value());
  return std::move(*result.value);
}

double value(const cases::Case& problem, const Row& row, const std::string& name) {
  const auto column = results::find_column(problem, results::result_columns(problem), name);
  REQUIRE(column);
  return results::column_value(*column, problem, row);
}

/// A press fit that wears by 50 N per mm, pushed by 0.1 mm in one increment.
std::string wear(const std::string& integration) {
  return "slipbench: 1\n"
         "connector: {type: SLOT}\n"
         "friction:\n"
         "  - component: 1\n"
         "    internal_contact_force: {columns: [force, accumulated_slip], rows: [[100, 0], [0, "
         "2]]}\n"
         "    coefficient: 0.2\n"
         "    stick: {stiffness: 1000}\n" +
         integration +
         "history:\n"
         "  - {step: push, increments: 1, motion: {CP1: {to: 0.1}}}\n";
}

double force_of(const std::string& text) {
  const cases::Case problem = read(text);
  return value(problem, rows_of(problem).back(), "CSF1");
}

TEST_CASE("the wear's timing in the file decides the force") {
  // From the slip of the start, nothing is worn yet: 0.2 * 100. From that of the end, with
  // b = 0.2 * 50 / 1000: 0.2 (100 - 50 * 0.1) / (1 - b). One increment: rounding, and the root's
  // last digits times the stiffness.
  CHECK(force_of(wear("integration: {accumulated_slip: start}\n")) == Approx(20.0).epsilon(1e-13));
  CHECK(force_of(wear("integration: {accumulated_slip: end}\n")) ==
        Approx(19.0 / 0.99).epsilon(1e-12));
  CHECK(force_of(wear("")) == Approx(19.0 / 0.99).epsilon(1e-12));
}

std::string placed(const std::string& positions, const std::string& history) {
  return "slipbench: 1\n"
         "connector: {type: SLIDE-PLANE" +
         positions +
         "}\n"
         "friction:\n"
         "  - {predefined: {internal_contact_force: 10}, coefficient: 0.2, stick: {elastic_slip: "
         "0.01}}\n"
         "history:\n" +
         history;
}

const std::string kGo = "  - {step: go, increments: 2, motion: {CP2: {to: 0.75}}}\n";

// All numbers below are sums of powers of two: the columns are exact.

TEST_CASE("the constitutive reference is the initial position unless the file says otherwise") {
  const cases::Case problem = read(placed(", initial: {CP2: 0.5, CP3: -2}", kGo));
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 3);
  CHECK(value(problem, rows[0], "CP2") == 0.5);
  CHECK(value(problem, rows[0], "CU2") == 0.0);
  CHECK(value(problem, rows[0], "CCU2") == 0.0);
  CHECK(value(problem, rows[0], "CCU3") == 0.0);
  CHECK(value(problem, rows[2], "CU2") == 0.25);
  CHECK(value(problem, rows[2], "CCU2") == 0.25);
  CHECK(value(problem, rows[2], "CCU3") == 0.0);
}

TEST_CASE("a reference given for one component leaves that of the others at the initial position") {
  const cases::Case problem =
      read(placed(", initial: {CP2: 0.5, CP3: -2}, reference: {CP3: -1.5}", kGo));
  const Row first = rows_of(problem).front();
  CHECK(value(problem, first, "CCU2") == 0.0);
  CHECK(value(problem, first, "CCU3") == -0.5);
  CHECK(value(problem, first, "CU3") == 0.0);
}

TEST_CASE("a measured history starts at its first row: no displacement, no force there") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,u,v\n2,0.5,-2\n3,0.75,-2\n");
  const std::string history = "  {csv: rig.csv, time: t, columns: {CP2: u, CP3: v}}\n";
  const cases::Case problem = read(placed("", history), folder.path());
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 2);
  for (const char* name : {"CU2", "CU3", "CCU2", "CCU3", "CSF2", "CSF3", "CASUC", "CV2", "CV3"}) {
    INFO(name);
    CHECK(value(problem, rows[0], name) == 0.0);
  }
  CHECK(value(problem, rows[0], "CP2") == 0.5);
  CHECK(value(problem, rows[0], "CP3") == -2.0);
  CHECK(value(problem, rows[1], "CU2") == 0.25);
  CHECK(value(problem, rows[1], "CCU2") == 0.25);
  CHECK(value(problem, rows[1], "CCU3") == 0.0);
  CHECK(value(problem, rows[1], "CV2") == 0.25);
}

TEST_CASE("positions of the file go before those of the first measured row") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,u,v\n2,0.5,-2\n3,0.75,-2\n");
  const std::string history = "  {csv: rig.csv, time: t, columns: {CP2: u, CP3: v}}\n";
  const cases::Case problem =
      read(placed(", initial: {CP2: 0.25}, reference: {CP3: -1.5}", history), folder.path());
  const Row first = rows_of(problem).front();
  CHECK(value(problem, first, "CU2") == 0.25);
  CHECK(value(problem, first, "CCU2") == 0.25);
  CHECK(value(problem, first, "CU3") == 0.0);
  CHECK(value(problem, first, "CCU3") == -0.5);
}

}  // namespace
}  // namespace slipbench::driver::bench
