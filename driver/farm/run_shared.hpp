// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "driver/farm/run_farm.hpp"

namespace slipbench::driver::farm {

/// Runs items 0 .. count - 1, each on some rank, and returns on all ranks what each made, in their
/// order. All ranks call it together.
/// \param item makes some numbers; is asked in ascending order
std::vector<std::vector<double>> run_shared(
    const Farm& farm, std::size_t count,
    const std::function<std::vector<double>(std::size_t)>& item);

}  // namespace slipbench::driver::farm
