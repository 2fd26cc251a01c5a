// SPDX-License-Identifier: Apache-2.0
// Numbers of radians that look like degrees.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/base/text/one_line.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::read {
namespace {

using Lines = std::vector<std::string>;

/// Returns what reading says of a shaft in a sleeve whose history has this step.
Lines told(const std::string& motion, const std::string& initial = "",
           const std::string& force = "f2: 10") {
  const std::string text =
      "slipbench: 1\ntitle: t\nconnector: {type: CYLINDRICAL" + initial +
      "}\nfriction:\n  - {component: 4, contact_force: 2, coefficient: 0.1, stick: {elastic_slip: "
      "0.01}}\nhistory:\n  - {step: a, increments: 10, motion: {" +
      motion + "}, force: {" + force + "}}\n";
  const ReadCase read = read_case_text(base::SourceText("c.yaml", text), ".");
  INFO(base::render(read.diagnostics));
  REQUIRE(read.value);
  return base::lines_of(read.diagnostics, base::Severity::kWarning);
}

TEST_CASE("an angle that looks like degrees is told in turns, with both ways to mean it") {
  CHECK(told("CPR1: {sine: {amplitude: 30, period: 1}}") ==
        Lines{"history[0].motion.CPR1.sine.amplitude: 30 rad is 4.8 turns; if degrees are meant "
              "write '= 30*pi/180', if radians '= 30'"});
  CHECK(told("CPR1: {to: 90}") ==
        Lines{"history[0].motion.CPR1.to: 90 rad is 14 turns; if degrees are meant write '= "
              "90*pi/180', if radians '= 90'"});
  CHECK(told("CPR1: {columns: [angle, t], rows: [[0, 0], [45, 0.5], [90, 1]]}") ==
        Lines{"history[0].motion.CPR1.rows[1][0]: 45 rad is 7.2 turns; if degrees are meant write "
              "'= 45*pi/180', if radians '= 45'"});
  CHECK(told("CPR1: {to: 1}", ", initial: {CPR1: 45}") ==
        Lines{"connector.initial.CPR1: 45 rad is 7.2 turns; if degrees are meant write '= "
              "45*pi/180', if radians '= 45'"});
}

TEST_CASE("a phase is an angle whatever it belongs to") {
  CHECK(told("CP1: {sine: {amplitude: 30, period: 1, phase: 90}}") ==
        Lines{"history[0].motion.CP1.sine.phase: 90 rad is 14 turns; if degrees are meant write '= "
              "90*pi/180', if radians '= 90'"});
  CHECK(told("CP1: {to: 1}", "", "f2: {sine: {amplitude: 5, period: 1, phase: 7}}") ==
        Lines{"history[0].force.f2.sine.phase: 7 rad is 1.1 turns; if degrees are meant write '= "
              "7*pi/180', if radians '= 7'"});
}

TEST_CASE("what is meant in radians, or is no angle, is not doubted") {
  CHECK(told("CPR1: {sine: {amplitude: 3, period: 1, phase: 1.57}}").empty());
  CHECK(told("CPR1: {to: 6.283185307179586}").empty());
  // A shaft that turns often.
  CHECK(told("CPR1: {to: 100}").empty());
  CHECK(told("CPR1: {to: 3600}").empty());
  CHECK(told("CP1: {to: 90}").empty());
  CHECK(told("CP1: {sine: {amplitude: 30, period: 1}}").empty());
  // As the warnings advise.
  CHECK(told("CPR1: {to: = 90}").empty());
  CHECK(told("CPR1: {to: = 90*pi/180}").empty());
}

}  // namespace
}  // namespace slipbench::driver::read
