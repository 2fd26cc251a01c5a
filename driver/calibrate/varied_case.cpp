// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/varied_case.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/calibrate/resolve_varied.hpp"

namespace slipbench::driver::calibrate {
namespace {

law::TableFunction* varied_table(law::FrictionDefinition& definition, VariedTable::Use use) {
  return const_cast<law::TableFunction*>(
      driver::calibrate::varied_table(std::as_const(definition), use));
}

/// The first error, in one line.
std::string first_error(const base::Diagnostics& diagnostics) {
  for (const base::Diagnostic& diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity != base::Severity::kError) continue;
    return diagnostic.path + (diagnostic.path.empty() ? "" : ": ") + diagnostic.message;
  }
  return "it cannot be read";
}

}  // namespace

const law::TableFunction* varied_table(const law::FrictionDefinition& definition,
                                       VariedTable::Use use) {
  if (use == VariedTable::Use::kInternalContactForce) {
    return std::get_if<law::TableFunction>(&definition.internal_contact_force);
  }
  const auto* law = std::get_if<law::TabularCoefficient>(&definition.law);
  return law == nullptr ? nullptr : &law->table;
}

std::vector<std::size_t> definitions_with(const cases::Case& problem, const VariedTable& table) {
  std::vector<std::size_t> found = definitions_of(problem, table.definition);
  std::erase_if(found, [&](std::size_t i) {
    return varied_table(problem.definitions[i].law, table.use) == nullptr;
  });
  return found;
}

std::vector<VariedOrdinates> varied_ordinates(const Fit& fit) {
  std::vector<VariedOrdinates> all;
  std::size_t next = fit.vary.size();
  for (std::size_t t = 0; t < fit.tables.size(); ++t) {
    VariedOrdinates ordinates;
    ordinates.table = t;
    ordinates.first_unknown = next;
    for (const ExperimentFit& experiment : fit.experiments) {
      const auto with = definitions_with(experiment.base, fit.tables[t]);
      if (with.empty()) continue;
      const law::FrictionDefinition& definition = experiment.base.definitions[with.front()].law;
      ordinates.count = varied_table(definition, fit.tables[t].use)->table().rows();
      break;
    }
    next += ordinates.count;
    all.push_back(std::move(ordinates));
  }
  return all;
}

tl::expected<VariedCase, std::string> VariedCase::open(const Fit& fit,
                                                       const ExperimentFit& experiment,
                                                       std::span<const VariedOrdinates> ordinates) {
  auto source = base::read_source(experiment.case_path.string());
  if (!source) return tl::unexpected(source.error().diagnostic.message);
  const std::string folder = experiment.case_path.parent_path().string();
  auto parsed = read::ParsedCase::parse(*source, folder.empty() ? "." : folder);
  if (!parsed) return tl::unexpected(first_error(parsed.error()));
  VariedCase varied(std::move(*parsed));
  varied.settings_ = experiment.settings;
  varied.first_ordinate_ = fit.vary.size();
  for (std::size_t i = 0; i < fit.vary.size(); ++i) {
    if (!experiment.base.parameters.contains(fit.vary[i].name)) continue;
    varied.parameters_.push_back({i, fit.vary[i].name});
    varied.unknowns_.push_back(i);
  }
  for (VariedOrdinates table : ordinates) {
    table.definitions = definitions_with(experiment.base, fit.tables[table.table]);
    if (table.definitions.empty()) continue;
    for (std::size_t i = 0; i < table.count; ++i) {
      varied.unknowns_.push_back(table.first_unknown + i);
    }
    varied.uses_.push_back(fit.tables[table.table].use);
    varied.ordinates_.push_back(std::move(table));
  }
  if (varied.parameters_.empty()) {
    for (const cases::CaseDefinition& definition : experiment.base.definitions) {
      varied.fixed_.push_back(definition.law);
    }
  }
  return varied;
}

read::ReadOptions VariedCase::options_at(std::span<const double> x) const {
  // The files were judged when the fit was read.
  read::ReadOptions options{.overrides = settings_, .allow_outside = true};
  for (const Parameter& parameter : parameters_) {
    options.overrides.push_back({parameter.name, x[parameter.unknown]});
  }
  return options;
}

void VariedCase::set_ordinates(std::span<const double> x, std::size_t index,
                               law::FrictionDefinition& definition) const {
  for (std::size_t k = 0; k < ordinates_.size(); ++k) {
    const VariedOrdinates& ordinates = ordinates_[k];
    if (std::find(ordinates.definitions.begin(), ordinates.definitions.end(), index) ==
        ordinates.definitions.end()) {
      continue;
    }
    law::Table& table = varied_table(definition, uses_[k])->table();
    for (std::size_t row = 0; row < ordinates.count; ++row) {
      table.set_ordinate(row, ordinates.column, x[ordinates.first_unknown + row]);
    }
  }
}

tl::expected<std::vector<law::FrictionDefinition>, std::string> VariedCase::definitions_at(
    std::span<const double> x) const {
  std::vector<law::FrictionDefinition> definitions;
  if (parameters_.empty()) {
    definitions = fixed_;
  } else {
    auto resolved = parsed_.resolve_friction_only(options_at(x));
    if (!resolved) return tl::unexpected(first_error(resolved.error()));
    definitions.reserve(resolved->size());
    for (cases::CaseDefinition& definition : *resolved)
      definitions.push_back(std::move(definition.law));
  }
  for (std::size_t i = 0; i < definitions.size(); ++i) {
    set_ordinates(x, i, definitions[i]);
  }
  return definitions;
}

tl::expected<cases::Case, std::string> VariedCase::case_at(std::span<const double> x) const {
  read::ReadOptions options = options_at(x);
  // The checks are none of the fit's business.
  options.curves_may_be_missing = true;
  read::ReadCase read = parsed_.resolve(options);
  if (!read.value) return tl::unexpected(first_error(read.diagnostics));
  for (std::size_t i = 0; i < read.value->definitions.size(); ++i) {
    set_ordinates(x, i, read.value->definitions[i].law);
  }
  return std::move(*read.value);
}

tl::expected<base::NamedNumbers, std::string> VariedCase::numbers_at(
    std::span<const double> x) const {
  auto numbers = parsed_.resolve_parameters_only(options_at(x));
  if (!numbers) return tl::unexpected(first_error(numbers.error()));
  return std::move(*numbers);
}

}  // namespace slipbench::driver::calibrate
