// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/base/units/units.hpp"

namespace slipbench::driver::cases {

struct Case;

/// The dimension of a quantity of the flat numbering of quantity.hpp; none for a field.
base::Dimension dimension_of(int quantity);
/// The same in a case, which knows what the load on its driver is.
base::Dimension dimension_of(const Case& problem, int quantity);

}  // namespace slipbench::driver::cases
