// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "driver/base/files/file_mark.hpp"
#include "driver/base/text/json.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::results {

/// The program's version, e.g. "0.1.0".
std::string_view program_version();

/// The file name of a case without its folders: results do not depend on where they were made.
std::string case_name(const cases::Case& problem);

/// The file name of a case without folders and extension: what its results are named after.
std::string case_stem(const cases::Case& problem);

/// Returns where a result comes from, as lines that start with "# ": program, case, title, units
/// and parameter values. No date, no machine: the same input gives the same bytes.
std::string provenance_lines(const cases::Case& problem);

/// The same as a JSON object.
base::json::Value provenance(const cases::Case& problem);

/// The mark of a file that begins with provenance_lines, or, if it is JSON, with provenance.
base::FileMark result_mark(const cases::Case& problem, bool is_json);

}  // namespace slipbench::driver::results
