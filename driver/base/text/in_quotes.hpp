// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::base {

/// Returns a text of the user for a message: in quotes, what cannot be printed written out.
inline std::string in_quotes(std::string_view text) { return "'" + printable(text) + "'"; }

}  // namespace slipbench::driver::base
