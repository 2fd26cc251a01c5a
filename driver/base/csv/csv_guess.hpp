// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "driver/base/csv/data_source.hpp"

namespace slipbench::driver::base {

/// The format in which the start of a file makes sense: a header with the columns `wanted` (of two
/// names or more if none are), below it rows with a number or nothing in each of them. That which
/// skips the fewest lines, and is nearest to `now`.
/// \param head the file's first lines; the last may be cut off
/// \return nothing if there is none, or it is `now`
std::optional<CsvFormat> guess_format(std::string_view head, const CsvFormat& now,
                                      std::span<const std::string> wanted);

}  // namespace slipbench::driver::base
