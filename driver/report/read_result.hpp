// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "driver/base/files/exit_code.hpp"
#include "driver/report/case_report.hpp"

namespace slipbench::driver::report {

/// A result, or why there is none.
struct ReadResult {
  CaseReport report;
  int code = base::kExitOk;
};

/// Reads a result of `slipbench run` for a page: the rows in `path`, and the verdicts and events in
/// the .json and .events.csv beside it, if they are there. What cannot be read becomes a report
/// that says so.
/// \param name what the result is called on the page
/// \param most_rows of a result that is not thinned (RowChoice)
ReadResult read_result(const std::string& path, const std::string& name,
                       std::size_t most_rows = kMostRows);

}  // namespace slipbench::driver::report
