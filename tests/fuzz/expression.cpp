// SPDX-License-Identifier: Apache-2.0
// A formula of a case, over some names.
#include "driver/base/units/expression.hpp"

#include <array>
#include <cmath>
#include <string>

#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void expression(std::string_view input) {
  using driver::base::Expression;
  static const std::array<std::string, 3> kVariables = {"t", "CU1", "liner.CSF1"};
  static const driver::base::NamedNumbers kConstants = {{"mu", 0.3}, {"li", 2.0}};
  auto compiled = Expression::compile(input, kVariables, kConstants);
  if (!compiled) {
    want(!compiled.error().message.empty(), "an error has a message");
    want(compiled.error().offset <= static_cast<int>(input.size()), "an error is in the text");
    return;
  }
  const Expression copy = *compiled;
  constexpr std::array<std::array<double, 3>, 4> kPoints = {
      {{0.0, 0.0, 0.0}, {1.0, -2.5, 1e-3}, {1e9, 1e-300, -1e300}, {0.5, 3.0, 7.0}}};
  for (const auto& point : kPoints) {
    const auto value = (*compiled)(point);
    const auto same = copy(point);
    want(value.has_value() == same.has_value(), "a copy has the same value");
    if (!value) continue;
    want(std::isfinite(*value), "a value is a finite number");
    want(*value == *same, "a copy has the same value");
  }
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(expression)
