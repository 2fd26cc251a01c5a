// SPDX-License-Identifier: Apache-2.0
// Digits of the numbers that go to gnuplot, and that it writes.
#pragma once

#include <string>

namespace slipbench::driver::plot {

/// Significant digits that divide a range of numbers into parts finer than a picture can show, also
/// where the range is small against the numbers themselves.
int drawn_digits(double lowest, double highest);

/// gnuplot's format of tics that divide a range: "% h", which has six digits, or one with as many
/// digits as tell them apart.
std::string tic_format(double lowest, double highest);

/// A distance of tics (tic_step) for an axis below a panel that has room for `parts` short numbers;
/// of numbers with exponents, or of many digits, it has room for fewer.
double wide_tic_step(double lowest, double highest, double parts);

}  // namespace slipbench::driver::plot
