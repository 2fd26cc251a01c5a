// SPDX-License-Identifier: Apache-2.0
// Losses of a case in a program's deck.
#pragma once

#include <string>
#include <vector>

#include "driver/import/loss.hpp"

namespace slipbench::driver::exports {

using import::Loss;

/// Case that a program's deck cannot hold; thrown by its writer.
struct NotExported {
  std::string reason;  ///< a sentence
};

/// Deck, and how much of the case it holds.
struct ExportedDeck {
  std::string text;
  std::vector<Loss> losses = {};
};

struct ExportOptions {
  bool behavior_only = false;  ///< the block to paste, in place of a deck that runs
  int digits = 0;              ///< that numbers are rounded to; 0: all
};

}  // namespace slipbench::driver::exports
