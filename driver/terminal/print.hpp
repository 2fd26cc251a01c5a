// SPDX-License-Identifier: Apache-2.0
// Printing, and whether it went well.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace slipbench::driver::terminal {

/// Everything written to standard output goes through here, so that `finish_output` knows whether
/// it arrived. What could harm a terminal, but for colours, is replaced (base::printable_lines).
void print(std::string_view text);
/// Prints what a program reads, piece by piece, as it is.
void print_data(std::string_view bytes);
/// Lets what was printed be seen now, while a long work runs.
void flush_output();
/// A message for standard error, replaced likewise.
void print_error(std::string_view text);
/// Draws on the line of standard error that the cursor is in, by the terminal's own sequences.
void draw_line(std::string_view text);
/// "slipbench: error: ..." for standard error; returns `code`. What names and files are called
/// cannot harm the terminal.
int refuse(int code, std::string_view message);

/// Flushes standard output. If something did not arrive (a closed or full one), says so on
/// standard error and returns the worse of `code` and base::kExitEnvironment. A reader that has
/// seen enough, as head has, is no trouble: nothing is said, and base::kExitOk becomes
/// base::kExitNoReader.
int finish_output(int code);

/// Tells whether colour is wanted on a stream. The first of these decides: NO_COLOR that is not
/// empty forbids it, FORCE_COLOR or CLICOLOR_FORCE that is neither empty nor 0 demands it,
/// CLICOLOR=0 forbids it; else a terminal whose TERM is neither empty nor "dumb" has it.
bool colour_wanted(int descriptor);

/// "12 ms", "0.21 s", "3.4 s".
std::string elapsed_text(std::chrono::steady_clock::duration elapsed);

}  // namespace slipbench::driver::terminal
