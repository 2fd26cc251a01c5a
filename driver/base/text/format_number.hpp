// SPDX-License-Identifier: Apache-2.0
// Numbers as text for files: the same double always gives the same bytes, and back.
#pragma once

#include <span>
#include <string>

namespace slipbench::driver::base {

/// The shortest text that reads back to the same double, with '.' whatever the locale: "0.1",
/// "1e+300", "-0" (the sign of a zero is part of the value). Not-a-number is "nan", infinities are
/// "inf" and "-inf".
[[nodiscard]] std::string format_number(double value);

/// As format_number, appended to a text that grows: for writing many numbers.
void append_number(std::string& text, double value);
/// The same of several, each with a comma behind it.
void append_numbers(std::string& text, std::span<const double> values);

/// Returns the number of so many digits, 1 to 17, that is nearest to another one.
[[nodiscard]] double rounded_number(double value, int digits);

}  // namespace slipbench::driver::base
