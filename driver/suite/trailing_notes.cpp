// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/trailing_notes.hpp"

#include <fmt/format.h>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::suite {

void TrailingNotes::add(const Candidate& candidate, const CaseOutcome& outcome) {
  const auto add_one = [&](const std::string& text) {
    if (++warning_count_ > kMostWarnings) return;
    warnings_ +=
        fmt::format("  warning: {}  {}\n", base::printable(candidate.label), base::printable(text));
  };
  for (const std::string& warning : outcome.warnings) add_one(warning);
  for (const CheckOutcome& check : outcome.verdicts) {
    for (const std::string& warning : check.verdict.warnings) {
      add_one(fmt::format("check '{}': {}", check.verdict.name, warning));
    }
  }
  if (!outcome.messages.empty() && ++message_count_ <= kMostCases) messages_ += outcome.messages;
}

std::string TrailingNotes::text() const {
  std::string text = warnings_;
  if (warning_count_ > kMostWarnings) {
    text += fmt::format("  ... and {} more warnings\n", warning_count_ - kMostWarnings);
  }
  text += messages_;
  if (message_count_ > kMostCases) {
    text += fmt::format("... and {} more cases that were not run\n", message_count_ - kMostCases);
  }
  return text;
}

}  // namespace slipbench::driver::suite
