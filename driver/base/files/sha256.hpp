// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/text/history_error.hpp"

namespace slipbench::driver::base {

/// SHA-256 (FIPS 180-4) of a file's bytes, 64 hexadecimal digits in lower case: the fingerprint by
/// which a calibration names its data. Errors of the kind kEnvironment: it cannot be read.
tl::expected<std::string, HistoryError> sha256_of_file(const std::filesystem::path& file);

/// The same of a text.
std::string sha256_of(std::string_view text);

}  // namespace slipbench::driver::base
