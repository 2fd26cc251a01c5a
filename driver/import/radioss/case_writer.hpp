// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "driver/base/units/units.hpp"
#include "driver/import/radioss/deck_friction.hpp"

namespace slipbench::driver::radioss {

/// Choices that the deck does not make.
struct SkeletonOptions {
  std::string deck;                             ///< name of its file, for the heading
  std::optional<base::UnitSystem> units;        ///< that its numbers are in
  std::optional<std::array<double, 3>> normal;  ///< of the contact plane, in the deck's frame
  std::vector<std::string> notes = {};          ///< sentences for the heading
  double shear_limit = 0.0;  ///< stress that the friction does not exceed; 0: none
};

/// Returns what a side is called in the case: the id of its part, or its group.
std::string side_text(const DeckSide& side);

/// A case in YAML with the friction of a deck: a contact point that is pressed and slid. What a
/// deck has no numbers for (stiffness and mass of the contact, area, load, speed, time step, which
/// parts meet) are parameters without a value, so that a run before they are given is refused.
/// Coefficients become laws by Ifric, records a table of part pairs, Ifiltr and Xfreq a filter and
/// Iform a formulation. The friction must be one that `judge` finds no error in.
std::string skeleton(const DeckContents& deck, const DeckFriction& friction,
                     const SkeletonOptions& options);

}  // namespace slipbench::driver::radioss
