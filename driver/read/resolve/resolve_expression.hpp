// SPDX-License-Identifier: Apache-2.0
// Expressions of checks: over those names of the result that they use.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// An expression over those of `variables` that it uses.
/// \param text anything with a node, a path and `sound`: At<std::string>, Named<std::string>
template <class Text>
std::optional<cases::ExpressionReference> compile_expression(
    yaml::Binder& binder, const Text& text, const std::vector<std::string>& variables) {
  if (!text.sound) return std::nullopt;
  auto first = binder.expression(*text.node, text.path, variables);
  if (!first) return std::nullopt;
  std::vector<std::string> used(first->used_variables().begin(), first->used_variables().end());
  auto again = binder.expression(*text.node, text.path, used);
  if (!again) return std::nullopt;
  return cases::ExpressionReference{std::move(*again), std::move(used)};
}

/// The expression that is a result column, or a number, and nothing else.
inline std::optional<cases::ExpressionReference> plain_expression(
    const std::string& text, std::vector<std::string> variables) {
  auto expression = base::Expression::compile(text, variables);
  if (!expression) return std::nullopt;
  return cases::ExpressionReference{std::move(*expression), std::move(variables)};
}

}  // namespace slipbench::driver::read
