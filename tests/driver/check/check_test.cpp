// SPDX-License-Identifier: Apache-2.0
#include "driver/check/check.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::check {
namespace {

base::Expression compiled(const std::string& text, const std::vector<std::string>& variables) {
  auto expression = base::Expression::compile(text, variables);
  REQUIRE(expression);
  return std::move(*expression);
}

/// A check of `quantity` against a formula, both over `variables`.
cases::Check formula_check(const std::string& quantity, const std::string& formula,
                           std::vector<std::string> variables, cases::Tolerance tolerance) {
  return {.name = "test",
          .quantity = compiled(quantity, variables),
          .quantity_text = quantity,
          .variables = variables,
          .against = cases::ExpressionReference{compiled(formula, variables), variables},
          .step = {},
          .from = {},
          .to = {},
          .tolerance = std::move(tolerance),
          .where = {}};
}

/// The slider of 20 N and 1000 N/mm, driven by `motion`.
cases::ClosedFormReference slider_reference(const std::string& motion,
                                            const std::vector<std::string>& variables) {
  return {"coulomb_slider",
          {{0.2}, {100.0}, {1000.0}, {1e300}},
          {cases::ExpressionReference{compiled(motion, variables), variables}},
          0};
}

Verdict verdict_of(const cases::Case& problem, const cases::Check& check) {
  CheckProgress progress(problem, check);
  for (const bench::Row& row : bench::rows_of(problem)) progress.add(row);
  return progress.verdict();
}

/// CP1 = T in ten increments, two steps of 1 s.
cases::Case ramp() {
  return bench::slider_case({bench::step("one", 10, 0, history::LinearTo{1.0}),
                             bench::step("two", 10, 0, history::LinearTo{2.0})});
}

TEST_CASE("a quantity within its tolerance passes, and the worst deviation is told") {
  const Verdict verdict =
      verdict_of(ramp(), formula_check("CP1", "T + 0.01*T", {"CP1", "T"}, {0.04, {}, ""}));
  CHECK(verdict.passed);
  CHECK(verdict.message.empty());
  CHECK(verdict.compared == 21);
  CHECK(verdict.worst.time == 2.0);
  CHECK(verdict.worst_fraction() == Approx(0.5));
}

TEST_CASE("a failure names the worst, the first and the last point and their number") {
  const Verdict verdict = verdict_of(
      ramp(),
      formula_check("CP1", "T + (T > 0.45 && T < 0.85 ? 0.5*T : 0)", {"CP1", "T"}, {0.1, {}, ""}));
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.failing == 4);
  CHECK(verdict.message ==
        "CP1 off by 0.4 mm (limit 0.1) at t = 0.8, first at 0.5, last at 0.8, 4 of 21 points");
}

TEST_CASE("a relative tolerance is relative to the range of the reference") {
  // The reference runs from 10 to 12: 1 % of the range is 0.02, not 0.12.
  const auto check = [&](double relative) {
    return verdict_of(ramp(),
                      formula_check("10 + CP1", "10.03 + T", {"CP1", "T"}, {{}, relative, ""}));
  };
  CHECK_FALSE(check(0.01).passed);
  CHECK(check(0.01).tolerance == Approx(0.02));
  CHECK(check(0.02).passed);
}

TEST_CASE("a relative tolerance to a constant reference is relative to its magnitude") {
  const auto check = [&](const std::string& formula) {
    return verdict_of(ramp(), formula_check("100 + 0*CP1", formula, {"CP1", "T"}, {{}, 1e-3, ""}));
  };
  CHECK(check("100.05 + 0*T").passed);
  CHECK(check("100.05 + 0*T").tolerance == Approx(0.10005));
  CHECK_FALSE(check("100.2 + 1e-10*T").passed);
}

TEST_CASE("many deviating rows are counted although only the suspicious ones are remembered") {
  // The deviation falls while the range of the reference grows: early rows fail for good only
  // where they exceed the final tolerance of 0.05 * 2.
  const cases::Case problem =
      bench::slider_case({bench::step("one", 20000, 0, history::LinearTo{2.0}, 2.0)});
  const Verdict verdict =
      verdict_of(problem, formula_check("CP1", "T + 0.2 - 0.1*T", {"CP1", "T"}, {{}, 0.05, ""}));
  CHECK_FALSE(verdict.passed);
  // Range: from 0.2 to 2.0, so the tolerance is 0.09; exceeded for T < 1.1, that is in row 0 to
  // 10999 (row 11000 is a tie that rounding decides).
  CHECK(verdict.tolerance == Approx(0.09));
  CHECK(verdict.failing >= 11000);
  CHECK(verdict.failing <= 11001);
  CHECK(verdict.first_failing.value() == 0.0);
}

TEST_CASE("a step and a span of time select the rows; t is the time in the step") {
  cases::Check check = formula_check("CP1", "1 + t", {"CP1", "t"}, {1e-12, {}, ""});
  check.step = "two";
  CHECK(verdict_of(ramp(), check).compared == 10);
  CHECK(verdict_of(ramp(), check).passed);
  check.from = 1.45;
  check.to = 1.75;
  CHECK(verdict_of(ramp(), check).compared == 3);
}

TEST_CASE("row 0 belongs to the first step") {
  cases::Check check = formula_check("CP1", "t", {"CP1", "t"}, {1e-12, {}, ""});
  check.step = "one";
  CHECK(verdict_of(ramp(), check).compared == 11);
}

TEST_CASE("a check that compares nothing fails") {
  cases::Check check = formula_check("CP1", "T", {"CP1", "T"}, {1.0, {}, ""});
  check.from = 3.0;
  CHECK(verdict_of(ramp(), check).message == "no row was compared");
  CHECK_FALSE(verdict_of(ramp(), check).passed);
}

TEST_CASE("a column that does not exist fails") {
  const Verdict verdict =
      verdict_of(ramp(), formula_check("CPR1", "T", {"CPR1", "T"}, {1.0, {}, ""}));
  CHECK(verdict.message == "there is no result column 'CPR1'");
  CHECK_FALSE(verdict.passed);
}

TEST_CASE("a reference without value fails, however large the tolerance") {
  const Verdict verdict =
      verdict_of(ramp(), formula_check("CP1", "1/T", {"CP1", "T"}, {1e9, {}, ""}));
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.failing == 1);
  CHECK(verdict.message.find("the reference has no value: ") == 0);
  CHECK(verdict.message.find("at t = 0") != std::string::npos);
}

TEST_CASE("a closed form follows the whole path, also where only a part is compared") {
  const cases::Case problem =
      bench::slider_case({bench::step("out", 10, 0, history::LinearTo{0.1}),
                          bench::step("back", 10, 0, history::LinearTo{-0.1})});
  cases::Check check = formula_check("CSF1", "T", {"CSF1", "T"}, {{}, 1e-12, ""});
  check.against = slider_reference("CU1", {"CU1"});
  check.step = "back";
  const Verdict verdict = verdict_of(problem, check);
  INFO(verdict.message);
  CHECK(verdict.passed);
  CHECK(verdict.compared == 10);
  CHECK(verdict.scale == Approx(40.0).margin(25.0));
}

TEST_CASE("a closed form is driven by expressions over times and columns") {
  const cases::Case problem =
      bench::slider_case({bench::step("out", 10, 0, history::LinearTo{0.1}),
                          bench::step("back", 10, 0, history::LinearTo{-0.1})});
  cases::Check check = formula_check("CSF1", "T", {"CSF1", "T"}, {{}, 1e-12, ""});
  // The motion again, from the times alone and with a column.
  check.against = slider_reference("T <= 1 ? 0.1*T : 0.1 - 0.2*t", {"T", "t"});
  CHECK(verdict_of(problem, check).passed);
  check.against = slider_reference("CU1 + 0*T", {"CU1", "T"});
  CHECK(verdict_of(problem, check).passed);
  check.against = slider_reference("0.99*CU1", {"CU1"});
  CHECK_FALSE(verdict_of(problem, check).passed);
}

TEST_CASE(
    "an input without a value breaks the path of a closed form, also where nothing compares") {
  const cases::Case problem =
      bench::slider_case({bench::step("out", 10, 0, history::LinearTo{0.1}),
                          bench::step("back", 10, 0, history::LinearTo{-0.1})});
  cases::Check check = formula_check("CSF1", "T", {"CSF1", "T"}, {1e9, {}, ""});
  check.against = slider_reference("CU1 + 1/(T - 0.5)", {"CU1", "T"});
  check.step = "back";
  const Verdict verdict = verdict_of(problem, check);
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.message.find("an input of the closed form, 'CU1 + 1/(T - 0.5)', has no value") ==
        0);
  CHECK(verdict.message.find("at t = 0.5") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::check
