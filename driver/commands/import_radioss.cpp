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
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/number.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/base/units/units.hpp"
#include "driver/commands/contact_choice.hpp"
#include "driver/commands/import_units.hpp"
#include "driver/import/deck_kind.hpp"
#include "driver/import/radioss/case_writer.hpp"
#include "driver/import/radioss/deck_friction.hpp"
#include "driver/import/radioss/deck_interface.hpp"
#include "driver/import/radioss/deck_line.hpp"
#include "driver/import/radioss/starter_deck.hpp"

namespace slipbench::driver::commands {
namespace {

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
                                         const import::DeckTexts& texts, base::Diagnostics& out) {
  if (friction.unit_id == 0) {
    for (const radioss::DeckFault& fault : contents.unit_faults) {
      out.warning(texts.name(fault.text), texts.position(fault.text), "/BEGIN", fault.message,
                  "state the units with --units");
    }
    return contents.units;
  }
  const auto local = contents.local_units.find(friction.unit_id);
  if (local != contents.local_units.end()) return local->second;
  out.warning(texts.name(friction.where), texts.position(friction.where),
              radioss::shortened(friction.where, 40),
              fmt::format("is in the local system of units {}, which the deck does not state",
                          friction.unit_id),
              "state it with --units");
  return std::nullopt;
}

void judge_directions(const radioss::DeckContents& contents, const radioss::DeckFriction& friction,
                      const std::optional<std::array<double, 3>>& normal,
                      const import::DeckTexts& texts, base::Diagnostics& out) {
  if (!normal || !radioss::is_orthotropic(friction)) return;
  for (const radioss::DeckOrientation& entry : radioss::used_orientations(contents, friction)) {
    if (entry.skew > 0 || radioss::direction_in_plane(entry, *normal)) continue;
    out.error(texts.name(entry.where), texts.position(entry.where), "/FRIC_ORIENT",
              "FRIC009: the direction is normal to the contact plane: it has no projection on it");
  }
}

/// Friction that becomes a case.
struct Meant {
  radioss::DeckFriction friction;
  radioss::SkeletonOptions options;
};

/// The friction of an interface: its own, or the /FRICTION that it names. Reports one that is not
/// there.
std::optional<Meant> meant_by(const radioss::DeckInterface& interface,
                              const radioss::DeckContents& contents, const import::DeckTexts& texts,
                              const radioss::SkeletonOptions& common, base::Diagnostics& out) {
  Meant meant{interface.own, common};
  const std::string name = fmt::format("/INTER/TYPE{}/{}", interface.type, interface.id);
  std::vector<std::string>& notes = meant.options.notes;
  if (interface.friction_id > 0) {
    const auto found = std::find_if(
        contents.frictions.begin(), contents.frictions.end(),
        [&](const radioss::DeckFriction& one) { return one.id == interface.friction_id; });
    if (found == contents.frictions.end()) {
      out.error(
          texts.name(interface.where), texts.position(interface.where), name,
          fmt::format("names /FRICTION/{}, which the deck does not have", interface.friction_id));
      return std::nullopt;
    }
    meant.friction = *found;
    notes.push_back("as " + name + " names it; the interface's own Fric is not used");
    if (interface.type == 21 || interface.type == 24 || interface.type == 25) {
      meant.friction.formulation = 2;
      notes.push_back(
          fmt::format("TYPE{} always uses the stiffness penalty (Iform 2)", interface.type));
    }
  } else {
    meant.options.shear_limit = interface.shear_limit;
    double& visf = meant.friction.otherwise.visf;
    if (meant.friction.formulation == 1 && visf != 0.0 && visf != 1.0) {
      const std::string own = base::format_number(visf);
      visf *= visf;
      meant.options.as_coded = true;
      notes.push_back(
          fmt::format("VISF {} of the interface is {} here: the program squares it, not that of a "
                      "/FRICTION, and takes the root (convention: as_coded): C = {} sqrt(2 K m)",
                      own, base::format_number(visf), own));
    }
  }
  if (interface.temperature_function > 0) {
    const std::string message = fmt::format(
        "its friction is scaled by function {} of the temperature (fct_IDF): not taken over",
        interface.temperature_function);
    meant.options.losses.push_back({import::Loss::Kind::kDropped, message});
    out.warning(texts.name(interface.where), texts.position(interface.where), name, message);
  }
  return meant;
}

/// Tells what a deck has.
std::string inventory(const radioss::DeckContents& contents,
                      const std::vector<radioss::DeckInterface>& interfaces) {
  const auto with = std::count_if(interfaces.begin(), interfaces.end(), radioss::has_friction);
  std::string text = fmt::format("{} interface{} with friction, {} /FRICTION\n", with,
                                 with == 1 ? "" : "s", contents.frictions.size());
  constexpr std::size_t kMostNamed = 20;
  for (std::size_t i = 0; i < std::min(kMostNamed, interfaces.size()); ++i) {
    const radioss::DeckInterface& one = interfaces[i];
    text += fmt::format("  TYPE{} {}", one.type, one.id);
    if (!one.own.title.empty()) text += " \"" + one.own.title + "\"";
    if (one.friction_id > 0) {
      text += fmt::format(": /FRICTION/{}\n", one.friction_id);
    } else if (one.unread) {
      text += ": passed over: " + *one.unread + "\n";
    } else if (!radioss::has_friction(one)) {
      text += ": no friction, passed over\n";
    } else {
      constexpr std::array kLaws{"Coulomb", "generalised viscous", "modified Darmstad", "Renard",
                                 "exponential decay"};
      text +=
          fmt::format(": {}, Fric {:g}, Iform {}\n", kLaws[static_cast<std::size_t>(one.own.law)],
                      one.own.otherwise.fric, one.own.formulation);
    }
  }
  if (interfaces.size() > kMostNamed) {
    text += fmt::format("  and {} more\n", interfaces.size() - kMostNamed);
  }
  return text;
}

/// Judges a friction and finds its units; what is wrong is reported.
void judge(Meant& meant, const radioss::DeckContents& contents, const import::DeckTexts& texts,
           base::Diagnostics& out) {
  const radioss::DeckFriction& friction = meant.friction;
  radioss::judge(contents, friction, texts, out);
  judge_directions(contents, friction, meant.options.normal, texts, out);
  if (!meant.options.units) meant.options.units = units_of(contents, friction, texts, out);
  if (meant.options.units || friction.law != 3) return;
  out.warning(texts.name(friction.where), texts.position(friction.where),
              radioss::shortened(friction.where, 40),
              "Ifric 3 hides a unit of speed: the case does not run before it states its units",
              "state them with --units, or in the case");
}

/// Finds what is to become cases: by --id a /FRICTION, else the interfaces with friction, else the
/// only /FRICTION. What is open, or wrong, is reported.
std::vector<Meant> find_meant(const radioss::DeckContents& contents,
                              const std::vector<radioss::DeckInterface>& interfaces,
                              const import::DeckTexts& texts, const ImportOptions& options,
                              const radioss::SkeletonOptions& common, base::Diagnostics& out) {
  std::vector<Meant> all;
  std::string ids;
  std::size_t records = 0;
  for (const radioss::DeckInterface& one : interfaces) {
    if (options.id || !radioss::has_friction(one)) continue;
    if (options.interface && one.id != *options.interface) continue;
    ids += (ids.empty() ? "" : ", ") + std::to_string(one.id);
    if (records > import::kMostRecords) continue;
    const auto named =
        std::ranges::find(contents.frictions, one.friction_id, &radioss::DeckFriction::id);
    if (one.friction_id > 0 && named != contents.frictions.end()) records += named->pairs.size();
    if (records > import::kMostRecords) {
      out.error(options.deck, {}, {},
                fmt::format("its interfaces have more than {} records of part pairs together",
                            import::kMostRecords),
                "take them one by one, with --interface");
      continue;
    }
    if (auto meant = meant_by(one, contents, texts, common, out)) all.push_back(std::move(*meant));
  }
  if (options.interface && ids.empty()) {
    out.error(options.deck, {}, {},
              fmt::format("has no interface {} with friction", *options.interface));
  }
  if (!ids.empty() || options.interface) {
    if (all.size() > 1 && !options.all) {
      out.error(options.deck, {}, {}, "has several interfaces with friction: " + ids,
                "choose one with --interface, or all of them with --all -o DIR");
    }
    return all;
  }
  if (options.all && !options.id) {
    for (const radioss::DeckFriction& one : contents.frictions) all.push_back({one, common});
    if (!all.empty()) return all;
  }
  if (const radioss::DeckFriction* const friction = choose(contents, options, out)) {
    all.push_back({*friction, common});
  }
  return all;
}

/// Sentence on a file that no reader knows as a deck of its program.
base::Diagnostic not_a_deck(const base::SourceText& source) {
  const bool empty = source.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
  return {.file = std::string(source.name()),
          .where = {1, 1, 1},
          .message = empty ? "the file is empty" : "this is no deck of a program that is known",
          .hint =
              "keywords of Abaqus and LS-DYNA begin with '*', blocks of Radioss with '/', and an "
              "OpenSees script has a line with frictionModel"};
}

}  // namespace

ImportedDeck import_radioss(const ImportOptions& options) {
  ImportedDeck imported;
  radioss::SkeletonOptions common;
  common.deck = std::filesystem::path(options.deck).filename().string();
  if (!options.normal.empty()) {
    const auto normal = parse_normal(options.normal);
    if (!normal) return refused(std::move(imported), normal.error());
    common.normal = *normal;
  }
  if (!options.units.empty()) {
    auto units = parse_units(options.units);
    if (!units) return refused(std::move(imported), units.error());
    common.units = std::move(*units);
  }
  const auto source = source_of(options, imported);
  if (!source) return imported;
  base::Diagnostics diagnostics;
  const radioss::StarterDeck deck = radioss::split_deck(
      *source, {std::filesystem::path(options.deck).parent_path().string(), options.allow_outside},
      diagnostics);
  if (!diagnostics.has_errors() &&
      import::kind_of_text(source->text()) == import::DeckKind::kUnknown) {
    imported.messages += base::render(not_a_deck(*source));
    imported.code = base::kExitBadInput;
    return imported;
  }
  const std::vector<radioss::DeckInterface> interfaces =
      radioss::read_interfaces(deck, diagnostics);
  std::optional<int> chosen = options.id;
  for (const radioss::DeckInterface& one : interfaces) {
    if (options.interface == one.id && one.friction_id > 0) chosen = one.friction_id;
  }
  const radioss::DeckContents contents = radioss::read_contents(deck, chosen, diagnostics);
  std::vector<Meant> all =
      find_meant(contents, interfaces, deck.texts, options, common, diagnostics);
  for (Meant& meant : all) judge(meant, contents, deck.texts, diagnostics);
  if (!interfaces.empty()) imported.messages = inventory(contents, interfaces);
  imported.messages += base::render(diagnostics, deck.texts.all());
  if (diagnostics.has_errors() || all.empty()) {
    imported.messages += base::summary(diagnostics) + ", nothing was written\n";
    imported.code = base::kExitBadInput;
    return imported;
  }
  std::size_t parts = 0;
  for (const Meant& meant : all) {
    const import::ContactFriction friction =
        radioss::contact_friction(contents, meant.friction, meant.options);
    if (lists_too_many_parts(friction, parts) && all.size() > 1) {
      return refused_for_parts(std::move(imported), options.deck, "--interface or --id");
    }
    std::string name = radioss::name_of(meant.friction);
    const std::size_t records = meant.friction.pairs.size();
    std::string summary = name;
    if (records > 0) {
      summary += fmt::format(", {} record{} and the default", records, records == 1 ? "" : "s");
    }
    std::replace(name.begin(), name.end(), '/', '_');
    imported.cases.push_back({std::filesystem::path(options.deck).stem().string() + name,
                              std::move(summary), import::contact_case(friction)});
  }
  return imported;
}

}  // namespace slipbench::driver::commands
