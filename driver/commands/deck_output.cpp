// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/deck_output.hpp"

#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {

tl::expected<DeckOutput, std::string> deck_of_case(const cases::Case& problem,
                                                   const read::CaseText& written,
                                                   const DeckOutputOptions& options) {
  const exports::ExportOptions how{!options.part.empty(), options.digits};
  auto deck = exported_case(options.to, problem, written, how);
  if (!deck) return tl::unexpected(std::move(deck.error()));
  const auto difference_of = [&](const tl::expected<exports::ExportedDeck, std::string>& whole) {
    return whole ? measured_difference(options.to, problem, written, whole->text)
                 : tl::unexpected(whole.error());
  };
  MeasuredDifference difference =
      how.behavior_only
          ? difference_of(exported_case(options.to, problem, written, {false, how.digits}))
          : difference_of(deck);
  return DeckOutput{options.output, std::move(*deck), std::move(difference)};
}

int write_deck(const DeckOutput& made, const std::string& source, bool force,
               base::json::Value* document) {
  const bool to_terminal = made.output.empty() || made.output == "-";
  if (!to_terminal) {
    const std::string inputs[] = {source};
    const auto saved = base::save_text(made.output, made.deck.text, {inputs, force});
    if (!saved) return terminal::refuse(base::kExitEnvironment, saved.error());
  }
  if (document != nullptr) {
    (*document)["source"] = source;
    (*document)["deck"] = made.output;
    (*document)["losses"] = loss_json(made.deck.losses);
    (*document)["on_the_history"] = difference_json(made.difference);
    return base::kExitOk;
  }
  terminal::print_error(loss_report(made.deck.losses) + difference_line(made.difference));
  terminal::print(to_terminal ? made.deck.text : base::printable(made.output) + "\n");
  return base::kExitOk;
}

std::string json_fault(const DeckOutputOptions& options) {
  const bool to_terminal = options.output.empty() || options.output == "-";
  if (!options.json || !to_terminal) return {};
  return "--json takes the terminal: say where the deck goes with -o";
}

}  // namespace slipbench::driver::commands
