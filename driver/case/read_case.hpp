// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/history/parameters.hpp"
#include "driver/text/source_text.hpp"

namespace slipbench::driver {

/// What reading a case gave: the case, unless there were errors, and everything there is to say.
struct ReadCase {
  std::optional<Case> value;
  Diagnostics diagnostics;
  std::vector<std::string> data_files;  ///< that the case names, also one with errors
  std::vector<SourceText> sources;      ///< texts the diagnostics quote from
  bool environment_failure =
      false;  ///< some error is the machine's (exit 4), not the text's (exit 2)
};

struct ReadOptions {
  std::vector<ParameterText> overrides = {};  ///< --set name=value
  bool allow_outside = false;                 ///< data files may lie outside the case's folder
  bool curves_may_be_missing = false;         ///< reference curves are about to be made
};

/// Reads, binds and checks a case file. All errors of the file are collected.
ReadCase read_case(const std::string& path, const ReadOptions& options = {});

/// The same from a text in memory; data files are looked for in `folder`.
ReadCase read_case_text(const SourceText& source, const std::string& folder,
                        const ReadOptions& options = {});

}  // namespace slipbench::driver
