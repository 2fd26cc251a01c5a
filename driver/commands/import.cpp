// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import.hpp"

#include <filesystem>
#include <span>
#include <string>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/commands/loss_report.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// Returns "model_7.yaml: HINGE "Pin": give f2, f3", what is printed of a case.
std::string written_text(const fs::path& path, const ImportedCase& one) {
  std::string text = path.string() + ": " + one.summary;
  for (const std::string& name : one.written.asked) {
    text += (&name == one.written.asked.data() ? ": give " : ", ") + name;
  }
  return base::printable(text) + "\n";
}

}  // namespace

int import_command(const ImportOptions& options) {
  const bool to_terminal = !options.all && (options.output.empty() || options.output == "-");
  if (options.json && to_terminal) {
    return terminal::refuse(base::kExitBadInput,
                            "--json takes the terminal: say where the case goes with -o");
  }
  const ImportedDeck deck = read_deck(options);
  terminal::print_error(deck.messages);
  if (deck.code != base::kExitOk) return deck.code;
  if (to_terminal) {
    terminal::print_error(loss_report(deck.cases.front().written.losses));
    terminal::print(deck.cases.front().written.text);
    return base::kExitOk;
  }
  base::json::Value document = base::json::Array{};
  for (const ImportedCase& one : deck.cases) {
    const fs::path path =
        options.all ? fs::path(options.output.empty() ? "." : options.output) / (one.stem + ".yaml")
                    : fs::path(options.output);
    const std::string inputs[] = {options.deck};
    if (const auto saved = base::save_text(path, one.written.text, {inputs, options.force});
        !saved) {
      return terminal::refuse(base::kExitEnvironment, saved.error());
    }
    if (options.json) {
      base::json::Value entry;
      entry["case"] = path.string();
      entry["of"] = one.summary;
      entry["asked"] = base::json::Array{};
      for (const std::string& name : one.written.asked) entry["asked"].push_back(name);
      entry["losses"] = loss_json(one.written.losses);
      document.push_back(std::move(entry));
    } else {
      terminal::print(written_text(path, one));
      terminal::print_error(loss_report(one.written.losses));
    }
  }
  if (options.json) terminal::print(document.dump(2) + "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
