// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/read/read_case.hpp"

namespace slipbench::driver::read {

/// A sound case with a bit of everything; tests change a few words of it.
inline const std::string kSoundCase =
    "slipbench: 1\n"
    "title: base\n"
    "units: {length: mm, force: N, time: s, temperature: degC}\n"
    "parameters: {r: 0.24, li: 0.55, mu: 0.15}\n"
    "connector:\n"
    "  type: CYLINDRICAL\n"
    "derived_components:\n"
    "  normal:\n"
    "    - {operator: norm, components: [2, 3]}\n"
    "    - {operator: norm, components: [5, 6], weights: [= 2/li, = 2/li]}\n"
    "friction:\n"
    "  - name: sleeve\n"
    "    potential:\n"
    "      terms: [{component: 1}, {component: 4, scale: = r}]\n"
    "    contact_force: normal\n"
    "    coefficient: = mu\n"
    "    stick: {elastic_slip: 1.0e-4}\n"
    "history:\n"
    "  - step: press\n"
    "    increments: 10\n"
    "    motion: {CP1: {to: 0.45}}\n"
    "    force: {f2: 300, f3: 400, m2: {to: 55}}\n"
    "checks:\n"
    "  - name: limit\n"
    "    quantity: FLIM\n"
    "    against: {expression: \"= mu*FN\"}\n"
    "    tolerance: {relative: 1.0e-2, why: rounding}\n";

/// A text to replace, and by what; once.
using Change = std::pair<std::string, std::string>;

inline std::string changed(const std::vector<Change>& changes, std::string text = kSoundCase) {
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    INFO("no '" << from << "' to be changed");
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  }
  return text;
}

inline ReadCase read_text(const std::string& text, const ReadOptions& options = {},
                          const std::string& folder = ".") {
  return read_case_text(base::SourceText("c.yaml", text), folder, options);
}

/// The case of a sound text.
inline cases::Case sound(const std::string& text, const ReadOptions& options = {},
                         const std::string& folder = ".") {
  ReadCase read = read_text(text, options, folder);
  INFO(base::render(read.diagnostics, read.sources));
  REQUIRE(read.value.has_value());
  return std::move(*read.value);
}

/// All messages as the user sees them.
inline std::string complaint(const std::string& text, const ReadOptions& options = {},
                             const std::string& folder = ".") {
  const ReadCase read = read_text(text, options, folder);
  CHECK(read.value.has_value() == !read.diagnostics.has_errors());
  return base::render(read.diagnostics, read.sources);
}

/// The messages without the lines they quote and without the file's name.
inline std::vector<std::string> messages(const std::string& text, const ReadOptions& options = {},
                                         const std::string& folder = ".") {
  const std::string all = complaint(text, options, folder);
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = all.find('\n', begin);
    const std::string line = all.substr(begin, end - begin);
    if (line.starts_with("c.yaml:")) lines.push_back(line.substr(7));
    begin = end + 1;
  }
  return lines;
}

}  // namespace slipbench::driver::read
