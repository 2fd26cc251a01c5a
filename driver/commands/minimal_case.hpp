// SPDX-License-Identifier: Apache-2.0
// The smallest case that shows the friction of a connection type.
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::commands {

/// A case of the type as commented YAML, in mm, N and s: it presses, rubs, and checks the contact
/// force. A type that has nothing free is joined with one that has. Empty for an unknown name.
std::string minimal_case(std::string_view type);

/// A drawing of the type in a few lines: the axis that slides or turns, and what is held.
std::string_view connection_sketch(std::string_view type);

/// "M_N = R_p sqrt(f2^2 + f3^2) + ..": what the coefficient is multiplied by; a line a check.
std::string contact_force_formulas(std::string_view type);

}  // namespace slipbench::driver::commands
