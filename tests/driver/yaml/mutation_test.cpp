// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>

#include "driver/yaml/parse.hpp"

namespace slipbench::driver::yaml {
namespace {

constexpr std::string_view kSeed = R"(slipbench: 1
title: "Shock absorber, \"user\" defined"
units: {length: mm, force: N, time: s}
parameters: {r: 0.24, li: 0.55, mu: 0.15}
connector:
  type: [SLOT, REVOLUTE]   # basic types
  initial: {CP1: 0.0}
derived_components:
  normal:
    - {operator: norm, components: [2, 3], weights: [1, 1]}
    - operator: norm
      weights:
        columns: [weight5, CP1]
        rows: [[= 2/li, 0.0], [2.5, 0.45]]
friction:
  - name: 'the sleeve''s'
    contact_force: &load normal
    also: *load
    internal_contact_force:
      rows: &rows [[100, 0, 20], [90, 1000, 20]]
    more: *rows
    why: |
      some text: with [brackets] and "quotes
    note: several words
      on two lines
history:
-
- step: press
  motion: {CP1: {to: 0.45}}
)";

constexpr std::array<std::string_view, 24> kPieces = {
    "\"",     "'",   "[",  "]", "{",   "}", ":", ": ", "- ",    "#",  " #",       "\n",
    "\n\n  ", "&a ", "*a", "!", "|\n", ">", ",", "? ", "---\n", "\t", "\xC3\xA4", "<<: "};

// Bytes changed, dropped, doubled or moved, and pieces of syntax put in.
std::string mutate(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::size_t changes = 1 + below(4);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(40, text.size() - at));
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 3:
        text.resize(at);
        break;
      default:
        text.insert(at, kPieces[below(kPieces.size())]);
    }
  }
  return text;
}

// Touches every node as a reader would.
std::size_t walk(const Node& node, const base::SourceText& source) {
  const base::SourcePosition where = node.where();
  REQUIRE(where.line >= 1);
  REQUIRE(where.line <= source.line_count());
  REQUIRE(where.column >= 1);
  std::size_t bytes = node.text().size();
  if (node.is_map()) {
    for (const Entry entry : node.entries()) {
      REQUIRE(entry.key.is_scalar());
      bytes += walk(entry.key, source) + walk(entry.value, source);
    }
  } else {
    for (const Node item : node.items()) bytes += walk(item, source);
  }
  return bytes;
}

TEST_CASE("Mutated files are read or refused with a place, and never crash") {
  REQUIRE(parse_yaml(base::SourceText("m.yaml", std::string(kSeed))).has_value());
  std::mt19937 random(19770525);
  std::size_t read = 0;
  std::size_t refused = 0;
  for (int i = 0; i < 8000; ++i) {
    const std::string text = mutate(std::string(kSeed), random);
    const base::SourceText source("m.yaml", text);
    const auto tree = parse_yaml(source);
    if (tree) {
      ++read;
      walk(tree->root(), source);
      continue;
    }
    ++refused;
    REQUIRE(tree.error().has_errors());
    for (const base::Diagnostic& diagnostic : tree.error().sorted()) {
      INFO(text);
      REQUIRE(diagnostic.where.line >= 1);
      REQUIRE(diagnostic.where.line <= source.line_count());
      REQUIRE_FALSE(diagnostic.message.empty());
    }
    REQUIRE_FALSE(base::render(tree.error(), {&source, 1}).empty());
  }
  // Both kinds must be met, or the test tests nothing.
  CHECK(read > 100);
  CHECK(refused > 1000);
}

}  // namespace
}  // namespace slipbench::driver::yaml
