// SPDX-License-Identifier: Apache-2.0
// Friction of a case for programs that prescribe motions and forces themselves.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/export/loss.hpp"

namespace slipbench::driver::exports {

/// Numbers of a connector's definitions, as law::pack_all gives them, and how much of the case they
/// hold.
struct LawNumbers {
  std::vector<double> numbers;
  std::vector<Loss> losses;
};

/// Packs the definitions of a case.
/// \return a sentence where the friction wants more than a law
tl::expected<LawNumbers, std::string> law_numbers(const cases::Case& problem);

/// Writes how many numbers there are and then each, a line each, so that they are read back in all
/// bits.
std::string numbers_text(const std::vector<double>& numbers);

}  // namespace slipbench::driver::exports
