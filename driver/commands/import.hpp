// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace slipbench::driver::commands {

struct ImportOptions {
  std::string deck;
  std::string output;            ///< empty: standard output
  std::string units;             ///< "mm N s"; empty: those of the deck
  std::string normal;            ///< "0 0 1"; empty: not known
  bool force = false;            ///< --force: replace a file that is there
  std::optional<int> id;         ///< of the /FRICTION; else there must be only one
  std::optional<int> interface;  ///< id of the /INTER; else there must be only one with friction
  std::string connector;  ///< number or set of the connector element; else there must be only one
  std::string history;    ///< --history: CSV with results of the model, CRF2, CTM3, CP1
  bool all = false;       ///< --all: a file each, into the folder `output`
};

/// `slipbench import`: a case from the friction of a Radioss starter deck. Messages go to standard
/// error with file, line and column; if one is an error, nothing is written. Returns the exit code.
int import_command(const ImportOptions& options);

}  // namespace slipbench::driver::commands
