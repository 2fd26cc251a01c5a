// SPDX-License-Identifier: Apache-2.0
// Unknowns of a fit: its numbers checked by themselves, then against the cases that have them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "driver/calibrate/fit.hpp"
#include "driver/calibrate/fit_text.hpp"

namespace slipbench::driver::calibrate {

/// An experiment as far as it was read, with its case.
struct ReadExperiment {
  ExperimentFit fit;                    ///< its base only where `read` says so
  std::optional<yaml::Node> root;       ///< of the case's text
  std::vector<std::string> parameters;  ///< names, in the order of the case
  bool read = false;                    ///< whether the case is sound
  std::string case_name;                ///< for messages
};

/// The definitions of a case to which a varied table belongs: of the friction entry of that name,
/// one or, where predefined friction gives several, all of them; of every one if the fit names
/// none.
std::vector<std::size_t> definitions_of(const cases::Case& problem, std::string_view definition);

/// The parameters of all cases, each once, in their order.
std::vector<std::string> parameters_of(std::span<const ReadExperiment> experiments);

/// Start, bounds and scale of a parameter, checked against each other. The start is not a number
/// if the fit leaves it to the case.
VariedParameter varied_parameter(yaml::Binder& binder, const yaml::Named<VaryText>& text);

/// Gives every parameter its start, and reports those that no fitted case has, or whose start is
/// outside their bounds.
void settle_parameters(yaml::Binder& binder, const yaml::NamedMap<VaryText>& texts,
                       std::span<const ReadExperiment> experiments,
                       std::vector<VariedParameter>& parameters);

/// The tables of a fit; every fault is reported.
std::vector<VariedTable> varied_tables(yaml::Binder& binder,
                                       const yaml::NamedMap<VariedTableText>& texts,
                                       std::span<const ReadExperiment> experiments);

/// Tells whether the numbers of a varied table in a case have the shape that the fit wants of them.
bool has_shape(const cases::Case& problem, const VariedTable& table);

}  // namespace slipbench::driver::calibrate
