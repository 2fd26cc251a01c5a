// SPDX-License-Identifier: Apache-2.0
#include "law/base/component.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <type_traits>

#include "law/base/field.hpp"
#include "law/base/unit_name.hpp"
#include "law/component/kinetic_force.hpp"
#include "law/definition/friction_definition.hpp"

namespace {

using namespace slipbench::law;

TEST_CASE("a component set is written with the users' numbers and asked by index") {
  constexpr ComponentSet kSet = ComponentSet::of(1, 4, 6);
  STATIC_REQUIRE(kSet.size() == 3);
  for (int c = 0; c < kComponents; ++c) CHECK(kSet.contains(c) == (c == 0 || c == 3 || c == 5));
  CHECK(ComponentSet().empty());
  for (int count = 0; count < 2; ++count) {
    ComponentSet some;
    if (count == 1) some.insert(4);
    CHECK(some.size() == count);
  }
  CHECK((kSet & ComponentSet::of(4, 5)) == ComponentSet::of(4));
  CHECK((kSet | ComponentSet::of(5)) == ComponentSet::of(1, 4, 5, 6));
}

TEST_CASE("positions, constitutive motions and forces are different types") {
  STATIC_REQUIRE_FALSE(std::is_convertible_v<RelativePosition, ConstitutiveMotion>);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<RelativePosition, ConnectorForce>);
}

TEST_CASE("the constitutive motion counts from the reference") {
  const RelativePosition position{{1, 2, 3, 4, 5, 6}};
  const RelativePosition reference{{0.5, 2, 4, 0, 5, 7}};
  CHECK(constitutive_motion(position, reference) == ConstitutiveMotion{{0.5, 0, -1, 4, 0, -1}});
}

TEST_CASE("a slip space is rotational if all of it turns, and nothing is scaled to a force") {
  CHECK(is_rotational(slip_space({4})));
  CHECK(is_rotational(slip_space({4, 6})));
  CHECK_FALSE(is_rotational(slip_space({1})));
  CHECK_FALSE(is_rotational(slip_space({4, 1})));
  CHECK_FALSE(is_rotational(slip_space({4}, 12.0)));
}

TEST_CASE("a component is elastic by a spring of its own, or as one of those that are coupled") {
  KineticBehavior behavior;
  behavior.elasticity[1].emplace(2.0);
  behavior.coupled.components = ComponentSet::of(4);
  for (int c = 0; c < kComponents; ++c) CHECK(behavior.is_elastic(c) == (c == 1 || c == 3));
}

TEST_CASE("the name of a unit is kept, up to its greatest length") {
  CHECK(UnitName().empty());
  CHECK(UnitName().name().empty());
  const UnitName unit("mm/ms");
  CHECK_FALSE(unit.empty());
  CHECK(unit.name() == "mm/ms");
  const std::string longer(UnitName::kLongest + 1, 'm');
  CHECK(UnitName(longer).name() == std::string(UnitName::kLongest, 'm'));
}

TEST_CASE("bounds may hold or leave out their ends") {
  constexpr double kMost = std::numeric_limits<double>::max();
  const Bounds any;
  CHECK((any.contains(-kMost) && any.contains(kMost)));
  CHECK(kPositive.contains(1e-300));
  CHECK_FALSE(kPositive.contains(0.0));
  CHECK(kNotNegative.contains(0.0));
  CHECK_FALSE(kNotNegative.contains(-1e-300));
  const Bounds half{.lower = 0.0, .upper = 1.0, .lower_open = false, .upper_open = true};
  CHECK_FALSE(half.contains(1.0));
  CHECK_FALSE(kNotNegative.contains(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
