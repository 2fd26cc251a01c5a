// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "driver/import/abaqus/keyword_deck.hpp"
#include "driver/import/abaqus/model.hpp"

namespace slipbench::driver::abaqus {

/// Amplitude times magnitude over a step, as a profile of a case.
struct DriveProfile {
  std::string text;       ///< YAML; empty where it cannot be written
  double end = 0.0;       ///< value at the end of the step
  std::string note = {};  ///< on what was approximated, or why there is no text
  double rate = 0.0;      ///< velocity at the end of the step, of a motion that states velocities
};

/// Profile of a motion, as a position, or of a load.
/// \param name of the quantity: CP1, f1
/// \param initial position at the start of the first step; 0 of a load
/// \param current value at the start of the step
/// \param begin total time at which the step begins
DriveProfile profile_of(const KeywordDeck& deck, const Model& model, const Step& step,
                        const Drive& drive, const std::string& name, double initial, double current,
                        double begin);

/// A number as YAML.
std::string number_text(double number);

}  // namespace slipbench::driver::abaqus
