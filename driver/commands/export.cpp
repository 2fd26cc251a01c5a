// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/export.hpp"

#include <algorithm>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/commands/export_law.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/read/read_case.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {

int export_command(const ExportCommandOptions& options) {
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  if (const std::string fault = json_fault(options.deck); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  read::CaseText written;
  const read::ReadCase read = read::read_case(
      options.file,
      {.overrides = *settings, .allow_outside = options.allow_outside, .text = &written});
  if (!read.value) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
    terminal::print_error(base::summary(read.diagnostics) + ", nothing was written\n");
    return read.environment_failure ? base::kExitEnvironment : base::kExitBadInput;
  }
  const auto is_law = std::find(kLawTargets.begin(), kLawTargets.end(), options.deck.to);
  if (is_law != kLawTargets.end()) return export_law(read, options.file, *settings, options.deck);
  const auto made = deck_of_case(*read.value, written, options.deck);
  if (!made) {
    return terminal::refuse(base::kExitBadInput,
                            base::printable(options.file) + ": is not exported: " + made.error());
  }
  base::json::Value document;
  const int code =
      write_deck(*made, options.file, options.deck.force, options.deck.json ? &document : nullptr);
  if (options.deck.json && code == base::kExitOk) terminal::print(document.dump(2) + "\n");
  return code;
}

}  // namespace slipbench::driver::commands
