// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "driver/base/units/units.hpp"
#include "driver/import/contact/contact_case.hpp"
#include "driver/import/radioss/deck_friction.hpp"

namespace slipbench::driver::radioss {

/// Choices that the deck does not make.
struct SkeletonOptions {
  std::string deck;                             ///< name of its file, for the heading
  std::optional<base::UnitSystem> units;        ///< that its numbers are in
  std::optional<std::array<double, 3>> normal;  ///< of the contact plane, in the deck's frame
  std::vector<std::string> notes = {};          ///< sentences for the heading
  std::vector<import::Loss> losses = {};        ///< what the deck has beyond its friction
  double shear_limit = 0.0;  ///< stress that the friction does not exceed; 0: none
  bool as_coded = false;     ///< computed as the program does where its page differs
};

/// Returns what a side is called in the case: the id of its part, or its group.
std::string side_text(const DeckSide& side);

/// Returns the friction of a deck in the words of a case: coefficients become laws by Ifric,
/// records a table of part pairs, Ifiltr and Xfreq a filter and Iform a formulation. The friction
/// must be one that `judge` finds no error in.
import::ContactFriction contact_friction(const DeckContents& deck, const DeckFriction& friction,
                                         const SkeletonOptions& options);

}  // namespace slipbench::driver::radioss
