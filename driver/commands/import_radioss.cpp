// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import_radioss.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/units/units.hpp"
#include "driver/commands/import_units.hpp"
#include "driver/import/radioss/case_writer.hpp"
#include "driver/import/radioss/deck_friction.hpp"
#include "driver/import/radioss/deck_line.hpp"
#include "driver/import/radioss/starter_deck.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

// Decks carry the whole mesh.
constexpr std::size_t kDeckSizeLimit = std::size_t{1} << 30U;

int refuse(const std::string& message) {
  terminal::print_error("slipbench: error: " + message + "\n");
  return base::kExitBadInput;
}

tl::expected<std::array<double, 3>, std::string> parse_normal(const std::string& text) {
  const std::vector<std::string> words = words_of(text);
  std::array<double, 3> normal{};
  bool zero = true;
  for (std::size_t i = 0; i < 3 && words.size() == 3; ++i) {
    const auto number = base::parse_number(words[i]);
    if (!number) return tl::make_unexpected("--normal: " + number.error());
    normal[i] = *number;
    zero = zero && *number == 0.0;
  }
  if (words.size() != 3 || zero) {
    return tl::make_unexpected("--normal wants the normal of the contact, like \"0 0 1\"");
  }
  return normal;
}

/// Chooses the friction that is meant; null if that is open, which is reported.
const radioss::DeckFriction* choose(const radioss::DeckContents& contents,
                                    const ImportOptions& options, base::Diagnostics& out) {
  constexpr std::size_t kMostNamed = 20;
  std::string ids;
  std::size_t count = 0;
  for (const radioss::DeckFriction& friction : contents.frictions) {
    if (options.id && friction.id == *options.id) return &friction;
    if (++count > kMostNamed) continue;
    ids += (ids.empty() ? "" : ", ") + std::to_string(friction.id);
  }
  if (count > kMostNamed) ids += fmt::format(" and {} more", count - kMostNamed);
  if (!options.id && contents.frictions.size() == 1) return &contents.frictions.front();
  if (out.has_errors()) return nullptr;
  if (contents.frictions.empty()) {
    out.error(options.deck, {}, {}, "has no /FRICTION",
              contents.has_includes ? "it may stand in a file that the deck includes" : "");
  } else if (options.id) {
    out.error(options.deck, {}, {}, fmt::format("has no /FRICTION/{}", *options.id),
              "there are " + ids);
  } else {
    out.error(options.deck, {}, {}, "has several /FRICTION: " + ids, "choose one with --id");
  }
  return nullptr;
}

/// The units the friction's numbers are in, as far as they are known.
std::optional<base::UnitSystem> units_of(const radioss::DeckContents& contents,
                                         const radioss::DeckFriction& friction,
                                         const base::SourceText& source, base::Diagnostics& out) {
  if (friction.unit_id == 0) {
    for (const radioss::DeckFault& fault : contents.unit_faults) {
      out.warning(source.name(), radioss::position_of(source, fault.text), "/BEGIN", fault.message,
                  "state the units with --units");
    }
    return contents.units;
  }
  out.warning(source.name(), radioss::position_of(source, friction.where),
              radioss::shortened(friction.where, 40),
              fmt::format("is in the local system of units {}", friction.unit_id),
              "state it with --units");
  return std::nullopt;
}

void judge_directions(const radioss::DeckContents& contents, const radioss::DeckFriction& friction,
                      const std::optional<std::array<double, 3>>& normal,
                      const base::SourceText& source, base::Diagnostics& out) {
  if (!normal || !radioss::is_orthotropic(friction)) return;
  for (const radioss::DeckOrientation& entry : radioss::used_orientations(contents, friction)) {
    if (entry.skew > 0 || radioss::direction_in_plane(entry, *normal)) continue;
    out.error(source.name(), radioss::position_of(source, source.line(entry.line)), "/FRIC_ORIENT",
              "FRIC009: the direction is normal to the contact plane: it has no projection on it");
  }
}

}  // namespace

int import_radioss(const ImportOptions& options) {
  radioss::SkeletonOptions skeleton_options;
  skeleton_options.deck = std::filesystem::path(options.deck).filename().string();
  if (!options.normal.empty()) {
    const auto normal = parse_normal(options.normal);
    if (!normal) return refuse(normal.error());
    skeleton_options.normal = *normal;
  }
  if (!options.units.empty()) {
    auto units = parse_units(options.units);
    if (!units) return refuse(units.error());
    skeleton_options.units = std::move(*units);
  }
  const auto source = base::read_source(options.deck, kDeckSizeLimit);
  if (!source) {
    terminal::print_error(base::render(source.error().diagnostic));
    return source.error().failure == base::ReadFailure::kEnvironment ? base::kExitEnvironment
                                                                     : base::kExitBadInput;
  }
  base::Diagnostics diagnostics;
  const radioss::StarterDeck deck = radioss::split_deck(*source, diagnostics);
  const radioss::DeckContents contents = radioss::read_contents(deck, options.id, diagnostics);
  const radioss::DeckFriction* friction = choose(contents, options, diagnostics);
  if (friction != nullptr) {
    radioss::judge(contents, *friction, *source, diagnostics);
    judge_directions(contents, *friction, skeleton_options.normal, *source, diagnostics);
    if (!skeleton_options.units) {
      skeleton_options.units = units_of(contents, *friction, *source, diagnostics);
    }
    if (!skeleton_options.units && friction->law == 3) {
      diagnostics.warning(
          source->name(), radioss::position_of(*source, friction->where),
          radioss::shortened(friction->where, 40),
          "Ifric 3 hides a unit of speed: the case does not run before it states its units",
          "state them with --units, or in the case");
    }
  }
  const base::SourceText sources[] = {*source};
  terminal::print_error(base::render(diagnostics, sources));
  if (diagnostics.has_errors() || friction == nullptr) {
    terminal::print_error(base::summary(diagnostics) + ", nothing was written\n");
    return base::kExitBadInput;
  }
  const std::string text = radioss::skeleton(contents, *friction, skeleton_options);
  if (options.output.empty() || options.output == "-") {
    terminal::print(text);
    return base::kExitOk;
  }
  const std::string inputs[] = {options.deck};
  auto file = base::OutputFile::create(options.output, {}, {inputs, options.force});
  if (!file) {
    terminal::print_error("slipbench: error: " + file.error() + "\n");
    return base::kExitEnvironment;
  }
  file->append(text);
  base::OutputFile* const alone[] = {&*file};
  if (const auto committed = base::commit(alone); !committed) {
    terminal::print_error("slipbench: error: " + committed.error() + "\n");
    return base::kExitEnvironment;
  }
  const std::size_t records = friction->pairs.size();
  terminal::print(fmt::format("{}: /FRICTION/{}, {} record{} and the default\n", options.output,
                              friction->id, records, records == 1 ? "" : "s"));
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
