// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/export.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"
#include "driver/commands/arguments.hpp"

namespace slipbench::driver::cli {

void declare_export(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::ExportCommandOptions>();
  CLI::App* declared = app.add_subcommand("export", "Write a case as the deck of a solver");
  declared->add_option("CASE", options->file, "A case file (YAML)")->required();
  declared->add_option("--to", options->to, "The program whose deck it is")
      ->type_name("abaqus")
      ->check(one_of({"abaqus"}))
      ->required();
  declared->add_option("-o,--output", options->output, "The deck; default: the terminal")
      ->type_name("FILE");
  declared
      ->add_option("--part", options->part,
                   "Only *CONNECTOR BEHAVIOR, to be pasted into a model that is there")
      ->type_name("behaviour")
      ->check(one_of({"behaviour"}));
  declared
      ->add_option("--digits", options->digits,
                   "Round numbers to so many digits, and say what was rounded")
      ->type_name("N")
      ->check(whole_number(2, 17));
  declare_settings(*declared, options->settings, options->allow_outside);
  declare_force(*declared, options->force, "there already");
  declared->footer(
      "The deck has two nodes and the connector, and its history as motions, loads and "
      "amplitudes:\n"
      "it runs as it stands. Tells on standard error what is approximated and what is dropped. A\n"
      "case that Abaqus has no joint for is refused with the reason.\n"
      "Example: slipbench export press_fit.yaml --to abaqus -o press_fit.inp");
  declared->callback([options, &command] {
    options->file = commands::named_case(options->file);
    command = [options] { return commands::export_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
