// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/export.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/export_law.hpp"

namespace slipbench::driver::cli {

void declare_export(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::ExportCommandOptions>();
  CLI::App* declared = app.add_subcommand(
      "export", "Write a case as the deck of a solver, or as a unit of a simulator");
  declared->add_option("CASE", options->file, "A case file (YAML)")->required();
  declare_deck_target(*declared, options->deck, commands::kLawTargets);
  declare_settings(*declared, options->settings, options->allow_outside);
  declared->footer(
      "An Abaqus deck has two nodes and the connector, and its history as motions, loads and\n"
      "amplitudes: it runs as it stands. Radioss, LS-DYNA and OpenSees get the friction of a "
      "contact,\n"
      "to be put into a model; table is the coefficient over slip rate and contact force as CSV.\n"
      "fmu is a functional mock-up unit (FMI 2.0) for system simulators: they set positions and "
      "forces\n"
      "and get friction forces; numbers are those of the friction for slip_law_unpack of the C\n"
      "interface. Tells on standard error what is kept, approximated and dropped, and what that "
      "changes\n"
      "on the case's history. What a program has no word for is refused with the reason. "
      "Examples:\n"
      "  slipbench export press_fit.yaml --to abaqus -o press_fit.inp\n"
      "  slipbench export press_fit.yaml --to lsdyna --part behaviour --digits 4\n"
      "  slipbench export hinge.yaml --to fmu -o hinge.fmu");
  declared->callback([options, &command] {
    options->file = commands::named_case(options->file);
    command = [options] { return commands::export_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
