// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/export/abaqus/deck_parts.hpp"
#include "driver/export/coefficient_grid.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::exports {
namespace {

using law::Independent;
using law::IndependentKind;

/// Temperature and fields, behind the first columns of a table.
std::vector<Independent> with_ambient(std::vector<Independent> first, int fields) {
  first.push_back({IndependentKind::kTemperature, 0});
  for (int i = 0; i < fields; ++i) first.push_back({IndependentKind::kField, i});
  return first;
}

bool is_motion(const Independent& one) {
  return one.kind == IndependentKind::kPosition || one.kind == IndependentKind::kConstitutiveMotion;
}

/// The motions that a table sees, in its order.
std::vector<Independent> motions_of(const law::TableFunction& table) {
  std::vector<Independent> motions;
  for (const Independent& one : table.independents()) {
    if (is_motion(one)) motions.push_back(one);
  }
  return motions;
}

/// "INDEPENDENT COMPONENTS=.." and the line of their numbers, where there are some.
std::pair<std::string, std::string> independent_components(
    const std::vector<Independent>& motions) {
  if (motions.empty()) return {};
  const bool constitutive = motions.front().kind == IndependentKind::kConstitutiveMotion;
  std::vector<std::string> numbers;
  for (const Independent& one : motions) {
    if ((one.kind == IndependentKind::kConstitutiveMotion) != constitutive) {
      throw NotExported{"a table over positions and constitutive motions at once is not in Abaqus"};
    }
    numbers.push_back(std::to_string(one.index + 1));
  }
  return {std::string(", INDEPENDENT COMPONENTS=") +
              (constitutive ? "CONSTITUTIVE MOTION" : "POSITION"),
          data_lines(numbers)};
}

/// A comment in the manner of Abaqus/CAE, as a deck has no name for a friction.
std::string name_comment(const std::string& name) {
  return name.empty() ? std::string() : "** Name: " + base::printable(name) + "\n";
}

/// The stick stiffness; K_t of a stiffness penalty is one.
law::StickStiffness stick_of(const law::FrictionDefinition& definition) {
  if (!definition.formulation) return definition.stick;
  const auto* const spring = std::get_if<law::StiffnessPenalty>(&definition.formulation->penalty);
  if (spring == nullptr) return definition.stick;
  return {law::StickStiffness::Mode::kStiffness, spring->stiffness};
}

}  // namespace

int DeckParts::fields_of(const law::TableFunction& table) {
  int fields = 0;
  for (const Independent& one : table.independents()) {
    if (one.kind == IndependentKind::kField) fields = std::max(fields, one.index + 1);
  }
  return fields;
}

std::string DeckParts::dependencies(int fields) {
  return fields > 0 ? fmt::format(", DEPENDENCIES={}", fields) : std::string();
}

std::string DeckParts::rows(const law::TableFunction& function,
                            const std::vector<Independent>& columns) {
  const law::Table& table = function.table();
  const auto independents = function.independents();
  // Places of the table's independents among the columns; the first varies fastest in both.
  std::vector<std::size_t> place;
  for (const Independent& one : independents) {
    const auto found = std::find(columns.begin(), columns.end(), one);
    if (found == columns.end()) refuse("a table sees something that it cannot see in Abaqus");
    place.push_back(static_cast<std::size_t>(found - columns.begin()));
  }
  std::vector<std::size_t> order(table.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!std::is_sorted(place.begin(), place.end())) {
    std::size_t points = 1;
    for (int k = 0; k < table.independents(); ++k) points *= table.knots(k).size();
    if (points != table.rows()) {
      refuse("a ragged table whose columns stand in another order than those of Abaqus");
    }
    std::vector<std::size_t> by_place(place.size());
    std::iota(by_place.begin(), by_place.end(), std::size_t{0});
    std::sort(by_place.begin(), by_place.end(),
              [&](std::size_t a, std::size_t b) { return place[a] > place[b]; });
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const std::vector<double> left = table.point(a);
      const std::vector<double> right = table.point(b);
      for (const std::size_t k : by_place) {
        if (left[k] != right[k]) return left[k] < right[k];
      }
      return false;
    });
  }
  const auto dependents = static_cast<std::size_t>(table.dependents());
  std::string text;
  for (const std::size_t row : order) {
    std::vector<std::string> items(dependents + columns.size());
    for (std::size_t k = 0; k < dependents; ++k) {
      items[k] = numbers_(table.ordinate(row, static_cast<int>(k)));
    }
    const std::vector<double> point = table.point(row);
    for (std::size_t k = 0; k < place.size(); ++k)
      items[dependents + place[k]] = numbers_(point[k]);
    text += data_lines(items);
  }
  return text;
}

/// A behaviour has one extrapolation for all its tables but those of *FRICTION.
void DeckParts::take_extrapolation(const law::TableFunction& table) {
  const law::Extrapolation own = table.table().extrapolation();
  if (extrapolation_ && *extrapolation_ != own) {
    refuse("tables that are extrapolated in different ways are not in Abaqus");
  }
  extrapolation_ = own;
}

std::string DeckParts::behavior() {
  const std::string springs_text = springs();
  std::string frictions;
  std::set<std::size_t> written;
  for (const cases::CaseDefinition& one : problem_.definitions) {
    if (written.insert(one.entry).second) frictions += friction(one.entry);
  }
  std::string text = "*CONNECTOR BEHAVIOR, NAME=JOINT";
  if (extrapolation_ == law::Extrapolation::kLinear) text += ", EXTRAPOLATION=LINEAR";
  text += "\n";
  std::vector<std::string> reference;
  bool given = false;
  for (int c = 0; c < law::kComponents; ++c) {
    const bool own = problem_.reference[c] != problem_.initial[c] && !problem_.belt;
    given = given || own;
    const double value = law::is_rotation(c) ? problem_.reference[c] * 180.0 / std::numbers::pi
                                             : problem_.reference[c];
    reference.push_back(own ? numbers_(value) : std::string());
  }
  if (problem_.belt && problem_.belt->initial_strain != 0.0) {
    reference = {numbers_(problem_.belt->initial_strain)};
    given = true;
  }
  if (given) text += "*CONNECTOR CONSTITUTIVE REFERENCE\n" + data_lines(reference);
  return text + springs_text + frictions;
}

std::string DeckParts::springs() {
  std::string text;
  const law::KineticBehavior& kinetic = problem_.kinetic;
  for (int c = 0; c < law::kComponents; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const std::string component = fmt::format(", COMPONENT={}", c + 1);
    const auto table_text = [&](const law::TableFunction& table, const char* keyword,
                                Independent motion) {
      // The motion is the component's, whatever index it has in the table.
      for (const Independent& one : table.independents()) {
        if (one.kind == motion.kind) motion.index = one.index;
      }
      take_extrapolation(table);
      const int fields = fields_of(table);
      text += keyword + component + ", NONLINEAR" + dependencies(fields) + "\n" +
              rows(table, with_ambient({motion}, fields));
    };
    if (kinetic.elasticity[i]) {
      const law::Elasticity& spring = *kinetic.elasticity[i];
      if (const law::TableFunction* const table = spring.table()) {
        table_text(*table, "*CONNECTOR ELASTICITY", {IndependentKind::kConstitutiveMotion, c});
      } else {
        text += "*CONNECTOR ELASTICITY" + component + "\n" + numbers_(spring.value(0.0, {}).slope) +
                "\n";
      }
    }
    if (kinetic.damping[i]) {
      const law::Damping& damper = *kinetic.damping[i];
      if (const law::TableFunction* const table = damper.table()) {
        table_text(*table, "*CONNECTOR DAMPING", {IndependentKind::kSlipRate, 0});
      } else {
        text +=
            "*CONNECTOR DAMPING" + component + "\n" + numbers_(damper.value(0.0, {}).slope) + "\n";
      }
    }
    if (problem_.stop[i]) {
      const law::Stop& stop = *problem_.stop[i];
      const auto side = [&](double value) {
        return std::isinf(value) ? std::string() : numbers_(value);
      };
      text +=
          "*CONNECTOR STOP" + component + "\n" + data_lines({side(stop.lower), side(stop.upper)});
    }
  }
  if (!kinetic.coupled.components.empty()) {
    std::vector<std::string> items;
    for (std::size_t column = 0; column < 6; ++column) {
      for (std::size_t row = 0; row <= column; ++row) {
        items.push_back(numbers_(kinetic.coupled.stiffness[row][column]));
      }
    }
    text += "*CONNECTOR ELASTICITY\n" + data_lines(items);
  }
  return text;
}

std::string DeckParts::derived(const std::string& name, const law::DerivedComponent& terms) {
  std::string text;
  for (const law::DerivedTerm& term : terms) {
    std::string line = "*CONNECTOR DERIVED COMPONENT, NAME=" + name;
    if (term.combine == law::TermOperator::kSum) line += ", OPERATOR=SUM";
    if (term.combine == law::TermOperator::kMacauleySum) line += ", OPERATOR=MACAULEY SUM";
    if (term.sign < 0.0) line += ", SIGN=NEGATIVE";
    std::vector<std::string> components;
    std::vector<std::string> weights;
    for (int k = 0; k < term.count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      components.push_back(std::to_string(term.component[i] + 1));
      weights.push_back(numbers_(term.weight[i]));
    }
    if (!term.weight_table) {
      text += line + "\n" + data_lines(components) + data_lines(weights);
      continue;
    }
    take_extrapolation(*term.weight_table);
    const std::vector<Independent> motions = motions_of(*term.weight_table);
    const auto [parameter, numbers] = independent_components(motions);
    const int fields = fields_of(*term.weight_table);
    text += line + parameter + dependencies(fields) + "\n" + numbers + data_lines(components) +
            rows(*term.weight_table, with_ambient(motions, fields));
  }
  return text;
}

law::DerivedComponent DeckParts::stated_component(const std::string& name) const {
  law::DerivedComponent component;
  for (const auto& named : written_.derived_components.value) {
    if (named.name != name) continue;
    for (const auto& at : named.value) {
      const read::DerivedTermText& text = at.value;
      const auto* const weights = std::get_if<std::vector<double>>(&text.weights.value);
      if (text.weights.given() && weights == nullptr) {
        refuse("weights of a table in a potential are not in Abaqus");
      }
      law::DerivedTerm& term = component.emplace_back();
      term.combine = text.combine.value;
      term.sign = text.sign.value;
      for (const yaml::At<int>& one : text.components.value) {
        const auto k = static_cast<std::size_t>(term.count++);
        term.component[k] = one.value - 1;
        term.weight[k] = weights == nullptr || weights->empty() ? 1.0 : (*weights)[k];
      }
    }
  }
  return component;
}

std::string DeckParts::friction(std::size_t entry) {
  std::vector<const cases::CaseDefinition*> own;
  for (const cases::CaseDefinition& one : problem_.definitions) {
    if (one.entry == entry) own.push_back(&one);
  }
  const cases::CaseDefinition& first = *own.front();
  std::string text;
  if (first.predefined) text = predefined(first);
  if (text.empty()) {
    for (const cases::CaseDefinition* const one : own) {
      text += user_defined(*one);
      text += coefficient(one->law.law, one->law.force_limit, stick_of(one->law));
    }
    return text;
  }
  return text + coefficient(first.law.law, first.law.force_limit, stick_of(first.law));
}

/// *CONNECTOR FRICTION, PREDEFINED; nothing where the geometry is more than that has, and
/// user-defined friction stands in for it.
std::string DeckParts::predefined(const cases::CaseDefinition& definition) {
  if (is_contact()) return {};
  std::vector<std::string> items;
  bool plain = true;
  bool has_twin = true;
  std::visit(
      [&]<class Type>(const Type& geometry) {
        has_twin = !std::is_same_v<Type, law::UJoint> && !std::is_same_v<Type, law::SlipRing>;
        if constexpr (law::HasPredefinedFriction<Type>) {
          std::apply(
              [&](const auto&... field) {
                [[maybe_unused]] const auto take = [&](const auto& one) {
                  const auto& value = geometry.*(one.member);
                  using Value = std::remove_cvref_t<decltype(value)>;
                  if constexpr (std::is_same_v<Value, double>) {
                    if (one.key == "R_i") {
                      plain = plain && value == 0.0;
                    } else {
                      items.push_back(value == 0.0 ? std::string() : numbers_(value));
                    }
                  } else if constexpr (std::is_same_v<Value, law::InternalContactForce>) {
                    const double* const number = std::get_if<double>(&value);
                    plain = plain && number != nullptr;
                    const double force = number != nullptr ? *number : 0.0;
                    items.push_back(force == 0.0 ? std::string() : numbers_(force));
                  } else {
                    // Hinge factors, if they are given.
                    plain = plain && !value.has_value();
                  }
                };
                (take(field), ...);
              },
              Type::fields());
        }
      },
      *definition.predefined);
  if (!plain) {
    if (!has_twin) refuse("the geometry of its predefined friction is not in Abaqus");
    note(Loss::Kind::kKept,
         "predefined friction, as user-defined friction of the same contact force");
    return {};
  }
  std::string text = name_comment(written_.friction.value[definition.entry].value.name.value) +
                     "*CONNECTOR FRICTION, PREDEFINED";
  const law::StickStiffness stick = stick_of(definition.law);
  if (stick.mode == law::StickStiffness::Mode::kStiffness) {
    text += ", STICK STIFFNESS=" + numbers_(stick.value);
  }
  text += "\n";
  const bool empty =
      std::all_of(items.begin(), items.end(), [](const std::string& one) { return one.empty(); });
  return text + (empty ? std::string() : data_lines(items));
}

std::string DeckParts::user_defined(const cases::CaseDefinition& definition) {
  const law::FrictionDefinition& law = definition.law;
  std::string text;
  std::string line = name_comment(definition.name) + "*CONNECTOR FRICTION";
  const bool pressed = !std::holds_alternative<law::NoContactForce>(law.contact_force);
  const bool single = law.slip.dimension == 1 && law.slip.scale[0] == 1.0 &&
                      std::holds_alternative<law::EuclideanPotential>(law.criterion);
  if (single) line += fmt::format(", COMPONENT={}", law.slip.component[0] + 1);
  if (const auto* one = std::get_if<law::ComponentContactForce>(&law.contact_force)) {
    line += fmt::format(", CONTACT FORCE={}", one->component + 1);
  } else if (const auto* terms = std::get_if<law::DerivedComponent>(&law.contact_force)) {
    const std::string name =
        fmt::format("CONTACT{}", definition.entry + 1) +
        (definition.law.slip.component[0] == 3 && definition.predefined ? std::string("_SPIN")
                                                                        : std::string());
    text += derived(name, *terms);
    line += ", CONTACT FORCE=" + name;
  } else if (std::holds_alternative<law::UniversalJointContact>(law.contact_force)) {
    refuse("the contact force of a UJOINT is predefined only");
  }
  const law::StickStiffness stick = stick_of(law);
  if (stick.mode == law::StickStiffness::Mode::kStiffness) {
    line += ", STICK STIFFNESS=" + numbers_(stick.value);
  }
  if (const double* const number = std::get_if<double>(&law.internal_contact_force)) {
    text += line + "\n" + (*number == 0.0 && pressed ? std::string() : numbers_(*number) + "\n");
  } else {
    const auto& table = std::get<law::TableFunction>(law.internal_contact_force);
    take_extrapolation(table);
    std::vector<Independent> columns = motions_of(table);
    const auto [parameter, numbers] = independent_components(columns);
    columns.push_back({IndependentKind::kAccumulatedSlip, 0});
    const int fields = fields_of(table);
    text += line + parameter + dependencies(fields) + "\n" + numbers +
            rows(table, with_ambient(columns, fields));
  }
  return single ? text : text + potential(definition);
}

std::string DeckParts::potential(const cases::CaseDefinition& definition) {
  const law::FrictionDefinition& law = definition.law;
  if (std::holds_alternative<law::EuclideanPotential>(law.criterion)) {
    std::string text = "*CONNECTOR POTENTIAL\n";
    for (int k = 0; k < law.slip.dimension; ++k) {
      const auto i = static_cast<std::size_t>(k);
      text += data_lines({std::to_string(law.slip.component[i] + 1),
                          law.slip.scale[i] == 1.0 ? std::string() : numbers_(law.slip.scale[i])});
    }
    return text;
  }
  const read::FrictionText& written = written_.friction.value[definition.entry].value;
  if (!written.potential.given()) refuse("its criterion of slip is not in Abaqus");
  const read::PotentialText& potential = written.potential.value;
  std::string before;
  std::string text = "*CONNECTOR POTENTIAL";
  if (potential.combine == law::PotentialOperator::kMax) text += ", OPERATOR=MAX";
  if (potential.exponent.value != 2.0) text += ", EXPONENT=" + numbers_(potential.exponent.value);
  text += "\n";
  for (const auto& at : potential.terms.value) {
    const read::PotentialTermText& term = at.value;
    std::string of = std::to_string(term.component.value);
    if (term.derived.given()) {
      of = fmt::format("PART{}_{}", definition.entry + 1, &at - potential.terms.value.data() + 1);
      before += derived(of, stated_component(term.derived.value));
    }
    constexpr std::array kUses{"", "MACAULEY", "NONE"};
    text += data_lines({of, numbers_(term.scale.value),
                        term.exponent.given() ? numbers_(term.exponent.value) : std::string(),
                        kUses[static_cast<std::size_t>(term.of.value)],
                        term.shift.value == 0.0 ? std::string() : numbers_(term.shift.value),
                        term.sign.value < 0 ? std::string("NEGATIVE") : std::string()});
  }
  return before + text;
}

std::string DeckParts::tabulated(const law::FrictionLaw& law) {
  if (!range_) range_ = run_range(problem_);
  const CoefficientGrid grid = tabulate(law, *range_);
  note(Loss::Kind::kApproximated,
       fmt::format("coefficient {}: {} points over slip rate and contact force, off by at most "
                   "{:.1e} between them, constant outside",
                   law::name_of(law), grid.rates.size() * grid.forces.size(), grid.error));
  std::string text;
  for (std::size_t j = 0; j < grid.forces.size(); ++j) {
    for (std::size_t i = 0; i < grid.rates.size(); ++i) {
      text += data_lines({numbers_(grid.mu[j][i]), numbers_(grid.rates[i]),
                          grid.forces.size() > 1 ? numbers_(grid.forces[j]) : std::string()});
    }
  }
  return text;
}

std::string DeckParts::coefficient(const law::FrictionLaw& law, double force_limit,
                                   const law::StickStiffness& stick) {
  std::string parameters;
  std::string data;
  if (const auto* constant = law::get_law_if<law::ConstantCoefficient>(law)) {
    data = numbers_(constant->mu) + "\n";
  } else if (const auto* decay = law::get_law_if<law::ExponentialDecay>(law)) {
    parameters = ", EXPONENTIAL DECAY";
    data =
        data_lines({numbers_(decay->mu_static), numbers_(decay->kinetic), numbers_(decay->decay)});
  } else if (const auto* test = law::get_law_if<law::ExponentialTestData>(law)) {
    parameters = ", EXPONENTIAL DECAY, TEST DATA";
    data = numbers_(test->mu1) + "\n" + data_lines({numbers_(test->mu2), numbers_(test->rate2)});
    if (test->mu_inf) data += numbers_(*test->mu_inf) + "\n";
  } else if (const auto* table = law::get_law_if<law::TabularCoefficient>(law)) {
    if (table->table.table().extrapolation() == law::Extrapolation::kLinear) {
      note(Loss::Kind::kApproximated,
           "the coefficient's linear extrapolation; *FRICTION keeps its end values");
    }
    const int fields = fields_of(table->table);
    parameters = dependencies(fields);
    data = rows(table->table,
                with_ambient({{IndependentKind::kSlipRate, 0}, {IndependentKind::kContactForce, 0}},
                             fields));
  } else {
    data = tabulated(law);
  }
  if (force_limit < law::kNoForceLimit) parameters += ", TAUMAX=" + numbers_(force_limit);
  if (stick.mode == law::StickStiffness::Mode::kElasticSlip) {
    parameters += ", ELASTIC SLIP=" + numbers_(stick.value);
  }
  return "*FRICTION" + parameters + "\n" + data;
}

}  // namespace slipbench::driver::exports
