// SPDX-License-Identifier: Apache-2.0
#include "law/contact/derived_component.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/finite_difference.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

DerivedTerm term(TermOperator combine, double sign, std::vector<int> number,
                 std::vector<double> weight) {
  DerivedTerm result;
  result.combine = combine;
  result.sign = sign;
  result.count = static_cast<int>(number.size());
  for (std::size_t i = 0; i < number.size(); ++i) {
    result.component[i] = number[i] - 1;
    result.weight[i] = weight[i];
  }
  return result;
}

const ConnectorForce kForce{{3.0, -4.0, 12.0, -1.5, 2.0, -0.5}};

TEST_CASE("NORM is the root of the weighted squares, with one entry the absolute value") {
  CHECK(evaluate({norm_term({2, 3}, 1.0)}, kForce, {}) == Approx(std::sqrt(160.0)).epsilon(1e-15));
  CHECK(evaluate({norm_term({2}, 1.0)}, kForce, {}) == 4.0);
  CHECK(evaluate({term(TermOperator::kNorm, -1.0, {1, 2}, {1.0, 1.0})}, kForce, {}) == -5.0);
  CHECK(evaluate({term(TermOperator::kNorm, 1.0, {1, 2}, {2.0, 0.5})}, kForce, {}) ==
        Approx(std::sqrt(36.0 + 4.0)).epsilon(1e-15));
}

TEST_CASE("the NORM of one entry has the bits of the root of its square, in all magnitudes") {
  for (const double size :
       {0.0, 1e-320, 1e-170, 1.1e-154, 1e-3, 0.1, 1.0 / 3.0, 7.7, 1e17, 1e154, 1e200}) {
    for (double x : {size, -size}) {
      for (int i = 0; i < 100; ++i, x *= 1.0 + 0.013 * i) {
        const ConnectorForce force{{0.0, x}};
        for (const double sign : {1.0, -1.0}) {
          // An entry of weight 0 adds nothing, but makes it a sum.
          const double root =
              evaluate({term(TermOperator::kNorm, sign, {2, 3}, {0.9, 0.0})}, force, {});
          const double alone = evaluate({term(TermOperator::kNorm, sign, {2}, {0.9})}, force, {});
          REQUIRE(std::bit_cast<std::uint64_t>(alone) == std::bit_cast<std::uint64_t>(root));
        }
      }
    }
  }
}

TEST_CASE("SUM keeps signs and MACAULEY SUM takes positive shares only") {
  CHECK(evaluate({term(TermOperator::kSum, 1.0, {1, 2}, {1.0, 2.0})}, kForce, {}) == -5.0);
  CHECK(evaluate({term(TermOperator::kSum, -1.0, {1, 2}, {1.0, 2.0})}, kForce, {}) == 5.0);
  CHECK(evaluate({term(TermOperator::kMacauleySum, 1.0, {1, 2, 3}, {1.0, 2.0, 0.5})}, kForce, {}) ==
        9.0);
  CHECK(evaluate({term(TermOperator::kMacauleySum, 1.0, {1, 2}, {-1.0, -2.0})}, kForce, {}) == 8.0);
}

TEST_CASE("terms of one name add after each root (D9)") {
  const DerivedComponent two = {norm_term({2, 3}, 1.0), norm_term({5, 6}, 2.0)};
  CHECK(evaluate(two, kForce, {}) ==
        Approx(std::sqrt(160.0) + 2.0 * std::sqrt(4.25)).epsilon(1e-15));
  CHECK(evaluate(DerivedComponent{}, kForce, {}) == 0.0);
}

TEST_CASE("weights from a table are interpolated, not the value of the term (D7)") {
  DerivedTerm bending = norm_term({5, 6}, 0.0);
  bending.weight_table =
      make_function({{2 / 0.55, 2 / 0.55, 0.0}, {2 / 0.1, 2 / 0.1, 0.45}}, {over_position(1)}, 2);
  const DerivedComponent g = {norm_term({2, 3}, 1.0), bending};
  const ConnectorForce force{{0, 300, 400, 0, 55, 0}};
  Ambient ambient;
  ambient.position[0] = 0.225;
  CHECK(evaluate(g, force, ambient) == Approx(1150).epsilon(1e-14));
  ambient.position[0] = 0.0;
  CHECK(evaluate(g, force, ambient) == Approx(700).epsilon(1e-14));
  ambient.position[0] = 7.0;  // constant beyond the table
  CHECK(evaluate(g, force, ambient) == Approx(500 + 20 * 55).epsilon(1e-14));
}

TEST_CASE("every weight has its own column of the table") {
  DerivedTerm sum = term(TermOperator::kSum, 1.0, {1, 5}, {0.0, 0.0});
  const std::vector<double> fields = {0.25};
  sum.weight_table = make_function({{1, 10, 0}, {3, 30, 1}}, {over_field(0)}, 2);
  Ambient ambient;
  ambient.fields = fields;
  CHECK(evaluate({sum}, kForce, ambient) == Approx(1.5 * 3.0 + 15.0 * 2.0).epsilon(1e-15));
}

TEST_CASE("the gradient of a derived component meets differences in every operator") {
  DerivedTerm varying = norm_term({5, 6, 2}, 0.0);
  varying.weight_table =
      make_function({{1, 2, 3, 0, 0}, {2, 2, 5, 1, 0}, {4, 1, 3, 0, 2}, {5, 9, 3, 1, 2}},
                    {over_position(1), over_motion(4)}, 3);
  const DerivedComponent g = {norm_term({2, 3}, 1.3), varying,
                              term(TermOperator::kSum, -1.0, {1, 4}, {0.7, -2.0}),
                              term(TermOperator::kMacauleySum, 1.0, {1, 2, 6}, {1.1, 0.4, -3.0})};
  Ambient ambient;
  ambient.position = {{0.3, 0, 0, 0.9, 0, 0}};
  ambient.motion = {{0.1, 0, 0, 0.8, 0, 0}};
  ConnectorForce to_force;
  RelativePosition to_position;
  add_gradient(g, kForce, ambient, &to_force, &to_position);
  for (int c = 0; c < kComponents; ++c) {
    // No kink lies within the steps, so the branch cannot change; rounding dominates.
    const auto by_force = one_sided_derivative(
        [&](double h) -> std::optional<double> {
          ConnectorForce force = kForce;
          force[c] += h;
          return evaluate(g, force, ambient);
        },
        1e-3);
    CHECK(to_force[c] == Approx(by_force->value).epsilon(1e-8).margin(1e-9));
    const auto by_position = one_sided_derivative(
        [&](double h) -> std::optional<double> {
          Ambient moved = ambient;
          moved.position[c] += h;
          moved.motion[c] += h;
          return evaluate(g, kForce, moved);
        },
        1e-3);
    CHECK(to_position[c] == Approx(by_position->value).epsilon(1e-8).margin(1e-9));
  }
}

TEST_CASE("the gradient is added, and is 0 at corners") {
  ConnectorForce to_force{{1, 1, 1, 1, 1, 1}};
  RelativePosition to_position;
  const DerivedComponent g = {norm_term({2, 3}, 1.0),
                              term(TermOperator::kMacauleySum, 1.0, {1}, {2.0})};
  add_gradient(g, ConnectorForce{}, {}, &to_force, &to_position);
  for (int c = 0; c < kComponents; ++c) CHECK(to_force[c] == 1.0);
}

}  // namespace
