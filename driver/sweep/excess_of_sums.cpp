// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/excess_of_sums.hpp"

#include <fmt/format.h>

#include "driver/sweep/sobol_indices.hpp"

namespace slipbench::driver::sweep {

std::optional<std::string> excess_of_sums(const Sweep& sweep) {
  const std::size_t varied = sweep.varied.size();
  const std::size_t collected = sweep.collected.size();
  // Sums for the correlation of each pair are kept, some 1.6 kB, however few samples there are.
  constexpr std::size_t kMostPairs = 100'000;
  if (varied * collected > kMostPairs) {
    return fmt::format(
        "{} varied parameters and {} collected numbers have more than {} correlations; vary or "
        "collect fewer",
        varied, collected, kMostPairs);
  }
  // With the rest of the program some 256 MB.
  constexpr std::size_t kMegabyte = 1'000'000;
  constexpr std::size_t kMostMegabytes = 220;
  const std::size_t size = SobolEstimate::size(varied, collected);
  if (sweep.sobol_indices && size > kMostMegabytes * kMegabyte) {
    return fmt::format(
        "{} varied parameters and {} collected numbers take {} MB of sums for Sobol' indices, more "
        "than {}; vary or collect fewer, or leave out 'sobol_indices'",
        varied, collected, (size + kMegabyte - 1) / kMegabyte, kMostMegabytes);
  }
  return std::nullopt;
}

}  // namespace slipbench::driver::sweep
