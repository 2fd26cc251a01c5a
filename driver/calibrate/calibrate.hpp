// SPDX-License-Identifier: Apache-2.0
// The fit itself: from a fit file that was read to what it found.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "driver/base/files/exit_code.hpp"
#include "driver/calibrate/calibration.hpp"
#include "driver/calibrate/fit.hpp"

namespace slipbench::driver::calibrate {

/// Progress of a fit, to show while it runs.
struct CalibrateStep {
  const char* stage = "";  ///< "search", "resamplings", "profiles", ...
  long evaluations = 0;    ///< of the model so far, runs with derivatives among them
  double cost = 0.0;       ///< of the latest one
};
struct CalibrateProgress {
  std::function<void(const CalibrateStep&)> step = {};  ///< may be empty; called by one thread
};

/// Reason why there is no fit at all; a search that did not converge is a Calibration, too.
struct CalibrationFailure {
  int code = base::kExitBadInput;  ///< for the shell: base::kExitBadInput, base::kExitNumerical or
                                   ///< base::kExitEnvironment
  std::string message;             ///< with its place where a file is at fault
};

struct CalibrateSettings {
  /// For runs that do not depend on one another; 0: as many as cores.
  unsigned threads = 0;
  bool with_hashes = true;   ///< of the data files; only for what is written
  fit::RunItems items = {};  ///< starts, resamplings and profiles, which programs may share
};

/// Fits the cases to the data: the given start, the search, statistics, and the values before and
/// after of every experiment, held-out ones included (docs/theory, section 17). The same fit
/// gives the same bits, whatever the number of threads.
/// Errors: faulty data, cases that have no run at the start values, nothing left to compare.
tl::expected<Calibration, CalibrationFailure> calibrate(const Fit& fit,
                                                        const CalibrateProgress& progress = {},
                                                        const CalibrateSettings& settings = {});

}  // namespace slipbench::driver::calibrate
