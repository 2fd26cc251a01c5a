// SPDX-License-Identifier: Apache-2.0
#include "driver/export/run_range.hpp"

#include <algorithm>

#include "driver/bench/run_case.hpp"
#include "driver/export/loss.hpp"

namespace slipbench::driver::exports {

RunRange run_range(const cases::Case& problem) {
  RunRange range;
  bool first = true;
  const auto ended = bench::run_case(problem, [&](const bench::Row& row) {
    if (first) {
      range.temperature = row.quantities[cases::kTemperatureQuantity];
      const auto* const fields = row.quantities.begin() + cases::kFirstField;
      range.fields.assign(fields, fields + law::kMaxFields);
    }
    if (range.duration == 0.0) range.duration = row.duration;
    for (const bench::DefinitionRow& one : row.definitions) {
      const double force = one.update.normal_force;
      range.slip_rate = std::max({range.slip_rate, one.update.slip_rate, one.penalty.speed});
      range.contact_force = std::max(range.contact_force, force);
      range.least_contact_force = first ? force : std::min(range.least_contact_force, force);
      first = false;
    }
  });
  if (!ended) throw NotExported{"the case does not run to its end: " + ended.error().message};
  return range;
}

}  // namespace slipbench::driver::exports
