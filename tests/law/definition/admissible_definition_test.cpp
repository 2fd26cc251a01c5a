// SPDX-License-Identifier: Apache-2.0
// Definitions that updates may be made of: the ends of each range, on either side.
#include "law/definition/admissible_definition.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>

#include "law/friction/law_list.hpp"

namespace {

using namespace slipbench::law;

/// Tells whether a sound definition is still so after a change.
bool admits(const std::function<void(FrictionDefinition*)>& change) {
  FrictionDefinition definition;
  definition.law = ConstantCoefficient{0.2};
  change(&definition);
  return is_admissible(definition);
}

TEST_CASE("an entry of a slip space has a component of its own and a positive scale") {
  const auto admits_entry = [](int component, double scale) {
    return admits([&](FrictionDefinition* d) {
      d->slip = slip_space({1, 2});
      d->slip.component[1] = component;
      d->slip.scale[1] = scale;
    });
  };
  CHECK(admits_entry(5, 0.1));
  CHECK_FALSE(admits_entry(6, 0.1));
  CHECK_FALSE(admits_entry(-1, 0.1));
  CHECK_FALSE(admits_entry(0, 0.1));  // as the first
  CHECK_FALSE(admits_entry(5, 0.0));
}

TEST_CASE("any force limit above 0 is one, and any elastic slip or stiffness") {
  CHECK(admits([](FrictionDefinition* d) { d->force_limit = 1e-3; }));
  CHECK_FALSE(admits([](FrictionDefinition* d) { d->force_limit = 0.0; }));
  CHECK(admits([](FrictionDefinition* d) { d->stick.value = 1e-3; }));
  CHECK_FALSE(admits([](FrictionDefinition* d) { d->stick.value = 0.0; }));
}

TEST_CASE("a change of friction is between its begin and its end") {
  const auto admits_blend = [](double start, double weight) {
    return admits([&](FrictionDefinition* d) { d->blend = {start, weight}; });
  };
  CHECK(admits_blend(0.0, 0.0));
  CHECK(admits_blend(0.3, 1.0));
  CHECK_FALSE(admits_blend(-0.3, 0.5));
  CHECK_FALSE(admits_blend(0.3, -0.1));
  CHECK_FALSE(admits_blend(0.3, 1.5));
}

TEST_CASE("a simple filter has a coefficient up to 1, a filter over time any time") {
  const auto admits_filter = [](Filter::Kind kind, double value) {
    return admits([&](FrictionDefinition* d) {
      d->formulation = Formulation{.penalty = StiffnessPenalty{1.0}, .filter = {kind, value}};
    });
  };
  CHECK(admits_filter(Filter::Kind::kSimple, 1.0));
  CHECK_FALSE(admits_filter(Filter::Kind::kSimple, 1.5));
  CHECK_FALSE(admits_filter(Filter::Kind::kSimple, 0.0));
  CHECK(admits_filter(Filter::Kind::kPeriod, 1.5));
  CHECK_FALSE(admits_filter(Filter::Kind::kPeriod, 0.0));
}

TEST_CASE("a potential has one to six parts and leaves, and leaves only of its parts") {
  const auto admits_potential = [](int parts, int leaves, int part_of_last) {
    return admits([&](FrictionDefinition* d) {
      Potential potential;
      potential.parts = parts;
      potential.leaves = leaves;
      for (std::size_t g = 0; g < kComponents; ++g) potential.leaf[g].direction[g] = 1.0;
      potential.leaf[5].part = part_of_last;
      d->slip = slip_space({1, 2, 3, 4, 5, 6});
      d->criterion = potential;
    });
  };
  CHECK(admits_potential(1, 1, 0));
  CHECK(admits_potential(6, 6, 5));
  CHECK_FALSE(admits_potential(6, 6, 6));
  CHECK_FALSE(admits_potential(7, 6, 6));
  CHECK_FALSE(admits_potential(7, 1, 0));
  CHECK_FALSE(admits_potential(0, 1, 0));
  CHECK_FALSE(admits_potential(1, 0, 0));
  CHECK_FALSE(admits_potential(1, 7, 0));
}

TEST_CASE("a homogeneous potential has no centers and any potential finite numbers") {
  const auto admits_leaf = [](bool homogeneous, double center, double direction) {
    return admits([&](FrictionDefinition* d) {
      Potential potential;
      potential.parts = potential.leaves = 1;
      potential.homogeneous = homogeneous;
      potential.leaf[0].center = center;
      potential.leaf[0].direction[0] = direction;
      d->criterion = potential;
    });
  };
  CHECK(admits_leaf(true, 0.0, 1.0));
  CHECK(admits_leaf(false, 2.0, 1.0));
  CHECK_FALSE(admits_leaf(true, 2.0, 1.0));
  for (const bool homogeneous : {false, true}) {
    CHECK_FALSE(admits_leaf(homogeneous, 0.0, std::numeric_limits<double>::infinity()));
    CHECK_FALSE(admits_leaf(homogeneous, 0.0, std::numeric_limits<double>::quiet_NaN()));
  }
}

}  // namespace
