// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/loss_report.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::commands {
namespace {

using Kind = import::Loss::Kind;

constexpr std::array kKinds{std::pair<Kind, std::string_view>{Kind::kApproximated, "approximated"},
                            std::pair<Kind, std::string_view>{Kind::kDropped, "dropped"},
                            std::pair<Kind, std::string_view>{Kind::kKept, "kept"}};

}  // namespace

std::string loss_report(const std::vector<import::Loss>& losses) {
  std::string text;
  for (const auto& [kind, name] : kKinds) {
    for (const import::Loss& one : losses) {
      if (one.kind == kind) text += fmt::format("  {}: {}\n", name, base::printable(one.text));
    }
  }
  return text;
}

base::json::Value loss_json(const std::vector<import::Loss>& losses) {
  base::json::Value value;
  for (const auto& [kind, name] : kKinds) {
    value[name] = base::json::Array{};
    for (const import::Loss& one : losses) {
      if (one.kind == kind) value[name].push_back(one.text);
    }
  }
  return value;
}

std::string difference_line(const MeasuredDifference& difference) {
  return "  on the case's history: " +
         (difference ? analysis::difference_text(*difference) : difference.error()) + "\n";
}

base::json::Value difference_json(const MeasuredDifference& difference) {
  base::json::Value value;
  value["text"] = difference ? analysis::difference_text(*difference) : difference.error();
  if (!difference) return value;
  value["force_most"] = difference->force.most;
  value["force_largest"] = difference->force.largest;
  value["time"] = difference->force.time;
  value["dissipation"] = difference->dissipation;
  value["other_dissipation"] = difference->other_dissipation;
  value["creep"] = difference->creep;
  value["other_creep"] = difference->other_creep;
  value["rows_without_counterpart"] = difference->unmatched;
  return value;
}

}  // namespace slipbench::driver::commands
