// SPDX-License-Identifier: Apache-2.0
// Sentences of failed checks.
#pragma once

#include <string>

#include "driver/check/check_labels.hpp"
#include "driver/check/criteria/point_judge.hpp"
#include "driver/check/verdict.hpp"

namespace slipbench::driver::check {

/// "CSF2 off by 3.1 N (limit 0.5) at t = 0.84, first at 0.8, last at 0.9, 41 of 400 points"; over
/// another abscissa the worst point is "at CU1 = 0.02 mm (t = 0.84)".
std::string points_message(const cases::Check& check, const PointJudge::Result& result,
                           std::int64_t compared, const CheckLabels& labels);

/// "energy of loop 2: 12.1 mJ instead of 11.0 (limit 0.5); ..." for the measures that fail.
/// \param result the compared rows of the run
std::string measures_message(const Verdict& verdict, const CheckLabels& labels,
                             const Series& result);

}  // namespace slipbench::driver::check
