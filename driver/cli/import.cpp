// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {

void declare_import(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::ImportOptions>();
  CLI::App* declared =
      app.add_subcommand("import", "Make cases of the joints and contacts of a solver's deck");
  declare_deck_source(*declared, *options);
  declared
      ->add_option("-o,--output", options->output,
                   "The case file; default: the terminal. With --all a folder")
      ->type_name("FILE|DIR");
  declared
      ->add_option("--history", options->history,
                   "Abaqus: CSV with results of the model over time (CRF2, CTM3, CP1): in place of "
                   "the parameters")
      ->type_name("FILE.csv");
  declared->add_flag("--all", options->all,
                     "A case each of all joints with friction, into DIR of -o");
  declared->add_flag("--json", options->json,
                     "Print what is asked for, kept, approximated and dropped as JSON");
  declare_force(*declared, options->force, "there already");
  declared->footer(
      "Tells on standard error what the deck has, and what is passed over and why. What a deck "
      "has\n"
      "no number for (of Abaqus the constraint forces, which are results of the model; of Radioss\n"
      "stiffness, mass, area, load) is a parameter without a value in the case: give it there or\n"
      "with --set. A deck with a fault is refused with its line, and nothing is written. "
      "Examples:\n"
      "  slipbench import model.inp --all -o cases\n"
      "  slipbench run cases/model_7.yaml --set f2=300 --set f3=400 ...\n"
      "  slipbench import model_0000.rad --units \"mm N s\" -o pad.yaml\n"
      "  slipbench run pad.yaml --set K=5000 --set m=1e-6 --set normal_force=100 ...");
  declared->callback(
      [options, &command] { command = [options] { return commands::import_command(*options); }; });
}

}  // namespace slipbench::driver::cli
