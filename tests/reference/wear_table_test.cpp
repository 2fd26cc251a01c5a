// SPDX-License-Identifier: Apache-2.0
#include "reference/wear_table.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;

namespace {
const std::vector<std::vector<double>> kTable{
    {0.0, 1.0, 4.0}, {20.0, 120.0}, {100.0, 60.0, 40.0, 80.0, 50.0, 30.0}};
}

TEST_CASE("a table over slip and temperature gives the known forces and holds its ends") {
  const double points[][3] = {
      {0.5, 20, 80}, {0.5, 70, 72.5}, {2.5, 70, 45}, {10, 500, 30}, {0.25, -40, 90}};
  for (const auto& point : points) {
    const auto rows = evaluate("wear_table", kTable, {{point[0], point[1]}});
    CHECK(rows[0][0] == Approx(point[2]).epsilon(1e-14));
  }
  CHECK(evaluate("wear_table", {{1.0}, {20.0}, {7.0}}, {{5.0, 300.0}})[0][0] == 7.0);
}

TEST_CASE("a table over slip and temperature needs rising values and every force") {
  const auto broken = [](std::vector<std::vector<double>> values) {
    return wear_table::violation(values).value_or("");
  };
  CHECK(broken({{0, 1}, {20}, {1, 2, 3}}) ==
        "internal_contact_forces has 3 entries; slips times temperatures make 2");
  CHECK(broken({{0, 0}, {20}, {1, 2}}) == "slips must rise from entry to entry");
  CHECK(broken({{0, 1}, {20, 10}, {1, 2, 3, 4}}) == "temperatures must rise from entry to entry");
  CHECK(broken({{}, {20}, {}}) == "slips needs at least one entry");
  CHECK(broken(kTable).empty());
}
