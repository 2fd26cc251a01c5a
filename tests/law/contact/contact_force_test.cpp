// SPDX-License-Identifier: Apache-2.0
#include "law/contact/contact_force.hpp"

#include <catch2/catch.hpp>

#include "law/contact/internal_contact_force.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

const ConnectorForce kForce{{100, -50, 20, 1, 8, -2}};

TEST_CASE("each kind of contact force gives its own value and gradient") {
  const Ambient ambient;
  const UniversalJointContact joint{1, 0.1, 0.08, 0.2, 1.0, hinge_shares(10.0)};
  const DerivedComponent derived = {norm_term({1}, 2.0)};
  CHECK(evaluate(ContactForce{NoContactForce{}}, kForce, ambient) == 0.0);
  CHECK(evaluate(ContactForce{ComponentContactForce{1}}, kForce, ambient) == -50.0);
  CHECK(evaluate(ContactForce{derived}, kForce, ambient) == 200.0);
  CHECK(evaluate(ContactForce{joint}, kForce, ambient) ==
        evaluate(joint, kForce, ambient.position));

  const auto gradient = [&](const ContactForce& contact) {
    ConnectorForce to_force;
    RelativePosition to_position;
    add_gradient(contact, kForce, ambient, &to_force, &to_position);
    return to_force;
  };
  CHECK(gradient(NoContactForce{}) == ConnectorForce{});
  CHECK(gradient(ComponentContactForce{1}) == ConnectorForce{{0, 1, 0, 0, 0, 0}});
  CHECK(gradient(derived) == ConnectorForce{{2, 0, 0, 0, 0, 0}});
  CHECK(gradient(joint)[0] > 0.0);
}

TEST_CASE("the internal contact force is a number or a table, with its slope to slip") {
  Ambient ambient;
  ambient.temperature = 70.0;
  const InternalContactForcePoint number = evaluate(InternalContactForce{7.0}, ambient, 3.0);
  CHECK(number.value == 7.0);
  CHECK(number.to_accumulated_slip == 0.0);
  CHECK_FALSE(depends_on_accumulated_slip(InternalContactForce{7.0}));

  // Reference case W3.
  const InternalContactForce worn = make_function(
      {{100, 0, 20}, {60, 1, 20}, {40, 4, 20}, {80, 0, 120}, {50, 1, 120}, {30, 4, 120}},
      {kOverAccumulatedSlip, kOverTemperature});
  const InternalContactForcePoint point = evaluate(worn, ambient, 0.5);
  CHECK(point.value == Approx(72.5).epsilon(1e-15));
  CHECK(point.to_accumulated_slip == Approx(-35.0).epsilon(1e-14));
  CHECK(depends_on_accumulated_slip(worn));
  CHECK_FALSE(depends_on_accumulated_slip(
      InternalContactForce{make_function({{1, 0}, {2, 1}}, {kOverTemperature})}));
}

TEST_CASE("an internal contact force prolonged below zero is zero, with slope zero") {
  const InternalContactForce worn =
      make_function({{100, 0}, {50, 1}}, {kOverAccumulatedSlip}, 1, Extrapolation::kLinear);
  CHECK(evaluate(worn, {}, 1.5).value == 25.0);
  CHECK(evaluate(worn, {}, 2.5).value == 0.0);
  CHECK(evaluate(worn, {}, 2.5).to_accumulated_slip == 0.0);
  // One that is 0 of itself grows from there.
  const InternalContactForce growing = make_function({{0, 0}, {50, 1}}, {kOverAccumulatedSlip});
  CHECK(evaluate(growing, {}, 0.0).value == 0.0);
  CHECK(evaluate(growing, {}, 0.0).to_accumulated_slip == 50.0);
}

}  // namespace
