// SPDX-License-Identifier: Apache-2.0
#include "law/update/connector.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace {

using namespace slipbench::law;
using Rule = FrictionRuleViolation::Rule;

std::vector<FrictionRuleViolation> check(std::string_view type,
                                         const std::vector<FrictionOutline>& definitions) {
  return check_rules(find_connection(type)->info, definitions);
}

TEST_CASE("definitions on components of their own keep the rules") {
  CHECK(check("CARTESIAN", {}).empty());
  CHECK(check("CARTESIAN", {{FrictionForm::kComponent, ComponentSet::of(1)},
                            {FrictionForm::kComponent, ComponentSet::of(2)},
                            {FrictionForm::kComponent, ComponentSet::of(3)}})
            .empty());
  CHECK(check("CARTESIAN", {{FrictionForm::kPotential, ComponentSet::of(1, 2)},
                            {FrictionForm::kComponent, ComponentSet::of(3)}})
            .empty());
  CHECK(check("PLANAR", {{FrictionForm::kPredefined, ComponentSet::of(2, 3, 4)}}).empty());
}

TEST_CASE("friction on a held or missing component is reported with the component") {
  const auto held = check("SLOT", {{FrictionForm::kComponent, ComponentSet::of(2)}});
  REQUIRE(held.size() == 1);
  CHECK(held[0].rule == Rule::kNotAvailable);
  CHECK(held[0].definition == 0);
  CHECK(held[0].component == 1);
  const auto missing = check("CARTESIAN", {{FrictionForm::kComponent, ComponentSet::of(1)},
                                           {FrictionForm::kPotential, ComponentSet::of(3, 4, 6)}});
  REQUIRE(missing.size() == 2);
  CHECK(missing[0].component == 3);
  CHECK(missing[1].component == 5);
  CHECK(missing[1].definition == 1);
}

TEST_CASE("a component used by two definitions is reported with both") {
  const auto shared = check("CARTESIAN", {{FrictionForm::kComponent, ComponentSet::of(1)},
                                          {FrictionForm::kComponent, ComponentSet::of(3)},
                                          {FrictionForm::kPotential, ComponentSet::of(2, 3)}});
  REQUIRE(shared.size() == 1);
  CHECK(shared[0].rule == Rule::kSharedComponent);
  CHECK(shared[0].definition == 2);
  CHECK(shared[0].other == 1);
  CHECK(shared[0].component == 2);
}

TEST_CASE("a second potential is reported with the first") {
  const auto two = check("CARTESIAN", {{FrictionForm::kPotential, ComponentSet::of(1)},
                                       {FrictionForm::kComponent, ComponentSet::of(3)},
                                       {FrictionForm::kPotential, ComponentSet::of(2)}});
  REQUIRE(two.size() == 1);
  CHECK(two[0].rule == Rule::kTwoPotentials);
  CHECK(two[0].definition == 2);
  CHECK(two[0].other == 0);
}

TEST_CASE("predefined friction must be the only definition, wherever it stands") {
  for (const bool first : {true, false}) {
    std::vector<FrictionOutline> definitions = {{FrictionForm::kComponent, ComponentSet::of(1)}};
    definitions.insert(first ? definitions.begin() : definitions.end(),
                       {FrictionForm::kPredefined, ComponentSet::of(1, 4)});
    const auto alone = check("CYLINDRICAL", definitions);
    REQUIRE(alone.size() == 1);
    CHECK(alone[0].rule == Rule::kPredefinedNotAlone);
    CHECK(alone[0].definition == (first ? 0 : 1));
    CHECK(alone[0].other == (first ? 1 : 0));
  }
}

TEST_CASE("predefined friction twice is reported for both") {
  const auto twice = check("SLOT", {{FrictionForm::kPredefined, ComponentSet::of(1)},
                                    {FrictionForm::kPredefined, ComponentSet::of(1)}});
  REQUIRE(twice.size() == 2);
  CHECK(twice[0].rule == Rule::kPredefinedNotAlone);
  CHECK(twice[1].rule == Rule::kPredefinedNotAlone);
}

}  // namespace
