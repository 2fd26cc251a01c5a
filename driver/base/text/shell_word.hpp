// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::base {

/// Returns a word as a POSIX shell reads it back: in single quotes where it needs some.
std::string shell_word(std::string_view word);

}  // namespace slipbench::driver::base
