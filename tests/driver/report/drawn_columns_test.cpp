// SPDX-License-Identifier: Apache-2.0
#include "driver/report/drawn_columns.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

namespace slipbench::driver::report {
namespace {

/// A result with so many definitions, each with all columns a page could draw.
results::ResultLayout layout_with(int definitions) {
  results::ResultLayout layout;
  layout.columns = {"t"};
  for (int d = 1; d <= definitions; ++d) {
    const std::string n = std::to_string(d);
    const std::string suffix = definitions > 1 ? ".d" + n : "";
    layout.friction.push_back({"d" + n, false, {"CSF2.d" + n}});
    for (const char* name : {"CSF2.d", "CP2"}) {
      layout.columns.push_back(name + (std::string(name) == "CP2" ? "" : n));
    }
    for (const char* name : {"STATUS", "MU", "FN", "FLIM", "DISS", "STRAIN_E", "WORK"}) {
      layout.columns.push_back(name + suffix);
    }
  }
  layout.columns.push_back("KINETIC_E");
  return layout;
}

TEST_CASE("all that a page draws is chosen, each column once") {
  const DrawnColumns drawn = drawn_columns(layout_with(2));
  CHECK(drawn.names.front() == "t");
  const std::set<std::string> unique(drawn.names.begin(), drawn.names.end());
  CHECK(unique.size() == drawn.names.size());
  REQUIRE(drawn.definitions.size() == 2);
  CHECK(drawn.definitions[1].force == "CSF2.d2");
  CHECK(drawn.definitions[1].mu == "MU.d2");
  CHECK(drawn.definitions[1].normal_force == "FN.d2");
  REQUIRE(drawn.energies.size() == 4);
  CHECK(drawn.energies[0].second == std::vector<std::string>{"WORK.d1", "WORK.d2"});
  CHECK(drawn.energies[3].first == "kinetic");
}

TEST_CASE("of many definitions coefficients go first, forces and regimes never") {
  const DrawnColumns drawn = drawn_columns(layout_with(7));
  CHECK(drawn.names.size() == 24);
  CHECK(drawn.definitions.back().mu.empty());
  CHECK(drawn.definitions.back().status == "STATUS.d7");
  CHECK(drawn.definitions.back().limit == "FLIM.d7");
  const DrawnColumns many = drawn_columns(layout_with(30));
  CHECK(many.names.size() == 2 + 3 * 30);
  CHECK(many.energies.empty());
}

TEST_CASE("the columns of very many definitions are found in time") {
  const DrawnColumns many = drawn_columns(layout_with(20000));
  CHECK(many.names.size() == 2 + 3 * 20000);
  CHECK(many.definitions.back().limit == "FLIM.d20000");
}

TEST_CASE("a table of no result has nothing to draw") {
  results::ResultLayout layout;
  layout.columns = {"t", "x"};
  CHECK(drawn_columns(layout).definitions.empty());
}

}  // namespace
}  // namespace slipbench::driver::report
