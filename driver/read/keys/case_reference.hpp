// SPDX-License-Identifier: Apache-2.0
// Texts generated from the declarations of the case format.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// "F L^-2": the symbols of a dimension; empty for a pure number.
std::string dimension_text(const base::Dimension& dimension);

/// One row for every key of a case file, in the order of the declarations.
std::vector<yaml::KeyRow> case_rows();

/// A table of keys as Markdown: key, what, default, meaning.
std::string key_table(std::span<const yaml::KeyRow> rows);

/// JSON Schema (draft 2020-12) of a case file.
yaml::Json case_schema();

/// The case reference as Markdown: all keys, connection types, coefficient laws, closed forms.
std::string case_reference_markdown();

}  // namespace slipbench::driver::read
