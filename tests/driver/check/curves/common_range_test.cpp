// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/common_range.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "driver/check/criteria/criteria.hpp"
#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

constexpr std::array kOfThisFile{cases::Criterion::kPointwise, cases::Criterion::kPeak,
                                 cases::Criterion::kArea,      cases::Criterion::kLoopEnergy,
                                 cases::Criterion::kBreakaway, cases::Criterion::kPlateau,
                                 cases::Criterion::kReversals};

/// A curve that every criterion accepts against itself.
Series loop() { return slider(zigzag({0, 0.1, -0.1, 0.1}, 20)); }

TEST_CASE("every criterion accepts a curve that is compared with itself") {
  for (const cases::Criterion criterion : kOfThisFile) {
    CAPTURE(info_of(criterion).word);
    const CurveComparison same = compare(criterion, loop(), loop(), absolute(0.0));
    CHECK(same.fault.empty());
    CHECK(same.compared > 0);
    CHECK(passed(same));
  }
}

TEST_CASE("every criterion refuses numbers that are not finite, on either side") {
  for (const cases::Criterion criterion : kOfThisFile) {
    CAPTURE(info_of(criterion).word);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Series broken = loop();
      broken.value.change()[3] = bad;
      const std::string ours = compare(criterion, broken, loop(), relative(1e9)).fault;
      CHECK(ours == "the value of the result is not a finite number in row 4");
      const std::string theirs = compare(criterion, loop(), broken, relative(1e9)).fault;
      CHECK(theirs == "the value of the reference is not a finite number in row 4");
      Series nowhere = loop();
      nowhere.abscissa.change()[2] = bad;
      CHECK_THAT(compare(criterion, nowhere, loop(), relative(1e9)).fault,
                 Catch::Contains("the abscissa of the result"));
    }
  }
}

TEST_CASE("every criterion refuses empty and ragged columns") {
  for (const cases::Criterion criterion : kOfThisFile) {
    CAPTURE(info_of(criterion).word);
    CHECK(compare(criterion, Series{}, loop(), relative(1e9)).fault == "the result has no rows");
    CHECK(compare(criterion, loop(), Series{}, relative(1e9)).fault == "the reference has no rows");
    Series short_abscissa = loop();
    short_abscissa.abscissa.change().pop_back();
    CHECK_FALSE(compare(criterion, short_abscissa, loop(), relative(1e9)).fault.empty());
    Series short_time = loop();
    short_time.time.change().pop_back();
    CHECK_FALSE(compare(criterion, short_time, loop(), relative(1e9)).fault.empty());
  }
}

TEST_CASE("every criterion refuses curves that share no range, and tells both ranges") {
  Series far = loop();
  for (double& x : far.abscissa.change()) x += 1.0;
  Series touching = loop();
  for (double& x : touching.abscissa.change()) x += 0.2;
  for (const cases::Criterion criterion : kOfThisFile) {
    CAPTURE(info_of(criterion).word);
    const std::string fault = compare(criterion, loop(), far, relative(1e9)).fault;
    CHECK_THAT(fault, Catch::Contains("no common range"));
    CHECK_THAT(fault, Catch::Contains("the result goes from -0.1 to 0.1"));
    CHECK_THAT(fault, Catch::Contains("the reference goes from 0.9 to 1.1"));
    CHECK_THAT(compare(criterion, loop(), touching, relative(1e9)).fault,
               Catch::Contains("only one point in common"));
  }
}

TEST_CASE("the extent of numbers is that of the standard library, to the sign of a 0") {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> numbers(1 + random() % 40);
    for (double& x : numbers) {
      x = static_cast<double>(random() % 5) - (i % 3);
      if (x == 0.0 && random() % 2 == 0) x = -0.0;
    }
    const auto [lowest, highest] = std::minmax_element(numbers.begin(), numbers.end());
    const Interval found = extent(numbers);
    REQUIRE(found.from == *lowest);
    REQUIRE(found.to == *highest);
    REQUIRE(std::signbit(found.from) == std::signbit(*lowest));
    REQUIRE(std::signbit(found.to) == std::signbit(*highest));
  }
}

TEST_CASE("the row is told that is not finite, wherever it stands") {
  for (std::size_t row = 0; row < 40; ++row) {
    Series broken = sampled(std::vector<double>(40, 1.0), [](double x) { return x; });
    const Series whole = broken;
    broken.value.change()[row] = std::numeric_limits<double>::infinity();
    CHECK(common_range(whole, broken).fault ==
          "the value of the reference is not a finite number in row " + std::to_string(row + 1));
  }
}

TEST_CASE("a common range of rounding alone is kept") {
  Series result = sampled({0.0, 0.1 + 0.2}, [](double x) { return x; });
  const Series reference = sampled({0.3, 1.0}, [](double x) { return x; });
  CHECK_THAT(common_range(result, reference).fault, Catch::Contains("only one point"));
  result.abscissa.change().back() = 0.3 - 1e-16;
  CHECK_THAT(common_range(result, reference).fault, Catch::Contains("only one point"));
  result.abscissa.change().back() = 0.3 - 1e-6;
  CHECK_THAT(common_range(result, reference).fault, Catch::Contains("no common range"));
}

TEST_CASE("a reference of one row is no curve, unless the result is one row, too") {
  const Series reference{{0.05}, {20.0}, {}};
  const Series result = slider(zigzag({0, 0.1}, 7));
  for (const cases::Criterion criterion : kOfThisFile) {
    CAPTURE(info_of(criterion).word);
    CHECK_THAT(compare(criterion, result, reference, relative(1e9)).fault,
               Catch::Contains("only one point in common"));
    CHECK_FALSE(
        compare(criterion, result, {{0.05, 0.05}, {20.0, 20.0}, {}}, relative(1e9)).fault.empty());
  }
  for (const cases::Criterion criterion : {cases::Criterion::kPointwise, cases::Criterion::kPeak}) {
    CHECK(passed(compare(criterion, {{0.05}, {19.5}, {}}, reference, absolute(0.6))));
    CHECK_FALSE(passed(compare(criterion, {{0.05}, {19.5}, {}}, reference, absolute(0.4))));
    // The very rows of a result that never moves, as an expression has them.
    const Series still{{0.05, 0.05}, {1.0, 2.0}, {0.0, 1.0}};
    CHECK(passed(compare(criterion, still, still, absolute(0.0))));
  }
}

TEST_CASE("numbers whose range no double holds are a fault, not a tolerance without bound") {
  Series huge = loop();
  huge.value.change().front() = -1.7e308;
  huge.value.change().back() = 1.7e308;
  for (const cases::Criterion criterion : kOfThisFile) {
    CAPTURE(info_of(criterion).word);
    CHECK(compare(criterion, loop(), huge, relative(0.05)).fault ==
          "the range of the reference exceeds that of a double");
  }
  CHECK(compare(cases::Criterion::kIso18571, loop(), huge, relative(0.05)).fault ==
        "the range of the reference exceeds that of a double");
}

TEST_CASE("every criterion judges by the same fraction in other units and mirrored") {
  const Series reference = loop();
  const Series result = scaled(slider(zigzag({0, 0.099, -0.1, 0.1}, 23)), 1.0, 1.03);
  for (const cases::Criterion criterion : kOfThisFile) {
    CAPTURE(info_of(criterion).word);
    const CurveComparison original = compare(criterion, result, reference, relative(0.1));
    REQUIRE(original.fault.empty());
    for (const auto& [x, q] : {std::pair{1e3, 1e-6}, std::pair{1e-6, 1e3}, std::pair{-1.0, -1.0},
                               std::pair{1.0, -1.0}, std::pair{-1.0, 1.0}}) {
      CAPTURE(x, q);
      const CurveComparison other =
          compare(criterion, scaled(result, x, q), scaled(reference, x, q), relative(0.1));
      REQUIRE(other.fault.empty());
      REQUIRE(other.measures.size() == original.measures.size());
      CHECK(other.compared == original.compared);
      // Mirrored, the largest value becomes the smallest.
      const bool swapped = criterion == cases::Criterion::kPeak && q < 0.0;
      for (std::size_t i = 0; i < other.measures.size(); ++i) {
        const Measure& a = original.measures[swapped ? 1 - i : i];
        const Measure& b = other.measures[i];
        if (a.unit == MeasureUnit::kNone) {
          CHECK(a.deviation == b.deviation);
        } else {
          CHECK(b.deviation / b.scale == Approx(a.deviation / a.scale).margin(1e-12));
          CHECK(b.tolerance / b.scale == Approx(0.1));
        }
      }
    }
  }
}

TEST_CASE("a part of a curve begins and ends between its rows, wherever it goes") {
  const Series curve = sampled({0, 1, 2, 3}, [](double x) { return 10 * x; });
  const Series part = cut(curve, {0.5, 2.25}, 1e-12);
  CHECK(part.abscissa == std::vector<double>{0.5, 1, 2, 2.25});
  CHECK(part.value == std::vector<double>{5, 10, 20, 22.5});
  const Series within = cut(curve, {1.25, 1.75}, 1e-12);
  CHECK(within.abscissa == std::vector<double>{1.25, 1.75});
  Series back = curve;
  std::reverse(back.abscissa.change().begin(), back.abscissa.change().end());
  std::reverse(back.value.change().begin(), back.value.change().end());
  CHECK(cut(back, {0.5, 2.25}, 1e-12).abscissa == std::vector<double>{2.25, 2, 1, 0.5});
  const Series line = sampled({0, 4}, [](double x) { return x; });
  CHECK(cut(line, {1, 3}, 1e-12).abscissa == std::vector<double>{1, 3});
  CHECK(cut(scaled(line, -1, 1), {-3, -1}, 1e-12).abscissa == std::vector<double>{-1, -3});
  CHECK(cut(line, {1, 1}, 1e-12).abscissa == std::vector<double>{1});
  // Row 1 is there but for rounding: no second one is made beside it.
  CHECK(cut(curve, {1.0 + 1e-14, 2.0}, 1e-12).abscissa == std::vector<double>{1, 2});
}

}  // namespace
}  // namespace slipbench::driver::check
