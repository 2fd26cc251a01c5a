// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "reference/exponential_decay.hpp"
#include "reference/generalized_viscous.hpp"
#include "reference/modified_darmstad.hpp"
#include "reference/renard.hpp"
#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

namespace {

using Values = std::vector<std::vector<double>>;

struct Row {
  double pressure;
  double speed;
  std::string_view coefficient;
};

/// Over an area of 4 the normal force is four times the pressure.
constexpr double kArea = 4.0;

/// The coefficient at both signs of the speed equals the printed one.
void check_rows(std::string_view name, Values constants, const std::vector<Row>& rows) {
  constants.push_back({kArea});
  constants.push_back({1e-30});
  for (const Row& row : rows) {
    CAPTURE(row.pressure, row.speed);
    const double normal_force = kArea * row.pressure;
    const auto results =
        evaluate(name, constants, {{row.speed, normal_force}, {-row.speed, normal_force}});
    CHECK_THAT(results[0][0], printed(std::string(row.coefficient)));
    CHECK(results[0] == results[1]);
  }
}

/// The slopes by speed and by pressure are the central differences of the coefficient.
template <class Formula, class Constants>
void check_slopes(Formula formula, const Constants& constants, double pressure, double speed) {
  const double h = 1e-4 * speed;
  const double g = 1e-4 * pressure;
  const auto middle = formula(constants, pressure, speed);
  const double by_speed = (formula(constants, pressure, speed + h).value -
                           formula(constants, pressure, speed - h).value) /
                          (2.0 * h);
  const double by_pressure = (formula(constants, pressure + g, speed).value -
                              formula(constants, pressure - g, speed).value) /
                             (2.0 * g);
  // The differences' own error, h^2/6 times the third derivative, is below 1e-7 of the slope.
  CHECK(middle.speed_slope == Approx(by_speed).epsilon(1e-6));
  CHECK(middle.pressure_slope == Approx(by_pressure).epsilon(1e-6));
}

constexpr renard::Constants kRising{.static_coefficient = 0.15,
                                    .dynamic_coefficient = 0.18,
                                    .largest_coefficient = 0.3,
                                    .smallest_coefficient = 0.1,
                                    .speed_of_largest = 2.0,
                                    .speed_of_smallest = 10.0};

}  // namespace

TEST_CASE("the coefficient quadratic in pressure and speed has the printed values") {
  check_rows("generalized_viscous_coefficient", {{.12}, {-2e-4}, {-1e-4}, {1e-6}, {4e-7}, {5e-8}},
             {{0.0, 0.0, ".12"},
              {0.0, 500.0, ".0825"},
              {0.0, 1000.0, ".07"},
              {100.0, 750.0, ".132125"},
              {110.0, 0.0, ".10284"},
              {150.0, 958.3333333333334, ".19283680555555555"},
              {200.0, 1000.0, ".246"}});
  check_rows("generalized_viscous_coefficient", {{.1}, {.001}, {.02}, {.0005}, {1e-5}, {-.002}},
             {{0.0, 0.0, ".1"}, {10.0, 1.0, ".134"}, {20.0, 2.0, ".176"}, {50.0, 3.0, ".292"}});
}

TEST_CASE("the coefficient exponential in speed has the printed values") {
  check_rows("modified_darmstad_coefficient",
             {{.08}, {1e-6}, {-2e-3}, {-2e-4}, {-1e-3}, {.1}, {-5e-3}},
             {{0.0, 0.0, ".18"},
              {0.0, 500.0, ".08820849986238988"},
              {100.0, 750.0, ".075135745132264925"},
              {110.0, 0.0, ".1701"},
              {150.0, 958.3333333333334, ".07263358481254817"},
              {200.0, 1000.0, ".07137202838251536"}});
  check_rows("modified_darmstad_coefficient", {{.1}, {1e-5}, {-.5}, {.002}, {-1.0}, {.05}, {-2.0}},
             {{0.0, 0.0, ".15"},
              {10.0, 0.0, ".171"},
              {10.0, 1.0, "0.114730883644972"},
              {20.0, 2.0, "0.107800711038587"},
              {50.0, 3.0, "0.11068089844933"}});
}

TEST_CASE("the slopes by pressure and speed are the derivatives") {
  check_slopes(generalized_viscous::coefficient,
               generalized_viscous::Constants{.12, -2e-4, -1e-4, 1e-6, 4e-7, 5e-8}, 150.0, 700.0);
  check_slopes(modified_darmstad::coefficient,
               modified_darmstad::Constants{.08, 1e-6, -2e-3, -2e-4, -1e-3, .1, -5e-3}, 150.0,
               700.0);
}

TEST_CASE("a coefficient below the floor is given at the floor, and as the formula has it") {
  const auto row =
      evaluate("generalized_viscous_coefficient",
               {{0.1}, {0.0}, {-0.2}, {0.0}, {0.0}, {0.0}, {1.0}, {1e-30}}, {{2.0, 5.0}})[0];
  CHECK(row[0] == 1e-30);
  CHECK(row[1] == Approx(-0.3).epsilon(1e-15));
  CHECK(row[2] == -0.2);
}

TEST_CASE("without the parts of the pressure the exponential coefficient is the decay") {
  const modified_darmstad::Constants constants{.2, 0.0, 0.0, 0.0, 0.0, .2, -.015};
  CHECK_THAT(modified_darmstad::coefficient(constants, 7.0, 600.0).value,
             printed(".20002468196081735"));
  const exponential_decay::Decay decay{.4, .2, .015};
  for (const double speed : {0.0, 3.0, 50.0, 600.0}) {
    // Rounding of one sum in another order.
    CHECK(modified_darmstad::coefficient(constants, 7.0, speed).value ==
          Approx(exponential_decay::coefficient(decay, speed)).epsilon(1e-15));
  }
  CHECK_THAT(exponential_decay::coefficient({.4, .2, .02}, 40.0), printed(".2898657928"));
}

TEST_CASE("the rising, falling and recovering coefficient has the printed values") {
  const auto check = [](const Values& constants,
                        const std::vector<std::pair<double, std::string>>& rows) {
    for (const auto& [speed, coefficient] : rows) {
      CAPTURE(speed);
      const auto results = evaluate("renard_coefficient", constants, {{speed}, {-speed}});
      CHECK_THAT(results[0][0], printed(coefficient));
      CHECK(results[0] == results[1]);
    }
  };
  check({{.15}, {.10}, {.25}, {.05}, {10.0}, {100.0}, {1.0}}, {{0.0, ".15"},
                                                               {2.0, ".186"},
                                                               {5.0, ".225"},
                                                               {10.0, ".25"},
                                                               {32.5, ".21875"},
                                                               {55.0, ".15"},
                                                               {77.5, ".08125"},
                                                               {100.0, ".05"},
                                                               {101.0, ".05238095238095239"},
                                                               {105.0, ".07777777777777778"},
                                                               {110.0, ".09166666666666667"},
                                                               {150.0, ".09960317460317461"},
                                                               {300.0, ".09997501249375312"}});
  check({{.15}, {.18}, {.3}, {.1}, {2.0}, {10.0}, {1.0}}, {{0.0, ".15"},
                                                           {1.0, ".2625"},
                                                           {2.0, ".3"},
                                                           {4.0, ".26875"},
                                                           {6.0, ".2"},
                                                           {10.0, ".1"},
                                                           {11.0, "0.105925925925926"},
                                                           {15.0, "0.153333333333333"},
                                                           {20.0, "0.171111111111111"},
                                                           {100.0, "0.179876733436055"}});
}

TEST_CASE("the recovering coefficient is continuous with level joints and its slope is right") {
  CHECK(renard::coefficient(kRising, 0.0).slope == Approx(2.0 * (0.3 - 0.15) / 2.0).epsilon(1e-15));
  for (const double joint : {2.0, 10.0}) {
    const auto below = renard::coefficient(kRising, std::nextafter(joint, 0.0));
    const auto above = renard::coefficient(kRising, std::nextafter(joint, 1e3));
    // One spacing of the speed times a slope that is itself of that size.
    CHECK(below.value == Approx(above.value).epsilon(1e-15));
    CHECK(std::abs(below.slope) < 1e-14);
    CHECK(std::abs(above.slope) < 1e-14);
  }
  for (const double speed : {0.5, 1.5, 3.0, 6.0, 9.0, 12.0, 40.0}) {
    constexpr double kHalf = 1e-4;
    const double difference = (renard::coefficient(kRising, speed + kHalf).value -
                               renard::coefficient(kRising, speed - kHalf).value) /
                              (2.0 * kHalf);
    // Rounding of the values over the step, 1e-16/1e-4; the third derivative adds 1e-10.
    CHECK(renard::coefficient(kRising, speed).slope == Approx(difference).margin(1e-9));
  }
}

TEST_CASE("half of the recovery is reached at the distance that its constants say") {
  const double distance = renard::recovery_half_distance(kRising);
  CHECK(distance == Approx(3.535533905932738).epsilon(1e-15));
  CHECK(renard::coefficient(kRising, 10.0 + distance).value == Approx(0.14).epsilon(1e-14));
}

TEST_CASE("without a recovery the last piece is constant") {
  auto level = kRising;
  level.dynamic_coefficient = level.smallest_coefficient;
  for (const double speed : {10.0, 10.5, 1e6}) {
    CHECK(renard::coefficient(level, speed).value == 0.1);
  }
  CHECK(renard::coefficient(level, 20.0).slope == 0.0);
  CHECK(std::isinf(renard::recovery_half_distance(level)));
}

TEST_CASE("the unit of the recovering coefficient's constants matters and the factor carries it") {
  const auto check = [](double factor, double scale, double speed, double expected) {
    const auto row =
        evaluate("renard_coefficient",
                 {{.15}, {.18}, {.3}, {.1}, {2.0 * scale}, {10.0 * scale}, {factor}}, {{speed}})[0];
    // Printed to six decimals.
    CHECK(row[0] == Approx(expected).margin(5e-7));
  };
  // 11 m/s by constants in m/s, the same in mm/s beside them, and by constants led into mm/s.
  check(1.0, 1.0, 11.0, 0.105926);
  check(1e-3, 1.0, 11e3, 0.105926);
  check(1.0, 1e3, 11e3, 0.179999);

  auto in_mm = kRising;
  in_mm.speed_factor = 1e-3;
  for (const double speed : {0.5, 4.0, 14.0}) {
    CHECK(renard::coefficient(in_mm, 1e3 * speed).slope ==
          Approx(1e-3 * renard::coefficient(kRising, speed).slope).epsilon(1e-14));
  }
}

TEST_CASE("a recovering coefficient without an order of its speeds or with a pole is refused") {
  CHECK(renard::violation(Values{{.15}, {.18}, {.3}, {.1}, {10.0}, {10.0}, {1.0}}).value() ==
        "C5 must be below C6");
  CHECK(renard::violation(Values{{.15}, {.09}, {.3}, {.1}, {2.0}, {10.0}, {1.0}}).value() ==
        "C4 must not be above C2, else the last piece has a pole");
  CHECK_FALSE(renard::violation(Values{{.15}, {.1}, {.3}, {.1}, {2.0}, {10.0}, {1.0}}));
}
