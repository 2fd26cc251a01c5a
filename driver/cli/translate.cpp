// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/translate.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {

void declare_translate(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::TranslateOptions>();
  CLI::App* declared = app.add_subcommand(
      "translate", "Put a joint or contact of a deck into another program's words");
  declare_deck_source(*declared, options->source);
  declare_deck_target(*declared, options->deck);
  declared->add_flag("--all", options->source.all,
                     "A deck each of all joints with friction, into DIR of -o");
  declared
      ->add_option(
          "--set", options->settings,
          "What the deck has no number for, as a load: where the other deck depends on it, "
          "and to measure the difference")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  declared->footer(
      "Reads as 'import' does and writes as 'export' does: tells on standard error what is kept,\n"
      "approximated and dropped, and once all numbers are given what that changes. Examples:\n"
      "  slipbench translate model_0000.rad --interface 6 --to lsdyna -o contact.k\n"
      "  slipbench translate model.inp --connector 7 --to radioss --set f2=300 --set f3=0 ...");
  declared->callback([options, &command] {
    command = [options] { return commands::translate_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
