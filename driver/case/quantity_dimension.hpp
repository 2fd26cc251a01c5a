// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/history/units.hpp"

namespace slipbench::driver {

/// The dimension of a quantity of the flat numbering of quantity.hpp; none for a field.
Dimension dimension_of(int quantity);

}  // namespace slipbench::driver
