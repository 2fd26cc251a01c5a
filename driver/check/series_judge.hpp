// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/check/check_labels.hpp"
#include "driver/check/criteria/point_judge.hpp"
#include "driver/check/curves/series.hpp"
#include "driver/check/verdict.hpp"

namespace slipbench::driver::check {

/// The rows of a run that a check compares.
struct ComparedRows {
  Series value;                    ///< with times
  cases::SharedNumbers reference;  ///< at the same rows; empty against a curve
  /// Of the quantity's definition at each row, see CausePoint.
  std::vector<std::int8_t> status;
};

/// The reference at these rows as a curve.
Series reference_of(const ComparedRows& rows);

/// Digits to which the numbers of a reference are known.
struct ReferenceDigits {
  /// Half a unit of the last printed digit, if it was printed with fewer than it has.
  std::optional<double> resolution;
  bool golden = false;  ///< of this program's own past
};

/// The verdict of a judge that has seen all points: message, likely cause and warnings.
/// \param rows where the status of the points is to be found, unless the judge was told
void conclude(const cases::Check& check, const CheckLabels& labels, const PointJudge& judge,
              const ReferenceDigits& digits, Verdict& verdict, const ComparedRows* rows = nullptr);

/// Judges a check whose rows were kept, by any criterion. Against a curve, its file is read here; a
/// fault of it is the check's failure.
void judge_rows(const cases::Check& check, const CheckLabels& labels, const ComparedRows& rows,
                Verdict& verdict);

}  // namespace slipbench::driver::check
