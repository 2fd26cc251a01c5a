// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/packed_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "driver/bench/component_forces.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/case/quantity.hpp"

namespace slipbench::driver::sweep {
namespace {

/// A history of as many increments is kept, some 300 bytes each.
constexpr std::size_t kMostIncrements = 200'000;

/// Tells whether friction is all that happens in a case, and that of one definition of law::Pack.
bool is_packable(const cases::Case& problem) {
  if (problem.definitions.size() != 1) return false;
  const cases::CaseDefinition& definition = problem.definitions.front();
  const bool changes =
      std::any_of(problem.steps.begin(), problem.steps.end(),
                  [](const cases::Step& step) { return !step.friction_changes.empty(); });
  return law::batch_form(definition.law) && !definition.backward && !definition.dead_zone &&
         !problem.belt && !problem.dynamics && problem.force_driven.empty() &&
         problem.kinetic.pressing.empty() && !bench::has_component_forces(problem) && !changes &&
         problem.integration.method == cases::IntegrationMethod::kBackwardEuler;
}

bool is_tame(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](double number) { return std::abs(number) < kTame; });
}

/// Returns how a step drives the constraint force of a component; null if it does not.
const history::Profile* profile_of(const cases::Step& step, int component) {
  for (const cases::Drive& drive : step.drives) {
    if (drive.quantity == cases::kFirstForce + component) return &drive.profile;
  }
  return nullptr;
}

/// Returns the varied forces that act in each step, in the order of their indices.
std::vector<std::vector<std::size_t>> acting_forces(const cases::Case& problem,
                                                    const std::vector<VariedForce>& forces) {
  std::vector<std::vector<std::size_t>> begun(problem.steps.size());
  for (std::size_t i = 0; i < forces.size(); ++i) begun[forces[i].step].push_back(i);
  // A measured history is a step that the case does not have.
  std::vector<std::vector<std::size_t>> acting(std::max<std::size_t>(problem.steps.size(), 1));
  std::vector<std::size_t> now;
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    // A force that a step does not drive keeps its value.
    std::erase_if(now, [&](std::size_t i) {
      return profile_of(problem.steps[s], forces[i].component) != nullptr;
    });
    now.insert(now.end(), begun[s].begin(), begun[s].end());
    std::sort(now.begin(), now.end());
    acting[s] = now;
  }
  return acting;
}

/// Tells whether a later step sets out from a force.
bool is_continued(const cases::Case& problem, const VariedForce& force) {
  for (std::size_t s = force.step + 1; s < problem.steps.size(); ++s) {
    const history::Profile* profile = profile_of(problem.steps[s], force.component);
    if (profile == nullptr) continue;
    return std::holds_alternative<history::LinearTo>(*profile) ||
           std::holds_alternative<history::SmoothTo>(*profile);
  }
  return false;
}

}  // namespace

bool may_pack(const Sweep& sweep) {
  return is_packable(sweep.base) && packed_numbers(sweep).has_value();
}

/// Memory of one thread: definitions and what is followed, written anew for every pack.
struct PackedRun::Place {
  QuickResolve quick;
  std::vector<law::FrictionDefinition> definitions;
  std::vector<double> forces;                  ///< of one sample
  std::vector<law::LaneColumn> force_columns;  ///< of all
  std::vector<law::LaneForce> acting;
};

PackedRun::PackedRun(const Sweep& sweep, QuickResolve quick, std::vector<PackedNumber> numbers)
    : sweep_(&sweep), quick_(std::move(quick)), numbers_(std::move(numbers)) {}

PackedRun::~PackedRun() = default;

std::unique_ptr<PackedRun> PackedRun::make(const Sweep& sweep) {
  auto numbers = packed_numbers(sweep);
  if (!numbers || !is_packable(sweep.base)) return nullptr;
  auto quick = QuickResolve::make(sweep);
  if (!quick) return nullptr;
  std::unique_ptr<PackedRun> run(new PackedRun(sweep, std::move(*quick), std::move(*numbers)));
  if (!run->walk_history()) return nullptr;
  return run;
}

/// Keeps the increments of the history that all samples share.
bool PackedRun::walk_history() {
  const cases::Case& problem = sweep_->base;
  std::vector<int> steps;
  bool tame = true;
  const auto walked = bench::Simulation::walk(problem, [&](const bench::Row& row) {
    tame = tame && is_tame(row.quantities) && increments_.size() < kMostIncrements;
    if (!tame) return;
    law::ConnectorIncrement increment = bench::connector_increment(problem, row);
    const std::span<const double> fields = increment.end.fields;
    if (fields_.empty() || !std::ranges::equal(fields_.back(), fields)) {
      fields_.emplace_back(fields.begin(), fields.end());
    }
    // The elements of a vector stay where they are when it is moved.
    increment.end.fields = fields_.back();
    increments_.push_back(increment);
    steps.push_back(row.step);
  });
  if (!walked || !tame) return false;
  const std::vector<VariedForce>& forces = quick_.forces();
  const auto continued = [&](const VariedForce& force) { return is_continued(problem, force); };
  if (std::any_of(forces.begin(), forces.end(), continued)) return false;
  const std::vector<std::vector<std::size_t>> acting = acting_forces(problem, forces);
  for (std::size_t row = 0; row < steps.size(); ++row) {
    if (row > 0 && steps[row] == steps[row - 1]) {
      ++stretches_.back().count;
      continue;
    }
    stretches_.push_back({.count = 1, .forces = acting[static_cast<std::size_t>(steps[row])]});
  }
  return true;
}

std::unique_ptr<PackedRun::Place> PackedRun::take_place() const {
  {
    const std::lock_guard lock(guard_);
    if (!free_.empty()) {
      std::unique_ptr<Place> place = std::move(free_.back());
      free_.pop_back();
      return place;
    }
  }
  auto place = std::make_unique<Place>();
  place->quick = quick_;
  place->definitions.assign(kMost, sweep_->base.definitions.front().law);
  place->forces.resize(quick_.forces().size());
  place->force_columns.resize(quick_.forces().size());
  return place;
}

void PackedRun::run(std::span<const double> values, std::span<double> numbers,
                    std::span<char> done) const {
  using Kind = PackedNumber::Kind;
  const std::size_t count = done.size();
  const std::size_t width = sweep_->varied.size();
  std::unique_ptr<Place> place = take_place();
  for (std::size_t lane = 0; lane < count; ++lane) {
    done[lane] = place->quick.resolve(values.subspan(lane * width, width), place->definitions[lane],
                                      place->forces);
    for (std::size_t f = 0; f < place->forces.size(); ++f) {
      place->force_columns[f][lane] = place->forces[f];
    }
  }

  std::vector<law::LaneExtreme> extremes;
  std::vector<law::LaneChanges> changes;
  for (const PackedNumber& one : numbers_) {
    if (one.kind == Kind::kExtreme) extremes.emplace_back(one.number, one.entry, one.kept);
    if (one.kind == Kind::kChanges) changes.emplace_back(one.from, one.to);
  }
  extremes.emplace_back(law::LaneNumber::kCoefficient, 0, law::LaneKept::kMagnitude);
  law::Pack pack(std::span(place->definitions).first(count));
  pack.follow(extremes, changes);
  std::span<const law::ConnectorIncrement> rest = increments_;
  for (const Stretch& stretch : stretches_) {
    place->acting.clear();
    for (const std::size_t f : stretch.forces) {
      place->acting.push_back({quick_.forces()[f].component, place->force_columns[f]});
    }
    pack.press(place->acting);
    pack.advance(rest.first(stretch.count));
    rest = rest.subspan(stretch.count);
  }

  for (std::size_t lane = 0; lane < count; ++lane) {
    // A number that is not finite is a failure, which the run of the sample words.
    done[lane] = done[lane] && pack.is_common(lane) && extremes.back().so_far[lane] < kTame &&
                 std::isfinite(pack.last(law::LaneNumber::kDissipation, 0, lane));
    std::size_t extreme = 0;
    std::size_t change = 0;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const PackedNumber& one = numbers_[i];
      double& number = numbers[lane * numbers_.size() + i];
      switch (one.kind) {
        case Kind::kLast:
          number = pack.last(one.number, one.entry, lane);
          break;
        case Kind::kExtreme:
          number = extremes[extreme++].so_far[lane];
          break;
        case Kind::kChanges:
          number = changes[change++].count[lane];
          break;
      }
    }
  }
  const std::lock_guard lock(guard_);
  free_.push_back(std::move(place));
}

}  // namespace slipbench::driver::sweep
