// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/case_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/case/quantity.hpp"
#include "driver/import/abaqus/case_parts.hpp"
#include "driver/import/abaqus/profile_text.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::abaqus {

WrittenCase CaseParts::write() {
  find_connection();
  const Behavior& behavior = *connector_.behavior;
  if (!behavior.not_taken.empty()) {
    throw PassedOver{"its behaviour has " + join(behavior.not_taken) +
                     ", which the bench does not model"};
  }
  // Which constraint forces matter, the case itself knows.
  forces_ = connection_.info.held;
  const std::string draft = text();
  const cases::Case problem = resolved(draft);
  forces_ = used_forces(problem);
  WrittenCase written{.text = text(), .asked = asked_};
  const cases::Case made = resolved(written.text);
  const auto kept = [&](std::size_t count, const char* what) {
    if (count == 0) return;
    written.losses.push_back(
        {import::Loss::Kind::kKept, fmt::format("{} {}{}", count, what, count == 1 ? "" : "s")});
  };
  kept(behavior.frictions.size(), "friction definition");
  std::size_t beside = 0;
  for (int c = 0; c < law::kComponents; ++c) {
    beside += cases::acts_beside_friction(made, c) ? 1U : 0U;
  }
  kept(beside, "component with springs, dampers or stops");
  kept(model_.steps.size(), "step");
  for (std::string& note : notes_) {
    written.losses.push_back({import::Loss::Kind::kApproximated, std::move(note)});
  }
  return written;
}

void CaseParts::find_connection() {
  const std::vector<std::string>& types = connector_.types;
  const int dimension = connector_.plane ? 2 : 3;
  const auto named = [&](const std::string& type) {
    const auto found = law::find_connection(type, dimension);
    if (const auto why = read::later_key(type); !found && why) pass(std::string(why->why));
    if (!found)
      pass(fmt::format("the bench has no connection type {}{}", type,
                       connector_.plane ? " in the plane" : ""));
    return *found;
  };
  if (types.empty() || types.size() > 2) pass("it has not one connection type, or two basic ones");
  connection_ = named(types[0]);
  if (types.size() == 2) {
    const auto pair = law::assemble(connection_, named(types[1]));
    if (!pair) pass(fmt::format("{} and {} make no connection", types[0], types[1]));
    connection_ = *pair;
  }
  belt_ = cases::is_belt(connection_);
}

cases::Case CaseParts::resolved(const std::string& text) const {
  read::ReadOptions options;
  options.allow_outside = true;
  for (const std::string& name : asked_) options.overrides.push_back({name, 1.0});
  const read::ReadCase read =
      read::read_case_text(base::SourceText("case", text), options_.folder, options);
  if (read.value) return *read.value;
  for (const base::Diagnostic& one : read.diagnostics.sorted()) {
    if (one.severity != base::Severity::kError) continue;
    pass(one.path + (one.path.empty() ? "" : ": ") + one.message);
  }
  pass("no case can be made of it");
}

law::ComponentSet CaseParts::used_forces(const cases::Case& problem) {
  law::ComponentSet used;
  for (const cases::CaseDefinition& definition : problem.definitions) {
    used = used | law::components_of(definition.law.contact_force);
  }
  return used & problem.connection.info.held;
}

std::string CaseParts::text() {
  asked_.clear();
  asked_why_.clear();
  notes_.clear();
  const std::string connector = connector_text();
  const std::string derived = derived_text();
  const std::string friction = friction_text();
  const std::string springs = springs_text();
  const std::string history = history_text();
  if (options_.characters != nullptr) {
    *options_.characters += derived.size() + friction.size() + springs.size();
  }
  std::string all = fmt::format("# {}\n# of {}, written by slipbench import.\n",
                                described(connector_), base::printable(options_.deck));
  if (!asked_.empty()) {
    all +=
        "# The deck has no values for the parameters below: give each one here, or with --set.\n";
  }
  for (const std::string& note : notes_) all += "# " + base::printable(note) + "\n";
  const std::string& name = connector_.behavior->name;
  all += "slipbench: 1\ntitle: " +
         quoted(fmt::format("{}, element {}", shown(name), connector_.name)) + "\n";
  if (!options_.units.empty()) all += "units: {" + options_.units + "}\n";
  if (!asked_.empty()) {
    all += "parameters:\n";
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      all += fmt::format("  {}:   # {}\n", asked_[i], asked_why_[i]);
    }
  }
  return all + connector + derived + friction + springs + history;
}

std::string CaseParts::connector_text() {
  std::string text = "connector:\n  type: ";
  if (connector_.types.size() == 1) {
    text += connector_.types[0] + "\n";
  } else {
    text += fmt::format("[{}, {}]\n", connector_.types[0], connector_.types[1]);
  }
  if (connector_.plane) text += "  dimension: 2\n";
  std::vector<std::string> initial;
  std::vector<std::string> reference;
  const auto& given = connector_.behavior->reference;
  for (int c = 0; c < law::kComponents; ++c) {
    const auto i = static_cast<std::size_t>(c);
    initial_[i] = belt_ ? (c == 0 ? distance() : 0.0) : position(c);
    const bool free = connection_.info.available.contains(c);
    if (free && initial_[i] != 0.0) {
      initial.push_back(cases::motion_name(c) + ": " + number_text(initial_[i]));
    }
    if (!given[i]) continue;
    if (belt_) {
      if (c == 0) text += "  initial_strain: " + number_text(*given[i]) + "\n";
      continue;
    }
    const double value = law::is_rotation(c) ? *given[i] * std::numbers::pi / 180.0 : *given[i];
    if (free) reference.push_back(cases::motion_name(c) + ": " + number_text(value));
  }
  if (connector_.turned && !(connection_.info.available & law::ComponentSet::of(4, 5, 6)).empty()) {
    notes_.emplace_back(
        "the axes of node b are turned against those of a: positions of rotations begin at 0 "
        "here");
  }
  const law::ComponentSet moving = connection_.info.available & law::ComponentSet::of(1, 2, 3);
  if (!connector_.position && (belt_ || !moving.empty())) {
    notes_.emplace_back(
        "the places of its nodes, or its axes, are not known: positions begin at 0 here");
  }
  if (belt_) {
    text +=
        "  wrap_angle: " +
        (connector_.number_of_type
             ? number_text(*connector_.number_of_type)
             : quoted(ask("wrap_angle", "angle that the belt turns by on its ring, in radians"))) +
        "\n";
  }
  if (!initial.empty()) text += "  initial: {" + join(initial) + "}\n";
  if (!reference.empty()) text += "  reference: {" + join(reference) + "}\n";
  return text;
}

double CaseParts::distance() const {
  if (!connector_.position) return 0.0;
  const Point& p = *connector_.position;
  return std::hypot(p[0], p[1], p[2]);
}

double CaseParts::position(int component) const {
  if (!connector_.position || law::is_rotation(component)) return 0.0;
  return (*connector_.position)[static_cast<std::size_t>(component)];
}

std::string described(const Connector& connector) {
  std::string types;
  for (const std::string& type : connector.types) types += (types.empty() ? "" : " + ") + type;
  std::string text = types;
  if (connector.behavior != nullptr)
    text += fmt::format(" \"{}\"", shown(connector.behavior->name));
  text += fmt::format(", element {}", connector.name);
  if (!connector.set.empty()) text += " of " + connector.set;
  return base::printable(text);
}

tl::expected<WrittenCase, std::string> write_case(const KeywordDeck& deck, const Model& model,
                                                  const Connector& connector,
                                                  const CaseOptions& options) {
  try {
    return CaseParts(deck, model, connector, options).write();
  } catch (const PassedOver& passed) {
    return tl::unexpected(passed.reason);
  }
}

}  // namespace slipbench::driver::abaqus
