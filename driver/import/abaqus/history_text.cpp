// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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
  const bool none = model_.steps.empty();
  if (none) notes_.emplace_back("the deck has no step: the motion is asked for");
  const std::vector<Step> asked(none ? 1 : 0, Step{.name = "slide", .where = connector_.where});
  const std::vector<Step>& steps = none ? asked : model_.steps;
  values_ = initial_;
  driven_ = {};
  moved_ = {};
  loaded_ = {};
  of_nodes_.clear();
  going_.clear();
  going_of_nodes_.clear();
  loads_.fill(0.0);
  double begin = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string step = step_text(steps[i], i == 0, i + 1 == steps.size(), begin);
    if (options_.characters != nullptr) *options_.characters += step.size();
    text += step;
    constexpr std::size_t kMostText = std::size_t{4} << 20U;
    if (text.size() > kMostText) {
      pass(
          fmt::format("its history takes more than {} MiB up to {}: let its amplitudes have fewer "
                      "points, or its steps",
                      kMostText >> 20U, steps[i].name));
    }
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
  const auto increments = static_cast<long>(std::clamp(wanted, 1.0, kMostIncrements));
  text += fmt::format("    increments: {}\n", increments);
  std::vector<std::string> motion;
  std::vector<std::string> force;
  std::vector<Drive> stated;
  std::copy_if(step.drives.begin(), step.drives.end(), std::back_inserter(stated),
               [&](const Drive& one) { return is_mine(one.target); });
  std::erase_if(going_,
                [&](const Drive& one) { return one.is_load ? step.new_loads : step.new_motions; });
  const std::vector<Drive> drives = in_effect(step, stated, going_);
  going_.clear();
  let_go(step, drives, force);
  for (const Drive& drive : drives) {
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
    go_on(drive, profile, going_);
    driven_.insert(c);
    (drive.is_load ? loaded_ : moved_)[i] = true;
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
  return text + changes_text(step, begin, increments);
}

std::vector<Drive> CaseParts::in_effect(const Step& step, const std::vector<Drive>& stated,
                                        const std::vector<Drive>& going) {
  const auto same = [](const Drive& a, const Drive& b) {
    return a.component == b.component && a.is_load == b.is_load && a.quantity == b.quantity;
  };
  // A step may drive each connector through hundreds of sets: a few notes say what is wrong.
  constexpr int kMostTold = 5;
  int twice = 0;
  std::vector<Drive> drives;
  for (const Drive& one : stated) {
    const auto before = std::find_if(drives.begin(), drives.end(),
                                     [&](const Drive& other) { return same(one, other); });
    if (before == drives.end()) {
      drives.push_back(one);
      continue;
    }
    const std::string name = !one.quantity.empty() ? one.quantity
                             : one.is_load         ? cases::force_name(one.component - 1)
                                                   : cases::motion_name(one.component - 1);
    if (++twice <= kMostTold) {
      notes_.push_back(fmt::format("{}: stated twice in {} ({} and {}): the last one holds", name,
                                   step.name, deck_.place(before->where), deck_.place(one.where)));
    }
    *before = one;
  }
  if (twice > kMostTold) {
    notes_.push_back(fmt::format("{}: {} more are stated twice: the last one holds", step.name,
                                 twice - kMostTold));
  }
  for (const Drive& one : going) {
    const bool again = std::any_of(drives.begin(), drives.end(),
                                   [&](const Drive& other) { return same(one, other); });
    if (!again) drives.push_back(one);
  }
  return drives;
}

void CaseParts::go_on(const Drive& drive, const DriveProfile& profile,
                      std::vector<Drive>& going) const {
  if (drive.fixed || drive.user || profile.text.empty()) return;
  const Amplitude* const amplitude = find_amplitude(model_, drive.amplitude);
  if (amplitude != nullptr && amplitude->total_time) {
    going.push_back(drive);
  } else if (!drive.is_load && drive.type == "VELOCITY") {
    // An amplitude over the time of its step keeps its last value.
    going.push_back(drive);
    going.back().magnitude = profile.rate;
    going.back().amplitude.clear();
  }
}

void CaseParts::let_go(const Step& step, const std::vector<Drive>& drives,
                       std::vector<std::string>& force) {
  const auto stated = [&](int c, bool is_load) {
    return std::any_of(drives.begin(), drives.end(), [&](const Drive& one) {
      return one.component == c + 1 && one.is_load == is_load;
    });
  };
  const std::string none = step.at_once.value_or(!step.is_static) ? "0" : "{to: 0}";
  for (int c = 0; c < law::kComponents; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const bool unloads = step.new_loads && loaded_[i] && !stated(c, true);
    if (unloads) {
      loads_[i] = 0.0;
      loaded_[i] = false;
    }
    const bool frees = step.new_motions && moved_[i] && !stated(c, false);
    if (frees) {
      moved_[i] = false;
      notes_.push_back(fmt::format("{}: OP=NEW lets component {} go in {}: {}",
                                   cases::motion_name(c), c + 1, step.name,
                                   "its force is that of its load, 0 without one"));
    }
    if (stated(c, true) || moved_[i] || !(unloads || frees)) continue;
    force.push_back(cases::force_name(c) + ": " + (unloads ? none : number_text(loads_[i])));
  }
}

std::optional<std::string> CaseParts::recorded(const std::vector<std::string>& names,
                                               double begin) const {
  const RecordedHistory& history = options_.history;
  for (const std::string& name : names) {
    const auto column = history.columns.find(name);
    if (column == history.columns.end()) continue;
    return fmt::format("{{csv: {}, time: {}, value: {}{}}}", quoted(history.file),
                       quoted(history.time), quoted(column->second),
                       begin > 0.0 ? ", begins: " + number_text(begin) : std::string());
  }
  return std::nullopt;
}

/// Constraint forces, temperature and fields from those of the nodes, of a connector that is alone.
void CaseParts::take_nodes(const Step& step, double begin, std::vector<std::string>& force,
                           std::vector<std::string>& ambient, std::vector<std::string>& fields) {
  if (!connector_.alone) return;
  std::set<std::string> stated;
  std::vector<Drive> of_node_b;
  for (const Drive& drive : step.of_nodes) {
    if (drive.target != (*connector_.alone)[1]) continue;
    const bool is_held = connection_.info.held.contains(drive.component - 1);
    if (is_held || !drive.quantity.empty()) of_node_b.push_back(drive);
  }
  std::erase_if(going_of_nodes_,
                [&](const Drive& one) { return step.new_of_nodes && one.quantity.empty(); });
  const std::vector<Drive> drives = in_effect(step, of_node_b, going_of_nodes_);
  going_of_nodes_.clear();
  for (const Drive& drive : drives) {
    const int c = drive.component - 1;
    const auto i = static_cast<std::size_t>(c);
    const bool is_force = drive.quantity.empty();
    const std::string name = is_force ? cases::force_name(c) : drive.quantity;
    double& value = is_force ? loads_[i] : ambient_values_[name];
    const DriveProfile profile = profile_of(deck_, model_, step, drive, name, 0.0, value, begin);
    if (!profile.note.empty()) notes_.push_back(profile.note);
    if (profile.text.empty()) continue;
    value = profile.end;
    go_on(drive, profile, going_of_nodes_);
    if (is_force) stated.insert(name);
    const std::string entry = name + ": " + profile.text;
    (is_force ? force : name == "temperature" ? ambient : fields).push_back(entry);
  }
  for (int c = 0; c < law::kComponents && step.new_of_nodes; ++c) {
    const std::string name = cases::force_name(c);
    if (of_nodes_.count(name) == 0 || stated.count(name) > 0) continue;
    loads_[static_cast<std::size_t>(c)] = 0.0;
    of_nodes_.erase(name);
    force.push_back(name + (step.at_once.value_or(!step.is_static) ? ": 0" : ": {to: 0}"));
  }
  of_nodes_.insert(stated.begin(), stated.end());
}

std::string CaseParts::changes_text(const Step& step, double begin, long increments) {
  std::string text;
  const FrictionChange* last = nullptr;
  for (const FrictionChange& change : step.changes) {
    if (!is_mine(change.target)) continue;
    if (last != nullptr) {
      notes_.push_back(fmt::format("*CHANGE FRICTION: twice in {} ({} and {}): the last one holds",
                                   step.name, deck_.place(last->where), deck_.place(change.where)));
    }
    last = &change;
  }
  if (last != nullptr) {
    const FrictionChange& change = *last;
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
    }
    if (!change.amplitude.empty()) {
      entries.push_back("amplitude: " + blend_text(step, change, begin));
    } else if (step.at_once.value_or(false) && increments > 1) {
      // A sudden change is complete at the end of the first increment.
      entries.push_back(fmt::format(
          "amplitude: {{columns: [weight, t], rows: [[0, 0], [1, {}], [1, {}]]}}",
          number_text(step.period / static_cast<double>(increments)), number_text(step.period)));
    }
    text += "    change_friction:\n";
    const std::vector<Friction>& frictions = connector_.behavior->frictions;
    for (std::size_t i = 0; i < frictions.size(); ++i) {
      std::vector<std::string> own = entries;
      if (const std::string stick = changed_stick(frictions[i], change); !stick.empty()) {
        own.push_back("stick: {" + stick + "}");
      }
      text += fmt::format("      {}: {{{}}}\n", friction_name(i), join(own));
    }
  }
  return text;
}

std::string CaseParts::changed_stick(const Friction& friction, const FrictionChange& change) {
  if (change.reset) return {};
  std::string stated = stick_text(std::nullopt, change.coefficient);
  if (!stated.empty() || friction.stick_stiffness || !friction.coefficient) return stated;
  // The program's default is a slip tolerance, whatever the friction before had.
  const auto has_own = [](const Coefficient& one) {
    return one.elastic_slip || one.slip_tolerance;
  };
  if (!changes_stick_) {
    changes_stick_ = std::ranges::any_of(model_.steps, [&](const Step& step) {
      return std::ranges::any_of(step.changes, [&](const FrictionChange& one) {
        return one.coefficient && has_own(*one.coefficient);
      });
    });
  }
  return has_own(*friction.coefficient) || *changes_stick_ ? "slip_tolerance: 0.0001" : "";
}

std::string CaseParts::blend_text(const Step& step, const FrictionChange& change, double begin) {
  Drive drive{
      .where = change.where, .magnitude = 1.0, .amplitude = change.amplitude, .is_load = true};
  const DriveProfile profile = profile_of(deck_, model_, step, drive, "weight", 0.0, 0.0, begin);
  if (profile.text == "{smooth_to: 1}") return "smooth";
  if (profile.text.empty() || profile.text.front() != '{') {
    pass(fmt::format("the amplitude of *CHANGE FRICTION ({}) is no table",
                     deck_.place(change.where)));
  }
  return profile.text;
}

}  // namespace slipbench::driver::abaqus
