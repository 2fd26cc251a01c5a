// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/export.hpp"

#include <fmt/format.h>

#include "driver/analysis/response.hpp"
#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/export/abaqus/deck_writer.hpp"
#include "driver/import/abaqus/case_writer.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/read/read_case.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

/// Tells what is kept, approximated and dropped.
std::string report(const std::vector<exports::Loss>& losses) {
  std::string text;
  for (const auto& [kind, name] : {std::pair{exports::Loss::Kind::kApproximated, "approximated"},
                                   std::pair{exports::Loss::Kind::kDropped, "dropped"},
                                   std::pair{exports::Loss::Kind::kKept, "kept"}}) {
    for (const exports::Loss& one : losses) {
      if (one.kind == kind) text += fmt::format("  {}: {}\n", name, base::printable(one.text));
    }
  }
  return text;
}

/// Reads a deck back and runs both; says how far they are apart.
std::string measured(const cases::Case& problem, const std::string& deck_text) {
  base::Diagnostics diagnostics;
  const auto deck =
      abaqus::KeywordDeck::read_text(base::SourceText("deck", deck_text), ".", diagnostics);
  const abaqus::Model model = abaqus::read_model(deck);
  if (diagnostics.has_errors() || model.connectors.size() != 1) return "the deck is not read back";
  const auto written =
      abaqus::write_case(deck, model, model.connectors[0], {.deck = "deck", .units = {}});
  if (!written) return "the deck is not read back: " + written.error();
  const read::ReadCase back =
      read::read_case_text(base::SourceText("case", written->text), ".", {});
  if (!back.value) return "the deck asks for more than the case has";
  const auto difference = analysis::compare_responses(problem, *back.value);
  return difference ? analysis::difference_text(*difference) : difference.error();
}

}  // namespace

int export_command(const ExportCommandOptions& options) {
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  read::CaseText written;
  const read::ReadCase read = read::read_case(
      options.file,
      {.overrides = *settings, .allow_outside = options.allow_outside, .text = &written});
  if (!read.value) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
    terminal::print_error(base::summary(read.diagnostics) + ", nothing was written\n");
    return read.environment_failure ? base::kExitEnvironment : base::kExitBadInput;
  }
  const auto deck =
      exports::to_abaqus(*read.value, written, {!options.part.empty(), options.digits});
  if (!deck) {
    return terminal::refuse(base::kExitBadInput,
                            base::printable(options.file) + ": is not exported: " + deck.error());
  }
  const auto whole = options.part.empty()
                         ? deck
                         : exports::to_abaqus(*read.value, written, {false, options.digits});
  terminal::print_error(report(deck->losses));
  if (whole) {
    terminal::print_error("  on the case's history: " + measured(*read.value, whole->text) + "\n");
  }
  if (options.output.empty() || options.output == "-") {
    terminal::print(deck->text);
    return base::kExitOk;
  }
  const std::string inputs[] = {options.file};
  auto file = base::OutputFile::create(options.output, {}, {inputs, options.force});
  if (!file) return terminal::refuse(base::kExitEnvironment, file.error());
  file->append(deck->text);
  base::OutputFile* const alone[] = {&*file};
  if (const auto committed = base::commit(alone); !committed) {
    return terminal::refuse(base::kExitEnvironment, committed.error());
  }
  terminal::print(base::printable(options.output) + "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
