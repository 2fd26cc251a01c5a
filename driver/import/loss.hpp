// SPDX-License-Identifier: Apache-2.0
// Losses between the words of one program and those of another.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace slipbench::driver::import {

/// Part of a deck or a case, and its fate in the words of another program.
struct Loss {
  enum class Kind : std::uint8_t { kKept, kApproximated, kDropped };
  Kind kind = Kind::kKept;
  std::string text;  ///< a phrase: "checks: a deck has none"
};

/// Case made of a joint, or of the friction of a contact.
struct WrittenCase {
  std::string text;                     ///< YAML
  std::vector<std::string> asked = {};  ///< parameters without a value
  std::vector<Loss> losses = {};
  std::vector<std::string> notes = {};  ///< on how numbers were read; kept among the losses
};

}  // namespace slipbench::driver::import
