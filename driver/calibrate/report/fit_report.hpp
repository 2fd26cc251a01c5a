// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "driver/base/files/output_file.hpp"
#include "driver/calibrate/calibration.hpp"
#include "driver/calibrate/fit.hpp"

namespace slipbench::driver::calibrate {

/// The JSON document of a fit's page, on one line, to be embedded as it is in a script element: no
/// '<' stands in it. Of many points some are drawn (thinned_rows keeps extremes); what is told of
/// the residuals (histogram, autocorrelation) is that of all. What is no finite number is null. The
/// same fit gives the same bytes: no date but the user's, no seconds.
std::string fit_document(const Fit& fit, const Calibration& calibration);

/// Writes the page of a fit as one file that appears only when it is complete: verdict, unknowns
/// with their errors, experiments before and after, residuals, tables, how it was found. It needs
/// nothing else. Returns its size in bytes.
/// \param with what appears together with it, or not at all
/// Errors: those of OutputFile.
tl::expected<std::size_t, std::string> write_fit_report(
    const Fit& fit, const Calibration& calibration, const std::filesystem::path& file,
    const base::Overwriting& overwriting = {}, std::span<base::OutputFile* const> with = {});

}  // namespace slipbench::driver::calibrate
