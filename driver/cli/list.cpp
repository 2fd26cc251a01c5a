// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "driver/cli/declare.hpp"
#include "driver/commands/catalogue.hpp"

namespace slipbench::driver::cli {

void declare_list(CLI::App& app, Command& command) {
  const auto what = std::make_shared<std::string>();
  CLI::App* declared = app.add_subcommand("list", "List what a case may use");
  declared->add_option("WHAT", *what, "One kind only")
      ->type_name("connections|laws|keys|closed-forms|curves|criteria|quantities")
      ->check(one_of(
          {"connections", "laws", "keys", "closed-forms", "curves", "criteria", "quantities"}));
  declared->footer("Example: slipbench list connections");
  declared->callback(
      [what, &command] { command = [what] { return commands::list_command(*what); }; });
}

}  // namespace slipbench::driver::cli
