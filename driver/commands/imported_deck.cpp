// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/imported_deck.hpp"

#include <map>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/commands/import_abaqus.hpp"
#include "driver/commands/import_lsdyna.hpp"
#include "driver/commands/import_opensees.hpp"
#include "driver/commands/import_radioss.hpp"
#include "driver/import/contact/contact_case.hpp"
#include "driver/import/deck_kind.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::commands {

namespace {

/// The first fault of a case, or nothing; what it asks for is 1. Parts of a group that stands in
/// another file have to be filled in, which is no fault.
std::string fault_of(const import::WrittenCase& written) {
  std::vector<base::ParameterText> values;
  for (const std::string& name : written.asked) values.push_back({name, 1.0});
  const base::SourceText source("case", written.text);
  const read::ReadCase read = read::read_case_text(source, ".", {.overrides = values});
  if (read.value || written.text.find(import::kPartsToFillIn) != std::string::npos) return {};
  for (const base::Diagnostic& one : read.diagnostics.sorted()) {
    if (one.severity == base::Severity::kError) return one.path + ": " + one.message;
  }
  return "its case is faulty";
}

/// Passes over cases that could not be read back, and gives the others names of their own.
ImportedDeck readable(ImportedDeck imported, bool checked) {
  std::vector<ImportedCase> cases;
  std::map<std::string, int> stems;
  for (ImportedCase& one : imported.cases) {
    one.written.text = base::as_text(one.written.text);
    const std::string fault = checked ? std::string() : fault_of(one.written);
    if (!fault.empty()) {
      imported.messages += base::printable(one.summary) + ": passed over: " + fault + "\n";
      continue;
    }
    const int count = ++stems[one.stem];
    if (count > 1) one.stem += "_" + std::to_string(count);
    cases.push_back(std::move(one));
  }
  const bool none = cases.empty() && !imported.cases.empty();
  imported.cases = std::move(cases);
  return none ? refused(std::move(imported), "has nothing that can be taken over") : imported;
}

}  // namespace

ImportedDeck refused(ImportedDeck imported, const std::string& message, int code) {
  imported.messages += "slipbench: error: " + message + "\n";
  imported.cases.clear();
  imported.code = code;
  return imported;
}

std::optional<base::SourceText> source_of(const ImportOptions& options, ImportedDeck& imported) {
  // Decks carry the whole mesh.
  constexpr std::size_t kDeckSizeLimit = std::size_t{1} << 30U;
  if (options.text) return options.text;
  auto source = base::read_source(options.deck, kDeckSizeLimit);
  if (source) return std::move(*source);
  imported.messages += base::render(source.error().diagnostic);
  imported.code = source.error().failure == base::ReadFailure::kEnvironment ? base::kExitEnvironment
                                                                            : base::kExitBadInput;
  return std::nullopt;
}

ImportedDeck read_deck(const ImportOptions& options) {
  const import::DeckKind kind = options.text ? import::kind_of_text(options.text->text())
                                             : import::kind_of_deck(options.deck);
  switch (kind) {
    case import::DeckKind::kAbaqus:
      return readable(import_abaqus(options), true);
    case import::DeckKind::kLsDyna:
      return readable(import_lsdyna(options), false);
    case import::DeckKind::kOpenSees:
      return readable(import_opensees(options), false);
    default:
      // Of a file that cannot be read, or is no deck, this reader tells what is wrong.
      return readable(import_radioss(options), false);
  }
}

}  // namespace slipbench::driver::commands
