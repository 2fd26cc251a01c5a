// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>

#include "driver/base/text/json.hpp"

namespace slipbench::driver::report {

/// The bench that a page carries along, so that its cases can be changed and run there.
struct LiveBench {
  std::string page_part;      ///< as scripts/wasm.sh built it, HTML
  base::json::Array files{};  ///< of each case the texts of its data files by name
};

/// Returns the texts of data files by their names in the case that names them; those that do not
/// lie in or below its folder are left out.
base::json::Value file_texts(const std::string& case_path, std::span<const std::string> files);

/// Reads the bench that stands beside the program. Error: there is none; a sentence.
tl::expected<LiveBench, std::string> read_live_bench();

}  // namespace slipbench::driver::report
