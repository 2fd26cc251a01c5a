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

}  // namespace slipbench::driver::commands
