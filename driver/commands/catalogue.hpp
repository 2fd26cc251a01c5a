// SPDX-License-Identifier: Apache-2.0
// Commands that tell what the program knows: list, describe, schema. They return the exit code.
#pragma once

#include <string>

namespace slipbench::driver {

/// Prints names with one line each. `what` is connections, laws, closed-forms or quantities, or
/// empty for all; anything else is bad input.
int list_command(const std::string& what);

/// Prints all there is on one connection type, law or closed form.
int describe_command(const std::string& name);

/// Prints the JSON Schema of a case file, or the case reference as Markdown.
int schema_command(bool markdown);

}  // namespace slipbench::driver
