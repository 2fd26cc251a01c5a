// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>

#include "driver/analysis/side_by_side.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::analysis {

/// Distance between the responses of two cases with the same definitions and history, as of a case
/// and what came of it in another program's words.
struct ResponseDifference {
  ForceDistance force;       ///< of all definitions together [F], [F L]
  double dissipation = 0.0;  ///< of the first case at its end [F L]
  double other_dissipation = 0.0;
  double creep = 0.0;  ///< dissipated slip below the limit, of all definitions [L]
  double other_creep = 0.0;
  std::size_t unmatched = 0;  ///< rows of the first case at whose time the other has none

  bool is_none() const {
    return force.most == 0.0 && dissipation == other_dissipation && unmatched == 0;
  }
};

/// Runs both. Error: one does not run to its end, or they have not as many definitions.
tl::expected<ResponseDifference, std::string> compare_responses(const cases::Case& one,
                                                                const cases::Case& other);

/// Tells a difference in a sentence: "friction force off by at most 0.3 of 812 (0.04 %) at T = 1.2,
/// dissipated energy 0.1 % more, creep of 2e-3 while sticking in place of none".
std::string difference_text(const ResponseDifference& difference);

}  // namespace slipbench::driver::analysis
