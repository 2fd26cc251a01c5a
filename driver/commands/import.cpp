// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

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
  const std::string inputs[] = {options.deck};
  std::vector<base::OutputFile> files;
  std::string output;
  std::string losses;
  base::json::Value document = base::json::Array{};
  for (const ImportedCase& one : deck.cases) {
    const fs::path path =
        options.all ? fs::path(options.output.empty() ? "." : options.output) / (one.stem + ".yaml")
                    : fs::path(options.output);
    auto file = base::OutputFile::create(path, {}, {inputs, options.force});
    if (!file) return terminal::refuse(base::kExitEnvironment, file.error());
    file->append(one.written.text);
    files.push_back(std::move(*file));
    output += written_text(path, one);
    losses += loss_report(one.written.losses);
    base::json::Value entry;
    entry["case"] = path.string();
    entry["of"] = one.summary;
    entry["asked"] = base::json::Array{};
    for (const std::string& name : one.written.asked) entry["asked"].push_back(name);
    entry["losses"] = loss_json(one.written.losses);
    document.push_back(std::move(entry));
  }
  std::vector<base::OutputFile*> together;
  together.reserve(files.size());
  for (base::OutputFile& file : files) together.push_back(&file);
  if (const auto committed = base::commit(together); !committed) {
    return terminal::refuse(base::kExitEnvironment, committed.error());
  }
  terminal::print(options.json ? document.dump(2) + "\n" : output);
  if (!options.json) terminal::print_error(losses);
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
