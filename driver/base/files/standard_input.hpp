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

/// Makes every later call of it an error of the kind kInput: nobody who has a folder searched means
/// to feed a case in it, and one that waits for an open pipe never ends.
void refuse_standard_input();

}  // namespace slipbench::driver::base
