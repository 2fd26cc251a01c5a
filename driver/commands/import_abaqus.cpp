// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import_abaqus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/csv/csv_fields.hpp"
#include "driver/base/csv/line_reader.hpp"
#include "driver/base/files/data_path.hpp"
#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/commands/import_units.hpp"
#include "driver/import/abaqus/case_writer.hpp"
#include "driver/import/abaqus/keyword_list.hpp"
#include "driver/import/abaqus/model.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// Connector with friction, and the case that it makes or why it makes none.
struct Candidate {
  const abaqus::Connector* connector = nullptr;
  tl::expected<import::WrittenCase, std::string> written;
};

/// Cases that are written at once, each read back: some 1 ms a case.
constexpr std::ptrdiff_t kMostAtOnce = 1000;
/// Number of connectors up to which those that are not meant are told of, too.
constexpr std::ptrdiff_t kMostBeside = 20;

/// Returns how much is written for all cases of a deck, each twice: all repeat its steps and
/// amplitudes.
std::size_t most_text(const abaqus::KeywordDeck& deck) {
  std::size_t most = std::size_t{4} << 20U;
  for (const base::SourceText& one : deck.sources()) most += 8 * one.text().size();
  return most;
}

/// Tells whether a connector makes a case.
bool has_friction(const abaqus::Connector& connector) {
  return connector.behavior != nullptr && !connector.behavior->frictions.empty();
}

/// Names the element sets of connectors with friction: "PINS (800), ARMS (300)".
std::string sets_of_sections(const abaqus::Model& model) {
  std::map<std::string, std::size_t> count;
  for (const abaqus::Connector& one : model.connectors) count[one.set] += has_friction(one) ? 1 : 0;
  std::vector<std::string> texts;
  for (const auto& [set, connectors] : count) {
    if (connectors > 0) texts.push_back(fmt::format("{} ({})", set, connectors));
  }
  return base::few_in_words(std::vector<std::string_view>(texts.begin(), texts.end()));
}

/// "arm-1.7" as a part of a file's name.
std::string file_stem(const std::string& deck, const abaqus::Connector& connector) {
  std::string name = fs::path(deck).stem().string() + "_" + connector.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == ' '; }, '_');
  return name;
}

std::string plural(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Tells what a deck has, and what becomes of the connectors that are looked at.
std::string inventory(const abaqus::Model& model, const std::vector<Candidate>& candidates) {
  const auto count = std::count_if(model.connectors.begin(), model.connectors.end(), has_friction);
  std::string text = plural(static_cast<std::size_t>(count), "connector") + " with friction";
  text += candidates.empty() ? "\n" : ":\n";
  for (const Candidate& one : candidates) {
    text += "  " + abaqus::described(*one.connector) + "\n";
    if (!one.written) text += "    passed over: " + base::printable(one.written.error()) + "\n";
  }
  for (const abaqus::Connector& one : model.connectors) {
    if (!has_friction(one)) text += "  " + abaqus::described(one) + ": no friction, passed over\n";
  }
  for (const std::string& note : model.notes) text += "  " + base::printable(note) + "\n";
  return text + "  " + plural(model.passed_over, "keyword") + " passed over\n";
}

/// Returns why the case cannot read a history file from its folder, and what to do; or nothing.
std::string outside(const abaqus::RecordedHistory& history, const ImportOptions& options,
                    const fs::path& folder) {
  if (options.allow_outside || base::resolve_data_path(folder, history.file)) return {};
  const std::string own = folder == "." ? "this folder" : base::printable(folder.string());
  return fmt::format(
      "--history {}: a case reads files of its own folder only, and this one would stand in {}: "
      "copy the file there, write the case beside it (-o), or give --allow-outside to import and "
      "run",
      base::printable(options.history), own);
}

/// Finds the columns of a history file. Error: a sentence.
tl::expected<abaqus::RecordedHistory, std::string> recorded_history(const ImportOptions& options,
                                                                    const fs::path& folder) {
  base::LineReader lines;
  const std::string name = base::printable(options.history);
  if (const auto opened = lines.open(options.history); !opened) {
    return tl::unexpected(name + ": " + opened.error().message);
  }
  std::string_view header = "#";
  while (header.starts_with('#') || header.empty()) {
    const auto filled = lines.fill();
    if (!filled) return tl::unexpected(name + ": " + filled.error().message);
    if (lines.begin == lines.lines_end) return tl::unexpected(name + ": has no header");
    header = lines.take_line();
  }
  const char separator = header.find(';') != header.npos    ? ';'
                         : header.find('\t') != header.npos ? '\t'
                                                            : ',';
  abaqus::RecordedHistory history{
      .file = fs::proximate(options.history, folder).string(), .time = {}, .columns = {}};
  const std::vector<std::string> columns = base::header_names(header, separator);
  const auto time = std::find_if(columns.begin(), columns.end(), [](const std::string& column) {
    return abaqus::folded(column) == "TIME" || abaqus::folded(column) == "T";
  });
  if (time == columns.end()) {
    return tl::unexpected(name + ": has no column called time, or t");
  }
  // The first of several columns whose names are the same when folded is taken.
  for (const std::string& column : columns) {
    history.columns.try_emplace(abaqus::folded(column), column);
  }
  history.time = *time;
  return history;
}

}  // namespace

ImportedDeck import_abaqus(const ImportOptions& options) {
  ImportedDeck imported;
  base::Diagnostics diagnostics;
  bool environment_failure = false;
  const auto deck = options.text
                        ? abaqus::KeywordDeck::read_text(*options.text, {"."}, diagnostics)
                        : abaqus::KeywordDeck::read(options.deck, diagnostics, environment_failure,
                                                    options.allow_outside);
  abaqus::Model model;
  if (deck) model = abaqus::read_model(*deck);
  imported.messages =
      base::render(diagnostics, deck ? deck->sources() : std::vector<base::SourceText>());
  if (diagnostics.has_errors()) {
    imported.messages += base::summary(diagnostics) + ", nothing was written\n";
    imported.code = environment_failure ? base::kExitEnvironment : base::kExitBadInput;
    return imported;
  }
  abaqus::CaseOptions case_options{
      .deck = fs::path(options.deck).filename().string(), .units = {}, .history = {}};
  if (!options.units.empty()) {
    const auto units = parse_units(options.units);
    if (!units) return refused(std::move(imported), units.error());
    case_options.units =
        fmt::format("length: {}, force: {}, time: {}", units->length, units->force, units->time);
  }
  if (!options.history.empty()) {
    const bool to_terminal = options.output.empty() || options.output == "-";
    const fs::path folder = options.all   ? fs::path(options.output)
                            : to_terminal ? fs::path()
                                          : fs::path(options.output).parent_path();
    case_options.folder = folder.empty() ? "." : folder.string();
    auto history = recorded_history(options, case_options.folder);
    if (!history) return refused(std::move(imported), history.error(), base::kExitEnvironment);
    if (const std::string fault = outside(*history, options, case_options.folder); !fault.empty()) {
      return refused(std::move(imported), fault);
    }
    case_options.history = std::move(*history);
  }
  const std::string name = base::printable(options.deck);
  const auto is_meant = [&](const abaqus::Connector& one) {
    return options.connector.empty() || options.connector == one.name ||
           one.labels.count(abaqus::label_of(options.connector)) > 0;
  };
  const auto count_if = [&](auto&& wanted) {
    return std::count_if(model.connectors.begin(), model.connectors.end(),
                         [&](const auto& one) { return has_friction(one) && wanted(one); });
  };
  if (const auto count = count_if(is_meant); count > kMostAtOnce) {
    return refused(
        std::move(imported),
        fmt::format("{}: {} connectors with friction are more than the {} that are taken "
                    "over at once: give the number of one, or a set of fewer, with --connector; "
                    "their sections have {}",
                    name, count, kMostAtOnce, sets_of_sections(model)));
  }
  const bool many = count_if([](const abaqus::Connector&) { return true; }) > kMostBeside;
  const std::size_t most = most_text(*deck);
  std::size_t text = 0;
  case_options.characters = &text;
  std::vector<Candidate> candidates;
  for (const abaqus::Connector& one : model.connectors) {
    if (!has_friction(one) || (many && !is_meant(one))) continue;
    candidates.push_back({&one, abaqus::write_case(*deck, model, one, case_options)});
    if (text > most) {
      return refused(
          std::move(imported),
          fmt::format("{}: its cases would have more than {} MiB together, each with all "
                      "steps of the deck: give the number of one connector, or a set of "
                      "fewer, with --connector; their sections have {}",
                      name, most >> 21U, sets_of_sections(model)));
    }
  }
  imported.messages += inventory(model, candidates);
  for (Candidate& one : candidates) {
    if (!is_meant(*one.connector) || !one.written) continue;
    imported.cases.push_back({file_stem(options.deck, *one.connector),
                              abaqus::described(*one.connector), std::move(*one.written)});
  }
  if (imported.cases.empty()) {
    return refused(std::move(imported),
                   name + (options.connector.empty() ? ": has no connector that can be taken over"
                                                     : ": has no such connector to take over: " +
                                                           base::printable(options.connector)));
  }
  if (imported.cases.size() > 1 && !options.all) {
    return refused(std::move(imported),
                   name + ": choose one with --connector NUMBER, or all of them with --all -o DIR");
  }
  return imported;
}

}  // namespace slipbench::driver::commands
