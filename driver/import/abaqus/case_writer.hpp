// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <tl/expected.hpp>

#include "driver/import/abaqus/keyword_deck.hpp"
#include "driver/import/abaqus/model.hpp"
#include "driver/import/loss.hpp"

namespace slipbench::driver::abaqus {

using import::WrittenCase;

/// History file with results of the model, whose columns drive the case in place of parameters.
struct RecordedHistory {
  std::string file;                                 ///< as the case names it; empty: none
  std::string time;                                 ///< its time column
  std::map<std::string, std::string> columns = {};  ///< as it has them, by their names folded: CRF2
};

struct CaseOptions {
  std::string deck;   ///< name of its file, for the heading
  std::string units;  ///< "length: mm, force: N, time: s", or empty: a deck does not say
  RecordedHistory history = {};
  std::string folder = ".";  ///< of the case, where its files are looked for
  /// Counts what is written, also of a case that is passed over in the end; null: nobody counts.
  std::size_t* characters = nullptr;
};

/// Writes the case of a connector. What a deck has no numbers for is a parameter without a value:
/// constraint forces, which are results of the model, motions that no step prescribes, temperature
/// and fields that a table sees, and the wrap angle of a belt that the deck leaves to the program.
/// \return a sentence where the connector cannot be taken over
tl::expected<WrittenCase, std::string> write_case(const KeywordDeck& deck, const Model& model,
                                                  const Connector& connector,
                                                  const CaseOptions& options);

/// Returns "HINGE "Pin joint" (element 1 of Wire-1-Set-1, mu 0.12)", for lists.
std::string described(const Connector& connector);

}  // namespace slipbench::driver::abaqus
