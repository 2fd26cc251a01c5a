// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <tl/expected.hpp>

#include "driver/base/text/history_error.hpp"

namespace slipbench::driver::base {

/// Standard input as a regular file, which may be opened again and again: readers of data look at
/// a file's start first, and a step that repeats reads it anew. It is read to its end, into memory,
/// by the first call; safe for threads. Errors are of the kind kEnvironment.
tl::expected<std::filesystem::path, HistoryError> standard_input_file();

}  // namespace slipbench::driver::base
