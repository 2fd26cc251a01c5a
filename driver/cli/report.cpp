// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/report.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"

namespace slipbench::driver::cli {

void declare_report(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::ReportOptions>();
  CLI::App* declared =
      app.add_subcommand("report", "Write an HTML page about cases and results, to look at");
  declared
      ->add_option("CASE|RESULT.csv", options->inputs,
                   "Case files, folders that are searched for them, or results of 'run'")
      ->required();
  declared->add_option("-o,--output", options->output, "The page")
      ->type_name("FILE.html")
      ->required();
  declared->add_option("--title", options->title, "Title of the page")->type_name("TEXT");
  declare_settings(*declared, options->settings, options->allow_outside);
  declared->add_flag("--live", options->live,
                     "Cases can be changed and run in the page, offline: an editor, a slider for "
                     "each parameter (built by scripts/wasm.sh)");
  declare_force(*declared, options->force, "no such page");
  declared->footer(
      "One file that opens offline in any browser: verdicts, loops and histories, events, energy.\n"
      "Example: slipbench report cases/ -o report.html");
  declared->callback([options, &command] {
    name_cases(options->inputs);
    command = [options] { return commands::report_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
