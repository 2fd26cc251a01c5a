// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "driver/check/check.hpp"
#include "driver/report/case_report.hpp"

namespace slipbench::driver::report {

/// Puts the curves of a check into its report, thinned: the extremes of both and of their
/// difference stay, and so do the points around the worst one. A check that failed gets more
/// points than one that passed, and one of many checks fewer.
/// \param checks how many the case has
void put_trace(ReportCheck& check, const check::CheckTrace& trace, std::size_t checks);

}  // namespace slipbench::driver::report
