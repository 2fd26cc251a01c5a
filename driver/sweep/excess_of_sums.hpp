// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Says how far the sums that a sweep is to keep of what it varies and collects go beyond what
/// memory should hold; nothing if they do not.
std::optional<std::string> excess_of_sums(const Sweep& sweep);

}  // namespace slipbench::driver::sweep
