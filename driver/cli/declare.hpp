// SPDX-License-Identifier: Apache-2.0
// The commands of the program with their options, one file a command.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
class Validator;
}  // namespace CLI

namespace slipbench::driver::commands {
struct DeckOutputOptions;
struct ImportOptions;
}  // namespace slipbench::driver::commands

namespace slipbench::driver::cli {

/// The command that was typed, with its options: runs it and returns the exit code.
using Command = std::function<int()>;

/// Adds a subcommand; where it is typed, parsing puts it with its options into `command`, which
/// must outlive the parsing.
using Declare = void(CLI::App& app, Command& command);
Declare declare_run, declare_check, declare_bless, declare_plot, declare_report, declare_calibrate,
    declare_sweep, declare_merge, declare_convert, declare_import, declare_export,
    declare_translate, declare_list, declare_describe, declare_new, declare_schema,
    declare_completion;

/// In the order of the help.
inline constexpr std::array kCommands{
    declare_run,       declare_check,     declare_bless, declare_plot,     declare_report,
    declare_calibrate, declare_sweep,     declare_merge, declare_convert,  declare_import,
    declare_export,    declare_translate, declare_list,  declare_describe, declare_new,
    declare_schema,    declare_completion};

/// Commit, compiler and libraries of this build, a line each; the build writes it.
const char* build_facts();

/// Adds the options that every command with cases has, '--set' and '--allow-outside'.
void declare_settings(CLI::App& command, std::vector<std::string>& settings, bool& allow_outside);

/// Refuses a value that is no whole number from `first` to `last`, one that is no number, or none
/// from `first` to `last`, and one that is none of the words, each in a sentence.
CLI::Validator whole_number(int first, int last);
CLI::Validator any_number();
CLI::Validator number_between(double first, double last);
CLI::Validator one_of(std::vector<std::string> words);

/// Adds '--format', in which rows are written.
void declare_format(CLI::App& command, std::string& format);

/// Adds '--force', with which a command replaces a file that is `what`: "no result of its case".
void declare_force(CLI::App& command, bool& force, const std::string& what);

/// Adds the deck that is read, which joint or contact of it, and its units.
void declare_deck_source(CLI::App& command, commands::ImportOptions& options);

/// Adds the program whose deck is written, its form, and where it goes.
/// \param more targets besides programs that have decks
void declare_deck_target(CLI::App& command, commands::DeckOutputOptions& options,
                         std::span<const std::string_view> more = {});

/// Completes names of cases that were given without their ending.
void name_cases(std::vector<std::string>& paths);

}  // namespace slipbench::driver::cli
