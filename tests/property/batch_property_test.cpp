// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "law/batch/pack.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/lane_bits.hpp"
#include "tests/support/random_definition.hpp"
#include "tests/support/random_history.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

constexpr std::array kKept{LaneKept::kMaximum, LaneKept::kMinimum, LaneKept::kMagnitude};

/// Numbers that a pack can follow of definitions with so many entries.
struct Followed {
  std::vector<LaneExtreme> extremes;
  std::vector<LaneChanges> changes{{Regime::kStick, Regime::kSlip}, {Regime::kSlip, Regime::kOpen}};

  explicit Followed(int dimension) {
    for (const LaneKept kept : kKept) {
      for (int k = 0; k < dimension; ++k) {
        extremes.emplace_back(LaneNumber::kForce, static_cast<std::size_t>(k), kept);
      }
      for (const LaneNumber number :
           {LaneNumber::kLimit, LaneNumber::kCoefficient, LaneNumber::kRegime,
            LaneNumber::kAccumulatedSlip, LaneNumber::kDissipation}) {
        extremes.emplace_back(number, 0, kept);
      }
    }
  }

  /// All of a lane, and the last values of a pack.
  Bits bits(const Pack& pack, std::size_t lane) const {
    Bits all;
    for (const LaneExtreme& one : extremes) {
      all.push_back(std::bit_cast<std::uint64_t>(one.so_far[lane]));
      all.push_back(std::bit_cast<std::uint64_t>(pack.last(one.number, one.entry, lane)));
    }
    for (const LaneChanges& one : changes) {
      all.push_back(std::bit_cast<std::uint64_t>(one.count[lane]));
    }
    return all;
  }
};

/// Returns what Followed::bits does, of a definition that is updated by itself.
Bits followed_alone(const FrictionDefinition& definition,
                    std::span<const ConnectorIncrement> increments, FrictionState state) {
  Followed followed(definition.slip.dimension);
  std::vector<double> last(followed.extremes.size());
  CompensatedSum dissipation;
  bool is_first = true;
  for (const ConnectorIncrement& increment : increments) {
    const Regime before = state.regime;
    const FrictionUpdate u = update(definition, increment, state);
    state = u.state;
    dissipation += u.dissipation;
    for (std::size_t i = 0; i < last.size(); ++i) {
      LaneExtreme& one = followed.extremes[i];
      switch (one.number) {
        case LaneNumber::kForce:
          last[i] = definition.slip.scale[one.entry] * state.force[one.entry];
          break;
        case LaneNumber::kLimit:
          last[i] = u.limit;
          break;
        case LaneNumber::kCoefficient:
          last[i] = u.mu;
          break;
        case LaneNumber::kRegime:
          last[i] = static_cast<double>(state.regime);
          break;
        case LaneNumber::kAccumulatedSlip:
          last[i] = state.accumulated_slip;
          break;
        case LaneNumber::kDissipation:
          last[i] = dissipation;
          break;
      }
      const double value = one.kept == LaneKept::kMagnitude ? std::abs(last[i]) : last[i];
      double& so_far = one.so_far[0];
      if (one.kept == LaneKept::kMinimum ? value < so_far : value > so_far) so_far = value;
    }
    for (LaneChanges& one : followed.changes) {
      if (!is_first && before == one.from && state.regime == one.to) one.count[0] += 1.0;
    }
    is_first = false;
  }
  Bits all;
  for (std::size_t i = 0; i < last.size(); ++i) {
    all.push_back(std::bit_cast<std::uint64_t>(followed.extremes[i].so_far[0]));
    all.push_back(std::bit_cast<std::uint64_t>(last[i]));
  }
  for (const LaneChanges& one : followed.changes) {
    all.push_back(std::bit_cast<std::uint64_t>(one.count[0]));
  }
  return all;
}

/// Returns those of a definition that is updated by itself.
Bits alone(const FrictionDefinition& definition, std::span<const ConnectorIncrement> increments,
           const FrictionState& state) {
  AloneLane lane{state, {}};
  for (const ConnectorIncrement& increment : increments) lane.advance(definition, increment);
  return bits(lane.state, lane.summary);
}

/// Replaces what keeps a definition off the common path.
DefinitionDescription with_form(Dice* dice, DefinitionDescription d) {
  if (d.slip.dimension > 2) d.slip.dimension = 2;
  d.potential.reset();
  if (dice->chance(0.5)) d.slip_rate = SlipRateMeasure::kRelativeMotion;
  if (d.slip_rate == SlipRateMeasure::kSlip ||
      !(std::holds_alternative<ConstantCoefficient>(d.law) ||
        std::holds_alternative<ExponentialDecay>(d.law))) {
    d.law = ConstantCoefficient{dice->chance(0.05) ? 0.0 : dice->between(0.05, 0.9)};
    if (d.slip_rate == SlipRateMeasure::kRelativeMotion) {
      d.law = random_table(dice, some_of(dice, {kOverSlipRate, kOverTemperature}), 1, 0.05, 0.6);
    }
  }
  d.accumulated_slip = AccumulatedSlipTiming::kStart;
  d.internal_contact_force = dice->between(0.0, 80.0);
  if (dice->chance(0.5)) {
    d.internal_contact_force = random_table(dice, {kOverAccumulatedSlip}, 1, 0.0, 120.0);
  }
  return d;
}

/// Part that the coefficients of all lanes share.
enum class Alike : std::uint8_t { kLaw, kCells, kNothing };

/// Changes the numbers of a definition.
DefinitionDescription varied(Dice* dice, DefinitionDescription d, Alike alike) {
  d.stick.value *= dice->between(0.5, 2.0);
  if (dice->chance(0.5)) d.force_limit = dice->between(1.0, 60.0);
  if (auto* number = std::get_if<double>(&d.internal_contact_force)) {
    *number *= dice->between(0.0, 2.0);
  } else {
    for (auto& row : std::get<TableRows>(d.internal_contact_force).rows) {
      row[0] *= dice->between(0.8, 1.2);
    }
  }
  if (alike == Alike::kLaw) return d;
  for (int k = 0; alike == Alike::kNothing && k < d.slip.dimension; ++k) {
    d.slip.scale[static_cast<std::size_t>(k)] *= dice->between(0.5, 2.0);
  }
  if (auto* constant = std::get_if<ConstantCoefficient>(&d.law)) {
    constant->mu *= dice->between(0.5, 2.0);
  } else if (auto* decay = std::get_if<ExponentialDecay>(&d.law)) {
    decay->decay *= dice->between(0.5, 2.0);
  } else if (auto* table = std::get_if<TableRows>(&d.law)) {
    for (auto& row : table->rows) row[0] *= dice->between(0.8, 1.2);
  }
  return d;
}

struct Histories {
  std::vector<HistoryRow> rows;  ///< owns the fields
  std::vector<ConnectorIncrement> increments;
};

Histories histories(Dice* dice) {
  Histories h{random_history(dice, 2 + dice->pick(60)), {}};
  for (const HistoryRow& row : h.rows) h.increments.push_back(row.increment());
  return h;
}

/// A force of every lane in place of that of the history.
struct OwnForce {
  int component = 0;
  std::vector<double> of_lane;
};

/// Compares packs over all the definitions, and over the increments in two parts, with update().
/// \return how many lanes went the common path
int compare(const std::vector<FrictionDefinition>& definitions, const Histories& history,
            const std::vector<FrictionState>& begin, std::size_t part,
            const std::vector<OwnForce>& own = {}) {
  std::vector<Bits> expected;
  std::vector<Bits> expected_followed;
  for (std::size_t lane = 0; lane < definitions.size(); ++lane) {
    std::vector<ConnectorIncrement> its = history.increments;
    for (const OwnForce& one : own) {
      for (ConnectorIncrement& increment : its) {
        increment.force[one.component] = one.of_lane[lane];
      }
    }
    const FrictionState first = begin.empty() ? FrictionState{} : begin[lane];
    expected.push_back(alone(definitions[lane], its, first));
    expected_followed.push_back(followed_alone(definitions[lane], its, first));
  }
  int common = 0;
  const std::span all(definitions);
  const std::span increments(history.increments);
  for (const InstructionSet set : available_instructions()) {
    INFO("instructions " << static_cast<int>(set));
    common = 0;
    for (std::size_t from = 0; from < all.size(); from += kLanes) {
      const std::size_t count = std::min(kLanes, all.size() - from);
      Pack pack(all.subspan(from, count), begin.empty() ? std::span<const FrictionState>{}
                                                        : std::span(begin).subspan(from, count));
      std::size_t first = 0;
      while (first + 1 < count && !pack.is_common(first)) ++first;
      Followed followed(all[from + first].slip.dimension);
      pack.follow(followed.extremes, followed.changes);
      std::vector<LaneForce> forces;
      forces.reserve(own.size());
      for (const OwnForce& one : own) {
        forces.push_back({one.component, std::span(one.of_lane).subspan(from, count)});
      }
      pack.press(forces);
      pack.advance(increments.first(part), set);
      pack.advance(increments.subspan(part), set);
      for (std::size_t lane = 0; lane < count; ++lane) {
        INFO("lane " << from + lane);
        REQUIRE(bits(pack.state(lane), pack.summary(lane)) == expected[from + lane]);
        if (!pack.is_common(lane)) continue;
        REQUIRE(followed.bits(pack, lane) == expected_followed[from + lane]);
        ++common;
      }
    }
  }
  return common;
}

TEST_CASE("lanes of one form go the common path and end in the bits of update()") {
  // What was drawn: entries, constant kappa, wear, what the coefficients have in common, own
  // forces.
  std::set<std::tuple<int, bool, bool, Alike, bool>> drawn;
  constexpr std::size_t kForms = std::size_t{2} * 2 * 2 * 3 * 2;
  for (std::uint64_t seed = 0; seed < 500 || drawn.size() < kForms; ++seed) {
    INFO("seed " << seed);
    REQUIRE(seed < 5000);
    Dice dice(20261123 + seed);
    const int kind = dice.pick(kDefinitionKinds);
    const DefinitionDescription base = with_form(&dice, random_definition(&dice, kind));
    const auto alike = static_cast<Alike>(dice.pick(3));
    std::vector<FrictionDefinition> definitions;
    const int lanes = 1 + dice.pick(130);
    definitions.reserve(static_cast<std::size_t>(lanes));
    for (int lane = 0; lane < lanes; ++lane) {
      definitions.push_back(varied(&dice, base, alike).build());
    }
    const Histories history = histories(&dice);
    const auto part = static_cast<std::size_t>(dice.pick(static_cast<int>(history.rows.size())));
    std::vector<OwnForce> own;
    for (int component = 0; component < kComponents; ++component) {
      if (!dice.chance(0.2)) continue;
      own.push_back({component, {}});
      for (int lane = 0; lane < lanes; ++lane) {
        own.back().of_lane.push_back(dice.between(-200, 200));
      }
    }
    REQUIRE(compare(definitions, history, {}, part, own) == lanes);
    drawn.insert({base.slip.dimension, base.stick.mode == StickStiffness::Mode::kStiffness,
                  base.wears(), alike, own.empty()});
  }
}

TEST_CASE("lanes of any form end in the bits of update(), begun in any state") {
  int common = 0;
  int lanes = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const int kind = dice.pick(kDefinitionKinds);
    std::vector<FrictionDefinition> definitions;
    const int count = 1 + dice.pick(40);
    definitions.reserve(static_cast<std::size_t>(count));
    for (int lane = 0; lane < count; ++lane) {
      DefinitionDescription d = random_definition(&dice, kind);
      if (dice.chance(0.4)) d = with_form(&dice, d);
      definitions.push_back(d.build());
    }
    // A state they have come to under another history.
    const Histories before = histories(&dice);
    std::vector<FrictionState> begin;
    begin.reserve(definitions.size());
    for (const FrictionDefinition& definition : definitions) {
      begin.push_back(run_history(definition, before.rows).back().state);
    }
    const Histories history = histories(&dice);
    common += compare(definitions, history, begin, 1);
    lanes += count;
  }
  CHECK(common > lanes / 10);
  CHECK(common < lanes * 9 / 10);
}

TEST_CASE("a pack and its counts forget what their memory held") {
  // Two sliders that begin in slip; the internal contact force of one is a number beside a table.
  std::vector<FrictionDefinition> definitions(2);
  for (FrictionDefinition& definition : definitions) {
    definition.law = ConstantCoefficient{0.5};
    definition.accumulated_slip = AccumulatedSlipTiming::kStart;
    definition.stick = {StickStiffness::Mode::kStiffness, 1000.0};
    definition.internal_contact_force = 100.0;
  }
  definitions[1].internal_contact_force =
      make_function({{100.0, 0.0}, {50.0, 2.0}}, {kOverAccumulatedSlip});
  FrictionState begin;
  begin.regime = Regime::kSlip;
  const std::vector<FrictionState> begins(2, begin);
  alignas(Pack) static std::array<std::byte, sizeof(Pack)> zeros{};
  auto* const pack = new (zeros.data()) Pack(definitions, begins);
  CHECK(pack->state(0).regime == Regime::kSlip);

  std::vector<LaneChanges> changes;
  for (const int run : {1, 2}) {
    // In the memory of the last run's: before its first increment a run has no regime.
    changes.assign(1, {Regime::kOpen, Regime::kSlip});
    pack->follow({}, changes);
    ConnectorIncrement increment;
    increment.end.position[0] = run;
    pack->advance({&increment, 1});
    CHECK(pack->state(0).force[0] == 50.0);
    CHECK(changes[0].count[0] == 0.0);
    changes[0].before.fill(static_cast<double>(Regime::kOpen));
  }
}

TEST_CASE("what the limit sees of the slip keeps a definition off the common path") {
  FrictionDefinition definition;
  definition.law = ConstantCoefficient{0.2};
  const auto form = batch_form(definition);
  REQUIRE(form);
  CHECK(*form == BatchForm{.fixed = false, .dimension = 1, .component = {0, 0}});

  definition.law = ExponentialDecay{0.3, 0.2, 0.05};
  CHECK_FALSE(batch_form(definition));
  definition.slip_rate = SlipRateMeasure::kRelativeMotion;
  CHECK(batch_form(definition));

  definition.internal_contact_force =
      make_function({{80.0, 0.0}, {40.0, 2.0}}, {kOverAccumulatedSlip});
  CHECK_FALSE(batch_form(definition));
  definition.accumulated_slip = AccumulatedSlipTiming::kStart;
  CHECK(batch_form(definition));

  definition.slip = slip_space({1, 2, 3});
  CHECK_FALSE(batch_form(definition));
  definition.slip = slip_space({1, 2});
  definition.formulation = Formulation{.penalty = StiffnessPenalty{1e4}};
  CHECK_FALSE(batch_form(definition));
}

}  // namespace
