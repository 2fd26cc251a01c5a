// SPDX-License-Identifier: Apache-2.0
#include "reference/tanh_friction.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;

TEST_CASE("regularised friction saturates at the limit and is odd") {
  const auto rows =
      evaluate("tanh_friction", {{0.2}, {100.0}, {0.5}}, {{0.0}, {0.5}, {-0.5}, {50.0}, {1e-9}});
  CHECK(rows[0][0] == 0.0);
  // tanh 1 to fifteen digits.
  CHECK(rows[1][0] == Approx(20.0 * 0.761594155955765).epsilon(1e-14));
  CHECK(rows[2][0] == -rows[1][0]);
  CHECK(rows[3][0] == 20.0);
  CHECK(rows[4][0] == Approx(20.0 * 2e-9).epsilon(1e-14));
}

TEST_CASE("regularised friction creeps under a load that Coulomb friction would hold") {
  // atanh(1/2) = ln(3)/2.
  const auto rows = evaluate("tanh_creep", {{0.2}, {100.0}, {0.5}, {10.0}, {3.0}}, {{2.0}, {7.0}});
  CHECK(rows[0] == std::vector<double>{0.0, 0.0});
  CHECK(rows[1][1] == Approx(0.25 * std::log(3.0)).epsilon(1e-14));
  CHECK(rows[1][0] == Approx(std::log(3.0)).epsilon(1e-14));
  CHECK(tanh_friction::force({20.0, 0.5}, rows[1][1]) == Approx(10.0).epsilon(1e-14));
  const std::vector<std::vector<double>> slips{{0.2}, {100.0}, {0.5}, {-20.0}, {0.0}};
  CHECK(tanh_friction::creep_violation(slips).value() ==
        "load must be below mu normal_force in magnitude, else there is no steady creep");
}
