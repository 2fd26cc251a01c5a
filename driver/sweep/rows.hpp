// SPDX-License-Identifier: Apache-2.0
// The file of rows that a sweep, or a part of it, leaves.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"
#include "driver/table/table_head.hpp"

namespace slipbench::driver::sweep {

/// A part of the samples, `number` of `count`, both from 1 on.
struct Part {
  std::size_t number = 1;
  std::size_t count = 1;

  /// The first sample of the part, and the one behind its last, of all samples.
  std::size_t first(std::size_t samples) const { return (number - 1) * samples / count; }
  std::size_t end(std::size_t samples) const { return number * samples / count; }
};

/// Reads "2/8"; nothing if it is none.
std::optional<Part> part_of(std::string_view text);

/// The sweep's file without its folders, for messages and heads.
std::string file_name(const Sweep& sweep);
/// The name of the files of a sweep, or of a part of it, before their ending: "name.2of8".
std::string result_name(const Sweep& sweep, const std::optional<Part>& part);

/// Returns the head of the rows: id, varied parameters, what is collected. A part says which it is,
/// and of what.
table::TableHead rows_head(const Sweep& sweep, const std::string& identity,
                           const std::optional<Part>& part);

/// Reads what was collected from a line; false if it is no line of sample `id`.
bool read_row(std::string_view line, std::size_t id, std::size_t varied, std::span<double> numbers);

}  // namespace slipbench::driver::sweep
