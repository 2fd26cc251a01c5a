// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/base/text/number.hpp"

namespace slipbench::driver::plot {

Canvas canvas_of(const PictureLook& look, double height) {
  if (look.width <= 0.0 || look.height <= 0.0) return {kLayoutWidth, height, 1.0};
  const double larger = std::max(kLayoutWidth / look.width, height / look.height);
  return {std::round(look.width * larger), std::round(look.height * larger), 1.0 / larger};
}

tl::expected<PictureLook, std::string> parse_size(std::string_view text) {
  constexpr long long kLeast = 200;
  constexpr long long kMost = 10000;
  const auto side = [](std::string_view digits) {
    const auto number = base::parse_integer(digits);
    return number && *number >= kLeast && *number <= kMost ? static_cast<double>(*number) : 0.0;
  };
  const std::size_t cross = text.find('x');
  PictureLook look;
  if (cross != std::string_view::npos) {
    look.width = side(text.substr(0, cross));
    look.height = side(text.substr(cross + 1));
  }
  if (look.width > 0.0 && look.height > 0.0) return look;
  return tl::unexpected(
      fmt::format("--size {}: wanted WIDTHxHEIGHT in pixels, each from {} to {}, such as 800x500",
                  text, kLeast, kMost));
}

}  // namespace slipbench::driver::plot
