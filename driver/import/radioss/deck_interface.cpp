// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/deck_interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "driver/import/radioss/deck_line.hpp"

namespace slipbench::driver::radioss {
namespace {

/// Differences between the interfaces, in the columns of a card of 100.
struct Layout {
  int type = 0;
  std::size_t boundary_card = 0;  ///< number of the card of IBC where nothing marks it; 0: unknown
  bool has_laws = true;           ///< Ifric and what follows it
  bool has_viscous = true;        ///< Iform and VISF; else the penalty is a stiffness
  bool has_limit = false;         ///< Ptlim
};

constexpr std::array kLayouts{
    Layout{.type = 3, .boundary_card = 3, .has_laws = false, .has_limit = true},
    Layout{.type = 5, .boundary_card = 3, .has_limit = true},
    Layout{.type = 7, .boundary_card = 5},
    Layout{.type = 11, .has_laws = false},
    Layout{.type = 19, .boundary_card = 5},
    Layout{.type = 20},
    Layout{.type = 21, .has_viscous = false},
    Layout{.type = 24, .has_viscous = false},
    Layout{.type = 25, .boundary_card = 6, .has_viscous = false},
};

/// Cards of an interface; decks from before version 51 have columns of 8 in place of 10.
class Cards {
 public:
  Cards(const StarterDeck& deck, const DeckBlock& block, int version, base::Diagnostics& out)
      : deck_(deck), block_(block), out_(out), old_(version < 51) {
    // The title is a line of its own, in old decks the end of the keyword's.
    first_ = old_ ? 0 : 1;
  }

  std::size_t count() const { return block_.lines.size() - std::min(first_, block_.lines.size()); }
  bool sound() const { return sound_; }
  /// Card `number` from 1 on; empty behind the last one.
  std::string_view card(std::size_t number) const {
    return number >= 1 && number <= count() ? block_.lines[first_ + number - 1]
                                            : std::string_view();
  }

  /// The number in columns of a card; columns as they are of 100.
  double number(std::size_t card_number, std::size_t begin, std::size_t width,
                std::string_view name, bool integer) {
    const std::string_view line = card(card_number);
    const DeckField field{scaled(begin), scaled(width), name, integer};
    const auto value = read_field(line, field, deck_.parameters);
    if (value) return *value;
    sound_ = false;
    const std::string_view piece = value.error().text.empty() ? line : value.error().text;
    out_.error(deck_.texts.name(piece), deck_.texts.position(piece), shortened(block_.keyword, 40),
               value.error().message);
    return 0.0;
  }

  /// The card of the boundary conditions, which has three digits 0 or 1 in columns 8 to 10 (6 to 8)
  /// and nothing before them; 0 if there is none.
  std::size_t boundary_card() const {
    for (std::size_t i = 2; i <= count(); ++i) {
      const std::string_view line = card(i).substr(0, scaled(10));
      if (line.size() != scaled(10) || line.find_first_not_of(' ') != scaled(7)) continue;
      const std::string_view digits = line.substr(scaled(7));
      if (digits.find_first_not_of("01") == std::string_view::npos && digits.size() == 3) return i;
    }
    return 0;
  }

 private:
  /// 7 blanks before the digits of IBC are 5 of 8 columns.
  std::size_t scaled(std::size_t columns) const {
    if (!old_) return columns;
    return columns == 7 ? 5 : columns / 10 * 8;
  }

  const StarterDeck& deck_;
  const DeckBlock& block_;
  base::Diagnostics& out_;
  bool old_ = false;
  bool sound_ = true;
  std::size_t first_ = 1;
};

/// The version of the deck, the first number below the name of the run in /BEGIN; decks without it
/// are of the latest.
int version_of(const StarterDeck& deck) {
  constexpr int kLatest = 2026;
  for (const DeckBlock& block : deck.blocks) {
    if (block.words.front() != "BEGIN" || block.lines.size() < 2) continue;
    const auto version = read_field(block.lines[1], {0, 10, "version", true}, {});
    if (version && *version > 0.0) return static_cast<int>(*version);
  }
  return kLatest;
}

DeckInterface read_interface(const StarterDeck& deck, const DeckBlock& block, const Layout& layout,
                             int version, base::Diagnostics& out, bool& sound) {
  DeckInterface one{.id = id_of(block, 2), .type = layout.type, .where = block.keyword, .own = {}};
  DeckFriction& own = one.own;
  own.id = one.id;
  own.unit_id = id_of(block, 3);
  own.where = block.keyword;
  own.interface_type = layout.type;
  own.formulation = layout.has_viscous ? 1 : 2;
  if (!block.lines.empty() && version >= 51) own.title = shortened(block.lines.front(), 100);
  own.title.erase(0, std::min(own.title.find_first_not_of(' '), own.title.size()));
  Cards cards(deck, block, version, out);
  std::size_t boundary = cards.boundary_card();
  if (boundary == 0) boundary = layout.boundary_card;
  if (boundary == 0 || boundary > cards.count()) {
    one.unread = cards.count() == 0 ? "it has no cards"
                                    : "none of its cards has the digits of IBC, by which the "
                                      "friction is found: write 000 in columns 8 to 10";
    return one;
  }
  DeckCoefficients& set = own.otherwise;
  set.where = cards.card(boundary - 1);
  set.rest = set.where;
  set.fric = cards.number(boundary - 1, 20, 20, "Fric", false);
  const bool takes_viscous = layout.has_viscous && layout.type != 3 && layout.type != 5;
  if (takes_viscous) set.visf = cards.number(boundary, 60, 20, "VISF", false);
  const std::size_t laws = boundary + 1;
  if (layout.type == 11) {
    own.formulation = static_cast<int>(cards.number(boundary - 2, 80, 10, "Iform", true));
    one.friction_id = static_cast<int>(cards.number(laws, 90, 10, "fric_ID", true));
  }
  if (layout.has_limit) one.shear_limit = cards.number(boundary, 80, 20, "Ptlim", false);
  if (layout.has_laws && laws <= cards.count()) {
    own.law = static_cast<int>(cards.number(laws, 0, 10, "Ifric", true));
    own.filter = static_cast<int>(cards.number(laws, 10, 10, "Ifiltr", true));
    own.xfreq = cards.number(laws, 20, 20, "Xfreq", false);
    if (takes_viscous) {
      own.formulation = static_cast<int>(cards.number(laws, 40, 10, "Iform", true));
    }
    const bool has_function = version >= 140 && (layout.type == 7 || layout.type == 19);
    if (has_function) {
      one.temperature_function = static_cast<int>(cards.number(laws, 60, 10, "fct_IDF", true));
    }
    if (version >= 2018 && layout.type != 5 && layout.type != 20) {
      one.friction_id = static_cast<int>(cards.number(laws, 90, 10, "fric_ID", true));
    }
    if (own.law > 0) {
      set.where = cards.card(laws + 1);
      for (std::size_t i = 0; i < 5; ++i) {
        set.c[i] = cards.number(laws + 1, 20 * i, 20, "C" + std::to_string(i + 1), false);
      }
    }
    if (own.law > 1) set.c[5] = cards.number(laws + 2, 0, 20, "C6", false);
  }
  own.formulation = std::max(1, own.formulation);
  const auto refuse = [&](const std::string& message) {
    sound = false;
    out.error(deck.texts.name(block.keyword), deck.texts.position(block.keyword),
              shortened(block.keyword, 40), message);
  };
  sound = cards.sound();
  if (!sound || one.friction_id > 0) return one;
  if (own.law < 0 || own.law > 4) refuse(fmt::format("FRIC001: unknown Ifric {}", own.law));
  if (own.filter < 0 || own.filter > 3)
    refuse(fmt::format("FRIC002: unknown Ifiltr {}", own.filter));
  if (own.formulation > 2) refuse(fmt::format("unknown Iform {}", own.formulation));
  return one;
}

}  // namespace

std::vector<DeckInterface> read_interfaces(const StarterDeck& deck, base::Diagnostics& out) {
  const int version = version_of(deck);
  std::vector<DeckInterface> interfaces;
  for (const DeckBlock& block : deck.blocks) {
    if (block.words.front() != "INTER" || block.words.size() < 3) continue;
    const DeckBlock type{
        {block.words[1].substr(std::min<std::size_t>(4, block.words[1].size()))}, {}, {}, {}};
    const auto* const layout =
        std::find_if(kLayouts.begin(), kLayouts.end(),
                     [&](const Layout& one) { return one.type == id_of(type, 0); });
    if (layout == kLayouts.end() || !block.words[1].starts_with("TYPE")) continue;
    bool sound = true;
    DeckInterface one = read_interface(deck, block, *layout, version, out, sound);
    if (sound) interfaces.push_back(std::move(one));
  }
  return interfaces;
}

bool has_friction(const DeckInterface& interface) {
  return interface.friction_id > 0 || !is_empty(interface.own.law, interface.own.otherwise);
}

}  // namespace slipbench::driver::radioss
