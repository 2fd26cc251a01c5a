// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/base/text/source_text.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/calibrate/fit.hpp"

namespace slipbench::driver::calibrate {

/// Result of reading a fit: the fit, unless there were errors, and all messages.
struct ReadFit {
  std::optional<Fit> value;
  base::Diagnostics diagnostics;          ///< of the fit, and of its cases under their own names
  std::vector<base::SourceText> sources;  ///< texts the diagnostics quote from: the fit, the cases
  /// Every file that the fit and its cases name: none of them may be overwritten. The fit itself is
  /// not among them.
  std::vector<std::string> data_files;
  bool environment_failure = false;  ///< some error is the machine's (exit 4), not the text's
};

struct ReadFitOptions {
  /// --set name=value, for every case that has a parameter of the name; stronger than an
  /// experiment's own `set`.
  std::vector<base::ParameterText> overrides = {};
  bool allow_outside = false;  ///< cases and data may lie outside the fit's folder
};

/// Reads, binds and checks a fit file, the cases it names (at the start values of what is varied)
/// and the headers of its data files. All errors are collected. The data's numbers are read by
/// read_measurements.
ReadFit read_fit(const std::string& path, const ReadFitOptions& options = {});

}  // namespace slipbench::driver::calibrate
