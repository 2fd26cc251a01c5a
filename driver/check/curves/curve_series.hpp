// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// A reference curve in the case's units.
struct ReferenceCurve {
  Series series;                     ///< with times where they are known
  std::optional<double> resolution;  ///< half a unit of its value's last printed digit
  bool golden = false;               ///< made by this program
};

/// The curve that `check` names. Of a curve over time, the part within the check's `over:`; of a
/// golden one, whose times are those of its case, also that of the check's step: the part between
/// the first and the last time of `result`, the selected rows of the run. The part begins and ends
/// between rows, but for a pointwise check, which compares the rows within.
///
/// Errors, in a sentence: a file that cannot be read or is faulty, a column it does not have, a
/// golden curve that is not over the times of `result` (it may go on before and behind what the
/// check selects), a number that the change of unit makes infinite, no row left, a single row left
/// of several while the result has several.
tl::expected<ReferenceCurve, std::string> reference_curve(const cases::Check& check,
                                                          const Series& result);

/// Tells a file which of its columns a check against it will ask for.
void want_columns(cases::CurveFile& file, const cases::Check& check);

}  // namespace slipbench::driver::check
