// SPDX-License-Identifier: Apache-2.0
#include "driver/farm/run_shared.hpp"

namespace slipbench::driver::farm {

std::vector<std::vector<double>> run_shared(
    const Farm& farm, std::size_t count,
    const std::function<std::vector<double>(std::size_t)>& item) {
  farm.restart();
  // Of each item its index, how many numbers it made, and these.
  std::vector<double> own;
  while (true) {
    const auto i = static_cast<std::size_t>(farm.advance(1));
    if (i >= count) break;
    const std::vector<double> made = item(i);
    own.push_back(static_cast<double>(i));
    own.push_back(static_cast<double>(made.size()));
    own.insert(own.end(), made.begin(), made.end());
  }
  std::vector<std::vector<double>> all(count);
  const std::vector<double> gathered = farm.gather(own);
  for (auto at = gathered.begin(); at != gathered.end();) {
    const auto i = static_cast<std::size_t>(*at++);
    const auto size = static_cast<std::ptrdiff_t>(*at++);
    all[i].assign(at, at + size);
    at += size;
  }
  return all;
}

}  // namespace slipbench::driver::farm
