// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::report {

/// Returns a text as it stands in HTML, in an element or an attribute in double quotes.
std::string escape_html(std::string_view text);

}  // namespace slipbench::driver::report
