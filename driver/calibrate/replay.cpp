// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/replay.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "driver/bench/simulation.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::driver::calibrate {
namespace {

// --- Which cases can be replayed ------------------------------------------------------------

/// Returns why the law is not all that moves in a case, or nothing.
std::optional<std::string> obstacle(const cases::Case& problem) {
  if (problem.dynamics) return "it has a mass";
  if (!problem.force_driven.empty()) return "it has a component that is driven by force";
  if (problem.belt) return "it has a belt";
  if (!problem.kinetic.pressing.empty()) return "a free component presses";
  if (problem.integration.method == cases::IntegrationMethod::kExact)
    return "it is integrated exactly";
  for (const cases::CaseDefinition& definition : problem.definitions) {
    if (definition.law.formulation) return "its friction is a contact penalty";
    if (definition.dead_zone) return "it has a dead zone";
    if (definition.backward) return "its coefficient depends on the direction";
  }
  for (const cases::Step& step : problem.steps) {
    if (!step.friction_changes.empty()) return "its friction changes in step '" + step.name + "'";
  }
  return std::nullopt;
}

// --- Whether two histories are the same -----------------------------------------------------

/// Tells whether a formula mentions a name.
bool mentions(std::string_view text, std::string_view name) {
  const auto is_part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
  };
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_part(text[at - 1])) && (end == text.size() || !is_part(text[end]))) {
      return true;
    }
  }
  return false;
}

bool same(const base::Expression& a, const base::Expression& b,
          const base::NamedNumbers& parameters, const base::NamedNumbers& others) {
  const auto matters = [&](const auto& parameter) {
    const auto other = others.find(parameter.first);
    const bool differs = other == others.end() || other->second != parameter.second;
    return differs && mentions(a.text(), parameter.first);
  };
  return a.text() == b.text() && std::none_of(parameters.begin(), parameters.end(), matters);
}

bool same(const history::Profile& a, const history::Profile& b,
          const base::NamedNumbers& parameters, const base::NamedNumbers& others) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&]<class Kind>(const Kind& one) {
        const Kind& other = *std::get_if<Kind>(&b);
        if constexpr (std::is_same_v<Kind, history::Wave>) {
          return one.shape == other.shape && one.amplitude == other.amplitude &&
                 one.period == other.period && one.mean == other.mean && one.phase == other.phase;
        } else if constexpr (std::is_same_v<Kind, history::Tabular>) {
          return one.times == other.times && one.values == other.values;
        } else if constexpr (std::is_same_v<Kind, history::CsvColumn>) {
          return one.data == other.data && one.time_column == other.time_column &&
                 one.time_conversion == other.time_conversion &&
                 one.value_column == other.value_column &&
                 one.value_conversion == other.value_conversion;
        } else if constexpr (requires { one.expression; }) {
          return same(one.expression, other.expression, parameters, others);
        } else {
          return one.value == other.value;
        }
      },
      a);
}

bool same(const cases::Step& a, const cases::Step& b, const base::NamedNumbers& parameters,
          const base::NamedNumbers& others) {
  return a.duration == b.duration && a.increments == b.increments && a.repeat == b.repeat &&
         std::equal(a.drives.begin(), a.drives.end(), b.drives.begin(), b.drives.end(),
                    [&](const cases::Drive& one, const cases::Drive& other) {
                      return one.quantity == other.quantity &&
                             same(one.profile, other.profile, parameters, others);
                    });
}

bool same(const history::MeasuredSource& a, const history::MeasuredSource& b) {
  return a.data == b.data && a.time_column == b.time_column &&
         a.time_conversion == b.time_conversion && a.hold == b.hold &&
         std::equal(a.columns.begin(), a.columns.end(), b.columns.begin(), b.columns.end(),
                    [](const history::MeasuredColumn& one, const history::MeasuredColumn& other) {
                      return one.quantity == other.quantity && one.column == other.column &&
                             one.conversion == other.conversion;
                    });
}

}  // namespace

// --- Recording ------------------------------------------------------------------------------

tl::expected<Replay, std::string> Replay::record(
    const cases::Case& problem, const std::function<void(const bench::Row&)>& watch) {
  if (auto why = obstacle(problem)) return tl::unexpected(*std::move(why));
  Replay replay;
  replay.parameters_ = problem.parameters;
  replay.jumps_ = problem.integration.snap_back == cases::SnapBackAction::kJump;
  replay.initial_ = problem.initial;
  replay.reference_ = problem.reference;
  replay.steps_ = problem.steps;
  replay.measured_ = problem.measured;
  replay.measured_pieces_ = problem.measured_pieces;

  std::array<bool, cases::kQuantities> driven{};
  for (const cases::Step& step : problem.steps) {
    for (const cases::Drive& drive : step.drives)
      driven.at(static_cast<std::size_t>(drive.quantity)) = true;
  }
  if (problem.measured) {
    for (const history::MeasuredColumn& column : problem.measured->columns)
      driven.at(column.quantity) = true;
  }
  for (int q = 0; q < cases::kTensionBehind; ++q) {
    if (!driven[static_cast<std::size_t>(q)]) continue;
    (q < cases::kFirstForce ? replay.columns_.motions : replay.columns_.others).push_back(q);
  }

  const auto walked = bench::Simulation::walk(problem, [&](const bench::Row& row) {
    if (watch) watch(row);
    if (replay.times_.empty()) replay.first_ = row.quantities;
    replay.times_.push_back(row.time);
    replay.record_row(row.duration, row.quantities);
  });
  if (!walked) return tl::unexpected(walked.error().message);
  return replay;
}

void Replay::record_row(double duration, std::span<const double> quantities) {
  increments_.push_back(duration);
  for (const int q : columns_.motions)
    increments_.push_back(quantities[static_cast<std::size_t>(q)]);
  for (const int q : columns_.others)
    increments_.push_back(quantities[static_cast<std::size_t>(q)]);
}

bool Replay::same_history(const cases::Case& other) const {
  return !obstacle(other) && initial_ == other.initial && reference_ == other.reference &&
         measured_pieces_ == other.measured_pieces &&
         measured_.has_value() == other.measured.has_value() &&
         (!measured_ || same(*measured_, *other.measured)) &&
         std::equal(steps_.begin(), steps_.end(), other.steps.begin(), other.steps.end(),
                    [&](const cases::Step& a, const cases::Step& b) {
                      return same(a, b, parameters_, other.parameters);
                    });
}

// --- Running --------------------------------------------------------------------------------

/// The recorded increments, one after another, as the law takes them.
class Replay::Increments {
 public:
  explicit Increments(const Replay& replay)
      : row_(replay.increments_.data()), columns_(replay.columns_), reference_(replay.reference_) {
    for (int c = 0; c < law::kComponents; ++c) {
      const auto k = static_cast<std::size_t>(c);
      increment_.end.position[c] = replay.first_[cases::kFirstMotion + k];
      increment_.force[c] = replay.first_[cases::kFirstForce + k];
    }
    increment_.begin_position = increment_.end.position;
    increment_.end.motion = law::constitutive_motion(increment_.end.position, reference_);
    increment_.end.temperature = replay.first_[cases::kTemperatureQuantity];
    std::copy_n(replay.first_.begin() + cases::kFirstField, fields_.size(), fields_.begin());
    increment_.end.fields = fields_;
    for (const int q : columns_.others) {
      targets_.push_back(q < cases::kTemperatureQuantity ? &increment_.force[q - cases::kFirstForce]
                         : q == cases::kTemperatureQuantity
                             ? &increment_.end.temperature
                             : &fields_[static_cast<std::size_t>(q) - cases::kFirstField]);
    }
  }
  Increments(const Increments&) = delete;
  Increments& operator=(const Increments&) = delete;

  /// The increment of the next row.
  const law::ConnectorIncrement& next() {
    increment_.duration = *row_++;
    for (const int c : columns_.motions) {
      increment_.begin_position[c] = increment_.end.position[c];
      increment_.end.position[c] = *row_;
      increment_.end.motion[c] = *row_++ - reference_[c];
    }
    for (double* target : targets_) *target = *row_++;
    return increment_;
  }

 private:
  const double* row_;
  const Columns& columns_;
  const law::RelativePosition& reference_;
  law::ConnectorIncrement increment_;
  std::array<double, law::kMaxFields> fields_{};
  std::vector<double*> targets_;
};

namespace {

/// Tells whether the forces of an increment can be used; Simulation asks the same of its energies.
inline bool is_sound(const law::FrictionUpdate& update, bool jumps) {
  if (update.snap_back >= 1.0 && !jumps) return false;
  // One infinity or NaN spoils the sum: the single numbers are only looked at when it happened.
  const auto& y = update.state.force;
  const double sum = (update.limit + update.normal_force + update.mu) +
                     (y[0] + y[1] + update.state.accumulated_slip) + (y[2] + y[3]) + (y[4] + y[5]);
  if (std::isfinite(sum)) return update.converged;
  const auto finite = [](double x) { return std::isfinite(x); };
  return update.converged && finite(update.limit) && finite(update.normal_force) &&
         finite(update.mu) && finite(update.state.accumulated_slip) &&
         std::all_of(y.begin(), y.end(), finite);
}

bool goes_before(const Replay::Point& a, const Replay::Point& b) { return a.row < b.row; }

/// One definition on its way: the result of the last increment and of the one before, in turn.
struct RunningDefinition {
  const law::FrictionDefinition* definition = nullptr;
  std::array<law::FrictionUpdate, 2> updates{};
  std::optional<law::StateSlopes> slopes;
};

/// An entry of a definition's slip space that a response reads.
struct Source {
  Source(const RunningDefinition& run, std::size_t slip_entry)
      : force{&run.updates[0].state.force[slip_entry], &run.updates[1].state.force[slip_entry]},
        slopes(run.slopes ? &*run.slopes : nullptr),
        entry(static_cast<int>(slip_entry)),
        scale(run.definition->slip.scale[slip_entry]) {}

  std::array<const double*, 2> force;  ///< in the two updates
  const law::StateSlopes* slopes;      ///< null: nothing depends on an unknown
  int entry;
  double scale;  ///< R_i
};

/// One response on its way along the rows.
struct RunningResponse {
  std::span<const Replay::Point> points;
  std::vector<std::size_t> order;  ///< of the points by their rows; empty: as they are
  bool consecutive = false;        ///< the points are rows, one after the other
  bool one_source = false;         ///< with slopes to all unknowns
  double factor = 1.0;
  std::vector<Source> sources;
  double* values = nullptr;
  double* jacobian = nullptr;
  std::size_t next = 0;     ///< the next point
  std::size_t waiting = 0;  ///< points from here to `next` still want the next row

  std::size_t at(std::size_t k) const { return order.empty() ? k : order[k]; }

  double force(std::size_t now) const {
    if (sources.empty()) return 0.0;
    double sum = sources[0].scale * *sources[0].force[now];
    for (std::size_t i = 1; i < sources.size(); ++i) {
      sum += sources[i].scale * *sources[i].force[now];
    }
    return factor * sum;
  }
  /// Adds share * d(force)/d(unknowns), or sets it.
  void take_slopes(double share, bool add, std::span<double> row) const {
    std::size_t set = add ? row.size() : 0;  // entries that have a value
    for (const Source& source : sources) {
      if (source.slopes == nullptr) continue;
      const auto slopes = source.slopes->force(source.entry);
      const double weight = share * factor * source.scale;
      const std::size_t count = std::min(row.size(), slopes.size());
      if (set < count) {
        std::fill(row.begin() + static_cast<std::ptrdiff_t>(count), row.end(), 0.0);
        for (std::size_t j = 0; j < count; ++j) row[j] = weight * slopes[j];
        set = row.size();
      } else {
        for (std::size_t j = 0; j < count; ++j) row[j] += weight * slopes[j];
      }
    }
    if (set == 0) std::fill(row.begin(), row.end(), 0.0);
  }
  /// The same set for a whole row, where one definition has slopes to all unknowns.
  void take_slopes_of_one(double* __restrict row, std::size_t unknowns) const {
    const double* __restrict slopes = sources[0].slopes->force(sources[0].entry).data();
    const double weight = factor * sources[0].scale;
    for (std::size_t j = 0; j < unknowns; ++j) row[j] = weight * slopes[j];
  }
};

/// Fills in all points that the row `row` has a part in.
template <bool kSlopes>
void read_row(std::size_t row, std::size_t now, std::size_t unknowns, RunningResponse& response) {
  if (response.consecutive) {
    const std::size_t k = row - response.points.front().row;  // beyond all points before the first
    if (k >= response.points.size()) return;
    response.values[k] = response.force(now);
    if constexpr (kSlopes) {
      double* const slopes = response.jacobian + k * unknowns;
      if (response.one_source) {
        response.take_slopes_of_one(slopes, unknowns);
      } else {
        response.take_slopes(1.0, false, {slopes, unknowns});
      }
    }
    return;
  }
  const auto jacobian_row = [&](std::size_t point) {
    return std::span<double>(response.jacobian + point * unknowns, unknowns);
  };
  const std::span<const Replay::Point> points = response.points;
  if (response.waiting == response.next &&
      (response.next == points.size() || points[response.at(response.next)].row != row)) {
    return;
  }
  const double force = response.force(now);
  for (; response.waiting < response.next; ++response.waiting) {
    const std::size_t k = response.at(response.waiting);
    const double fraction = points[k].fraction;
    if (fraction == 0.0) continue;
    response.values[k] += fraction * (force - response.values[k]);
    if constexpr (kSlopes) response.take_slopes(fraction, true, jacobian_row(k));
  }
  while (response.next < points.size()) {
    const std::size_t k = response.at(response.next);
    if (points[k].row != row) return;
    ++response.next;
    response.values[k] = force;
    if constexpr (kSlopes) {
      response.take_slopes(1.0 - points[k].fraction, false, jacobian_row(k));
    }
  }
}

}  // namespace

template <bool kSlopes>
bool Replay::run_all(std::span<const law::FrictionDefinition> definitions,
                     std::span<const law::DefinitionSlopes> slopes, std::size_t unknowns,
                     std::span<const Response> responses, double* values, double* jacobian) const {
  const std::size_t rows = times_.size();
  // Room for all, so that none moves once it is referred to.
  std::vector<RunningDefinition> runs;
  runs.reserve(definitions.size());
  std::vector<const RunningDefinition*> run_of(definitions.size(), nullptr);
  const auto run_definition = [&](std::size_t d) -> const RunningDefinition& {
    if (run_of[d] == nullptr) {
      RunningDefinition& run = runs.emplace_back();
      run.definition = &definitions[d];
      if constexpr (kSlopes) {
        if (slopes[d].unknowns > 0) run.slopes.emplace(definitions[d], slopes[d]);
      }
      run_of[d] = &run;
    }
    return *run_of[d];
  };

  std::vector<RunningResponse> running;
  for (const Response& response : responses) {
    RunningResponse here;
    here.points = response.points;
    here.factor = response.factor;
    here.values = values;
    here.jacobian = jacobian;
    values += response.points.size();
    if constexpr (kSlopes) jacobian += response.points.size() * unknowns;
    for (const Point& point : response.points) {
      if (point.row + (point.fraction > 0.0 ? 1 : 0) >= rows) return false;
    }
    here.consecutive = !here.points.empty();
    for (std::size_t k = 0; here.consecutive && k < here.points.size(); ++k) {
      const Point& point = here.points[k];
      here.consecutive = point.row == here.points.front().row + k && point.fraction == 0.0;
    }
    if (!std::is_sorted(here.points.begin(), here.points.end(), goes_before)) {
      here.order.resize(here.points.size());
      for (std::size_t k = 0; k < here.order.size(); ++k) here.order[k] = k;
      std::stable_sort(here.order.begin(), here.order.end(), [&](std::size_t a, std::size_t b) {
        return goes_before(here.points[a], here.points[b]);
      });
    }
    for (std::size_t d = 0; d < definitions.size(); ++d) {
      const law::SlipSpace& slip = definitions[d].slip;
      for (std::size_t i = 0; i < static_cast<std::size_t>(slip.dimension); ++i) {
        if (slip.component[i] != response.component) continue;
        here.sources.emplace_back(run_definition(d), i);
      }
    }
    here.one_source = here.sources.size() == 1 && here.sources[0].slopes != nullptr &&
                      here.sources[0].slopes->force(0).size() == unknowns;
    running.push_back(std::move(here));
  }

  Increments increments(*this);
  std::size_t now = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const law::ConnectorIncrement& increment = increments.next();
    now = 1 - now;
    for (RunningDefinition& run : runs) {
      const law::FrictionState& old = run.updates[1 - now].state;
      // In place: an assignment would build the result elsewhere and copy its 400 bytes.
      static_assert(std::is_trivially_destructible_v<law::FrictionUpdate>);
      const law::FrictionUpdate& update = *::new (&run.updates[now]) law::FrictionUpdate(
          law::update_force(*run.definition, increment, old));
      if (!is_sound(update, jumps_)) return false;
      if constexpr (kSlopes) {
        if (run.slopes) run.slopes->advance(increment, old, update);
      }
    }
    for (RunningResponse& response : running) {
      read_row<kSlopes>(row, now, unknowns, response);
    }
  }
  return true;
}

bool Replay::show(std::span<const law::FrictionDefinition> definitions, const Watch& watch) const {
  std::vector<law::FrictionUpdate> updates(definitions.size());
  Increments increments(*this);
  for (std::size_t row = 0; row < times_.size(); ++row) {
    const law::ConnectorIncrement& increment = increments.next();
    for (std::size_t d = 0; d < definitions.size(); ++d) {
      updates[d] = law::update_force(definitions[d], increment, updates[d].state);
      if (!is_sound(updates[d], jumps_)) return false;
    }
    if (watch) watch(increment.end, updates);
  }
  return true;
}

bool Replay::run(std::span<const law::FrictionDefinition> definitions,
                 std::span<const Response> responses, std::span<double> values) const {
  return run_all<false>(definitions, {}, 0, responses, values.data(), nullptr);
}

bool Replay::run(std::span<const law::FrictionDefinition> definitions,
                 std::span<const law::DefinitionSlopes> slopes, std::size_t unknowns,
                 std::span<const Response> responses, std::span<double> values,
                 std::span<double> jacobian) const {
  return run_all<true>(definitions, slopes, unknowns, responses, values.data(), jacobian.data());
}

}  // namespace slipbench::driver::calibrate
