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
  declare_deck_target(*declared, options->deck);
  declare_settings(*declared, options->settings, options->allow_outside);
  declared->footer(
      "An Abaqus deck has two nodes and the connector, and its history as motions, loads and\n"
      "amplitudes: it runs as it stands. Radioss, LS-DYNA and OpenSees get the friction of a "
      "contact,\n"
      "to be put into a model; table is the coefficient over slip rate and contact force as CSV. "
      "Tells\n"
      "on standard error what is kept, approximated and dropped, and what that changes on the "
      "case's\n"
      "history. What a program has no word for is refused with the reason. Examples:\n"
      "  slipbench export press_fit.yaml --to abaqus -o press_fit.inp\n"
      "  slipbench export press_fit.yaml --to lsdyna --part behaviour --digits 4");
  declared->callback([options, &command] {
    options->file = commands::named_case(options->file);
    command = [options] { return commands::export_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
