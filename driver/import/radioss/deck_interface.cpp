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

/// Cards of an interface up to that of the boundary conditions (IBC), from a version of the input
/// on. The card before it has Fric, the one behind it the law.
struct Layout {
  int type = 0;
  int since = 0;
  std::size_t boundary_card = 0;  ///< number of the card of IBC
  bool has_curvature = false;     ///< a card of two nodes more where Icurv is 1 or 2
};

constexpr std::array kLayouts{
    Layout{3, 41, 3},   Layout{5, 41, 3},   Layout{7, 41, 3},        Layout{7, 51, 5, true},
    Layout{11, 41, 3},  Layout{11, 110, 4}, Layout{19, 90, 5, true}, Layout{20, 100, 6},
    Layout{21, 100, 5}, Layout{24, 120, 5}, Layout{25, 2018, 5},
};

/// Friction cards of a type, and since which version.
struct Friction {
  int type = 0;
  int laws = 0;            ///< Ifric and what follows it; kNever: Coulomb's alone
  int function = 0;        ///< fct_IDF
  int pointer = 0;         ///< fric_ID
  bool is_viscous = true;  ///< Iform and VISF; else the penalty is a stiffness
};

constexpr int kNever = 1 << 30;
constexpr std::array kFrictions{
    Friction{3, kNever, kNever, kNever},
    Friction{5, 44, kNever, kNever},
    Friction{7, 44, 140, 2018},
    Friction{11, kNever, kNever, 2018},
    Friction{19, 90, kNever, 2018},
    Friction{20, 100, kNever, kNever},
    Friction{21, 100, 140, 2025, false},
    Friction{24, 120, kNever, 2018, false},
    Friction{25, 2018, kNever, 2018, false},
};

/// The layout of a type in a version; of one older than the type its first.
const Layout* layout_of(int type, int version) {
  const Layout* found = nullptr;
  for (const Layout& one : kLayouts) {
    if (one.type == type && (found == nullptr || one.since <= version)) found = &one;
  }
  return found;
}

/// Cards of an interface; decks from before version 51 have columns of 8 in place of 10.
class Cards {
 public:
  Cards(const StarterDeck& deck, const DeckBlock& block, int version, bool titled,
        base::Diagnostics& out)
      : deck_(deck), block_(block), out_(out), old_(version < 51), first_(titled ? 1 : 0) {}

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

  /// Refuses a block that ends before a card that it announces.
  void want(std::size_t card_number, std::string_view what) {
    if (card_number <= count()) return;
    sound_ = false;
    out_.error(deck_.texts.name(block_.keyword), deck_.texts.position(block_.keyword),
               shortened(block_.keyword, 40),
               fmt::format("FRIC006: the card of {} is missing: the block ends before it", what));
  }

  /// Tells whether a card can be that of the boundary conditions: its first field has three digits
  /// 0 or 1 at its end, or fewer, and nothing before them.
  bool is_boundary(std::size_t number) const {
    if (number < 2 || number > count()) return false;
    const std::string_view field = card(number).substr(0, scaled(10));
    const std::size_t first = field.find_first_not_of(' ');
    if (first == std::string_view::npos) return true;
    return first >= scaled(7) && field.find_first_not_of("01 ", first) == std::string_view::npos;
  }

  /// The only card that has all three digits of IBC, as of an interface with cards too few or too
  /// many; 0 if there is none, or are several.
  std::size_t marked_boundary() const {
    std::size_t found = 0;
    for (std::size_t number = 2; number <= count(); ++number) {
      if (!is_boundary(number) || card(number).find_first_not_of(' ') != scaled(7)) continue;
      if (found != 0) return 0;
      found = number;
    }
    return found;
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
  bool old_;
  bool sound_ = true;
  std::size_t first_;
};

/// The version of a block's cards, the first number below the name of the run in /BEGIN: in the one
/// of its submodel, or that of its keyword, else the deck's. Decks without it are of the latest.
int version_of(const StarterDeck& deck, const Submodel& submodel) {
  constexpr int kLatest = 2026;
  for (const DeckBlock& block : deck.blocks) {
    if (block.words.front() != "BEGIN" || block.lines.size() < 2) continue;
    const bool own = submodel.unit_id < 0 && block.submodel.unit_id == submodel.unit_id;
    if (!own && (block.submodel.unit_id < 0 || submodel.unit_id < 0)) continue;
    if (!own && submodel.version > 0) break;
    const auto version = read_field(block.lines[1], {0, 10, "version", true}, {});
    if (version && *version > 0.0) return static_cast<int>(*version);
  }
  return submodel.version > 0 ? submodel.version : kLatest;
}

/// Puts what the deck says of a law into its friction, behind the card of IBC.
void read_law(Cards& cards, std::size_t laws, const Friction& friction, int version,
              DeckInterface& one) {
  DeckFriction& own = one.own;
  const bool shell_edges = one.type == 11;
  if (version >= friction.pointer) {
    one.friction_id = static_cast<int>(cards.number(laws, 90, 10, "fric_ID", true));
  }
  if (one.type == 3 && version >= 2018) {
    one.shear_limit = cards.number(laws, 60, 20, "Ptlim", false);
  }
  if (shell_edges && version >= 120) {
    own.formulation = static_cast<int>(cards.number(laws - 3, 80, 10, "Iform", true));
  }
  std::size_t constants = laws + 1;
  // Versions 42 and 43 of TYPE5 have Ifric on the first card and C1 .. C5 where later Ifric stands.
  if (one.type == 5 && version >= 42 && version < 44) {
    own.law = static_cast<int>(cards.number(1, 40, 10, "Ifric", true));
    constants = laws;
  } else if (version < friction.laws || laws > cards.count()) {
    return;
  } else {
    own.law = static_cast<int>(cards.number(laws, 0, 10, "Ifric", true));
    own.filter = static_cast<int>(cards.number(laws, 10, 10, "Ifiltr", true));
    own.xfreq = cards.number(laws, 20, 20, "Xfreq", false);
    if (friction.is_viscous && one.type != 5) {
      own.formulation = static_cast<int>(cards.number(laws, 40, 10, "Iform", true));
    }
    if (one.type == 5 && version >= 2018) {
      one.shear_limit = cards.number(laws, 60, 20, "Ptlim", false);
    }
    if (version >= friction.function) {
      one.temperature_function = static_cast<int>(cards.number(laws, 60, 10, "fct_IDF", true));
    }
  }
  DeckCoefficients& set = own.otherwise;
  // Before version 51 there are layouts without them.
  const bool has_constants = version >= 51 && own.law <= 4;
  if (own.law > 0) {
    if (has_constants) cards.want(constants, "C1 to C5");
    set.where = cards.card(constants);
    for (std::size_t i = 0; i < 5; ++i) {
      set.c[i] = cards.number(constants, 20 * i, 20, "C" + std::to_string(i + 1), false);
    }
  }
  if (own.law > 1 && has_constants) cards.want(constants + 1, "C6");
  if (own.law > 1) set.c[5] = cards.number(constants + 1, 0, 20, "C6", false);
}

/// The title of "/INTER/TYPE7/2/lid on drum".
std::string title_behind(std::string_view keyword) {
  for (int slash = 0; slash < 4; ++slash) {
    const std::size_t at = keyword.find('/');
    if (at == std::string_view::npos) return {};
    keyword.remove_prefix(at + 1);
  }
  return shortened(keyword, 100);
}

DeckInterface read_interface(const StarterDeck& deck, const DeckBlock& block,
                             const Friction& friction, int version, base::Diagnostics& out,
                             bool& sound) {
  const int type = friction.type;
  // The title is a line of its own, in old decks of some types the end of the keyword's.
  const bool titled = version >= 51 || type == 3 || type == 5;
  DeckInterface one{.id = with_offset(id_of(block, 2), block.submodel.offset),
                    .type = type,
                    .where = block.keyword,
                    .own = {}};
  DeckFriction& own = one.own;
  own.id = one.id;
  own.unit_id = titled ? id_of(block, 3) : 0;
  if (own.unit_id == 0) own.unit_id = block.submodel.unit_id;
  own.where = block.keyword;
  own.interface_type = type;
  own.formulation = friction.is_viscous ? 1 : 2;
  if (!titled) own.title = title_behind(block.keyword);
  if (titled && !block.lines.empty()) own.title = shortened(block.lines.front(), 100);
  own.title.erase(0, std::min(own.title.find_first_not_of(' '), own.title.size()));
  Cards cards(deck, block, version, titled, out);
  const Layout& layout = *layout_of(type, version);
  std::size_t boundary = layout.boundary_card;
  if (layout.has_curvature) {
    const double curvature = cards.number(1, 80, 10, "Icurv", true);
    if (curvature == 1.0 || curvature == 2.0) ++boundary;
  }
  const std::size_t marked = cards.marked_boundary();
  const bool is_there = cards.is_boundary(boundary);
  // TYPE24 and 25 have such digits on a card of their own, too.
  const bool alone = type != 24 && type != 25;
  if ((is_there && alone && marked != 0 && marked != boundary) || (!is_there && marked == 0)) {
    one.unread = fmt::format(
        "card {} of a TYPE{} of version {} has the digits of IBC, and friction beside it; here {}",
        layout.boundary_card, type, version,
        is_there ? fmt::format("card {} has 000 in columns 8 to 10", marked)
                 : "it has not, and no other card alone has 000 in columns 8 to 10");
    return one;
  }
  if (!is_there) boundary = marked;
  DeckCoefficients& set = own.otherwise;
  set.where = cards.card(boundary - 1);
  set.rest = set.where;
  set.fric = cards.number(boundary - 1, 20, 20, "Fric", false);
  if (friction.is_viscous && type != 3 && type != 5) {
    set.visf = cards.number(boundary, 60, 20, "VISF", false);
  }
  read_law(cards, boundary + 1, friction, version, one);
  one.friction_id = with_offset(one.friction_id, block.submodel.offset);
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
  std::vector<DeckInterface> interfaces;
  for (const DeckBlock& block : deck.blocks) {
    if (block.words.front() != "INTER" || block.words.size() < 3) continue;
    const DeckBlock type{
        {block.words[1].substr(std::min<std::size_t>(4, block.words[1].size()))}, {}, {}, {}, {}};
    const auto* const friction =
        std::find_if(kFrictions.begin(), kFrictions.end(),
                     [&](const Friction& each) { return each.type == id_of(type, 0); });
    if (friction == kFrictions.end() || !block.words[1].starts_with("TYPE")) continue;
    bool sound = true;
    const int version = version_of(deck, block.submodel);
    DeckInterface one = read_interface(deck, block, *friction, version, out, sound);
    if (sound) interfaces.push_back(std::move(one));
  }
  return interfaces;
}

bool has_friction(const DeckInterface& interface) {
  return interface.friction_id > 0 || !is_empty(interface.own.law, interface.own.otherwise);
}

}  // namespace slipbench::driver::radioss
