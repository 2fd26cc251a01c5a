// SPDX-License-Identifier: Apache-2.0
#include "law/friction/part_pairs.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <vector>

namespace slipbench::law {
namespace {

const std::vector<int> kG100{1, 2, 3};
const std::vector<int> kG200{4, 5};

/// The coefficient a table gives: one a record, and a default.
double coefficient(const std::vector<PartPair>& pairs, const std::vector<double>& mu,
                   double otherwise, int a, int b) {
  const std::optional<std::size_t> record = last_joining(pairs, a, b);
  return record ? mu[*record] : otherwise;
}

TEST_CASE("A later record refines an earlier one, and what no record joins takes the default") {
  const std::vector<PartPair> pairs{{kG100, kG200}, {{2}, {4}}};
  const std::vector<double> mu{0.2, 0.3};
  CHECK(coefficient(pairs, mu, 0.1, 2, 4) == 0.3);
  CHECK(coefficient(pairs, mu, 0.1, 4, 2) == 0.3);
  CHECK(coefficient(pairs, mu, 0.1, 1, 4) == 0.2);
  CHECK(coefficient(pairs, mu, 0.1, 1, 2) == 0.1);
  CHECK(coefficient(pairs, mu, 0.1, 6, 1) == 0.1);
}

TEST_CASE("Of the records of one pair the last wins, in whichever order it names the parts") {
  const std::vector<PartPair> pairs{{{1}, {2}}, {{2}, {1}}, {{1}, {2}}};
  CHECK(coefficient(pairs, {0.2, 0.3, 0.4}, 0.1, 1, 2) == 0.4);
  CHECK(coefficient(pairs, {0.2, 0.3, 0.4}, 0.1, 2, 1) == 0.4);
}

TEST_CASE("A group paired before a single part hides it") {
  const std::vector<PartPair> pairs{{{2}, {4}}, {kG100, kG200}};
  CHECK(last_joining(pairs, 2, 4) == std::size_t{1});
}

TEST_CASE("A group with itself is every pair inside it, each part with itself included") {
  const std::vector<PartPair> pairs{{kG100, kG100}};
  for (const int a : kG100) {
    for (const int b : kG100) CHECK(last_joining(pairs, a, b) == std::size_t{0});
  }
  CHECK_FALSE(last_joining(pairs, 1, 4));
  CHECK_FALSE(last_joining(pairs, 4, 4));
}

TEST_CASE("Two groups do not join the parts inside either") {
  const std::vector<PartPair> pairs{{kG100, kG200}};
  CHECK_FALSE(last_joining(pairs, 1, 1));
  CHECK_FALSE(last_joining(pairs, 4, 5));
}

TEST_CASE("Overlapping groups join a part of both with itself") {
  const std::vector<PartPair> pairs{{{1, 2}, {2, 3}}};
  CHECK(last_joining(pairs, 2, 2) == std::size_t{0});
  CHECK_FALSE(last_joining(pairs, 1, 1));
}

TEST_CASE("A table without records joins nothing") { CHECK_FALSE(last_joining({}, 1, 2)); }

TEST_CASE("The lookup is symmetric for every pair of parts") {
  const std::vector<PartPair> pairs{
      {kG100, kG200}, {kG200, kG200}, {{3}, kG100}, {{6}, {1}}, {{5, 6}, {2, 6}}};
  for (int a = 1; a <= 7; ++a) {
    for (int b = a; b <= 7; ++b) {
      INFO(a << " and " << b);
      CHECK(last_joining(pairs, a, b) == last_joining(pairs, b, a));
    }
  }
}

}  // namespace
}  // namespace slipbench::law
