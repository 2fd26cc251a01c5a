// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/translate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/read/read_case.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

using Values = std::vector<base::ParameterText>;

/// Case of a deck, with numbers for what the deck has none for.
struct NumberedCase {
  read::CaseText written;
  read::ReadCase read;

  NumberedCase(const import::WrittenCase& of, const Values& values)
      : read(read::read_case_text(base::SourceText("case", of.text), ".",
                                  {.overrides = values, .text = &written})) {}
};

/// The deck's text with these numbers, or why there is none.
std::string text_of(const import::WrittenCase& of, const Values& values,
                    const DeckOutputOptions& options) {
  const NumberedCase numbered(of, values);
  if (!numbered.read.value) return base::render(numbered.read.diagnostics, numbered.read.sources);
  const auto deck = exported_case(options.to, *numbered.read.value, numbered.written,
                                  {!options.part.empty(), options.digits});
  return deck ? deck->text : deck.error();
}

std::string joined(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Those of `open` on which the deck depends: it is another one if they are twice as large.
std::vector<std::string> needed(const import::WrittenCase& of, const Values& values,
                                const std::vector<std::string>& open,
                                const DeckOutputOptions& options) {
  std::vector<std::string> names;
  const std::string text = text_of(of, values, options);
  for (const std::string& name : open) {
    Values doubled = values;
    doubled.push_back({name, 2.0});
    if (text_of(of, doubled, options) != text) names.push_back(name);
  }
  return names;
}

/// The words for what is missing: "the deck depends on K, m: give them with --set".
std::string request(const std::vector<std::string>& missing, const std::string& program) {
  return fmt::format("the deck for {} depends on {}: give {} with --set", program, joined(missing),
                     missing.size() == 1 ? "it" : "them");
}

/// The ending of a program's decks.
std::string_view ending(std::string_view program) {
  if (program == "abaqus") return ".inp";
  if (program == "radioss") return "_0000.rad";
  if (program == "lsdyna") return ".k";
  return program == "opensees" ? ".tcl" : ".csv";
}

/// The losses of reading a deck. That the case keeps something does not say that the other deck
/// does, which its writer tells; sentences on how numbers were read stay.
std::vector<import::Loss> losses_of_reading(const import::WrittenCase& of) {
  std::vector<import::Loss> losses;
  for (const import::Loss& one : of.losses) {
    if (one.kind != import::Loss::Kind::kKept) losses.push_back(one);
  }
  for (const std::string& note : of.notes) {
    losses.push_back({import::Loss::Kind::kKept, "as read: " + note});
  }
  return losses;
}

/// Reports settings that no case of the deck asks for.
std::string unknown_setting(const ImportedDeck& deck, const Values& settings) {
  for (const base::ParameterText& one : settings) {
    const bool asked =
        std::any_of(deck.cases.begin(), deck.cases.end(), [&](const ImportedCase& each) {
          const auto& names = each.written.asked;
          return std::find(names.begin(), names.end(), one.name) != names.end();
        });
    if (!asked) return "--set " + one.name + ": nothing of this name is asked for";
  }
  return {};
}

}  // namespace

tl::expected<DeckOutput, std::string> translated(const import::WrittenCase& of,
                                                 const std::vector<base::ParameterText>& settings,
                                                 const DeckOutputOptions& options) {
  Values values;
  std::vector<std::string> open;
  for (const std::string& asked : of.asked) {
    const auto given = std::find_if(settings.begin(), settings.end(),
                                    [&](const auto& one) { return one.name == asked; });
    if (given != settings.end()) {
      values.push_back(*given);
    } else {
      open.push_back(asked);
      values.push_back({asked, 1.0});
    }
  }
  const std::vector<std::string> missing = needed(of, values, open, options);
  if (!missing.empty()) return tl::unexpected(request(missing, options.to));
  const NumberedCase numbered(of, values);
  if (!numbered.read.value) {
    return tl::unexpected("its case does not run with these numbers:\n" +
                          base::render(numbered.read.diagnostics, numbered.read.sources));
  }
  auto made = deck_of_case(*numbered.read.value, numbered.written, options);
  if (!made) return made;
  if (!open.empty()) {
    made->difference =
        tl::unexpected("not measured: give " + joined(open) + " with --set, and it is run");
  }
  const std::vector<import::Loss> read = losses_of_reading(of);
  made->deck.losses.insert(made->deck.losses.begin(), read.begin(), read.end());
  return made;
}

int translate_command(const TranslateOptions& options) {
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  const bool all = options.source.all;
  DeckOutputOptions form = options.deck;
  if (all && form.output.empty()) form.output = ".";
  if (const std::string fault = json_fault(form); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  const ImportedDeck deck = read_deck(options.source);
  terminal::print_error(deck.messages);
  if (deck.code != base::kExitOk) return deck.code;
  const std::string fault = unknown_setting(deck, *settings);
  if (!fault.empty()) return terminal::refuse(base::kExitBadInput, fault);
  base::json::Value documents = base::json::Array{};
  int code = base::kExitOk;
  for (const ImportedCase& one : deck.cases) {
    auto made = translated(one.written, *settings, form);
    if (!made) {
      const std::string name = all ? one.summary : options.source.deck;
      code = terminal::refuse(base::kExitBadInput,
                              base::printable(name) + ": is not translated: " + made.error());
      continue;
    }
    if (all) {
      made->output =
          (std::filesystem::path(form.output) / (one.stem + std::string(ending(form.to)))).string();
    }
    base::json::Value document;
    const int written =
        write_deck(*made, options.source.deck, form.force, form.json ? &document : nullptr);
    if (written != base::kExitOk) return written;
    if (form.json && !all) terminal::print(document.dump(2) + "\n");
    documents.push_back(std::move(document));
  }
  if (form.json && all) terminal::print(documents.dump(2) + "\n");
  return code;
}

}  // namespace slipbench::driver::commands
