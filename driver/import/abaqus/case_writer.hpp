// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/import/abaqus/keyword_deck.hpp"
#include "driver/import/abaqus/model.hpp"

namespace slipbench::driver::abaqus {

/// Case made of a connector.
struct WrittenCase {
  std::string text;                     ///< YAML
  std::vector<std::string> asked = {};  ///< parameters without a value
  std::vector<std::string> notes = {};  ///< sentences on what was approximated, or is not known
};

struct CaseOptions {
  std::string deck;   ///< name of its file, for the heading
  std::string units;  ///< "length: mm, force: N, time: s", or empty: a deck does not say
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
