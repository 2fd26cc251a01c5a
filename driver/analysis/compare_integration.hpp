// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "driver/analysis/side_by_side.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::analysis {

/// `slipbench run --compare-integration`: the case by backward Euler and exactly, row beside row on
/// the case's own increments, whichever method it names. Tells for each definition how far the
/// forces are apart and where, the slip and the dissipation at the end: the error of the increment
/// size. Exact is the history that goes straight from row to row: what a curved history loses
/// between its rows is in neither. Writes nothing.
/// Errors: a case that exact integration refuses; a run that fails.
tl::expected<std::string, CommandFailure> compare_integration(const cases::Case& problem);

}  // namespace slipbench::driver::analysis
