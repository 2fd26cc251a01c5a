// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "driver/calibrate/fit.hpp"
#include "driver/case/case.hpp"
#include "driver/read/read_case.hpp"
#include "law/definition/friction_definition.hpp"

namespace slipbench::driver::calibrate {

/// A table of a case whose ordinates are unknowns.
struct VariedOrdinates {
  std::size_t table = 0;                 ///< in Fit::tables
  std::size_t first_unknown = 0;         ///< its ordinates are consecutive, in the rows' order
  std::size_t count = 0;                 ///< of its rows
  int column = 0;                        ///< dependent of the table
  std::vector<std::size_t> definitions;  ///< in Case::definitions, that have it
};

/// The tables of a fit with their place among the unknowns; `definitions` stays empty. Cases that
/// have the same table have the same rows of it.
std::vector<VariedOrdinates> varied_ordinates(const Fit& fit);

/// The definitions of a case that have a varied table.
std::vector<std::size_t> definitions_with(const cases::Case& problem, const VariedTable& table);

/// The function of a varied table in a definition; null if it has none there.
const law::TableFunction* varied_table(const law::FrictionDefinition& definition,
                                       VariedTable::Use use);

/// The case of one experiment as a function of the unknowns: parameters in the fit's order, then
/// the ordinates of its tables. The text is parsed once; each value of the parameters resolves it
/// again, so that whatever depends on them by an expression follows.
class VariedCase {
 public:
  /// \param ordinates of the fit, by varied_ordinates
  /// Errors, in a sentence: a case that cannot be read any more.
  static tl::expected<VariedCase, std::string> open(const Fit& fit, const ExperimentFit& experiment,
                                                    std::span<const VariedOrdinates> ordinates);

  /// The unknowns that the case has: its parameters and its tables' ordinates, ascending.
  std::span<const std::size_t> unknowns() const { return unknowns_; }
  /// Counts those that stand for parameters.
  std::size_t parameters() const { return parameters_.size(); }
  const std::string& parameter_name(std::size_t i) const { return parameters_[i].name; }
  /// Unknowns from here on are ordinates.
  std::size_t first_ordinate() const { return first_ordinate_; }

  /// The friction definitions only, in the order of the case's.
  /// Errors, in a sentence: what the reader refuses at these values.
  tl::expected<std::vector<law::FrictionDefinition>, std::string> definitions_at(
      std::span<const double> x) const;

  /// The whole case. Errors as before.
  tl::expected<cases::Case, std::string> case_at(std::span<const double> x) const;

  /// The numbers that expressions may use.
  tl::expected<base::NamedNumbers, std::string> numbers_at(std::span<const double> x) const;

 private:
  struct Parameter {
    std::size_t unknown = 0;
    std::string name;
  };

  explicit VariedCase(read::ParsedCase parsed) : parsed_(std::move(parsed)) {}

  read::ReadOptions options_at(std::span<const double> x) const;
  /// Puts ordinates into the tables.
  void set_ordinates(std::span<const double> x, std::size_t index,
                     law::FrictionDefinition& definition) const;

  read::ParsedCase parsed_;
  std::vector<base::ParameterText> settings_;
  std::vector<Parameter> parameters_;
  std::vector<VariedOrdinates> ordinates_;
  std::vector<VariedTable::Use> uses_;  ///< of each of them
  std::vector<std::size_t> unknowns_;
  std::size_t first_ordinate_ = 0;
  /// Of a case without varied parameters: they need not be resolved again.
  std::vector<law::FrictionDefinition> fixed_;
};

}  // namespace slipbench::driver::calibrate
