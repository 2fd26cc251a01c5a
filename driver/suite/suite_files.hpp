// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/suite/candidates.hpp"

namespace slipbench::driver::suite {

/// Files that the verdicts of a suite go to beside the terminal; empty for nowhere.
struct SuiteTargets {
  std::string junit;
  std::string json;
  std::string report;
  bool force = false;  ///< whether they may take the place of files that are no verdicts
};

/// The first of the targets that is one of the files that are read, in a sentence, or nothing.
std::string overwritten_input(const SuiteTargets& targets, std::span<const std::string> inputs);

struct SuiteFilesFault {
  int code = 0;
  std::string message;
};

/// The files of verdicts. They are created before a suite begins, so that a place that cannot be
/// written to is known before the work and not after it, and are committed at its end.
struct SuiteFiles {
  std::optional<base::OutputFile> junit;
  std::optional<base::OutputFile> json;

  /// The page is written by others (`write_report`); here it is only tried whether it can be.
  /// Errors: "-", or two targets that are the same file (exit code 2); a target that is one of the
  /// cases, and those of OutputFile (exit code 4). What else the cases are read from is known only
  /// after reading, see `overwritten_input`.
  static tl::expected<SuiteFiles, SuiteFilesFault> create(const SuiteTargets& targets,
                                                          std::span<const Candidate> cases);

  /// Those that are wanted.
  std::vector<base::OutputFile*> all();
};

}  // namespace slipbench::driver::suite
