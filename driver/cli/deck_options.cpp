// SPDX-License-Identifier: Apache-2.0
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "driver/cli/declare.hpp"
#include "driver/commands/deck_output.hpp"
#include "driver/commands/imported_deck.hpp"

namespace slipbench::driver::cli {

void declare_deck_source(CLI::App& command, commands::ImportOptions& options) {
  command
      .add_option("DECK", options.deck,
                  "An Abaqus input deck, a Radioss starter deck, an LS-DYNA keyword deck, or an "
                  "OpenSees script")
      ->required();
  command
      .add_option("--id", options.id,
                  "The /FRICTION, *DEFINE_FRICTION or frictionModel to take, if there are several")
      ->type_name("ID")
      ->check(whole_number(1, 2147483647));
  command
      .add_option("--interface", options.interface,
                  "Radioss, LS-DYNA: the contact to take, if several have friction")
      ->type_name("ID")
      ->check(whole_number(1, 2147483647));
  command
      .add_option("--connector", options.connector,
                  "Abaqus: the connector to take, if there are several: its element or set")
      ->type_name("NAME");
  command.add_flag("--allow-outside", options.allow_outside,
                   "Let the deck include files outside its own folder");
  command
      .add_option("--units", options.units,
                  "Length, force and time the deck is in; default: those of /BEGIN (an Abaqus "
                  "deck has none)")
      ->type_name("\"mm N s\"");
  command
      .add_option(
          "--normal", options.normal,
          "Radioss: normal of the contact, to judge the directions of orthotropic friction by")
      ->type_name("\"X Y Z\"");
}

void declare_deck_target(CLI::App& command, commands::DeckOutputOptions& options,
                         std::span<const std::string_view> more) {
  std::vector<std::string> targets(commands::kExportTargets.begin(),
                                   commands::kExportTargets.end());
  targets.insert(targets.end(), more.begin(), more.end());
  command.add_option("--to", options.to, "The program whose deck it is")
      ->type_name(fmt::format("{}", fmt::join(targets, "|")))
      ->check(one_of(targets))
      ->required();
  command.add_option("-o,--output", options.output, "The deck; default: the terminal")
      ->type_name("FILE");
  command
      .add_option("--part", options.part, "Only the block to be pasted into a model that is there")
      ->type_name("behaviour")
      ->check(one_of({"behaviour"}));
  command
      .add_option("--digits", options.digits,
                  "Round numbers to so many digits, and say what was rounded")
      ->type_name("N")
      ->check(whole_number(2, 17));
  command.add_flag("--json", options.json, "Print what is kept, approximated and dropped as JSON");
  declare_force(command, options.force, "there already");
}

}  // namespace slipbench::driver::cli
