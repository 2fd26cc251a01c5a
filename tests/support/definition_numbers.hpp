// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "law/definition/friction_definition.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::test {

/// One number of a definition that can be changed.
struct DefinitionNumber {
  std::string name;
  double value = 0.0;
  std::function<void(law::FrictionDefinition*, double)> set;

  law::FrictionDefinition at(law::FrictionDefinition definition, double x) const {
    set(&definition, x);
    return definition;
  }
};

/// All ordinates of a table that `table(definition)` gives.
template <class TableOf>
void list_ordinates(const std::string& name, const law::FrictionDefinition& definition,
                    TableOf table, std::vector<DefinitionNumber>* list) {
  law::FrictionDefinition copy = definition;
  const law::Table& rows = table(&copy).table();
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    list->push_back({name + "[" + std::to_string(r) + "]", rows.ordinate(r),
                     [table, r](law::FrictionDefinition* d, double x) {
                       table(d).table().set_ordinate(r, 0, x);
                     }});
  }
}

/// Every number of a definition to which exact derivatives are known.
inline std::vector<DefinitionNumber> numbers_of(const law::FrictionDefinition& definition) {
  using law::FrictionDefinition;
  std::vector<DefinitionNumber> list;
  list.push_back({"stick", definition.stick.value,
                  [](FrictionDefinition* d, double x) { d->stick.value = x; }});
  if (std::isfinite(definition.force_limit)) {
    list.push_back({"force limit", definition.force_limit,
                    [](FrictionDefinition* d, double x) { d->force_limit = x; }});
  }
  if (const double* number = std::get_if<double>(&definition.internal_contact_force)) {
    list.push_back({"internal contact force", *number,
                    [](FrictionDefinition* d, double x) { d->internal_contact_force = x; }});
  } else {
    list_ordinates(
        "internal contact force", definition,
        [](FrictionDefinition* d) -> law::TableFunction& {
          return std::get<law::TableFunction>(d->internal_contact_force);
        },
        &list);
  }
  if (std::holds_alternative<law::TabularCoefficient>(definition.law)) {
    list_ordinates(
        "coefficient", definition,
        [](FrictionDefinition* d) -> law::TableFunction& {
          return std::get<law::TabularCoefficient>(d->law).table;
        },
        &list);
  }
  visit_law(
      [&]<class Law>(const Law& law) {
        if constexpr (!std::is_same_v<Law, law::TabularCoefficient>) {
          const auto one = [&](const auto& field) {
            const auto member = field.member;
            using Member = std::remove_cvref_t<decltype(law.*member)>;
            constexpr bool kIsNumber =
                std::is_same_v<Member, double> || std::is_same_v<Member, std::optional<double>>;
            if constexpr (kIsNumber) {
              const std::optional<double> value = law.*member;
              if (!value) return;
              list.push_back(
                  {std::string(field.key), *value, [member](FrictionDefinition* d, double x) {
                     get_law_if<Law>(d->law)->*member = x;
                   }});
            }
          };
          std::apply([&](const auto&... field) { (one(field), ...); }, Law::fields());
        }
      },
      definition.law);
  if (const auto* terms = std::get_if<law::DerivedComponent>(&definition.contact_force)) {
    for (std::size_t t = 0; t < terms->size(); ++t) {
      if ((*terms)[t].weight_table) continue;
      for (std::size_t j = 0; j < static_cast<std::size_t>((*terms)[t].count); ++j) {
        list.push_back({"weight", (*terms)[t].weight[j], [t, j](FrictionDefinition* d, double x) {
                          std::get<law::DerivedComponent>(d->contact_force)[t].weight[j] = x;
                        }});
      }
    }
  }
  return list;
}

}  // namespace slipbench::test
