// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace slipbench::driver::report {

/// A series of numbers as a short text for a page (base64): smooth series take about two characters
/// a number, constant ones next to none. Every number becomes a decimal k/10^d, so that the page
/// has the very double that the same decimal text would give.
///
/// The bytes are variable-length unsigned integers (seven bits a byte, the lowest first, all but
/// the last with the highest bit). Every kPackedBlock numbers begin with the change of d; signed
/// integers are folded (0, -1, 1, -2, ..). Then, of k minus what a straight line through the two
/// numbers before it gives: 0 and a count for so many zeros, 1 for a number that is not finite (and
/// is passed over by the line), else the folded difference plus one. Where d changes, the two
/// numbers before are rounded to it, or taken as 0 where that needs more than fifteen digits.
///
/// \param decimals d, the same for all: the numbers are told to within 10^-d / 2
std::string packed_numbers(std::span<const double> numbers, int decimals);

/// The same with as many decimals in each block as keep its shape: a millionth of the range of all
/// numbers, and a thousandth of the block's usual step (those below 1e-8 of the range are none);
/// never more than kMostDigits significant digits.
std::string packed_series(std::span<const double> numbers);

inline constexpr std::size_t kPackedBlock = 64;

/// The number rounded to so many decimals, as the page has it after packed_numbers().
double to_decimals(double number, int decimals);

/// Decimals that tell numbers up to `largest` in size to within `resolution` > 0: half of the last
/// one is no more.
int decimals_within(double resolution, double largest);

}  // namespace slipbench::driver::report
