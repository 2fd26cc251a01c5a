// SPDX-License-Identifier: Apache-2.0
// What is typed wrongly is answered by what to type.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

struct Mistake {
  std::string typed;
  std::string fault;
};

void check_all(const std::vector<Mistake>& mistakes, const std::string& help) {
  const TemporaryFolder folder;
  folder.write("shock.yaml", "");
  for (const Mistake& mistake : mistakes) {
    INFO(mistake.typed);
    const Ended ended = slipbench(folder, mistake.typed);
    CHECK(ended.code == 2);
    CHECK(ended.output == "slipbench: error: " + mistake.fault + "\n" + help);
  }
}

TEST_CASE("a command line without a command is answered by the one that was meant") {
  check_all(
      {{"rnu shock.yaml", "no command 'rnu'; did you mean 'run'?"},
       {"RUN shock.yaml", "no command 'RUN'; did you mean 'run'?"},
       {"shock.yaml", "no command before 'shock.yaml'; did you mean 'slipbench run shock.yaml'?"},
       {"shock", "no command before 'shock'; did you mean 'slipbench run shock'?"},
       {"rows.csv", "no command before 'rows.csv'; did you mean 'slipbench plot rows.csv'?"},
       {"deck.rad", "no command before 'deck.rad'; did you mean 'slipbench import deck.rad'?"},
       {".", "no command before '.'; did you mean 'slipbench check .'?"},
       {"frobnicate", "no command 'frobnicate'; 'slipbench --help' tells which there are"},
       {"help", "no command 'help'; type 'slipbench --help' or 'slipbench run --help'"},
       {"--set a=1 run shock.yaml",
        "'--set' stands before the command; options stand behind it: slipbench run ... --set"},
       {"--verson", "no option '--verson'; did you mean '--version' or '--verbose'?"}},
      "");
  check_all({{"", "no command; wanted one, for example: slipbench run shock.yaml"}},
            "See 'slipbench --help'.\n");
}

TEST_CASE("an option that a command does not have is answered by the nearest one, or by its home") {
  check_all({{"run shock.yaml --evry 3", "run: no option '--evry'; did you mean '--every'?"},
             {"run shock.yaml --evry=3", "run: no option '--evry'; did you mean '--every'?"},
             {"run shock.yaml --junit x", "run: no option '--junit'; it is an option of 'check'"},
             {"run shock.yaml -x", "run: no option '-x'; the help lists all"}},
            "See 'slipbench run --help'.\n");
  // An unknown option is told also where an argument is missing.
  check_all({{"plot --sett a=1", "plot: no option '--sett'; did you mean '--set'?"}},
            "See 'slipbench plot --help'.\n");
}

TEST_CASE("a missing, extra or wrong value is told with what is wanted") {
  check_all(
      {{"run",
        "run: CASE is missing (Case files (YAML); - is standard input), for example: slipbench "
        "run shock.yaml hinge.yaml -o out --set mu=0.2 --every 10"},
       {"run shock.yaml --every", "run: --every wants a value: --every N"},
       {"run shock.yaml --every 0",
        "run: --every: wanted a whole number from 1 to 1000000000, found '0'"},
       {"run shock.yaml --every 2.5",
        "run: --every: wanted a whole number from 1 to 1000000000, found '2.5'"},
       {"run shock.yaml --every 2 --every 3", "run: --every is given more than once"},
       {"run shock.yaml --explain soon", "run: --explain: wanted a number, found 'soon'"},
       {"run shock.yaml --format vtk", "run: --format: unknown word 'vtk'; known: csv, npy and h5"},
       {"run shock.yaml --no-output=3", "run: --no-output takes no value"},
       {"run shock.yaml --set", "run: --set wants a value: --set NAME=VALUE"}},
      "See 'slipbench run --help'.\n");
  check_all(
      {{"list connection", "list: WHAT: unknown word 'connection'; did you mean 'connections'?"},
       {"list laws curves", "list: 'curves' is one argument too many"}},
      "See 'slipbench list --help'.\n");
}

}  // namespace
}  // namespace slipbench::driver::commands
