// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/slowest_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "driver/base/text/diagnostic.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::suite {

void SlowestCases::add(const Candidate& candidate, const CaseOutcome& outcome) {
  // Cases that took equally long stay in the order of the suite.
  const auto place =
      std::upper_bound(entries_.begin(), entries_.end(), outcome.seconds,
                       [](double seconds, const Entry& entry) { return seconds > entry.seconds; });
  if (place == entries_.end() && entries_.size() >= most_) return;
  entries_.insert(place, {outcome.seconds, candidate.label});
  if (entries_.size() > most_) entries_.pop_back();
}

std::string SlowestCases::text() const {
  if (entries_.empty()) return {};
  std::string text = "  slowest:\n";
  for (const Entry& entry : entries_) {
    text += fmt::format("  {:>9}  {}\n", seconds_text(entry.seconds), base::printable(entry.label));
  }
  return text;
}

std::string seconds_text(double seconds) {
  return terminal::elapsed_text(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(seconds)));
}

}  // namespace slipbench::driver::suite
