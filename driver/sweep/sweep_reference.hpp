// SPDX-License-Identifier: Apache-2.0
// Texts generated from the declarations of sweep files.
#pragma once

#include <string>
#include <vector>

#include "driver/yaml/binding.hpp"

namespace slipbench::driver::sweep {

/// One row for every key of a sweep file, in the order of the declarations.
std::vector<yaml::KeyRow> sweep_rows();

/// JSON Schema (draft 2020-12) of a sweep file.
yaml::Json sweep_schema();

/// The section on sweep files of the case reference, as Markdown.
std::string sweep_reference_markdown();

/// Words of messages about the keys of a sweep.
extern const yaml::FileWords kSweepWords;

}  // namespace slipbench::driver::sweep
