// SPDX-License-Identifier: Apache-2.0
// Files that a command has read, which its output must not take the place of.
#pragma once

#include <filesystem>

namespace slipbench::driver::base {

/// Begins to remember the files that are read. For a program that ends with its command: in a
/// library, what was read long ago may well be written.
void remember_inputs();

/// Remembers an open file, by its device and number, so that any of its names stands for it.
void note_input(int descriptor);

/// Tells whether a file was read, links followed.
bool was_read(const std::filesystem::path& file);

}  // namespace slipbench::driver::base
