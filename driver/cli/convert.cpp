// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/convert.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {

void declare_convert(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::ConvertOptions>();
  CLI::App* declared =
      app.add_subcommand("convert", "Write the rows of a result in another format");
  declared->add_option("FILE", options->file, "Rows of a result: .csv, .npy or .h5")->required();
  declared->add_option("-o,--output", options->target, "The file to write: .csv, .npy or .h5")
      ->type_name("FILE")
      ->required();
  declare_force(*declared, options->force, "another table");
  declared->footer(
      "Every number keeps its bits. HDF5 keeps the lines that say where the rows come from, and\n"
      "the units; npy has no place for them.\n"
      "Example: slipbench convert out/shock.csv -o shock.npy");
  declared->callback(
      [options, &command] { command = [options] { return commands::convert_command(*options); }; });
}

}  // namespace slipbench::driver::cli
