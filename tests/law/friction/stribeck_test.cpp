// SPDX-License-Identifier: Apache-2.0
#include "law/friction/stribeck.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include "law/friction/law_list.hpp"

namespace {

using namespace slipbench::law;

CoefficientPoint at(const FrictionLaw& law, double rate) {
  return evaluate(law, Ambient{}, {.slip_rate = rate});
}

TEST_CASE("Stribeck friction falls from rest to sliding and rises with the speed") {
  const Stribeck<> law{0.3, 0.2, 10.0, 2.0, 1e-4};
  CHECK(at(law, 0.0).mu == 0.3);
  CHECK(at(law, 0.0).to_slip_rate == Approx(1e-4).epsilon(1e-15));
  // 1/e of the difference is left at the Stribeck rate: 0.2 + 0.1/e + 1e-3.
  CHECK(at(law, 10.0).mu == Approx(0.23778794411714423).epsilon(1e-15));
  CHECK(at(law, 10.0).to_slip_rate == Approx(1e-4 - 0.02 * std::exp(-1.0)).epsilon(1e-14));
  CHECK(at(law, 1e4).mu == Approx(1.2).epsilon(1e-15));
}

TEST_CASE("Stribeck friction of exponent 1 without viscous part is the exponential decay") {
  const Stribeck<> law{0.3, 0.2, 20.0, 1.0, 0.0};
  const ExponentialDecay decay{0.3, 0.2, 0.05};
  for (double rate = 0.0; rate < 300.0; rate += 7.0) {
    CHECK(at(law, rate).mu == Approx(at(decay, rate).mu).epsilon(1e-15));
    // The decay's mu - kinetic cancels where the exponential has died out.
    CHECK(at(law, rate).to_slip_rate ==
          Approx(at(decay, rate).to_slip_rate).epsilon(1e-12).margin(1e-17));
  }
  // Found by a scan: the bounds of the decay.
  CHECK(largest(law) == largest(decay));
  CHECK(largest_growth(law) == largest_growth(decay));
  CHECK(steepest_weakening(law) == Approx(steepest_weakening(decay)).epsilon(1e-12));
}

TEST_CASE("the bounds and the bend of Stribeck friction are those of its formula") {
  const Stribeck<> law{0.3, 0.2, 10.0, 2.0, 0.0};
  // -mu' = 0.02 u exp(-u^2) with u = V/10 is steepest at the inflection u = 1/sqrt(2).
  CHECK(steepest_weakening(law) == Approx(0.02 * std::sqrt(0.5) * std::exp(-0.5)).epsilon(1e-12));
  CHECK(largest(law) == 0.3);
  CHECK(std::isinf(largest(Stribeck<>::example())));  // the viscous part has no end
  const SlipLine line{.end = 100.0, .rate_per_slip = 1.0, .force = 1.0};
  CHECK(next_bend(law, line) == Approx(10.0 * std::sqrt(0.5)).epsilon(1e-11));
  SlipLine behind = line;
  behind.slip = next_bend(law, line);
  CHECK(next_bend(law, behind) == kNoBend);
}

TEST_CASE("Stribeck friction refuses a kinetic coefficient above the static one") {
  CHECK(Stribeck<>{0.2, 0.3}.violation() == "'static' must not be below 'kinetic'");
  CHECK_FALSE(Stribeck<>{0.3, 0.3}.violation().has_value());
}

TEST_CASE("Stribeck friction takes exponents from 1 on, which is that of the decay") {
  const auto exponent = std::get<3>(Stribeck<>::fields());
  CHECK(exponent.key == "exponent");
  CHECK(exponent.bounds.contains(1.0));
  CHECK_FALSE(exponent.bounds.contains(std::nextafter(1.0, 0.0)));
}

}  // namespace
