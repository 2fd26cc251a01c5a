// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "driver/report/case_report.hpp"
#include "driver/results/result_layout.hpp"

namespace slipbench::driver::report {

/// The columns of a result that a page draws, and what they mean.
struct DrawnColumns {
  std::vector<std::string> names;    ///< the first is t
  std::vector<std::size_t> motions;  ///< of them, the positions of the first definition
  std::vector<ReportDefinition> definitions;
  std::vector<std::pair<std::string, std::vector<std::string>>> energies;  ///< kind, columns
};

/// Chooses them. Forces, motions, limits and regimes come first, then energies, then coefficients
/// and normal forces: of a case with many definitions, what comes last is left out.
DrawnColumns drawn_columns(const results::ResultLayout& layout);

/// Gives the columns of energies the unit that the summary of a run tells its energies in: mJ, and
/// not N mm beside it.
void use_energy_unit(CaseReport& report, const std::string& unit);

}  // namespace slipbench::driver::report
