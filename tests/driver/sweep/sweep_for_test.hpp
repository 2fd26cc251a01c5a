// SPDX-License-Identifier: Apache-2.0
// Sweeps of a slot for tests.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// A slot that is pulled by 0.1 mm under 100 N: it ends at min(100 mu, 0.1 k) N.
inline constexpr const char* kSlot =
    "slipbench: 1\nunits: {length: mm, force: N, time: s}\nparameters: {mu: 0.2, k: 1000}\n"
    "connector: {type: SLOT}\n"
    "friction: [{predefined: {}, coefficient: = mu, stick: {stiffness: = k}}]\n"
    "history: [{step: go, increments: 10, motion: {CP1: {to: 0.1}}, force: {f2: 100}}]\n";

/// A sweep over parameters a, b, .. of a case that has none: for what never runs it.
inline Sweep sweep_of(std::vector<Distribution> distributions, std::size_t samples) {
  auto parsed = read::ParsedCase::parse(base::SourceText("slot.yaml", kSlot), ".");
  Sweep sweep{.file = "slot_sweep.yaml",
              .title = "slot_sweep",
              .case_path = "slot.yaml",
              .parsed = std::move(*parsed)};
  char name = 'a';
  for (Distribution& one : distributions) {
    sweep.varied.push_back({std::string(1, name++), std::move(one)});
  }
  sweep.samples = samples;
  return sweep;
}

/// Adds the line of a sample as it stands in a file of rows.
inline void append_row(const SampleOutcome& outcome, std::string& text) {
  text += std::to_string(outcome.id) + ",";
  base::append_numbers(text, outcome.values);
  base::append_numbers(text, outcome.numbers);
  text.back() = '\n';
}

}  // namespace slipbench::driver::sweep
