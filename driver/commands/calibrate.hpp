// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "driver/calibrate/fit/run_items.hpp"

namespace slipbench::driver::commands {

struct CalibrateOptions {
  std::string file;                   ///< the fit file
  std::string folder = ".";           ///< where the results go
  std::vector<std::string> settings;  ///< --set, for all cases of the fit
  bool allow_outside = false;
  bool no_output = false;        ///< write no files, only tell what was found
  bool force = false;            ///< --force: replace files that are no results of the fit
  std::optional<int> bootstrap;  ///< resamplings; the fit's choice if absent
  bool profile = false;          ///< profile likelihood, whatever the fit says
  std::string report;            ///< an HTML page; empty: `FIT.html` in `folder`
  unsigned threads = 0;          ///< 0: as many as the machine has cores
  fit::RunItems items = {};      ///< of calibrate::CalibrateSettings
  /// Asked when all is read and nothing stands in the way, with the data files; false: nothing is
  /// done after all.
  std::function<bool(const std::vector<std::string>&)> ready = {};
};

/// `slipbench calibrate`: fits parameters and tables of cases to measured data, tells how well they
/// are known, and writes FIT.json, FIT.html, the pictures FIT.NAME.svg and one calibrated case a
/// fitted case, CASE.calibrated.yaml. Returns the exit code: 0 if the fit converged, 3 if not.
int calibrate_command(const CalibrateOptions& options);

}  // namespace slipbench::driver::commands
