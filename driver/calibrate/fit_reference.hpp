// SPDX-License-Identifier: Apache-2.0
// Texts generated from the declarations of fit files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "driver/yaml/binding.hpp"

namespace slipbench::driver::calibrate {

/// One row for every key of a fit file, in the order of the declarations; the keys of experiments
/// that are held out are those of experiments and listed once.
std::vector<yaml::KeyRow> fit_rows();

/// JSON Schema (draft 2020-12) of a fit file.
yaml::Json fit_schema();

/// The section on fit files of the case reference, as Markdown.
std::string fit_reference_markdown();

/// Words of messages about the keys of a fit.
extern const yaml::FileWords kFitWords;

}  // namespace slipbench::driver::calibrate
