// SPDX-License-Identifier: Apache-2.0
#include <rapidcheck.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "law/connection/slipring.hpp"
#include "law/update/capstan_update.hpp"
#include "tests/support/random_history.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

const bool kSeeded =
    setenv("RC_PARAMS", "seed=20240611 max_success=1500 max_discard_ratio=100", 0) == 0;

/// A random belt with its history; the tension is component 1's force, of both signs.
struct Case {
  DefinitionDescription description;
  double wrap_angle = 0.0;
  std::vector<HistoryRow> rows;
  Dice dice;

  FrictionDefinition definition() const {
    FrictionDefinition d = description.build();
    d.criterion = Capstan{wrap_angle};
    return d;
  }
};

Case draw() {
  const int length = *rc::gen::inRange(1, 60).as("increments");
  const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()).as("seed");
  Dice dice(seed);
  DefinitionDescription d = random_belt(&dice);
  const double angle = d.belt->wrap_angle;
  std::vector<HistoryRow> rows = random_history(&dice, length);
  return {std::move(d), angle, std::move(rows), dice};
}

template <class Property>
void check(const std::string& text, const Property& property) {
  REQUIRE(kSeeded);
  REQUIRE(rc::check(text, property));
}

bool is_fixed(const Case& c) {
  return c.description.stick.mode == StickStiffness::Mode::kStiffness;
}

/// T expm1(mu alpha), or what stands for it backward; no force limit.
double band(const FrictionUpdate& u, double wrap_angle, double sense) {
  return u.normal_force * std::abs(std::expm1(sense * u.mu * wrap_angle));
}

TEST_CASE("a belt's force stays in its band, dissipates, and never pushes") {
  check("-T (1 - exp(-A)) <= CSF2 <= T (exp(A) - 1), f_bc >= 0", [] {
    const Case c = draw();
    const FrictionDefinition definition = c.definition();
    double slip = 0.0;
    for (const FrictionUpdate& u : run_history(definition, c.rows)) {
      for (const double x : numbers(u)) RC_ASSERT(std::isfinite(x));
      const double y = u.state.force[0];
      const double sense = y < 0.0 ? -1.0 : 1.0;
      RC_ASSERT(std::abs(y) <= u.limit * (1.0 + 1e-14) || y == 0.0);
      RC_ASSERT(std::abs(y) <= band(u, c.wrap_angle, sense) * (1.0 + 1e-13));
      RC_ASSERT(u.limit <= c.description.force_limit);
      RC_ASSERT(u.normal_force == std::max(u.contact_force, 0.0));
      RC_ASSERT(tension_behind(u) >= 0.0);
      RC_ASSERT(u.normal_force > 0.0 || (y == 0.0 && u.state.regime == Regime::kOpen));
      RC_ASSERT(u.dissipation >= 0.0);
      RC_ASSERT(u.stored_energy >= 0.0);
      RC_ASSERT(u.state.accumulated_slip >= slip);
      RC_ASSERT((u.state.regime == Regime::kSlip) == (u.slip_increment > 0.0));
      RC_ASSERT(u.state.regime != Regime::kOpen || u.limit == 0.0);
      slip = u.state.accumulated_slip;
    }
  });
}

TEST_CASE("in slip the force lies on the side's limit and the trial motion is shared out") {
  check("slip: |y| = limit, |trial| = elastic + slip", [] {
    const Case c = draw();
    const FrictionDefinition definition = c.definition();
    FrictionState old;
    for (const HistoryRow& row : c.rows) {
      const FrictionUpdate u = update(definition, row.increment(), old);
      if (u.state.regime == Regime::kSlip) {
        const double ds = row.end[1] - row.begin[1];
        const double kappa = definition.stick.value;
        const double trial = is_fixed(c) ? old.force[0] + kappa * ds : old.elastic_slip[0] + ds;
        const double q = std::abs(trial);
        RC_ASSERT(u.direction[0] == (trial < 0.0 ? -1.0 : 1.0));
        RC_ASSERT(std::abs(std::abs(u.state.force[0]) - u.limit) <= 1e-14 * u.limit);
        const double shared =
            is_fixed(c) ? u.limit + kappa * u.slip_increment : kappa + u.slip_increment;
        // Rounding of the root, in units of the trial force, steepened by a falling coefficient.
        RC_ASSERT(std::abs(q - shared) <= 1e-11 * (q + u.limit));
      }
      old = u.state;
    }
  });
}

TEST_CASE("a belt at constant tension keeps its energy balance to rounding") {
  check("work = dissipated + stored", [] {
    Case c = draw();
    c.description.law = ConstantCoefficient{c.dice.between(0.05, 0.5)};
    const double tension = c.dice.between(1.0, 100.0);
    for (HistoryRow& row : c.rows) row.force[0] = tension;
    double work = 0.0, dissipation = 0.0, largest = 0.0;
    for (const FrictionUpdate& u : run_history(c.definition(), c.rows)) {
      work += u.work;
      dissipation += u.dissipation;
      largest = std::max({largest, dissipation, u.stored_energy});
      RC_ASSERT(std::abs(work - dissipation - u.stored_energy) <= 1e-12 * largest);
    }
  });
}

TEST_CASE("more increments change nothing for a belt with constant coefficient and tension") {
  check("halving", [] {
    Case c = draw();
    c.description.law = ConstantCoefficient{c.dice.between(0.05, 0.5)};
    std::vector<HistoryRow> halves;
    const double tension = c.dice.between(1.0, 100.0);
    for (HistoryRow& row : c.rows) {
      row.force[0] = tension;
      HistoryRow half = row;
      for (int k = 0; k < kComponents; ++k) half.end[k] = 0.5 * (row.begin[k] + row.end[k]);
      halves.push_back(half);
      half.begin = half.end;
      half.end = row.end;
      halves.push_back(half);
    }
    const auto whole = run_history(c.definition(), c.rows);
    const auto twice = run_history(c.definition(), halves);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const FrictionUpdate& u = whole[i];
      const FrictionUpdate& v = twice[2 * i + 1];
      const double scale = u.limit + v.limit + u.normal_force;
      // Rounding of positions around 1 relative to an elastic slip of 2e-3 and more.
      RC_ASSERT(std::abs(u.state.force[0] - v.state.force[0]) <= 1e-11 * scale);
      RC_ASSERT(std::abs(u.state.accumulated_slip - v.state.accumulated_slip) <=
                1e-12 * (1.0 + u.state.accumulated_slip));
    }
  });
}

TEST_CASE("the same belt in other units gives the same physics, to the last bit") {
  check("change of units by powers of two", [] {
    Case c = draw();
    const auto power = [&] { return std::ldexp(1.0, c.dice.pick(41) - 20); };
    const Units units{power(), power(), power()};
    Case other = c;
    other.description = in_units(c.description, units);
    other.rows = in_units(c.rows, units);
    const auto results = run_history(c.definition(), c.rows);
    const auto others = run_history(other.definition(), other.rows);
    for (std::size_t i = 0; i < results.size(); ++i) {
      RC_ASSERT(numbers(results[i]) == numbers(others[i], slip_units(c.description, units)));
    }
  });
}

TEST_CASE("a weak ring is a slider whose normal force is the tension times the wrap angle") {
  check("mu alpha -> 0", [] {
    Case c = draw();
    for (HistoryRow& row : c.rows) row.force[0] = std::abs(row.force[0]);
    c.description.law = ConstantCoefficient{c.dice.between(0.05, 0.5)};
    c.description.blend = {};
    c.description.force_limit = kNoForceLimit;
    c.wrap_angle = 1e-9;
    if (is_fixed(c)) c.description.stick.value *= 1e-9;  // as stiff beside the weak limit
    FrictionDefinition slider = c.definition();
    slider.criterion = EuclideanPotential{};
    slider.law = ConstantCoefficient{1e-9 * std::get<ConstantCoefficient>(slider.law).mu};
    const auto belts = run_history(c.definition(), c.rows);
    const auto sliders = run_history(slider, c.rows);
    for (std::size_t i = 0; i < belts.size(); ++i) {
      // The limits differ by A/2, below 1e-9.
      RC_ASSERT(std::abs(belts[i].state.force[0] - sliders[i].state.force[0]) <=
                2e-8 * (belts[i].limit + sliders[i].limit));
    }
  });
}

TEST_CASE("rings in a chain are one ring of the summed angle once all of them slip") {
  check("product of the ratios", [] {
    Case c = draw();
    const double mu = c.dice.between(0.05, 0.4);
    c.description.law = ConstantCoefficient{mu};
    c.description.blend = {};
    c.description.force_limit = kNoForceLimit;
    double sum = 0.0;
    double tension = c.dice.between(1.0, 100.0);
    const double first = tension;
    const double sense = c.dice.chance(0.5) ? 1.0 : -1.0;
    const int rings = 2 + c.dice.pick(5);
    ConnectorIncrement increment;
    increment.end.position[1] = sense * 1e6;
    for (int r = 0; r < rings; ++r) {
      c.wrap_angle = c.dice.between(0.0, 2.0);
      sum += c.wrap_angle;
      increment.force[0] = tension;
      tension = tension_behind(update(c.definition(), increment, {}));
    }
    // One rounding of each exponential and product.
    RC_ASSERT(std::abs(tension / first - std::exp(sense * mu * sum)) <=
              1e-14 * rings * std::exp(sense * mu * sum));
  });
}

}  // namespace
