// SPDX-License-Identifier: Apache-2.0
// Estimates as people write them: as many digits as are known.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// The digits of a value that its standard error leaves, and the error to two significant digits:
/// {"0.2310", "0.0020"}, {"4213", "50"}, {"1.235e+09", "1.2e+06"}. At most ten significant digits;
/// without a finite, positive error six digits and "-".
struct ValueAndError {
  std::string value;
  std::string error;
};
ValueAndError value_and_error(double value, double error);

/// "0.2270 .. 0.2350", with the digits that go with the standard error; an end that is open is
/// "-inf" or "inf", and "-" stands for an interval that is not known.
std::string interval_text(double lower, double upper, double error);

/// A number for reading, to four significant digits: "0.01235", "12680", "1.268e+07".
std::string short_number(double value);

/// Returns why a search stopped, without the verdict that the sentence may begin with.
std::string stop_reason_text(const fit::LeastSquaresFit& fit);

/// One unknown as the cells of a table.
struct EstimateText {
  std::string value;
  std::string error;
  std::string interval;
  std::string
      remark;  ///< at a bound, weakly known, never visited; empty if there is nothing to say
};
EstimateText estimate_text(const Calibration& calibration, std::size_t unknown);

/// Costs within this part of one another are the same minimum.
inline constexpr double kSameMinimum = 1e-6;

/// Tells whether a search had a value at all; a cost of one that had none means nothing.
bool has_value(const fit::SearchTrace& search);

/// Tells whether a search ended at the least cost of all.
bool found_the_minimum(const fit::LeastSquaresFit& fit, const fit::SearchTrace& search);

/// "9 of 12 starts found this minimum, the next best has 3.4 times its cost, 2 had no value"; empty
/// for one start.
std::string starts_text(const fit::LeastSquaresFit& fit);

/// An unknown for people: a parameter's name; an ordinate by its knots, "mu at slip_rate 3.5 mm/s",
/// with its table, "sleeve.coefficient.mu at ..", where several are fitted.
std::string told_name(const Calibration& calibration, std::size_t unknown);

/// "good", "weak" or "never_visited": the word of files that programs read.
std::string_view word_of(Identifiability identifiability);

}  // namespace slipbench::driver::calibrate
