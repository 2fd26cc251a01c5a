// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace slipbench::driver::fit {

/// Work that makes some numbers for an index, and depends on no other work.
using Item = std::function<std::vector<double>(std::size_t)>;

/// Runs items 0 .. count - 1, ascending, and returns what each made, in their order. Programs that
/// do the same fit may share them: each runs some, and all get what all made. Not to be called
/// within an item.
using RunItems =
    std::function<std::vector<std::vector<double>>(std::size_t count, const Item& item)>;

/// Runs all items here, one after the other.
inline std::vector<std::vector<double>> run_here(std::size_t count, const Item& item) {
  std::vector<std::vector<double>> made;
  made.reserve(count);
  for (std::size_t i = 0; i < count; ++i) made.push_back(item(i));
  return made;
}

}  // namespace slipbench::driver::fit
