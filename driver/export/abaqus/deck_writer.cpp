// SPDX-License-Identifier: Apache-2.0
#include "driver/export/abaqus/deck_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "driver/export/abaqus/deck_parts.hpp"
#include "driver/export/deck_text.hpp"
#include "driver/results/provenance.hpp"
#include "law/friction/friction_law.hpp"

namespace slipbench::driver::exports {

std::string data_lines(const std::vector<std::string>& items) {
  constexpr std::size_t kItems = 8;
  std::size_t count = items.size();
  // Empty items at the end may be left out, but of the line's last full eight.
  while (count > 1 && items[count - 1].empty()) --count;
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += items[i];
    const bool line_ends = (i + 1) % kItems == 0 || i + 1 == count;
    text += i + 1 == count ? "\n" : line_ends ? ",\n" : ", ";
  }
  // A row has as many lines as its table, or the next row would be read as its end.
  const std::size_t lines = (items.size() + kItems - 1) / kItems;
  for (std::size_t line = (count + kItems - 1) / kItems; line < lines; ++line) text += ",\n";
  return text;
}

bool DeckParts::sees_slip_rate() const {
  const auto in_law = [](const cases::CaseDefinition& one) {
    return law::depends_on_slip_rate(one.law.law);
  };
  const auto in_changes = [](const cases::Step& step) {
    return std::any_of(
        step.friction_changes.begin(), step.friction_changes.end(),
        [](const cases::FrictionChange& change) { return law::depends_on_slip_rate(change.law); });
  };
  return std::any_of(problem_.definitions.begin(), problem_.definitions.end(), in_law) ||
         std::any_of(problem_.steps.begin(), problem_.steps.end(), in_changes);
}

void DeckParts::judge() {
  if (problem_.dynamics) refuse("a mass of the bench is no part of a connector");
  if (problem_.belt) {
    if (problem_.belt->nodes || problem_.belt->both_tensions || !problem_.belt->lengths.empty()) {
      refuse("only a belt over one ring with a given angle becomes a SLIPRING of a deck");
    }
    if (written_.connector.value.wrap_angle.value.values.size() != 1) {
      refuse("a belt over several rings is several connectors of a deck");
    }
  }
  for (const cases::CaseDefinition& one : problem_.definitions) {
    if (one.backward) refuse("a coefficient for each direction is not in Abaqus");
    if (one.dead_zone) refuse("backlash in series with friction is not in Abaqus");
    if (one.law.formulation && one.law.formulation->orthotropy) {
      refuse("two coefficients for two directions are not in Abaqus");
    }
  }
  for (int c = 3; c < law::kComponents; ++c) {
    if (problem_.initial[c] != 0.0) {
      refuse("an initial rotation would have to be told by turned axes of node b");
    }
  }
  if (written_.connector.value.friction_radius.given()) {
    refuse("Abaqus has no radius at which a coefficient sees the spinning");
  }
  using Kind = Loss::Kind;
  if (problem_.integration.snap_back == cases::SnapBackAction::kJump) {
    note(Kind::kApproximated, "integration: snap_back: jump; the solver does what it does there");
  }
  if (problem_.integration.method == cases::IntegrationMethod::kExact) {
    note(Kind::kApproximated, "integration: exact; the solver takes implicit increments");
  }
  for (const cases::CaseDefinition& one : problem_.definitions) {
    if (one.law.slip_rate == law::SlipRateMeasure::kRelativeMotion && sees_slip_rate()) {
      note(Kind::kApproximated,
           "integration: slip_rate: relative_motion; the solver takes that of the slip");
      break;
    }
  }
  for (const cases::CaseDefinition& one : problem_.definitions) {
    if (one.law.accumulated_slip == law::AccumulatedSlipTiming::kStart) {
      note(Kind::kApproximated,
           "integration: accumulated_slip: start; a deck does not say which one counts");
      break;
    }
  }
  judge_contact();
  if (!problem_.checks.empty()) note(Kind::kDropped, "checks: a deck has none");
  if (!problem_.units.length.empty()) note(Kind::kDropped, "units: they stand in the heading only");
}

void DeckParts::judge_contact() {
  using Kind = Loss::Kind;
  if (is_contact()) {
    note(Kind::kKept, "CONTACT, as SLIDE-PLANE with friction of what presses alone");
  }
  if (written_.friction_pairs.given()) {
    note(Kind::kDropped, "records of part pairs, but that of the two parts of the case");
  }
  bool viscous = false;
  bool spring = false;
  bool filtered = false;
  bool as_coded = false;
  for (const cases::CaseDefinition& one : problem_.definitions) {
    if (!one.law.formulation) continue;
    const law::Formulation& formulation = *one.law.formulation;
    const bool own = std::holds_alternative<law::ViscousPenalty>(formulation.penalty);
    viscous = viscous || own;
    spring = spring || !own;
    filtered = filtered || formulation.filter.kind != law::Filter::Kind::kNone;
    as_coded = as_coded || formulation.convention == law::Convention::kAsCoded;
  }
  if (spring) note(Kind::kKept, "K_t, as stick stiffness");
  if (viscous) note(Kind::kDropped, "viscous penalty: Abaqus sticks");
  if (filtered) note(Kind::kDropped, "filter: Abaqus has none");
  if (as_coded) note(Kind::kDropped, "convention: as_coded; what OpenRadioss makes of its page");
}

std::string DeckParts::model() {
  const auto type_of = [&]() -> std::string {
    const auto& names = written_.connector.value.type.value.names;
    std::string text(is_contact() ? "SLIDE-PLANE" : names[0].value);
    if (names.size() > 1) text += ", " + std::string(names[1].value);
    return text;
  };
  std::string text = "*HEADING\n" + title_line(problem_.title);
  const base::UnitSystem& units = problem_.units;
  if (!units.length.empty()) {
    text += fmt::format(" ({}, {}, {})", units.length, units.force, units.time);
  }
  text += fmt::format("\n** written by slipbench {}\n*NODE\n1, 0., 0., 0.\n2",
                      results::program_version());
  for (int c = 0; c < 3; ++c) {
    text += ", " + whole_(problem_.belt && c > 0 ? 0.0 : problem_.initial[c]);
  }
  // SLIDE-PLANE is one of space; the second tangent is held.
  const bool plane = written_.connector.value.dimension.value == 2 && !is_contact();
  text += fmt::format("\n*ELEMENT, TYPE={}, ELSET=JOINT\n1, 1, 2\n", plane ? "CONN2D2" : "CONN3D2");
  text += "*CONNECTOR SECTION, ELSET=JOINT, BEHAVIOR=JOINT\n" + type_of() + "\n";
  if (problem_.belt) {
    text += ",\n" + numbers_(written_.connector.value.wrap_angle.value.values[0]) + "\n";
  }
  return text;
}

tl::expected<ExportedDeck, std::string> to_abaqus(const cases::Case& problem,
                                                  const read::CaseText& written,
                                                  const ExportOptions& options) {
  DeckParts parts(problem, written, options);
  try {
    parts.judge();
    const std::string behavior = parts.behavior();
    ExportedDeck deck;
    if (options.behavior_only) {
      deck.text = behavior;
    } else {
      deck.text = parts.model() + behavior + parts.history();
    }
    deck.losses = std::move(parts.losses());
    tell_rounding(parts.rounded(), parts.worst(), deck.losses);
    return deck;
  } catch (const NotExported& refused) {
    return tl::unexpected(refused.reason);
  }
}

}  // namespace slipbench::driver::exports
