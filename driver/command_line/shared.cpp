// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/shared.hpp"

#include <CLI/CLI.hpp>

#include "driver/command_line/declare.hpp"

namespace slipbench::driver {

void declare_settings(CLI::App& command, std::vector<std::string>& settings, bool& allow_outside) {
  command
      .add_option("--set", settings,
                  "Give a parameter of the case another value; a number or an expression")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--allow-outside", allow_outside,
                   "Let the case read data files outside its own folder");
}

void name_cases(std::vector<std::string>& paths) {
  for (std::string& path : paths) path = named_case(path);
}

}  // namespace slipbench::driver
