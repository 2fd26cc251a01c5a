// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "driver/cli/declare.hpp"
#include "driver/commands/catalogue.hpp"

namespace slipbench::driver::cli {

void declare_describe(CLI::App& app, Command& command) {
  const auto name = std::make_shared<std::string>();
  CLI::App* declared = app.add_subcommand(
      "describe",
      "Describe a connection type, law, key, closed form, curve, criterion or quantity");
  declared->add_option("NAME", *name, "A name that 'slipbench list' shows")->required();
  declared->footer("Example: slipbench describe CYLINDRICAL");
  declared->callback(
      [name, &command] { command = [name] { return commands::describe_command(*name); }; });
}

}  // namespace slipbench::driver::cli
