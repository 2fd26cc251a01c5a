// SPDX-License-Identifier: Apache-2.0
#include "law/base/component.hpp"

#include <catch2/catch.hpp>
#include <type_traits>

#include "law/base/field.hpp"

namespace {

using namespace slipbench::law;

TEST_CASE("a component set is written with the users' numbers and asked by index") {
  constexpr ComponentSet set = ComponentSet::of(1, 4, 6);
  STATIC_REQUIRE(set.size() == 3);
  for (int c = 0; c < kComponents; ++c) CHECK(set.contains(c) == (c == 0 || c == 3 || c == 5));
  CHECK(ComponentSet().empty());
  CHECK((set & ComponentSet::of(4, 5)) == ComponentSet::of(4));
  CHECK((set | ComponentSet::of(5)) == ComponentSet::of(1, 4, 5, 6));
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

TEST_CASE("bounds may hold or leave out their ends") {
  CHECK(kPositive.contains(1e-300));
  CHECK_FALSE(kPositive.contains(0.0));
  CHECK(kNotNegative.contains(0.0));
  CHECK_FALSE(kNotNegative.contains(-1e-300));
  const Bounds half{.lower = 0.0, .upper = 1.0, .lower_open = false, .upper_open = true};
  CHECK_FALSE(half.contains(1.0));
  CHECK_FALSE(kNotNegative.contains(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
