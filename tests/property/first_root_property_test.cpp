// SPDX-License-Identifier: Apache-2.0
// With a constant stick stiffness and a limit that falls with slip, several slips may put the force
// on its limit. The law takes the first; a scan of the increment is the judge.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "law/update/return_mapping.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/random_definition.hpp"

namespace slipbench::law {
namespace {

using test::Dice;
using test::random_darmstad;
using test::random_renard;
using test::random_viscous;

TableFunction over(const std::vector<std::vector<double>>& rows,
                   const std::vector<Independent>& independents) {
  Table table;
  TableError error;
  REQUIRE(Table::build(rows, 1, static_cast<int>(independents.size()), Extrapolation::kConstant,
                       &table, &error));
  return {table, independents};
}

/// Ascending knots, `count` of them from about `first` on with steps in [low, high].
std::vector<double> knots(Dice& dice, int count, double first, double low, double high) {
  std::vector<double> x;
  for (int i = 0; i < count; ++i) {
    x.push_back(first);
    first += dice.between(low, high);
  }
  return x;
}

enum class Kind {
  kContactForce,
  kExponential,
  kRate,
  kRateAndContactForce,
  kViscous,
  kDarmstad,
  kRenard
};

FrictionLaw random_law(Dice& dice, Kind kind) {
  const Independent rate{IndependentKind::kSlipRate, 0};
  const Independent force{IndependentKind::kContactForce, 0};
  const auto mu = [&] { return dice.between(0.05, 0.4); };
  std::vector<std::vector<double>> rows;
  switch (kind) {
    case Kind::kExponential:
      return ExponentialDecay{dice.between(0.2, 0.4), dice.between(0.0, 0.2), dice.between(1, 40)};
    case Kind::kContactForce:
      for (const double n : knots(dice, 2 + dice.pick(4), dice.between(0, 20), 5, 40)) {
        rows.push_back({mu(), n});
      }
      return TabularCoefficient{over(rows, {force})};
    case Kind::kRate:
      for (const double r : knots(dice, 2 + dice.pick(4), 0.0, 0.05, 0.4))
        rows.push_back({mu(), r});
      return TabularCoefficient{over(rows, {rate})};
    // Steep enough, and with rates and forces small enough, for several roots.
    case Kind::kViscous: {
      GeneralizedViscous law = random_viscous(&dice);
      law.c2 *= 10.0, law.c5 *= 50.0, law.c1 *= 5.0, law.c3 *= 10.0, law.c4 *= 5.0;
      return law;
    }
    case Kind::kDarmstad: {
      ModifiedDarmstad law = random_darmstad(&dice);
      for (double* exponent : {&law.c2, &law.c4, &law.c6}) *exponent = dice.between(-40.0, 2.0);
      law.c1 *= 5.0, law.c3 *= 5.0;
      return law;
    }
    case Kind::kRenard: {
      Renard law = random_renard(&dice);
      law.speed_factor = dice.between(2.0, 20.0);
      return law;
    }
    case Kind::kRateAndContactForce:
      for (const double n : knots(dice, 2 + dice.pick(3), dice.between(0, 20), 5, 40)) {
        for (const double r : knots(dice, 2 + dice.pick(3), 0.0, 0.05, 0.4)) {
          rows.push_back({mu(), r, n});
        }
      }
      return TabularCoefficient{over(rows, {rate, force})};
  }
  return ConstantCoefficient{0.0};
}

struct Tally {
  int draws = 0;
  int slips = 0;
  int with_several_roots = 0;
};

constexpr double kSlipRounding = 4.0 * std::numeric_limits<double>::epsilon();

/// Tries as many as are asked for, and more until several have several roots.
Tally try_many(Kind kind, int draws) {
  Dice dice(20240117 + static_cast<std::uint64_t>(kind));
  Tally tally;
  for (int draw = 0; draw < draws || tally.with_several_roots <= 5; ++draw) {
    REQUIRE(draw < 10 * draws);  // else the test would show nothing
    ++tally.draws;
    FrictionDefinition definition;
    definition.slip = slip_space({1});
    definition.law = random_law(dice, kind);
    // Wear, or running-in, with one or two slopes.
    std::vector<std::vector<double>> wear = {{dice.between(20, 100), 0.0}};
    for (const double s : knots(dice, 1 + dice.pick(2), dice.between(0.2, 1.0), 0.2, 1.0)) {
      wear.push_back({dice.between(0, 100), s});
    }
    const TableFunction internal = over(wear, {{IndependentKind::kAccumulatedSlip, 0}});
    definition.internal_contact_force = internal;
    const double kappa = dice.between(5.0, 60.0);
    definition.stick = {StickStiffness::Mode::kStiffness, kappa};
    // Every third in the middle of a change of friction.
    if (dice.chance(0.33)) definition.blend = {dice.between(0.0, 0.4), dice.between(0.3, 1.0)};

    ConnectorIncrement increment;
    increment.duration = 1.0;
    const auto limit = [&](double slip) {
      const double normal = internal.value({}, {.accumulated_slip = slip});
      const CoefficientPoint law =
          evaluate(definition.law, {}, {.slip_rate = slip, .contact_force = normal});
      return blended(definition.blend, law).mu * normal;
    };
    if (!(limit(0.0) > 0.0)) continue;
    const double trial = limit(0.0) * dice.between(1.0001, 2.0);
    increment.end.position[0] = trial / kappa;
    const FrictionUpdate u = update(definition, increment, FrictionState{});
    if (u.state.regime != Regime::kSlip) continue;
    ++tally.slips;

    // The first step of the scan that ends on or below the limit; a root may hide within one step.
    constexpr int kSteps = 2000;
    const double step = trial / kappa / kSteps;
    double first = -1.0;
    int changes = 0;
    bool above = true;
    for (int i = 1; i <= kSteps; ++i) {
      const double slip = step * i;
      const bool now_above = trial - kappa * slip - limit(slip) > 0.0;
      if (now_above != above) {
        ++changes;
        if (first < 0.0) first = slip;
      }
      above = now_above;
    }
    if (changes > 1) ++tally.with_several_roots;
    INFO("kind " << static_cast<int>(kind) << ", draw " << draw << ", kappa " << kappa);
    if (first >= 0.0) REQUIRE(u.slip_increment <= first + 1e-9 * step);
    // It is a root: the residual changes its sign within the rounding of the slip and its own.
    const auto residual = [&](double slip) { return trial - kappa * slip - limit(slip); };
    REQUIRE(residual(u.slip_increment * (1.0 - kSlipRounding)) >= -1e-12 * trial);
    REQUIRE(residual(u.slip_increment * (1.0 + kSlipRounding)) <= 1e-12 * trial);
  }
  return tally;
}

}  // namespace

TEST_CASE("The first root is taken whatever makes the limit fall") {
  const Kind kind =
      GENERATE(Kind::kContactForce, Kind::kExponential, Kind::kRate, Kind::kRateAndContactForce,
               Kind::kViscous, Kind::kDarmstad, Kind::kRenard);
  const Tally tally = try_many(kind, 4000);
  CHECK(tally.slips > tally.draws * 3 / 4);
}

}  // namespace slipbench::law
