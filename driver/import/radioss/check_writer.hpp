// SPDX-License-Identifier: Apache-2.0
// Checks of a case from a deck: what its friction must come to when the contact slides steadily.
#pragma once

#include <string>

#include "driver/import/radioss/deck_friction.hpp"

namespace slipbench::driver::radioss {

/// The `checks:` of a case in YAML. One holds for every friction: from the middle of the slide on,
/// the force keeps within its limit. The others hold the coefficient against the closed form of
/// Ifric with the constants of the deck, at the speed and the normal force that are prescribed.
/// Where parts pick a record, each of the first records has such checks as a comment, since the
/// deck does not say which parts meet. Renard sets with negative coefficients have none: their
/// closed form does not take them.
std::string checks_text(const DeckFriction& friction);

}  // namespace slipbench::driver::radioss
