// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"
#include "driver/commands/new_case.hpp"

namespace slipbench::driver::cli {

void declare_new(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::NewOptions>();
  CLI::App* declared =
      app.add_subcommand("new", "Print a minimal case of a connection type, to begin with");
  declared->add_option("TYPE", options->type, "A type that 'slipbench list connections' shows")
      ->required();
  declared
      ->add_option("-o,--output", options->output,
                   "The case file, which must not be there yet; default: the terminal")
      ->type_name("FILE");
  declared->footer(
      "The case runs and passes its check: slipbench check hinge.yaml\n"
      "Example: slipbench new HINGE -o hinge.yaml");
  declared->callback(
      [options, &command] { command = [options] { return commands::new_command(*options); }; });
}

}  // namespace slipbench::driver::cli
