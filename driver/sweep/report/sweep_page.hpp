// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "driver/base/files/file_mark.hpp"
#include "driver/sweep/kept_samples.hpp"
#include "driver/sweep/sobol_indices.hpp"
#include "driver/sweep/sweep.hpp"
#include "driver/sweep/sweep_summary.hpp"

namespace slipbench::driver::sweep {

/// Returns a page of a sweep that needs nothing else, and no script: for each number its histogram,
/// what it depends on (Sobol' indices, or correlations), its extremes and how to run them; a matrix
/// of numbers over parameters.
/// \param kept what the matrix shows
std::string sweep_page(const Sweep& sweep, const SweepSummary& summary,
                       const std::optional<SobolEstimate>& indices, const KeptSamples& kept);

/// Returns the mark of the page of a sweep.
base::FileMark sweep_page_mark(const Sweep& sweep);

}  // namespace slipbench::driver::sweep
