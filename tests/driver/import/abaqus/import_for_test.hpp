// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "driver/import/abaqus/case_writer.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/support/checks_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::abaqus {

/// A deck that was read, and what was said of it.
struct ReadDeck {
  std::optional<KeywordDeck> deck;
  Model model;
  std::vector<std::string> said;  ///< "3:4: error: *NODE: .."
};

inline ReadDeck read_deck(const std::string& path) {
  ReadDeck read;
  static base::Diagnostics diagnostics;
  diagnostics = {};
  bool environment_failure = false;
  read.deck = KeywordDeck::read(path, diagnostics, environment_failure);
  REQUIRE(read.deck.has_value());
  read.model = read_model(*read.deck);
  for (const base::Diagnostic& one : diagnostics.sorted()) {
    read.said.push_back(
        fmt::format("{}:{}: {}: {}", one.where.line, one.where.column, one.path, one.message));
  }
  return read;
}

/// The case of a connector of a deck.
inline WrittenCase case_of(const ReadDeck& read, std::size_t connector = 0) {
  INFO((read.said.empty() ? "" : read.said.front()));
  REQUIRE(read.said.empty());
  REQUIRE(read.model.connectors.size() > connector);
  auto written =
      write_case(*read.deck, read.model, read.model.connectors[connector], {"d.inp", ""});
  INFO((written ? "" : written.error()));
  REQUIRE(written.has_value());
  return *written;
}

/// A check that a quantity has a value at the end of a case, to be put behind its text.
inline std::string at_the_end(const std::string& quantity, const std::string& value,
                              double end = 1.0) {
  return fmt::format(
      "checks:\n  - name: {0}\n    quantity: \"= {0}\"\n    against: {{expression: \"= {1}\"}}\n"
      "    over: {{from: {2}, to: {2}}}\n    tolerance: {{relative: 1.0e-8, absolute: 1.0e-8, why: "
      "rounding}}\n",
      quantity, value, end);
}

/// Runs a written case with values for what it asks, and returns the checks that fail.
inline std::vector<std::string> failed(const std::string& text,
                                       const std::vector<base::ParameterText>& values) {
  const read::ReadCase read =
      read::read_case_text(base::SourceText("c.yaml", text), ".", {.overrides = values});
  for (const base::Diagnostic& one : read.diagnostics.sorted()) {
    INFO(one.path << ": " << one.message);
    CHECK(one.severity != base::Severity::kError);
  }
  REQUIRE(read.value.has_value());
  return failed_checks(*read.value);
}

}  // namespace slipbench::driver::abaqus
