// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/sweep.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/base/files/work_crew.hpp"
#include "driver/cli/declare.hpp"
#include "driver/commands/arguments.hpp"

namespace slipbench::driver::cli {

void declare_sweep(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::SweepOptions>();
  CLI::App* declared = app.add_subcommand("sweep", "Run a case with many values of its parameters");
  declared->add_option("SWEEP", options->file, "A sweep file (YAML)")->required();
  declared
      ->add_option("-o,--output", options->folder, "Folder of the result, made if it is missing")
      ->type_name("DIR")
      ->capture_default_str();
  declare_settings(*declared, options->settings, options->allow_outside);
  declare_format(*declared, options->format);
  declared->add_option("--report", options->report, "Also write a page to look at: FILE.html")
      ->type_name("FILE");
  declared->add_option("-j,--jobs", options->threads, "Threads; default: one a core")
      ->type_name("N")
      ->check(whole_number(1, base::kMostThreads));
  declared
      ->add_option("--part", options->part,
                   "Only part I of N of the samples, for any engine that starts many programs")
      ->type_name("I/N");
  declared
      ->add_option("--emit", options->emit,
                   "Run nothing; write <sweep>.slurm, a job array of parts of some minutes")
      ->type_name("slurm")
      ->check(one_of({"slurm"}));
  declared
      ->add_option("--rate", options->rate,
                   "With --emit: samples a second and core; default: some are run to find it")
      ->type_name("N")
      ->check(number_between(1e-6, 1e9));
  declared->add_flag(
      "--no-rows", options->no_rows,
      "Write the summaries only, however many samples; of a part <sweep>.IofN.tally");
  declared->add_flag("--no-output", options->no_output, "Write no file, only tell what was found");
  declare_force(*declared, options->force, "no result of this sweep");
  declared->get_option("--rate")->needs(declared->get_option("--emit"));
  declared->get_option("--part")->excludes(declared->get_option("--emit"));
  declared->get_option("--format")->excludes(declared->get_option("--no-rows"));
  declared->footer(
      "Writes <sweep>.csv, .npy or .h5, or <sweep>.IofN.csv of a part: a row a sample, with its "
      "id, the values\n"
      "of the varied parameters, and what was collected (nan where the run failed). The same "
      "bytes\n"
      "whatever the threads; the rows of all parts, one after the other, are those of the whole:\n"
      "'slipbench merge' joins them. What was run is kept in <sweep>.journal meanwhile: "
      "interrupted,\n"
      "the same command goes on from there.\n"
      "<sweep>.json has spread, quantiles, histogram and correlations of each number.\n"
      "Exit code 3 if a sample failed.\n"
      "Example: slipbench sweep loop_sweep.yaml -o out");
  declared->callback([options, &command] {
    options->file = commands::named_case(options->file);
    command = [options] { return commands::sweep_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
