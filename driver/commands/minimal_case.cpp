// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/minimal_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <type_traits>

#include "driver/base/text/diagnostic.hpp"
#include "driver/case/quantity.hpp"
#include "driver/results/columns.hpp"
#include "driver/yaml/binding.hpp"
#include "law/connection/connection_type.hpp"
#include "reference/catalogue.hpp"

namespace slipbench::driver::commands {
namespace {

/// One check of friction: the column of its contact force, and the closed form of it.
struct Pressing {
  std::string quantity = "FN";
  const reference::ClosedForm* form = nullptr;
};

/// The checks of a type's predefined friction. A closed form is called after the type and its
/// check: contact_force_slide_plane, contact_force_ujoint_1 of "axis1".
template <class Type>
std::vector<Pressing> pressing_of() {
  std::string stem = "contact_force_" + std::string(Type::kInfo.name);
  std::transform(stem.begin(), stem.end(), stem.begin(), [](unsigned char c) {
    return c == '-' ? '_' : static_cast<char>(std::tolower(c));
  });
  std::vector<Pressing> all;
  for (const law::PredefinedFriction& check : Type{}.predefined()) {
    std::string_view suffix = check.suffix;
    Pressing one;
    if (!suffix.empty()) one.quantity += "." + std::string(suffix);
    if (suffix.starts_with("axis")) suffix.remove_prefix(4);
    one.form = reference::find(suffix.empty() ? stem : stem + "_" + std::string(suffix));
    all.push_back(one);
  }
  return all;
}

/// The names of components in a set, 0..5.
std::vector<int> components_of(law::ComponentSet set) {
  std::vector<int> components;
  for (int c = 0; c < law::kComponents; ++c) {
    if (set.contains(c)) components.push_back(c);
  }
  return components;
}

std::string force_name(int component) {
  return fmt::format("{}{}", law::is_rotation(component) ? 'm' : 'f', component % 3 + 1);
}

std::string motion_name(int component) {
  return fmt::format("{}{}", law::is_rotation(component) ? "CPR" : "CP", component % 3 + 1);
}

/// "{a: 1, b: 2}"
std::string flow_map(const std::vector<std::string>& entries) {
  return fmt::format("{{{}}}", fmt::join(entries, ", "));
}

/// A length of the geometry in mm: radii are small against lengths, and a puck has no hole.
double length_of(std::string_view key) {
  if (key == "R_i") return 0.0;
  return key.starts_with('R') ? 5.0 : 30.0;
}

/// The parts of a case that differ from type to type.
struct Parts {
  std::string type;        ///< as the connector has it
  std::string parameters;  ///< lines
  std::string connector;   ///< further keys of it
  std::string derived;     ///< lines of derived_components
  std::string friction;    ///< what is rubbed, within the braces or lines of a definition
  std::vector<std::string> forces;
  std::string slip_unit;  ///< ", in radians" and the like, behind what its elastic travel is
  int moving = 0;         ///< the component that is moved to and fro
  std::string checks;
};

std::string contact_check(const std::string& quantity, const std::string& against) {
  return fmt::format(
      "  - name: contact force{}\n"
      "    quantity: {}\n"
      "    against: {}\n"
      "    tolerance: {{relative: 1.0e-9, why: the same formula evaluated twice}}\n",
      quantity == "FN" ? "" : ", " + quantity.substr(3), quantity, against);
}

/// "{closed_form: contact_force_slot, inputs: {f2: CRF2, f3: CRF3}}"
std::string against_form(const reference::ClosedForm& form, const std::vector<std::string>& given) {
  std::vector<std::string> with;
  for (const reference::Parameter& parameter : form.parameters) {
    if (std::find(given.begin(), given.end(), parameter.name) != given.end()) {
      with.push_back(fmt::format("{0}: = {0}", parameter.name));
    }
  }
  std::vector<std::string> inputs;
  for (const reference::Signal& input : form.inputs) {
    if (const auto c = cases::component_of_force(input.name)) {
      inputs.push_back(fmt::format("{}: {}", input.name, cases::force_column("CRF", *c)));
    } else if (input.name == "alpha") {
      inputs.emplace_back("alpha: CPR1");
    }
  }
  std::string text = fmt::format("{{closed_form: {}", form.name);
  if (!with.empty()) text += ", with: " + flow_map(with);
  return text + ", inputs: " + flow_map(inputs) + "}";
}

/// A type with predefined friction.
template <class Type>
Parts predefined_parts() {
  Parts parts;
  parts.type = Type::kInfo.name;
  std::vector<std::string> geometry;
  std::vector<std::string> given;
  yaml::for_each_key<Type>([&](std::string_view key, auto member, const yaml::KeyInfo& info) {
    using Member = std::remove_cvref_t<decltype(std::declval<Type&>().*member)>;
    if constexpr (std::is_same_v<Member, double>) {
      parts.parameters +=
          fmt::format("  {:<12} # {}\n", fmt::format("{}: {}", key, length_of(key)), info.text);
      geometry.push_back(fmt::format("{0}: = {0}", key));
      given.emplace_back(key);
    }
  });
  parts.friction = "predefined: " + flow_map(geometry);
  const auto checks = Type{}.predefined();
  parts.moving = checks.front().slip.component.front();
  if (law::is_rotational(checks.front().slip) != law::is_rotational(checks.back().slip)) {
    parts.slip_unit = ", in mm and in radians: a warning says so";
  }
  for (const int c : components_of(Type::kInfo.held)) {
    parts.forces.push_back(
        fmt::format("{}: {{to: {}}}", force_name(c), law::is_rotation(c) ? 500 : 100));
  }
  for (const Pressing& one : pressing_of<Type>()) {
    if (one.form) parts.checks += contact_check(one.quantity, against_form(*one.form, given));
  }
  if constexpr (std::is_same_v<Type, law::SlipRing>) {
    parts.connector = ", wrap_angle: = pi";
    parts.forces = {"f1: {columns: [value, t], rows: [[100, 0], [200, 1]]}"};
    parts.checks = contact_check("FN", "{expression: \"= CTF1\"}");
  } else if constexpr (std::is_same_v<Type, law::Contact>) {
    parts.checks = contact_check("FN", "{expression: \"= max(CRF1, 0)\"}");
  }
  return parts;
}

/// A building block: what presses on its first free component is named, held forces as far as
/// there are any.
Parts basic_parts(const law::ConnectionInfo& info) {
  Parts parts;
  parts.type = info.name;
  std::vector<int> free = components_of(info.available);
  const std::vector<int> held = components_of(info.held);
  if (free.empty()) {
    const bool holds_rotations = law::is_rotation(held.front());
    parts.type = fmt::format("[{}, {}]", info.name, holds_rotations ? "CARTESIAN" : "CARDAN");
    free = {holds_rotations ? 0 : 3};
  }
  parts.moving = free.front();
  parts.friction = fmt::format("component: {}", parts.moving + 1);
  if (held.empty()) {
    parts.friction += "\n    internal_contact_force: 100  # nothing is held that could press";
    parts.checks = contact_check("FN", "{expression: \"= 100\"}");
    return parts;
  }
  std::vector<std::string> numbers;
  std::vector<std::string> weights;
  std::vector<std::string> squares;
  // A radius turns held forces into the moment that presses on a rotation, and the other way round.
  const bool same_kind = law::is_rotation(held.front()) == law::is_rotation(parts.moving);
  const double weight = same_kind ? 1.0 : (law::is_rotation(parts.moving) ? 5.0 : 0.2);
  for (const int c : held) {
    parts.forces.push_back(
        fmt::format("{}: {{to: {}}}", force_name(c), law::is_rotation(c) ? 500 : 100));
    numbers.push_back(std::to_string(c + 1));
    weights.push_back(fmt::format("{}", weight));
    squares.push_back(fmt::format("{}^2", cases::force_column("CRF", c)));
  }
  parts.derived = fmt::format(
      "derived_components:\n"
      "  pressing:\n"
      "    - {{operator: norm, components: [{}], weights: [{}]}}\n",
      fmt::join(numbers, ", "), fmt::join(weights, ", "));
  parts.friction += "\n    contact_force: pressing";
  parts.checks = contact_check(
      "FN", fmt::format("{{expression: \"= {}*sqrt({})\"}}", weight, fmt::join(squares, " + ")));
  return parts;
}

std::string text_of(const law::ConnectionInfo& info, const Parts& parts) {
  const bool turns = law::is_rotation(parts.moving);
  const std::string slip_unit = parts.slip_unit.empty() && turns ? ", in radians" : parts.slip_unit;
  std::string text = fmt::format("# {}: {}\n", info.name, info.text);
  std::string_view sketch = connection_sketch(info.name);
  while (!sketch.empty()) {
    const std::size_t end = sketch.find('\n');
    text += fmt::format("#   {}\n", sketch.substr(0, end));
    sketch.remove_prefix(end + 1);
  }
  text += fmt::format(
      "slipbench: 1\n"
      "title: Minimal case of {}\n"
      "units: {{length: mm, force: N, time: s}}  # angles are radians\n"
      "parameters:\n"
      "  {:<12} # coefficient of friction\n"
      "{}"
      "connector: {{type: {}{}}}\n"
      "{}"
      "friction:\n"
      "  - {}\n"
      "    coefficient: = mu\n"
      "    stick: {{elastic_slip: 0.001}}  # elastic travel before it slips{}\n"
      "history:\n",
      info.name, "mu: 0.2", parts.parameters, parts.type, parts.connector, parts.derived,
      parts.friction, slip_unit);
  if (!parts.forces.empty()) {
    text +=
        fmt::format("  - step: press\n    increments: 10\n    force: {}\n", flow_map(parts.forces));
  }
  return text + fmt::format(
                    "  - step: rub  # to and fro, one cycle in one second\n"
                    "    increments: 200\n"
                    "    motion: {{{}: {{sine: {{amplitude: {}, frequency: 1}}}}}}\n"
                    "checks:\n"
                    "{}",
                    motion_name(parts.moving), turns ? 0.1 : 1.0, parts.checks);
}

}  // namespace

std::string minimal_case(std::string_view type) {
  std::string text;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if (Type::kInfo.name != type) return;
    if constexpr (law::HasPredefinedFriction<Type>) {
      text = text_of(Type::kInfo, predefined_parts<Type>());
    } else {
      text = text_of(Type::kInfo, basic_parts(Type::kInfo));
    }
  });
  return text;
}

std::string contact_force_formulas(std::string_view type) {
  std::string text;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if (Type::kInfo.name != type) return;
    if constexpr (std::is_same_v<Type, law::SlipRing>) {
      text = fmt::format(
          "F_N = T, the tension that the ring meets; with the wrap angle alpha it slips at\n{}\n",
          reference::find("capstan")->formula);
    } else if constexpr (std::is_same_v<Type, law::Contact>) {
      text = "F_N = max(f1, 0)\n";
    } else if constexpr (law::HasPredefinedFriction<Type>) {
      for (const Pressing& one : pressing_of<Type>()) {
        text += fmt::format("{}\n", one.form->formula);
      }
    } else {
      text = "F_N = |g + F_int|, g what 'contact_force' names, F_int 'internal_contact_force'\n";
    }
  });
  return text;
}

}  // namespace slipbench::driver::commands
