// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Returns what bash offers for the last of these words.
std::string offered(const TemporaryFolder& folder, const std::string& words) {
  const Ended ended = shell(
      folder, "bash -uc 'source <(\"" + kProgram + "\" completion bash); COMP_WORDS=(slipbench " +
                  words +
                  "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _slipbench; echo ${COMPREPLY[*]-}'");
  REQUIRE(ended.code == 0);
  return ended.output;
}

TEST_CASE("bash completes commands, their options and the words that these take") {
  const TemporaryFolder folder;
  CHECK(offered(folder, "re") == "report\n");
  CHECK(offered(folder, "c") == "check calibrate convert completion\n");
  CHECK(offered(folder, "run --ex") == "--explain\n");
  CHECK(offered(folder, "run a.yaml --format \"\"") == "csv npy h5\n");
  CHECK(offered(folder, "run a.yaml --format n") == "npy\n");
  CHECK(offered(folder, "list c") == "connections closed-forms curves criteria\n");
  CHECK(offered(folder, "export a.yaml --to r") == "radioss\n");
  // Files and names of the user are left to the shell.
  CHECK(offered(folder, "run a.yaml --set --ex") == "\n");
  CHECK(offered(folder, "run \"\"") == "\n");
}

/// Returns what zsh has to offer for the last of these words at the first call of the function that
/// it loads from a folder, as an installation has it.
std::string offered_by_zsh(const TemporaryFolder& folder, const std::string& words) {
  const Ended ended = shell(
      folder,
      "\"" + kProgram +
          "\" completion zsh > _slipbench && zsh -fc 'fpath=(. $fpath); autoload -U _slipbench;"
          " compdef() { print compdef }; _describe() { print -l ${(P)2} };"
          " _arguments() { print -l -- \"$@\" }; words=(slipbench " +
          words + "); CURRENT=${#words}; _slipbench'");
  REQUIRE(ended.code == 0);
  return ended.output;
}

TEST_CASE("zsh completes at the first call of what it loads, and by what it reads") {
  const TemporaryFolder folder;
  const std::string commands = offered_by_zsh(folder, "re");
  CHECK(contains(commands, "report:"));
  CHECK(contains(commands, "completion:"));
  CHECK_FALSE(contains(commands, "compdef"));
  const std::string run = offered_by_zsh(folder, "run --ex");
  CHECK(contains(run, "*--explain["));
  CHECK(contains(run, ":value:(csv npy h5)"));
  const Ended read = shell(folder, "zsh -fc 'compdef() { print $@ }; source ./_slipbench'");
  CHECK(read.output == "_slipbench slipbench\n");
}

TEST_CASE("fish completes commands, their options and the words that these take") {
  const TemporaryFolder folder;
  const auto offered_by_fish = [&](const std::string& typed) {
    const Ended ended = shell(folder, "HOME=. fish --no-config -c '\"" + kProgram +
                                          "\" completion fish | source; complete -C \"slipbench " +
                                          typed + "\" | cut -f 1'");
    REQUIRE(ended.code == 0);
    return ended.output;
  };
  CHECK(offered_by_fish("re") == "report\n");
  CHECK(offered_by_fish("run --ex") == "--explain\n");
  CHECK(offered_by_fish("run a.yaml --format n") == "npy\n");
  CHECK(offered_by_fish("export a.yaml --to r") == "radioss\n");
}

TEST_CASE("every command of the help is in the completion of every shell") {
  const TemporaryFolder folder;
  const Ended help = slipbench(folder, "--help");
  std::istringstream lines(help.output.substr(help.output.find("Subcommands:")));
  std::vector<std::string> commands;
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    if (line.starts_with("  ")) commands.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  REQUIRE(commands.size() > 10);
  for (const char* const name : {"bash", "zsh", "fish"}) {
    const Ended script = slipbench(folder, std::string("completion ") + name);
    REQUIRE(script.code == 0);
    for (const std::string& command : commands) {
      CAPTURE(name, command);
      CHECK(contains(script.output, command));
    }
  }
  CHECK(slipbench(folder, "completion tcsh").code == 2);
}

}  // namespace
}  // namespace slipbench::driver::commands
