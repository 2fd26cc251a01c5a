// SPDX-License-Identifier: Apache-2.0
// Faults of a command line, in words that say what to type.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
class ParseError;
}  // namespace CLI

namespace slipbench::driver::cli {

/// The fault of words after the program's name that do not begin with a command or an option of
/// the program, or hold what could harm a terminal, a log or a script that is written; empty if
/// there is none.
std::string fault_of_command(const CLI::App& app, std::span<const std::string_view> words);

/// Returns what parsing refused, and with which command's help to go on: two lines.
std::string fault_of_options(const CLI::App& app, const CLI::ParseError& error);

}  // namespace slipbench::driver::cli
