// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
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

/// Damages some numbers of a list: other values, counts that are one off, numbers that change
/// places, too few, too many.
std::vector<double> damaged(std::vector<double> numbers, Dice& dice) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values{0.0,  1.0,   2.0,    3.0,   4.0,       5.0,        6.0, -1.0,
                                   -0.0, 1e300, 1e-300, -1e10, kInfinity, -kInfinity, 1e5, 0.5};
  const auto place = [&] {
    return static_cast<std::size_t>(dice.pick(static_cast<int>(numbers.size())));
  };
  for (int times = 1 + dice.pick(3); times > 0; --times) {
    switch (dice.pick(6)) {
      case 0:
        numbers[place()] = dice.one_of(values);
        break;
      case 1:
        numbers[place()] += dice.chance(0.5) ? 1.0 : -1.0;
        break;
      case 2:
        numbers[place()] *= dice.chance(0.5) ? -1.0 : 1e150;
        break;
      case 3:
        std::swap(numbers[place()], numbers[place()]);
        break;
      case 4:
        numbers.insert(numbers.begin() + static_cast<std::ptrdiff_t>(place()), dice.one_of(values));
        break;
      default: {
        double& x = numbers[place()];
        x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^
                                  (std::uint64_t{1} << static_cast<unsigned>(dice.pick(64))));
      }
    }
  }
  return numbers;
}

// The sanitizers look at the updates here: what is out of the numbers of a table or of a component
// would be an index of its own memory.
TEST_CASE("damaged numbers are refused, or make a definition whose updates run") {
  int refused = 0, ran = 0;
  for (std::uint32_t seed = 1; seed <= 600; ++seed) {
    Dice dice(seed);
    const std::vector<double> packed = pack(any_definition(dice));
    const std::vector<HistoryRow> rows = random_history(&dice, 4);
    const std::array<double, kMaxFields> fields{0.5, -0.25};
    for (int times = 0; times < 40; ++times) {
      const std::vector<double> bad = damaged(packed, dice);
      std::span<const double> rest(bad);
      const auto read = unpack(rest);
      if (!read || std::holds_alternative<Capstan>(read->criterion)) {
        ++refused;
        continue;
      }
      ++ran;
      FrictionState state;
      for (const HistoryRow& row : rows) {
        ConnectorIncrement increment = row.increment();
        increment.end.fields = fields;  // a damaged table may ask for any
        const FrictionUpdate one = read->formulation ? update_penalty(*read, increment, state)
                                                     : update(*read, increment, state);
        if (!all_finite(one)) break;
        state = one.state;
      }
    }
  }
  CHECK(refused > 10000);
  CHECK(ran > 3000);
}

TEST_CASE("a table of other columns than are asked for is refused") {
  const auto read = [](const FrictionDefinition& definition) {
    const std::vector<double> packed = pack(definition);
    std::span<const double> rest(packed);
    return unpack(rest).has_value();
  };
  const auto table_of = [](int dependents) {
    std::vector<double> row(static_cast<std::size_t>(dependents), 0.5);
    row.push_back(20.0);
    return make_function({row}, {kOverTemperature}, dependents);
  };
  FrictionDefinition definition;
  definition.law = ConstantCoefficient{0.2};
  DerivedTerm term = norm_term({1, 2, 3}, 1.0);
  for (int dependents = 1; dependents <= 6; ++dependents) {
    term.weight_table = table_of(dependents);
    definition.contact_force = DerivedComponent{term};
    CHECK(read(definition) == (dependents == 3));
  }
  definition.contact_force = NoContactForce{};
  for (int dependents = 1; dependents <= 2; ++dependents) {
    FrictionDefinition other = definition;
    other.internal_contact_force = table_of(dependents);
    CHECK(read(other) == (dependents == 1));
    other = definition;
    other.law = TabularCoefficient{table_of(dependents)};
    CHECK(read(other) == (dependents == 1));
  }
  for (const double stick : {0.0, -1.0, HUGE_VAL}) {
    FrictionDefinition other = definition;
    other.stick.value = stick;
    CHECK_FALSE(read(other));
  }
  definition.slip.dimension = 2;  // both of component 1
  CHECK_FALSE(read(definition));
}

}  // namespace
