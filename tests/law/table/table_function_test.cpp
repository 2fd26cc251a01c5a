// SPDX-License-Identifier: Apache-2.0
#include "law/table/table_function.hpp"

#include <array>
#include <catch2/catch.hpp>

#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

const std::array<double, 3> kFields = {0.5, 0.25, 0.75};

Ambient somewhere() {
  Ambient ambient;
  ambient.position = {{.1, .2, .3, .4, .5, .6}};
  ambient.motion = {{-.1, -.2, -.3, -.4, -.5, -.6}};
  ambient.temperature = 0.9;
  ambient.fields = kFields;
  return ambient;
}
const SlipArguments kSlip{.slip_rate = 0.15, .contact_force = 0.35, .accumulated_slip = 0.55};

TEST_CASE("each kind of independent reads its own connector quantity") {
  // The identity table returns its argument.
  const auto read = [](Independent independent) {
    const auto f = make_function({{-2, -2}, {2, 2}}, {independent});
    return f.value(somewhere(), kSlip);
  };
  CHECK(read(kOverSlipRate) == Approx(0.15));
  CHECK(read(kOverContactForce) == Approx(0.35));
  CHECK(read(kOverAccumulatedSlip) == Approx(0.55));
  CHECK(read(kOverTemperature) == Approx(0.9));
  for (int i = 0; i < 3; ++i) {
    CHECK(read(over_field(i)) == Approx(kFields[static_cast<std::size_t>(i)]));
  }
  for (int number = 1; number <= 6; ++number) {
    CHECK(read(over_position(number)) == Approx(0.1 * number));
    CHECK(read(over_motion(number)) == Approx(-0.1 * number));
  }
}

TEST_CASE("slopes to slip quantities and to motions are told apart") {
  // f = 3 rate + 5 slip + 7 CP2 + 11 CU2 over the unit cube, linear in each.
  Rows rows;
  for (int corner = 0; corner < 16; ++corner) {
    const double r = corner & 1, s = (corner >> 1) & 1, p = (corner >> 2) & 1;
    const double m = (corner >> 3) & 1;
    rows.push_back({3 * r + 5 * s + 7 * p - 11 * m, r, s, p, -1 + m});
  }
  const auto f =
      make_function(rows, {kOverSlipRate, kOverAccumulatedSlip, over_position(2), over_motion(2)});
  SlipArguments slopes;
  const double value = f.value_and_slopes(somewhere(), kSlip, &slopes);
  CHECK(value == Approx(3 * .15 + 5 * .55 + 7 * .2 - 11 * .8).epsilon(1e-13));
  CHECK(f.value(somewhere(), kSlip) == value);
  CHECK(slopes.slip_rate == Approx(3).epsilon(1e-13));
  CHECK(slopes.accumulated_slip == Approx(5).epsilon(1e-13));
  CHECK(slopes.contact_force == 0.0);

  RelativePosition gradient{{1, 1, 1, 1, 1, 1}};
  f.add_motion_slopes(somewhere(), kSlip, 2.0, &gradient);
  CHECK(gradient[1] == Approx(1 + 2 * (7 - 11)).epsilon(1e-12));
  for (const int c : {0, 2, 3, 4, 5}) CHECK(gradient[c] == 1.0);
  CHECK(f.depends_on_motion());
}

TEST_CASE("a function may depend on as many quantities as a table can have") {
  std::vector<double> low(1 + kMaxIndependents, 0.0);
  std::vector<double> high = low;
  high[0] = 4.0;
  high[1] = 2.0;
  std::vector<Independent> independents;
  for (int i = 0; i < kMaxIndependents; ++i) independents.push_back(over_field(i));
  const auto f = make_function({low, high}, independents);
  const std::vector<double> fields(kMaxIndependents, 0.25);
  Ambient ambient;
  ambient.fields = fields;
  SlipArguments slopes;
  CHECK(f.value_and_slopes(ambient, kSlip, &slopes) == 0.5);
}

TEST_CASE("a function knows the columns of its independents") {
  const auto f =
      make_function({{1, 0, 0}, {2, 1, 0}, {3, 0, 1}}, {kOverTemperature, kOverAccumulatedSlip});
  CHECK(f.column_of(IndependentKind::kTemperature) == 0);
  CHECK(f.column_of(IndependentKind::kAccumulatedSlip) == 1);
  CHECK(f.column_of(IndependentKind::kSlipRate) == -1);
  CHECK_FALSE(f.depends_on_motion());
  RelativePosition gradient;
  f.add_motion_slopes(somewhere(), kSlip, 1.0, &gradient);
  CHECK(gradient == RelativePosition{});
}

TEST_CASE("a function says whether its arguments lie outside its table") {
  const auto f = make_function({{1, 0}, {2, 1}}, {over_position(1)});
  Ambient ambient;
  for (const auto& [x, expected] : {std::pair{-0.1, true}, std::pair{0.0, false},
                                    std::pair{1.0, false}, std::pair{1.1, true}}) {
    ambient.position[0] = x;
    CHECK(f.outside(ambient, {}) == expected);
  }
}

}  // namespace
