// SPDX-License-Identifier: Apache-2.0
#include "driver/results/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/bench/connector_increment.hpp"

namespace slipbench::driver::results {
namespace {

/// Moves `axis.last` to the interval of `x` within the table, right-hand at a knot.
void locate(TableCoverage::Axis& axis, double x) {
  const std::vector<double>& knots = axis.knots;
  if (knots.size() < 3) return;
  const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
  axis.last = static_cast<std::size_t>(next - knots.begin()) - 1;
}

/// Tells whether `x` lies in the interval of the last increment: they follow each other closely.
bool is_where_it_was(const TableCoverage::Axis& axis, double x) {
  const double* const begin = axis.knots.data() + axis.last;
  return axis.knots.size() > 1 && x >= begin[0] && x < begin[1];
}

}  // namespace

std::string independent_name(const law::Independent& independent) {
  using Kind = law::IndependentKind;
  switch (independent.kind) {
    case Kind::kSlipRate:
      return "slip_rate";
    case Kind::kContactForce:
      return "contact_force";
    case Kind::kAccumulatedSlip:
      return "accumulated_slip";
    case Kind::kTemperature:
      return "temperature";
    case Kind::kField:
      return fmt::format("field{}", independent.index + 1);
    case Kind::kPosition:
      return cases::motion_name(independent.index);
    case Kind::kConstitutiveMotion:
      break;
  }
  return "CU" + cases::component_suffix(independent.index);
}

std::size_t TableCoverage::unvisited() const {
  return static_cast<std::size_t>(std::count(visits.begin(), visits.end(), 0));
}

std::string TableCoverage::cell_text(std::size_t cell) const {
  std::string text;
  for (const Axis& axis : axes) {
    const std::size_t i = cell / axis.stride % axis.intervals();
    text += (text.empty() ? "" : ", ") + axis.name + " " + base::format_number(axis.knots[i]);
    if (axis.knots.size() > 1) text += " .. " + base::format_number(axis.knots[i + 1]);
  }
  return text;
}

Coverage::Coverage(const cases::Case& problem) : case_(&problem) {
  constexpr int kEver = std::numeric_limits<int>::max();
  const auto add_law = [&](const law::FrictionLaw& law, std::size_t d, std::string what, int first,
                           int end, Sense sense = Sense::kAny) {
    if (const auto* tabular = std::get_if<law::TabularCoefficient>(&law)) {
      add_table(tabular->table, Use::kCoefficient, d, std::move(what), first, end, sense);
    }
  };
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    const law::FrictionDefinition& definition = problem.definitions[d].law;
    // The law in force, and the step since which it is.
    const law::FrictionLaw* law = &definition.law;
    std::string what = "coefficient";
    int since = 0;
    const auto& backward = problem.definitions[d].backward;
    for (std::size_t s = 0; s < problem.steps.size(); ++s) {
      for (const cases::FrictionChange& change : problem.steps[s].friction_changes) {
        if (change.definition != d) continue;
        if (s > 0) add_law(*law, d, what, since, static_cast<int>(s));
        law = &change.law;
        since = static_cast<int>(s);
        what = "coefficient of step '" + problem.steps[s].name + "'";
      }
    }
    if (backward) {
      add_law(*law, d, "coefficient.forward", 0, kEver, Sense::kForward);
      add_law(*backward, d, "coefficient.backward", 0, kEver, Sense::kBackward);
    } else {
      add_law(*law, d, what, since, kEver);
    }
    if (const auto* table = std::get_if<law::TableFunction>(&definition.internal_contact_force)) {
      add_table(*table, Use::kInternalContactForce, d, "internal_contact_force", 0, kEver);
    }
    if (const auto* derived = std::get_if<law::DerivedComponent>(&definition.contact_force)) {
      for (const law::DerivedTerm& term : *derived) {
        if (!term.weight_table) continue;
        add_table(*term.weight_table, Use::kWeights, d, "weights", 0, kEver);
      }
    }
  }
  by_step_.resize(tables_.size());
  std::iota(by_step_.begin(), by_step_.end(), std::size_t{0});
  std::stable_sort(by_step_.begin(), by_step_.end(), [&](std::size_t a, std::size_t b) {
    return probes_[a].first_step < probes_[b].first_step;
  });
}

void Coverage::add_table(const law::TableFunction& function, Use use, std::size_t definition,
                         std::string what, int first_step, int end_step, Sense sense) {
  if (function.independents().empty()) return;
  TableCoverage table;
  table.definition = definition;
  table.what = std::move(what);
  table.extrapolation = function.table().extrapolation();
  std::size_t cells = 1;
  for (std::size_t k = 0; k < function.independents().size(); ++k) {
    const auto knots = function.table().knots(static_cast<int>(k));
    TableCoverage::Axis axis;
    axis.name = independent_name(function.independents()[k]);
    axis.knots.assign(knots.begin(), knots.end());
    axis.stride = cells;
    cells = cells > kMostCells ? cells : cells * axis.intervals();
    table.axes.push_back(std::move(axis));
  }
  if (cells <= kMostCells - cells_) {
    table.visits.resize(cells);
    cells_ += cells;
  }
  tables_.push_back(std::move(table));
  probes_.push_back({&function, use, first_step, end_step, sense});
}

void Coverage::go_to(int step) {
  if (step < step_) {
    next_ = 0;
    in_force_.clear();
  }
  step_ = step;
  const auto is_over = [&](std::size_t table) { return probes_[table].end_step <= step; };
  std::erase_if(in_force_, is_over);
  for (; next_ < by_step_.size() && probes_[by_step_[next_]].first_step <= step; ++next_) {
    if (!is_over(by_step_[next_])) in_force_.push_back(by_step_[next_]);
  }
}

void Coverage::add(std::span<const bench::Row> rows) {
  if (tables_.empty()) return;
  while (!rows.empty()) {
    const int step = rows.front().step;
    const auto behind = std::find_if(rows.begin(), rows.end(),
                                     [&](const bench::Row& row) { return row.step != step; });
    const auto of_step = static_cast<std::size_t>(behind - rows.begin());
    if (step != step_) go_to(step);
    for (const std::size_t table : in_force_) count(rows.first(of_step), table);
    rows = rows.subspan(of_step);
  }
}

void Coverage::count(std::span<const bench::Row> rows, std::size_t which) {
  const Probe& probe = probes_[which];
  const std::size_t definition = tables_[which].definition;
  law::Ambient end;
  for (const bench::Row& row : rows) {
    if (row.index == 0) continue;
    const bench::DefinitionRow& here = row.definitions[definition];
    if (probe.sense != Sense::kAny && here.backward != (probe.sense == Sense::kBackward)) continue;
    if (probe.function->depends_on_motion()) {
      end = bench::ambient_of(row.quantities, case_->reference);
    } else {
      end.temperature = row.quantities[cases::kTemperatureQuantity];
      end.fields = bench::fields_of(row.quantities);
    }
    count(end, here.update, which);
  }
}

void Coverage::add(const law::Ambient& end, std::span<const law::FrictionUpdate> updates) {
  for (std::size_t t = 0; t < tables_.size(); ++t) count(end, updates[tables_[t].definition], t);
}

void Coverage::count(const law::Ambient& end, const law::FrictionUpdate& update,
                     std::size_t which) {
  const Probe& probe = probes_[which];
  TableCoverage& table = tables_[which];
  law::SlipArguments slip;
  if (probe.use == Use::kCoefficient) {
    slip = {.slip_rate = update.slip_rate, .contact_force = update.normal_force};
  } else if (probe.use == Use::kInternalContactForce) {
    const bool at_end = case_->definitions[table.definition].law.accumulated_slip ==
                        law::AccumulatedSlipTiming::kEnd;
    slip.accumulated_slip = update.state.accumulated_slip - (at_end ? 0.0 : update.slip_increment);
  }
  const std::span<const law::Independent> independents = probe.function->independents();
  ++table.increments;
  std::size_t cell = 0;
  bool outside = false;
  for (std::size_t k = 0; k < table.axes.size(); ++k) {
    TableCoverage::Axis& axis = table.axes[k];
    const double x = law::argument(independents[k], end, slip);
    if (is_where_it_was(axis, x)) {
      cell += axis.last * axis.stride;
    } else if (x < axis.knots.front()) {
      ++axis.below;
      outside = true;
    } else if (x > axis.knots.back()) {
      ++axis.above;
      outside = true;
    } else {
      locate(axis, x);
      cell += axis.last * axis.stride;
    }
  }
  if (outside) {
    ++table.outside;
  } else if (!table.visits.empty()) {
    ++table.visits[cell];
  }
}

std::string Coverage::text(std::size_t most_lines) const {
  std::string text;
  std::size_t lines = 0;
  std::size_t left = 0;
  std::size_t uncounted = 0;
  for (const TableCoverage& table : tables_) {
    if (table.increments > 0 && table.visits.empty()) ++uncounted;
    const std::size_t unvisited = table.unvisited();
    if (table.increments == 0 || (unvisited == 0 && table.outside == 0)) continue;
    if (lines == most_lines) {
      ++left;
      continue;
    }
    ++lines;
    std::string line =
        fmt::format("  table '{}' of '{}':", table.what, case_->definitions[table.definition].name);
    if (!table.visits.empty()) {
      line += fmt::format(" {} of {} cell{} used", table.visits.size() - unvisited,
                          table.visits.size(), table.visits.size() == 1 ? "" : "s");
    }
    if (table.outside > 0) {
      std::string where;
      for (const TableCoverage::Axis& axis : table.axes) {
        for (const auto& [count, side, knot] :
             {std::tuple{axis.below, "below", axis.knots.front()},
              std::tuple{axis.above, "above", axis.knots.back()}}) {
          if (count == 0) continue;
          where += fmt::format("{}{} {} {}", where.empty() ? "" : ", ", axis.name, side,
                               base::format_number(knot));
        }
      }
      const bool held = table.extrapolation == law::Extrapolation::kConstant;
      line += fmt::format("{} outside in {} of {} increments ({}), where {}",
                          table.visits.empty() ? "" : ",", table.outside, table.increments, where,
                          held ? "the end value is held" : "the end segment is prolonged");
    }
    text += line + "\n";
  }
  if (left > 0) text += fmt::format("  {} more table{} like these\n", left, left == 1 ? "" : "s");
  if (uncounted > 0) {
    text += fmt::format("  the cells of {} table{} are not counted: more than {} in all\n",
                        uncounted, uncounted == 1 ? "" : "s", kMostCells);
  }
  return text;
}

base::json::Value Coverage::to_json() const {
  constexpr std::size_t kMostListed = 1000;
  // A case may have a table for each of its steps: 3 MB of text.
  std::size_t left = 100 * kMostListed;
  base::json::Value all = base::json::Array{};
  for (const TableCoverage& table : tables_) {
    base::json::Value one;
    one["definition"] = case_->definitions[table.definition].name;
    one["table"] = table.what;
    one["increments"] = table.increments;
    one["increments_outside"] = table.outside;
    const bool held = table.extrapolation == law::Extrapolation::kConstant;
    one["outside"] = held ? "held" : "prolonged";
    base::json::Value axes = base::json::Array{};
    for (const TableCoverage::Axis& axis : table.axes) {
      base::json::Value entry;
      entry["independent"] = axis.name;
      entry["first"] = axis.knots.front();
      entry["last"] = axis.knots.back();
      entry["below"] = axis.below;
      entry["above"] = axis.above;
      axes.push_back(entry);
    }
    one["independents"] = axes;
    if (!table.visits.empty()) {
      one["cells"] = table.visits.size();
      one["cells_never_visited"] = table.unvisited();
      base::json::Value never = base::json::Array{};
      base::json::Value visited = base::json::Array{};
      const std::size_t listed = std::min({table.visits.size(), kMostListed, left});
      left -= listed;
      for (std::size_t cell = 0; cell < listed; ++cell) {
        if (table.visits[cell] == 0) {
          never.push_back(table.cell_text(cell));
          continue;
        }
        base::json::Value entry;
        entry["cell"] = table.cell_text(cell);
        entry["increments"] = table.visits[cell];
        visited.push_back(entry);
      }
      one["never_visited"] = never;
      one["visited"] = visited;
      one["cells_listed"] = listed;
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace slipbench::driver::results
