// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/branches.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

void check_branch(const Branch& branch, std::size_t first, std::size_t last, int direction) {
  CHECK(branch.first == first);
  CHECK(branch.last == last);
  CHECK(branch.direction == direction);
}

TEST_CASE("an abscissa is divided where it turns, and the turn belongs to both branches") {
  const auto parts = branches(std::vector<double>{0, 1, 2, 1, -1, -2, 0});
  REQUIRE(parts.size() == 3);
  check_branch(parts[0], 0, 2, 1);
  check_branch(parts[1], 2, 5, -1);
  check_branch(parts[2], 5, 6, 1);
}

TEST_CASE("a dwell belongs to the branch before it, at the start to the first") {
  const auto parts = branches(std::vector<double>{0, 0, 0, 1, 1, 1, 0, 0});
  REQUIRE(parts.size() == 2);
  check_branch(parts[0], 0, 5, 1);
  check_branch(parts[1], 5, 7, -1);
  const auto within = branches(std::vector<double>{0, 1, 1, 2});
  REQUIRE(within.size() == 1);
}

TEST_CASE("a dwell is one place though its abscissas differ by rounding") {
  const auto parts = branches(std::vector<double>{0.0, 1.0, 1.0 - 1e-16, 1.0 - 2e-16, 0.0});
  REQUIRE(parts.size() == 2);
  check_branch(parts[0], 0, 3, 1);
}

TEST_CASE("a turn below a billionth of the range is rounding, a larger one is a branch") {
  CHECK(branches(std::vector<double>{0, 1, 1 - 1e-10, 2, 3}).size() == 1);
  CHECK(branches(std::vector<double>{0, 1, 1 - 1e-8, 2, 3}).size() == 3);
  // The same in units a million times larger.
  CHECK(branches(std::vector<double>{0, 1e6, 1e6 - 1e-4, 2e6, 3e6}).size() == 1);
  CHECK(branches(std::vector<double>{0, 1e6, 1e6 - 1e-2, 2e6, 3e6}).size() == 3);
}

TEST_CASE("many small steps back are a turn all the same") {
  std::vector<double> slow{0.0, 1.0};
  for (int i = 1; i <= 1000; ++i) slow.push_back(1.0 - 1e-10 * i);
  const auto parts = branches(slow);
  REQUIRE(parts.size() == 2);
  check_branch(parts[0], 0, 1, 1);
}

TEST_CASE("a decreasing start, no motion, one row and no row") {
  const auto falling = branches(std::vector<double>{3, 2, 4});
  REQUIRE(falling.size() == 2);
  check_branch(falling[0], 0, 1, -1);
  const auto still = branches(std::vector<double>{2, 2, 2});
  REQUIRE(still.size() == 1);
  check_branch(still[0], 0, 2, 1);
  CHECK(branches(std::vector<double>{5}).size() == 1);
  CHECK(branches({}).empty());
}

TEST_CASE("matched curves begin and end at the same places") {
  const Series result = slider(zigzag({0, 0.1, -0.1, 0.1}, 7));
  const Series reference = slider(zigzag({0.05, 0.1, -0.1, 0.033}, 5), 20.0);
  const MatchedBranches matched = match_branches(result, reference);
  REQUIRE(matched.fault.empty());
  CHECK(matched.result.abscissa.front() == Approx(0.05));
  CHECK(matched.result.abscissa.back() == Approx(0.033));
  CHECK(matched.result.value.front() == Approx(20.0));
  CHECK(matched.reference.abscissa == reference.abscissa);
  REQUIRE(matched.result_branches.size() == 3);
  const auto turn = matched.result_branches[1].first;
  CHECK(matched.result_branches[0].first == 0);
  CHECK(matched.result_branches[0].last == turn);
  CHECK(matched.result.abscissa[turn] == 0.1);
  CHECK(matched.result.abscissa[matched.result_branches[2].first] == -0.1);
  CHECK(matched.result_branches[2].last == matched.result.size() - 1);
}

TEST_CASE("a common part between two rows of the result is found") {
  const Series result = slider({0.0, 1.0});
  const Series reference = slider({0.25, 0.5, 0.75});
  const MatchedBranches matched = match_branches(result, reference);
  REQUIRE(matched.fault.empty());
  CHECK(matched.result.abscissa == std::vector<double>{0.25, 0.75});
  CHECK(matched.result_branches.front().last == 1);
}

TEST_CASE("curves of different branches or opposite directions do not match") {
  const Series two = slider(zigzag({0, 0.1, -0.1}, 5));
  const Series three = slider(zigzag({0, 0.1, -0.1, 0.1}, 5));
  const std::string fault = match_branches(two, three).fault;
  CHECK_THAT(fault, Catch::Contains("the result has 2 branches, the reference 3 branches"));
  CHECK_THAT(fault, Catch::Contains("arc_length"));
  const Series other = slider(zigzag({0, -0.1, 0.1}, 5));
  CHECK_THAT(match_branches(two, other).fault, Catch::Contains("opposite directions"));
  const Series below = slider(zigzag({-0.1, -0.05, -0.1}, 5));
  const Series inside = slider(zigzag({-0.07, 0.1, -0.08}, 5));
  CHECK(match_branches(inside, below).fault.empty());
  const Series late = slider(zigzag({0.2, 0.3, -0.1}, 5));
  CHECK_THAT(match_branches(two, late).fault,
             Catch::Contains("the first branches have no part in common"));
}

TEST_CASE("last branches that do not meet are a fault") {
  const Series result = slider(zigzag({0, 0.1, 0}, 5));
  const Series reference = slider(zigzag({0, 0.12, 0.11}, 5));
  CHECK_THAT(match_branches(result, reference).fault,
             Catch::Contains("the last branches have no part in common"));
  CHECK_THAT(match_branches(reference, result).fault,
             Catch::Contains("the last branches have no part in common"));
}

TEST_CASE("turns that the printed digits of an abscissa explain are none") {
  // A dwell at 0.1 printed with seven digits.
  const std::vector<double> printed{0.0, 0.1, 0.09999999, 0.1, 0.09999998, 0.1, -0.1};
  CHECK(branches(printed).size() == 6);
  const auto parts = branches(printed, 1e-7);
  REQUIRE(parts.size() == 2);
  check_branch(parts[0], 0, 5, 1);
  check_branch(parts[1], 5, 6, -1);
  // Round numbers look as if they had one digit: their turns are turns.
  CHECK(branches(std::vector<double>{0, 0.1, -0.1, 0.1}, 0.1).size() == 3);
  CHECK(branches(std::vector<double>{0, 0.1, 0.0997, 0.1}, 0.1).size() == 3);
}

TEST_CASE("turns that the reference cannot show are none of the result") {
  Series reference = slider(zigzag({0, 0.1, -0.1}, 20));
  const Series result = slider({0, 0.05, 0.1, 0.1 - 3e-8, 0.1, -0.1});
  const std::string fault = match_branches(result, reference).fault;
  CHECK_THAT(fault, Catch::Contains("the result has 4 branches, the reference 2 branches"));
  CHECK_THAT(fault, Catch::Contains("turns by 3e-08 may be noise, only those up to 2e-10 were"));
  reference.noise = 1e-7;
  CHECK(match_branches(result, reference).fault.empty());
}

TEST_CASE("times of a reference that decrease are named") {
  Series result = sampled({0, 1, 2, 3}, [](double t) { return t; });
  result.time = result.abscissa;
  const Series reference = sampled({0, 2, 1, 3}, [](double t) { return t; });
  CHECK_THAT(match_branches(result, reference).fault,
             Catch::Contains("times of the reference decrease after row 2, from 2"));
}

}  // namespace
}  // namespace slipbench::driver::check
