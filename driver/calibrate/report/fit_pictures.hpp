// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/calibrate/calibration.hpp"
#include "driver/calibrate/fit.hpp"

namespace slipbench::driver::calibrate {

/// The pictures of a fit, and why one is missing.
struct FitPictures {
  std::vector<std::filesystem::path> written;  ///< in the fit's order
  std::vector<std::string> notes;  ///< for the user, a sentence each; gnuplot is missing
};

/// The names of all pictures of a fit: of each experiment the loop and the residuals, then of each
/// table.
std::vector<std::string> fit_picture_names(const Fit& fit, std::string_view stem);

/// Draws with gnuplot, into `folder`, under names that start with `stem`:
///   `STEM.EXPERIMENT.loop.svg`       measured, before and after, over time and over the position
///   `STEM.EXPERIMENT.residuals.svg`  what is left, over time and as a histogram
///   `STEM.TABLE.table.svg`           ordinates before and after with their intervals
/// The first two are drawn of the first 20 experiments, which is told. Characters of a name that do
/// not belong into a file's name become '-'. A picture that does not come about is a note, no
/// failure: the page has the same curves; one that would take the place of what must stay is not
/// drawn.
FitPictures draw_fit_pictures(const Fit& fit, const Calibration& calibration,
                              const std::filesystem::path& folder, std::string_view stem,
                              const base::Overwriting& overwriting = {});

}  // namespace slipbench::driver::calibrate
