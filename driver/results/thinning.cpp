// SPDX-License-Identifier: Apache-2.0
#include "driver/results/thinning.hpp"

#include <algorithm>
#include <numeric>

namespace slipbench::driver::results {

std::vector<std::size_t> thinned_rows(std::span<const double> table, std::size_t columns,
                                      std::size_t limit, std::span<const std::size_t> watched) {
  const std::size_t count = table.size() / columns;
  limit = std::max(limit, 2 + 2 * columns);
  std::vector<std::size_t> all(std::max(count, columns));
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (count <= limit) return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};

  std::vector<std::size_t> chosen;
  const auto choose = [&](std::size_t begin, std::size_t end, std::span<const std::size_t> of) {
    chosen.push_back(begin);
    chosen.push_back(end - 1);
    for (const std::size_t c : of) {
      // A number that compares with nothing must not stay the extreme it happened to begin as.
      const auto number = [&](std::size_t row) { return table[row * columns + c]; };
      std::size_t first = begin;
      while (first < end && !(number(first) == number(first))) ++first;
      if (first == end) continue;
      std::size_t lowest = first;
      std::size_t highest = first;
      for (std::size_t row = first + 1; row < end; ++row) {
        if (number(row) < number(lowest)) lowest = row;
        if (number(row) > number(highest)) highest = row;
      }
      chosen.push_back(lowest);
      chosen.push_back(highest);
    }
  };
  const std::span<const std::size_t> every = std::span(all).first(columns);
  choose(0, count, every);
  const std::vector<std::size_t> always = chosen;

  // Pieces of so many rows, a power of two, of which at most `limit` are whole, or groups of them.
  std::size_t length = 1;
  while (count / length > limit) length *= 2;
  const std::size_t pieces = (count + length - 1) / length;
  // A group of its own for every piece cannot fit; the rows fall about as the number of groups.
  for (std::size_t groups = pieces;;) {
    chosen = always;
    for (std::size_t g = 0; g < groups; ++g) {
      choose(g * pieces / groups * length, std::min((g + 1) * pieces / groups * length, count),
             watched.empty() ? every : watched);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    if (chosen.size() <= limit || groups == 1) return chosen;
    groups = std::max<std::size_t>(1, std::min(groups * limit / chosen.size(), groups - 1));
  }
}

}  // namespace slipbench::driver::results
