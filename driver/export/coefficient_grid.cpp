// SPDX-License-Identifier: Apache-2.0
#include "driver/export/coefficient_grid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "driver/export/loss.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::exports {
namespace {

constexpr double kTolerance = 1e-4;
constexpr std::size_t kMostPoints = 200;
/// The most points of all: what a grid over all knots of a ragged table has may be far more than
/// its rows.
constexpr std::size_t kMostOfGrid = 30'000;

/// mu over one of the two, whichever the other is.
using Line = std::function<double(double at, double other)>;

/// The largest error of a chord at three places in it, for all values of the other.
double chord_error(const Line& line, double begin, double end, const std::vector<double>& others) {
  double error = 0.0;
  for (const double other : others) {
    const double left = line(begin, other);
    const double right = line(end, other);
    for (const double part : {0.25, 0.5, 0.75}) {
      const double between = line(begin + part * (end - begin), other);
      error = std::max(error, std::abs(between - (left + part * (right - left))));
    }
  }
  return error;
}

void sort_and_keep_each_once(std::vector<double>& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

/// Halves intervals between ascending points until their chords are good enough.
std::vector<double> refined(std::vector<double> points, const Line& line,
                            const std::vector<double>& others, double tolerance) {
  for (bool added = true; added;) {
    added = false;
    std::vector<double> more;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double middle = 0.5 * (points[i] + points[i + 1]);
      if (points.size() + more.size() >= kMostPoints || middle <= points[i]) break;
      if (chord_error(line, points[i], points[i + 1], others) > tolerance) more.push_back(middle);
    }
    added = !more.empty();
    points.insert(points.end(), more.begin(), more.end());
    std::sort(points.begin(), points.end());
  }
  return points;
}

std::vector<double> knots_of(const law::FrictionLaw& law, law::IndependentKind kind) {
  const auto* const table = law::get_law_if<law::TabularCoefficient>(law);
  const int column = table == nullptr ? -1 : table->table.column_of(kind);
  if (column < 0) return {};
  const auto knots = table->table.table().knots(column);
  return {knots.begin(), knots.end()};
}

std::size_t rows_of(const law::FrictionLaw& law) {
  const auto* const table = law::get_law_if<law::TabularCoefficient>(law);
  return table == nullptr ? 0 : table->table.table().rows();
}

}  // namespace

CoefficientGrid tabulate(const law::FrictionLaw& law, const RunRange& run) {
  const law::Ambient ambient = run.ambient();
  const auto mu = [&](double rate, double force) {
    law::SlipArguments slip;
    slip.slip_rate = rate;
    slip.contact_force = force;
    return law::evaluate(law, ambient, slip).mu;
  };
  CoefficientGrid grid;
  const law::LawRange range = law::range(law);
  std::vector<double> rates{0.0};
  if (law::depends_on_slip_rate(law)) {
    const std::vector<double> knots = knots_of(law, law::IndependentKind::kSlipRate);
    rates.insert(rates.end(), knots.begin(), knots.end());
    rates.push_back(std::max(range.slip_rate, run.slip_rate));
    for (const law::Landmark& one : range.landmarks) {
      if (!one.name.empty()) rates.push_back(one.slip_rate);
    }
  }
  std::vector<double> forces = knots_of(law, law::IndependentKind::kContactForce);
  if (law::depends_on_contact_force(law)) {
    forces.push_back(run.least_contact_force);
    forces.push_back(run.contact_force);
  } else {
    forces = {run.contact_force};
  }
  sort_and_keep_each_once(rates);
  sort_and_keep_each_once(forces);
  // A table whose rows are a grid already gets some slip rates and forces more.
  if (rates.size() * forces.size() > std::max(kMostOfGrid, 2 * rows_of(law))) {
    throw NotExported{"its table has too many slip rates and contact forces for a grid of them"};
  }
  double largest = 0.0;
  for (const double rate : rates) {
    for (const double force : forces) largest = std::max(largest, mu(rate, force));
  }
  const double tolerance = kTolerance * largest;
  grid.rates = refined(std::move(rates), mu, forces, tolerance);
  const Line over_force = [&](double force, double rate) { return mu(rate, force); };
  grid.forces = refined(std::move(forces), over_force, grid.rates, tolerance);
  for (const double force : grid.forces) {
    std::vector<double>& row = grid.mu.emplace_back();
    for (const double rate : grid.rates) row.push_back(mu(rate, force));
  }
  for (std::size_t i = 0; i + 1 < grid.rates.size(); ++i) {
    grid.error =
        std::max(grid.error, chord_error(mu, grid.rates[i], grid.rates[i + 1], grid.forces));
  }
  for (std::size_t i = 0; i + 1 < grid.forces.size(); ++i) {
    grid.error = std::max(grid.error,
                          chord_error(over_force, grid.forces[i], grid.forces[i + 1], grid.rates));
  }
  return grid;
}

}  // namespace slipbench::driver::exports
