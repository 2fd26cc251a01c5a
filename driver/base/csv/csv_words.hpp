// SPDX-License-Identifier: Apache-2.0
// Sentences about the text of a CSV file.
#pragma once

#include <string>
#include <string_view>

#include "driver/base/csv/data_source.hpp"

namespace slipbench::driver::base {

/// "holds '1,5' with a decimal comma; the decimal mark is '.'": why a field is no number.
std::string not_a_number(std::string_view text, char decimal);

/// Tells whether marks may stand between thousands: in "1.100" and "12,345,678", not in "0.125".
bool may_be_thousands(std::string_view text, char mark);

/// "tab", "';'".
std::string_view separator_name(char separator);

/// The remedy for an empty last column.
std::string take_away(char separator);

}  // namespace slipbench::driver::base
