// SPDX-License-Identifier: Apache-2.0
// The file of rows that a sweep, or a part of it, leaves.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "driver/sweep/part.hpp"
#include "driver/sweep/sweep.hpp"
#include "driver/table/table_head.hpp"

namespace slipbench::driver::sweep {

/// Returns the head of the rows: id, varied parameters, what is collected. A part says which it is,
/// and of what.
table::TableHead rows_head(const Sweep& sweep, const std::string& identity,
                           const std::optional<Part>& part);

/// Reads what was collected from a line; false if it is no line of sample `id` with these values of
/// what is varied.
bool read_row(std::string_view line, std::size_t id, std::span<const double> values,
              std::span<double> numbers);

}  // namespace slipbench::driver::sweep
