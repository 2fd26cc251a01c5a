// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <memory>
#include <type_traits>
#include <variant>
#include <vector>

#include "law/batch/pack.hpp"
#include "law/connection/connection_type.hpp"
#include "law/definition/potential_terms.hpp"
#include "law/exact/continuous_update.hpp"
#include "law/friction/law_list.hpp"
#include "law/sensitivity/sensitivity.hpp"
#include "law/update/connector_tangent.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/definition_numbers.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// Keeps a compiler from leaving out the allocation behind a pointer.
void* volatile kept = nullptr;

TEST_CASE("the counter catches deliberate allocations of every form") {
  CHECK(count_allocations([] {}) == 0);
  CHECK(count_allocations([] {
          const auto one = std::make_unique<int>(1);
          kept = one.get();
        }) == 1);
  CHECK(count_allocations([] {
          std::vector<double> v(100);
          v[0] = 1.0;
          volatile double x = v[0];
          static_cast<void>(x);
        }) == 1);
  struct alignas(64) Wide {
    double x[8];
  };
  CHECK(count_allocations([] {
          const auto wide = std::make_unique<Wide>();
          kept = wide.get();
        }) == 1);
}

std::vector<FrictionLaw> laws() {
  std::vector<FrictionLaw> all = {
      TabularCoefficient{make_function({{0.3, 0, 0, 0}, {0.2, 3, 0, 0}, {0.25, 0, 90, 1}},
                                       {kOverSlipRate, kOverContactForce, over_field(1)})}};
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    (all.push_back(Law::example()), ...);
  }(std::type_identity<LawList>{});
  // Joints and floors within reach of the slip rates of the runs.
  Renard renard = Renard::example();
  renard.c5 = 1.0, renard.c6 = 3.0;
  all.push_back(renard);
  all.push_back(GeneralizedViscous{0.3, -1e-3, 0.2, -1e-3, 1e-5, -0.08, 0.0, 1.0});
  all.push_back(ModifiedDarmstad{0.1, 1e-5, -0.5, -2e-3, -1.0, 0.2, -2.0, 1.0});
  return all;
}

std::vector<InternalContactForce> internal_contact_forces() {
  return {50.0, make_function({{80, 0, -1, 0}, {40, 3, -1, 0}, {70, 0, 1, 0}, {60, 0, 0, 50}},
                              {kOverAccumulatedSlip, over_position(1), kOverTemperature})};
}

/// Every kind of contact force: those of all predefined types, a component, none.
std::vector<std::pair<SlipSpace, ContactForce>> contact_forces() {
  std::vector<std::pair<SlipSpace, ContactForce>> all = {
      {slip_space({1}), NoContactForce{}},
      {slip_space({4, 5, 6}), ComponentContactForce{0}},
      {slip_space({1, 2, 3, 4, 5, 6}), ComponentContactForce{0}}};
  DerivedTerm varying = norm_term({2, 3}, 0.0);
  varying.weight_table = make_function({{1, 2, -1}, {3, 4, 1}}, {over_motion(1)}, 2);
  all.emplace_back(slip_space({2, 3}), DerivedComponent{varying});
  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (HasPredefinedFriction<Type>) {
      Type type;
      const auto set = [](auto& member) {
        if constexpr (std::is_same_v<decltype(member), double&>) member = 0.5;
      };
      std::apply([&](const auto&... field) { (set(type.*(field.member)), ...); }, Type::fields());
      for (const PredefinedFriction& friction : type.predefined()) {
        all.emplace_back(friction.slip, friction.contact_force);
      }
    }
  });
  return all;
}

TEST_CASE("no update, force or tangent allocates, whatever the definition") {
  int updates = 0;
  for (const auto& [space, contact] : contact_forces()) {
    for (const FrictionLaw& law : laws()) {
      for (const InternalContactForce& internal : internal_contact_forces()) {
        for (const StickStiffness stick : {allowable_slip(0.01), fixed_stiffness(1e4)}) {
          for (const SlipRateMeasure rate :
               {SlipRateMeasure::kSlip, SlipRateMeasure::kRelativeMotion}) {
            FrictionDefinition definition;
            definition.slip = space;
            definition.contact_force = contact;
            definition.internal_contact_force = internal;
            definition.law = law;
            definition.stick = stick;
            definition.slip_rate = rate;
            FrictionRun run(definition);
            run.force = {{30, 20, -10, 5, 4, -3}};
            run.fields = {0.0, 0.5};
            run.duration = 0.1;
            double sink = 0.0;
            const std::size_t count = count_allocations([&] {
              for (int i = 1; i <= 20; ++i) {
                for (int c = 0; c < kComponents; ++c) {
                  run.position[c] = 0.1 * (i % 7) * (c % 2 == 0 ? 1.0 : -1.0);
                }
                const ConnectorIncrement increment = run.increment();
                const FrictionUpdate& u = run.step();
                sink += friction_force(definition, u.state)[0];
                sink += connector_tangent(definition, increment, u).to_motion.sum();
                sink += outside(definition.law, increment.end, {}) ? 1.0 : 0.0;
                ++updates;
              }
            });
            CHECK(count == 0);
            CHECK(sink == sink);
          }
        }
      }
    }
  }
  CHECK(updates > 5000);
}

TEST_CASE("no pack of definitions allocates, on the common path or beside it") {
  std::vector<FrictionDefinition> definitions;
  for (const FrictionLaw& law : laws()) {
    FrictionDefinition definition;
    definition.law = law;
    definition.internal_contact_force = 50.0;
    definitions.push_back(definition);
    definition.slip_rate = SlipRateMeasure::kRelativeMotion;
    definition.accumulated_slip = AccumulatedSlipTiming::kStart;
    definition.internal_contact_force =
        make_function({{80, 0}, {40, 0.3}, {60, 0.8}}, {kOverAccumulatedSlip});
    definitions.push_back(definition);
  }
  const std::vector<double> fields = {0.0, 0.5};
  std::vector<ConnectorIncrement> increments(20);
  for (std::size_t i = 0; i < increments.size(); ++i) {
    increments[i].duration = 0.1;
    increments[i].end.position[0] = i % 2 == 0 ? 0.1 : 0.0;
    increments[i].begin_position[0] = i % 2 == 0 ? 0.0 : 0.1;
    increments[i].end.fields = fields;
  }
  std::size_t common = 0;
  double slip = 0.0;
  const std::size_t count = count_allocations([&] {
    Pack pack(definitions);
    pack.advance(increments);
    for (std::size_t lane = 0; lane < definitions.size(); ++lane) {
      common += pack.is_common(lane) ? 1 : 0;
      slip += pack.state(lane).accumulated_slip;
    }
  });
  CHECK(count == 0);
  CHECK(common > 3);
  CHECK(common < definitions.size());
  CHECK(slip > 1.0);
}

TEST_CASE("no belt, potential or exactly integrated increment allocates") {
  std::vector<FrictionDefinition> definitions(4 + laws().size());
  definitions[0].slip = slip_space({2});
  definitions[0].contact_force = ComponentContactForce{0};
  definitions[0].criterion = Capstan{2.0};
  definitions[0].law = ConstantCoefficient{0.2};
  std::vector<PotentialContribution> terms(2);
  terms[0].of = 1;
  terms[1].of = 2;
  terms[1].scale = 0.5;
  for (const std::size_t i : {1U, 2U}) {
    const BuiltPotential built = build_potential(
        terms, i == 1 ? PotentialOperator::kSum : PotentialOperator::kMax, i == 1 ? 1.5 : 2.0);
    REQUIRE(built.violations.empty());
    definitions[i].slip = built.slip;
    definitions[i].criterion = built.criterion;
    definitions[i].contact_force = ComponentContactForce{0};
    definitions[i].law = ConstantCoefficient{0.2};
  }
  definitions[3].slip = slip_space({2, 3});
  definitions[3].contact_force = ComponentContactForce{0};
  definitions[3].internal_contact_force = internal_contact_forces().back();
  definitions[3].law = ConstantCoefficient{0.2};
  for (std::size_t i = 0; i < laws().size(); ++i) {
    definitions[4 + i] = definitions[0];
    definitions[4 + i].law = laws()[i];
  }

  int moved = 0;
  for (FrictionDefinition& definition : definitions) {
    for (const StickStiffness stick : {allowable_slip(0.01), fixed_stiffness(1e4)}) {
      definition.stick = stick;
      const bool continuous = !no_continuous_solution(definition);
      FrictionRun run(definition);
      run.fields = {0.0, 0.5};
      run.duration = 0.1;
      ConnectorIncrement before = run.increment();
      FrictionState exact;
      CHECK(count_allocations([&] {
              for (int i = 1; i <= 20; ++i) {
                run.position[1] = 0.1 * (i % 7);
                run.position[2] = 0.05 * (i % 5);
                run.force[0] = 20.0 + 3.0 * (i % 4);
                const ConnectorIncrement increment = run.increment();
                const FrictionUpdate& u = run.step();
                moved += connector_tangent(definition, increment, u).to_motion.sum() != 0.0 ? 1 : 0;
                if (continuous) {
                  const FrictionUpdate whole = continuous_update(
                      definition, path_segment(definition, increment, before.end, before.force),
                      exact, 1e-8);
                  exact = whole.state;
                  moved += whole.slip_increment > 0.0 ? 1 : 0;
                }
                before = increment;
              }
            }) == 0);
    }
  }
  CHECK(moved > 160);
}

TEST_CASE("no increment of a contact penalty allocates") {
  ViscousPenalty viscous;
  viscous.mass = 2.0;
  viscous.stiffness =
      make_function({{50, 0, 0}, {60, 90, 0}, {70, 0, 1}}, {kOverContactForce, over_position(2)});
  const Orthotropy orthotropy{.second = ConstantCoefficient{0.1}};
  int moved = 0;
  for (const bool stiff : {false, true}) {
    for (const bool with_axes : {false, true}) {
      for (const Convention convention : {Convention::kDocumented, Convention::kAsCoded}) {
        FrictionDefinition definition;
        definition.slip = slip_space({2, 3});
        definition.contact_force = ComponentContactForce{0};
        definition.law = laws().back();
        Formulation& formulation = definition.formulation.emplace();
        if (stiff) {
          formulation.penalty = StiffnessPenalty{1e3};
        } else {
          formulation.penalty = viscous;
        }
        formulation.filter = {Filter::Kind::kSimple, 0.3, true};
        formulation.convention = convention;
        if (with_axes) formulation.orthotropy = orthotropy;
        FrictionRun run(definition);
        run.fields = {0.0, 0.5};
        run.duration = 0.1;
        CHECK(count_allocations([&] {
                for (int i = 1; i <= 20; ++i) {
                  run.position[1] = 0.1 * (i % 7);
                  run.position[2] = 0.05 * (i % 5);
                  run.force[0] = 20.0 + 3.0 * (i % 4);
                  const ConnectorIncrement increment = run.increment();
                  const FrictionUpdate& u = run.step();
                  moved +=
                      connector_tangent(definition, increment, u).to_motion.sum() != 0.0 ? 1 : 0;
                }
              }) == 0);
      }
    }
  }
  CHECK(moved == 160);
}

TEST_CASE("no table evaluation allocates") {
  Rows rows;
  for (int block = 0; block < 8; ++block) {
    for (int i = 0; i < 8; ++i) rows.push_back({8.0 * block + i, 1.0 * i, 1.0 * block});
  }
  for (const Extrapolation extrapolation : {Extrapolation::kConstant, Extrapolation::kLinear}) {
    const Table table = make_table(rows, 1, 2, extrapolation);
    double sink = 0.0;
    CHECK(count_allocations([&] {
            for (double x = -1.0; x < 9.0; x += 0.1) {
              const std::array<double, 2> at = {x, 8.0 - x};
              std::array<double, 2> slopes{};
              sink += table.value(at) + table.value_and_slopes(at, slopes) + slopes[0];
              sink += table.outside(at) ? 1.0 : 0.0;
            }
          }) == 0);
    CHECK(sink > 0.0);
  }
}

TEST_CASE("no derivative of an increment allocates, whatever the regime") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force = make_function({{100, 0}, {0, 2}}, {kOverAccumulatedSlip});
  definition.law = TabularCoefficient{make_function({{0.3, 0}, {0.2, 10}}, {kOverSlipRate})};
  definition.contact_force = DerivedComponent{norm_term({2, 3}, 2.0)};
  for (const StickStiffness stick : {allowable_slip(0.01), fixed_stiffness(1e4)}) {
    definition.stick = stick;
    DefinitionSlopes slopes;
    for (const DefinitionNumber& number : numbers_of(definition)) {
      REQUIRE(add_slopes(definition, number.at(definition, number.value + 1), 1.0, slopes.unknowns,
                         &slopes));
    }
    FrictionRun run(definition);
    StateSlopes state(definition, slopes);
    const double motions[] = {0.002, 0.5, 0.498, -0.5, 5.0, 5.1};  // at last all is worn away
    std::vector<Regime> seen;
    seen.reserve(8);
    const std::size_t count = count_allocations([&] {
      for (const double motion : motions) {
        run.position[0] = motion;
        run.force[1] = motion < 4.0 ? 10.0 : 0.0;
        const FrictionState old = run.state;
        const ConnectorIncrement increment = run.increment();
        state.advance(increment, old, run.step());
        seen.push_back(run.state.regime);
      }
    });
    CHECK(count == 0);
    CHECK(seen.front() == Regime::kStick);
    CHECK(seen[1] == Regime::kSlip);
    CHECK(seen.back() == Regime::kOpen);
  }
}

}  // namespace
