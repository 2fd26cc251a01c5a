// SPDX-License-Identifier: Apache-2.0
// One switch for the tables of a connector's behaviour.
#include <catch2/catch.hpp>
#include <string>
#include <variant>

#include "driver/read/read_case.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

std::string fitted(const std::string& extrapolation, const std::string& own) {
  return "slipbench: 1\nconnector: {type: SLOT}\n" + extrapolation +
         "friction:\n  - {component: 1, internal_contact_force: {columns: [F, CP1], rows: [[10, "
         "0], [20, 1]]" +
         own +
         "}, coefficient: {columns: [mu, slip_rate], rows: [[0.1, 0], [0.2, 1]]}, stick: "
         "{elastic_slip: "
         "0.1}}\nhistory:\n  - {step: go, increments: 2, motion: {CP1: {to: 1}}}\n";
}

law::Extrapolation of_force(const cases::Case& problem) {
  return std::get<law::TableFunction>(problem.definitions.at(0).law.internal_contact_force)
      .table()
      .extrapolation();
}

TEST_CASE("tables of the behaviour follow the case's extrapolation, unless they have their own") {
  using law::Extrapolation;
  CHECK(of_force(sound(fitted("", ""))) == Extrapolation::kConstant);
  const cases::Case problem = sound(fitted("extrapolation: linear\n", ""));
  CHECK(of_force(problem) == Extrapolation::kLinear);
  CHECK(std::get<law::TabularCoefficient>(problem.definitions[0].law.law)
            .table.table()
            .extrapolation() == Extrapolation::kConstant);
  CHECK(of_force(sound(fitted("extrapolation: linear\n", ", extrapolate: constant"))) ==
        Extrapolation::kConstant);
  CHECK(of_force(sound(fitted("extrapolation: constant\n", ", extrapolate: linear"))) ==
        Extrapolation::kLinear);
}

TEST_CASE("an extrapolation that there is none of is refused with those there are") {
  const auto found = messages(fitted("extrapolation: spline\n", ""));
  REQUIRE(found.size() == 1);
  CHECK(found[0] == "3:16: error: extrapolation: wanted constant or linear, found 'spline'");
}

}  // namespace
}  // namespace slipbench::driver::read
