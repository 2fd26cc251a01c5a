// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "driver/base/text/format_number.hpp"
#include "driver/case/quantity.hpp"
#include "driver/case/quantity_dimension.hpp"
#include "driver/history/profile_cursor.hpp"
#include "driver/read/keys/column_unit.hpp"
#include "driver/read/keys/degrees.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {
namespace {

/// A belt is driven by its tension, by that behind its ring, and by its nodes where it has them.
/// \return nothing if `name` is none of these; the quantity, or -1 after reporting an error
std::optional<int> belt_quantity_of(yaml::Binder& binder, const cases::Case& problem,
                                    const std::string& name, const yaml::Node& key,
                                    const yaml::Path& path, bool motion, bool force) {
  if (motion && name == "CP1" && problem.belt->nodes) {
    binder.error(key, path, "the distance CP1 follows from the nodes a and b",
                 "move them under 'nodes:'");
    return -1;
  }
  if (!force) {
    if (name != "f_bc") return std::nullopt;
    binder.error(key, path, "'f_bc' is a tension: it goes under 'force:'");
    return -1;
  }
  if (name == "f_bc") return cases::kTensionBehind;
  const auto c = cases::component_of_force(name);
  if (!c) return std::nullopt;
  if (*c == 0) return cases::kFirstForce;
  binder.error(key, path,
               "a SLIPRING has the tensions f1, of segment ab, and f_bc, behind the ring; found '" +
                   name + "'");
  return -1;
}

std::string held_message(const law::Connection& connection, int component) {
  return connector_words(connection) + " holds component " + std::to_string(component + 1) +
         " (its constraint " + (law::is_rotation(component) ? "moment " : "force ") +
         cases::force_name(component) + " goes under 'force:'); free are " +
         motion_names(connection.info.available);
}

std::string nearest_quantity(const yaml::Binder& binder, std::string_view name,
                             const law::ConnectionInfo& info, bool motion, bool force, bool others,
                             std::string otherwise) {
  if (force)
    otherwise = nearest_component(name, info.held, cases::force_name, std::move(otherwise));
  if (motion) {
    otherwise = nearest_component(name, info.available, cases::motion_name, std::move(otherwise));
  }
  return others ? binder.nearest_or(name, std::array<std::string_view, 2>{"temperature", "field1"},
                                    std::move(otherwise))
                : otherwise;
}

/// The quantity a name under motion, force, fields or the columns of a measured history means.
std::optional<int> quantity_of(yaml::Binder& binder, const cases::Case& problem,
                               const std::string& name, const yaml::Node& key,
                               const yaml::Path& path, bool motion, bool force, bool others) {
  const law::ConnectionInfo& info = problem.connection.info;
  const std::string words = connector_words(problem.connection);
  if (problem.belt) {
    if (const auto q = belt_quantity_of(binder, problem, name, key, path, motion, force)) {
      return *q < 0 ? std::nullopt : q;
    }
  }
  if (name == "driver" && force && problem.dynamics) {
    if (problem.dynamics->driver) return cases::kDriverLoad;
    binder.error(key, path, "the mass has no driver that a load could act on",
                 "'dynamics: {driver: {mass: .., velocity: ..}}' gives it one");
    return std::nullopt;
  }
  if (const auto c = cases::component_of_motion(name); c && (motion || force)) {
    if (!motion) {
      binder.error(key, path, "'" + name + "' is a motion: it goes under 'motion:'");
    } else if (info.available.contains(*c)) {
      return cases::kFirstMotion + *c;
    } else if (info.held.contains(*c)) {
      binder.error(key, path, held_message(problem.connection, *c));
    } else {
      binder.error(key, path,
                   words + " has no component " + std::to_string(*c + 1) + "; free are " +
                       motion_names(info.available));
    }
    return std::nullopt;
  }
  if (const auto c = cases::component_of_force(name); c && (motion || force)) {
    if (!force) {
      binder.error(key, path, "'" + name + "' is a force: it goes under 'force:'");
    } else if (info.held.contains(*c) || info.available.contains(*c)) {
      return cases::kFirstForce + *c;
    } else {
      binder.error(key, path,
                   words + " has no component " + std::to_string(*c + 1) +
                       "; its constraint forces are " + force_names(info.held) +
                       ", its free components take " + force_names(info.available));
    }
    return std::nullopt;
  }
  if (others) {
    if (name == "temperature") return cases::kTemperatureQuantity;
    if (const auto field = cases::field_of(name)) return cases::kFirstField + *field;
  }
  std::string known;
  if (motion) known += motion_names(info.available);
  if (force) known += (known.empty() ? "" : ", ") + force_names(info.held);
  if (others) {
    known += (known.empty() ? "field1 .. field" : ", temperature, field1 .. field") +
             std::to_string(law::kMaxFields);
  }
  binder.error(key, path, "unknown quantity '" + base::printable(name) + "'",
               nearest_quantity(binder, name, info, motion, force, others, "known here: " + known));
  return std::nullopt;
}

/// The dimensions that a unit of a quantity may have: fields have none that is known.
std::vector<base::Dimension> dimensions_of(const cases::Case& problem, int quantity) {
  const base::Dimension dimension = cases::dimension_of(problem, quantity);
  return dimension == base::Dimension{} ? std::vector<base::Dimension>{} : std::vector{dimension};
}

/// Returns true if a quantity can follow the positions that a formula names; else reports why not.
bool may_follow_position(yaml::Binder& binder, const cases::Case& problem,
                         const history::PositionFormula& formula, const yaml::Node& node,
                         const yaml::Path& path, int quantity) {
  const std::string named(*std::find_if(
      formula.expression.used_variables().begin(), formula.expression.used_variables().end(),
      [](const std::string& name) { return cases::component_of_motion(name).has_value(); }));
  const bool force = (quantity >= cases::kFirstForce && quantity < cases::kTemperatureQuantity) ||
                     quantity == cases::kDriverLoad;
  if (!force || problem.belt) {
    binder.error(node, path,
                 "only forces can follow a position such as " + named +
                     (problem.belt ? ", and not the tensions of a belt" : ""),
                 "the variables here are t and T");
    return false;
  }
  const law::ConnectionInfo& info = problem.connection.info;
  for (const std::string& name : formula.expression.used_variables()) {
    const auto c = cases::component_of_motion(name);
    if (!c || (info.held | info.available).contains(*c)) continue;
    binder.error(node, path,
                 connector_words(problem.connection) + " has no position " + name + "; it has " +
                     motion_names(info.held | info.available));
    return false;
  }
  return true;
}

/// Finishes a profile now that it is known what it drives, and tries its data out.
///
/// \param start of the step; the current value is not known before the run
std::optional<history::Profile> finish(yaml::Binder& binder, const cases::Case& problem,
                                       const ProfileText& text, const yaml::Node& node,
                                       const yaml::Path& path, int quantity,
                                       const history::StepStart& start) {
  doubt_angles_of_profile(binder, node, path,
                          quantity < cases::kFirstForce && law::is_rotation(quantity));
  history::Profile profile = text.profile;
  if (std::holds_alternative<history::Constant>(profile) && quantity < cases::kFirstForce) {
    binder.error(node, path, "a motion needs a profile, found a number",
                 "{to: " + base::format_number(std::get<history::Constant>(profile).value) +
                     "} goes there linearly over the step");
    return std::nullopt;
  }
  if (const auto* points = std::get_if<history::Tabular>(&profile);
      points && !history::covers(*points, start.duration)) {
    binder.error(node, path,
                 "the table covers t = " + base::format_number(points->times.front()) + " .. " +
                     base::format_number(points->times.back()) + ", the step asks for 0 .. " +
                     base::format_number(start.duration));
    return std::nullopt;
  }
  if (auto* csv = std::get_if<history::CsvColumn>(&profile)) {
    const yaml::Node& at = *text.csv.node;
    if (!may_read(binder, csv->data, at, text.csv.path)) return std::nullopt;
    const std::array names{csv->time_column, csv->value_column};
    const auto file = base::CsvReader::open(csv->data, names);
    if (!file) {
      binder.history_error(at, text.csv.path, file.error());
      return std::nullopt;
    }
    const auto value = column_unit(binder, &*file, csv->value_column, at, text.csv.path, text.unit,
                                   dimensions_of(problem, quantity), problem.units);
    const auto time = column_unit(binder, &*file, csv->time_column, at, text.csv.path,
                                  text.time_unit, std::span(&base::kTime, 1), problem.units);
    if (!value || !time) return std::nullopt;
    csv->value_conversion = value->conversion;
    csv->time_conversion = time->conversion;
    csv->time_conversion.offset -= text.begins;
    note_missing(binder, csv->data, names, at, text.csv.path);
  }
  if (const auto* formula = std::get_if<history::PositionFormula>(&profile)) {
    if (!may_follow_position(binder, problem, *formula, node, path, quantity)) return std::nullopt;
    // Where a later step begins shows only on the way.
    if (!problem.steps.empty()) return profile;
  }
  auto cursor = history::ProfileCursor::open(profile);
  const auto begun = cursor ? cursor->begin(start) : tl::unexpected(cursor.error());
  if (!begun) {
    const bool file = text.csv.given();
    binder.history_error(file ? *text.csv.node : node, file ? text.csv.path : path, begun.error());
    return std::nullopt;
  }
  return profile;
}

/// Warns of a sine whose increments are too few to follow it: they show another, slower one. The
/// peaks and jumps of the other waves are ends of increments.
void doubt_increments(yaml::Binder& binder, const yaml::Node& node, const yaml::Path& path,
                      const history::Profile& profile, const cases::Step& step) {
  constexpr double kFewest = 4.0;
  constexpr double kEnough = 20.0;
  const auto* wave = std::get_if<history::Wave>(&profile);
  if (wave == nullptr || wave->shape != history::WaveShape::kSine || wave->amplitude == 0.0) return;
  const double per_period = wave->period / step.duration * static_cast<double>(step.increments);
  if (!(per_period < kFewest)) return;
  binder.warning(
      node, path,
      fmt::format("{:.3g} increments a period are too few to follow the sine: they show a "
                  "slower or a smaller one",
                  per_period),
      fmt::format("increments: {:.0f} make {:.0f} a period",
                  std::ceil(kEnough * step.duration / wave->period), kEnough));
}

/// \param start total time at the step's start
void read_step(yaml::Binder& binder, const StepText& text, cases::Case& out, double start,
               NodePlaces& places) {
  cases::Step step;
  step.name = text.step.value;
  step.duration = text.duration.value;
  step.increments = text.increments;
  step.repeat = text.repeat;
  // A table may well cover the duration that was meant.
  const bool judge = !text.duration.faulty();
  const auto add = [&](std::optional<int> quantity, const ProfileText& profile,
                       const yaml::Node& node, const yaml::Path& path, bool sound) {
    if (quantity) binder.settle_units(path, cases::dimension_of(out, *quantity));
    if (!quantity || !sound || !judge) return;
    const history::StepStart begin{.duration = step.duration,
                                   .current_value = 0.0,
                                   .total_time = start,
                                   .position = out.initial.values};
    auto finished = finish(binder, out, profile, node, path, *quantity, begin);
    if (!finished) return;
    doubt_increments(binder, node, path, *finished, step);
    step.drives.push_back({*quantity, std::move(*finished)});
  };
  for (const auto& entry : text.motion) {
    add(quantity_of(binder, out, entry.name, *entry.key, entry.path, true, false, false),
        entry.value, *entry.node, entry.path, entry.sound);
  }
  drive_nodes(binder, text, out, places, [&](int quantity, const yaml::At<ProfileText>& profile) {
    add(quantity, profile.value, *profile.node, profile.path, profile.sound);
  });
  for (const auto& entry : text.force) {
    add(quantity_of(binder, out, entry.name, *entry.key, entry.path, false, true, false),
        entry.value, *entry.node, entry.path, entry.sound);
  }
  if (text.temperature.given()) {
    add(cases::kTemperatureQuantity, text.temperature.value, *text.temperature.node,
        text.temperature.path, text.temperature.sound);
  }
  for (const auto& entry : text.fields) {
    const auto field = cases::field_of(entry.name);
    if (!field) {
      binder.error(*entry.key, entry.path, "unknown field '" + base::printable(entry.name) + "'",
                   "fields are field1 .. field" + std::to_string(law::kMaxFields));
      continue;
    }
    add(cases::kFirstField + *field, entry.value, *entry.node, entry.path, entry.sound);
  }
  out.steps.push_back(std::move(step));
}

bool names_component(const yaml::NamedMap<double>& positions, int component) {
  return std::any_of(positions.begin(), positions.end(), [&](const auto& entry) {
    return entry.name == cases::motion_name(component);
  });
}

void read_measured(yaml::Binder& binder, const MeasuredText& text, const ConnectorText& connector,
                   cases::Case& out) {
  history::MeasuredSource source;
  const auto data = data_source(binder, text.csv);
  std::vector<std::string> names;
  if (text.time.sound) names.push_back(text.time.value);
  for (const auto& entry : text.columns.value) {
    if (entry.sound) names.push_back(entry.value.column.value);
  }
  std::optional<base::CsvReader> file;
  if (data) {
    auto opened = base::CsvReader::open(*data, names);
    if (opened) {
      file = std::move(*opened);
    } else {
      binder.history_error(*text.csv.node, text.csv.path, opened.error());
    }
    source.data = *data;
  }
  const base::CsvReader* const header = file ? &*file : nullptr;
  bool good = file && text.time.sound && text.columns.sound;
  std::optional<ColumnUnit> time;
  if (text.time.sound) {
    time = column_unit(binder, header, text.time.value, *text.time.node, text.time.path,
                       text.time_unit, std::span(&base::kTime, 1), out.units);
    good = good && time;
  }
  if (text.columns.sound && text.columns.value.empty()) {
    binder.error(*text.columns.node, text.columns.path, "needs at least one column to drive");
    good = false;
  }
  if (time) source.time_conversion = time->conversion;
  source.time_column = text.time.value;
  source.hold = text.hold;
  for (const auto& entry : text.columns.value) {
    const auto quantity =
        quantity_of(binder, out, entry.name, *entry.key, entry.path, true, true, true);
    if (!quantity || !entry.sound) {
      good = false;
      continue;
    }
    const yaml::At<std::string>& column = entry.value.column;
    const auto unit = column_unit(binder, header, column.value, *column.node, column.path,
                                  entry.value.unit, dimensions_of(out, *quantity), out.units);
    if (!unit) {
      good = false;
      continue;
    }
    source.columns.push_back({static_cast<std::size_t>(*quantity), column.value, unit->conversion});
  }
  if (!good) return;
  auto opened = history::MeasuredHistory::open(source);
  const auto first = opened ? opened->advance() : tl::unexpected(opened.error());
  if (!first) {
    binder.history_error(*text.csv.node, text.csv.path, first.error());
    return;
  }
  note_missing(binder, source.data, names, *text.csv.node, text.csv.path);
  // A measured path starts at its first row: that is the initial position unless the case says so.
  for (std::size_t i = 0; i < source.columns.size(); ++i) {
    const int component = static_cast<int>(source.columns[i].quantity);
    if (component >= cases::kFirstForce || names_component(connector.initial, component)) continue;
    out.initial[component] = opened->values()[i];
    if (!names_component(connector.reference, component)) {
      out.reference[component] = out.initial[component];
    }
  }
  out.measured = std::move(source);
}

}  // namespace

void resolve_history(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  const HistoryText& history = text.history.value;
  if (history.measured) {
    read_measured(binder, *history.measured, text.connector.value, out);
    return;
  }
  double start = 0.0;
  NodePlaces places;
  std::map<std::string_view, std::size_t> names;
  for (std::size_t i = 0; i < history.steps.size(); ++i) {
    const StepText& step = history.steps[i].value;
    if (step.step.sound && step.step.value.empty()) {
      binder.error(*step.step.node, step.step.path, "the name of a step must not be empty");
    }
    if (step.step.sound) {
      const auto [first, is_new] = names.try_emplace(step.step.value, i);
      if (!is_new) {
        binder.error(*step.step.node, step.step.path,
                     "the name '" + base::printable(step.step.value) +
                         "' is already that of history[" + std::to_string(first->second) + "]");
      }
    }
    read_step(binder, step, out, start, places);
    const bool ends = std::isfinite(start);
    start += step.repeat * step.duration.value;
    if (ends && !std::isfinite(start) && step.duration.sound) {
      binder.error(*step.duration.node, step.duration.path,
                   "the total time at the end of this step is beyond the largest number, 1.8e308");
    }
  }
}

}  // namespace slipbench::driver::read
