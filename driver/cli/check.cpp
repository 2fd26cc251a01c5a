// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/check.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/base/files/work_crew.hpp"
#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {

void declare_check(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::CheckOptions>();
  CLI::App* declared = app.add_subcommand("check", "Run cases and judge their checks");
  declared
      ->add_option("PATH", options->paths,
                   "Case files, or folders that are searched for *.yaml and *.yml; - is standard "
                   "input; default: this folder")
      ->expected(0, -1);
  declared->add_option("-j,--jobs", options->jobs, "Threads; default: one a core")
      ->type_name("N")
      ->check(whole_number(1, base::kMostThreads));
  declare_settings(*declared, options->settings, options->allow_outside);
  declared
      ->add_option("--filter", options->filters,
                   "Only cases whose name matches: a part of it, or a pattern with * and ?")
      ->type_name("PATTERN")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  declared->add_flag("--failed-first", options->failed_first,
                     "Begin with the cases that did not pass last time");
  declared->add_flag("--fail-fast", options->fail_fast,
                     "Stop at the first case that does not pass");
  declared->add_flag("-q,--quiet", options->quiet, "Of the table, only the cases that do not pass");
  declared
      ->add_option("--durations", options->durations,
                   "Also tell the N slowest cases and their times; 0 for all")
      ->type_name("N")
      ->check(whole_number(0, 1000000000));
  declared->add_flag("--strict", options->strict, "A case with a warning fails");
  declared->add_option("--junit", options->junit, "Also write the verdicts as JUnit XML")
      ->type_name("FILE");
  declared->add_option("--json", options->json, "Also write the verdicts as JSON")
      ->type_name("FILE");
  declared->add_option("--report", options->report, "Also write an HTML page of the cases")
      ->type_name("FILE");
  declare_force(*declared, options->force, "not of its kind");
  declared->footer(
      "Writes the files asked for, and remembers in the user's cache which cases did not pass.\n"
      "Folders named 'bad' and hidden files and folders are not searched.\n"
      "Exit code 1 if a check failed. In GitHub Actions, failures are also annotations and a "
      "summary.\n"
      "Example: slipbench check cases/ -j 4 --junit slip.xml --report slip.html");
  declared->callback([options, &command] {
    if (options->paths.empty()) options->paths = {"."};
    name_cases(options->paths);
    command = [options] { return commands::check_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
