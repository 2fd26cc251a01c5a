// SPDX-License-Identifier: Apache-2.0
// Exact integration of potentials and viscous laws does not depend on the number of increments.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "law/definition/potential_terms.hpp"
#include "law/update/uniqueness.hpp"
#include "tests/support/backward_euler_error.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/exact_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

struct Draw {
  FrictionDefinition definition;
  std::vector<Waypoint> corners;
  std::string name;
};

/// Rows of random ordinates over knots.
Rows rows_over(Dice* dice, double low, double high, const std::vector<double>& knots) {
  Rows rows;
  for (const double knot : knots) rows.push_back({dice->between(low, high), knot});
  return rows;
}

/// Units of a case, in those of the draw.
struct Units {
  double force = 1.0;
  double length = 1.0;
  double time = 1.0;
};

/// A maximum or sum over two or three components, one of them perhaps one-sided; or the
/// norm with a coefficient that rises with the rate.
/// \param round numbers are quarters of their range: what happens falls on the ends of segments
Draw draw(std::uint64_t seed, const Units& units = {}, bool round = false) {
  Dice dice(seed);
  const auto number = [&](double low, double high) {
    const double part = dice.between(0.0, 1.0);
    return low + (high - low) * (round ? std::round(4.0 * part) / 4.0 : part);
  };
  Draw d;
  FrictionDefinition& f = d.definition;
  const double force = units.force * dice.one_of(std::vector<double>{50.0, 1000.0});
  const bool viscous = dice.chance(0.35);
  const int dimension = viscous ? 1 + dice.pick(2) : 2 + dice.pick(2);
  if (viscous) {
    d.name = "viscous";
    f.slip.dimension = dimension;
    for (int i = 0; i < dimension; ++i) f.slip.component[static_cast<std::size_t>(i)] = i;
    const double mu = number(0.05, 0.3);
    const double middle = number(0.1, 1.0);
    const double rate = units.length / units.time;
    f.law = TabularCoefficient{make_function(
        {{mu, 0.0}, {mu + 0.08 * middle, middle * rate}, {mu + 0.3, 4.0 * rate}}, {kOverSlipRate})};
  } else {
    std::vector<PotentialContribution> terms;
    for (int i = 0; i < dimension; ++i) {
      PotentialContribution term;
      term.of = i;
      term.scale = number(0.5, 2.0);
      terms.push_back(term);
    }
    if (dice.chance(0.2)) terms[0].function = ContributionFunction::kMacauley;
    const bool maximum = dice.chance(0.5);
    const double exponent = dice.one_of(std::vector<double>{1.0, 1.0, 1.5, 3.0});
    d.name = maximum ? "maximum" : "sum " + std::to_string(exponent);
    const BuiltPotential built = build_potential(
        terms, maximum ? PotentialOperator::kMax : PotentialOperator::kSum, exponent);
    f.slip = built.slip;
    f.criterion = built.criterion;
    switch (dice.pick(3)) {
      case 0:
        f.law = ConstantCoefficient{number(0.05, 0.6)};
        break;
      case 1:
        f.law = TabularCoefficient{make_function(
            rows_over(&dice, 0.05, 0.5, {0.0, 0.3 * force, 0.8 * force}), {kOverContactForce})};
        break;
      default:
        f.law = TabularCoefficient{
            make_function(rows_over(&dice, 0.05, 0.5, {20.0, 70.0}), {kOverTemperature})};
    }
    if (dice.chance(0.25)) f.force_limit = number(0.05, 0.3) * force;
  }
  if (dice.chance(0.6)) {
    const double worn = units.length * number(0.2, 1.5);
    f.internal_contact_force = make_function({{force * number(0.8, 1.2), 0.0},
                                              {force * number(0.3, 0.8), 0.4 * worn},
                                              {dice.chance(0.4) ? 0.0 : 0.2 * force, worn}},
                                             {kOverAccumulatedSlip});
  } else {
    f.internal_contact_force = number(0.2, 1.0) * force;
  }
  f.contact_force = ComponentContactForce{5};
  const double elastic = units.length * dice.one_of(std::vector<double>{1e-3, 0.01, 0.1});
  f.stick = !viscous && dice.chance(0.5)
                ? StickStiffness{StickStiffness::Mode::kElasticSlip, elastic}
                : StickStiffness{StickStiffness::Mode::kStiffness, 0.2 * force / elastic};

  const double stride = units.length * dice.one_of(std::vector<double>{0.1, 0.5});
  Waypoint here;
  here.temperature = 20.0;
  here.force[5] = number(-force, force);
  d.corners.push_back(here);
  for (int n = 0; n < 3; ++n) {
    for (int i = 0; i < dimension; ++i) {
      if (n == 0 || dice.chance(0.7)) here.position[i] = number(-stride, stride);
    }
    if (dice.chance(0.6)) here.force[5] = number(-force, force);
    if (dice.chance(0.4)) here.temperature = number(0.0, 100.0);
    here.duration = units.time * dice.one_of(std::vector<double>{0.5, 1.0, 2.0});
    d.corners.push_back(here);
  }
  return d;
}

/// Force, slip and energies at the ends of all segments.
using Ends = std::vector<std::array<double, 6>>;

struct Course {
  Ends ends;
  double imbalance = 0.0;  ///< of the energies, with a constant stick stiffness
  double snap_back = 0.0;
  double limit = 0.0;    ///< the largest that was told, that of the begin too
  double elastic = 0.0;  ///< slip at that limit
  bool converged = true;
  bool opens = false;
};

Course follow(const Draw& d, int count, bool backward_euler = false) {
  ExactRun run(d.definition, d.corners.front(), 1e-10);
  run.backward_euler = backward_euler;
  Course course;
  course.limit = run.go(d.corners.front()).limit;
  for (std::size_t n = 1; n < d.corners.size(); ++n) {
    for (int i = 1; i <= count; ++i) {
      Waypoint to = d.corners[n];
      const Waypoint& from = d.corners[n - 1];
      const auto mix = [&](double a, double b) {
        return i == count || a == b ? b : a + (b - a) * i / count;
      };
      for (int c = 0; c < kComponents; ++c) {
        to.position[c] = mix(from.position[c], to.position[c]);
        to.force[c] = mix(from.force[c], to.force[c]);
      }
      to.temperature = mix(from.temperature, to.temperature);
      to.duration /= count;
      run.go(to);
      course.snap_back = std::max(course.snap_back, run.last.snap_back);
      course.limit = std::max(course.limit, run.last.limit);
      course.converged = course.converged && run.last.converged;
      for (int e = 0; e < run.changes.count; ++e) {
        course.opens =
            course.opens || run.changes.at[static_cast<std::size_t>(e)].to == Regime::kOpen;
      }
    }
    const auto& y = run.state.force;
    course.ends.push_back(
        {y[0], y[1], y[2], run.state.accumulated_slip, run.dissipation, run.last.stored_energy});
    if (d.definition.stick.mode == StickStiffness::Mode::kStiffness) {
      course.imbalance =
          std::max(course.imbalance,
                   std::abs(run.work - run.dissipation - run.last.stored_energy) /
                       (std::abs(run.work) + run.dissipation + run.last.stored_energy + 1e-12));
    }
  }
  const bool fixed = d.definition.stick.mode == StickStiffness::Mode::kStiffness;
  course.elastic = fixed ? course.limit / d.definition.stick.value : d.definition.stick.value;
  return course;
}

/// The largest difference as a part of the range of its quantity over the run, or of the limit.
double apart(const Course& first, const Course& second) {
  const Ends& a = first.ends;
  const Ends& b = second.ends;
  double worst = 0.0;
  for (std::size_t q = 0; q < 6; ++q) {
    double low = 0.0;
    double high = 0.0;
    for (const auto& end : a) {
      low = std::min(low, end[q]);
      high = std::max(high, end[q]);
    }
    const double limit = std::max(first.limit, second.limit);
    const double least = q < 3 ? limit : q == 5 ? limit * first.elastic : 1e-9;
    const double range = std::max(high - low, least);
    for (std::size_t n = 0; n < a.size(); ++n) {
      worst = std::max(worst, std::abs(a[n][q] - b[n][q]) / range);
    }
  }
  return worst;
}

TEST_CASE("potentials and viscous laws do not see the number of increments") {
  int judged = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Draw d = draw(seed);
    const Course one = follow(d, 1);
    const Course three = follow(d, 3);
    // Where the force would jump there is no continuous solution, and teeth of a saw without number
    // are not followed; both are told.
    if (one.snap_back >= 1.0 || !one.converged || !three.converged) continue;
    ++judged;
    CAPTURE(seed, d.name);
    // The tolerance of 1e-10 in some ten pieces of each of three segments.
    CHECK(apart(one, three) <= 3e-9);
    CHECK(one.imbalance <= 1e-9);
    CHECK(three.imbalance <= 1e-9);
  }
  CHECK(judged >= 52);
}

TEST_CASE("events on the ends of increments change nothing") {
  int judged = 0;
  int given_up = 0;
  for (std::uint64_t seed = 0; judged < 40; ++seed) {
    const Draw d = draw(seed, {}, true);
    const Course one = follow(d, 1);
    const Course three = follow(d, 3);
    // A contact that opens on a row forgets an elastic slip, and the force beside a one-sided term.
    const auto* potential = std::get_if<Potential>(&d.definition.criterion);
    const bool fixed = d.definition.stick.mode == StickStiffness::Mode::kStiffness;
    const bool forgets = !fixed || (potential != nullptr &&
                                    potential->leaf[0].kind == PotentialLeaf::Kind::kHalfLine);
    if (one.snap_back >= 1.0 || (forgets && (one.opens || three.opens))) continue;
    if (!one.converged || !three.converged) {
      // Teeth of a saw, which took minutes, are given up after some seconds.
      ++given_up;
      continue;
    }
    ++judged;
    CAPTURE(seed, d.name);
    // Of a viscous joint the force is exact to 1e-7, whatever is asked for.
    CHECK(apart(one, three) <= (d.name == "viscous" ? 1e-6 : 3e-9));
  }
  CHECK(given_up <= 2);
}

TEST_CASE("under potentials and viscous laws a fine backward Euler tends to the exact end") {
  std::vector<double> ratios;
  int judged = 0;
  for (std::uint64_t seed = 0; judged < 30; ++seed) {
    const Draw d = draw(seed);
    const Course exact = follow(d, 1);
    // Backward Euler sees no opening of an instant, in which an elastic slip, or the force beside a
    // one-sided term, is forgotten; and it goes on where slip has worn the contact force through 0.
    if (exact.snap_back >= 1.0 || !exact.converged || exact.opens) continue;
    ++judged;
    const auto error_at = [&](int count) { return apart(exact, follow(d, count, true)); };
    const BackwardEulerError error = backward_euler_error(200, error_at);
    CAPTURE(seed, d.name, error.coarse, error.fine);
    if (error.coarse < 0.05 && error.fine > 1e-6) ratios.push_back(error.coarse / error.fine);
    CHECK(error.last <= 0.05);
  }
  REQUIRE(ratios.size() > 10);
  CHECK(middle_of(ratios) == Approx(2.0).margin(0.1));
}

TEST_CASE("the units of a case change no digit of exact integration") {
  // Powers of two, so that nothing rounds otherwise.
  for (const Units& units : {Units{0x1p-30, 1.0, 1.0}, Units{0x1p40, 1.0, 1.0},
                             Units{1.0, 0x1p-20, 1.0}, Units{0x1p20, 0x1p30, 0x1p-10}}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      for (const bool norm : {false, true}) {
        CAPTURE(units.force, units.length, units.time, seed, norm);
        // By events and by extrapolation.
        const auto ends_in = [&](const Units& in) {
          Draw d = draw(seed, in);
          if (norm) d.definition.criterion = EuclideanPotential{};
          if (norm && d.name == "viscous") {
            d.definition.stick = {StickStiffness::Mode::kElasticSlip, 0.01 * in.length};
          }
          return follow(d, 1).ends;
        };
        const Ends one = ends_in({});
        const Ends other = ends_in(units);
        const double energy = units.force * units.length;
        const std::array size{units.force, units.force, units.force, units.length, energy, energy};
        for (std::size_t n = 0; n < one.size(); ++n) {
          for (std::size_t q = 0; q < size.size(); ++q) CHECK(other[n][q] == one[n][q] * size[q]);
        }
      }
    }
  }
}

}  // namespace
