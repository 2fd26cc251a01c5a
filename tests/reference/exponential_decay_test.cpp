// SPDX-License-Identifier: Apache-2.0
#include "reference/exponential_decay.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

TEST_CASE("a coefficient that decays with the slip rate has the printed values") {
  const double rates[] = {0.0, 1.0, 10.0, 50.0, 100.0};
  const char* coefficients[] = {"0.3", "0.295122942450071", "0.260653065971263", "0.20820849986239",
                                "0.200673794699909"};
  for (int i = 0; i < 5; ++i) {
    const auto rows =
        evaluate("exponential_decay", {{0.3}, {0.2}, {0.05}}, {{rates[i]}, {-rates[i]}});
    CHECK_THAT(rows[0][0], printed(coefficients[i]));
    CHECK(rows[0][0] == rows[1][0]);
  }
  CHECK(evaluate("exponential_decay", {{0.3}, {0.2}, {0.0}}, {{7.0}})[0][0] == 0.3);
}

TEST_CASE("test data give the printed decay, from three and from two points") {
  const auto three = exponential_decay::from_test_data(0.3, 0.23, 20.0, 0.2);
  CHECK_THAT(three.decay_coefficient, printed("0.0601986402162968"));
  const auto two = exponential_decay::from_test_data(0.3, 0.23, 20.0);
  CHECK_THAT(two.kinetic_coefficient, printed("0.226315789473684"));
  CHECK_THAT(two.decay_coefficient, printed("0.1497866136777"));

  const double absent = std::numeric_limits<double>::infinity();
  for (const double infinite : {0.2, absent}) {
    const auto rows = evaluate("exponential_decay_test_data", {{0.3}, {0.23}, {20.0}, {infinite}},
                               {{0.0}, {20.0}, {1e9}});
    CHECK(rows[0][0] == Approx(0.3).epsilon(1e-14));
    CHECK(rows[1][0] == Approx(0.23).epsilon(1e-14));
    CHECK(rows[2][0] == Approx(infinite == absent ? 0.226315789473684 : 0.2).epsilon(1e-14));
  }
}

TEST_CASE("test data that do not fall to mu_inf are refused") {
  const auto broken = [](std::vector<std::vector<double>> values) {
    return exponential_decay::test_data_violation(values).value_or("");
  };
  const double absent = std::numeric_limits<double>::infinity();
  CHECK(broken({{0.3}, {0.3}, {20}, {0.2}}) == "test_coefficient must be below static_coefficient");
  CHECK(broken({{0.3}, {0.23}, {20}, {0.23}}) ==
        "infinite_rate_coefficient must be below test_coefficient");
  CHECK_FALSE(broken({{0.3}, {0.01}, {20}, {absent}}).empty());
  CHECK(broken({{0.3}, {0.23}, {20}, {absent}}).empty());
}
