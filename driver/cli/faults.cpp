// SPDX-License-Identifier: Apache-2.0
#include "driver/cli/faults.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/suggestions.hpp"

namespace slipbench::driver::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

/// "--every", "-o", ..: the ways to write the options of a command.
std::vector<std::string> flags_of(const CLI::App& command) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    for (const std::string& name : option->get_snames()) flags.push_back("-" + name);
  }
  return flags;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Without the value behind '='.
std::string_view flag_of(std::string_view word) { return word.substr(0, word.find('=')); }

std::string in_quotes(std::string_view word) { return "'" + base::printable(word) + "'"; }

/// The commands that have an option, in words; empty if none has.
std::string commands_with(const CLI::App& app, std::string_view flag) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (contains(flags_of(*command), flag)) names.push_back(in_quotes(command->get_name()));
  }
  return base::few_in_words(std::vector<std::string_view>(names.begin(), names.end()));
}

/// The command for a file of this kind, if the word names one.
std::string_view command_for_file(std::string_view word) {
  struct Ending {
    std::string_view text;
    std::string_view command;
  };
  static constexpr std::array<Ending, 4> kEndings{
      {{".yaml", "run"}, {".yml", "run"}, {".csv", "plot"}, {".rad", "import"}}};
  for (const Ending& ending : kEndings) {
    if (word.ends_with(ending.text)) return ending.command;
  }
  std::error_code error;
  if (fs::is_directory(word, error)) return "check";
  return fs::is_regular_file(std::string(word) + ".yaml", error) ? "run" : "";
}

std::string unknown_flag(const CLI::App& app, const CLI::App& command, std::string_view word) {
  const std::vector<std::string> flags = flags_of(command);
  const std::string others = commands_with(app, flag_of(word));
  return "no option " + in_quotes(flag_of(word)) + "; " +
         (others.empty()
              ? base::did_you_mean(flag_of(word),
                                   std::vector<std::string_view>(flags.begin(), flags.end()),
                                   "the help lists all")
              : "it is an option of " + others);
}

/// The first example in the help of a command, or what is to be typed in its place.
std::string example_of(const CLI::App& command) {
  const std::string footer = command.get_footer();
  const std::size_t begin = footer.find("slipbench " + command.get_name());
  return begin == std::string::npos ? "" : footer.substr(begin, footer.find('\n', begin) - begin);
}

/// An option with its value as the help writes it: "--every N"; the name alone of an argument.
std::string written(const CLI::Option& option) {
  if (option.nonpositional()) return option.get_name() + " " + option.get_type_name();
  return option.get_name();
}

/// The option that a message of the library begins with or ends with, if any.
const CLI::Option* option_in(const CLI::App& command, std::string_view message) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    // A flag that was given a value is told without its dashes.
    if (message.starts_with(name + ":") || message.starts_with(name + " ") ||
        message.starts_with(name.substr(std::min<std::size_t>(2, name.size())) + " was given") ||
        message.find(": " + name + " =") != std::string_view::npos) {
      return option;
    }
  }
  return nullptr;
}

std::string fault_in(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
  const std::vector<std::string> left = command.remaining();
  for (const std::string& word : left) {
    if (word.size() > 1 && word.front() == '-') return unknown_flag(app, command, word);
  }
  if (!left.empty()) return in_quotes(left.front()) + " is one argument too many";
  std::string message = error.what();
  const CLI::Option* option = option_in(command, message);
  if (option == nullptr) return message;
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return fmt::format("{} is missing ({}), for example: {}", written(*option),
                       option->get_description(), example_of(command));
  }
  if (option->get_expected_max() == 0) return option->get_name() + " takes no value";
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return message;
  if (option->count() > 1) return option->get_name() + " is given more than once";
  return fmt::format("{} wants a value: {}", option->get_name(), written(*option));
}

}  // namespace

std::string fault_of_command(const CLI::App& app, std::span<const std::string_view> words) {
  if (words.empty()) return {};
  for (const std::string_view word : words) {
    if (base::printable(word) == word) continue;
    return in_quotes(word) +
           " holds control characters, marks that turn the direction of writing, or bytes that are "
           "no UTF-8, which no name may; rename the file";
  }
  const std::vector<std::string> commands = command_names(app);
  const std::string_view word = words.front();
  if (contains(commands, word) || contains(flags_of(app), flag_of(word))) return {};
  if (word == "help") return "no command 'help'; type 'slipbench --help' or 'slipbench run --help'";
  if (word.size() > 1 && word.front() == '-') {
    if (commands_with(app, flag_of(word)).empty()) return unknown_flag(app, app, word);
    const auto command = std::find_if(words.begin(), words.end(), [&](std::string_view candidate) {
      return contains(commands, candidate);
    });
    return fmt::format("{} stands before the command; options stand behind it: slipbench {} ... {}",
                       in_quotes(flag_of(word)), command == words.end() ? "COMMAND" : *command,
                       base::printable(word));
  }
  if (const std::string_view command = command_for_file(word); !command.empty()) {
    return fmt::format("no command before {}; did you mean 'slipbench {} {}'?", in_quotes(word),
                       command, base::printable(word));
  }
  return fmt::format(
      "no command {}; {}", in_quotes(word),
      base::did_you_mean(word, std::vector<std::string_view>(commands.begin(), commands.end()),
                         "'slipbench --help' tells which there are"));
}

std::string fault_of_options(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> typed = app.get_subcommands();
  if (typed.empty()) {
    return "slipbench: error: no command; wanted one, for example: slipbench run shock.yaml\n"
           "See 'slipbench --help'.\n";
  }
  const CLI::App& command = *typed.front();
  return fmt::format("slipbench: error: {0}: {1}\nSee 'slipbench {0} --help'.\n",
                     command.get_name(), base::printable(fault_in(app, command, error)));
}

}  // namespace slipbench::driver::cli
