// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/carried_unit.hpp"

#include <fmt/format.h>

#include <cmath>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/number.hpp"

namespace slipbench::driver::base {

bool carries_unit(std::string_view text) { return split_unit(text).has_value(); }

std::string misfit(std::string_view text, const Dimension& unit, const Dimension& wanted,
                   const UnitSystem& system) {
  return fmt::format("'{}' is {}: {}", printable(text), in_words(unit),
                     wanted_in_words(wanted, system));
}

std::string shifted_in_words(std::string_view text, const CarriedUnit& read,
                             const UnitSystem& system) {
  const std::string unit = unit_text(read.dimension, system);
  return fmt::format("'{}' is taken as the temperature {:.9g} {}; a difference is written in {}",
                     printable(text), read.value, unit, unit);
}

tl::expected<CarriedUnit, std::string> read_with_unit(std::string_view text,
                                                      const std::optional<Dimension>& wanted,
                                                      const UnitSystem& system, bool difference) {
  const auto fault = [&](std::string_view why) {
    return tl::make_unexpected(fmt::format("'{}': {}", printable(text), why));
  };
  const NumberAndUnit parts = *split_unit(text);
  const auto number = parse_number(parts.number);
  if (!number) return fault(number.error());
  const auto dimension = dimension_of_unit(parts.unit);
  if (!dimension) return fault(dimension.error().message);
  if (*dimension == Dimension{}) return fault(fmt::format("'{}' is no unit", parts.unit));
  if (wanted && !measures(*dimension, *wanted)) {
    return tl::make_unexpected(misfit(text, *dimension, *wanted, system));
  }
  const auto conversion = conversion_to_case(parts.unit, *dimension, system);
  if (!conversion) return fault(conversion.error().message);
  const double value = difference ? conversion->scale * *number : (*conversion)(*number);
  if (!std::isfinite(value)) return fault("is too large for a double in the case's units");
  return CarriedUnit{value, *dimension, !difference && conversion->offset != 0.0};
}

}  // namespace slipbench::driver::base
