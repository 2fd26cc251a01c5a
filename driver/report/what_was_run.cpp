// SPDX-License-Identifier: Apache-2.0
#include "driver/report/what_was_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/keys/law_numbers.hpp"
#include "driver/results/coverage.hpp"
#include "driver/results/normal_shares.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::report {
namespace {

constexpr std::size_t kMostRowsOfTable = 200;

std::string digits(double value) { return fmt::format("{:.10g}", value); }

template <class... Cases>
struct Match : Cases... {
  using Cases::operator()...;
};
// clang 14 needs to be told.
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

std::string arguments_of(const law::TableFunction& function) {
  std::vector<std::string> names;
  for (const law::Independent& one : function.independents())
    names.push_back(results::independent_name(one));
  return fmt::format("a table over {}", fmt::join(names, ", "));
}

TextTable table_of(const std::string& title, const std::string& value,
                   const law::TableFunction& function) {
  const law::Table& table = function.table();
  const bool held = table.extrapolation() == law::Extrapolation::kConstant;
  TextTable told{title + (held ? ", held at its ends" : ", prolonged at its ends"), {}, {}, 0};
  for (int k = 0; k < table.dependents(); ++k) {
    told.head.push_back(table.dependents() == 1 ? value : fmt::format("{} {}", value, k + 1));
  }
  for (const law::Independent& one : function.independents()) {
    told.head.push_back(results::independent_name(one));
  }
  const std::size_t rows = std::min(table.rows(), kMostRowsOfTable);
  told.left_out = table.rows() - rows;
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<std::string> cells;
    cells.reserve(told.head.size());
    for (int k = 0; k < table.dependents(); ++k) cells.push_back(digits(table.ordinate(row, k)));
    for (const double x : table.point(row)) cells.push_back(digits(x));
    told.rows.push_back(std::move(cells));
  }
  return told;
}

/// A coefficient law: its title, its formula and its numbers.
std::string law_words(const law::FrictionLaw& law) {
  return law::visit_law(
      [](const auto& one) -> std::string {
        using Law = std::remove_cvref_t<decltype(one)>;
        if constexpr (std::is_same_v<Law, law::TabularCoefficient>) {
          return arguments_of(one.table);
        } else if constexpr (std::is_same_v<Law, law::ConstantCoefficient>) {
          return "constant, " + digits(one.mu);
        } else {
          return fmt::format("{}: {}; {}", Law::kTitle, Law::kFormula, read::numbers(one));
        }
      },
      law);
}

std::string contact_words(const law::ContactForce& contact) {
  return std::visit(
      Match{[](const law::ComponentContactForce& one) { return cases::force_name(one.component); },
            [](const law::DerivedComponent& terms) {
              std::vector<std::string> words;
              for (const law::DerivedTerm& term : terms) words.push_back(results::term_words(term));
              return fmt::format("{}", fmt::join(words, " + "));
            },
            [](const law::UniversalJointContact& joint) {
              return fmt::format("two hinges on axis {}", joint.axis);
            },
            [](const law::NoContactForce&) { return std::string("none"); }},
      contact);
}

class Teller {
 public:
  explicit Teller(const cases::Case& problem) : problem_(problem) {}

  WhatWasRun tell() && {
    connection();
    for (const cases::CaseDefinition& definition : problem_.definitions) friction(definition);
    forces();
    history();
    return std::move(run_);
  }

 private:
  void fact(std::string name, std::string words) {
    if (!words.empty()) run_.facts.emplace_back(std::move(name), std::move(words));
  }
  void table(const std::string& title, const std::string& value,
             const law::TableFunction& function) {
    run_.tables.push_back(table_of(title, value, function));
  }

  void connection() {
    const law::ConnectionInfo& info = problem_.connection.info;
    std::vector<std::string> free;
    for (int c = 0; c < law::kComponents; ++c) {
      if (info.available.contains(c)) free.push_back(cases::motion_name(c));
    }
    fact("connection", fmt::format("{}, free: {}", info.name, fmt::join(free, ", ")));
    if (problem_.pair) {
      fact("part pair", fmt::format("{} and {}: {}", problem_.pair->parts[0],
                                    problem_.pair->parts[1], problem_.pair->record()));
    }
  }

  void law(const std::string& name, const std::string& what, const law::FrictionLaw& law) {
    fact(fmt::format("{}: {}", name, what), law_words(law));
    if (const auto* tabular = std::get_if<law::TabularCoefficient>(&law)) {
      table(name + ": " + what, "mu", tabular->table);
    }
  }

  void friction(const cases::CaseDefinition& definition) {
    const law::FrictionDefinition& one = definition.law;
    const std::string& name = definition.name;
    const bool two = one.formulation && one.formulation->orthotropy;
    law(name,
        definition.backward ? "coefficient forward"
        : two               ? "coefficient along 1"
                            : "coefficient",
        one.law);
    if (definition.backward) law(name, "coefficient backward", *definition.backward);
    if (two) law(name, "coefficient along 2", one.formulation->orthotropy->second);
    std::vector<std::string> along;
    for (int k = 0; k < one.slip.dimension; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double scale = one.slip.scale[i];
      along.push_back(cases::motion_name(one.slip.component[i]) +
                      (scale == 1.0 ? "" : fmt::format(" on radius {}", digits(scale))));
    }
    fact(name + ": acts along", fmt::format("{}", fmt::join(along, ", ")));
    if (!problem_.belt) fact(name + ": contact force", contact_words(one.contact_force));
    if (const auto* inside = std::get_if<law::TableFunction>(&one.internal_contact_force)) {
      fact(name + ": internal contact force", arguments_of(*inside));
      table(name + ": internal contact force", "force", *inside);
    } else if (const double number = std::get<double>(one.internal_contact_force); number != 0.0) {
      fact(name + ": internal contact force", digits(number));
    }
    if (one.force_limit < law::kNoForceLimit) fact(name + ": force limit", digits(one.force_limit));
    if (one.formulation) {
      fact(name + ": stick", "a contact penalty in place of stick");
    } else {
      const bool elastic = one.stick.mode == law::StickStiffness::Mode::kElasticSlip;
      fact(name + ": stick",
           fmt::format("{} {}", elastic ? "elastic slip" : "stiffness", digits(one.stick.value)));
    }
    if (definition.dead_zone) fact(name + ": dead zone", digits(definition.dead_zone->width));
  }

  void forces() {
    std::vector<std::string> words;
    for (int c = 0; c < law::kComponents; ++c) {
      const law::KineticBehavior& kinetic = problem_.kinetic;
      const bool stopped = problem_.stop[static_cast<std::size_t>(c)].has_value();
      for (const auto& [there, word] :
           {std::pair{kinetic.is_elastic(c), "elasticity"},
            std::pair{kinetic.is_damped(c), "damping"}, std::pair{stopped, "stop"}}) {
        if (there) words.push_back(fmt::format("{} along {}", word, cases::motion_name(c)));
      }
    }
    fact("beside friction", fmt::format("{}", fmt::join(words, ", ")));
    if (const auto& mass = problem_.dynamics) {
      fact("dynamics", fmt::format("mass {} along {}, {}", digits(mass->mass),
                                   cases::motion_name(mass->component),
                                   mass->driver ? "driver of mass " + digits(mass->driver->mass)
                                                : "belt velocity " + digits(mass->belt_velocity)));
    }
  }

  void history() {
    if (problem_.measured) {
      std::vector<std::string> names;
      fact("history",
           fmt::format(
               "the rows of {}",
               std::filesystem::path(problem_.measured->data.shown_name).filename().string()));
      return;
    }
    TextTable told{"History", {"Step", "Duration", "Increments", "Prescribed"}, {}, 0};
    const bool repeats = std::any_of(problem_.steps.begin(), problem_.steps.end(),
                                     [](const cases::Step& step) { return step.repeat > 1; });
    if (repeats) told.head.insert(told.head.end() - 1, "Times");
    for (const cases::Step& step : problem_.steps) {
      std::vector<std::string> drives;
      for (const cases::Drive& drive : step.drives) {
        drives.push_back(cases::quantity_name(drive.quantity) + " " + profile_words(drive.profile));
      }
      if (!step.friction_changes.empty()) drives.emplace_back("friction changes");
      std::vector<std::string> cells{step.name, digits(step.duration),
                                     std::to_string(step.increments)};
      if (repeats) cells.push_back(std::to_string(step.repeat));
      cells.push_back(drives.empty() ? "all stays" : fmt::format("{}", fmt::join(drives, "; ")));
      told.rows.push_back(std::move(cells));
    }
    run_.tables.push_back(std::move(told));
  }

  static std::string profile_words(const history::Profile& profile) {
    return std::visit(
        Match{[](const history::Constant& one) { return digits(one.value); },
              [](const history::LinearTo& one) { return "to " + digits(one.value); },
              [](const history::SmoothTo& one) { return "smoothly to " + digits(one.value); },
              [](const history::Wave& one) {
                constexpr std::array<std::string_view, 4> kShapes{"sine", "triangle", "sawtooth",
                                                                  "square"};
                std::string text = fmt::format("{} of amplitude {} and period {}",
                                               kShapes[static_cast<std::size_t>(one.shape)],
                                               digits(one.amplitude), digits(one.period));
                if (one.mean != 0.0) text += " about " + digits(one.mean);
                if (one.phase != 0.0) text += fmt::format(", phase {} rad", digits(one.phase));
                return text;
              },
              [](const history::Tabular& one) {
                return fmt::format("by {} points", one.times.size());
              },
              [](const history::CsvColumn& one) {
                return fmt::format("by column {} of {}", one.value_column,
                                   std::filesystem::path(one.data.shown_name).filename().string());
              },
              [](const history::ExpressionProfile& one) { return "= " + one.expression.text(); },
              [](const history::PositionFormula& one) { return "= " + one.expression.text(); }},
        profile);
  }

  const cases::Case& problem_;
  WhatWasRun run_;
};

}  // namespace

WhatWasRun what_was_run(const cases::Case& problem) { return Teller(problem).tell(); }

}  // namespace slipbench::driver::report
