// SPDX-License-Identifier: Apache-2.0
#include "law/table/table_cursor.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// Draws of one table and of a way through it.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}

  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(engine_); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// Ascending points, few and simple or many.
  std::vector<double> grid(int fewest) {
    std::vector<double> x{between(-3.0, 1.0)};
    const int count = fewest + below(below(8) == 0 ? 60 : 5);
    while (static_cast<int>(x.size()) < count) x.push_back(x.back() + between(1e-3, 2.0));
    return x;
  }
  double ordinate() {
    const double special[] = {0.0, -0.0, 1e300, -1e300};
    return below(8) == 0 ? special[below(4)] : between(-1.0, 2.0);
  }

 private:
  std::mt19937 engine_;
};

/// A table of one or two independents, the blocks of some ragged.
TableFunction draw_function(Draw& draw) {
  const bool held = draw.below(2) == 0;
  const Extrapolation extrapolation = held ? Extrapolation::kConstant : Extrapolation::kLinear;
  const int fewest = held ? 1 : 2;
  const std::vector<double> shared = draw.grid(fewest);
  Rows rows;
  if (draw.below(3) == 0) {
    for (const double x : shared) rows.push_back({draw.ordinate(), x});
    return make_function(rows, {kOverAccumulatedSlip}, 1, extrapolation);
  }
  const bool ragged = draw.below(4) == 0;
  for (const double y : draw.grid(fewest)) {
    for (const double x : ragged ? draw.grid(fewest) : shared) {
      rows.push_back({draw.ordinate(), x, y});
    }
  }
  return make_function(rows, {kOverAccumulatedSlip, kOverTemperature}, 1, extrapolation);
}

/// Where a way through a table goes next: on a little, to a knot or beside it, or anywhere.
double draw_argument(Draw& draw, const TableFunction& function, int k, double before) {
  const auto knots = function.table().knots(k);
  const double knot = knots[static_cast<std::size_t>(draw.below(static_cast<int>(knots.size())))];
  const double infinity = std::numeric_limits<double>::infinity();
  switch (draw.below(8)) {
    case 0:
      return knot;
    case 1:
      return std::nextafter(knot, draw.below(2) == 0 ? infinity : -infinity);
    case 2:
      return draw.between(knots.front() - 2.0, knots.back() + 2.0);
    case 3: {
      const double special[] = {infinity, -infinity, std::nan(""), 0.0, -0.0, 1e308};
      return special[draw.below(6)];
    }
    default:
      return before + draw.between(-0.1, 0.2);
  }
}

TEST_CASE("a table read along a way has the bits of each value alone") {
  int finite = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    INFO("seed " << seed);
    Draw draw(seed);
    const TableFunction function = draw_function(draw);
    TableCursor cursor(function);
    SlipArguments slip;
    Ambient ambient;
    for (int i = 0; i < 100; ++i) {
      INFO("value " << i);
      slip.accumulated_slip = draw_argument(draw, function, 0, slip.accumulated_slip);
      if (function.independents().size() == 2) {
        ambient.temperature = draw_argument(draw, function, 1, ambient.temperature);
      }
      const double expected = function.value(ambient, slip);
      const double found = cursor.value(ambient, slip);
      REQUIRE(std::isnan(found) == std::isnan(expected));
      if (!std::isnan(expected)) {
        REQUIRE(std::bit_cast<std::uint64_t>(found) == std::bit_cast<std::uint64_t>(expected));
      }
      if (std::isfinite(slip.accumulated_slip))
        ++finite;
      else
        slip.accumulated_slip = 0.0;
      if (!std::isfinite(ambient.temperature)) ambient.temperature = 0.0;
    }
  }
  CHECK(finite > 100000);
}

TEST_CASE("a table without independents is read as its number") {
  const TableFunction function = make_function({{0.25}}, {});
  TableCursor cursor(function);
  CHECK(cursor.value({}, {}) == 0.25);
  CHECK(cursor.value({}, {.slip_rate = 3.0}) == 0.25);
}

TEST_CASE("a cursor reads every kind of independent") {
  const std::array<double, 2> fields = {0.5, 0.25};
  Ambient ambient;
  ambient.position = {{.1, .2, .3, .4, .5, .6}};
  ambient.motion = {{-.1, -.2, -.3, -.4, -.5, -.6}};
  ambient.temperature = 0.9;
  ambient.fields = fields;
  const SlipArguments slip{.slip_rate = 0.15, .contact_force = 0.35, .accumulated_slip = 0.55};
  for (const Independent independent :
       {kOverSlipRate, kOverContactForce, kOverAccumulatedSlip, kOverTemperature, over_field(1),
        over_position(4), over_motion(2)}) {
    const TableFunction function = make_function({{-2, -2}, {2, 2}}, {independent});
    TableCursor cursor(function);
    CHECK(cursor.value(ambient, slip) == function.value(ambient, slip));
    CHECK(cursor.value(ambient, slip) == function.value(ambient, slip));
  }
}

}  // namespace
