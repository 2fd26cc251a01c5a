// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/run.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {

void declare_run(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::RunOptions>();
  CLI::App* declared = app.add_subcommand("run", "Run cases and write their results");
  declared->add_option("CASE", options->cases, "Case files (YAML); - is standard input")
      ->required();
  declared
      ->add_option("-o,--output", options->folder,
                   "Folder of the results, made if it is missing; - prints the rows instead")
      ->type_name("DIR")
      ->capture_default_str();
  declare_settings(*declared, options->settings, options->allow_outside);
  declared->add_option("--every", options->every, "Write every N-th row, and the last")
      ->type_name("N")
      ->check(whole_number(1, 1000000000));
  declare_format(*declared, options->format);
  declared->add_flag("-q,--quiet", options->quiet, "Tell only warnings, failed checks and errors");
  declared->add_flag("--no-output", options->no_output, "Write no files, only tell what happened");
  declared
      ->add_option("--explain", options->explain,
                   "Only tell why it sticks or slips at this total time; writes nothing")
      ->type_name("TIME")
      ->check(any_number());
  declared->add_flag("--solver-report", options->solver_report,
                     "Also judge what an implicit solver has to expect; writes <case>.solver.csv");
  declared->add_flag("--compare-integration", options->compare_integration,
                     "Only tell how far backward Euler is from exact integration; writes nothing");
  declared->add_flag("--converge", options->converge,
                     "Only tell what half and quarter increments change; writes nothing");
  declared->add_flag("--strict", options->strict,
                     "Warnings count as errors: of reading a case nothing is run (exit code 2), of "
                     "its run the exit code is 1");
  declare_force(*declared, options->force, "no result of its case");
  for (const char* other : {"--compare-integration", "--converge"}) {
    declared->get_option("--explain")->excludes(declared->get_option(other));
  }
  declared->footer(
      "Writes <case>.csv, .npy or .h5 (a row an increment), <case>.events.csv (every change "
      "between stick and\n"
      "slip) and <case>.json (the summary). Prints what happened and the case's own checks.\n"
      "A case from standard input is called stdin.\n"
      "Example: slipbench run shock.yaml hinge.yaml -o out --set mu=0.2 --every 10");
  declared->callback([options, &command] {
    name_cases(options->cases);
    command = [options] { return commands::run_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
