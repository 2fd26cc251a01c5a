// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/quick_resolve.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "driver/case/quantity.hpp"
#include "driver/history/profile.hpp"
#include "law/friction/friction_law.hpp"

namespace slipbench::driver::sweep {
namespace {

/// Without the '=' and the blanks around it.
std::string_view bare(std::string_view text) {
  while (!text.empty() && (text.front() == '=' || text.front() == ' ')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Takes `begin` off the front of a text; tells whether it stood there.
bool skip(std::string_view& text, std::string_view begin) {
  if (!text.starts_with(begin)) return false;
  text.remove_prefix(begin.size());
  return true;
}

/// Takes "12]" off the front of a text.
std::optional<std::size_t> take_index(std::string_view& text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (!skip(text, "]")) return std::nullopt;
  return index;
}

/// Returns the row of "rows[3][0]", the dependent of a table of one.
std::optional<std::size_t> row_of(std::string_view path) {
  if (!skip(path, "rows[")) return std::nullopt;
  const auto row = take_index(path);
  return row && path == "[0]" ? row : std::nullopt;
}

const double* constant_force(const cases::Case& problem, const VariedForce& force) {
  if (force.step >= problem.steps.size()) return nullptr;
  for (const cases::Drive& drive : problem.steps[force.step].drives) {
    if (drive.quantity != cases::kFirstForce + force.component) continue;
    const auto* constant = std::get_if<history::Constant>(&drive.profile);
    return constant == nullptr ? nullptr : &constant->value;
  }
  return nullptr;
}

/// All expressions of parameters; those of settings count more than those of the text.
std::map<std::string, std::string, std::less<>> parameter_texts(const Sweep& sweep) {
  std::map<std::string, std::string, std::less<>> texts;
  const auto parameters = sweep.parsed.root().find("parameters");
  if (parameters && parameters->is_map()) {
    for (const yaml::Entry entry : parameters->entries()) {
      if (entry.value.is_scalar() && bare(entry.value.text()) != entry.value.text()) {
        texts[std::string(entry.key.text())] = std::string(entry.value.text());
      }
    }
  }
  for (const base::ParameterText& setting : sweep.settings) {
    texts.erase(setting.name);
    if (const auto* text = std::get_if<std::string>(&setting.value)) texts[setting.name] = *text;
  }
  for (const VariedParameter& varied : sweep.varied) texts.erase(varied.name);
  return texts;
}

}  // namespace

std::optional<QuickResolve::Number> QuickResolve::number_of(const std::string& text,
                                                            const base::NamedNumbers& fixed) const {
  const auto name = std::find(names_.begin(), names_.end(), bare(text));
  if (name != names_.end()) return Number{static_cast<std::size_t>(name - names_.begin()), {}};
  auto expression = base::Expression::compile(text, names_, fixed);
  if (!expression) return std::nullopt;
  return Number{std::nullopt, std::move(*expression)};
}

/// Tells whether a formula over times and positions uses none of the names.
bool QuickResolve::is_independent(const std::string& text, const base::NamedNumbers& fixed) const {
  std::vector<std::string> variables = names_;
  for (const char* name : {"t", "T", "CP1", "CP2", "CP3", "CPR1", "CPR2", "CPR3"}) {
    variables.emplace_back(name);
  }
  const auto expression = base::Expression::compile(text, variables, fixed);
  return expression && std::none_of(names_.begin(), names_.end(), [&](const std::string& name) {
           return expression->uses(name);
         });
}

/// Finds the parameters that depend on the varied ones, each behind those that it uses.
bool QuickResolve::name_dependents(const Sweep& sweep) {
  const auto texts = parameter_texts(sweep);
  std::vector<std::string> all;
  for (const auto& [name, number] : sweep.base.parameters) all.push_back(name);
  std::map<std::string, std::vector<std::string>, std::less<>> uses;
  for (const auto& [name, text] : texts) {
    // What is no expression is a setting with a unit.
    const auto expression = base::Expression::compile(text, all);
    if (!expression) continue;
    const auto used = expression->used_variables();
    uses[name].assign(used.begin(), used.end());
  }
  std::map<std::string, std::vector<std::string>, std::less<>> users;
  for (const auto& [name, used] : uses) {
    for (const std::string& one : used) users[one].push_back(name);
  }
  std::set<std::string, std::less<>> met(names_.begin(), names_.end());
  std::vector<std::string> dependent = names_;
  for (std::size_t i = 0; i < dependent.size(); ++i) {
    for (const std::string& user : users[dependent[i]]) {
      if (met.insert(user).second) dependent.push_back(user);
    }
  }
  // Each follows when the last of those that it uses is named.
  std::map<std::string, std::size_t, std::less<>> open;
  for (const auto& [name, used] : uses) {
    open[name] = static_cast<std::size_t>(std::count_if(
        used.begin(), used.end(), [&](const auto& one) { return met.contains(one); }));
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const std::vector<std::string> of_it = users[names_[i]];
    for (const std::string& user : of_it) {
      if (--open[user] == 0) names_.push_back(user);
    }
  }
  if (names_.size() < dependent.size()) return false;
  for (std::size_t i = sweep.varied.size(); i < names_.size(); ++i) {
    auto number = number_of(texts.find(names_[i])->second, sweep.base.parameters);
    if (!number) return false;
    dependents_.push_back(std::move(*number));
  }
  return true;
}

std::optional<QuickResolve::Target> QuickResolve::target_at(const std::string& path,
                                                            const cases::Case& base) {
  std::string_view rest = path;
  if (skip(rest, "friction[0].")) {
    if (rest == "coefficient") return Target{Place::kCoefficient};
    if (rest == "stick.stiffness") return Target{Place::kStickStiffness};
    if (rest == "stick.elastic_slip") return Target{Place::kElasticSlip};
    if (rest == "force_limit") return Target{Place::kForceLimit};
    if (skip(rest, "coefficient.")) {
      if (const auto row = row_of(rest)) return Target{Place::kCoefficientRow, *row};
      return std::nullopt;
    }
    skip(rest, "predefined.");
    if (rest == "internal_contact_force") return Target{Place::kInternalForce};
    if (!skip(rest, "internal_contact_force.")) return std::nullopt;
    if (const auto row = row_of(rest)) return Target{Place::kInternalForceRow, *row};
    return std::nullopt;
  }
  if (!skip(rest, "history[")) return std::nullopt;
  const auto step = take_index(rest);
  if (!step || *step >= base.steps.size() || !skip(rest, ".force.")) return std::nullopt;
  const auto component = cases::component_of_force(rest);
  if (!component) return std::nullopt;
  forces_.push_back({*step, *component});
  return Target{Place::kForce, forces_.size() - 1};
}

std::optional<double> QuickResolve::value_of(const Number& number) const {
  if (number.name) return numbers_[*number.name];
  const auto value = (*number.expression)(numbers_);
  return value ? std::optional(*value) : std::nullopt;
}

bool QuickResolve::take_names(std::span<const double> values) {
  std::copy(values.begin(), values.end(), numbers_.begin());
  for (std::size_t i = 0; i < dependents_.size(); ++i) {
    const auto value = value_of(dependents_[i]);
    if (!value) return false;
    numbers_[values.size() + i] = *value;
  }
  return true;
}

/// A number of a definition, or a force; nothing where the definition has none there.
class QuickResolve::Slot {
 public:
  Slot(const Target& target, law::FrictionDefinition& definition, std::span<double> forces)
      : row_(target.index) {
    const bool fixed = definition.stick.mode == law::StickStiffness::Mode::kStiffness;
    switch (target.place) {
      case Place::kCoefficient:
        if (auto* law = std::get_if<law::ConstantCoefficient>(&definition.law)) number_ = &law->mu;
        break;
      case Place::kCoefficientRow:
        if (auto* law = std::get_if<law::TabularCoefficient>(&definition.law)) take(law->table);
        break;
      case Place::kInternalForce:
        number_ = std::get_if<double>(&definition.internal_contact_force);
        break;
      case Place::kInternalForceRow:
        if (auto* function = std::get_if<law::TableFunction>(&definition.internal_contact_force)) {
          take(*function);
        }
        break;
      case Place::kStickStiffness:
      case Place::kElasticSlip:
        if (fixed == (target.place == Place::kStickStiffness)) number_ = &definition.stick.value;
        break;
      case Place::kForceLimit:
        number_ = &definition.force_limit;
        break;
      case Place::kForce:
        number_ = &forces[target.index];
        break;
    }
  }

  bool exists() const { return number_ != nullptr || table_ != nullptr; }
  double value() const { return table_ == nullptr ? *number_ : table_->ordinate(row_); }
  void set(double value) {
    if (table_ == nullptr) {
      *number_ = value;
    } else {
      table_->set_ordinate(row_, 0, value);
    }
  }

 private:
  void take(law::TableFunction& function) {
    law::Table& table = function.table();
    if (table.dependents() == 1 && row_ < table.rows()) table_ = &table;
  }

  double* number_ = nullptr;
  law::Table* table_ = nullptr;
  std::size_t row_;
};

bool QuickResolve::resolve(std::span<const double> values, law::FrictionDefinition& definition,
                           std::span<double> forces) {
  if (!take_names(values)) return false;
  for (const Target& target : targets_) {
    const auto value = value_of(target.number);
    if (!value || !is_admissible(target.place, *value)) return false;
    Slot(target, definition, forces).set(*value);
  }
  return true;
}

/// Tells whether a number is far within what the reader takes, and so small that no product of a
/// run becomes infinite.
bool QuickResolve::is_admissible(Place place, double value) {
  if (!(std::abs(value) < kTame)) return false;
  switch (place) {
    case Place::kForce:
      return true;
    case Place::kStickStiffness:
    case Place::kElasticSlip:
    case Place::kForceLimit:
      return value > 1.0 / kTame;
    default:
      return value >= 0.0;
  }
}

std::optional<QuickResolve> QuickResolve::make(const Sweep& sweep) {
  std::vector<double> middle;
  for (const VariedParameter& one : sweep.varied) middle.push_back(one.distribution.at(0.5));
  std::vector<yaml::Formula> formulas;  // some are read more than once
  read::ReadCase read = sweep.parsed.resolve({.overrides = overrides_of(sweep, middle),
                                              .allow_outside = sweep.allow_outside,
                                              .curves_may_be_missing = true,
                                              .formulas = &formulas});
  if (!read.value || read.value->definitions.size() != 1) return std::nullopt;
  cases::Case& base = *read.value;

  QuickResolve quick;
  for (const VariedParameter& one : sweep.varied) quick.names_.push_back(one.name);
  if (!quick.name_dependents(sweep)) return std::nullopt;
  quick.numbers_.resize(quick.names_.size());
  if (!quick.take_names(middle)) return std::nullopt;
  // The formulas of checks have no say in a run, and no value of a parameter makes them faulty.
  std::set<std::string_view> of_checks;
  for (const yaml::Formula& formula : formulas) {
    if (!formula.is_number && formula.path.starts_with("checks[")) of_checks.insert(formula.path);
  }
  std::set<std::string> seen;
  std::set<std::string_view> idle;  // texts that use no varied parameter: many may be the same
  for (const yaml::Formula& formula : formulas) {
    if (of_checks.contains(formula.path) || idle.contains(formula.text)) continue;
    auto number = quick.number_of(formula.text, base.parameters);
    if (!number) {
      if (!quick.is_independent(formula.text, base.parameters)) return std::nullopt;
      idle.insert(formula.text);
      continue;
    }
    if (number->expression && number->expression->used_variables().empty()) {
      idle.insert(formula.text);
      continue;
    }
    if (!seen.insert(formula.path).second) continue;
    auto target = quick.target_at(formula.path, base);
    if (!target) return std::nullopt;
    target->number = std::move(*number);
    quick.targets_.push_back(std::move(*target));
  }

  // Each number stands where it is looked for, as the reader took it over.
  std::vector<double> forces;
  for (const VariedForce& force : quick.forces_) {
    const double* constant = constant_force(base, force);
    if (constant == nullptr) return std::nullopt;
    forces.push_back(*constant);
  }
  for (const Target& target : quick.targets_) {
    const Slot slot(target, base.definitions.front().law, forces);
    const auto value = quick.value_of(target.number);
    if (!value || !slot.exists() ||
        std::bit_cast<std::uint64_t>(slot.value()) != std::bit_cast<std::uint64_t>(*value)) {
      return std::nullopt;
    }
  }
  return quick;
}

}  // namespace slipbench::driver::sweep
