// SPDX-License-Identifier: Apache-2.0
// Derivatives of short histories whose forces are known in closed form.
#include "law/sensitivity/sensitivity.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "law/friction/law_list.hpp"
#include "tests/support/definition_numbers.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

// All tolerances: rounding of a few operations, unless a comment says otherwise.
constexpr double kRounding = 1e-13;

/// The slopes of a definition to one of its numbers, by name.
DefinitionSlopes slopes_to(const FrictionDefinition& definition, const std::string& name) {
  DefinitionSlopes slopes;
  for (const DefinitionNumber& number : numbers_of(definition)) {
    if (number.name != name) continue;
    // One unit apart: the numbers follow linearly, so that the difference is exact.
    REQUIRE(add_slopes(number.at(definition, number.value), number.at(definition, number.value + 1),
                       1.0, 0, &slopes));
  }
  REQUIRE(slopes.unknowns == 1);
  return slopes;
}

/// The same to an unknown that moves the number three times as far.
DefinitionSlopes thrice(DefinitionSlopes slopes) {
  for (auto* list : {&slopes.stick, &slopes.force_limit, &slopes.law,
                     &slopes.internal_contact_force, &slopes.contact_weights}) {
    for (NumberSlope& slope : *list) slope.slope *= 3.0;
  }
  return slopes;
}

/// A run of one definition with the derivatives to one of its numbers; those to an unknown
/// that moves it three times as far are three times as large.
class SlopeRun {
 public:
  SlopeRun(FrictionDefinition definition, const std::string& name)
      : run_(std::move(definition)),
        numbers_(slopes_to(run_.definition, name)),
        slopes_(run_.definition, numbers_),
        numbers_of_thrice_(thrice(numbers_)),
        thrice_(run_.definition, numbers_of_thrice_) {}

  FrictionRun& run() { return run_; }
  void move_to(int number, double value) {
    run_.position[number - 1] = value;
    const FrictionState old = run_.state;
    const ConnectorIncrement increment = run_.increment();
    slopes_.advance(increment, old, run_.step());
    thrice_.advance(increment, old, run_.last);
    for (int i = 0; i < run_.definition.slip.dimension; ++i) {
      CHECK(thrice_.force(i)[0] == Approx(3.0 * force(i)).epsilon(kRounding).margin(1e-10));
    }
    CHECK(thrice_.accumulated_slip()[0] == Approx(3.0 * slip()).epsilon(kRounding).margin(1e-13));
  }
  Regime regime() const { return run_.state.regime; }
  double force(int entry = 0) const { return slopes_.force(entry)[0]; }
  double slip() const { return slopes_.accumulated_slip()[0]; }

 private:
  FrictionRun run_;
  DefinitionSlopes numbers_;
  StateSlopes slopes_;
  DefinitionSlopes numbers_of_thrice_;
  StateSlopes thrice_;
};

SlopeRun slider_run(const std::string& name, StickStiffness stick) {
  return {slider(0.2, 100.0, stick), name};  // the limit is 20
}

TEST_CASE("in stick the force follows the stiffness alone, over all the motion since slip") {
  SlopeRun to_k = slider_run("stick", fixed_stiffness(1000.0));
  to_k.move_to(1, 0.005);
  to_k.move_to(1, 0.015);
  REQUIRE(to_k.regime() == Regime::kStick);
  CHECK(to_k.force() == Approx(0.015).epsilon(kRounding));
  CHECK(to_k.slip() == 0.0);

  SlopeRun to_mu = slider_run("mu", fixed_stiffness(1000.0));
  to_mu.move_to(1, 0.015);
  CHECK(to_mu.force() == 0.0);
}

TEST_CASE("in slip y = mu N, and the slip falls short by the elastic slip mu N/k") {
  SlopeRun to_mu = slider_run("mu", fixed_stiffness(1000.0));
  to_mu.move_to(1, 0.1);
  REQUIRE(to_mu.regime() == Regime::kSlip);
  CHECK(to_mu.force() == Approx(100.0).epsilon(kRounding));
  CHECK(to_mu.slip() == Approx(-0.1).epsilon(kRounding));  // s = u - mu N/k
  to_mu.move_to(1, 0.09);  // stick on the way back: y = mu N - k (0.1 - u)
  CHECK(to_mu.force() == Approx(100.0).epsilon(kRounding));
  to_mu.move_to(1, -0.1);  // slip: y = -mu N, s = 0.3 - 3 mu N/k
  CHECK(to_mu.force() == Approx(-100.0).epsilon(kRounding));
  CHECK(to_mu.slip() == Approx(-0.3).epsilon(kRounding));

  SlopeRun to_k = slider_run("stick", fixed_stiffness(1000.0));
  to_k.move_to(1, 0.1);
  CHECK(to_k.force() == Approx(0.0).margin(kRounding));
  CHECK(to_k.slip() == Approx(20.0 / 1e6).epsilon(kRounding));
  to_k.move_to(1, 0.09);
  CHECK(to_k.force() == Approx(-0.01).epsilon(kRounding));
}

TEST_CASE("with an allowable elastic slip the force in stick is a part of the limit") {
  SlopeRun to_mu = slider_run("mu", allowable_slip(0.02));
  to_mu.move_to(1, 0.015);  // y = mu N u/g
  CHECK(to_mu.force() == Approx(75.0).epsilon(kRounding));
  to_mu.move_to(1, 0.1);
  CHECK(to_mu.force() == Approx(100.0).epsilon(kRounding));
  CHECK(to_mu.slip() == Approx(0.0).margin(kRounding));  // s = u - g

  SlopeRun to_g = slider_run("stick", allowable_slip(0.02));
  to_g.move_to(1, 0.015);  // -mu N u/g^2
  CHECK(to_g.force() == Approx(-750.0).epsilon(kRounding));
  to_g.move_to(1, 0.1);
  CHECK(to_g.force() == Approx(0.0).margin(1e-10));
  CHECK(to_g.slip() == Approx(-1.0).epsilon(kRounding));
  to_g.move_to(1, 0.09);  // y = mu N (1 - 0.01/g)
  CHECK(to_g.force() == Approx(20.0 * 0.01 / 4e-4).epsilon(kRounding));
}

TEST_CASE("in two dimensions a force that has slipped once keeps turning with the stiffness") {
  // Slip along 1, then a small step along 2: y = mu N (k s_el + k du)/|.|, against differences of
  // the same two steps in closed form.
  const auto forces = [](double mu, double k) {
    const double limit = 100.0 * mu;
    const double trial = k * 0.05;
    const double size = std::hypot(limit, trial);
    return std::pair{limit * limit / size, limit * trial / size};
  };
  for (const std::string name : {"mu", "stick"}) {
    SlopeRun run(slider(0.2, 100.0, fixed_stiffness(1000.0), {1, 2}), name);
    run.move_to(1, 0.1);
    run.move_to(2, 0.05);
    REQUIRE(run.regime() == Regime::kSlip);
    const bool is_mu = name == "mu";
    const double h = is_mu ? 1e-6 : 1e-2;
    const auto above = is_mu ? forces(0.2 + h, 1000.0) : forces(0.2, 1000.0 + h);
    const auto below = is_mu ? forces(0.2 - h, 1000.0) : forces(0.2, 1000.0 - h);
    // The difference quotient: h^2 and rounding over h.
    CHECK(run.force(0) == Approx((above.first - below.first) / (2 * h)).epsilon(1e-8));
    CHECK(run.force(1) == Approx((above.second - below.second) / (2 * h)).epsilon(1e-8));
  }
}

/// F_int = 100 - w s, mu = 0.2: one slipping increment from rest gives, with k = 1000,
///   F = mu (100 - w s), s = u - F/k.
FrictionDefinition wearing(AccumulatedSlipTiming timing) {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force = make_function({{100, 0}, {0, 2}}, {kOverAccumulatedSlip});
  definition.accumulated_slip = timing;
  return definition;
}

TEST_CASE("wear: the limit follows the slip, and the slip follows the ordinates") {
  // With a, b the ordinates at 0 and 2: F = mu (a + (b - a) s/2).
  SlopeRun to_first(wearing(AccumulatedSlipTiming::kEnd), "internal contact force[0]");
  to_first.move_to(1, 0.5);
  const double s = (0.5 - 0.02) / (1.0 - 0.01);
  const double by_first = 0.2 * (1.0 - s / 2) / (1.0 - 0.01);
  CHECK(to_first.run().state.accumulated_slip == Approx(s).epsilon(kRounding));
  CHECK(to_first.force() == Approx(by_first).epsilon(1e-12));
  CHECK(to_first.slip() == Approx(-by_first / 1000).epsilon(1e-12));

  SlopeRun to_last(wearing(AccumulatedSlipTiming::kEnd), "internal contact force[1]");
  to_last.move_to(1, 0.5);
  CHECK(to_last.force() == Approx(0.2 * s / 2 / (1.0 - 0.01)).epsilon(1e-12));

  // Explicit wear sees the slip of the start: first nothing, then what mu has made of it.
  SlopeRun explicit_run(wearing(AccumulatedSlipTiming::kStart), "mu");
  explicit_run.move_to(1, 0.5);
  CHECK(explicit_run.force() == Approx(100.0).epsilon(kRounding));
  explicit_run.move_to(1, 0.6);  // F = mu (100 - 50 (0.5 - mu 100/k))
  CHECK(explicit_run.force() == Approx(100.0 - 25.0 + 2 * 0.2 * 50 * 0.1).epsilon(1e-12));
}

TEST_CASE("grip that is worn away is gone; where it went tells the accumulated slip") {
  // a + (b - a) s with a = 100, b = 40, prolonged to 0 at s = a/(a - b).
  FrictionDefinition definition = wearing(AccumulatedSlipTiming::kEnd);
  definition.internal_contact_force =
      make_function({{100, 0}, {40, 1}}, {kOverAccumulatedSlip}, 1, Extrapolation::kLinear);
  SlopeRun run(definition, "internal contact force[0]");
  run.move_to(1, 5.0);
  REQUIRE(run.regime() == Regime::kOpen);
  CHECK(run.run().state.accumulated_slip == Approx(100.0 / 60.0).epsilon(1e-12));
  CHECK(run.force() == 0.0);
  // -b/(a - b)^2, taken 1e-9 before that place.
  CHECK(run.slip() == Approx(-40.0 / 3600.0).epsilon(1e-8));
  run.move_to(1, 6.0);
  CHECK(run.force() == 0.0);
  CHECK(run.slip() == Approx(-40.0 / 3600.0).epsilon(1e-8));
}

TEST_CASE("where a prolonged table has fallen below 0 its ordinates do not count") {
  // 100 - 60 s is below 0 from s = 1.67 on; the contact force of 50 N holds on.
  FrictionDefinition definition = wearing(AccumulatedSlipTiming::kEnd);
  definition.internal_contact_force =
      make_function({{100, 0}, {40, 1}}, {kOverAccumulatedSlip}, 1, Extrapolation::kLinear);
  definition.contact_force = ComponentContactForce{1};
  for (const std::string name : {"internal contact force[0]", "internal contact force[1]"}) {
    SlopeRun run(definition, name);
    run.run().force[1] = 50.0;
    run.move_to(1, 5.0);
    REQUIRE(run.regime() == Regime::kSlip);
    CHECK(run.run().state.force[0] == Approx(0.2 * 50.0).epsilon(kRounding));
    CHECK(run.force() == 0.0);
  }
}

TEST_CASE("under a force limit only the limit counts") {
  FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(1000.0));
  definition.force_limit = 15.0;
  SlopeRun to_limit(definition, "force limit");
  to_limit.move_to(1, 0.1);
  CHECK(to_limit.force() == Approx(1.0).epsilon(kRounding));
  CHECK(to_limit.slip() == Approx(-1e-3).epsilon(kRounding));
  SlopeRun to_mu(definition, "mu");
  to_mu.move_to(1, 0.1);
  CHECK(to_mu.force() == 0.0);

  definition.stick = allowable_slip(0.02);
  SlopeRun stick(definition, "force limit");
  stick.move_to(1, 0.01);
  CHECK(stick.force() == Approx(0.5).epsilon(kRounding));

  definition.force_limit = 25.0;  // above mu N: it does not act
  SlopeRun idle(definition, "force limit");
  idle.move_to(1, 0.1);
  CHECK(idle.force() == 0.0);
}

TEST_CASE("where nothing holds nothing depends on anything, and it starts afresh") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.contact_force = ComponentContactForce{1};
  SlopeRun run(definition, "mu");
  run.run().force[1] = 100.0;
  run.move_to(1, 0.1);
  CHECK(run.force() == Approx(100.0).epsilon(kRounding));
  run.run().force[1] = 0.0;
  run.move_to(1, 0.2);
  REQUIRE(run.regime() == Regime::kOpen);
  CHECK(run.force() == 0.0);
  CHECK(run.slip() == Approx(-0.1).epsilon(kRounding));
  run.run().force[1] = 100.0;
  run.move_to(1, 0.21);
  REQUIRE(run.regime() == Regime::kStick);
  CHECK(run.force() == 0.0);
}

TEST_CASE("the slip rate: the coefficient slows the slip, and the slip the coefficient") {
  // mu = a + (b - a) v/10, v = s/dt, dt = 0.1, N = 100, k = 1000: F = 100 (a + (b - a) s),
  // s = u - F/k.
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1000.0));
  definition.law = TabularCoefficient{make_function({{0.3, 0}, {0.2, 10}}, {kOverSlipRate})};
  SlopeRun to_first(definition, "coefficient[0]");
  to_first.run().duration = 0.1;
  to_first.move_to(1, 0.5);
  const double s = (0.5 - 0.03) / (1.0 - 0.01);
  CHECK(to_first.run().state.accumulated_slip == Approx(s).epsilon(1e-12));
  CHECK(to_first.force() == Approx(100.0 * (1.0 - s) / (1.0 - 0.01)).epsilon(1e-12));

  // The rate of the motion, 5, is known beforehand.
  definition.slip_rate = SlipRateMeasure::kRelativeMotion;
  SlopeRun known(definition, "coefficient[1]");
  known.run().duration = 0.1;
  known.move_to(1, 0.5);
  CHECK(known.force() == Approx(50.0).epsilon(1e-12));
}

TEST_CASE("constant weights of a derived component count through what they weigh") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.contact_force = DerivedComponent{norm_term({2, 3}, 2.0)};
  SlopeRun run(definition, "weight");  // both at once, so in the direction (1, 1)
  run.run().force[1] = 30.0;
  run.run().force[2] = 40.0;
  run.move_to(1, 1.0);
  CHECK(run.force() == Approx(0.2 * 50.0).epsilon(1e-12));
}

TEST_CASE("a weight of 0 under Macauley brackets is a corner of slope 0") {
  FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(1000.0));
  DerivedTerm term = norm_term({2}, 0.0);
  term.combine = TermOperator::kMacauleySum;
  definition.contact_force = DerivedComponent{term};
  SlopeRun run(definition, "weight");
  run.run().force[1] = 30.0;
  run.move_to(1, 1.0);
  CHECK(run.regime() == Regime::kSlip);
  CHECK(run.force() == 0.0);
}

TEMPLATE_LIST_TEST_CASE("a law's slopes to its numbers are the derivatives of its coefficient", "",
                        LawList) {
  FrictionDefinition definition;
  definition.law = TestType::example();
  Ambient ambient;
  ambient.temperature = 60.0;
  int compared = 0;
  for (const DefinitionNumber& number : numbers_of(definition)) {
    if constexpr (!std::is_same_v<TestType, TabularCoefficient>) {
      if (number.name == "stick" || number.name == "internal contact force") continue;
      for (const double rate : {0.0, 0.7, 3.0, 12.0, 40.0, 150.0}) {
        const SlipArguments slip{.slip_rate = rate, .contact_force = 30.0};
        const double h = 1e-6 * std::max(std::abs(number.value), 1e-6);
        const auto mu = [&](double x) {
          return evaluate(number.at(definition, x).law, ambient, slip).mu;
        };
        const double difference = (mu(number.value + h) - mu(number.value - h)) / (2 * h);
        DefinitionSlopes slopes;
        REQUIRE(add_slopes(number.at(definition, number.value - h),
                           number.at(definition, number.value + h), 2 * h, 0, &slopes));
        REQUIRE(slopes.law.size() == 1);
        CHECK(slopes.law[0].slope == Approx(1.0).epsilon(1e-9));  // rounding over the width
        const auto slopes_of_law = to_numbers(*get_law_if<TestType>(definition.law), ambient, slip);
        INFO(number.name << " at rate " << rate);
        // Rounding of mu over the width.
        CHECK(slopes_of_law[slopes.law[0].number] ==
              Approx(difference).epsilon(1e-7).margin(1e-15 / h));
        ++compared;
      }
    }
  }
  // Tables have ordinates instead.
  if constexpr (!std::is_same_v<TestType, TabularCoefficient>) CHECK(compared >= 6);
}

TEST_CASE("the decay through two points, without mu_inf, has the same slopes") {
  ExponentialTestData law = ExponentialTestData::example();
  law.mu_inf.reset();
  const SlipArguments slip{.slip_rate = 12.0};
  const auto to_numbers = law.to_numbers({}, slip);
  const auto difference = [&](double ExponentialTestData::*member, double h) {
    ExponentialTestData above = law;
    ExponentialTestData below = law;
    above.*member += h;
    below.*member -= h;
    return (above.evaluate({}, slip).mu - below.evaluate({}, slip).mu) / (2 * h);
  };
  // The difference quotient: rounding over the width.
  CHECK(to_numbers[0] == Approx(difference(&ExponentialTestData::mu1, 1e-6)).epsilon(1e-8));
  CHECK(to_numbers[1] == Approx(difference(&ExponentialTestData::mu2, 1e-6)).epsilon(1e-8));
  CHECK(to_numbers[2] == Approx(difference(&ExponentialTestData::rate2, 1e-4)).epsilon(1e-8));
  CHECK(to_numbers[3] == 0.0);
}

TEST_CASE("differences that the derivatives do not cover are refused and leave no trace") {
  const FrictionDefinition base = slider(0.2, 100.0, fixed_stiffness(1000.0));
  DefinitionSlopes slopes;
  const auto refuses = [&](const auto& change) {
    FrictionDefinition other = base;
    other.law = ConstantCoefficient{0.3};
    change(other);
    const bool refused = !add_slopes(base, other, 0.1, 0, &slopes);
    return refused && slopes.unknowns == 0 && slopes.law.empty();
  };
  CHECK(refuses([](auto& d) { d.slip.scale[0] = 2.0; }));
  CHECK(refuses([](auto& d) { d.slip = slip_space({1, 2}); }));
  CHECK(refuses([](auto& d) { d.stick.mode = StickStiffness::Mode::kElasticSlip; }));
  CHECK(refuses([](auto& d) { d.law = ExponentialDecay::example(); }));
  CHECK(refuses([](auto& d) { d.force_limit = 10.0; }));  // there was none
  CHECK(refuses([](auto& d) { d.contact_force = ComponentContactForce{1}; }));
  CHECK(refuses([](auto& d) { d.blend = {0.1, 0.5}; }));
  CHECK(refuses([](auto& d) { d.criterion = Potential{}; }));
  CHECK(refuses([](auto& d) { d.criterion = Capstan{}; }));
  CHECK(refuses([](auto& d) { d.formulation = Formulation{.penalty = StiffnessPenalty{}}; }));
  CHECK(refuses([](auto& d) {
    d.internal_contact_force = make_function({{100, 0}, {0, 2}}, {kOverAccumulatedSlip});
  }));
  CHECK(refuses([](auto& d) { d.slip_rate = SlipRateMeasure::kRelativeMotion; }));
  CHECK(refuses([](auto& d) { d.accumulated_slip = AccumulatedSlipTiming::kStart; }));
  CHECK_FALSE(refuses([](auto&) {}));

  // Points of a table are no ordinates.
  FrictionDefinition table = wearing(AccumulatedSlipTiming::kEnd);
  FrictionDefinition moved = table;
  moved.internal_contact_force = make_function({{100, 0}, {0, 3}}, {kOverAccumulatedSlip});
  DefinitionSlopes none;
  CHECK_FALSE(add_slopes(table, moved, 1.0, 0, &none));
  CHECK(none.unknowns == 0);

  FrictionDefinition renard = base;
  renard.law = Renard::example();
  FrictionDefinition other_unit = renard;
  get_law_if<Renard>(other_unit.law)->speed_factor = 1000.0;
  CHECK_FALSE(add_slopes(renard, other_unit, 1.0, 0, &none));
}

/// Tells whether each of some changes of a definition is refused, from either side, and the
/// definition beside itself is not.
template <class... Change>
bool refuses_each(const FrictionDefinition& base, const Change&... change) {
  [[maybe_unused]] const auto refuses = [&](const auto& one) {
    FrictionDefinition other = base;
    one(other);
    DefinitionSlopes slopes;
    return !add_slopes(base, other, 1.0, 0, &slopes) && !add_slopes(other, base, 1.0, 0, &slopes) &&
           slopes.unknowns == 0;
  };
  DefinitionSlopes slopes;
  return (refuses(change) && ...) && add_slopes(base, base, 1.0, 0, &slopes);
}

TEST_CASE("what is no number of a contact force may not differ") {
  FrictionDefinition joint = slider(0.2, 0.0, fixed_stiffness(1000.0));
  UniversalJointContact contact;
  contact.R_p = contact.R_a = contact.L_s = contact.L_a = 1.0;
  joint.contact_force = contact;
  const auto of = [](FrictionDefinition& d) -> UniversalJointContact& {
    return *std::get_if<UniversalJointContact>(&d.contact_force);
  };
  CHECK(refuses_each(
      joint, [&](auto& d) { of(d).axis = 3; }, [&](auto& d) { of(d).R_p = 2.0; },
      [&](auto& d) { of(d).R_a = 2.0; }, [&](auto& d) { of(d).L_s = 2.0; },
      [&](auto& d) { of(d).L_a = 2.0; }, [&](auto& d) { of(d).shares.k_ax += 1.0; },
      [&](auto& d) { of(d).shares.t_ax += 1.0; }, [&](auto& d) { of(d).shares.k_tw += 1.0; },
      [&](auto& d) { of(d).shares.t_tw += 1.0; },
      [&](auto& d) { d.contact_force = NoContactForce{}; }));

  FrictionDefinition derived = joint;
  const TableFunction weights = make_function({{1, 2, 0}, {3, 4, 1}}, {over_motion(1)}, 2);
  DerivedTerm tabulated = norm_term({2, 3}, 1.0);
  tabulated.weight_table = weights;
  derived.contact_force = DerivedComponent{norm_term({2, 3}, 1.0), tabulated};
  const auto term = [](FrictionDefinition& d, std::size_t t) -> DerivedTerm& {
    return (*std::get_if<DerivedComponent>(&d.contact_force))[t];
  };
  const auto table = [&](const Rows& rows, Independent over) {
    return [=, &term](auto& d) { term(d, 1).weight_table = make_function(rows, {over}, 2); };
  };
  CHECK(refuses_each(
      derived, [&](auto& d) { term(d, 0).combine = TermOperator::kSum; },
      [&](auto& d) { term(d, 0).sign = -1.0; }, [&](auto& d) { term(d, 0).count = 1; },
      [&](auto& d) { term(d, 0).component[0] = 4; },
      [&](auto& d) { term(d, 0).weight_table = weights; },
      [&](auto& d) {
        d.contact_force = DerivedComponent{norm_term({2, 3}, 1.0)};
      },
      table({{1, 2, 0}, {3, 5, 1}}, over_motion(1)), table({{1, 2, 0}, {3, 4, 2}}, over_motion(1)),
      table({{1, 2, 0}, {3, 4, 1}}, over_motion(2)),
      table({{1, 2, 0}, {2, 2, 0.5}, {3, 4, 1}}, over_motion(1))));
}

TEST_CASE("what is no number of a law may not differ") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.law = Renard::example();
  const auto renard = [](FrictionDefinition& d) { return get_law_if<Renard>(d.law); };
  CHECK(refuses_each(
      definition, [&](auto& d) { renard(d)->speed_unit = UnitName{"m/s"}; },
      [&](auto& d) { renard(d)->rules = RenardRules::kLenient; },
      [&](auto& d) { d.law = GeneralizedViscous::example(); }));
  definition.law = GeneralizedViscous::example();
  CHECK(refuses_each(definition,
                     [](auto& d) { get_law_if<GeneralizedViscous>(d.law)->area = std::nullopt; }));
  // Neither has one.
  get_law_if<GeneralizedViscous>(definition.law)->area = std::nullopt;
  CHECK(refuses_each(definition));
  definition.law = TabularCoefficient{make_function({{0.1, 0}, {0.2, 1}}, {kOverSlipRate})};
  const auto table = [](const Rows& rows, Independent over, Extrapolation beyond) {
    return [=](auto& d) { d.law = TabularCoefficient{make_function(rows, {over}, 1, beyond)}; };
  };
  CHECK(refuses_each(definition,
                     table({{0.1, 0}, {0.2, 2}}, kOverSlipRate, Extrapolation::kConstant),
                     table({{0.1, 0}, {0.2, 1}}, kOverContactForce, Extrapolation::kConstant),
                     table({{0.1, 0}, {0.2, 1}}, kOverSlipRate, Extrapolation::kLinear)));
}

TEST_CASE("several unknowns may share a number, and one unknown may move several") {
  const FrictionDefinition base = slider(0.2, 100.0, fixed_stiffness(1000.0));
  DefinitionSlopes slopes;
  FrictionDefinition above = base;
  above.law = ConstantCoefficient{0.4};  // mu = 2 x
  above.internal_contact_force = 130.0;  // F_int = 100 + 30 x
  REQUIRE(add_slopes(base, above, 1.0, 5, &slopes));
  above = base;
  above.law = ConstantCoefficient{0.1};
  REQUIRE(add_slopes(base, above, -1.0, 2, &slopes));
  REQUIRE(slopes.unknowns == 6);
  FrictionRun run(base);
  StateSlopes state(base, slopes);
  run.position[0] = 0.1;
  const ConnectorIncrement increment = run.increment();
  const FrictionState old = run.state;
  state.advance(increment, old, run.step());
  CHECK(state.force(0)[5] == Approx(0.2 * 100 + 0.2 * 30).epsilon(kRounding));
  CHECK(state.force(0)[2] == Approx(0.1 * 100).epsilon(kRounding));
  CHECK(state.force(0)[0] == 0.0);
  CHECK(state.force(0).size() == 6);
}

}  // namespace
