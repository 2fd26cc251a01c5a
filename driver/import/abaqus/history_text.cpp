// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/case/quantity.hpp"
#include "driver/import/abaqus/case_parts.hpp"
#include "driver/import/abaqus/keyword_list.hpp"
#include "driver/import/abaqus/profile_text.hpp"

namespace slipbench::driver::abaqus {

bool CaseParts::is_mine(const std::string& target) const {
  return connector_.labels.count(target) > 0;
}

std::string CaseParts::history_text() {
  std::string text = "history:\n";
  std::vector<Step> steps = model_.steps;
  if (steps.empty()) {
    notes_.emplace_back("the deck has no step: the motion is asked for");
    steps.push_back({.name = "slide", .where = connector_.where});
  }
  values_ = initial_;
  driven_ = {};
  loads_.fill(0.0);
  double begin = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    text += step_text(steps[i], i == 0, i + 1 == steps.size(), begin);
    begin += steps[i].period;
  }
  return text;
}

std::string CaseParts::step_text(const Step& step, bool first, bool last, double begin) {
  constexpr double kIncrements = 100.0;
  constexpr double kMostIncrements = 1e6;
  std::string text = "  - step: " + quoted(step.name) + "\n";
  text += "    duration: " + number_text(step.period) + "\n";
  const double wanted =
      step.increment > 0.0 ? std::ceil(step.period / step.increment - 1e-9) : kIncrements;
  text += fmt::format("    increments: {}\n",
                      static_cast<long>(std::clamp(wanted, 1.0, kMostIncrements)));
  std::vector<std::string> motion;
  std::vector<std::string> force;
  for (const Drive& drive : step.drives) {
    if (!is_mine(drive.target)) continue;
    const int c = drive.component - 1;
    const auto i = static_cast<std::size_t>(c);
    if (!connection_.info.available.contains(c)) {
      pass(fmt::format("component {} is not free, and yet driven ({})", drive.component,
                       deck_.place(drive.where)));
    }
    const std::string name = drive.is_load ? cases::force_name(c) : cases::motion_name(c);
    double& value = drive.is_load ? loads_[i] : values_[i];
    DriveProfile profile = profile_of(deck_, model_, step, drive, name,
                                      drive.is_load ? 0.0 : initial_[i], value, begin);
    if (!profile.note.empty()) notes_.push_back(profile.note);
    if (profile.text.empty()) {
      profile.text = quoted(ask(name, "at the end of " + step.name));
      if (!drive.is_load) profile.text = "{to: " + profile.text + "}";
    }
    value = profile.end;
    driven_.insert(c);
    (drive.is_load ? force : motion).push_back(name + ": " + profile.text);
  }
  for (int c = 0; c < law::kComponents; ++c) {
    // A belt's flow at a is a result.
    if (driven_.contains(c) || !connection_.info.available.contains(c)) continue;
    if (belt_ && c != 1) continue;
    const std::string name = cases::motion_name(c);
    if (const auto profile = recorded({name}, begin)) {
      motion.push_back(name + ": " + *profile);
      continue;
    }
    // A free component that nothing drives, springs hold where they are.
    if (!last) continue;
    motion.push_back(
        name + ": {to: " +
        quoted(ask(name, fmt::format("position at the end of {}: no step drives it", step.name))) +
        "}");
  }
  std::vector<std::string> ambient;
  std::vector<std::string> fields;
  take_nodes(step, begin, force, ambient, fields);
  for (int c = 0; c < law::kComponents; ++c) {
    if (!forces_.contains(c) || connector_.alone) continue;
    const std::string name = cases::force_name(c);
    if (const auto profile =
            recorded({cases::force_column("CRF", c), cases::force_column("CTF", c)}, begin)) {
      force.push_back(name + ": " + *profile);
    } else if (first) {
      force.push_back(name + ": " +
                      quoted(ask(name, fmt::format("constraint {} along {}, {} of the element",
                                                   law::is_rotation(c) ? "moment" : "force", c + 1,
                                                   cases::force_column("CRF", c)))));
    }
  }
  const bool has_spring =
      std::any_of(connector_.behavior->elasticity.begin(), connector_.behavior->elasticity.end(),
                  [](const Spring& one) { return one.component == 1; });
  if (belt_ && !has_spring && !driven_.contains(0)) {
    if (const auto tension = recorded({"CTF1"}, begin)) {
      force.push_back("f1: " + *tension);
    } else if (first) {
      force.push_back("f1: " + quoted(ask("f1", "tension of the belt between a and b, CTF1")));
    }
  }
  if (!motion.empty()) text += "    motion: {" + join(motion) + "}\n";
  if (!force.empty()) text += "    force: {" + join(force) + "}\n";
  for (const std::string& one : ambient_) {
    if (!first || connector_.alone) break;
    if (one == "temperature") {
      ambient.push_back("temperature: " + quoted(ask(one, "of the connector")));
    } else {
      fields.push_back(one + ": " + quoted(ask(one, "field variable of the connector")));
    }
  }
  for (const std::string& one : ambient) text += "    " + one + "\n";
  if (!fields.empty()) text += "    fields: {" + join(fields) + "}\n";
  return text + changes_text(step);
}

std::optional<std::string> CaseParts::recorded(const std::vector<std::string>& names,
                                               double begin) const {
  const RecordedHistory& history = options_.history;
  for (const std::string& name : names) {
    for (const std::string& column : history.columns) {
      if (folded(column) != name) continue;
      return fmt::format("{{csv: {}, time: {}, value: {}{}}}", quoted(history.file),
                         quoted(history.time), quoted(column),
                         begin > 0.0 ? ", begins: " + number_text(begin) : std::string());
    }
  }
  return std::nullopt;
}

/// Constraint forces, temperature and fields from those of the nodes, of a connector that is alone.
void CaseParts::take_nodes(const Step& step, double begin, std::vector<std::string>& force,
                           std::vector<std::string>& ambient, std::vector<std::string>& fields) {
  if (!connector_.alone) return;
  for (const Drive& drive : step.of_nodes) {
    if (drive.target != (*connector_.alone)[1]) continue;
    const int c = drive.component - 1;
    const auto i = static_cast<std::size_t>(c);
    const bool is_force = drive.quantity.empty();
    if (is_force && !connection_.info.held.contains(c)) continue;
    const std::string name = is_force ? cases::force_name(c) : drive.quantity;
    double& value = is_force ? loads_[i] : ambient_values_[name];
    const DriveProfile profile = profile_of(deck_, model_, step, drive, name, 0.0, value, begin);
    if (!profile.note.empty()) notes_.push_back(profile.note);
    if (profile.text.empty()) continue;
    value = profile.end;
    const std::string entry = name + ": " + profile.text;
    (is_force ? force : name == "temperature" ? ambient : fields).push_back(entry);
  }
}

std::string CaseParts::changes_text(const Step& step) {
  std::string text;
  for (const FrictionChange& change : step.changes) {
    if (!is_mine(change.target)) continue;
    std::vector<std::string> entries;
    if (change.reset) {
      entries.emplace_back("reset: true");
    } else {
      entries.push_back("coefficient: " + coefficient_text(change.coefficient));
      // The new friction stands alone: without TAUMAX there is no limit any more.
      if (change.coefficient) {
        entries.push_back("force_limit: " +
                          number_text(change.coefficient->force_limit.value_or(0.0)));
      }
      const std::string stick = stick_text(std::nullopt, change.coefficient);
      if (!stick.empty()) entries.push_back("stick: {" + stick + "}");
    }
    if (!change.amplitude.empty()) entries.push_back("amplitude: " + blend_text(step, change));
    text += text.empty() ? "    change_friction:\n" : "";
    for (std::size_t i = 0; i < connector_.behavior->frictions.size(); ++i) {
      text += fmt::format("      {}: {{{}}}\n", friction_name(i), join(entries));
    }
  }
  return text;
}

std::string CaseParts::blend_text(const Step& step, const FrictionChange& change) {
  Drive drive{
      .where = change.where, .magnitude = 1.0, .amplitude = change.amplitude, .is_load = true};
  const DriveProfile profile = profile_of(deck_, model_, step, drive, "weight", 0.0, 0.0, 0.0);
  if (profile.text == "{smooth_to: 1}") return "smooth";
  if (profile.text.empty() || profile.text.front() != '{') {
    pass(fmt::format("the amplitude of *CHANGE FRICTION ({}) is no table",
                     deck_.place(change.where)));
  }
  return profile.text;
}

}  // namespace slipbench::driver::abaqus
