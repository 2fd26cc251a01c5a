// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "driver/base/text/format_number.hpp"
#include "driver/case/quantity.hpp"
#include "driver/read/resolve/resolve.hpp"

namespace slipbench::driver::read {
namespace {

bool driven(const cases::Case& problem, int quantity) {
  if (problem.measured) {
    return std::any_of(problem.measured->columns.begin(), problem.measured->columns.end(),
                       [&](const history::MeasuredColumn& column) {
                         return column.quantity == static_cast<std::size_t>(quantity);
                       });
  }
  return std::any_of(problem.steps.begin(), problem.steps.end(), [&](const cases::Step& step) {
    return std::any_of(step.drives.begin(), step.drives.end(),
                       [&](const cases::Drive& drive) { return drive.quantity == quantity; });
  });
}

/// Calls visit for every independent of a coefficient table.
template <class Visit>
void for_each_independent(const law::FrictionLaw& law, Visit visit) {
  const auto* table = std::get_if<law::TabularCoefficient>(&law);
  if (table == nullptr) return;
  for (const law::Independent& independent : table->table.independents()) visit(independent);
}

/// Calls visit for every independent of every table of a definition.
template <class Visit>
void for_each_independent(const law::FrictionDefinition& definition, Visit visit) {
  const auto table = [&](const law::TableFunction& function) {
    for (const law::Independent& independent : function.independents()) visit(independent);
  };
  if (const auto* f = std::get_if<law::TableFunction>(&definition.internal_contact_force))
    table(*f);
  for_each_independent(definition.law, visit);
  if (const auto* g = std::get_if<law::DerivedComponent>(&definition.contact_force)) {
    for (const law::DerivedTerm& term : *g) {
      if (term.weight_table) table(*term.weight_table);
    }
  }
}

}  // namespace

void explain_table_arguments(yaml::Binder& binder, const CaseText& text,
                             const cases::Case& problem) {
  std::vector<law::Independent> told;  // once a case is enough
  const auto explain = [&](const law::Independent& independent) {
    if (std::find(told.begin(), told.end(), independent) != told.end()) return;
    told.push_back(independent);
    const int c = independent.index;
    using Kind = law::IndependentKind;
    const bool is_field = independent.kind == Kind::kField;
    if (independent.kind == Kind::kTemperature || is_field) {
      const int quantity = is_field ? cases::kFirstField + c : cases::kTemperatureQuantity;
      if (driven(problem, quantity)) return;
      binder.warning(*text.friction.node, text.friction.path,
                     "a table depends on " + cases::quantity_name(quantity) +
                         ", which the history never gives: it is 0");
    } else if (independent.kind == Kind::kConstitutiveMotion &&
               problem.reference[c] != problem.initial[c]) {
      binder.note(*text.friction.node, text.friction.path,
                  "a table over CU" + cases::component_suffix(c) +
                      " sees the constitutive motion " + cases::motion_name(c) + " - " +
                      base::format_number(problem.reference[c]) + " (result column CCU" +
                      cases::component_suffix(c) +
                      "), not the displacement from the initial position");
    }
  };
  for (const cases::CaseDefinition& definition : problem.definitions) {
    for_each_independent(definition.law, explain);
    if (definition.backward) for_each_independent(*definition.backward, explain);
  }
  for (const cases::Step& step : problem.steps) {
    for (const cases::FrictionChange& change : step.friction_changes) {
      for_each_independent(change.law, explain);
    }
  }
}

}  // namespace slipbench::driver::read
