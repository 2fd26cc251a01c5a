// SPDX-License-Identifier: Apache-2.0
#include "driver/history/profile.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace slipbench::driver::history {

tl::expected<ExpressionProfile, base::ExpressionError> compile_profile(
    std::string_view text, const base::NamedNumbers& parameters) {
  static const std::array<std::string, 2> variables = {"t", "T"};
  auto expression = base::Expression::compile(text, variables, parameters);
  if (!expression) return tl::unexpected(std::move(expression.error()));
  return ExpressionProfile{std::move(*expression)};
}

std::optional<std::string> violation(const Tabular& table) {
  if (table.times.size() != table.values.size()) {
    return fmt::format("{} times but {} values", table.times.size(), table.values.size());
  }
  if (table.times.size() < 2) {
    return fmt::format("{} point{}; two or more are wanted", table.times.size(),
                       table.times.size() == 1 ? "" : "s");
  }
  for (std::size_t i = 0; i < table.times.size(); ++i) {
    if (!std::isfinite(table.times[i]) || !std::isfinite(table.values[i])) {
      return fmt::format("point {} is not finite", i + 1);
    }
    if (i > 0 && !(table.times[i] > table.times[i - 1])) {
      return fmt::format("the times do not increase: point {} at {} after point {} at {}", i + 1,
                         table.times[i], i, table.times[i - 1]);
    }
  }
  return std::nullopt;
}

std::optional<std::string> violation(const Wave& wave) {
  if (!(wave.period > 0.0) || !std::isfinite(wave.period)) {
    return fmt::format("the period must be positive, not {}", wave.period);
  }
  if (!std::isfinite(wave.amplitude) || !std::isfinite(wave.mean) || !std::isfinite(wave.phase)) {
    return "amplitude, mean and phase must be finite";
  }
  // Beyond it the corners of a wave have no digits left.
  constexpr double kMostPhase = 1e9;
  if (std::abs(wave.phase) > kMostPhase) {
    return fmt::format("the phase {} is more than a billion radians", wave.phase);
  }
  return std::nullopt;
}

bool covers(const Tabular& table, double duration) {
  const double slack = kCoverageSlack * duration;
  return !table.times.empty() && table.times.front() <= slack &&
         table.times.back() >= duration - slack;
}

}  // namespace slipbench::driver::history
