// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/export.hpp"

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/commands/exported_case.hpp"
#include "driver/commands/loss_report.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/read/read_case.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
int export_command(const ExportCommandOptions& options) {
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  read::CaseText written;
  const read::ReadCase read = read::read_case(
      options.file,
      {.overrides = *settings, .allow_outside = options.allow_outside, .text = &written});
  if (!read.value) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
    terminal::print_error(base::summary(read.diagnostics) + ", nothing was written\n");
    return read.environment_failure ? base::kExitEnvironment : base::kExitBadInput;
  }
  const bool to_terminal = options.output.empty() || options.output == "-";
  if (options.json && to_terminal) {
    return terminal::refuse(base::kExitBadInput,
                            "--json takes the terminal: say where the deck goes with -o");
  }
  const exports::ExportOptions how{!options.part.empty(), options.digits};
  const auto deck = exported_case(options.to, *read.value, written, how);
  if (!deck) {
    return terminal::refuse(base::kExitBadInput,
                            base::printable(options.file) + ": is not exported: " + deck.error());
  }
  const auto whole = how.behavior_only
                         ? exported_case(options.to, *read.value, written, {false, how.digits})
                         : deck;
  const MeasuredDifference difference =
      whole ? measured_difference(options.to, *read.value, written, whole->text)
            : tl::unexpected(whole.error());
  if (options.json) {
    base::json::Value document;
    document["case"] = options.file;
    document["deck"] = options.output;
    document["losses"] = loss_json(deck->losses);
    document["on_the_history"] = difference_json(difference);
    terminal::print(document.dump(2) + "\n");
  } else {
    terminal::print_error(loss_report(deck->losses) + difference_line(difference));
  }
  if (to_terminal) {
    terminal::print(deck->text);
    return base::kExitOk;
  }
  const std::string inputs[] = {options.file};
  auto file = base::OutputFile::create(options.output, {}, {inputs, options.force});
  if (!file) return terminal::refuse(base::kExitEnvironment, file.error());
  file->append(deck->text);
  base::OutputFile* const alone[] = {&*file};
  if (const auto committed = base::commit(alone); !committed) {
    return terminal::refuse(base::kExitEnvironment, committed.error());
  }
  if (!options.json) terminal::print(base::printable(options.output) + "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
