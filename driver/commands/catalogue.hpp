// SPDX-License-Identifier: Apache-2.0
// The commands that tell what the program knows; they read no case.
#pragma once

#include <string>

#include "driver/read/file_kind.hpp"

namespace slipbench::driver::commands {

/// `slipbench list`: the names of one kind of thing with one sentence each; `what` is connections,
/// laws, keys, closed-forms or quantities, and empty for all of them. Returns the exit code.
int list_command(const std::string& what);

/// `slipbench describe`: everything about the connection type, coefficient law, closed form or
/// quantity of that name. Returns the exit code: bad input for an unknown name.
int describe_command(const std::string& name);

/// `slipbench schema`: the JSON Schema of a kind of files, or the case reference, which tells of
/// all kinds, as Markdown. Returns the exit code.
int schema_command(bool markdown, read::FileKind kind);

}  // namespace slipbench::driver::commands
