// SPDX-License-Identifier: Apache-2.0
#include "law/contact/universal_joint_contact.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "reference/contact_force_ujoint.hpp"
#include "tests/support/finite_difference.hpp"

namespace {

using namespace slipbench::law;
using slipbench::test::one_sided_derivative;
namespace reference = slipbench::reference::contact_force_ujoint;

UniversalJointContact joint(int axis) { return {axis, 0.1, 0.08, 0.2, 1.0, hinge_shares(10.0)}; }

RelativePosition angles(double alpha, double beta) { return {{0, 0, 0, alpha, beta, 0}}; }

const ConnectorForce kForce{{100, 50, 20, 0, 8, 0}};

TEST_CASE("the shares of the hinges are those of the theory at slenderness 10") {
  const HingeShares shares = hinge_shares(10.0);
  // The numbers are given to six digits.
  CHECK(shares.k_ax == Approx(0.456731).margin(5e-7));
  CHECK(shares.t_ax == Approx(0.0432692).margin(5e-8));
  CHECK(shares.k_tw == Approx(0.101563).margin(5e-7));
  CHECK(shares.t_tw == Approx(0.351563).margin(5e-7));
}

TEST_CASE("the shares keep their exact sums and match the reference at any slenderness") {
  for (double a = 0.01; a < 200.0; a *= 1.07) {
    const HingeShares shares = hinge_shares(a);
    CHECK(shares.k_ax + shares.t_ax == Approx(0.5).epsilon(1e-15));
    CHECK(shares.t_tw - shares.k_tw == Approx(0.25).epsilon(1e-14));
    const auto other = reference::slenderness_factors(a);
    // Rounding only; t_ax and k_tw come from differences of numbers near 1/2.
    CHECK(shares.k_ax == Approx(other.axial).epsilon(1e-14));
    CHECK(shares.t_ax == Approx(other.shear).margin(2e-16));
    CHECK(shares.k_tw == Approx(other.twist_bending).epsilon(1e-13).margin(1e-16));
    CHECK(shares.t_tw == Approx(other.twist_shear).epsilon(1e-14));
  }
}

TEST_CASE("the shares are continuous where the fit gives way to lines") {
  for (const double a : {2.0, 6.0}) {
    const HingeShares below = hinge_shares(a * (1.0 - 1e-12));
    const HingeShares above = hinge_shares(a * (1.0 + 1e-12));
    CHECK(below.k_ax == Approx(above.k_ax).epsilon(1e-11));
    CHECK(below.k_tw == Approx(above.k_tw).epsilon(1e-11));
  }
  CHECK(hinge_shares(1e-9).k_ax == Approx(0.25).epsilon(1e-9));
  CHECK(hinge_shares(1e-9).k_tw == Approx(0.0).margin(1e-9));
  CHECK(hinge_shares(1e9).k_ax == Approx(0.5).epsilon(1e-9));
  CHECK(hinge_shares(1e9).k_tw == Approx(0.125).epsilon(1e-9));
}

TEST_CASE("the limits of the worked universal joint are met in both axes") {
  const double mu = 0.1;
  // The limits are given to six digits.
  CHECK(mu * evaluate(joint(1), kForce, angles(0, 0)) == Approx(2.24812).margin(5e-6));
  CHECK(mu * evaluate(joint(3), kForce, angles(0, 0)) == Approx(1.67714).margin(5e-6));
  CHECK(mu * (evaluate(joint(1), kForce, angles(0.5, 0)) + 1.0) == Approx(2.45055).margin(5e-6));
  CHECK(mu * (evaluate(joint(3), kForce, angles(0.5, 0)) + 2.0) == Approx(1.88002).margin(5e-6));
}

TEST_CASE("the contact moment matches the reference over forces, angles and dropped terms") {
  for (const double alpha : {-2.0, -0.4, 0.0, 1.1, 3.0}) {
    for (const double beta : {-1.2, 0.0, 0.3}) {
      for (const double L_s : {0.0, 0.2}) {
        for (const double R_a : {0.0, 0.08}) {
          const ConnectorForce force{{-30, 7, 55, 99, -4, 99}};
          const auto expected =
              reference::normal_moments({0.1, R_a, L_s, 0.35, 0.0, 0.0},
                                        {force[0], force[1], force[2], force[4], alpha, beta});
          for (const int axis : {1, 3}) {
            const UniversalJointContact contact{axis, 0.1, R_a, L_s, 0.35, hinge_shares(3.5)};
            CHECK(evaluate(contact, force, angles(alpha, beta)) ==
                  Approx(axis == 1 ? expected.axis_1 : expected.axis_3).epsilon(1e-13));
          }
        }
      }
    }
  }
}

TEST_CASE("the gradient of the contact moment meets differences, angles included") {
  for (const int axis : {1, 3}) {
    for (const double L_s : {0.0, 0.2}) {
      UniversalJointContact contact = joint(axis);
      contact.L_s = L_s;
      const ConnectorForce force{{100, -50, 20, 0, -8, 0}};
      const RelativePosition position = angles(0.4, -0.3);
      ConnectorForce to_force;
      RelativePosition to_position;
      add_gradient(contact, force, position, &to_force, &to_position);
      for (int c = 0; c < kComponents; ++c) {
        const auto by_force = one_sided_derivative(
            [&](double h) -> std::optional<double> {
              ConnectorForce moved = force;
              moved[c] += h;
              return evaluate(contact, moved, position);
            },
            1e-2);
        CHECK(to_force[c] == Approx(by_force->value).epsilon(1e-8).margin(1e-10));
        const auto by_position = one_sided_derivative(
            [&](double h) -> std::optional<double> {
              RelativePosition moved = position;
              moved[c] += h;
              return evaluate(contact, force, moved);
            },
            1e-4);
        CHECK(to_position[c] == Approx(by_position->value).epsilon(1e-7).margin(1e-8));
      }
    }
  }
}

TEST_CASE("without forces the joint has no contact moment and a gradient without NaN") {
  ConnectorForce to_force;
  RelativePosition to_position;
  for (const int axis : {1, 3}) {
    CHECK(evaluate(joint(axis), ConnectorForce{}, angles(0.2, 0.1)) == 0.0);
    add_gradient(joint(axis), ConnectorForce{}, angles(0.2, 0.1), &to_force, &to_position);
  }
  CHECK(to_force == ConnectorForce{});
  CHECK(to_position == RelativePosition{});
}

}  // namespace
