// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/case/case.hpp"
#include "driver/check/check.hpp"

namespace slipbench::driver::check {

/// Returns whether a check keeps the rows that it compares until the end of the run.
bool keeps_rows(const cases::Check& check, Trace trace);

/// Returns why the checks of a case cannot be judged: those that keep the rows they compare need
/// more memory than there is. A sentence with the need, what is free and what helps; empty if they
/// fit, or if nothing is known of the number of rows.
std::string memory_fault(const cases::Case& problem, Trace trace = Trace::kNone);

}  // namespace slipbench::driver::check
