// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/report/case_report.hpp"
#include "driver/results/coverage.hpp"

namespace slipbench::driver::report {

/// A table's coverage, small enough to be drawn: neighbouring cells of a large table are taken
/// together, and of more than two independents there are only the sums along each.
/// \param definition the name of the friction definition it belongs to
ReportTable drawn_coverage(const results::TableCoverage& table, const std::string& definition);

}  // namespace slipbench::driver::report
