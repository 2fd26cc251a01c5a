// SPDX-License-Identifier: Apache-2.0
#include "reference/helical_slip.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "reference/varying_overlap.hpp"
#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

namespace {

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-13); }

const std::vector<std::vector<double>> kShock{{0.15}, {0.24}, {0.55}, {0.0}};
const std::vector<std::vector<double>> kTable{
    {0.55}, {0.0, 0.45}, {2.0 / 0.55, 2.0 / 0.10}, {0.0}, {0.0}};

}  // namespace

TEST_CASE("a shaft that slides and turns has the printed force, moment and power") {
  const auto rows = evaluate(helical_slip::kForm, kShock,
                             {{0.3, 1.25, 300, 400, 55, 0},
                              {-0.3, 0.0, 300, 400, 55, 0},
                              {0.0, 0.0, 300, 400, 55, 0},
                              {0.3, -1.25, -300, 400, 0, -55}});
  CHECK_THAT(rows[0][0], printed("74.2462120245875"));
  CHECK_THAT(rows[0][1], printed("17.819090885901"));
  CHECK(rows[0][2] == exact(105.0));
  CHECK_THAT(rows[0][3], printed("0.424264068711929"));
  CHECK_THAT(rows[0][4], printed("44.5477272147525"));
  CHECK(rows[1][0] == exact(-105.0));
  CHECK(rows[1][1] == 0.0);
  CHECK(rows[2] == std::vector<double>{0.0, 0.0, rows[0][2], 0.0, 0.0});
  CHECK(rows[3][0] == exact(rows[0][0]));
  CHECK(rows[3][1] == exact(-rows[0][1]));
}

TEST_CASE("the terms of a shaft's contact force add after each square root") {
  const contact_force::Cylindrical joint{0.55, 0.0};
  const double shear = contact_force::cylindrical(joint, 3.0, 4.0, 0.0, 0.0);
  const double bending = contact_force::cylindrical(joint, 0.0, 0.0, 5.0, 12.0);
  CHECK(shear == exact(5.0));
  CHECK(bending == exact(2.0 / 0.55 * 13.0));
  CHECK(contact_force::cylindrical(joint, 3.0, 4.0, 5.0, 12.0) == exact(shear + bending));
}

TEST_CASE("rotation frees the axial direction of a shaft") {
  for (const double spin : {0.5, 2.0, 10.0}) {
    const auto row = evaluate(helical_slip::kForm, kShock, {{0.3, spin, 300, 400, 55, 0}}).back();
    const double ratio = 0.24 * spin / 0.3;
    CHECK(row[0] == exact(105.0 / std::sqrt(1.0 + ratio * ratio)));
    CHECK(std::hypot(row[0], row[1] / 0.24) == exact(105.0));
  }
}

TEST_CASE("a two-point weight over-predicts the bending share in mid span by the printed amount") {
  const auto rows = evaluate(varying_overlap::kForm, kTable,
                             {{0.225, 300, 400, 55, 0},
                              {0.45, 300, 400, 55, 0},
                              {1.0, 300, 400, 55, 0},
                              {-1.0, 300, 400, 55, 0},
                              {0.55, 300, 400, 0, 0}});
  CHECK_THAT(rows[0][2], printed("11.8181818181818"));
  CHECK(rows[0][0] == exact(1150.0));
  CHECK_THAT(rows[0][3], printed("6.15384615384615"));
  CHECK(rows[0][1] == exact(500.0 + 55.0 * 6.15384615384615));
  CHECK_THAT(100.0 * (rows[0][2] / rows[0][3] - 1.0), printed("92"));
  CHECK(rows[1][0] == exact(rows[1][1]));
  CHECK(rows[2][2] == exact(20.0));
  CHECK(std::isinf(rows[2][1]));
  CHECK(rows[3][2] == exact(2.0 / 0.55));
  CHECK(rows[4][1] == exact(500.0));
}

TEST_CASE(
    "a weight's table is held beyond its ends or extended straight, and has the printed limits") {
  auto table = kTable;
  table[2] = {3.636364, 20.0};
  const auto limit = [&](double position) {
    return 0.15 * evaluate(varying_overlap::kForm, table, {{position, 100, 50, 10, 5}}).back()[0];
  };
  CHECK_THAT(limit(0.225), printed("36.5902"));
  CHECK_THAT(limit(0.45), printed("50.3115"));
  CHECK_THAT(limit(1.0), printed("50.3115"));
  table[4] = {1.0};
  CHECK(limit(0.9) ==
        exact(0.15 * (std::hypot(100.0, 50.0) + (2.0 * 20.0 - 3.636364) * std::hypot(10.0, 5.0))));
  CHECK(limit(-5.0) == exact(0.15 * std::hypot(100.0, 50.0)));
  table[1] = {0.0};
  CHECK(varying_overlap::kForm.violation(table).has_value());
  table[1] = {0.45, 0.0};
  CHECK(varying_overlap::kForm.violation(table).has_value());
  table[1] = {0.3};
  table[2] = {7.0};
  CHECK(evaluate(varying_overlap::kForm, table, {{9.0, 0, 0, 1, 0}}).back()[2] == 7.0);
}
