// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/import/radioss/deck_friction.hpp"
#include "driver/import/radioss/starter_deck.hpp"

namespace slipbench::driver::radioss {

/// Numbers in columns of 20, as decks have them.
inline std::string reals(std::initializer_list<std::string_view> numbers) {
  std::string line;
  for (const std::string_view number : numbers) line += fmt::format("{:>20}", number);
  return line + "\n";
}

/// Numbers in columns of 10.
inline std::string integers(std::initializer_list<int> numbers) {
  std::string line;
  for (const int number : numbers) line += fmt::format("{:>10}", number);
  return line + "\n";
}

/// A line of Ifric, Ifiltr, Xfreq, Iform.
inline std::string options(int law, int filter, std::string_view xfreq, int form) {
  return fmt::format("{:>10}{:>10}{:>20}{:>10}\n", law, filter, xfreq, form);
}

/// A line of the two sides of a record and its Idir.
inline std::string sides(int group1, int group2, int part1, int part2, int direction = 0) {
  return fmt::format("{:>10}{:>10}{:>10}{:>10}{:10}{:>10}\n", group1, group2, part1, part2, "",
                     direction);
}

/// C1 .. C5, and C6, Fric, VISF of a set.
inline std::string set(std::array<std::string_view, 8> numbers) {
  return reals({numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]}) +
         reals({numbers[5], numbers[6], numbers[7]});
}
/// A set that is Fric alone.
inline std::string coulomb(std::string_view fric, std::string_view visf = "") {
  return set({"0", "", "", "", "", "", fric, visf});
}

/// Result of reading a deck and judging its first friction, or the chosen one.
struct ReadDeck {
  DeckContents contents;
  std::string said;                   ///< all messages, as the user sees them
  std::vector<std::string> messages;  ///< without the lines they quote and without the file's name
};

inline ReadDeck read_deck(const std::string& text, std::optional<int> chosen = {}) {
  const base::SourceText source("d.rad", text);
  base::Diagnostics diagnostics;
  const StarterDeck deck = split_deck(source, {"."}, diagnostics);
  ReadDeck read{read_contents(deck, chosen, diagnostics), {}, {}};
  const auto friction =
      std::find_if(read.contents.frictions.begin(), read.contents.frictions.end(),
                   [&](const DeckFriction& one) { return !chosen || one.id == *chosen; });
  if (friction != read.contents.frictions.end() && !diagnostics.has_errors()) {
    judge(read.contents, *friction, deck.texts, diagnostics);
  }
  const base::SourceText sources[] = {source};
  read.said = base::render(diagnostics, sources);
  for (const base::Diagnostic& one : diagnostics.sorted()) {
    std::string line = base::render(one);
    line.pop_back();
    read.messages.push_back(line.starts_with("d.rad:") ? line.substr(6) : line);
  }
  return read;
}

/// The friction of a deck that has nothing wrong with it.
inline DeckFriction sound_friction(const std::string& text) {
  ReadDeck read = read_deck(text);
  INFO(read.said);
  REQUIRE(read.said.find("error") == std::string::npos);
  REQUIRE(read.contents.frictions.size() == 1);
  return std::move(read.contents.frictions.front());
}

}  // namespace slipbench::driver::radioss
