// SPDX-License-Identifier: Apache-2.0
// Which files belong to one run: its JSON lists them, so that files of two runs that came to lie
// beside each other are not taken for one.
#pragma once

#include <filesystem>
#include <span>

#include "driver/base/files/output_file.hpp"
#include "driver/base/text/json.hpp"
#include "driver/yaml/node.hpp"

namespace slipbench::driver::results {

/// Lists files that are closed: name, and of a CSV file the hash of its bytes (StreamHash, 16
/// hexadecimal digits).
base::json::Value list_of_files(std::span<const base::OutputFile* const> files);

/// Tells whether a file has the bytes of one that the JSON of a run lists. One that lists none, as
/// versions before this list wrote it, may be of any.
bool is_listed(const yaml::Node& json, const std::filesystem::path& file);

}  // namespace slipbench::driver::results
