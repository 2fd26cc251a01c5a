// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/contact_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "driver/commands/import_units.hpp"

namespace slipbench::driver::commands {
namespace {

/// Some megabytes of cases, and a second's work to write them and read them back.
constexpr std::size_t kMostParts = 1'000'000;

}  // namespace

bool lists_too_many_parts(const import::ContactFriction& friction, std::size_t& parts) {
  if (friction.pairs.empty()) return false;
  parts += friction.parts.size();
  for (const auto& group : friction.groups) parts += group->parts.size();
  return parts > kMostParts;
}

ImportedDeck refused_for_parts(ImportedDeck imported, const std::string& deck,
                               std::string_view option) {
  return refused(
      std::move(imported),
      fmt::format(
          "{}: its cases would list more than {} parts together: choose one of them with {}",
          base::printable(deck), kMostParts, option));
}

ImportedDeck choose_contacts(const ImportOptions& options, std::vector<ContactChoice> choices,
                             const base::Diagnostics& diagnostics, const import::DeckTexts& texts,
                             const ChoiceWords& words) {
  ImportedDeck imported;
  std::optional<base::UnitSystem> units;
  if (!options.units.empty()) {
    auto parsed = parse_units(options.units);
    if (!parsed) return refused(std::move(imported), parsed.error());
    units = std::move(*parsed);
  }
  const auto count = std::count_if(choices.begin(), choices.end(),
                                   [](const ContactChoice& one) { return !one.passed_over; });
  imported.messages =
      fmt::format("{} {}{} with friction\n", count, words.what, count == 1 ? "" : "s");
  constexpr std::size_t kMostNamed = 20;
  for (std::size_t i = 0; i < std::min(kMostNamed, choices.size()); ++i) {
    const ContactChoice& one = choices[i];
    imported.messages += base::printable("  " + one.friction.name);
    if (!one.friction.title.empty()) {
      imported.messages += " \"" + base::printable(one.friction.title) + "\"";
    }
    imported.messages +=
        one.passed_over ? ": passed over: " + base::printable(*one.passed_over) + "\n" : "\n";
  }
  if (choices.size() > kMostNamed) {
    imported.messages += fmt::format("  and {} more\n", choices.size() - kMostNamed);
  }
  imported.messages += base::render(diagnostics, texts.all());
  if (diagnostics.has_errors()) {
    imported.messages += base::summary(diagnostics) + ", nothing was written\n";
    imported.code = base::kExitBadInput;
    return imported;
  }
  const std::string name = base::printable(options.deck);
  const auto meant = std::ranges::count_if(
      choices, [](const ContactChoice& one) { return one.meant && !one.passed_over; });
  if (meant > 1 && !options.all) {
    return refused(std::move(imported),
                   fmt::format("{}: choose one with {}, or all of them with --all -o DIR", name,
                               words.option));
  }
  const std::filesystem::path deck(options.deck);
  std::size_t parts = 0;
  for (ContactChoice& one : choices) {
    if (one.passed_over || !one.meant) continue;
    if (lists_too_many_parts(one.friction, parts) && meant > 1) {
      return refused_for_parts(std::move(imported), options.deck, words.option);
    }
    one.friction.deck = deck.filename().string();
    one.friction.units = units;
    const std::size_t records = one.friction.pairs.size();
    std::string summary = one.friction.name;
    if (records > 0)
      summary += fmt::format(", {} record{} and the default", records, records == 1 ? "" : "s");
    imported.cases.push_back({deck.stem().string() + "_" + one.stem, std::move(summary),
                              import::contact_case(one.friction)});
  }
  if (imported.cases.empty()) {
    return refused(
        std::move(imported),
        fmt::format("{}: has no {} with friction that can be taken over", name, words.what));
  }
  return imported;
}

}  // namespace slipbench::driver::commands
