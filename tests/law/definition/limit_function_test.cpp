// SPDX-License-Identifier: Apache-2.0
// Limits as functions of the slip of an increment: where they bend, and what that finds.
#include "law/definition/limit_function.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "law/definition/capstan_limit.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/first_root.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

ConnectorIncrement lasting(double duration, double force = 0.0) {
  ConnectorIncrement increment;
  increment.duration = duration;
  increment.force[0] = force;
  return increment;
}

/// F_int falls by 1 per slip, from 2 to 0.
FrictionDefinition wearing(const FrictionLaw& law) {
  FrictionDefinition definition;
  definition.contact_force = ComponentContactForce{0};
  definition.internal_contact_force =
      make_function({{2.0, 0.0}, {0.0, 2.0}}, {kOverAccumulatedSlip});
  definition.law = law;
  return definition;
}

/// F_int grows by `growth` per slip from 2, up to the slip 1; mu has a knot at a contact force.
FrictionDefinition growing(double growth, double knot) {
  FrictionDefinition definition = wearing(TabularCoefficient{
      make_function({{0.3, 0.0}, {0.2, knot}, {0.25, 9.0}}, {kOverContactForce})});
  definition.internal_contact_force =
      make_function({{2.0, 0.0}, {2.0 + growth, 1.0}}, {kOverAccumulatedSlip});
  return definition;
}

TEST_CASE("a contact force that wears through 0 presses again from there on") {
  const FrictionDefinition definition = wearing(TabularCoefficient{
      make_function({{0.3, 0.0}, {0.2, 0.5}, {0.25, 4.0}}, {kOverContactForce})});
  const ConnectorIncrement increment = lasting(1.0, -1.0);
  const LimitFunction limit(definition, increment, {}, 0.0);
  // F_N = |1 - x|: the knot at 0.5 on the way down, 0 itself, and the knot on the way up.
  CHECK(limit.next_knot(0.0, 2.0) == Approx(0.5).epsilon(1e-15));
  CHECK(limit.next_knot(0.5, 2.0) == 1.0);
  CHECK(limit.next_knot(1.0, 2.0) == Approx(1.5).epsilon(1e-15));
}

TEST_CASE("wear by the slip before the increment has no knot in it") {
  FrictionDefinition definition = wearing(ConstantCoefficient{0.3});
  const ConnectorIncrement increment = lasting(1.0, 1.0);
  CHECK(LimitFunction(definition, increment, {}, 0.0).next_knot(0.0, 10.0) == 2.0);
  definition.accumulated_slip = AccumulatedSlipTiming::kStart;
  CHECK(LimitFunction(definition, increment, {}, 0.0).next_knot(0.0, 10.0) > 10.0);
}

TEST_CASE("an internal contact force that grows slowly meets the knots of the contact force") {
  for (const double growth : {0.5, 5e-4}) {
    const FrictionDefinition definition = growing(growth, 2.0 + 0.2 * growth);
    const ConnectorIncrement increment = lasting(1.0);
    CHECK(LimitFunction(definition, increment, {}, 0.0).next_knot(0.0, 1.0) ==
          Approx(0.2).epsilon(1e-10));
  }
}

TEST_CASE("an internal contact force that a table brings to 0 stays there, and so do its knots") {
  // F_N = 5 + max(worn - wear x, 0), with a knot of the coefficient next to 5, in any digits.
  for (int i = 1; i < 100; ++i) {
    for (const double knot : {5.5, 5.0005}) {
      CAPTURE(i, knot);
      const double wear = std::sqrt(i);
      const double worn = 0.6 * std::cbrt(i);
      FrictionDefinition definition = wearing(TabularCoefficient{
          make_function({{0.3, 0.0}, {0.2, knot}, {0.25, 90.0}}, {kOverContactForce})});
      definition.internal_contact_force =
          make_function({{worn, 0.0}, {worn - 2.0 * wear, 2.0}}, {kOverAccumulatedSlip});
      const ConnectorIncrement increment = lasting(1.0, 5.0);
      const LimitFunction limit(definition, increment, {}, 0.0);
      double slip = 0.0;
      for (const double next : {(worn + 5.0 - knot) / wear, worn / wear, 2.0}) {
        // Rounding may leave a knot just ahead of where it is looked from.
        const double before = slip;
        for (int k = 0; k < 3 && slip - before < 1e-12; ++k) slip = limit.next_knot(slip, 10.0);
        CHECK(slip == Approx(next).epsilon(1e-11));
      }
    }
  }
}

TEST_CASE("the largest value in a piece is looked for inside of its ends, and in the middle") {
  const auto inside = [](double x) { return x > 1.0 && x < 3.0; };
  const auto largest = [&](auto value) {
    return largest_inside(1.0, 3.0, 0.0, [&](double x) { return inside(x) ? value(x) : 9.0; });
  };
  CHECK(largest([](double x) { return 3.0 - x; }) == Approx(2.0));
  CHECK(largest([](double x) { return x - 1.0; }) == Approx(2.0));
  CHECK(largest([](double x) { return 1.0 - std::abs(x - 2.0); }) == Approx(1.0));
}

TEST_CASE("a knot that rounding leaves just ahead is passed") {
  for (int i = 1; i < 200; ++i) {
    const double force = -0.01 * i;
    const FrictionDefinition definition = wearing(ConstantCoefficient{0.3});
    const ConnectorIncrement increment = lasting(1.0, force);
    FrictionState old;
    old.accumulated_slip = 1.0 / 3.0;
    const LimitFunction limit(definition, increment, old, 0.0);
    // The place where F_C + F_int is 0, and the end of the table.
    const double zero = 2.0 + force - old.accumulated_slip;
    double slip = 0.0;
    if (zero > 0.0) {
      slip = limit.next_knot(0.0, 10.0);
      CHECK(slip == Approx(zero).epsilon(1e-14));
    }
    CHECK(limit.next_knot(slip, 10.0) == Approx(5.0 / 3.0).epsilon(1e-15));
  }
}

TEST_CASE(
    "behind a zero of the contact force its knots come again, whatever rounding leaves there") {
  FrictionDefinition definition = wearing(TabularCoefficient{
      make_function({{1.0, 0.0}, {1.0, 0.1}, {0.05, 0.12}}, {kOverContactForce})});
  for (int i = 1; i < 200; ++i) {
    INFO("case " << i);
    const double wear = std::sqrt(i);
    const double worn = std::cbrt(i);
    definition.internal_contact_force =
        make_function({{worn + 1.0, 0.0}, {worn + 1.0 - 2.0 * wear, 2.0}}, {kOverAccumulatedSlip});
    const ConnectorIncrement increment = lasting(1.0, -worn);
    FrictionState old;
    old.accumulated_slip = 0.3 / wear;
    const LimitFunction limit(definition, increment, old, 0.0);
    // F_N = |0.7 - wear x|
    double slip = 0.0;
    for (const double force : {0.12, 0.1, 0.0, -0.1, -0.12}) {
      if (worn < -force) break;
      slip = limit.next_knot(slip, 2.0);
      CHECK(slip == Approx((0.7 - force) / wear).epsilon(1e-11));
    }
    // The first of three roots lies where mu is still 1; the last where it is 0.05.
    CHECK(first_root(limit, 0.85, wear) == Approx(0.775 / wear).epsilon(1e-11));
  }
}

TEST_CASE("of three roots within one piece of a cubic limit the first is found") {
  // mu = V F_N and F_N = 1 - x at V = x/duration: F_lim = x (1 - x)^2, a cubic about x = 2/3.
  FrictionDefinition definition;
  definition.law = TabularCoefficient{
      make_function({{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}},
                    {kOverSlipRate, kOverContactForce})};
  definition.internal_contact_force =
      make_function({{1.0, 0.0}, {0.0, 1.0}}, {kOverAccumulatedSlip});
  const ConnectorIncrement increment = lasting(1.0);
  const LimitFunction limit(definition, increment, {}, 0.0);
  CHECK(limit(0.5).force == Approx(0.125).epsilon(1e-15));
  // With u = x - 2/3 the limit is (1/3 - kappa) u - u^3 below a line through its inflection.
  for (const double kappa : {0.2, 0.25, 0.3, 0.32}) {
    INFO("kappa " << kappa);
    const double trial = 2.0 / 27.0 + kappa * 2.0 / 3.0;
    CHECK(first_root(limit, trial, kappa) ==
          Approx(2.0 / 3.0 - std::sqrt(1.0 / 3.0 - kappa)).epsilon(1e-12));
  }
  // A stiffness of which the double is infinite, with a limit lost in its rounding.
  CHECK(first_root(limit, 5e307, 1e308) == 0.5);
}

TEST_CASE("the first root of a limit of cubic pieces is that of a fine scan") {
  constexpr int kPoints = 4000;
  const ConnectorIncrement increment = lasting(1.0);
  int within = 0;
  for (int i = 0; i < 300; ++i) {
    INFO("case " << i);
    const auto mu = [&](int k) { return 0.5 + 0.5 * std::sin(1.7 * i + 2.3 * k * (i % 7 + 1)); };
    FrictionDefinition definition =
        wearing(TabularCoefficient{make_function({{mu(1), 0.0, 0.0},
                                                  {mu(2), 0.8, 0.0},
                                                  {mu(3), 2.0, 0.0},
                                                  {mu(4), 0.0, 2.0},
                                                  {mu(5), 0.8, 2.0},
                                                  {mu(6), 2.0, 2.0}},
                                                 {kOverSlipRate, kOverContactForce})});
    const LimitFunction limit(definition, increment, {}, 0.0);
    const double kappa = 0.05 + 0.1 * (i % 5);
    const double trial = limit(0.0).force + 0.01 + 0.05 * (i % 9);
    const double end = std::min(trial / kappa, 2.0);
    double scan = end;
    for (int k = 1; k <= kPoints && scan == end; ++k) {
      const double x = end * k / kPoints;
      if (trial - kappa * x - limit(x).force < 0.0) scan = x;
    }
    if (scan == end) continue;
    ++within;
    // Between two points of the scan.
    CHECK(first_root(limit, trial, kappa) ==
          Approx(scan - 0.5 * end / kPoints).margin(0.51 * end / kPoints));
  }
  CHECK(within > 100);
}

TEST_CASE("a limit is cubic only where the contact force changes with the slip") {
  FrictionDefinition definition = wearing(TabularCoefficient{
      make_function({{0.1, 0.0, 0.0}, {0.06, 100.0, 0.0}, {0.08, 0.0, 1e3}, {0.05, 100.0, 1e3}},
                    {kOverSlipRate, kOverContactForce})});
  const ConnectorIncrement increment = lasting(0.01);
  CHECK(LimitFunction(definition, increment, {}, 0.0).is_cubic());
  definition.internal_contact_force = 12.0;
  CHECK_FALSE(LimitFunction(definition, increment, {}, 0.0).is_cubic());
}

/// A belt over `wrap_angle` whose coefficient sees the slip rate.
FrictionDefinition belt(const FrictionLaw& law, double wrap_angle) {
  FrictionDefinition definition;
  definition.slip = slip_space({2});
  definition.criterion = Capstan{wrap_angle};
  definition.contact_force = ComponentContactForce{0};
  definition.law = law;
  return definition;
}

TEST_CASE("the limit of a belt bends where its angle and its blend make it and its tension") {
  // mu = C3 exp(C4 V) p: -exp(-weight alpha mu) bends where weight alpha mu is 1.
  ModifiedDarmstad law;
  law.c3 = 1e5;
  law.c4 = -2.0;
  FrictionDefinition definition = belt(law, 3.0);
  definition.blend = {0.0, 0.5};
  const ConnectorIncrement increment = lasting(0.5, 1e-4);
  const CapstanLimit limit(definition, increment, 0.0, FlowSense::kBackward);
  CHECK(limit.next_knot(0.0, 1.0) ==
        Approx(0.5 * std::log(0.5 * 3.0 * 1e5 * 1e-4) / 2.0).epsilon(1e-12));
}

TEST_CASE("a dip of a belt's limit is found in any unit of length") {
  // mu falls from 10 at rest to 0 at the rate 1: with u = 10 x/length the limit of the unwrapping
  // side is 1 - exp(u - 10), and its distance from the trial line is least at u = 1.
  const FrictionDefinition definition =
      belt(TabularCoefficient{make_function({{10.0, 0.0}, {0.0, 1.0}}, {kOverSlipRate})}, 1.0);
  for (const double length : {1.0, 1e-8, 1e-16, 1e8}) {
    INFO("length " << length);
    const ConnectorIncrement increment = lasting(length, 1.0);
    const CapstanLimit limit(definition, increment, 0.0, FlowSense::kBackward);
    const double kappa = 10.0 * std::exp(-9.0) / length;
    const double trial = 1.0 - 0.5 * std::exp(-10.0);
    const double u = 10.0 * first_root(limit, trial, kappa) / length;
    CHECK(std::exp(u) - std::exp(1.0) * u == Approx(0.5).epsilon(1e-9));
    CHECK(u < 1.0);
  }
}

TEST_CASE("the rate of a belt's motion is the motion over the time") {
  const FrictionDefinition definition = belt(ConstantCoefficient{0.3}, 1.0);
  const ConnectorIncrement increment = lasting(0.5, 1.0);
  const CapstanLimit limit(definition, increment, 0.0, FlowSense::kForward);
  CHECK(limit.motion_rate(3.0) == 6.0);
}

}  // namespace
