// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "law/definition/packed_definition.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/penalty_update.hpp"
#include "tests/support/any_definition.hpp"
#include "tests/support/random_history.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// Compares by value, but for NaN: a filter with no clip may leave one.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

TEST_CASE("a definition that comes back from its numbers gives the same updates") {
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    Dice dice(seed);
    FrictionDefinition definition = any_definition(dice);
    if (dice.chance(0.1)) definition.criterion = Capstan{dice.between(0.0, 7.0)};
    const std::vector<double> packed = pack(definition);
    std::span<const double> rest(packed);
    const auto unpacked = unpack(rest);
    INFO("seed " << seed << ", law " << name_of(definition.law));
    REQUIRE(unpacked);
    CHECK(rest.empty());
    CHECK(pack(*unpacked) == packed);
    // Updates of a belt want a tension.
    if (std::holds_alternative<Capstan>(definition.criterion)) continue;
    const std::vector<HistoryRow> rows = random_history(&dice, 20);
    const auto before = run_any(definition, rows);
    const auto after = run_any(*unpacked, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      REQUIRE(same(numbers(before[i]), numbers(after[i])));
    }
  }
}

TEST_CASE("definitions follow each other in one list of numbers") {
  Dice dice(7);
  std::vector<FrictionDefinition> definitions;
  definitions.reserve(10);
  for (int i = 0; i < 10; ++i) definitions.push_back(any_definition(dice));
  std::vector<double> all = pack_all(definitions);
  const auto unpacked = unpack_all(all);
  REQUIRE(unpacked);
  CHECK(pack_all(*unpacked) == all);
  all.push_back(0.0);
  CHECK_FALSE(unpack_all(all));
  all.pop_back();
  CHECK_FALSE(unpack_all(std::span<const double>(all).first(all.size() - 1)));
  all[1] = 9.0;
  CHECK_FALSE(unpack_all(all));
  all[0] = 2.0;
  CHECK_FALSE(unpack_all(all));
}

TEST_CASE("numbers that are no definition are refused, and damaged ones do no harm") {
  int refused = 0;
  for (std::uint32_t seed = 1; seed <= 500; ++seed) {
    Dice dice(seed);
    std::vector<double> packed = pack(any_definition(dice));
    const std::span<const double> whole(packed);
    std::span<const double> cut =
        whole.first(static_cast<std::size_t>(dice.pick(static_cast<int>(whole.size()))));
    const std::size_t left = cut.size();
    CHECK_FALSE(unpack(cut));
    CHECK(cut.size() == left);
    for (int times = 0; times < 20; ++times) {
      std::vector<double> damaged = packed;
      const std::vector<double> bad{std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::infinity(),
                                    -1.0,
                                    1e300,
                                    0.5,
                                    7.0,
                                    1e9};
      damaged[static_cast<std::size_t>(dice.pick(static_cast<int>(damaged.size())))] =
          dice.one_of(bad);
      std::span<const double> rest(damaged);
      const auto read = unpack(rest);
      if (!read) ++refused;
      // What is read can be written: all of its indices lie within.
      if (read) CHECK(pack(*read).size() <= damaged.size());
    }
  }
  CHECK(refused > 3000);
}

}  // namespace
