// SPDX-License-Identifier: Apache-2.0
// The note on a mass and its spring.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/base/text/one_line.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::read {
namespace {

/// Returns what reading says of a mass on a spring.
std::vector<std::string> told(const std::string& units, const std::string& mass,
                              base::Severity severity, const std::string& type = "SLOT",
                              int component = 1, int increments = 1000) {
  const std::string c = std::to_string(component);
  const std::string text =
      "slipbench: 1\ntitle: t\n" + units + "connector: {type: " + type +
      "}\nfriction:\n  - {component: " + c +
      ", internal_contact_force: 1, coefficient: 0.1}\nelasticity: [{component: " + c +
      ", stiffness: 100}]\n"
      "dynamics: {component: " +
      c + ", mass: " + mass +
      ", initial_velocity: 1}\n"
      "history:\n  - {step: run, increments: " +
      std::to_string(increments) + "}\n";
  const ReadCase read = read_case_text(base::SourceText("c.yaml", text), ".");
  INFO(base::render(read.diagnostics));
  REQUIRE(read.value);
  return base::lines_of(read.diagnostics, severity);
}

using Lines = std::vector<std::string>;

TEST_CASE("a mass on its spring is told with its unit and its natural frequency") {
  CHECK(told("units: {length: mm, force: N, time: s}\n", "0.0003", base::Severity::kNote) ==
        Lines{"dynamics.mass: 0.0003 t (0.3 kg; N s^2/mm is t) on the spring of 100 N/mm swings at "
              "91.89 Hz (period 0.01088 s)"});
  CHECK(told("units: {length: m, force: N, time: s}\n", "0.3", base::Severity::kNote) ==
        Lines{"dynamics.mass: 0.3 kg (N s^2/m is kg) on the spring of 100 N/m swings at 2.906 Hz "
              "(period 0.3441 s)"});
  CHECK(told("units: {length: mm, force: kN, time: ms}\n", "400", base::Severity::kNote) ==
        Lines{"dynamics.mass: 400 kg (kN ms^2/mm is kg) on the spring of 100 kN/mm swings at "
              "0.07958 kHz (period 12.57 ms)"});
  CHECK(told("units: {length: in, force: lbf, time: s}\n", "0.02", base::Severity::kNote) ==
        Lines{"dynamics.mass: 0.02 slinch (lbf s^2/in is slinch) on the spring of 100 lbf/in "
              "swings at 11.25 Hz (period 0.08886 s)"});
}

TEST_CASE("a mass on a driver swings with it, as the reduced mass of both") {
  CHECK(told("units: {length: m, force: N, time: s}\n", "0.6, driver: {mass: 0.4}",
             base::Severity::kNote) ==
        Lines{"dynamics.mass: with its driver as one mass of 0.24 kg (N s^2/m is kg) on the spring "
              "of 100 N/m swings at 3.249 Hz (period 0.3078 s)"});
}

TEST_CASE("of units that have no name, or that the case does not state, nothing is made up") {
  CHECK(told("", "0.3", base::Severity::kNote) ==
        Lines{"dynamics.mass: 0.3 on the spring of 100 swings at 2.906 a unit of time (period "
              "0.3441)"});
  CHECK(told("units: {length: cm, force: N, time: s}\n", "1", base::Severity::kNote) ==
        Lines{"dynamics.mass: 1 N s^2/cm on the spring of 100 N/cm swings at 1.592 Hz (period "
              "0.6283 s)"});
  CHECK(
      told("units: {length: mm, force: N, time: s}\n", "0.04", base::Severity::kNote, "HINGE", 4) ==
      Lines{"dynamics.mass: 0.04 t mm^2 (N mm s^2 is t mm^2) on the spring of 100 N mm swings at "
            "7.958 Hz (period 0.1257 s)"});
}

TEST_CASE("increments that do not show how the mass swings are warned of") {
  const std::string units = "units: {length: mm, force: N, time: s}\n";
  CHECK(told(units, "0.00000003", base::Severity::kWarning) ==
        Lines{"dynamics.mass: the mass swings with a period of 0.0001088 s, and no increment is "
              "shorter than 0.001 s: fewer than 10 rows a period do not show it; look at the unit "
              "of the mass, or take increments of 1.088e-05 s or less"});
  CHECK(told(units, "0.00000003", base::Severity::kWarning, "SLOT", 1, 100000).empty());
}

}  // namespace
}  // namespace slipbench::driver::read
