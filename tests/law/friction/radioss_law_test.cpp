// SPDX-License-Identifier: Apache-2.0
// The coefficient laws of the Radioss friction options against their numbers.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "law/friction/friction_law.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/uniqueness.hpp"

namespace {

using namespace slipbench::law;

/// mu at pressure and speed; a unit area makes the pressure the force.
double mu(const FrictionLaw& law, double p, double v) {
  return evaluate(law, Ambient{}, {.slip_rate = v, .contact_force = p}).mu;
}

struct Value {
  double p, v, mu;
};
void check(const FrictionLaw& law, const std::vector<Value>& values, double tolerance) {
  for (const Value& value : values) {
    INFO("p " << value.p << ", V " << value.v);
    CHECK(mu(law, value.p, value.v) == Approx(value.mu).epsilon(tolerance));
  }
}

Renard renard(const std::array<double, 6>& c) {
  Renard law;
  law.c1 = c[0], law.c2 = c[1], law.c3 = c[2], law.c4 = c[3], law.c5 = c[4], law.c6 = c[5];
  return law;
}
const Renard kRenard = renard({0.15, 0.10, 0.25, 0.05, 10.0, 100.0});

TEST_CASE("generalised viscous friction gives what OpenRadioss gives") {
  const GeneralizedViscous law{0.12, -2e-4, -1e-4, 1e-6, 4e-7, 5e-8, 0.0, 1.0};
  // Sums of terms that cancel to a half.
  check(law,
        {{0, 0, 0.12},
         {0, 500, 0.0825},
         {0, 1000, 0.07},
         {100, 750, 0.132125},
         {110, 0, 0.10284},
         {150, 958.3333333333334, 0.19283680555555555},
         {200, 1000, 0.246}},
        1e-14);
}

TEST_CASE("generalised viscous friction gives the reference values (R2)") {
  const GeneralizedViscous law{0.1, 0.001, 0.02, 0.0005, 1e-5, -0.002, 0.0, 1.0};
  check(law, {{0, 0, 0.1}, {10, 1, 0.134}, {20, 2, 0.176}, {50, 3, 0.292}}, 1e-14);
}

TEST_CASE("modified Darmstad friction gives what OpenRadioss gives") {
  const ModifiedDarmstad law{0.08, 1e-6, -2e-3, -2e-4, -1e-3, 0.1, -5e-3, 1.0};
  // The exponential function and sums of terms that cancel.
  check(law,
        {{0, 0, 0.18},
         {0, 500, 0.08820849986238988},
         {100, 750, 0.075135745132264925},
         {110, 0, 0.1701},
         {150, 958.3333333333334, 0.07263358481254817},
         {200, 1000, 0.07137202838251536}},
        1e-14);
}

TEST_CASE("modified Darmstad friction gives the reference values (R3)") {
  const ModifiedDarmstad law{0.1, 1e-5, -0.5, 0.002, -1.0, 0.05, -2.0, 1.0};
  // The numbers have 15 digits.
  check(law,
        {{0, 0, 0.15},
         {10, 0, 0.171},
         {10, 1, 0.114730883644972},
         {20, 2, 0.107800711038587},
         {50, 3, 0.11068089844933}},
        1e-14);
}

TEST_CASE("the exponential decay is a case of modified Darmstad friction") {
  const ModifiedDarmstad law = darmstad_decay(0.4, 0.2, 0.015);
  CHECK(mu(law, 0, 600) == Approx(0.20002468196081735).epsilon(1e-15));
  const ExponentialDecay decay{0.4, 0.2, 0.015};
  for (double v = 0.0; v < 1000.0; v += 7.0) {
    const CoefficientPoint a = evaluate(law, Ambient{}, {.slip_rate = v, .contact_force = 50.0});
    const CoefficientPoint b = evaluate(decay, Ambient{}, {.slip_rate = v, .contact_force = 50.0});
    CHECK(a.mu == Approx(b.mu).epsilon(1e-15));
    // mu - kinetic of the decay cancels where the exponential has died out.
    CHECK(a.to_slip_rate == Approx(b.to_slip_rate).epsilon(1e-12).margin(1e-18));
    CHECK(a.to_contact_force == 0.0);
  }
  CHECK(largest(law) == 0.4);
  CHECK(steepest_weakening(law) == Approx(steepest_weakening(decay)).epsilon(1e-15));
  CHECK_FALSE(needs_area(law));
}

TEST_CASE("the exponential decay with Radioss' constants gives its value") {
  CHECK(mu(ExponentialDecay{0.4, 0.2, 0.02}, 0, 40) == Approx(0.2898657928).epsilon(1e-10));
}

TEST_CASE("Renard friction gives what OpenRadioss gives") {
  check(kRenard,
        {{0, 0, 0.15},
         {0, 2, 0.186},
         {0, 5, 0.225},
         {0, 10, 0.25},
         {0, 32.5, 0.21875},
         {0, 55, 0.15},
         {0, 77.5, 0.08125},
         {0, 100, 0.05},
         {0, 101, 0.05238095238095239},
         {0, 105, 0.07777777777777778},
         {0, 110, 0.09166666666666667},
         {0, 150, 0.09960317460317461},
         {0, 300, 0.09997501249375312}},
        1e-14);  // C2 - d/q cancels to a half at C6
}

TEST_CASE("Renard friction gives the reference values (R1)") {
  // The numbers have 15 digits.
  check(renard({0.15, 0.18, 0.3, 0.1, 2.0, 10.0}),
        {{0, 0, 0.15},
         {0, 1, 0.2625},
         {0, 2, 0.3},
         {0, 4, 0.26875},
         {0, 6, 0.2},
         {0, 10, 0.1},
         {0, 11, 0.105925925925926},
         {0, 15, 0.153333333333333},
         {0, 20, 0.171111111111111},
         {0, 100, 0.179876733436055}},
        1e-14);
}

TEST_CASE("Renard's last piece depends on the unit of speed unless the factor goes along (R1)") {
  // The constants in m/s, asked at 11 m/s.
  const Renard metres = renard({0.15, 0.18, 0.3, 0.1, 2.0, 10.0});
  CHECK(mu(metres, 0, 11) == Approx(0.105925925925926).epsilon(1e-14));
  // C5 and C6 alone converted to mm/s: another friction.
  CHECK(mu(renard({0.15, 0.18, 0.3, 0.1, 2000.0, 10000.0}), 0, 11000) ==
        Approx(0.179999).margin(5e-7));
  // A case in mm/s with the constants left in m/s.
  Renard millimetres = metres;
  millimetres.speed_factor = 1e-3;
  for (const double v : {0.0, 1.0, 4.0, 11.0, 20.0, 100.0}) {
    const CoefficientPoint a = evaluate(metres, Ambient{}, {.slip_rate = v});
    const CoefficientPoint b = evaluate(millimetres, Ambient{}, {.slip_rate = 1e3 * v});
    CHECK(a.mu == Approx(b.mu).epsilon(1e-14));  // rounding of 1e-3 V beside C6
    CHECK(a.to_slip_rate == Approx(1e3 * b.to_slip_rate).epsilon(1e-13).margin(1e-18));
  }
  CHECK(steepest_weakening(metres) == Approx(1e3 * steepest_weakening(millimetres)));
}

TEST_CASE("Renard's curve is smooth at its joints and rises from rest as said") {
  const auto at = [](double v) { return evaluate(kRenard, Ambient{}, {.slip_rate = v}); };
  // One rounding of V beside a joint moves mu by nothing and its slope by slope' times it.
  for (const auto& [joint, value] : {std::pair{10.0, 0.25}, std::pair{100.0, 0.05}}) {
    for (const double v : {std::nextafter(joint, 0.0), joint, std::nextafter(joint, 1e9)}) {
      CHECK(at(v).mu == Approx(value).epsilon(1e-15));
      CHECK(std::abs(at(v).to_slip_rate) <= 1e-15);
    }
  }
  CHECK(at(0.0).to_slip_rate == Approx(2.0 * (0.25 - 0.15) / 10.0).epsilon(1e-15));
  CHECK(at(1e9).mu == Approx(0.10).epsilon(1e-15));
}

TEST_CASE("Renard's coefficient keeps its digits beside a minimum of 0") {
  const Renard law = renard({0.15, 0.10, 0.25, 0.0, 10.0, 100.0});
  const auto mu = [&](double v) { return evaluate(law, Ambient{}, {.slip_rate = v}).mu; };
  for (const double apart : {0x1p-10, 0x1p-20, 0x1p-30}) {
    const double z = apart / 90.0;
    CHECK(mu(100.0 - apart) == Approx(0.25 * z * z * (3.0 - 2.0 * z)).epsilon(1e-14));
    const double t = 0.10 * apart * apart;
    CHECK(mu(100.0 + apart) == Approx(0.10 * t / (1.0 + t)).epsilon(1e-14));
  }
  // From the other side, and without an end.
  CHECK(mu(10.0 + 0x1p-10) == Approx(0.25).epsilon(1e-9));
  CHECK(mu(1e200) == 0.10);
}

TEST_CASE("Renard's last piece is constant where C2 = C4") {
  const Renard law = renard({0.15, 0.05, 0.25, 0.05, 10.0, 100.0});
  for (const double v : {100.0, 101.0, 1e3, 1e8}) {
    const CoefficientPoint point = evaluate(law, Ambient{}, {.slip_rate = v});
    CHECK(point.mu == 0.05);
    CHECK(point.to_slip_rate == 0.0);
  }
}

TEST_CASE("Renard's rules are quoted, and lenient lets pass those that mu can do without") {
  const auto broken = [](std::array<double, 6> c, RenardRules rules) {
    Renard law = renard(c);
    law.rules = rules;
    return std::string(law.violation().value_or("nothing"));
  };
  struct Breach {
    std::array<double, 6> c;
    std::string rule;
    bool needed;
  };
  const std::vector<Breach> breaches = {
      {{0.15, 0.10, 0.25, 0.05, 0.0, 100.0}, "C5 > 0 must hold", true},
      {{0.15, 0.10, 0.25, 0.05, -1.0, 100.0}, "C5 > 0 must hold", true},
      {{0.15, 0.10, 0.25, 0.05, 100.0, 100.0}, "C5 < C6 must hold", true},
      {{0.15, 0.04, 0.25, 0.05, 10.0, 100.0},
       "C4 <= C2 must hold, or mu has a pole beyond C6",
       true},
      {{0.26, 0.10, 0.25, 0.05, 10.0, 100.0}, "C1 <= C3 must hold", false},
      {{0.15, 0.26, 0.25, 0.05, 10.0, 100.0}, "C2 <= C3 must hold", false},
      {{0.15, 0.20, 0.25, 0.16, 10.0, 100.0}, "C4 <= C1 must hold", false},
      {{0.15, 0.10, 0.25, -0.05, 10.0, 100.0}, "C4 >= 0 must hold", false}};
  for (const Breach& breach : breaches) {
    CHECK(broken(breach.c, RenardRules::kStrict) == breach.rule);
    CHECK(broken(breach.c, RenardRules::kLenient) == (breach.needed ? breach.rule : "nothing"));
    Renard law = renard(breach.c);
    CHECK(law.leniences().empty());
    law.rules = RenardRules::kLenient;
    if (!breach.needed) {
      REQUIRE(law.leniences().size() == 1);
      CHECK(law.leniences()[0] == breach.rule);
    }
  }
  CHECK(broken({0.15, 0.10, 0.25, 0.05, 10.0, 100.0}, RenardRules::kStrict) == "nothing");
  CHECK(broken({0.1, 0.1, 0.1, 0.1, 10.0, 100.0}, RenardRules::kStrict) == "nothing");
  // However small the unit makes the numbers.
  CHECK(broken({0.0, 0.0, 0.25, 0.0, 1e-9, 1e-8}, RenardRules::kStrict) == "nothing");
  CHECK_FALSE(depends_on_slip_rate(renard({0.1, 0.1, 0.1, 0.1, 10.0, 100.0})));
}

TEST_CASE("the pressure is the contact force over the area") {
  GeneralizedViscous viscous{0.1, 1e-3, 0.0, 0.0, 0.0, 0.0, 0.0, {}};
  CHECK(needs_area(viscous));
  viscous.area = 4.0;
  CHECK_FALSE(needs_area(viscous));
  const CoefficientPoint point = evaluate(viscous, Ambient{}, {.contact_force = 100.0});
  CHECK(point.mu == Approx(0.125).epsilon(1e-15));
  CHECK(point.to_contact_force == Approx(2.5e-4).epsilon(1e-15));
  // A law that does not see the pressure needs no area.
  CHECK_FALSE(needs_area(GeneralizedViscous{0.1, 0.0, 0.2, 0.0, 0.0, 0.1, 0.0, {}}));
  CHECK_FALSE(needs_area(ModifiedDarmstad{0.1, 0.0, 0.2, 0.0, 0.3, 0.1, 0.0, {}}));
  CHECK(needs_area(ModifiedDarmstad{0.1, 1e-5, 0.2, 0.0, 0.3, 0.1, 0.0, {}}));
}

TEST_CASE("a coefficient that meets the floor of itself leaves it with its own slopes") {
  const FrictionLaw law = GeneralizedViscous{kCoefficientFloor, 1e-3, 0.02, 0.0, 0.0, 0.0, 0.0, {}};
  const CoefficientPoint point = evaluate(law, Ambient{}, {});
  CHECK(point.mu == kCoefficientFloor);
  CHECK(point.to_slip_rate == 0.02);
  CHECK(point.to_contact_force == 1e-3);
  CHECK_FALSE(is_clamped(law, Ambient{}, {}));
}

TEST_CASE("each number of a polynomial law says what it depends on and whether it has a bound") {
  struct Number {
    double GeneralizedViscous::*member;
    bool rate, force;
  };
  using L = GeneralizedViscous;
  CHECK(largest(L{}) == kCoefficientFloor);
  for (const auto& [member, rate, force] : {Number{&L::fric, false, false},
                                            {&L::c1, false, true},
                                            {&L::c2, true, false},
                                            {&L::c3, true, true},
                                            {&L::c4, false, true},
                                            {&L::c5, true, false},
                                            {&L::c6, false, false}}) {
    for (const double value : {-1.0, -1e-9, 1e-9, 1.0}) {
      L law;
      law.fric = 0.3;
      law.*member = value;
      CHECK(depends_on_slip_rate(law) == rate);
      CHECK(depends_on_contact_force(law) == force);
      if (rate || force) CHECK(std::isinf(largest(law)) == (value > 0.0));
      if (value < 0.0) CHECK(largest(law) == std::max(law.fric, kCoefficientFloor));
    }
  }
}

TEST_CASE("an exponential law depends on the rate by a factor and an exponent together") {
  using L = ModifiedDarmstad;
  for (const auto& [factor, exponent] :
       {std::pair{&L::c1, &L::c2}, {&L::c3, &L::c4}, {&L::c5, &L::c6}}) {
    L law;
    law.*factor = 0.1;
    CHECK_FALSE(depends_on_slip_rate(law));
    law.*exponent = 1.0;
    CHECK(depends_on_slip_rate(law));
    law.*factor = 0.0;
    CHECK_FALSE(depends_on_slip_rate(law));
  }
}

TEST_CASE("under a constant force a polynomial bends where it meets its floor") {
  const SlipLine line{.end = 100.0, .rate_at_zero = -2.0, .rate_per_slip = 0.5, .force = 10.0};
  const auto bend = [&](double slip, double fric, double c2, double c5) {
    SlipLine from = line;
    from.slip = slip;
    return next_bend(GeneralizedViscous{fric, 0.0, c2, 0.0, 0.0, c5, 0.0, {}}, from);
  };
  // V = -2 + x/2. Falling, and rising from below 0.
  CHECK(bend(4.0, 0.1, -0.02, 0.0) == Approx(14.0).epsilon(1e-14));
  CHECK(bend(4.0, -0.1, 0.02, 0.0) == Approx(14.0).epsilon(1e-14));
  CHECK(bend(14.0, 0.1, -0.02, 0.0) == kNoBend);
  // (V - 2)(V - 8)/100, and roots far apart: (V - 1e-9)(V - 8)/100.
  CHECK(bend(4.0, 0.16, -0.1, 0.01) == Approx(8.0).epsilon(1e-14));
  CHECK(bend(8.0, 0.16, -0.1, 0.01) == Approx(20.0).epsilon(1e-14));
  CHECK(bend(20.0, 0.16, -0.1, 0.01) == kNoBend);
  CHECK(bend(0.0, 8e-11, -0.08 - 1e-11, 0.01) - 4.0 == Approx(2e-9).epsilon(1e-5));
  CHECK(bend(4.0, 0.16, 0.1, 0.01) == kNoBend);
  CHECK(bend(4.0, 0.16, 0.0, 0.0) == kNoBend);
  // p = 10/4: 0.1 + (-0.04 + 0.008 p) V.
  CHECK(next_bend(GeneralizedViscous{0.1, 0.0, -0.04, 0.008, 0.0, 0.0, 0.0, 4.0}, line) ==
        Approx(14.0).epsilon(1e-14));
}

TEST_CASE("a coefficient below the floor is kept up, and its raw value told") {
  const FrictionLaw law = GeneralizedViscous{0.1, 0.0, -0.02, 0.0, 0.0, 0.0, 0.0, {}};
  const SlipArguments fast{.slip_rate = 6.0};
  const CoefficientPoint point = evaluate(law, Ambient{}, fast);
  CHECK(point.mu == kCoefficientFloor);
  CHECK(point.to_slip_rate == 0.0);
  CHECK(raw_coefficient(law, Ambient{}, fast) == Approx(-0.02).epsilon(1e-14));
  CHECK(is_clamped(law, Ambient{}, fast));
  CHECK_FALSE(is_clamped(law, Ambient{}, {.slip_rate = 4.9}));
  CHECK(has_floor(law));
  // The other laws have none, and a raw value like any other.
  const FrictionLaw decay = ExponentialDecay{0.3, 0.2, 0.1};
  CHECK_FALSE(has_floor(decay));
  CHECK_FALSE(is_clamped(ConstantCoefficient{0.0}, Ambient{}, fast));
  CHECK(raw_coefficient(decay, Ambient{}, fast) == evaluate(decay, Ambient{}, fast).mu);
}

TEST_CASE("an exponent that overflows names its coefficient and makes mu infinite") {
  const ModifiedDarmstad law{0.1, 1e-6, 0.5, 1e-4, 0.7, 0.1, 1.0, 1.0};
  CHECK(overflow(law, 700.0).empty());
  CHECK(std::isfinite(mu(law, 1.0, 700.0)));
  CHECK(overflow(law, 701.0) == "C6");
  CHECK(overflow(law, 1001.0) == "C4");
  CHECK(overflow(law, 1401.0) == "C2");
  CHECK(std::isinf(mu(law, 0.0, 701.0)));
  // A factor of 0 takes its exponent out.
  CHECK(overflow(ModifiedDarmstad{0.1, 0.0, 0.5, 0.0, 0.7, 0.0, 1.0, 1.0}, 1e9).empty());
  CHECK(overflow(kRenard, 1e300).empty());
  CHECK(std::isfinite(mu(kRenard, 0.0, 1e300)));
}

TEST_CASE("a law without bounds has them up to a rate at a pressure") {
  // dmu/dV = -0.02 + 0.0005 p - 0.004 V falls to -0.04 at V = 5, p = 0, and to -0.015 at p = 50.
  const FrictionLaw viscous = GeneralizedViscous{0.4, 0.0, -0.02, 5e-4, 0.0, -0.002, 0.0, 1.0};
  CHECK(std::isinf(steepest_weakening(viscous)));
  CHECK(coefficient_bounds(viscous, Ambient{}, 0.0, 5.0).steepest_weakening ==
        Approx(0.04).epsilon(1e-15));
  CHECK(coefficient_bounds(viscous, Ambient{}, 50.0, 5.0).steepest_weakening ==
        Approx(0.015).epsilon(1e-13));
  CHECK(coefficient_bounds(viscous, Ambient{}, 0.0, 5.0).largest == 0.4);
  // Beyond the rate at which the floor takes over, here (-20 + sqrt(3600))/4 = 10, nothing falls:
  // looked for a little before it.
  CHECK(coefficient_bounds(viscous, Ambient{}, 0.0, 50.0).steepest_weakening ==
        Approx(0.06).epsilon(1e-8));
  // Two exponentials: a slope that is steepest inside, where 4 e^-2V = e^-V: V = ln 4.
  const FrictionLaw darmstad = ModifiedDarmstad{0.5, 0.0, 0.0, 1e-3, -1.0, -0.1, -2.0, 1.0};
  const double v = std::log(4.0);
  CHECK(coefficient_bounds(darmstad, Ambient{}, 100.0, 9.0).steepest_weakening ==
        Approx(0.1 * std::exp(-v) - 0.2 * std::exp(-2.0 * v)).epsilon(1e-8));
  // What cannot fall, and what is bounded, says so without being asked for a place.
  CHECK(steepest_weakening(GeneralizedViscous{0.1, 0.0, 0.02, 5e-4, 0.0, 0.1, 0.0, 1.0}) == 0.0);
  CHECK(steepest_weakening(kRenard) == Approx(1.5 * 0.2 / 90.0).epsilon(1e-15));
}

TEST_CASE("an exponential law that falls to nothing bends where the floor holds it") {
  // exp(-V) = 1e-30.
  ModifiedDarmstad law;
  law.c5 = 1.0;
  law.c6 = -1.0;
  CHECK(law.next_bend({.end = 100.0, .rate_per_slip = 1.0, .force = 10.0}) ==
        Approx(30.0 * std::log(10.0)).epsilon(1e-12));
}

TEST_CASE("a coefficient that has overflown does not bend any more") {
  // exp(V) - exp(2 V - 352)/4 has an inflection at 352, where the law is infinite: 2 V > 700.
  const ModifiedDarmstad law{0.0, 0.0, 0.0, -0.25 * std::exp(-352.0), 2.0, 1.0, 1.0, 1.0};
  const SlipLine line{.slip = 351.0, .end = 354.0, .rate_per_slip = 1.0, .force = 1.0};
  CHECK(std::isinf(mu(law, 1.0, 351.0)));
  CHECK(law.next_bend(line) == kNoBend);
}

TEST_CASE("the raw coefficient of an exponential law is its coefficient above the floor") {
  const ModifiedDarmstad law = {0.3, 1e-3, -2.0, 2e-2, -1.0, 0.1, -0.5, 1.0};
  for (const double v : {0.0, 0.25, 2.0}) {
    CHECK(law.raw_coefficient(3.0, v) == Approx(mu(law, 3.0, v)).epsilon(1e-15));
  }
}

TEST_CASE("an exponential law without an exponent does not weaken with the rate") {
  using L = ModifiedDarmstad;
  for (const auto factor : {&L::c1, &L::c3, &L::c5}) {
    for (const double value : {-0.1, 0.1}) {
      L law;
      law.fric = 0.3;
      law.*factor = value;
      CHECK(law.steepest_weakening() == 0.0);
    }
  }
}

}  // namespace
