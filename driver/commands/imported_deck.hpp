// SPDX-License-Identifier: Apache-2.0
// A deck of any program, as the cases of its joints and contacts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/import/loss.hpp"

namespace slipbench::driver::commands {

struct ImportOptions {
  std::string deck;
  std::string output = {};                      ///< empty: standard output
  std::string units = {};                       ///< "mm N s"; empty: those of the deck
  std::string normal = {};                      ///< "0 0 1"; empty: not known
  bool force = false;                           ///< --force: replace a file that is there
  std::optional<int> id = std::nullopt;         ///< of a statement of friction: /FRICTION
  std::optional<int> interface = std::nullopt;  ///< of a contact interface
  std::string connector = {};                   ///< number or set of a connector element
  std::string history = {};    ///< --history: CSV with results of the model, CRF2, CTM3, CP1
  bool all = false;            ///< --all: a file each, into the folder `output`
  bool allow_outside = false;  ///< --allow-outside: included files may lie outside its folder
  bool json = false;           ///< --json: what is kept, approximated and dropped, for machines
  std::optional<base::SourceText> text = std::nullopt;  ///< of the deck, in place of the file's
};

/// Case of a joint or a contact of a deck.
struct ImportedCase {
  std::string stem;     ///< of the name of its file
  std::string summary;  ///< a phrase: "/FRICTION/7, 2 records and the default"
  import::WrittenCase written;
};

/// Cases that are chosen of a deck.
struct ImportedDeck {
  std::string messages;  ///< what the deck has, and what is wrong with it: for standard error
  std::vector<ImportedCase> cases;  ///< at least one if the code is kExitOk
  int code = base::kExitOk;
};

/// Ends an import with a message.
ImportedDeck refused(ImportedDeck imported, const std::string& message,
                     int code = base::kExitBadInput);

/// Reads the text of a deck; a file that cannot be read ends the import.
std::optional<base::SourceText> source_of(const ImportOptions& options, ImportedDeck& imported);

/// Reads a deck of any program that is known.
ImportedDeck read_deck(const ImportOptions& options);

}  // namespace slipbench::driver::commands
