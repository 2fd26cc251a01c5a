// SPDX-License-Identifier: Apache-2.0
// Defaults of a law that tells only its coefficient.
#include "law/friction/law_defaults.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "law/base/field.hpp"
#include "law/friction/law_list.hpp"

namespace {

using namespace slipbench::law;

/// Saturates with F_N and weakens with the temperature and the rate.
template <class Number = double>
struct Warm {
  Number cold{0.4}, softening{1e-3}, half{50.0};
  std::optional<Number> rest;
  static constexpr auto fields() {
    return std::tuple{Field{"cold", &Warm::cold, dimension::kNone, kPositive, true, ""},
                      Field{"softening", &Warm::softening, dimension::kNone, kPositive, true, ""},
                      Field{"half", &Warm::half, dimension::kForce, kPositive, true, ""},
                      Field{"rest", &Warm::rest, dimension::kNone, kPositive, false, ""}};
  }
  Number coefficient(const Number& rate, const Number& force, const Ambient& ambient) const {
    using std::exp;
    return rest.value_or(0.0) + (cold - softening * ambient.temperature) *
                                    exp(-rate * ambient.temperature) / (1.0 + force / half);
  }
};

/// Grows with F_N from 0.1 towards 0.4 over a force, and falls over a rate.
template <class Number = double>
struct Growing {
  Number half{50.0}, fast{2.0};
  static constexpr auto fields() {
    return std::tuple{Field{"half", &Growing::half, dimension::kForce, kPositive, true, ""},
                      Field{"fast", &Growing::fast, Dimension{0, 1, -1}, kPositive, true, ""}};
  }
  Number coefficient(const Number& rate, const Number& force) const {
    return 0.1 + 0.3 * force / (force + half) - 0.05 * rate / (rate + fast);
  }
};

/// Level, falling, level, rising, so that there is a kink of either sense; below 0 before its end.
template <class Number = double>
struct Broken {
  static constexpr auto fields() { return std::tuple{}; }
  Number coefficient(const Number& v) const {
    if (v < 1.0) return 0.3;
    if (v < 2.0) return 0.3 - 0.1 * (v - 1.0);
    if (v < 3.0) return 0.2;
    return 0.2 - 0.2 * (v - 3.0);
  }
};

TEST_CASE("a law of rate, force and temperature has its slopes and those to its numbers") {
  Warm<> law;
  law.rest = 0.05;
  Ambient ambient;
  ambient.temperature = 20.0;
  const SlipArguments slip{.slip_rate = 0.01, .contact_force = 50.0};
  const double part = 0.5 * std::exp(-0.2);
  const CoefficientPoint here = default_point(law, ambient, slip);
  CHECK(here.mu == Approx(0.05 + 0.38 * part).epsilon(1e-15));
  CHECK(here.to_slip_rate == Approx(-20.0 * 0.38 * part).epsilon(1e-14));
  CHECK(here.to_contact_force == Approx(-0.38 * part / 100.0).epsilon(1e-14));
  const auto to_numbers = default_to_numbers(law, ambient, slip);
  CHECK(to_numbers[0] == Approx(part).epsilon(1e-14));
  CHECK(to_numbers[1] == Approx(-20.0 * part).epsilon(1e-14));
  CHECK(to_numbers[2] == Approx(0.38 * part / 100.0).epsilon(1e-14));
  CHECK(to_numbers[3] == 1.0);
  law.rest.reset();
  CHECK(default_to_numbers(law, ambient, slip)[3] == 0.0);
}

TEST_CASE("the bends of a law are those at the temperature of the line, which bounds do not know") {
  Ambient ambient;
  ambient.temperature = 20.0;
  SlipLine line{.end = 1.0, .rate_per_slip = 1.0, .force = 1e-3, .force_per_slip = 1e-3};
  CHECK(default_next_bend(Warm<>{}, line) == kNoBend);  // cold: F_N/(1 + F_N/half) is concave
  ambient.temperature = 4.0;
  line.ambient = &ambient;
  line.force = 0.0;
  line.force_per_slip = 1e-6;  // far below `half`: x exp(-4 x) bends at x = 2/4
  CHECK(default_next_bend(Warm<>{}, line) == Approx(0.5).epsilon(1e-6));
  CHECK(std::isinf(default_largest(Warm<>{})));
  CHECK(std::isinf(default_steepest_weakening(Warm<>{})));
}

TEST_CASE("kinks part a limit where they turn it, and the floor holds it") {
  const Broken<> law;
  SlipLine line{.end = 10.0, .rate_per_slip = 1.0, .force = 1.0};
  // Concave at 1, convex at 2; concave at 3, convex on the floor at 4: where the sense changes.
  for (const double bend : {2.0, 4.0}) {
    line.slip = default_next_bend(law, line);
    CHECK(line.slip == Approx(bend).epsilon(1e-11));
  }
  CHECK(default_next_bend(law, line) == kNoBend);
  CHECK(default_point(law, {}, {.slip_rate = 5.0}).mu == kCoefficientFloor);
  CHECK(default_point(law, {}, {.slip_rate = 5.0}).to_slip_rate == 0.0);
  CHECK(default_largest(law) == 0.3);
  CHECK(default_steepest_weakening(law) == Approx(0.2).epsilon(1e-15));
}

TEST_CASE("a bound that is met at the largest rates, or from below, is a bound") {
  CHECK(default_largest(Stribeck<>{0.2, 0.2, 10.0, 2.0, 0.0}) == 0.2);
  CHECK(default_largest(Stribeck<>{0.3, 0.2, 10.0, 2.0, 0.0}) == 0.3);
  // Rises for ever, but where the scan ends, at 4e13, by 4e-3 only.
  CHECK(default_largest(Stribeck<>{0.3, 0.2, 10.0, 2.0, 1e-16}) == 0.3);
  CHECK(std::isinf(default_largest(Stribeck<>{0.3, 0.2, 10.0, 2.0, 1e-12})));
}

TEST_CASE("a bound is found whatever the unit of the rate") {
  // The steepest fall of exp(-x^2) is sqrt(2/e), at x = sqrt(1/2).
  for (const double fast : {1e-30, 1e-16, 10.0, 1e30}) {
    const Stribeck<> law{0.3, 0.2, fast, 2.0, 0.0};
    CHECK(default_steepest_weakening(law) * fast ==
          Approx(0.1 * std::sqrt(2.0 / std::numbers::e)).epsilon(1e-12));
  }
}

TEST_CASE("a coefficient that grows towards a bound with the force is drawn and bounded") {
  const LawRange range = default_range(Growing<>{});
  CHECK(range.slip_rate == 8.0);
  CHECK(range.contact_force == 200.0);
  // Met at rest, and at any rate.
  for (const double fast : {2.0, 1e30}) {
    CHECK(default_largest(Growing<>{50.0, fast}) == Approx(0.4).epsilon(1e-9));
  }
}

}  // namespace
