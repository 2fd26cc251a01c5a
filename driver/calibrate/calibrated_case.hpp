// SPDX-License-Identifier: Apache-2.0
// The user's own case with the numbers that were found.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "driver/base/files/file_mark.hpp"
#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// A case as the user wrote it, with other numbers.
struct CalibratedCase {
  std::string file_name;                 ///< loop.calibrated.yaml, for the output folder
  std::string text;                      ///< with the provenance as comments at the top
  std::vector<std::size_t> experiments;  ///< in Fit::experiments, that it stands for
  std::vector<std::string> notes;        ///< sentences: what the user should know of the file
};

struct CalibratedCases {
  std::vector<CalibratedCase> cases;
  std::vector<std::string> faults;  ///< cases that could not be written: a sentence each
};

/// The mark of a case that was calibrated by a fit.
base::FileMark calibrated_case_mark(const Fit& fit);

/// The names of the files of calibrated_cases.
std::vector<std::string> calibrated_case_names(const Fit& fit);

/// One case for each case file and `set:` of the fitted experiments: its text with parameters,
/// ordinates of tables and `set:` values replaced in place, layout, comments and line ends kept (a
/// byte order mark is not). Numbers are
/// the shortest text that reads back to the same double. Expressions that were replaced are kept in
/// the comments; a table from a file becomes rows. Paths of data files are rewritten for `folder`.
/// A text is returned only if it reads back to the same case with these values.
/// \param folder where the cases are going to be
CalibratedCases calibrated_cases(const Fit& fit, const Calibration& calibration,
                                 const std::filesystem::path& folder);

}  // namespace slipbench::driver::calibrate
