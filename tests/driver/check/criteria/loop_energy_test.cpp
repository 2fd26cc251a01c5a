// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/loop_energy.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

/// Reference cases, J2: 4 lim (A - s_c) = 6.4 mJ a loop of the amplitude 0.1 mm.
constexpr double kLoop = 6.4;

TEST_CASE("loops are counted from the first reversal if they close there") {
  const Series curve = slider(zigzag({0, 0.1, -0.1, 0.1, -0.1, 0.1}, 20));
  const CurveComparison found = compare_loop_energy(curve, curve, relative(0.0));
  REQUIRE(found.measures.size() == 3);
  CHECK(measure(found, "energy of loop 1").value == Approx(kLoop));
  CHECK(measure(found, "energy of loop 2").value == Approx(kLoop));
  CHECK(measure(found, "energy of all 2 loops").value == Approx(2.0 * kLoop));
  CHECK(measure(found, "energy of all 2 loops").scale == Approx(2.0 * kLoop));
  CHECK(measure(found, "energy of loop 2").where->abscissa == 0.1);
  CHECK(measure(found, "energy of loop 2").where->time == 60.0);
  CHECK(passed(found));
}

TEST_CASE("loops are counted from the start if they close there") {
  const Series curve = slider(zigzag({0, 0.1, 0, 0.1, 0, 0.1}, 20));
  const CurveComparison found = compare_loop_energy(curve, curve, relative(0.0));
  REQUIRE(found.measures.size() == 3);
  // From rest 20 N (0.08 + 0.01) mm less what the spring gives back, then 20 x 2 x (0.1 - 0.04).
  CHECK(measure(found, "energy of loop 2").value == Approx(2.4));
  CHECK(measure(found, "energy of loop 1").value > 2.4);
}

TEST_CASE("a loop that does not close is not counted") {
  // From rest to the first reversal and back beyond the start, then whole loops from there.
  const Series curve = slider(zigzag({0, 0.05, -0.1, 0.1, -0.1, 0.1, -0.1}, 40));
  const CurveComparison found = compare_loop_energy(curve, curve, relative(0.0));
  REQUIRE(found.measures.size() == 3);
  CHECK(measure(found, "energy of all 2 loops").value == Approx(2.0 * kLoop));
}

TEST_CASE("one wave has no loop between reversals, and its whole work is compared by that name") {
  const Series curve = slider(zigzag({0, 0.1, -0.1, 0}, 20));
  const CurveComparison found = compare_loop_energy(curve, curve, relative(0.0));
  REQUIRE(found.measures.size() == 1);
  CHECK(found.measures[0].name == "energy over the whole range (no whole loop)");
  // 20 N (0.08 + 0.16 + 0.06) mm dissipated, and 20^2/2000 stored at the end.
  CHECK(found.measures[0].value == Approx(6.2));
}

TEST_CASE("a loop's work is positive for friction in every quadrant, negative if it drives") {
  const Series curve = slider(zigzag({0.1, -0.1, 0.1}, 20), 20.0);
  const auto energy = [](const Series& loop) {
    return compare_loop_energy(loop, loop, {}).measures.at(0).value;
  };
  CHECK(energy(curve) == Approx(kLoop));
  CHECK(energy(scaled(curve, -1.0, -1.0)) == Approx(kLoop));
  CHECK(energy(scaled(curve, 1.0, -1.0)) == Approx(-kLoop));
}

TEST_CASE("ten rows a branch have the energy of a thousand") {
  const std::vector<double> turns{0, 0.1, -0.1, 0.1};
  const Series fine = slider(zigzag(turns, 1000, true));
  // Exact rows: a kink within a row cuts off less than (2 mu N)(h) / 2 / 4 a corner.
  CHECK(passed(compare_loop_energy(slider(zigzag(turns, 10)), fine, absolute(1e-3))));
  const double ragged =
      compare_loop_energy(slider(zigzag(turns, 10, true)), fine, {}).measures[0].deviation;
  CHECK(ragged < 0.03 * kLoop);
  const double four_times_finer =
      compare_loop_energy(slider(zigzag(turns, 41, true)), fine, {}).measures[0].deviation;
  CHECK(four_times_finer < 0.03 * kLoop / 9.0);
}

TEST_CASE("a wrong energy fails, in one loop alone, too") {
  const std::vector<double> turns{0, 0.1, -0.1, 0.1, -0.1, 0.1};
  const Series reference = slider(zigzag(turns, 20));
  Series result = reference;
  for (std::size_t i = 65; i < 78; ++i) result.value.change()[i] *= 1.1;
  const CurveComparison found = compare_loop_energy(result, reference, relative(0.03));
  CHECK(measure(found, "energy of loop 1").passed());
  CHECK_FALSE(measure(found, "energy of loop 2").passed());
  CHECK(measure(found, "energy of loop 2").scale == Approx(kLoop));
}

TEST_CASE("the total tells errors of all loops together") {
  const Series reference = slider(zigzag({0.1, -0.1, 0.1, -0.1, 0.1}, 20), 20.0);
  const CurveComparison found =
      compare_loop_energy(scaled(reference, 1.0, 1.1), reference, absolute(0.7));
  CHECK(measure(found, "energy of loop 1").passed());
  CHECK(measure(found, "energy of loop 2").passed());
  CHECK(measure(found, "energy of all 2 loops").deviation == Approx(0.2 * kLoop));
  CHECK_FALSE(measure(found, "energy of all 2 loops").passed());
}

TEST_CASE("an elastic loop without energy is measured by its ranges") {
  const auto spring = [](double x) { return 100.0 * x; };
  const Series reference = sampled(zigzag({0.1, -0.1, 0.1}, 10), spring);
  const CurveComparison found = compare_loop_energy(reference, reference, relative(1e-3));
  REQUIRE(found.measures.size() == 1);
  CHECK(std::abs(found.measures[0].reference) < 1e-12);  // rounding
  CHECK(found.measures[0].scale == Approx(0.2 * 20.0));
  const Series lossy = slider(zigzag({0.1, -0.1, 0.1}, 10), 20.0);
  CHECK_FALSE(passed(compare_loop_energy(lossy, reference, relative(1e-3))));
}

TEST_CASE("the last loop ends where both curves have it") {
  const Series result = slider(zigzag({0.1, -0.1, 0.1}, 20), 20.0);
  const Series reference = slider(zigzag({0.1, -0.1, 0.09}, 1900), 20.0);
  const CurveComparison found = compare_loop_energy(result, reference, relative(1e-3));
  CHECK(found.measures.at(0).reference ==
        Approx(kLoop - 0.2).epsilon(1e-5));  // a kink within a row
  CHECK(passed(found));
}

TEST_CASE("different numbers of branches are a fault") {
  const Series result = slider(zigzag({0, 0.1, -0.1}, 20));
  const Series reference = slider(zigzag({0, 0.1, -0.1, 0.1}, 20));
  CHECK_THAT(compare_loop_energy(result, reference, relative(1.0)).fault,
             Catch::Contains("arc_length"));
}

}  // namespace
}  // namespace slipbench::driver::check
