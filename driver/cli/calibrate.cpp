// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/calibrate.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/calibrate/fit_text.hpp"
#include "driver/cli/declare.hpp"
#include "driver/commands/arguments.hpp"

namespace slipbench::driver::cli {

void declare_calibrate(CLI::App& app, Command& command) {
  const auto options = std::make_shared<commands::CalibrateOptions>();
  CLI::App* declared =
      app.add_subcommand("calibrate", "Fit parameters and tables of cases to measured data");
  declared->add_option("FIT", options->file, "A fit file (YAML)")->required();
  declared
      ->add_option("-o,--output", options->folder, "Folder of the results, made if it is missing")
      ->type_name("DIR")
      ->capture_default_str();
  declare_settings(*declared, options->settings, options->allow_outside);
  declared
      ->add_option("--bootstrap", options->bootstrap,
                   "Also errors by so many resamplings of the residuals")
      ->type_name("N")
      ->check(whole_number(1, calibrate::kMostResamplings));
  declared->add_flag("--profile", options->profile,
                     "Also the profile likelihood of every parameter");
  declared
      ->add_option(
          "--report", options->report,
          "The HTML page, with the pictures beside it; default: <fit>.html in the folder of "
          "the results")
      ->type_name("FILE");
  declared->add_flag("--no-output", options->no_output, "Write no files, only tell what was found");
  declare_force(*declared, options->force, "no result of this fit");
  declared->footer(
      "Writes <fit>.json (all figures), <fit>.html and <fit>.*.svg (measured against fitted), and\n"
      "<case>.calibrated.yaml, the case with the values found, ready to run. Exit code 3 if the\n"
      "search did not converge; the reason is told in words.\n"
      "Example: slipbench calibrate rig_fit.yaml -o out --bootstrap 200");
  declared->callback([options, &command] {
    options->file = commands::named_case(options->file);
    command = [options] { return commands::calibrate_command(*options); };
  });
}

}  // namespace slipbench::driver::cli
