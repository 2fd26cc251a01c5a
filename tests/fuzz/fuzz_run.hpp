// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"

namespace slipbench::fuzz {

/// Runs the first increments of a case and judges its checks by them.
void run_briefly(const driver::cases::Case& problem);

}  // namespace slipbench::fuzz
