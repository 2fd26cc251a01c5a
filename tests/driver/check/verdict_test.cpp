// SPDX-License-Identifier: Apache-2.0
#include "driver/check/verdict.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>

namespace slipbench::driver::check {
namespace {

Measure measure(const std::string& name, double deviation, double tolerance, MeasureUnit unit) {
  return {.name = name,
          .unit = unit,
          .value = 10.0 + deviation,
          .reference = 10.0,
          .deviation = deviation,
          .scale = 10.0,
          .tolerance = tolerance,
          .where = {}};
}

TEST_CASE("the worst measure is the one nearest to its tolerance, not one that is only reported") {
  Verdict verdict;
  verdict.unit = "N";
  verdict.abscissa_unit = "metre";
  verdict.product_unit = "mJ";
  verdict.measures = {
      measure("force", 1.0, 2.0, MeasureUnit::kQuantity),
      measure("position", 0.9, 1.0, MeasureUnit::kAbscissa),
      measure("mean", 5.0, std::numeric_limits<double>::infinity(), MeasureUnit::kNone)};
  REQUIRE(worst_measure(verdict) != nullptr);
  CHECK(worst_measure(verdict)->name == "position");
  CHECK(unit_of(verdict.measures[0], verdict) == "N");
  CHECK(unit_of(verdict.measures[1], verdict) == "metre");
  CHECK(unit_of(verdict.measures[2], verdict).empty());
  verdict.tolerance = 1.0;
  CHECK(verdict.worst_deviation() == 0.9);
  CHECK(verdict.worst_fraction() == Approx(0.9));

  verdict.measures = {verdict.measures[2]};
  CHECK(worst_measure(verdict) == nullptr);
  CHECK(verdict.worst_deviation() == 0.0);
}

TEST_CASE("JSON has all of a verdict, and null for what is not finite or not there") {
  Verdict verdict;
  verdict.name = "loop";
  verdict.criterion = cases::Criterion::kLoopEnergy;
  verdict.message = "wrong";
  verdict.warnings = {"doubtful"};
  verdict.product_unit = "mJ";
  verdict.measures = {measure("energy of loop 1", 3.0, 1.5, MeasureUnit::kProduct)};
  verdict.measures[0].where = CurvePoint{0.1, 13.0, 10.0};
  verdict.tolerance = 1.5;
  verdict.worst.time = std::numeric_limits<double>::quiet_NaN();
  const std::string text = to_json(verdict).dump();
  CHECK(text ==
        R"({"name": "loop", "criterion": "loop_energy", "passed": false, "message": "wrong", )"
        R"("likely_cause": "", "warnings": ["doubtful"], "compared": 0, "failing": 0, "unit": "", )"
        R"("abscissa": "", "tolerance": 1.5, "scale": 0, "worst_deviation": 3, )"
        R"("worst_fraction": 2, "worst_time": null, "worst_abscissa": 0, "worst_value": 0, )"
        R"("worst_reference": 0, "first_failing": null, "last_failing": null, "measures": )"
        R"([{"name": "energy of loop 1", "unit": "mJ", "value": 13, "reference": 10, )"
        R"("deviation": 3, "tolerance": 1.5, "scale": 10, "passed": false, "where": )"
        R"({"time": null, "abscissa": 0.1, "value": 13, "reference": 10}}]})");
}

}  // namespace
}  // namespace slipbench::driver::check
