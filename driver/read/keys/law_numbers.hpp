// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <type_traits>

#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// The parameters of a law with their numbers, to six digits: "static 0.3, kinetic 0.2".
template <class Law>
std::string numbers(const Law& law) {
  std::string text;
  yaml::for_each_key<Law>([&](std::string_view key, auto member, const yaml::KeyInfo&) {
    using Member = std::remove_cvref_t<decltype(law.*member)>;
    if constexpr (std::is_convertible_v<Member, std::optional<double>>) {
      const std::optional<double> value = law.*member;
      if (value) text += fmt::format("{}{} {:.6g}", text.empty() ? "" : ", ", key, *value);
    }
  });
  return text;
}

}  // namespace slipbench::driver::read
