// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {

void declare_import(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::ImportOptions>();
  CLI::App* declared =
      app.add_subcommand("import", "Write a case with the friction of a Radioss starter deck");
  declared->add_option("DECK", options->deck, "A starter deck with a /FRICTION")->required();
  declared->add_option("-o,--output", options->output, "The case file; default: the terminal")
      ->type_name("FILE");
  declared->add_option("--id", options->id, "The /FRICTION to take, if there are several")
      ->type_name("ID")
      ->check(whole_number(1, 2147483647));
  declared
      ->add_option("--units", options->units,
                   "Length, force and time the deck is in; default: those of /BEGIN")
      ->type_name("\"mm N s\"");
  declared
      ->add_option("--normal", options->normal,
                   "Normal of the contact, to judge the directions of orthotropic friction by")
      ->type_name("\"X Y Z\"");
  declare_force(*declared, options->force, "there already");
  declared->footer(
      "What a deck has no number for (stiffness, mass, area, load) is a parameter without a value\n"
      "in the case: give it there or with --set. Example:\n"
      "  slipbench import model_0000.rad --units \"mm N s\" -o pad.yaml\n"
      "  slipbench run pad.yaml --set K=5000 --set m=1e-6 --set normal_force=100 ...");
  declared->callback(
      [options, &command] { command = [options] { return commands::import_command(*options); }; });
}

}  // namespace slipbench::driver::cli
