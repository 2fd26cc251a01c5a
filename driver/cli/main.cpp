// SPDX-License-Identifier: Apache-2.0
// The command line: what is typed becomes the options of a command.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/interruption.hpp"
#include "driver/base/text/inputs_read.hpp"
#include "driver/cli/declare.hpp"
#include "driver/cli/faults.hpp"
#include "driver/results/provenance.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::cli {
namespace {

/// A closed standard stream would give its number to the next file opened, and messages would end
/// up in a result. A stand-in that refuses the wrong direction makes them fail instead.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // The lowest free number is the closed stream's, since those below it are open by now.
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

/// Stands before a word in brackets while it is parsed; no typed word has it, see fault_of_command.
constexpr char kAsTyped = '\1';

/// Returns the words of a command line, the last one first, as the library parses them. It would
/// take "[a,b]" for two words; a file may be called so.
std::vector<std::string> as_parsed(std::span<const std::string_view> words) {
  std::vector<std::string> all(words.rbegin(), words.rend());
  for (std::string& word : all) {
    if (word.starts_with('[') && word.ends_with(']')) word.insert(word.begin(), kAsTyped);
  }
  return all;
}

int run(int argc, char** argv) {
  CLI::App app(
      "A test bench for connector friction: a case in YAML is run increment by increment\n"
      "and gives forces, slip and energies as CSV, verdicts and pictures.",
      "slipbench");
  app.footer(
      "Examples:\n"
      "  slipbench run shock.yaml                      run a case; shock.csv is the result\n"
      "  slipbench run shock.yaml --set mu=0.2 -o out  the same with another parameter value\n"
      "  slipbench check cases/                        run all cases and judge their checks\n"
      "  slipbench plot shock.yaml -o shock.svg        force against time and motion\n"
      "  slipbench new HINGE -o hinge.yaml             a minimal case to begin with\n"
      "  slipbench list connections                    what a case may use\n"
      "  slipbench describe CYLINDRICAL                one of them in detail\n"
      "'slipbench COMMAND --help' tells more about a command.\n"
      "Exit codes: 0 all well, 1 a check failed, 2 bad input, 3 numerical failure,\n"
      "4 file or environment, 70 internal error, 130/143 interrupted, 141 broken pipe.");
  const std::vector<std::string_view> words(argv + std::min(argc, 1), argv + argc);
  std::string version = "slipbench " + std::string(results::program_version());
  // --version ends the parsing, so that what stands beside it is looked for here.
  if (std::find(words.begin(), words.end(), "--verbose") != words.end()) {
    version += "\n" + std::string(build_facts());
  }
  CLI::Option* const told = app.set_version_flag("--version", version);
  app.add_flag_function(
         "--verbose", [](std::int64_t) {},
         "With --version: commit, compiler and libraries of the build")
      ->needs(told);
  app.require_subcommand(1);
  Command command;
  for (Declare* const declare : kCommands) declare(app, command);

  for (CLI::App* declared : app.get_subcommands(nullptr)) {
    for (CLI::Option* option : declared->get_options()) {
      if (option->get_expected_max() == 0) {
        option->disable_flag_override();
        continue;
      }
      // Nor is that of "--set=[a,b]"; only what stands without a name may be several words.
      if (!option->get_positional()) option->allow_extra_args(false);
      option->transform([](std::string word) {
        if (word.starts_with(kAsTyped)) word.erase(word.begin());
        return word;
      });
      option->check([](const std::string& word) {
        return std::string(word.empty() ? "an empty text; is a variable of the shell not set?"
                                        : "");
      });
    }
  }
  if (const std::string fault = fault_of_command(app, words); !fault.empty()) {
    terminal::print_error("slipbench: error: " + fault + "\n");
    return base::kExitBadInput;
  }
  try {
    app.parse(as_parsed(words));
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) {
      terminal::print(out.str());
      return base::kExitOk;
    }
    std::string fault = fault_of_options(app, error);
    std::erase(fault, kAsTyped);
    terminal::print_error(fault);
    return base::kExitBadInput;
  }
  return command();
}

}  // namespace
}  // namespace slipbench::driver::cli

int main(int argc, char** argv) {
  using namespace slipbench::driver;
  using namespace slipbench::driver::cli;
  fill_closed_streams();
  base::handle_interruption();
  base::remember_inputs();
  try {
    return terminal::finish_output(run(argc, argv));
  } catch (const std::bad_alloc&) {
    return terminal::finish_output(
        terminal::refuse(base::kExitEnvironment, "this needs more memory than there is"));
  } catch (const std::exception& error) {
    terminal::print_error(fmt::format("slipbench: internal error: {}\n", error.what()));
    return base::kExitInternal;
  }
}
