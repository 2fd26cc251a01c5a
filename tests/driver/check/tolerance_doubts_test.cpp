// SPDX-License-Identifier: Apache-2.0
#include "driver/check/tolerance_doubts.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

namespace slipbench::driver::check {
namespace {

using Doubts = std::vector<std::string>;

cases::Tolerance absolute(double value) { return {.absolute = value, .relative = {}, .why = ""}; }
cases::Tolerance relative(double value) { return {.absolute = {}, .relative = value, .why = ""}; }

TEST_CASE(
    "a tolerance that is orders looser than the agreement is doubted, with one that would do") {
  CHECK(tolerance_doubts(absolute(0.5),
                         {.scale = 40.0, .worst = 1.23e-4, .resolution = {}, .unit = "N"}) ==
        Doubts{"the tolerance of 0.5 N is 4e+03 times the largest deviation, 0.000123 N; "
               "'absolute: 2e-03' would do"});
  CHECK(tolerance_doubts(relative(0.01),
                         {.scale = 40.0, .worst = 1.2e-4, .resolution = {}, .unit = "N"}) ==
        Doubts{"the tolerance of 0.4 N is 3e+03 times the largest deviation, 0.00012 N; "
               "'relative: 3e-05' would do"});
  CHECK(tolerance_doubts(relative(0.05),
                         {.scale = 1.0, .worst = 0.0, .resolution = {}, .unit = ""}) ==
        Doubts{"the tolerance of 0.05 is not needed at all, there is no deviation; "
               "'relative: 1e-06' would do"});
}

TEST_CASE("the tolerance that counts is the one that is doubted") {
  const cases::Tolerance both{.absolute = 0.1, .relative = 0.01, .why = ""};
  const ToleranceUse use{.scale = 1.0, .worst = 1e-6, .resolution = {}, .unit = "mm"};
  REQUIRE(tolerance_doubts(both, use).size() == 1);
  CHECK_THAT(tolerance_doubts(both, use).front(), Catch::Contains("'absolute: 1e-05' would do"));
}

TEST_CASE("a suggested tolerance is not doubted itself, and holds") {
  for (const double worst : {0.0, 1e-12, 3e-8, 9.99e-6, 1.1e-5, 2.3e-4}) {
    CAPTURE(worst);
    const ToleranceUse use{.scale = 1.0, .worst = worst, .resolution = {}, .unit = ""};
    const Doubts doubts = tolerance_doubts(relative(0.9), use);
    REQUIRE(doubts.size() == 1);
    const std::size_t at = doubts.front().find("relative: ") + 10;
    const double suggested = std::stod(doubts.front().substr(at));
    CHECK(suggested >= worst);
    CHECK(tolerance_doubts(relative(suggested), use).empty());
  }
  // A millionth of this scale has two digits.
  const ToleranceUse rounded{.scale = 34.0, .worst = 7e-15, .resolution = {}, .unit = "N"};
  CHECK_THAT(tolerance_doubts(absolute(1.0), rounded).front(),
             Catch::Contains("'absolute: 4e-05'"));
  CHECK(tolerance_doubts(absolute(4e-5), rounded).empty());
}

TEST_CASE("tolerances near the agreement, or tight for their scale, are not doubted") {
  const auto doubted = [](const cases::Tolerance& tolerance, double scale, double worst) {
    return !tolerance_doubts(tolerance,
                             {.scale = scale, .worst = worst, .resolution = {}, .unit = "N"})
                .empty();
  };
  CHECK(doubted(absolute(0.5), 40.0, 0.00049));
  CHECK_FALSE(doubted(absolute(0.5), 40.0, 0.00051));
  CHECK_FALSE(doubted(absolute(0.5), 40.0, 3.0));
  CHECK(doubted(relative(1.1e-6), 40.0, 1e-12));
  CHECK_FALSE(doubted(relative(1e-6), 40.0, 0.0));
  CHECK_FALSE(doubted(relative(1e-9), 40.0, 1e-15));
  CHECK_FALSE(doubted(absolute(1e-5), 40.0, 1e-12));
  // A quantity that is zero throughout has no natural tolerance.
  CHECK_FALSE(doubted(absolute(1e-3), 0.0, 0.0));
}

TEST_CASE("a tolerance below the reference's printed digits is doubted") {
  CHECK(tolerance_doubts(absolute(0.01),
                         {.scale = 40.0, .worst = 0.03, .resolution = 0.05, .unit = "N"}) ==
        Doubts{"the reference's printed digits leave it uncertain by 0.05 N, more than the "
               "tolerance of 0.01 N; print more digits or widen the tolerance"});
  CHECK(tolerance_doubts(absolute(0.05),
                         {.scale = 40.0, .worst = 0.03, .resolution = 0.05, .unit = "N"})
            .empty());
  CHECK(tolerance_doubts(relative(0.01),
                         {.scale = 40.0, .worst = 0.03, .resolution = 0.05, .unit = "N"})
            .empty());
}

TEST_CASE("a tolerance of the reference itself, as a percentage would be, is doubted") {
  const ToleranceUse use{.scale = 1.0, .worst = 0.5, .resolution = {}, .unit = ""};
  CHECK(tolerance_doubts(relative(5.0), use) ==
        Doubts{"'relative: 5' allows 5 times the reference itself; 5 % is 'relative: 0.05'"});
  CHECK(tolerance_doubts(relative(0.99), use).empty());
  CHECK(tolerance_doubts(relative(1e308), use).size() == 1);
  CHECK(tolerance_doubts(absolute(1e300), use) ==
        Doubts{"the tolerance of 1e+300 allows any number"});
}

TEST_CASE("numbers that are not finite give no doubts") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CHECK(tolerance_doubts(absolute(1.0), {.scale = kNan, .worst = 0.0, .resolution = {}, .unit = ""})
            .empty());
  CHECK(tolerance_doubts(absolute(1.0), {.scale = 1.0, .worst = kNan, .resolution = {}, .unit = ""})
            .empty());
  CHECK(tolerance_doubts(absolute(kInfinity),
                         {.scale = 1.0, .worst = 0.0, .resolution = {}, .unit = ""})
            .empty());
  CHECK(
      tolerance_doubts(absolute(0.1), {.scale = 1.0, .worst = 0.05, .resolution = kNan, .unit = ""})
          .empty());
}

TEST_CASE("a deviation that rounding cannot explain is no matter of the digits") {
  const auto doubted = [](double worst) {
    return !tolerance_doubts(absolute(0.01),
                             {.scale = 40.0, .worst = worst, .resolution = 0.05, .unit = "N"})
                .empty();
  };
  CHECK(doubted(0.15));
  CHECK_FALSE(doubted(0.16));
}

TEST_CASE("no tolerance is suggested that the reference's digits forbid") {
  const ToleranceUse use{.scale = 20.0, .worst = 0.0, .resolution = 0.5, .unit = "N"};
  // Too small for the digits: only that is said.
  REQUIRE(tolerance_doubts(absolute(0.1), use).size() == 1);
  CHECK_THAT(tolerance_doubts(absolute(0.1), use).front(), Catch::Contains("printed digits"));
  CHECK(tolerance_doubts(absolute(1.0), use).empty());
  const ToleranceUse fine{.scale = 20.0, .worst = 0.0, .resolution = 1e-6, .unit = "N"};
  CHECK(tolerance_doubts(absolute(0.1), fine).size() == 1);
}

std::vector<CurvePoint> points(const std::vector<double>& values,
                               const std::vector<double>& references) {
  std::vector<CurvePoint> made;
  for (std::size_t i = 0; i < values.size(); ++i) {
    made.push_back({.value = values[i], .reference = references[i]});
  }
  return made;
}

TEST_CASE("digits are complete if most different values agree better than rounding could") {
  // Integers that are exact, a failing row or two beside them.
  CHECK(has_all_digits(points({0, 2, 4, 7, 8, 11, 12, 14}, {0, 2, 4, 6, 8, 10, 12, 14}), 0.5));
  // Rounded to integers: one of four agrees by chance.
  CHECK_FALSE(has_all_digits(points({1.7, 4.0, 6.3, 7.9}, {2, 4, 6, 8}), 0.5));
  // Zeros and a plateau agree in a rounded file, too.
  CHECK_FALSE(has_all_digits(
      points({0, 0, 0, 1.7, 4.4, 20, 20, 20, 20, 20}, {0, 0, 0, 2, 4, 20, 20, 20, 20, 20}), 0.5));
  // Few values count if nothing speaks against them.
  CHECK(has_all_digits(points({0, 10, 20}, {0, 10, 20}), 0.5));
  CHECK_FALSE(has_all_digits(points({0, 10.1, 20}, {0, 10, 20}), 0.5));
}

TEST_CASE("a reference of which less than half was seen is told with both ranges") {
  const Series reference{{0, 1, 2, 3, 4}, {0, 0, 0, 0, 0}, {}};
  const auto doubt = [&](double end, std::int64_t rows) {
    return coverage_doubt({{0, end}, {0, 0}, {}}, reference, rows);
  };
  CHECK(doubt(1.5, 2) ==
        "only 2 of the reference's 5 rows were compared, from 0 to 1.5, while it goes from 0 to 4; "
        "select with 'over' what is meant");
  CHECK(doubt(2.0, 3).empty());
  CHECK(doubt(8.0, 5).empty());
  CHECK(doubt(9.0, 5) ==
        "the reference goes from 0 to 4 only, and the rows that the check selects from 0 to 9; "
        "select with 'over' what is meant");
  // Half of the rows, but a small part of the range.
  CHECK_FALSE(coverage_doubt({{0, 1}, {0, 0}, {}}, {{0, 0.5, 1, 9}, {0, 0, 0, 0}, {}}, 3).empty());
}

}  // namespace
}  // namespace slipbench::driver::check
