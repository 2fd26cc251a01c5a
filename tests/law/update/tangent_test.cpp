// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "law/connection/connection_type.hpp"
#include "law/update/connector_tangent.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/force_difference.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// Branch, the same in all evaluations of a difference quotient: the regime, the side of the
/// force limit, the signs inside absolute values, and the cell of every table.
struct Branch {
  Regime regime = Regime::kOpen;
  bool capped = false;
  bool negative = false;
  std::vector<int> cells;
  friend bool operator==(const Branch&, const Branch&) = default;
};

/// The number of knots at or below x: a cell of the table, whose slope at a knot is right-hand.
int cell(std::span<const double> knots, double x) {
  return static_cast<int>(std::upper_bound(knots.begin(), knots.end(), x) - knots.begin());
}

void add_cells(const TableFunction& function, const Ambient& ambient, const SlipArguments& slip,
               std::vector<int>* cells) {
  for (std::size_t k = 0; k < function.independents().size(); ++k) {
    const Independent& independent = function.independents()[k];
    double x = 0.0;
    switch (independent.kind) {
      case IndependentKind::kSlipRate:
        x = slip.slip_rate;
        break;
      case IndependentKind::kContactForce:
        x = slip.contact_force;
        break;
      case IndependentKind::kAccumulatedSlip:
        x = slip.accumulated_slip;
        break;
      case IndependentKind::kPosition:
        x = ambient.position[independent.index];
        break;
      case IndependentKind::kConstitutiveMotion:
        x = ambient.motion[independent.index];
        break;
      default:
        continue;  // temperature and fields are not varied
    }
    cells->push_back(cell(function.table().knots(static_cast<int>(k)), x));
  }
}

Branch branch_of(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                 const FrictionState& old, const FrictionUpdate& u) {
  Branch branch{u.state.regime, u.limit >= definition.force_limit, u.contact_force < 0.0, {}};
  const bool at_end = definition.accumulated_slip == AccumulatedSlipTiming::kEnd;
  const SlipArguments slip{u.slip_rate, u.normal_force,
                           at_end ? u.state.accumulated_slip : old.accumulated_slip};
  if (const auto* f = std::get_if<TableFunction>(&definition.internal_contact_force)) {
    add_cells(*f, increment.end, slip, &branch.cells);
  }
  if (const auto* law = std::get_if<TabularCoefficient>(&definition.law)) {
    add_cells(law->table, increment.end, slip, &branch.cells);
  }
  if (const auto* g = std::get_if<DerivedComponent>(&definition.contact_force)) {
    for (const DerivedTerm& term : *g) {
      if (term.weight_table) add_cells(*term.weight_table, increment.end, {}, &branch.cells);
    }
  }
  if (std::holds_alternative<UniversalJointContact>(definition.contact_force)) {
    const double alpha = increment.end.position[3], beta = increment.end.position[4];
    const ConnectorForce& f = increment.force;
    const double along_e3b =
        std::sin(beta) * f[0] + std::cos(beta) * (std::cos(alpha) * f[2] - std::sin(alpha) * f[1]);
    branch.cells.push_back(along_e3b < 0.0 ? -1 : 1);
  }
  return branch;
}

/// Compares connector_tangent() with one-sided differences from both sides in all components.
/// \return false if the point is too near an edge of its branch for that; then nothing is compared
bool tangent_meets_differences(const FrictionDefinition& definition,
                               const ConnectorIncrement& increment, const FrictionState& old) {
  const FrictionUpdate here = update(definition, increment, old);
  const Branch branch = branch_of(definition, increment, old, here);
  const ConnectorTangent tangent = connector_tangent(definition, increment, here);
  const auto force_at = [&](const ConnectorIncrement& moved,
                            int component) -> std::optional<double> {
    const FrictionUpdate u = update(definition, moved, old);
    if (!(branch_of(definition, moved, old, u) == branch)) return std::nullopt;
    return friction_force(definition, u.state)[component];
  };
  struct Comparison {
    double analytic, difference, scale;
  };
  std::vector<Comparison> comparisons;
  for (int i = 0; i < kComponents; ++i) {
    for (int j = 0; j < kComponents; ++j) {
      for (const double side : {1.0, -1.0}) {
        const auto by_motion = force_by_motion(force_at, increment, i, j, side * 2e-6);
        const auto by_force = force_by_force(force_at, increment, i, j, side * 2e-3);
        if (!by_motion || !by_force) return false;
        comparisons.push_back({tangent.to_motion(i, j), by_motion->value,
                               tangent.to_motion.cwiseAbs().maxCoeff() + here.limit});
        comparisons.push_back({tangent.to_force(i, j), by_force->value, 1.0});
      }
    }
  }
  for (const Comparison& c : comparisons) {
    // Rounding of a force of some 100 over steps of 2e-6 (2e-3 for forces), amplified by the
    // extrapolation, and the solver's own tolerance in implicit slip.
    const double tolerance = 1e-6 * std::max(1.0, c.scale);
    if (std::abs(c.analytic - c.difference) > tolerance) {
      CHECK(c.analytic == Approx(c.difference).margin(tolerance));
    }
  }
  CHECK(here.state.regime == branch.regime);
  return true;
}

// The choices that make up a definition, one of each list.

std::vector<std::pair<std::string, SlipSpace>> slip_spaces() {
  SlipSpace shaft = slip_space({1, 4});
  shaft.scale[1] = 0.24;
  return {{"1-D", slip_space({1})},
          {"2-D coupled", slip_space({2, 3})},
          {"shaft", shaft},
          {"3-D ball", slip_space({4, 5, 6}, 1.5)}};
}

std::vector<std::pair<std::string, FrictionLaw>> laws() {
  return {{"constant", ConstantCoefficient{0.25}},
          {"exponential", ExponentialDecay{0.3, 0.15, 0.4}},
          {"table", TabularCoefficient{
                        make_function({{0.30, 0, 0, 0},
                                       {0.34, 2, 0, 0},
                                       {0.22, 9, 0, 0},
                                       {0.26, 0, 400, 0},
                                       {0.17, 5, 400, 0},
                                       {0.28, 0, 0, 100},
                                       {0.19, 8, 0, 100},
                                       {0.21, 0, 500, 100},
                                       {0.23, 7, 500, 100}},
                                      {kOverSlipRate, kOverContactForce, kOverTemperature})}}};
}

std::vector<std::pair<std::string, InternalContactForce>> internal_contact_forces() {
  return {{"number", 60.0},
          {"over slip", make_function({{90, 0}, {60, 0.5}, {50, 4}}, {kOverAccumulatedSlip})},
          {"over CP and CU",
           make_function({{60, -1, -1}, {75, 1, -1}, {50, -1, 1}, {95, 0.7, 1}, {90, 2, 1}},
                         {over_position(2), over_motion(4)})},
          {"over slip and CP", make_function({{90, 0, -1}, {60, 3, -1}, {70, 0, 1}, {50, 2, 1}},
                                             {kOverAccumulatedSlip, over_position(1)})}};
}

std::vector<std::pair<std::string, ContactForce>> contact_forces() {
  DerivedTerm bending = norm_term({5, 6}, 0.0);
  bending.weight_table = make_function({{3, 4, -1, 0}, {9, 7, 1, 0}, {5, 2, -1, 2}, {8, 3, 1, 2}},
                                       {over_position(1), over_motion(6)}, 2);
  UniversalJointContact joint{1, 0.4, 0.3, 0.5, 1.2, hinge_shares(3.0)};
  UniversalJointContact other = joint;
  other.axis = 3;
  return {{"component", ComponentContactForce{1}},
          {"derived", DerivedComponent{norm_term({2, 3}, 1.0), bending}},
          {"joint axis 1", joint},
          {"joint axis 3", other}};
}

ConnectorForce random_force(Dice* dice) {
  ConnectorForce force;
  for (int c = 0; c < kComponents; ++c) {
    force[c] = dice->between(5.0, 60.0) * (dice->between(0.0, 1.0) < 0.5 ? -1.0 : 1.0);
  }
  return force;
}

enum class Wanted { kStick, kSlip, kCappedSlip };

/// A point in the wanted branch: the definition after a first, slipping increment, and a second
/// one short enough to stick or long enough to slip.
struct Point {
  FrictionDefinition definition;
  ConnectorIncrement increment;
  FrictionState old;
};

Point random_point(FrictionDefinition definition, Wanted wanted, Dice* dice) {
  if (wanted == Wanted::kCappedSlip) definition.force_limit = 4.0;
  FrictionRun run(definition);
  run.duration = dice->between(0.1, 0.4);
  run.temperature = dice->between(10.0, 90.0);
  run.reference = {{0.01, -0.02, 0.03, -0.01, 0.02, 0.01}};
  run.force = random_force(dice);
  for (int c = 0; c < kComponents; ++c) run.position[c] = dice->between(-0.4, 0.4);
  run.step();
  run.force = random_force(dice);
  // In stick: back by less than the elastic slip, so that the force stays below the limit.
  const double reach = definition.stick.mode == StickStiffness::Mode::kElasticSlip
                           ? definition.stick.value
                           : run.last.limit / definition.stick.value;
  for (int c = 0; c < kComponents; ++c) {
    run.position[c] += wanted == Wanted::kStick
                           ? -dice->between(0.05, 0.35) * reach * run.position[c]
                           : dice->between(-0.4, 0.4);
  }
  return {definition, run.increment(), run.state};
}

TEST_CASE("the consistent tangent meets one-sided differences in every branch") {
  Dice dice(20240611);
  for (const auto& [slip_name, space] : slip_spaces()) {
    for (const auto& [law_name, law] : laws()) {
      for (const auto& [internal_name, internal] : internal_contact_forces()) {
        for (const auto& [contact_name, contact] : contact_forces()) {
          for (const StickStiffness stick : {allowable_slip(0.05), fixed_stiffness(800.0)}) {
            for (const SlipRateMeasure rate :
                 {SlipRateMeasure::kSlip, SlipRateMeasure::kRelativeMotion}) {
              for (const AccumulatedSlipTiming timing :
                   {AccumulatedSlipTiming::kEnd, AccumulatedSlipTiming::kStart}) {
                FrictionDefinition definition;
                definition.slip = space;
                definition.contact_force = contact;
                definition.internal_contact_force = internal;
                definition.law = law;
                definition.stick = stick;
                definition.slip_rate = rate;
                definition.accumulated_slip = timing;
                for (const Wanted wanted : {Wanted::kStick, Wanted::kSlip, Wanted::kCappedSlip}) {
                  INFO(slip_name << ", " << law_name << ", F_int " << internal_name << ", F_C "
                                 << contact_name << ", fixed "
                                 << (stick.mode == StickStiffness::Mode::kStiffness)
                                 << ", relative motion "
                                 << (rate == SlipRateMeasure::kRelativeMotion) << ", slip at start "
                                 << (timing == AccumulatedSlipTiming::kStart) << ", wanted "
                                 << static_cast<int>(wanted));
                  bool met = false;
                  for (int attempt = 0; attempt < 60 && !met; ++attempt) {
                    const Point point = random_point(definition, wanted, &dice);
                    const FrictionUpdate here =
                        update(point.definition, point.increment, point.old);
                    const bool capped = here.limit >= point.definition.force_limit;
                    const Regime regime = wanted == Wanted::kStick ? Regime::kStick : Regime::kSlip;
                    if (here.state.regime != regime || capped != (wanted == Wanted::kCappedSlip)) {
                      continue;
                    }
                    met = tangent_meets_differences(point.definition, point.increment, point.old);
                  }
                  CHECK(met);  // the branch was reached and compared
                }
              }
            }
          }
        }
      }
    }
  }
}

TEST_CASE("the consistent tangent meets differences for all predefined friction at random points") {
  Dice dice(7);
  int compared = 0;
  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (HasPredefinedFriction<Type>) {
      Type type;
      std::apply(
          [&](const auto&... field) {
            [[maybe_unused]] const auto set = [&](auto& member) {
              if constexpr (std::is_same_v<decltype(member), double&>) {
                member = dice.between(0.2, 0.9);
              } else if constexpr (std::is_same_v<decltype(member), InternalContactForce&>) {
                member = make_function({{40, 0}, {30, 2}}, {kOverAccumulatedSlip});
              }
            };
            (set(type.*(field.member)), ...);
          },
          Type::fields());
      for (const PredefinedFriction& friction : type.predefined()) {
        // The capstan has points and branches of its own: law/update/capstan_update_test.
        if (!std::holds_alternative<EuclideanPotential>(friction.criterion)) continue;
        FrictionDefinition definition;
        definition.slip = friction.slip;
        definition.contact_force = friction.contact_force;
        definition.internal_contact_force = friction.internal_contact_force;
        definition.law = ExponentialDecay{0.3, 0.2, 0.3};
        for (const StickStiffness stick : {allowable_slip(0.05), fixed_stiffness(800.0)}) {
          definition.stick = stick;
          for (const Wanted wanted : {Wanted::kStick, Wanted::kSlip}) {
            INFO(Type::kInfo.name << friction.suffix << " fixed "
                                  << (stick.mode == StickStiffness::Mode::kStiffness));
            int met = 0;
            for (int attempt = 0; attempt < 40 && met < 5; ++attempt) {
              const Point point = random_point(definition, wanted, &dice);
              if (tangent_meets_differences(point.definition, point.increment, point.old)) ++met;
            }
            CHECK(met == 5);
            compared += met;
          }
        }
      }
    }
  });
  CHECK(compared == 10 * 2 * 2 * 5);
}

TEST_CASE("the consistent tangent meets differences in the middle of a change of friction") {
  Dice dice(20260611);
  int compared = 0;
  for (const auto& [law_name, law] : laws()) {
    for (const auto& [internal_name, internal] : internal_contact_forces()) {
      FrictionDefinition definition;
      definition.slip = slip_space({2, 3});
      definition.contact_force = DerivedComponent{norm_term({1}, 1.0)};
      definition.internal_contact_force = internal;
      definition.law = law;
      for (const StickStiffness stick : {allowable_slip(0.05), fixed_stiffness(800.0)}) {
        definition.stick = stick;
        for (const Wanted wanted : {Wanted::kStick, Wanted::kSlip}) {
          INFO(law_name << ", F_int " << internal_name << ", fixed "
                        << (stick.mode == StickStiffness::Mode::kStiffness));
          int met = 0;
          for (int attempt = 0; attempt < 60 && met < 3; ++attempt) {
            definition.blend = {dice.between(0.05, 0.5), dice.between(0.05, 0.95)};
            const Point point = random_point(definition, wanted, &dice);
            if (tangent_meets_differences(point.definition, point.increment, point.old)) ++met;
          }
          CHECK(met == 3);
          compared += met;
        }
      }
    }
  }
  CHECK(compared == 3 * 4 * 2 * 2 * 3);
}

TEST_CASE("without contact the tangent is zero") {
  FrictionRun run(slider(0.2, 0.0, allowable_slip(0.01), {2, 3}));
  run.move_to(2, 0.5);
  const ConnectorTangent tangent = connector_tangent(run.definition, run.increment(), run.last);
  CHECK(tangent.to_motion.isZero(0.0));
  CHECK(tangent.to_force.isZero(0.0));
}

TEST_CASE("the tangent has the entries of the table of docs/theory, section 12") {
  // Slip along 2 at constant coefficient: no stiffness along, limit/q across.
  FrictionDefinition definition = slider(0.2, 0.0, allowable_slip(0.02), {2, 3});
  definition.contact_force = DerivedComponent{norm_term({1}, 1.0)};
  FrictionRun run(definition);
  run.force[0] = -100.0;
  const auto tangent_of = [&] { return connector_tangent(definition, run.increment(), run.last); };
  run.position[1] = 0.1;
  const FrictionUpdate elastic = update(definition, run.increment(), run.state);
  ConnectorTangent t = connector_tangent(definition, run.increment(), elastic);
  CHECK(t.to_motion(1, 1) == 0.0);
  CHECK(t.to_motion(2, 2) == Approx(20.0 / 0.1).epsilon(1e-14));
  CHECK(t.to_force(1, 0) == Approx(-0.2).epsilon(1e-14));  // sign of f1
  CHECK(t.to_force(0, 0) == 0.0);
  run.position[1] = 0.01;
  run.step();
  t = tangent_of();
  CHECK(t.to_motion(1, 1) == Approx(1000.0).epsilon(1e-14));
  CHECK(t.to_motion(2, 2) == Approx(1000.0).epsilon(1e-14));
  CHECK(t.to_force(1, 0) == Approx(-0.1).epsilon(1e-14));  // y / F_lim times mu

  definition.stick = fixed_stiffness(500.0);
  FrictionRun fixed(definition);
  fixed.force[0] = 100.0;
  fixed.position[1] = 0.01;
  FrictionUpdate u = update(definition, fixed.increment(), fixed.state);
  t = connector_tangent(definition, fixed.increment(), u);
  CHECK(t.to_motion(1, 1) == 500.0);
  CHECK(t.to_force.isZero(0.0));
  fixed.position[1] = 0.2;
  u = update(definition, fixed.increment(), fixed.state);
  t = connector_tangent(definition, fixed.increment(), u);
  CHECK(t.to_motion(1, 1) == 0.0);
  CHECK(t.to_motion(2, 2) == Approx(20.0 / 0.2).epsilon(1e-14));
  CHECK(t.to_force(1, 0) == Approx(0.2).epsilon(1e-14));
}

}  // namespace
