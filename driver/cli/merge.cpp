// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/merge.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"
#include "driver/commands/arguments.hpp"

namespace slipbench::driver::cli {

void declare_merge(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::MergeOptions>();
  CLI::App* declared = app.add_subcommand("merge", "Join the parts of a sweep into one result");
  declared->add_option("SWEEP", options->file, "The sweep file (YAML)")->required();
  declared->add_option("PARTS", options->parts,
                       "Results of 'sweep --part' and journals; default: all those in DIR");
  declared
      ->add_option("-o,--output", options->folder, "Folder of the result, made if it is missing")
      ->type_name("DIR")
      ->capture_default_str();
  declare_settings(*declared, options->settings, options->allow_outside);
  declare_format(*declared, options->format);
  declared->add_option("--report", options->report, "Also write a page to look at: FILE.html")
      ->type_name("FILE");
  declare_force(*declared, options->force, "no result of this sweep");
  declared->footer(
      "Writes <sweep>.csv with the bytes of a sweep that was never divided, and keeps the parts.\n"
      "Refuses parts of another sweep, of other inputs or settings, and says which are missing.\n"
      "Exit code 3 if a sample failed.\n"
      "Example: slipbench merge loop_sweep.yaml -o out");
  declared->callback([options, &command] {
    options->file = commands::named_case(options->file);
    command = [options] { return commands::merge_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
