// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>

#include "driver/cli/declare.hpp"
#include "driver/commands/catalogue.hpp"

namespace slipbench::driver::cli {

void declare_schema(CLI::App& app, Command& command) {
  CLI::App* declared = app.add_subcommand(
      "schema", "Print the JSON Schema of case, fit or sweep files, for editors");
  struct Options {
    bool markdown = false;
    bool fit = false;
    bool sweep = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::Option* fit = declared->add_flag("--fit", options->fit,
                                        "Print the schema of fit files, which calibrate reads");
  declared
      ->add_flag("--sweep", options->sweep, "Print the schema of sweep files, which sweep reads")
      ->excludes(fit);
  declared->add_flag("--markdown", options->markdown,
                     "Print the reference of all kinds of files as Markdown instead");
  declared->callback([options, &command] {
    command = [options] {
      return commands::schema_command(options->markdown, options->fit     ? read::FileKind::kFit
                                                         : options->sweep ? read::FileKind::kSweep
                                                                          : read::FileKind::kCase);
    };
  });
}

}  // namespace slipbench::driver::cli
