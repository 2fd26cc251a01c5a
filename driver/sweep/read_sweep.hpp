// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/base/text/source_text.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Result of reading a sweep: the sweep, unless there were errors, and all messages.
struct ReadSweep {
  std::optional<Sweep> value;
  base::Diagnostics diagnostics;          ///< of the sweep, and of its case under its own name
  std::vector<base::SourceText> sources;  ///< texts the diagnostics quote from
  /// Every file that the sweep and its case name, but for the sweep itself.
  std::vector<std::string> data_files;
  bool environment_failure = false;  ///< some error is the machine's (exit 4), not the text's
};

struct ReadSweepOptions {
  std::vector<base::ParameterText> overrides = {};  ///< --set name=value
  bool allow_outside = false;  ///< the case and its data may lie outside the sweep's folder
};

/// Reads, binds and checks a sweep file and its case, in the middle of what is varied. All errors
/// are collected.
ReadSweep read_sweep(const std::string& path, const ReadSweepOptions& options = {});

/// A case that is read already, with values of its parameters: a list for each, all of one length.
struct GivenSamples {
  read::ParsedCase parsed;
  std::vector<VariedParameter> varied;
};

/// Makes the sweep of samples that a program has in memory.
/// \param collect a map as it stands under 'collect' in a sweep file, in one line
ReadSweep sweep_of_samples(GivenSamples given, const std::string& collect,
                           const ReadSweepOptions& options = {});

}  // namespace slipbench::driver::sweep
