// SPDX-License-Identifier: Apache-2.0
#include "law/update/penalty_update.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "law/friction/law_list.hpp"
#include "law/update/penalty_predictor.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;
using std::numbers::pi;

Renard renard() {
  Renard law;
  law.c1 = 0.15;
  law.c2 = 0.10;
  law.c3 = 0.25;
  law.c4 = 0.05;
  law.c5 = 10.0;
  law.c6 = 100.0;
  return law;
}

/// A contact point: component 1 presses, components 2 and 3 slide.
FrictionDefinition contact_point(FrictionLaw law, Formulation formulation, int directions = 1) {
  FrictionDefinition definition;
  definition.slip = directions == 1 ? slip_space({2}) : slip_space({2, 3});
  definition.contact_force = ComponentContactForce{0};
  definition.law = std::move(law);
  definition.formulation = std::move(formulation);
  return definition;
}
Formulation viscous(double coefficient) {
  ViscousPenalty penalty;
  penalty.coefficient = coefficient;
  return {.penalty = penalty};
}
Formulation stiffness(double k) { return {.penalty = StiffnessPenalty{k}}; }
Formulation with(Formulation formulation, Filter filter,
                 Convention convention = Convention::kDocumented) {
  formulation.filter = filter;
  formulation.convention = convention;
  return formulation;
}
Formulation orthotropic(Formulation formulation, double second_mu,
                        Convention convention = Convention::kDocumented) {
  formulation.orthotropy = Orthotropy{.second = ConstantCoefficient{second_mu}};
  formulation.convention = convention;
  return formulation;
}

/// Drives a contact point with velocities and normal forces; every increment starts at 0.
struct Run {
  explicit Run(FrictionDefinition d) : definition(std::move(d)) {}
  FrictionDefinition definition;
  FrictionState state;
  FrictionUpdate last;
  PenaltyDetail detail;
  double dissipation = 0.0;
  double work = 0.0;

  static ConnectorIncrement increment(double dt, double motion2, double motion3, double normal) {
    ConnectorIncrement next;
    next.duration = dt;
    next.end.position[1] = motion2;
    next.end.position[2] = motion3;
    next.force[0] = normal;
    return next;
  }
  const FrictionUpdate& move(double dt, double motion2, double motion3, double normal) {
    last = update_penalty(definition, increment(dt, motion2, motion3, normal), state, &detail);
    state = last.state;
    dissipation += last.dissipation;
    work += last.work;
    return last;
  }
  const FrictionUpdate& slide(double dt, double v2, double v3, double normal) {
    return move(dt, v2 * dt, v3 * dt, normal);
  }
};

/// The histories the reference program was run on: speed and normal force are those of the end of
/// every increment, t = k dt with k from 1.
std::vector<double> harmonic_history(const FrictionDefinition& definition, double amplitude) {
  constexpr double kDt = 1e-4;
  Run run(definition);
  std::vector<double> force{0.0};
  for (int k = 1; k <= 500; ++k) {
    const double t = k * kDt;
    run.slide(kDt, amplitude * std::sin(100.0 * pi * t), 0.0,
              100.0 * (1.0 + 0.5 * std::sin(40.0 * pi * t)));
    force.push_back(run.state.force[0]);
  }
  return force;
}

// Rounding of sin, of v dt and of five hundred increments.
void check_digits(double value, double expected) {
  CHECK(value == Approx(expected).epsilon(2e-13).margin(1e-300));
}

TEST_CASE("a viscous penalty with a simple or a period filter meets the reference history") {
  ViscousPenalty penalty;
  penalty.mass = 1e-3;
  // K = 5000 + F_N.
  penalty.stiffness = make_function({{5000, 0}, {6000, 1000}}, {kOverContactForce});
  const auto history = [&](const Filter& filter) {
    return harmonic_history(
        contact_point(ConstantCoefficient{0.3}, with({.penalty = penalty}, filter)), 100.0);
  };
  const auto simple = history({Filter::Kind::kSimple, 0.1, false});
  check_digits(simple[1], 1.0032409893080816);
  check_digits(simple[10], 19.069107441169447);
  check_digits(simple[500], 22.771027271840186);
  const auto period = history({Filter::Kind::kPeriod, 60e-4, false});
  check_digits(period[1], 1.0505915072634751);
  check_digits(period[10], 19.630311234520690);
  check_digits(period[500], 22.609100480237650);
}

TEST_CASE("a stiffness penalty meets the reference history, without a filter and as coded") {
  const auto plain =
      harmonic_history(contact_point(ConstantCoefficient{0.3}, stiffness(1e4)), 10.0);
  check_digits(plain[1], 0.31410759078128292);
  check_digits(plain[10], 17.122998340917899);
  check_digits(plain[100], 44.206474574921224);
  check_digits(plain[500], 29.811509401749692);
  const Formulation coded =
      with(stiffness(1e4), {Filter::Kind::kSimple, 0.1, false}, Convention::kAsCoded);
  const auto scaled = harmonic_history(contact_point(ConstantCoefficient{0.3}, coded), 10.0);
  check_digits(scaled[1], 0.031410759078128292);
  check_digits(scaled[10], 1.7122998340917901);
  check_digits(scaled[100], 44.175209143415493);
  check_digits(scaled[500], 29.339690656855090);
}

TEST_CASE("as coded a filter takes its part of each increment, and what is stored stays at rest") {
  Run run{contact_point(
      ConstantCoefficient{0.3},
      with(stiffness(1e4), {Filter::Kind::kPeriod, 2e-2 * pi, false}, Convention::kAsCoded))};
  // alpha = 0.1: 0.1 K_t ds = 10 to the limit of 30, then slip; the dissipation is alpha of the
  // work on the limit.
  for (int k = 1; k <= 3; ++k) {
    run.move(1e-3, 0.01, 0.0, 100.0);
    CHECK(run.last.state.force[0] == Approx(10.0 * k).epsilon(1e-14));
    CHECK(run.last.dissipation == Approx(0.0).margin(1e-14));
  }
  run.move(1e-3, 0.02, 0.0, 100.0);
  CHECK(run.last.state.force[0] == 30.0);
  CHECK(run.last.slip_increment == Approx(0.1 * 0.02).epsilon(1e-13));
  CHECK(run.last.dissipation == Approx(0.1 * 30.0 * 0.02).epsilon(1e-13));
  CHECK(run.last.work == Approx(30.0 * 0.02).epsilon(1e-13));
  // Another increment is another alpha; nothing moves, so nothing changes.
  for (const double dt : {1e-4, 1e-2}) {
    run.move(dt, 0.0, 0.0, 100.0);
    CHECK(run.last.state.force[0] == 30.0);
    CHECK(run.last.stored_energy == Approx(30.0 * 30.0 / 2e4).epsilon(1e-14));
  }
}

TEST_CASE("a coefficient that vanishes is no loss of contact: the filter forgets, not restarts") {
  FrictionDefinition definition = contact_point(
      TabularCoefficient{make_function({{0.3, 0}, {0.3, 10}, {0.0, 20}}, {kOverSlipRate})},
      with(stiffness(1e4), {Filter::Kind::kSimple, 0.1, false}));
  Run run{definition};
  for (int k = 0; k < 400; ++k) run.move(1e-3, 0.01, 0.0, 100.0);
  CHECK(run.last.state.force[0] == Approx(30.0).epsilon(1e-14));
  run.move(1e-3, 0.03, 0.0, 100.0);  // a speed beyond 20: mu = 0
  CHECK(run.last.mu == 0.0);
  CHECK(run.last.state.force[0] == Approx(27.0).epsilon(1e-14));
  CHECK(run.last.state.elastic_slip[0] == 0.0);
  run.move(1e-3, 0.01, 0.0, 0.0);  // lift-off
  CHECK(run.last.state.force[0] == 0.0);
  run.move(1e-3, 0.01, 0.0, 100.0);
  CHECK(run.last.state.force[0] == Approx(3.0).epsilon(1e-14));
}

TEST_CASE("Renard friction in two directions meets the reference history") {
  const auto at = [](const Formulation& formulation, int steps) {
    constexpr double kDt = 1e-4;
    Run run(contact_point(renard(), formulation, 2));
    for (int k = 1; k <= steps; ++k) {
      const double t = k * kDt;
      run.slide(kDt, 200.0 * (t / 0.05) * std::cos(80.0 * pi * t),
                120.0 * (t / 0.05) * std::sin(120.0 * pi * t), 100.0);
    }
    return run.state.force;
  };
  ViscousPenalty penalty;
  penalty.stiffness = 5100.0;
  penalty.mass = 1e-3;
  const auto fast = at({.penalty = penalty}, 50);
  check_digits(fast[0], 11.874198073023681);
  check_digits(fast[1], 21.927014355901857);
  const auto stiff = at(stiffness(1e4), 50);
  check_digits(stiff[0], 12.913254185916179);
  check_digits(stiff[1], 21.331629210429373);
  const auto late = at(stiffness(1e4), 500);
  check_digits(late[0], 9.9900135851177918);
  // The small entry has the rounding of the large one.
  CHECK(std::abs(late[1] + 0.011285918482703687) < 1e-13);
}

TEST_CASE("the viscous coefficient takes VISF as the page says or as the program does") {
  ViscousPenalty penalty;
  penalty.visf = 4.0;
  penalty.stiffness = 5100.0;
  penalty.mass = 1e-3;
  const Ambient end;
  check_digits(viscous_coefficient(penalty, Convention::kDocumented, end, 0.0).value,
               12.774975538137051);
  check_digits(viscous_coefficient(penalty, Convention::kAsCoded, end, 0.0).value,
               6.3874877690685254);
  penalty.coefficient = 7.0;
  CHECK(viscous_coefficient(penalty, Convention::kAsCoded, end, 0.0).value == 7.0);
}

TEST_CASE("a normal stiffness out of its range counts as none") {
  ViscousPenalty penalty;
  penalty.mass = 1.0;
  penalty.stiffness =
      make_function({{2, 0}, {1, 1}}, {kOverContactForce}, 1, Extrapolation::kLinear);
  const Ambient end;
  CHECK(viscous_coefficient(penalty, Convention::kDocumented, end, 5.0).value == 0.0);
  CHECK(viscous_coefficient(penalty, Convention::kDocumented, end, 5.0).to_normal_force == 0.0);
  // K = 0.5: little is not none.
  CHECK(viscous_coefficient(penalty, Convention::kDocumented, end, 1.5).value == Approx(1.0));
  const auto c = viscous_coefficient(penalty, Convention::kDocumented, end, 0.5);
  CHECK(c.value == Approx(std::sqrt(3.0)));
  CHECK(c.to_normal_force == Approx(-1.0 / std::sqrt(3.0)));
}

TEST_CASE("the viscous force is steady, without memory, odd, and cut at the limit") {
  Run run(contact_point(ConstantCoefficient{0.2}, viscous(2.0)));
  for (const double v : {0.0, 1e-3, 4.0, 9.999, 10.0, 10.001, 500.0, -3.0, -500.0}) {
    run.slide(0.01, v, 0.0, 100.0);
    CHECK(
        run.state.force[0] ==
        Approx(std::copysign(std::min(2.0 * std::abs(v), 20.0), v)).epsilon(1e-15).margin(1e-300));
    CHECK((run.state.regime == Regime::kSlip) == (std::abs(v) > 10.0));
    CHECK(run.last.slip_increment == Approx(std::abs(v) * 0.01).epsilon(1e-15).margin(1e-300));
    CHECK(run.last.stored_energy == 0.0);
    CHECK(run.state.elastic_slip[0] == 0.0);
    CHECK(run.last.work == run.last.dissipation);
  }
}

TEST_CASE("a load below the limit creeps through a viscous penalty at P/C") {
  // The force that balances P = 7 is reached at the speed P/C = 3.5 and no other.
  Run run(contact_point(ConstantCoefficient{0.2}, viscous(2.0)));
  double creep = 0.0;
  for (int k = 0; k < 100; ++k) {
    run.slide(0.01, 3.5, 0.0, 100.0);
    creep += 0.035;
    CHECK(run.state.force[0] == Approx(7.0).epsilon(1e-15));
    CHECK(run.state.regime == Regime::kStick);
  }
  CHECK(run.state.accumulated_slip == Approx(creep).epsilon(1e-14));
}

TEST_CASE("under constant speed a stiffness penalty gives min(K V t, mu N) at any increment") {
  for (const double dt : {1e-3, 0.013, 0.1, 0.7, 5.0}) {
    Run run(contact_point(ConstantCoefficient{0.2}, stiffness(50.0), 2));
    for (int k = 1; k <= 7; ++k) {
      run.slide(dt, 0.6, -0.8, 100.0);
      const double force = std::min(50.0 * k * dt, 20.0);
      // Rounding of the sums.
      CHECK(run.state.force[0] == Approx(0.6 * force).epsilon(1e-14));
      CHECK(run.state.force[1] == Approx(-0.8 * force).epsilon(1e-14));
    }
    const double slip = std::max(0.0, 7.0 * dt - 20.0 / 50.0);
    CHECK(run.state.accumulated_slip == Approx(slip).epsilon(1e-13).margin(1e-15));
    CHECK(run.dissipation == Approx(20.0 * slip).epsilon(1e-13).margin(1e-13));
    CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-13));
  }
}

TEST_CASE("the filter answers a step of the force as the recursion says") {
  for (const double alpha : {0.01, 0.2, 0.5, 1.0}) {
    Run run(contact_point(ConstantCoefficient{0.2},
                          with(viscous(1e3), {Filter::Kind::kSimple, alpha, false})));
    for (int n = 1; n <= 20; ++n) {
      run.slide(0.01, 1.0, 0.0, 100.0);
      CHECK(run.state.force[0] ==
            Approx(20.0 * (1.0 - std::pow(1.0 - alpha, n))).epsilon(1e-14));  // rounding
      CHECK(run.detail.raw[0] == 20.0);
      CHECK(run.detail.alpha == alpha);
    }
  }
  Run run(contact_point(ConstantCoefficient{1.0},
                        with(viscous(1e3), {Filter::Kind::kSimple, 0.2, false})));
  std::vector<double> force{0.0};
  for (int n = 1; n <= 20; ++n) force.push_back(run.slide(0.01, 1.0, 0.0, 1.0).state.force[0]);
  check_digits(force[1], 0.2);
  check_digits(force[5], 0.67232);
  check_digits(force[10], 0.8926258176);
  CHECK(force[20] == Approx(0.988470784953932).epsilon(1e-14));
}

TEST_CASE("the filter lets half the power of a harmonic pass at its exact cut step") {
  for (const double alpha : {0.01, 0.1, 0.2, 0.5, 0.8}) {
    const double step = std::acos(1.0 - alpha * alpha / (2.0 * (1.0 - alpha)));
    // A force below the limit is C v: a harmonic motion in two directions turns steadily, so its
    // magnitude is that of the filter's answer.
    Run run(contact_point(ConstantCoefficient{1.0},
                          with(viscous(1.0), {Filter::Kind::kSimple, alpha, false}), 2));
    for (int k = 1; k <= 4000; ++k) {
      run.slide(0.01, std::cos(k * step), std::sin(k * step), 100.0);
    }
    // Rounding; what is left of the start is below (1 - 0.01)^4000 = 4e-18.
    CHECK(std::hypot(run.state.force[0], run.state.force[1]) ==
          Approx(std::sqrt(0.5)).epsilon(1e-12));
  }
}

TEST_CASE("the filter smooths what a stiffness penalty gives and leaves its memory alone") {
  const Filter filter{Filter::Kind::kSimple, 0.25, false};
  Run smooth(contact_point(ConstantCoefficient{0.2}, with(stiffness(50.0), filter)));
  Run plain(contact_point(ConstantCoefficient{0.2}, stiffness(50.0)));
  double expected = 0.0;
  Dice dice(3);
  for (int k = 0; k < 200; ++k) {
    const double v = dice.between(-30.0, 30.0), n = dice.between(0.0, 100.0);
    smooth.slide(0.01, v, 0.0, n);
    plain.slide(0.01, v, 0.0, n);
    expected = 0.25 * plain.state.force[0] + 0.75 * expected;
    // Rounding of K (F/K).
    CHECK(smooth.detail.raw[0] == Approx(plain.state.force[0]).epsilon(1e-13).margin(1e-13));
    CHECK(smooth.state.force[0] == Approx(expected).epsilon(1e-13).margin(1e-13));
    CHECK(smooth.last.dissipation == Approx(plain.last.dissipation).epsilon(1e-12).margin(1e-13));
    CHECK(smooth.last.limit == plain.last.limit);
  }
}

TEST_CASE("a falling normal force leaves the filtered force above the limit unless it is clipped") {
  Filter filter{Filter::Kind::kSimple, 0.1, false};
  const auto after_fall = [&] {
    Run run(contact_point(ConstantCoefficient{0.2}, with(stiffness(1e3), filter), 2));
    for (int k = 0; k < 200; ++k) run.slide(0.01, 3.0, 4.0, 100.0);
    run.slide(0.01, 4.0, 3.0, 50.0);
    return run;
  };
  const Run over = after_fall();
  CHECK(over.last.limit == Approx(10.0));
  // 0.9 of the 20 before and 0.1 of the 10 now, nearly in one direction.
  CHECK(std::hypot(over.state.force[0], over.state.force[1]) == Approx(19.0).epsilon(2e-3));
  filter.clip = true;
  const Run clipped = after_fall();
  CHECK(std::hypot(clipped.state.force[0], clipped.state.force[1]) == Approx(10.0).epsilon(1e-14));
  CHECK(clipped.state.force[0] / clipped.state.force[1] ==
        Approx(over.state.force[0] / over.state.force[1]).epsilon(1e-14));
}

TEST_CASE("lift-off opens the contact: memory and filter start again from 0") {
  for (const Formulation& formulation : {stiffness(50.0), viscous(2.0)}) {
    Run run(contact_point(ConstantCoefficient{0.2},
                          with(formulation, {Filter::Kind::kSimple, 0.5, false})));
    for (int k = 0; k < 20; ++k) run.slide(0.01, 30.0, 0.0, 100.0);
    CHECK(run.state.force[0] > 19.0);
    const double slip = run.state.accumulated_slip;
    run.slide(0.01, 30.0, 0.0, 0.0);
    CHECK(run.state.regime == Regime::kOpen);
    CHECK(run.state.force[0] == 0.0);
    CHECK(run.state.elastic_slip[0] == 0.0);
    CHECK(run.state.accumulated_slip == slip);
    CHECK(run.last.dissipation == 0.0);
    run.slide(0.01, 1e3, 0.0, 100.0);
    // Half of 20 for the filter starts at 0; the spring alone would give 50 * 10 > 20.
    CHECK(run.state.force[0] == Approx(10.0).epsilon(1e-14));
  }
}

TEST_CASE("an increment without duration has no speed") {
  SECTION("a viscous force is held, down to the limit") {
    Run run(contact_point(ConstantCoefficient{0.2}, viscous(2.0)));
    CHECK(run.move(0.0, 0.0, 0.0, 100.0).state.force[0] == 0.0);
    run.slide(0.01, 7.0, 0.0, 100.0);
    CHECK(run.move(0.0, 0.0, 0.0, 80.0).state.force[0] == Approx(14.0));
    CHECK(run.last.slip_increment == 0.0);
    CHECK(run.state.regime == Regime::kStick);
    CHECK(run.move(0.0, 0.0, 0.0, 50.0).state.force[0] == Approx(10.0));
  }
  SECTION("motion in no time puts a viscous force on the limit") {
    Run run(contact_point(ConstantCoefficient{0.2}, viscous(2.0), 2));
    run.move(0.0, -3e-9, 4e-9, 100.0);
    CHECK(run.state.force[0] == Approx(-12.0).epsilon(1e-14));
    CHECK(run.state.force[1] == Approx(16.0).epsilon(1e-14));
    CHECK(run.state.regime == Regime::kSlip);
    Run without(contact_point(ConstantCoefficient{0.2}, viscous(0.0)));
    CHECK(without.move(0.0, 1.0, 0.0, 100.0).state.force[0] == 0.0);
  }
  SECTION("a stiffness penalty sees the motion") {
    Run run(contact_point(ConstantCoefficient{0.2}, stiffness(50.0)));
    CHECK(run.move(0.0, 0.1, 0.0, 100.0).state.force[0] == Approx(5.0));
    CHECK(run.move(0.0, 1.0, 0.0, 100.0).state.force[0] == Approx(20.0));
    CHECK(run.last.slip_rate == 0.0);
  }
  SECTION("a filter over time does not move") {
    Run run(contact_point(ConstantCoefficient{0.2},
                          with(stiffness(50.0), {Filter::Kind::kPeriod, 0.1, false})));
    run.slide(0.01, 100.0, 0.0, 100.0);
    const double before = run.state.force[0];
    CHECK(run.move(0.0, 0.1, 0.0, 100.0).state.force[0] == before);
  }
}

TEST_CASE("the orthotropic trial of the reference is returned, in any frame") {
  const double f = 30.0 * std::numbers::sqrt2;
  for (const double turn : {0.0, 0.4, 2.5}) {
    const double c = std::cos(turn), s = std::sin(turn);
    const auto force_of = [&](Convention convention) {
      Formulation formulation = orthotropic(stiffness(1.0), 0.1, convention);
      formulation.orthotropy->first = {c, s};
      Run run(contact_point(ConstantCoefficient{0.3}, formulation, 2));
      run.move(1.0, f * (c - s), f * (s + c), 100.0);
      const auto& y = run.state.force;
      return std::array{c * y[0] + s * y[1], -s * y[0] + c * y[1]};
    };
    const auto closest = force_of(Convention::kDocumented);
    // Printed with twelve digits behind the point.
    CHECK(std::abs(closest[0] - 24.687131330648) < 2e-12);
    CHECK(std::abs(closest[1] - 5.681798880473) < 2e-12);
    const auto ratio = force_of(Convention::kAsCoded);
    CHECK(std::abs(ratio[0] - 26.939972582437) < 2e-12);
    CHECK(std::abs(ratio[1] - 4.399973197615) < 2e-12);
  }
}

/// The force of steady sliding at 45 degrees with a given elastic force per increment.
std::array<double, 6> steady_force(const Formulation& formulation, double dt, int increments) {
  Run run(contact_point(ConstantCoefficient{0.3}, formulation, 2));
  for (int k = 0; k < increments; ++k) {
    run.slide(dt, std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0, 100.0);
  }
  return run.state.force;
}

TEST_CASE("steady orthotropic sliding dissipates most, whatever the increment") {
  for (const double per_increment : {0.3, 1.0, 100.0, 1e4}) {
    const auto force = steady_force(orthotropic(stiffness(1.0), 0.1), per_increment, 3000);
    // Printed with twelve digits behind the point.
    CHECK(std::abs(force[0] - 28.460498941515) < 1e-12);
    CHECK(std::abs(force[1] - 3.162277660168) < 1e-12);
  }
  Run run(contact_point(ConstantCoefficient{0.3}, orthotropic(viscous(1.0), 0.1), 2));
  run.slide(1.0, 1e18, 1e18, 100.0);
  CHECK(std::abs(run.state.force[0] - 28.460498941515) < 1e-12);
  CHECK(run.last.dissipation == Approx(run.state.force[0] * 1e18 + run.state.force[1] * 1e18));
}

TEST_CASE("as coded steady orthotropic sliding depends on the increment, to first order") {
  const Formulation coded = orthotropic(stiffness(1.0), 0.1, Convention::kAsCoded);
  // K_t V dt = N/100 = 1.
  const auto force = steady_force(coded, 1.0, 3000);
  CHECK(std::abs(force[0] - 28.8035165194) < 1e-10);  // printed with ten digits
  CHECK(std::abs(force[1] - 2.7959779866) < 1e-10);
  double previous = 0.0;
  for (const double dt : {0.08, 0.04, 0.02, 0.01}) {
    const auto f = steady_force(coded, dt, static_cast<int>(600.0 / dt));
    const double error = std::abs(f[1] - 3.162277660168);
    // First order, with a second-order rest.
    if (previous > 0.0) CHECK(previous / error == Approx(2.0).epsilon(0.02));
    previous = error;
  }
  CHECK(previous < 5e-3);
}

TEST_CASE("viscous creep below the ellipse is isotropic, C v in both directions") {
  Run run(contact_point(ConstantCoefficient{0.3}, orthotropic(viscous(2.0), 0.1), 2));
  run.slide(0.1, 5.0, -2.0, 100.0);
  CHECK(run.state.force[0] == Approx(10.0));
  CHECK(run.state.force[1] == Approx(-4.0));
  CHECK(run.state.regime == Regime::kStick);
  // In the direction of the force: 1/sqrt((c/0.3)^2 + (s/0.1)^2).
  const double c = 5.0 / std::sqrt(29.0), s = 2.0 / std::sqrt(29.0);
  CHECK(run.last.mu == Approx(1.0 / std::hypot(c / 0.3, s / 0.1)).epsilon(1e-14));
  CHECK(run.last.limit == Approx(100.0 * run.last.mu).epsilon(1e-14));
}

TEST_CASE("the coefficients of an orthotropic law see the speed along their own axes") {
  const ExponentialDecay first{0.4, 0.2, 0.5}, second{0.3, 0.1, 0.2};
  const auto mu = [](const ExponentialDecay& law, double v) {
    return law.evaluate({}, {.slip_rate = v}).mu;
  };
  Formulation formulation = stiffness(1e4);
  formulation.orthotropy = Orthotropy{.second = second};
  const auto coefficients = [&] {
    Run run(contact_point(first, formulation, 2));
    run.slide(0.1, 3.0, -4.0, 100.0);
    return run.detail;
  };
  CHECK(coefficients().speed == Approx(5.0));
  CHECK(coefficients().mu[0] == Approx(mu(first, 3.0)));
  CHECK(coefficients().mu[1] == Approx(mu(second, 4.0)));
  formulation.orthotropy->speed = Orthotropy::Speed::kTotal;
  CHECK(coefficients().mu[0] == Approx(mu(first, 5.0)));
  CHECK(coefficients().mu[1] == Approx(mu(second, 5.0)));
  formulation.orthotropy->speed = Orthotropy::Speed::kComponent;
  formulation.convention = Convention::kAsCoded;
  CHECK(coefficients().mu[0] == Approx(mu(first, 3.0)));
  CHECK(coefficients().speeds[1] == 1e-30);
  CHECK(coefficients().mu[1] == Approx(0.3));
}

TEST_CASE("a direction without friction slides freely, the other one holds") {
  Run run(contact_point(ConstantCoefficient{0.3}, orthotropic(stiffness(10.0), 0.0), 2));
  run.slide(1.0, 1.0, 5.0, 100.0);
  CHECK(run.state.force[0] == Approx(10.0));
  CHECK(run.state.force[1] == 0.0);
  CHECK(run.state.regime == Regime::kSlip);
  CHECK(run.last.slip_increment == Approx(5.0));
  CHECK(run.last.dissipation == 0.0);
  // It slips, so the force is the limit in its direction, as with a hint of friction along 2.
  CHECK(run.last.limit == Approx(10.0));
  CHECK(run.last.mu == Approx(0.1));
  run.slide(1.0, 5.0, 0.0, 100.0);
  CHECK(run.state.force[0] == Approx(30.0));
  CHECK(run.last.dissipation == Approx(30.0 * 3.0));
  CHECK(run.last.limit == Approx(30.0));
  CHECK(run.last.mu == Approx(0.3));
}

TEST_CASE("a thin ellipse along an axis between the components has the coefficient of that axis") {
  Formulation formulation = orthotropic(stiffness(10.0), 1e-12);
  formulation.orthotropy->first = {0.6, 0.8};
  Run run(contact_point(ConstantCoefficient{0.3}, formulation, 2));
  run.slide(1.0, 0.6 * 77.7, 0.8 * 77.7, 100.0);
  CHECK(run.state.regime == Regime::kSlip);
  CHECK(run.last.mu == Approx(0.3).epsilon(1e-14));
  CHECK(run.last.limit == Approx(30.0).epsilon(1e-14));
}

TEST_CASE("a filter and its clip see no rounding across an axis without friction") {
  Formulation formulation = orthotropic(stiffness(10.0), 0.0);
  formulation.filter = {Filter::Kind::kSimple, 0.58, true};
  Run along(contact_point(ConstantCoefficient{0.3}, formulation, 2));
  formulation.orthotropy->first = {0.6, 0.8};
  Run turned(contact_point(ConstantCoefficient{0.3}, formulation, 2));
  for (const double v : {7.7, -5.3, 0.31, 11.0, -0.7, -9.1, 2.9, -3.3, 0.9, 1.7}) {
    along.slide(1.0, v, 0.0, 100.0);
    turned.slide(1.0, 0.6 * v, 0.8 * v, 100.0);
    CHECK(turned.state.regime == along.state.regime);
    const double force = 0.6 * turned.state.force[0] + 0.8 * turned.state.force[1];
    CHECK(force == Approx(along.state.force[0]).margin(1e-13));
  }
}

TEST_CASE("a force limit bounds both axes, and slopes and coefficients stay those of the law") {
  FrictionDefinition definition =
      contact_point(ConstantCoefficient{0.3}, orthotropic(stiffness(10.0), 0.1), 2);
  definition.force_limit = 15.0;
  Run run(definition);
  run.slide(1.0, 100.0, 0.0, 100.0);
  CHECK(run.state.force[0] == Approx(15.0));
  CHECK(run.last.limit == Approx(15.0));
  CHECK(run.last.mu == Approx(0.3));
  run.slide(1.0, -1.5, 100.0, 100.0);
  CHECK(std::hypot(run.state.force[0], run.state.force[1]) <= 15.0);
  CHECK(run.last.limit ==
        Approx(std::hypot(run.state.force[0], run.state.force[1])).epsilon(1e-14));
}

TEST_CASE("behind a filter the use of an elliptic limit is measured along its axes") {
  Formulation formulation = orthotropic(stiffness(10.0), 0.1);
  formulation.filter = {Filter::Kind::kSimple, 0.5, false};
  FrictionDefinition definition = contact_point(ConstantCoefficient{0.3}, formulation, 2);
  for (const double force_limit : {20.0, kNoForceLimit}) {
    definition.force_limit = force_limit;
    // From rest the filter lets half of a force on the limit pass, along each axis and between.
    for (const auto& [v2, v3] : {std::pair{1e3, 0.0}, {0.0, -1e3}, {1e3, 2e3}}) {
      Run run(definition);
      run.slide(1.0, v2, v3, 100.0);
      CHECK(limit_use(definition, run.last, run.detail) == Approx(0.5).epsilon(1e-14));
    }
  }
}

TEST_CASE("with equal coefficients both orthotropic returns are those of the planar slider") {
  // The circle of radius R the planar slider is known on, at lim = 20, k = 1000, R = 0.05: with n
  // increments a turn the steady lag is a/2 + asin(lim/(k R) cos(a/2)), a = 2 pi/n.
  for (const Convention convention : {Convention::kDocumented, Convention::kAsCoded}) {
    for (const int n : {12, 36, 100, 360}) {
      Formulation formulation = orthotropic(stiffness(1000.0), 0.2, convention);
      formulation.orthotropy->first = {std::cos(0.7), std::sin(0.7)};
      const FrictionDefinition definition = contact_point(ConstantCoefficient{0.2}, formulation, 2);
      FrictionDefinition planar = definition;
      planar.formulation.reset();
      planar.stick = {StickStiffness::Mode::kStiffness, 1000.0};
      FrictionState state, expected;
      const double a = 2.0 * pi / n;
      const auto at = [&](int k) {
        RelativePosition u;
        u[1] = 0.05 * std::cos(a * k);
        u[2] = 0.05 * std::sin(a * k);
        return u;
      };
      for (int k = 1; k <= 6 * n; ++k) {
        ConnectorIncrement increment;
        increment.duration = 0.01;
        increment.begin_position = at(k - 1);
        increment.end.position = at(k);
        increment.force[0] = 100.0;
        state = update(definition, increment, state).state;
        expected = update(planar, increment, expected).state;
        // Rounding of a force of 20, carried along by a contracting map.
        REQUIRE(std::abs(state.force[0] - expected.force[0]) < 1e-13);
        REQUIRE(std::abs(state.force[1] - expected.force[1]) < 1e-13);
      }
      const double angle = std::atan2(state.force[1], state.force[0]);
      const double tangent = std::remainder(6 * n * a + pi / 2.0, 2.0 * pi);
      const double lag = a / 2.0 + std::asin(0.4 * std::cos(a / 2.0));
      // Five turns leave less than 1e-11 of the start.
      CHECK(std::remainder(angle - tangent + lag, 2.0 * pi) == Approx(0.0).margin(1e-10));
    }
  }
}

TEST_CASE("the internal contact force is that of the slip at the start of the increment") {
  FrictionDefinition definition = contact_point(ConstantCoefficient{0.2}, stiffness(1e3));
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force = make_function({{100, 0}, {50, 10}}, {kOverAccumulatedSlip});
  Run run(definition);
  run.slide(1.0, 5.02, 0.0, 0.0);
  CHECK(run.state.force[0] == Approx(20.0));
  CHECK(run.state.accumulated_slip == Approx(5.0));
  run.slide(1.0, 1.0, 0.0, 0.0);
  CHECK(run.last.normal_force == Approx(75.0));
  CHECK(run.state.force[0] == Approx(15.0));
}

}  // namespace
