// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/case/case.hpp"
#include "driver/check/verdict.hpp"

namespace slipbench::driver::check {

/// The check's line in the results of `run` and `check`: its name, and the worst deviation or what
/// is wrong.
std::string verdict_text(const cases::Check& check, const Verdict& verdict);

/// "worst 2.1e-15 of 1e-12" (both relative), or "worst 0.41 of its tolerance".
std::string worst_text(const cases::Check& check, const Verdict& verdict);

}  // namespace slipbench::driver::check
