// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::fit {

bool is_convergence(StopReason reason) {
  return reason == StopReason::kStep || reason == StopReason::kGradient ||
         reason == StopReason::kCost;
}

std::string stop_text(StopReason reason) {
  switch (reason) {
    case StopReason::kStep:
      return "another step would not change the unknowns any more";
    case StopReason::kGradient:
      return "the gradient is zero to its tolerance";
    case StopReason::kCost:
      return "what could still be gained is below rounding";
    case StopReason::kIterations:
      return "the most iterations allowed are used up; allow more (stop: "
             "iterations), or start from the values reached";
    case StopReason::kNoProgress:
      return "no step lowers the cost any more, though the gradient is not zero. A "
             "kink of the model is likely (a point that just begins to slip), or derivatives that "
             "are not those of the model: try other starts (multistart), fewer unknowns, or finer "
             "steps of the case";
    case StopReason::kZeroGradient:
      return "nothing that is varied changes any compared value at the start. Look "
             "at the start values (does anything slip?), at the time range, and at whether the "
             "compared quantities depend on what is varied";
    case StopReason::kNoIteration:
      return "not a single step was gained from the start, so nothing was learnt. "
             "The start may already be the minimum, or a kink of the model: start from other "
             "values and see whether the search comes back";
    case StopReason::kModelFailure:
      return "the model has no value at the start; run the case with the start "
             "values by itself";
    case StopReason::kTooFewData:
      return "fewer values are compared than unknowns are varied; compare more, or "
             "vary less";
    case StopReason::kSilent:
      return "an unknown that changes the compared values elsewhere changes none of them at the "
             "values found: there everything sticks, or everything slips. Start it nearer, or "
             "compare several starts (multistart: 8); if the data cannot tell it, do not vary it";
  }
  return {};
}

}  // namespace slipbench::driver::fit
