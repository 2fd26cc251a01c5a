// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/packed_numbers.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "driver/results/columns.hpp"

namespace slipbench::driver::sweep {
namespace {

/// Returns the name of a quantity that is a column and nothing else.
std::optional<std::string_view> only_column(const Collected& collected) {
  if (!collected.quantity || collected.variables.size() != 1) return std::nullopt;
  std::string_view text = collected.quantity->text();
  while (!text.empty() && (text.front() == '=' || text.front() == ' ')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (text != collected.variables.front()) return std::nullopt;
  return collected.variables.front();
}

std::optional<law::LaneNumber> lane_number(const results::Column& column) {
  using law::LaneNumber;
  if (results::is_friction_force(column)) return LaneNumber::kForce;
  if (results::is_accumulated_slip(column)) return LaneNumber::kAccumulatedSlip;
  constexpr std::array<std::pair<std::string_view, LaneNumber>, 4> kNames{
      {{"FLIM", LaneNumber::kLimit},
       {"MU", LaneNumber::kCoefficient},
       {"STATUS", LaneNumber::kRegime},
       {"DISS", LaneNumber::kDissipation}}};
  for (const auto& [name, number] : kNames) {
    if (column.name == name) return number;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PackedNumber> packed_number(const cases::Case& problem, const Collected& collected) {
  using law::Regime;
  if (collected.counted) {
    PackedNumber count{.kind = PackedNumber::Kind::kChanges};
    if (*collected.counted == Counted::kStickToSlip) return count;
    if (*collected.counted != Counted::kSlipToStick) return std::nullopt;
    std::swap(count.from, count.to);
    return count;
  }
  const auto name = only_column(collected);
  if (!name || *name == "t" || *name == "T") return std::nullopt;
  const std::vector<results::Column> columns = results::result_columns(problem);
  const auto column = results::find_column(problem, columns, *name);
  if (!column || column->definition != 0) return std::nullopt;
  const auto number = lane_number(*column);
  if (!number) return std::nullopt;
  PackedNumber packed{.kind = PackedNumber::Kind::kExtreme, .number = *number};
  if (*number == law::LaneNumber::kForce) packed.entry = static_cast<std::size_t>(column->index);
  switch (collected.reduction) {
    case Reduction::kMaximum:
      packed.kept = law::LaneKept::kMaximum;
      return packed;
    case Reduction::kMinimum:
      packed.kept = law::LaneKept::kMinimum;
      return packed;
    case Reduction::kMagnitude:
      packed.kept = law::LaneKept::kMagnitude;
      return packed;
    case Reduction::kLast:
      packed.kind = PackedNumber::Kind::kLast;
      return packed;
    default:
      return std::nullopt;
  }
}

std::optional<std::vector<PackedNumber>> packed_numbers(const Sweep& sweep) {
  std::vector<PackedNumber> numbers;
  for (const Collected& collected : sweep.collected) {
    const auto number = packed_number(sweep.base, collected);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace slipbench::driver::sweep
