// SPDX-License-Identifier: Apache-2.0
#include "driver/check/verdict_text.hpp"

#include <fmt/format.h>

namespace slipbench::driver::check {

std::string worst_text(const cases::Check& check, const Verdict& verdict) {
  const cases::Tolerance& tolerance = check.tolerance;
  if (tolerance.relative && !tolerance.absolute && verdict.scale > 0.0) {
    return fmt::format("worst {:.2g} of {:.2g}", verdict.worst_deviation() / verdict.scale,
                       *tolerance.relative);
  }
  return fmt::format("worst {:.2g} of its tolerance", verdict.worst_fraction());
}

std::string verdict_text(const cases::Check& check, const Verdict& verdict) {
  return fmt::format("check '{}': {}", check.name,
                     verdict.passed ? worst_text(check, verdict) : verdict.message);
}

}  // namespace slipbench::driver::check
