// SPDX-License-Identifier: Apache-2.0
// Identifiability: whether the measurements say anything about what is varied, and which data would
// say more.
#pragma once

#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"
#include "driver/results/coverage.hpp"

namespace slipbench::driver::calibrate {

/// Adds the increments of one run to the cells of a fitted table, and makes the cells at the first
/// call. Runs of cases that do not have the table add nothing.
/// \param table what is varied
/// \param problem the case that was run, at the optimum
/// \param coverage of the whole run
/// \param[in,out] fitted gets `cells` (first independent fastest; none of a table too large to be
/// counted) and `units`
void add_visits(const VariedTable& table, const cases::Case& problem,
                const results::Coverage& coverage, FittedTable* fitted);

/// Fills `visits`, `identifiability` and `why` of every unknown: from the derivatives at the
/// optimum (compared points that depend on it), the statistics (an interval wider than the value or
/// as wide as the bounds; lost in a combination) and the tables' cells. Wants names, values,
/// tables, problem, fit and statistics to be there.
void judge_identifiability(Calibration* calibration);

/// Returns what to know of it, a sentence each: table ranges that were never visited and what to
/// measure, combinations of unknowns of which the data see only one ("only the product of mu and N
/// is seen"), pairs that move together. Wants judge_identifiability to have been called.
std::vector<std::string> identifiability_notes(const Fit& fit, const Calibration& calibration);

/// Correlations from here on are told to the user.
inline constexpr double kStrongCorrelation = 0.95;

}  // namespace slipbench::driver::calibrate
