// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "law/batch/pack.hpp"
#include "law/connection/connection_type.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/known_update.hpp"
#include "law/update/return_mapping.hpp"

/// One increment of the law, timed over whole histories. Every timed run checks where it ended, so
/// that a fast wrong answer cannot win. The column `increment` is the time of one increment.
namespace {

using namespace slipbench::law;
using std::numbers::pi;

constexpr int kIncrements = 100000;
constexpr double kEndTime = 100.0;

/// Motions and loads over the history; one row an increment.
struct History {
  std::vector<double> motion2, motion3, force1, temperature;
};

double time_at(int i) { return kEndTime * i / kIncrements; }

void count_increments(benchmark::State& state, std::size_t lanes = 1) {
  const double increments = static_cast<double>(state.iterations()) * kIncrements;
  state.counters["increment"] =
      benchmark::Counter(increments * static_cast<double>(lanes),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

bool near(double value, double expected, double tolerance) {
  return std::abs(value - expected) <= tolerance * std::abs(expected);
}

TableFunction table(const std::vector<std::vector<double>>& rows,
                    std::vector<Independent> independents) {
  Table built;
  TableError error;
  const int count = static_cast<int>(independents.size());
  Table::build(rows, 1, count, Extrapolation::kConstant, &built, &error);
  return {built, std::move(independents)};
}

/// SLOT, k = 1e4, mu = 0.2, F_int = 10.
FrictionDefinition slot_with_constants() {
  const PredefinedFriction slot = Slot{10.0, 3}.predefined().front();
  FrictionDefinition definition;
  definition.slip = slot.slip;
  definition.contact_force = slot.contact_force;
  definition.internal_contact_force = slot.internal_contact_force;
  definition.law = ConstantCoefficient{0.2};
  definition.stick = {StickStiffness::Mode::kStiffness, 1e4};
  return definition;
}

/// A SLOT under u = sin(2 pi t) and F_N = 50 + 10.
void slot_constants(benchmark::State& state) {
  const FrictionDefinition definition = slot_with_constants();
  std::vector<double> motion;
  for (int i = 0; i <= kIncrements; ++i) motion.push_back(std::sin(2.0 * pi * time_at(i)));
  ConnectorIncrement increment;
  increment.duration = kEndTime / kIncrements;
  increment.force[1] = 50.0;
  for (auto _ : state) {
    FrictionState now;
    double slip = 0.0;
    for (std::size_t i = 1; i <= kIncrements; ++i) {
      increment.begin_position[0] = motion[i - 1];
      increment.end.position[0] = motion[i];
      const FrictionUpdate next = update(definition, increment, now);
      slip += next.slip_increment * next.direction[0];
      now = next.state;
    }
    benchmark::DoNotOptimize(now);
    // Rounding of a hundred thousand sums.
    if (!near(now.force[0], 12.0, 1e-9) || !near(slip, -0.0012, 1e-6) ||
        !near(now.accumulated_slip, 399.5188, 1e-9)) {
      state.SkipWithError("wrong end state");
      break;
    }
  }
  count_increments(state);
}
BENCHMARK(slot_constants)->Name("SLOT, constants")->Unit(benchmark::kMillisecond);

/// mu over slip rate and temperature, F_int over accumulated slip.
FrictionDefinition two_tables(SlipRateMeasure rate, AccumulatedSlipTiming timing) {
  const std::vector<double> rates = {0, 0.5, 1, 2, 5, 10, 20, 50};
  const std::vector<double> temperatures = {0, 50, 100, 200};
  const std::vector<std::vector<double>> mu = {{.30, .27, .25, .23, .20, .18, .17, .16},
                                               {.28, .25, .235, .22, .19, .175, .165, .155},
                                               {.25, .23, .215, .20, .18, .165, .155, .15},
                                               {.20, .19, .18, .17, .16, .15, .145, .14}};
  std::vector<std::vector<double>> rows;
  for (std::size_t t = 0; t < temperatures.size(); ++t) {
    for (std::size_t r = 0; r < rates.size(); ++r) {
      rows.push_back({mu[t][r], rates[r], temperatures[t]});
    }
  }
  const PredefinedFriction plane = SlidePlane{}.predefined().front();
  FrictionDefinition definition;
  definition.slip = plane.slip;
  definition.contact_force = plane.contact_force;
  definition.internal_contact_force =
      table({{100, 0}, {98, 5}, {95, 10}, {90, 20}, {80, 50}, {72, 100}, {60, 500}, {55, 1000}},
            {{IndependentKind::kAccumulatedSlip, 0}});
  definition.law = TabularCoefficient{
      table(rows, {{IndependentKind::kSlipRate, 0}, {IndependentKind::kTemperature, 0}})};
  definition.stick = {StickStiffness::Mode::kStiffness, 2e3};
  definition.slip_rate = rate;
  definition.accumulated_slip = timing;
  return definition;
}

/// A Lissajous path with varying normal force and temperature.
History lissajous() {
  History history;
  for (int i = 0; i <= kIncrements; ++i) {
    const double t = time_at(i);
    history.motion2.push_back(std::sin(2.0 * pi * t));
    history.motion3.push_back(0.5 * std::sin(2.0 * pi * 1.37 * t + 0.3));
    history.force1.push_back(500.0 + 200.0 * std::sin(2.0 * pi * 0.31 * t));
    history.temperature.push_back(60.0 + 40.0 * std::sin(2.0 * pi * 0.05 * t));
  }
  return history;
}

/// Takes increment i of that path.
void take(const History& history, std::size_t i, ConnectorIncrement* increment) {
  increment->begin_position[1] = history.motion2[i - 1];
  increment->begin_position[2] = history.motion3[i - 1];
  increment->end.position[1] = history.motion2[i];
  increment->end.position[2] = history.motion3[i];
  increment->end.temperature = history.temperature[i];
  increment->force[0] = history.force1[i];
}

/// Tells whether the explicit integration of that path ends where it is known to end.
bool is_known_end(const FrictionState& end) {
  return near(end.force[0], 84.1177303524, 1e-10) && near(end.force[1], 55.9984338346, 1e-10) &&
         near(end.accumulated_slip, 504.118416295, 1e-10);
}

/// SLIDE-PLANE with two tables on that path.
void slide_plane_tables(benchmark::State& state, SlipRateMeasure rate, AccumulatedSlipTiming timing,
                        bool known_end) {
  const FrictionDefinition definition = two_tables(rate, timing);
  const History history = lissajous();
  ConnectorIncrement increment;
  increment.duration = kEndTime / kIncrements;
  for (auto _ : state) {
    FrictionState now;
    double limit = 0.0;
    for (std::size_t i = 1; i <= kIncrements; ++i) {
      take(history, i, &increment);
      const FrictionUpdate next = update(definition, increment, now);
      limit = next.limit;
      now = next.state;
    }
    benchmark::DoNotOptimize(now);
    // Implicitly this path is one of chatter, with another end: only admissibility is known.
    const bool right = known_end ? is_known_end(now)
                                 : std::hypot(now.force[0], now.force[1]) <= limit * (1 + 1e-12) &&
                                       near(now.accumulated_slip, 504.118416295, 0.05);
    if (!right) {
      state.SkipWithError("wrong end state");
      break;
    }
  }
  count_increments(state);
}
BENCHMARK_CAPTURE(slide_plane_tables, known, SlipRateMeasure::kRelativeMotion,
                  AccumulatedSlipTiming::kStart, true)
    ->Name("SLIDE-PLANE, two tables, rate of motion, slip at start")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(slide_plane_tables, implicit, SlipRateMeasure::kSlip, AccumulatedSlipTiming::kEnd,
                  false)
    ->Name("SLIDE-PLANE, two tables, slip rate and slip at end, implicit")
    ->Unit(benchmark::kMillisecond);

/// The explicit one as a run takes it in blocks: without the tangent.
void slide_plane_rows(benchmark::State& state) {
  const FrictionDefinition definition =
      two_tables(SlipRateMeasure::kRelativeMotion, AccumulatedSlipTiming::kStart);
  const History history = lissajous();
  ConnectorIncrement increment;
  increment.duration = kEndTime / kIncrements;
  for (auto _ : state) {
    KnownLimits limits(definition);
    std::array<FrictionUpdate, 2> results;
    for (std::size_t i = 1; i <= kIncrements; ++i) {
      take(history, i, &increment);
      const FrictionState& now = results[(i - 1) % 2].state;
      const auto limit_of = [&](double motion) { return limits(increment, now, motion); };
      update_known<2>(definition, increment, now, limit_of, &results[i % 2]);
    }
    if (!is_known_end(results[kIncrements % 2].state)) {
      state.SkipWithError("wrong end state");
      break;
    }
  }
  count_increments(state);
}
BENCHMARK(slide_plane_rows)
    ->Name("SLIDE-PLANE, two tables, rows of a run")
    ->Unit(benchmark::kMillisecond);

/// A pack of definitions, the first of which ends in a known state. The column `increment` is the
/// time of one increment of one lane.
void pack_of(benchmark::State& state, const std::vector<FrictionDefinition>& definitions,
             const std::vector<ConnectorIncrement>& increments, const FrictionState& end) {
  for (auto _ : state) {
    Pack pack(definitions);
    pack.advance(increments);
    const FrictionState now = pack.state(0);
    if (!near(now.force[0], end.force[0], 1e-9) ||
        (end.force[1] != 0.0 && !near(now.force[1], end.force[1], 1e-9)) ||
        !near(now.accumulated_slip, end.accumulated_slip, 1e-9)) {
      state.SkipWithError("wrong end state");
      break;
    }
  }
  count_increments(state, definitions.size());
}

/// SLOT with four numbers that differ from lane to lane.
void slot_pack(benchmark::State& state) {
  std::vector<FrictionDefinition> definitions(kLanes, slot_with_constants());
  for (std::size_t lane = 1; lane < kLanes; ++lane) {
    const double factor = 0.8 + 0.4 * static_cast<double>(lane) / kLanes;
    definitions[lane].law = ConstantCoefficient{0.2 * factor};
    definitions[lane].internal_contact_force = 10.0 / factor;
    definitions[lane].stick.value *= factor * factor;
    definitions[lane].force_limit = 14.0 / factor;
  }
  std::vector<ConnectorIncrement> increments(kIncrements);
  for (int i = 1; i <= kIncrements; ++i) {
    ConnectorIncrement& increment = increments[static_cast<std::size_t>(i) - 1];
    increment.duration = kEndTime / kIncrements;
    increment.force[1] = 50.0;
    increment.begin_position[0] = std::sin(2.0 * pi * time_at(i - 1));
    increment.end.position[0] = std::sin(2.0 * pi * time_at(i));
  }
  pack_of(state, definitions, increments, {.force = {12.0}, .accumulated_slip = 399.5188});
}
BENCHMARK(slot_pack)->Name("SLOT, constants, a pack of lanes")->Unit(benchmark::kMillisecond);

/// SLIDE-PLANE with a table of F_int and a stiffness for each lane, and one of the coefficient.
void slide_plane_pack(benchmark::State& state) {
  std::vector<FrictionDefinition> definitions(
      kLanes, two_tables(SlipRateMeasure::kRelativeMotion, AccumulatedSlipTiming::kStart));
  for (std::size_t lane = 1; lane < kLanes; ++lane) {
    const double factor = 0.8 + 0.4 * static_cast<double>(lane) / kLanes;
    Table& wear = std::get<TableFunction>(definitions[lane].internal_contact_force).table();
    for (std::size_t row = 0; row < wear.rows(); ++row) {
      wear.set_ordinate(row, 0, wear.ordinate(row) * factor);
    }
    definitions[lane].stick.value *= factor;
  }
  const History history = lissajous();
  std::vector<ConnectorIncrement> increments(kIncrements);
  for (std::size_t i = 1; i <= kIncrements; ++i) {
    ConnectorIncrement& increment = increments[i - 1];
    increment.duration = kEndTime / kIncrements;
    increment.begin_position[1] = history.motion2[i - 1];
    increment.begin_position[2] = history.motion3[i - 1];
    increment.end.position[1] = history.motion2[i];
    increment.end.position[2] = history.motion3[i];
    increment.end.temperature = history.temperature[i];
    increment.force[0] = history.force1[i];
  }
  pack_of(state, definitions, increments,
          {.force = {84.1177303524, 55.9984338346}, .accumulated_slip = 504.118416295});
}
BENCHMARK(slide_plane_pack)
    ->Name("SLIDE-PLANE, two tables, a pack of lanes")
    ->Unit(benchmark::kMillisecond);

/// All components swing; the end must lie within the limit, and most increments slip.
void swing(benchmark::State& state, const FrictionDefinition& definition) {
  std::vector<double> motion;
  for (int i = 0; i <= kIncrements; ++i) motion.push_back(0.4 * std::sin(2.0 * pi * time_at(i)));
  ConnectorIncrement increment;
  increment.duration = kEndTime / kIncrements;
  increment.force = {{100, 50, 20, 5, 8, 3}};
  for (auto _ : state) {
    FrictionState now;
    double limit = 0.0;
    int slipping = 0;
    for (std::size_t i = 1; i <= kIncrements; ++i) {
      for (int c = 0; c < definition.slip.dimension; ++c) {
        const int component = definition.slip.component[static_cast<std::size_t>(c)];
        increment.begin_position[component] = motion[i - 1];
        increment.end.position[component] = motion[i];
      }
      const FrictionUpdate next = update(definition, increment, now);
      limit = next.limit;
      slipping += next.state.regime == Regime::kSlip ? 1 : 0;
      now = next.state;
    }
    benchmark::DoNotOptimize(now);
    double square = 0.0;
    for (const double y : now.force) square += y * y;
    if (!(limit > 0.0) || !(std::sqrt(square) <= limit * (1.0 + 1e-12)) ||
        slipping < kIncrements / 2) {
      state.SkipWithError("wrong end state");
      break;
    }
  }
  count_increments(state);
}

/// One row a law and stick mode, some of the contact penalties, one a check of every type with
/// predefined friction.
bool register_rows() {
  const auto add = [](const std::string& name, const FrictionDefinition& definition) {
    benchmark::RegisterBenchmark(name.c_str(), [definition](benchmark::State& state) {
      swing(state, definition);
    })->Unit(benchmark::kMillisecond);
  };
  FrictionDefinition base;
  base.internal_contact_force = 20.0;
  const auto add_law = [&]<class Law>(std::type_identity<Law>) {
    FrictionDefinition definition = base;
    definition.law = Law::example();
    definition.stick = {StickStiffness::Mode::kElasticSlip, 1e-3};
    add("law " + std::string(Law::kName) + ", elastic slip", definition);
    definition.stick = {StickStiffness::Mode::kStiffness, 1e4};
    add("law " + std::string(Law::kName) + ", stiffness", definition);
  };
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    (add_law(std::type_identity<Law>{}), ...);
  }(std::type_identity<LawList>{});

  const auto add_penalty = [&](const std::string& name, const Formulation& formulation) {
    FrictionDefinition definition = base;
    definition.law = ConstantCoefficient{0.2};
    if (formulation.orthotropy) definition.slip = slip_space({1, 2});
    definition.formulation = formulation;
    add("penalty " + name, definition);
  };
  Formulation viscous{.penalty = ViscousPenalty{.coefficient = 1e3}};
  Formulation stiffness{.penalty = StiffnessPenalty{1e4}};
  add_penalty("viscous", viscous);
  add_penalty("stiffness", stiffness);
  stiffness.filter = {Filter::Kind::kSimple, 0.5, false};
  add_penalty("stiffness, filter", stiffness);
  stiffness.filter = {};
  stiffness.orthotropy = Orthotropy{.second = ConstantCoefficient{0.1}};
  add_penalty("stiffness, two directions", stiffness);
  stiffness.convention = Convention::kAsCoded;
  add_penalty("stiffness, two directions as coded", stiffness);

  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (HasPredefinedFriction<Type>) {
      Type type;
      const auto set = [](auto& member) {
        if constexpr (std::is_same_v<decltype(member), double&>) member = 0.5;
      };
      std::apply([&](const auto&... field) { (set(type.*(field.member)), ...); }, Type::fields());
      for (const PredefinedFriction& friction : type.predefined()) {
        FrictionDefinition definition = base;
        definition.slip = friction.slip;
        definition.contact_force = friction.contact_force;
        definition.law = ConstantCoefficient{0.2};
        definition.stick = {StickStiffness::Mode::kElasticSlip, 1e-3};
        const std::string suffix(friction.suffix);
        add("type " + std::string(Type::kInfo.name) + (suffix.empty() ? "" : " " + suffix),
            definition);
      }
    }
  });
  return true;
}
const bool kRegistered = register_rows();

}  // namespace
