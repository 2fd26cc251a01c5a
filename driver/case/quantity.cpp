// SPDX-License-Identifier: Apache-2.0
#include "driver/case/quantity.hpp"

#include <charconv>

#include "law/base/component.hpp"

namespace slipbench::driver::cases {

std::string component_suffix(int component) {
  return law::is_rotation(component) ? "R" + std::to_string(component - 2)
                                     : std::to_string(component + 1);
}

std::string motion_name(int component) { return "CP" + component_suffix(component); }

std::string force_name(int component) {
  return law::is_rotation(component) ? "m" + std::to_string(component - 2)
                                     : "f" + std::to_string(component + 1);
}

std::string force_column(std::string_view prefix, int component) {
  std::string name(prefix);
  if (law::is_rotation(component)) {
    name.back() = 'M';
    return name + std::to_string(component - 2);
  }
  return name + std::to_string(component + 1);
}

std::string quantity_name(int quantity) {
  if (quantity < kFirstForce) return motion_name(quantity);
  if (quantity < kTemperatureQuantity) return force_name(quantity - kFirstForce);
  if (quantity == kTemperatureQuantity) return "temperature";
  if (quantity < kTensionBehind) return "field" + std::to_string(quantity - kFirstField + 1);
  if (quantity == kTensionBehind) return "f_bc";
  if (quantity == kDriverLoad) return "driver";
  const int coordinate = quantity - kFirstNode;
  return std::string(1, "abc"[coordinate / 3]) + "." + "xyz"[coordinate % 3];
}

std::optional<int> component_of_motion(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  for (int c = 0; c < law::kComponents; ++c) {
    if (name == component_suffix(c)) return c;
  }
  return std::nullopt;
}

std::optional<int> component_of_force(std::string_view name) {
  for (int c = 0; c < law::kComponents; ++c) {
    if (name == force_name(c)) return c;
  }
  return std::nullopt;
}

std::optional<int> field_of(std::string_view name) {
  constexpr std::string_view kPrefix = "field";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  name.remove_prefix(kPrefix.size());
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size() || name.starts_with('0') ||
      number < 1 || number > law::kMaxFields) {
    return std::nullopt;
  }
  return number - 1;
}

}  // namespace slipbench::driver::cases
