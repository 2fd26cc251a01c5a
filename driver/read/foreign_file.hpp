// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/source_text.hpp"

namespace slipbench::driver::read {

/// Returns what a file is that was given as a case and is none by its first lines: a Radioss deck,
/// an Abaqus input file, or numbers in columns, such as a result; with what to do instead. Nothing
/// if it may be a case.
std::optional<base::Diagnostic> foreign_file(const base::SourceText& source);

}  // namespace slipbench::driver::read
