// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <tuple>
#include <variant>

#include "driver/import/abaqus/case_parts.hpp"
#include "driver/import/abaqus/profile_text.hpp"

namespace slipbench::driver::abaqus {

std::string CaseParts::derived_text() {
  std::string text;
  for (const auto& [label, terms] : connector_.behavior->derived) {
    text += text.empty() ? "derived_components:\n" : "";
    text += "  " + name_of(label) + ":\n";
    for (const DerivedTerm& term : terms) {
      std::vector<std::string> components;
      std::vector<std::string> weights;
      for (const int c : term.components) {
        components.push_back(std::to_string(c));
        weights.push_back("weight" + std::to_string(c));
      }
      std::vector<std::string> entries;
      if (term.op != "NORM") {
        entries.emplace_back(term.op == "SUM" ? "operator: sum" : "operator: macauley_sum");
      }
      if (term.sign < 0) entries.emplace_back("sign: -1");
      entries.push_back("components: [" + join(components) + "]");
      if (!term.rows.empty()) {
        std::vector<std::string> independents;
        for (const int c : term.independents) {
          independents.push_back(motion_column(c, term.constitutive));
        }
        std::string list =
            table(weights, ambient_columns(independents, term.fields), term.rows, "");
        if (list.front() != '[' && list.front() != '{') list = "[" + list + "]";
        entries.push_back("weights: " + list);
      }
      text += fmt::format("    - {{{}}}   # line {}\n", join(entries), line_of(term.where));
    }
  }
  return text;
}

std::string CaseParts::coefficient_text(const std::optional<Coefficient>& coefficient) {
  if (!coefficient) return "0";
  const std::vector<Row>& rows = coefficient->rows;
  const auto at = [&](std::size_t row, std::size_t i) {
    return number_text(rows[row].size() > i ? rows[row][i].value_or(0.0) : 0.0);
  };
  switch (coefficient->kind) {
    case Coefficient::Kind::kDecay:
      return fmt::format("{{exponential_decay: {{static: {}, kinetic: {}, decay: {}}}}}", at(0, 0),
                         at(0, 1), at(0, 2));
    case Coefficient::Kind::kTestData:
      return fmt::format("{{exponential_test_data: {{mu1: {}, mu2: {}, rate2: {}{}}}}}", at(0, 0),
                         at(1, 0), at(1, 1),
                         rows.size() > 2 ? ", mu_inf: " + at(2, 0) : std::string());
    default:
      return table({"mu"}, ambient_columns({"slip_rate", "contact_force"}, coefficient->fields),
                   rows, "");
  }
}

std::string CaseParts::stick_text(const std::optional<double>& stiffness,
                                  const std::optional<Coefficient>& coefficient) {
  if (stiffness) return "stiffness: " + number_text(*stiffness);
  if (!coefficient) return {};
  if (coefficient->elastic_slip && *coefficient->elastic_slip > 0.0) {
    return "elastic_slip: " + number_text(*coefficient->elastic_slip);
  }
  if (coefficient->slip_tolerance && *coefficient->slip_tolerance > 0.0) {
    return "slip_tolerance: " + number_text(*coefficient->slip_tolerance);
  }
  return {};
}

std::string CaseParts::predefined_text(const Row& row) {
  std::vector<std::string> entries;
  std::size_t most = 0;
  if (!connection_.type) pass("its connection type has no predefined friction");
  std::visit(
      [&]<class Type>(const Type&) {
        if constexpr (law::HasPredefinedFriction<Type>) {
          std::apply(
              [&](const auto&... field) {
                [[maybe_unused]] const auto take = [&](const auto& one) {
                  // What the bench has beyond the deck's items stands behind them.
                  if (one.key == "hinge_factors" || one.key == "R_i") return;
                  const std::size_t i = most++;
                  if (i >= row.size() || row[i].value_or(0.0) == 0.0) {
                    if (one.required) pass(fmt::format("{} is missing", one.key));
                    return;
                  }
                  entries.push_back(fmt::format("{}: {}", one.key, number_text(*row[i])));
                };
                (take(field), ...);
              },
              Type::fields());
        } else {
          pass("its connection type has no predefined friction");
        }
      },
      *connection_.type);
  if (row.size() > most) pass(fmt::format("has {} items, {} are wanted", row.size(), most));
  return "{" + join(entries) + "}";
}

std::string CaseParts::potential_text(const Potential& potential) {
  std::vector<std::string> terms;
  for (const PotentialTerm& term : potential.terms) {
    std::vector<std::string> entries;
    if (const int* const component = std::get_if<int>(&term.of)) {
      entries.push_back("component: " + std::to_string(*component));
    } else {
      entries.push_back("derived: " + name_of(std::get<std::string>(term.of)));
    }
    if (term.scale != 1.0) entries.push_back("scale: " + number_text(term.scale));
    if (term.shift != 0.0) entries.push_back("shift: " + number_text(term.shift));
    if (term.use != "ABS") {
      entries.emplace_back(term.use == "NONE" ? "of: none" : "of: macauley");
    }
    if (term.exponent) entries.push_back("exponent: " + number_text(*term.exponent));
    if (term.sign < 0) entries.emplace_back("sign: -1");
    terms.push_back("{" + join(entries) + "}");
  }
  std::string text = "{";
  if (potential.maximum) text += "operator: max, ";
  if (!potential.maximum && potential.exponent != 2.0) {
    text += "exponent: " + number_text(potential.exponent) + ", ";
  }
  return text + "terms: [" + join(terms) + "]}";
}

/// The name of a definition in the case: its own, or friction1, ..
std::string CaseParts::friction_name(std::size_t index) const {
  const std::string_view name = connector_.behavior->frictions[index].name;
  return name.empty() ? fmt::format("friction{}", index + 1) : quoted(std::string(name));
}

std::string CaseParts::friction_text() {
  std::string text = "friction:\n";
  for (const Friction& friction : connector_.behavior->frictions) {
    const std::string where = "   # line " + line_of(friction.where) + "\n";
    if (friction.predefined) {
      text += "  - predefined: " + predefined_text(*friction.predefined) + where;
    } else if (friction.potential) {
      text += "  - potential: " + potential_text(*friction.potential) + where;
    } else if (friction.component) {
      text += fmt::format("  - component: {}", *friction.component) + where;
    } else {
      pass("its friction (" + deck_.place(friction.where) +
           ") is neither PREDEFINED nor has it a component or a potential");
    }
    if (!friction.name.empty()) text += "    name: " + quoted(std::string(friction.name)) + "\n";
    if (friction.contact_force) {
      const int* const component = std::get_if<int>(&*friction.contact_force);
      text += "    contact_force: " +
              (component != nullptr ? std::to_string(*component)
                                    : name_of(std::get<std::string>(*friction.contact_force))) +
              "\n";
    }
    if (!friction.rows.empty()) {
      std::vector<std::string> independents;
      for (const int c : friction.independents) {
        independents.push_back(motion_column(c, friction.constitutive));
      }
      independents.emplace_back("accumulated_slip");
      text += "    internal_contact_force: " +
              table({"F"}, ambient_columns(independents, friction.fields), friction.rows, "") +
              "\n";
    }
    if (!friction.coefficient) {
      notes_.push_back(
          fmt::format("*CONNECTOR FRICTION ({}) has no *FRICTION: its coefficient is 0",
                      deck_.place(friction.where)));
    }
    text += "    coefficient: " + coefficient_text(friction.coefficient) + "\n";
    const auto& coefficient = friction.coefficient;
    if (coefficient && coefficient->force_limit && *coefficient->force_limit > 0.0) {
      text += "    force_limit: " + number_text(*coefficient->force_limit) + "\n";
    }
    const std::string stick = stick_text(friction.stick_stiffness, coefficient);
    if (!stick.empty()) text += "    stick: {" + stick + "}\n";
  }
  return text;
}

}  // namespace slipbench::driver::abaqus
