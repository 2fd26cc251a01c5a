// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/exported_case.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "driver/base/units/parameters.hpp"
#include "driver/commands/imported_deck.hpp"
#include "driver/export/abaqus/deck_writer.hpp"
#include "driver/export/contact/contact_block.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/read/read_case.hpp"
#include "law/friction/at_radius.hpp"

namespace slipbench::driver::commands {
namespace {

/// The case that a deck makes, with numbers for what it asks. Error: a sentence.
tl::expected<cases::Case, std::string> read_back(const cases::Case& problem,
                                                 const read::CaseText& text,
                                                 const std::string& deck) {
  import::WrittenCase written;
  {
    // The deck and its keywords end here: of a long table they would be most of the memory below.
    ImportOptions options;
    options.deck = "deck";
    options.text = base::SourceText("deck", deck);
    options.all = true;
    ImportedDeck imported = read_deck(options);
    if (imported.cases.size() != 1) {
      return tl::unexpected<std::string>("the deck is not read back");
    }
    written = std::move(imported.cases.front().written);
  }
  std::vector<base::ParameterText> values;
  for (const std::string& name : written.asked) {
    double value = 1.0;
    const double area = exports::contact_area(problem, text);
    if (name == "area" && area > 0.0) value = area;
    if (problem.pair && name == "part1") value = problem.pair->parts[0];
    if (problem.pair && name == "part2") value = problem.pair->parts[1];
    values.push_back({name, value});
  }
  read::ReadCase read =
      read::read_case_text(base::SourceText("case", written.text), ".", {.overrides = values});
  if (!read.value) return tl::unexpected<std::string>("the deck asks for more than the case has");
  return std::move(*read.value);
}

/// Gives a definition a coefficient; where the case's slide in some and spin in others, at its
/// friction radius.
void give(const law::FrictionLaw& law, const read::CaseText& text, const cases::Case& problem,
          law::FrictionDefinition& definition) {
  const auto& radius = text.connector.value.friction_radius;
  const bool spins = law::is_rotational(definition.slip) &&
                     !law::is_rotational(problem.definitions.front().law.slip);
  definition.law = spins && radius.given() ? law::at_radius(law, radius.value) : law;
}

/// Takes the changes of friction out of the steps: no contact of a deck has them.
void drop_changes(cases::Case& problem) {
  for (cases::Step& step : problem.steps) step.friction_changes.clear();
}

/// The case with the friction that a contact of a deck has.
cases::Case with_friction_of(const cases::Case& other, const read::CaseText& text,
                             cases::Case problem) {
  drop_changes(problem);
  const law::FrictionDefinition& stated = other.definitions.front().law;
  for (cases::CaseDefinition& one : problem.definitions) {
    give(stated.law, text, problem, one.law);
    one.law.force_limit = stated.force_limit;
    if (!one.law.formulation || !stated.formulation) continue;
    // A viscous penalty is one of Radioss alone.
    if (std::holds_alternative<law::ViscousPenalty>(one.law.formulation->penalty) &&
        !std::holds_alternative<law::ViscousPenalty>(stated.formulation->penalty)) {
      one.law.formulation.reset();
    }
  }
  return problem;
}

}  // namespace

tl::expected<exports::ExportedDeck, std::string> exported_case(
    std::string_view program, const cases::Case& problem, const read::CaseText& written,
    const exports::ExportOptions& options) {
  return program == "abaqus" ? exports::to_abaqus(problem, written, options)
                             : exports::to_contact(program, problem, written, options);
}

tl::expected<analysis::ResponseDifference, std::string> measured_difference(
    std::string_view program, const cases::Case& problem, const read::CaseText& written,
    const std::string& deck) {
  if (program == "table") {
    cases::Case other = problem;
    drop_changes(other);
    for (cases::CaseDefinition& one : other.definitions) {
      give(exports::law_of_table(deck), written, problem, one.law);
      one.law.force_limit = law::kNoForceLimit;
    }
    return analysis::compare_responses(problem, other);
  }
  const auto back = read_back(problem, written, deck);
  if (!back) return tl::unexpected(back.error());
  if (program == "abaqus") return analysis::compare_responses(problem, *back);
  return analysis::compare_responses(problem, with_friction_of(*back, written, problem));
}

}  // namespace slipbench::driver::commands
