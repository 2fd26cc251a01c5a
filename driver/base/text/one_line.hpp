// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::base {

/// A message without its place: "friction[0].coefficient: .. ; hint".
std::string one_line(const Diagnostic& diagnostic);

/// The messages of one severity so, in their order.
std::vector<std::string> lines_of(const Diagnostics& diagnostics, Severity severity);

}  // namespace slipbench::driver::base
