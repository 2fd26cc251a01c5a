// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::base {

/// A name as a part of a file's name: what is neither a letter, a digit nor one of _.-+ becomes
/// '-'; other scripts stay as they are. Never empty, and no hidden file.
std::string file_part(std::string_view name);

}  // namespace slipbench::driver::base
