// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace slipbench::law {

/// The name of a unit that stands beside constants ("mm/ms"). The law carries it, its reader knows
/// what it means. At most kLongest characters, kept in place so that a law copies without memory.
class UnitName {
 public:
  static constexpr std::size_t kLongest = 47;

  constexpr UnitName() = default;
  /// Longer texts are cut off; the reader refuses them.
  constexpr explicit UnitName(std::string_view name) : size_(std::min(name.size(), kLongest)) {
    std::copy_n(name.begin(), size_, text_.begin());
  }
  constexpr std::string_view name() const { return {text_.data(), size_}; }
  constexpr bool empty() const { return size_ == 0; }

 private:
  std::array<char, kLongest> text_{};
  std::size_t size_ = 0;
};

}  // namespace slipbench::law
