// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/suggestions.hpp"

#include <array>
#include <catch2/catch.hpp>

namespace slipbench::driver::base {
namespace {

using Names = std::vector<std::string_view>;

TEST_CASE("At most five names are suggested, the nearest first and each once") {
  const Names names{"filters", "filter", "Filter", "filter", "filer", "filte", "filtr", "belt"};
  CHECK(suggestions("filter", names) == Names{"filter", "Filter", "filters", "filer", "filte"});
}

TEST_CASE("Names that contain the word come behind those that resemble it") {
  const Names names{"belt_velocity", "elastic_slip", "elasticity", "elastic_belt_reversal"};
  CHECK(suggestions("elastic", names) ==
        Names{"elasticity", "elastic_slip", "elastic_belt_reversal"});
  CHECK(suggestions("el", names).empty());
}

TEST_CASE("Without a suggestion few names are all told, of many where they are listed") {
  const Names few{"a1", "b1", "c1"};
  CHECK(did_you_mean("xyz", few, "'list' shows all") == "known: a1, b1 and c1");
  const Names many{"a1", "b1", "c1", "d1", "e1", "f1"};
  CHECK(did_you_mean("xyz", many, "'list' shows all") == "'list' shows all");
  CHECK(did_you_mean("xyz", {}, "there are none") == "there are none");
  CHECK(did_you_mean("normla", Names{"normal", "formal"}, "") ==
        "did you mean 'normal' or 'formal'?");
}

TEST_CASE("A long list of names is cut, a short one is not") {
  CHECK(few_in_words(Names{"a", "b", "c", "d", "e", "f"}) == "a, b, c, d, e and f");
  CHECK(few_in_words(Names{"a", "b", "c", "d", "e", "f", "g"}) == "a, b, c, d, e and 2 more");
  CHECK(few_in_words({}).empty());
}

}  // namespace
}  // namespace slipbench::driver::base
