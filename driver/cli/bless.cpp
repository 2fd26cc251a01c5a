// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/bless.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"
#include "driver/commands/arguments.hpp"

namespace slipbench::driver::cli {

void declare_bless(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::BlessOptions>();
  CLI::App* declared =
      app.add_subcommand("bless", "Accept today's curves of a case as its golden curves");
  declared->add_option("CASE", options->file, "A case file (YAML)")->required();
  declared
      ->add_option("--reason", options->reason,
                   "Why today's curve is right; it is kept in the golden file")
      ->type_name("TEXT")
      ->required();
  declare_settings(*declared, options->settings, options->allow_outside);
  declared->footer(
      "Writes the files that the case's checks name as 'against: {curve: ..}', if they are "
      "missing\n"
      "or golden curves already; never anybody else's reference.\n"
      "Example: slipbench bless belt.yaml --reason \"new liner, mu 0.16\"");
  declared->callback([options, &command] {
    options->file = commands::named_case(options->file);
    command = [options] { return commands::bless_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
