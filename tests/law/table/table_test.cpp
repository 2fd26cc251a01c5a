// SPDX-License-Identifier: Apache-2.0
#include "law/table/table.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <vector>

#include "tests/support/law_tables.hpp"

namespace {

using slipbench::law::Extrapolation;
using slipbench::law::Table;
using slipbench::law::TableError;
using slipbench::test::make_table;
using slipbench::test::Rows;

double at(const Table& table, std::vector<double> x, int column = 0) {
  return table.value(x, column);
}

/// The error of rows that must not make a table.
TableError error_of(const Rows& rows, int dependents, int independents,
                    Extrapolation extrapolation = Extrapolation::kConstant) {
  Table table;
  TableError error;
  REQUIRE_FALSE(Table::build(rows, dependents, independents, extrapolation, &table, &error));
  return error;
}

/// Internal contact force over slip and temperature of reference case W3.
Table press_fit() {
  return make_table(
      {{100, 0, 20}, {60, 1, 20}, {40, 4, 20}, {80, 0, 120}, {50, 1, 120}, {30, 4, 120}}, 1, 2);
}

TEST_CASE("a table of two independents interpolates inside blocks, then between them (W3)") {
  const Table table = press_fit();
  CHECK(at(table, {0.5, 20}) == Approx(80).epsilon(1e-15));
  CHECK(at(table, {0.5, 70}) == Approx(72.5).epsilon(1e-15));
  CHECK(at(table, {2.5, 70}) == Approx(45).epsilon(1e-15));
  CHECK(at(table, {10, 500}) == 30);
  CHECK(at(table, {0.25, -40}) == Approx(90).epsilon(1e-15));
}

TEST_CASE("the cell of a point says between which grid points its value lies") {
  using Place = slipbench::law::TableInterval::Place;
  const Table table = press_fit();
  const std::array<double, 2> inside = {2.5, 70};
  const slipbench::law::TableCell cell = table.cell(inside);
  CHECK(cell.independents == 2);
  CHECK(cell.along[0].lower == 1);
  CHECK(cell.along[0].upper == 4);
  CHECK(cell.along[0].fraction == 0.5);
  CHECK(cell.along[1].lower == 20);
  CHECK(cell.along[1].upper == 120);
  CHECK(cell.along[1].fraction == 0.5);
  CHECK(cell.along[1].place == Place::kInside);
  CHECK_FALSE(cell.ragged);

  const std::array<double, 2> outside = {10, -40};
  const slipbench::law::TableCell held = table.cell(outside);
  CHECK(held.along[0].place == Place::kAbove);
  CHECK(held.along[0].fraction == 1.0);
  CHECK(held.along[1].place == Place::kBelow);
  CHECK(held.along[1].fraction == 0.0);

  const Table prolonged = make_table({{1, 0}, {2, 1}, {4, 2}}, 1, 1, Extrapolation::kLinear);
  const std::array<double, 1> beyond = {3.0};
  CHECK(prolonged.cell(beyond).along[0].place == Place::kAbove);
  CHECK(prolonged.cell(beyond).along[0].fraction == 2.0);
  CHECK(prolonged.cell(beyond).along[0].upper == 2.0);
}

TEST_CASE("a cell between blocks of different grids is that of the nearer one, and says so") {
  const Table table = make_table({{1, 0, 0}, {2, 10, 0}, {1, 0, 1}, {2, 4, 1}, {3, 10, 1}}, 1, 2);
  const std::array<double, 2> near_second = {3.0, 0.75};
  CHECK(table.cell(near_second).ragged);
  CHECK(table.cell(near_second).along[0].upper == 4.0);
  const std::array<double, 2> on_first = {3.0, 0.0};
  CHECK_FALSE(table.cell(on_first).ragged);
  CHECK(table.cell(on_first).along[0].upper == 10.0);
}

TEST_CASE("a table is exact at its grid points") {
  const Table table = press_fit();
  for (const auto& row : Rows{{100, 0, 20}, {60, 1, 20}, {40, 4, 20}, {50, 1, 120}, {30, 4, 120}}) {
    CHECK(at(table, {row[1], row[2]}) == row[0]);
  }
}

TEST_CASE("weights over position interpolate linearly between two points (D7)") {
  const Table table = make_table({{2 / 0.55, 0}, {2 / 0.10, 0.45}}, 1, 1);
  CHECK(at(table, {0.225}) == Approx(11.8181818181818).epsilon(1e-14));
  CHECK(at(table, {1.0}) == 20.0);
  const Table prolonged =
      make_table({{2 / 0.55, 0}, {2 / 0.10, 0.45}}, 1, 1, Extrapolation::kLinear);
  CHECK(at(prolonged, {0.9}) == Approx(40 - 2 / 0.55).epsilon(1e-14));
  CHECK(at(prolonged, {-0.45}) == Approx(4 / 0.55 - 20).epsilon(1e-14));
}

TEST_CASE("a table without independents is a number") {
  const Table table = make_table({{7.5}}, 1, 0);
  CHECK(at(table, {}) == 7.5);
  CHECK(table.independents() == 0);
}

TEST_CASE("blocks of a ragged table keep their own grids") {
  // The block at 0 has three points, that at 10 one, that at 20 two others.
  const Table table =
      make_table({{1, 0, 0}, {3, 1, 0}, {4, 3, 0}, {10, 5, 10}, {20, 2, 20}, {40, 4, 20}}, 1, 2);
  CHECK(at(table, {2, 0}) == 3.5);
  CHECK(at(table, {2, 10}) == 10);
  CHECK(at(table, {3, 20}) == 30);
  CHECK(at(table, {2, 5}) == 0.5 * (3.5 + 10));
  CHECK(at(table, {3, 15}) == 0.5 * (10 + 30));
  const std::vector<double> expected = {0, 1, 2, 3, 4, 5};
  CHECK(std::vector<double>(table.knots(0).begin(), table.knots(0).end()) == expected);
}

TEST_CASE("a later independent may repeat with another grid below a higher one") {
  // Three independents, ragged on every level: at z = 1 there is only one y.
  const Table table = make_table({{1, 0, 0, 0}, {2, 1, 0, 0}, {5, 0, 2, 0}, {9, 7, 3, 1}}, 1, 3);
  CHECK(at(table, {0.5, 0, 0}) == 1.5);
  CHECK(at(table, {0.5, 1, 0}) == 0.5 * (1.5 + 5));
  CHECK(at(table, {0.5, 1, 1}) == 9);
  CHECK(at(table, {0.5, 1, 0.5}) == 0.5 * (0.5 * (1.5 + 5) + 9));
}

TEST_CASE("a table of multilinear data is reproduced for any number of independents") {
  for (int independents = 1; independents <= 7; ++independents) {
    // f = product over k of (1 + c_k x_k), with a grid of two points a dimension.
    const auto exact = [&](const std::vector<double>& x) {
      double product = 1.0;
      for (int k = 0; k < independents; ++k) {
        product *= 1.0 + 0.1 * (k + 1) * x[static_cast<std::size_t>(k)];
      }
      return product;
    };
    Rows rows;
    for (int corner = 0; corner < (1 << independents); ++corner) {
      std::vector<double> x;
      x.reserve(static_cast<std::size_t>(independents));
      for (int k = 0; k < independents; ++k) x.push_back(((corner >> k) & 1) != 0 ? 3.0 : 1.0);
      std::vector<double> row = {exact(x), 2.0 * exact(x)};
      row.insert(row.end(), x.begin(), x.end());
      rows.push_back(row);
    }
    const Table table = make_table(rows, 2, independents, Extrapolation::kLinear);
    std::vector<double> x;
    x.reserve(static_cast<std::size_t>(independents));
    for (int k = 0; k < independents; ++k) x.push_back(0.7 + 0.45 * k);  // some lie outside
    // Rounding of 2^7 products dominates.
    CHECK(at(table, x) == Approx(exact(x)).epsilon(1e-13));
    CHECK(at(table, x, 1) == Approx(2.0 * exact(x)).epsilon(1e-13));

    std::vector<double> slopes(x.size(), 0.0);
    table.value_and_slopes(x, slopes, 1, 0.5);
    for (int k = 0; k < independents; ++k) {
      const double c = 0.1 * (k + 1);
      const double expected = exact(x) / (1.0 + c * x[static_cast<std::size_t>(k)]) * c;
      CHECK(slopes[static_cast<std::size_t>(k)] == Approx(expected).epsilon(1e-12));
    }
  }
}

TEST_CASE("outside a table the end value holds by default, with slope zero") {
  const Table table = make_table({{1, 0}, {3, 1}}, 1, 1);
  for (const double x : {-1e300, -1.0, 1.0, 5.0, 1e300}) {
    std::array<double, 1> slope = {0.0};
    const double value = table.value_and_slopes(std::array{x}, slope);
    CHECK(value == (x < 0.5 ? 1.0 : 3.0));
    CHECK(slope[0] == 0.0);
  }
  CHECK(table.outside(std::array{-0.1}));
  CHECK(table.outside(std::array{1.1}));
  CHECK_FALSE(table.outside(std::array{0.0}));
  CHECK_FALSE(table.outside(std::array{1.0}));
}

TEST_CASE("the slope at a knot is the right-hand one") {
  const Table constant = make_table({{0, 0}, {1, 1}, {3, 2}}, 1, 1);
  const Table linear = make_table({{0, 0}, {1, 1}, {3, 2}}, 1, 1, Extrapolation::kLinear);
  const auto slope = [](const Table& table, double x) {
    std::array<double, 1> s = {0.0};
    table.value_and_slopes(std::array{x}, s);
    return s[0];
  };
  CHECK(slope(constant, 0) == 1);
  CHECK(slope(constant, 1) == 2);
  CHECK(slope(constant, 2) == 0);
  CHECK(slope(linear, -1) == 1);
  CHECK(slope(linear, 1) == 2);
  CHECK(slope(linear, 2) == 2);
  CHECK(slope(linear, 9) == 2);
}

TEST_CASE("slopes are added with their weight") {
  const Table table = make_table({{0, 0}, {1, 1}}, 1, 1);
  std::array<double, 1> slope = {10.0};
  table.value_and_slopes(std::array{0.5}, slope, 0, 3.0);
  CHECK(slope[0] == 13.0);
}

TEST_CASE("a long table finds its segment like a short one") {
  Rows rows;
  for (int i = 0; i < 100; ++i)
    rows.push_back({static_cast<double>(i * i), static_cast<double>(i)});
  const Table table = make_table(rows, 1, 1);
  for (int i = 0; i < 99; ++i) {
    CHECK(at(table, {static_cast<double>(i)}) == i * i);
    CHECK(at(table, {i + 0.5}) == i * i + i + 0.5);
  }
  CHECK(at(table, {98.999999}) < 9801.0);
  CHECK(at(table, {1000}) == 9801.0);
}

TEST_CASE("smallest, largest and steepest fall look at all rows") {
  const Table table = press_fit();
  CHECK(table.smallest() == 30);
  CHECK(table.largest() == 100);
  CHECK(table.steepest_fall(0) == -40);
  CHECK(table.steepest_fall(1) == Approx(-0.2).epsilon(1e-15));
  CHECK(make_table({{1, 0}, {2, 1}}, 1, 1).steepest_fall(0) == 0.0);
}

TEST_CASE("of equal falls and growths the first is told") {
  const Table table = make_table({{9, 0}, {7, 1}, {8, 2}, {6, 3}, {6, 4}}, 1, 1);
  double knot = -1.0;
  CHECK(table.steepest_fall(0, 0, &knot) == -2.0);
  CHECK(knot == 0.0);
  knot = -1.0;
  CHECK(make_table({{1, 5}, {1, 6}, {1, 7}}, 1, 1).largest_growth(0, 0, &knot) == 1.0);
  CHECK(knot == 5.0);
  knot = -1.0;
  CHECK(make_table({{1, 5}, {2, 6}, {1, 7}}, 1, 1).largest_growth(0, 0, &knot) == 8.0);
  CHECK(knot == 5.0);
  CHECK(make_table({{0.1, 1}, {0.1, 5}, {0.3, 6}}, 1, 1).largest_growth(0, 0, &knot) ==
        Approx(0.3 + 6 * 0.2).epsilon(1e-14));
  CHECK(knot == 5.0);
}

TEST_CASE("a cell knows where its point lies, and whether any of its blocks is ragged") {
  using Place = slipbench::law::TableInterval::Place;
  const Table line = make_table({{1, 0}, {2, 1}, {4, 2}}, 1, 1);
  for (const auto& [x, place] : {std::pair{-0.1, Place::kBelow}, std::pair{0.0, Place::kInside},
                                 std::pair{2.0, Place::kInside}, std::pair{2.1, Place::kAbove}}) {
    CHECK(line.cell(std::array{x}).along[0].place == place);
  }
  // Three independents: at z = 0 the blocks are the same, at z = 1 they differ along x.
  const Table table = make_table({{1, 0, 0, 0},
                                  {2, 1, 0, 0},
                                  {1, 0, 1, 0},
                                  {2, 1, 1, 0},
                                  {1, 0, 0, 1},
                                  {2, 1, 0, 1},
                                  {1, 0, 1, 1},
                                  {2, 3, 1, 1}},
                                 1, 3);
  CHECK_FALSE(table.cell(std::array{0.5, 0.2, 0.0}).ragged);
  CHECK(table.cell(std::array{0.5, 0.2, 1.0}).ragged);
  CHECK(table.cell(std::array{0.5, 0.2, 0.3}).ragged);
}

TEST_CASE("rows that make no table are refused with the row, the other row and the column") {
  using Kind = TableError::Kind;
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(error_of({}, 1, 1).kind == Kind::kNoRows);

  const TableError length = error_of({{1, 0}, {2}}, 1, 1);
  CHECK(length.kind == Kind::kRowLength);
  CHECK(length.row == 1);

  const TableError finite = error_of({{1, 0}, {infinity, 1}}, 1, 1);
  CHECK(finite.kind == Kind::kNotFinite);
  CHECK(finite.row == 1);
  CHECK(finite.column == 0);
  CHECK(error_of({{1, std::nan("")}}, 1, 1).kind == Kind::kNotFinite);

  const TableError order = error_of({{1, 0, 5}, {2, 2, 5}, {3, 1, 5}}, 1, 2);
  CHECK(order.kind == Kind::kNotAscending);
  CHECK(order.row == 2);
  CHECK(order.other_row == 1);
  CHECK(order.column == 1);
  const TableError later = error_of({{1, 0, 5}, {2, 0, 4}}, 1, 2);
  CHECK(later.kind == Kind::kNotAscending);
  CHECK(later.column == 2);

  const TableError repeated = error_of({{1, 0, 5}, {2, 0, 5}}, 1, 2);
  CHECK(repeated.kind == Kind::kRepeatedPoint);
  CHECK(repeated.row == 1);
  CHECK(repeated.other_row == 0);
  CHECK(error_of({{1}, {2}}, 1, 0).kind == Kind::kRepeatedPoint);

  const TableError one = error_of({{1, 0, 0}, {2, 1, 0}, {3, 7, 1}}, 1, 2, Extrapolation::kLinear);
  CHECK(one.kind == Kind::kOneRowLinear);
  CHECK(one.row == 2);
  CHECK(one.other_row == -1);
  CHECK(one.column == 1);
  CHECK(error_of({{1, 0, 0}, {2, 1, 0}}, 1, 2, Extrapolation::kLinear).column == 2);

  std::vector<double> wide(static_cast<std::size_t>(slipbench::law::kMaxIndependents) + 2, 0.0);
  CHECK(error_of({wide}, 1, slipbench::law::kMaxIndependents + 1).kind ==
        Kind::kTooManyIndependents);

  // No two blocks share a point; with the same points there is one corner a row.
  const auto deep = [](int independents, double apart) {
    Rows rows;
    for (int row = 0; row < 1 << (2 * independents); ++row) {
      std::vector<double> items{0.1};
      for (int k = 0; k < independents; ++k) {
        const int place = row >> (2 * k);
        items.push_back((place & 3) + apart * (place >> 2));
      }
      rows.push_back(items);
    }
    return rows;
  };
  CHECK(error_of(deep(6, 1e-4), 1, 6).kind == Kind::kTooManyCorners);
  CHECK(make_table(deep(8, 0.0), 1, 8).rows() == 65536);
}

/// Rows of random blocks: each has points of its own, or those of all.
Rows random_rows(std::mt19937& random, int independents, bool same, bool single) {
  std::uniform_real_distribution<double> number(-1.0, 3.0);
  Rows rows;
  const auto fill = [&](auto& self, int k, std::vector<double> outer) -> void {
    if (k < 0) {
      outer.insert(outer.begin(), number(random));
      rows.push_back(outer);
      return;
    }
    std::uniform_int_distribution<int> count(single ? 1 : 2, 4);
    std::vector<double> points(static_cast<std::size_t>(same ? 3 : count(random)));
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = same ? static_cast<double>(i) : number(random);
    std::sort(points.begin(), points.end());
    for (const double point : points) {
      std::vector<double> all = outer;
      all.insert(all.begin(), point);
      self(self, k - 1, all);
    }
  };
  fill(fill, independents - 1, {});
  return rows;
}

TEST_CASE("steepest fall and largest growth are those over all combinations of points") {
  std::mt19937 random(20261127);
  for (int draw = 0; draw < 200; ++draw) {
    const int independents = 1 + draw % 4;
    const bool linear = draw % 3 == 0;
    const Table table =
        make_table(random_rows(random, independents, draw % 5 == 0, !linear), 1, independents,
                   linear ? Extrapolation::kLinear : Extrapolation::kConstant);
    const auto n = static_cast<std::size_t>(independents);
    std::vector<double> fall(n, 0.0);
    std::vector<double> growth(n, 0.0);
    std::vector<std::size_t> pick(n, 0);
    for (std::size_t j = 0; j < n;) {
      std::vector<double> x(n);
      std::vector<double> slopes(n, 0.0);
      for (std::size_t k = 0; k < n; ++k) x[k] = table.knots(static_cast<int>(k))[pick[k]];
      const double y = table.value_and_slopes(x, slopes);
      for (std::size_t k = 0; k < n; ++k) {
        const auto knots = table.knots(static_cast<int>(k));
        fall[k] = std::min(fall[k], slopes[k]);
        growth[k] = std::max({growth[k], y, y + x[k] * slopes[k]});
        if (pick[k] + 1 < knots.size()) {
          growth[k] = std::max(growth[k], y + (2.0 * knots[pick[k] + 1] - x[k]) * slopes[k]);
        }
      }
      for (j = 0; j < n && ++pick[j] == table.knots(static_cast<int>(j)).size();) pick[j++] = 0;
    }
    INFO("draw " << draw);
    // Rounding of differences of values over widths.
    for (std::size_t k = 0; k < n; ++k) {
      CHECK(table.steepest_fall(static_cast<int>(k)) == Approx(fall[k]).epsilon(1e-9));
      CHECK(table.largest_growth(static_cast<int>(k)) == Approx(growth[k]).epsilon(1e-9));
    }
  }
}

TEST_CASE("a refused table leaves the old one alone") {
  Table table = press_fit();
  TableError error;
  CHECK_FALSE(Table::build(Rows{}, 1, 1, Extrapolation::kConstant, &table, &error));
  CHECK(at(table, {0.5, 20}) == Approx(80).epsilon(1e-15));
}

TEST_CASE("the largest growth of y x is that of the steepest cell, at one of its ends") {
  // y falls from 0.4 to 0.2 over x = 10..20, then rises to 0.5 at x = 30: in the rising cell
  // d(y x)/dx = y + 0.03 x, largest at its far end: 0.5 + 0.9.
  const Table table = make_table({{0.4, 10}, {0.2, 20}, {0.5, 30}}, 1, 1);
  CHECK(table.largest_growth(0) == Approx(1.4).epsilon(1e-15));
  // A table that falls throughout grows fastest where it is flat: outside, with slope y.
  CHECK(make_table({{0.4, 10}, {0.2, 20}}, 1, 1).largest_growth(0) == 0.4);
  // Over another independent the worst row counts.
  const Table two = make_table({{0.1, 0, 1}, {0.2, 10, 1}, {0.1, 0, 2}, {0.4, 10, 2}}, 1, 2);
  CHECK(two.largest_growth(0) == Approx(0.4 + 10 * 0.03).epsilon(1e-15));
}

/// The weights of all rows at a point; those of rows that have no part are 0.
std::vector<double> weights(const Table& table, const std::vector<double>& x) {
  std::vector<double> all(table.rows(), 0.0);
  table.for_each_weight(x, [&](std::size_t row, double weight) {
    CHECK(weight != 0.0);
    all[row] += weight;
  });
  return all;
}

TEST_CASE("the weights of the rows make up the value, ragged or prolonged") {
  for (const Extrapolation extrapolation : {Extrapolation::kConstant, Extrapolation::kLinear}) {
    const Table table = make_table({{0.30, -5, 0, 20},
                                    {0.20, -6, 10, 20},
                                    {0.26, -7, 0, 90},
                                    {0.18, -8, 4, 90},
                                    {0.11, -9, 10, 90}},
                                   2, 2, extrapolation);
    for (const double x : {-3.0, 0.0, 2.5, 4.0, 9.0, 10.0, 30.0}) {
      for (const double y : {-10.0, 20.0, 55.0, 90.0, 120.0}) {
        const std::vector<double> all = weights(table, {x, y});
        double sum = 0.0;
        double values[2] = {0.0, 0.0};
        for (std::size_t r = 0; r < table.rows(); ++r) {
          sum += all[r];
          for (int c = 0; c < 2; ++c) values[c] += all[r] * table.ordinate(r, c);
        }
        // Rounding; prolonged weights are up to some 10.
        CHECK(sum == Approx(1.0).epsilon(1e-14));
        CHECK(values[0] == Approx(at(table, {x, y}, 0)).epsilon(1e-13).margin(1e-14));
        CHECK(values[1] == Approx(at(table, {x, y}, 1)).epsilon(1e-13));
      }
    }
  }
  const Table table = press_fit();
  CHECK(weights(table, {0.25, 20}) == std::vector<double>{0.75, 0.25, 0, 0, 0, 0});
  CHECK(weights(table, {9, 500}) == std::vector<double>{0, 0, 0, 0, 0, 1});
  CHECK(weights(make_table({{7}}, 1, 0), {}) == std::vector<double>{1});
}

TEST_CASE("rows are numbered as given, and their ordinates can be changed alone") {
  Table table = make_table({{0.30, 1, 0, 20}, {0.20, 2, 10, 20}, {0.26, 3, 0, 90}}, 2, 2);
  REQUIRE(table.rows() == 3);
  CHECK(table.ordinate(1) == 0.20);
  CHECK(table.ordinate(2, 1) == 3);
  CHECK(table.point(0) == std::vector<double>{0, 20});
  CHECK(table.point(1) == std::vector<double>{10, 20});
  CHECK(table.point(2) == std::vector<double>{0, 90});
  const Table before = table;
  table.set_ordinate(1, 0, 0.5);
  CHECK(at(table, {10, 20}) == 0.5);
  CHECK(at(table, {10, 20}, 1) == 2);
  CHECK(table.largest() == 0.5);
  CHECK(table.largest(1) == 3);
  table.set_ordinate(1, 0, 0.28);
  CHECK(table.largest() == 0.30);
  table.set_ordinate(0, 0, 0.1);
  CHECK(table.largest() == 0.28);
  CHECK(table.same_grid(before));
  CHECK_FALSE(
      table.same_grid(make_table({{0.3, 1, 0, 20}, {0.2, 2, 9, 20}, {0.2, 3, 0, 90}}, 2, 2)));
  CHECK_FALSE(table.same_grid(make_table({{0.3, 0, 20}, {0.2, 10, 20}, {0.2, 0, 90}}, 1, 2)));
  CHECK(Table().rows() == 0);
}

}  // namespace
