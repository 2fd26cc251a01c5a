// SPDX-License-Identifier: Apache-2.0
#include "driver/import/lsdyna/deck_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/import/radioss/deck_line.hpp"

namespace slipbench::driver::lsdyna {
namespace {

using Kind = import::Loss::Kind;

/// FS, FD, DC and VC of a card.
struct Coefficients {
  double fs = 0.0;  ///< static [1]
  double fd = 0.0;  ///< dynamic [1]
  double dc = 0.0;  ///< decay [T/L]
  double vc = 0.0;  ///< largest shear stress [F/L^2]; 0: none
};

/// Points of a *DEFINE_CURVE: relative velocity [L/T] and coefficient [1].
using Curve = std::vector<std::pair<double, double>>;

/// Pressures of a *DEFINE_TABLE [F/L^2], each with its curve.
struct Table {
  std::vector<std::pair<double, int>> values;  ///< the id of the curve, 0: of those that follow
  std::size_t block = 0;
};

Coefficients read_coefficients(CardReader& cards, std::size_t card, std::size_t first) {
  const Coefficients found{cards.number(card, first, "FS"), cards.number(card, first + 1, "FD"),
                           cards.number(card, first + 2, "DC"),
                           cards.number(card, first + 3, "VC")};
  // FS of *CONTACT, which is the first of its card, says below 0 where the friction is stated.
  constexpr const char* kNegative = "a coefficient must not be negative";
  if (found.fs < 0.0 && first > 0) cards.refuse(card, first, kNegative);
  if (found.fd < 0.0) cards.refuse(card, first + 1, kNegative);
  if (found.dc < 0.0) {
    cards.refuse(card, first + 2,
                 "DC must not be negative: the coefficient would grow with the velocity for ever");
  }
  if (found.vc < 0.0) cards.refuse(card, first + 3, "VC must not be negative");
  return found;
}

/// Returns the id that a coefficient stands for; the least int, which no card can give, for one
/// beyond all ids.
int id_of(double value) {
  using Limits = std::numeric_limits<int>;
  return std::abs(value) <= Limits::max() ? static_cast<int>(value) : Limits::min();
}

std::string number(double value) { return base::format_number(value); }

/// The coefficient in YAML. One that rises with the velocity, or is limited, which an exponential
/// decay cannot be, is the same curve as the part of a modified Darmstad law without pressure.
std::string coefficient(const Coefficients& set, double factor, bool limited) {
  const double fs = factor * set.fs;
  const double fd = factor * set.fd;
  if (set.dc == 0.0 || fs == fd) return number(fs);
  if (fs > fd && !limited) {
    return fmt::format("{{exponential_decay: {{static: {}, kinetic: {}, decay: {}}}}}", number(fs),
                       number(fd), number(set.dc));
  }
  return fmt::format("{{modified_darmstad: {{Fric: {}, C5: {}, C6: {}}}}}", number(fd),
                     number(fs - fd), number(-set.dc));
}

/// \param limited some record of the same table is, and all have one law
import::ContactRecord record(const Coefficients& set, bool limited, double factor = 1.0,
                             double limit_factor = 1.0){
    return {.coefficient = coefficient(set, factor, limited), .shear_limit = limit_factor * set.vc};
}  // namespace

bool is_option(std::string_view keyword, std::string_view option) {
  return keyword.find(std::string("_") + std::string(option)) != keyword.npos;
}

/// Tells whether a card is the second one of the option MPP, which has '&' in its first column; a
/// parameter's name behind it makes it another one.
bool is_second_of_mpp(std::string_view card) {
  if (!card.starts_with('&')) return false;
  const std::size_t next = card.find_first_not_of(' ', 1);
  return next == card.npos || !std::isalpha(static_cast<unsigned char>(card[next]));
}

/// Reads all that a friction may be made of.
class FrictionReader {
 public:
  FrictionReader(const KeywordDeck& deck, base::Diagnostics& out, std::optional<int> contact)
      : deck_(deck), out_(out), contact_(contact) {}

  std::vector<Found> read() {
    for (const Block& block : deck_.blocks) {
      if (block.keyword.starts_with("SET_PART")) read_group(block);
    }
    for (const auto& [id, group] : groups_) {
      std::vector<int>& parts = group->parts;
      std::sort(parts.begin(), parts.end());
      parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    }
    for (std::size_t i = 0; i < deck_.blocks.size(); ++i) {
      const std::string& keyword = deck_.blocks[i].keyword;
      const std::string plain =
          keyword.ends_with("_TITLE") ? keyword.substr(0, keyword.rfind('_')) : keyword;
      if (plain == "DEFINE_CURVE") {
        read_curve(i);
      } else if (plain == "DEFINE_CURVE_FUNCTION" || plain == "DEFINE_CURVE_SMOOTH") {
        // Curves without points, which a table that counts on them misses.
        curve_of_block_[i] = {};
      }
      if (plain == "DEFINE_TABLE" || plain == "DEFINE_TABLE_2D") read_table(i);
      if (plain == "DEFINE_FRICTION") {
        read_definition(i);
      } else if (plain.starts_with("DEFINE_FRICTION_")) {
        const std::string_view where = deck_.blocks[i].where;
        out_.warning(deck_.texts.name(where), deck_.texts.position(where), "*" + keyword,
                     "is not read: what it changes of the friction is missing here");
      }
    }
    for (const Block& block : deck_.blocks) {
      if (block.keyword.starts_with("CONTACT_")) read_contact(block);
    }
    for (auto& [id, definition] : definitions_) {
      if (named_.count(id) == 0) found_.push_back({id, true, std::move(definition)});
    }
    return std::move(found_);
  }

 private:
  void read_group(const Block& block) {
    CardReader cards(deck_, block, out_);
    const std::size_t first = is_option(block.keyword, "TITLE") ? 1 : 0;
    import::ContactGroup group;
    const int id = cards.id(first, 0, "SID");
    group.name = fmt::format("S{}", id);
    if (first == 1) group.title = radioss::shortened(cards.text(0, 0, 80), 80);
    const bool listed = !is_option(block.keyword, "ADD") && !is_option(block.keyword, "GENERATE") &&
                        !is_option(block.keyword, "COLUMN") && !is_option(block.keyword, "TREE");
    for (std::size_t card = first + 1; listed && card < cards.count(); ++card) {
      for (std::size_t field = 0; field < 8; ++field) {
        const int part = cards.id(card, field, "PID");
        if (part > 0) group.parts.push_back(part);
      }
    }
    const auto collected = groups_.find(id);
    if (is_option(block.keyword, "COLLECT") && collected != groups_.end()) {
      std::vector<int>& parts = collected->second->parts;
      parts.insert(parts.end(), group.parts.begin(), group.parts.end());
      return;
    }
    keep(groups_, id, std::make_shared<import::ContactGroup>(std::move(group)), cards, first);
  }

  /// Keeps what a keyword says under its id, which no other has.
  template <class T>
  static void keep(std::map<int, T>& all, int id, T one, CardReader& cards, std::size_t card) {
    if (!cards.sound()) return;
    if (!all.try_emplace(id, std::move(one)).second) {
      cards.refuse(card, 0, fmt::format("the id {} stands twice", id));
    }
  }

  void read_curve(std::size_t index) {
    const Block& block = deck_.blocks[index];
    CardReader cards(deck_, block, out_);
    const std::size_t first = is_option(block.keyword, "TITLE") ? 1 : 0;
    const int id = cards.id(first, 0, "LCID");
    const auto scale = [&](std::size_t field, std::string_view name) {
      const double value = cards.number(first, field, name);
      return value == 0.0 ? 1.0 : value;
    };
    const double sfa = scale(2, "SFA");
    const double sfo = scale(3, "SFO");
    const double offa = cards.number(first, 4, "OFFA");
    const double offo = cards.number(first, 5, "OFFO");
    Curve curve;
    for (std::size_t card = first + 1; card < cards.count(); ++card) {
      if (cards.is_blank(card)) continue;
      curve.emplace_back(sfa * (cards.number(card, 0, "A", 20) + offa),
                         sfo * (cards.number(card, 1, "O", 20) + offo));
    }
    curve_of_block_[index] = curve;
    keep(curves_, id, std::move(curve), cards, first);
  }

  void read_table(std::size_t index) {
    const Block& block = deck_.blocks[index];
    CardReader cards(deck_, block, out_);
    const std::size_t first = is_option(block.keyword, "TITLE") ? 1 : 0;
    const int id = cards.id(first, 0, "TBID");
    const bool names_curves = is_option(block.keyword, "TABLE_2D");
    const double scale = cards.number(first, 1, "SFA");
    const double offset = cards.number(first, 2, "OFFA");
    Table table;
    table.block = index;
    for (std::size_t card = first + 1; card < cards.count(); ++card) {
      if (cards.is_blank(card)) continue;
      const double value = cards.number(card, 0, "VALUE", 20) + offset;
      table.values.emplace_back(scale == 0.0 ? value : scale * value,
                                names_curves ? cards.id(card, 1, "LCID", 20) : 0);
    }
    keep(tables_, id, std::move(table), cards, first);
  }

  void read_definition(std::size_t index) {
    const Block& block = deck_.blocks[index];
    CardReader cards(deck_, block, out_);
    const std::size_t first = is_option(block.keyword, "TITLE") ? 1 : 0;
    const int id = cards.id(first, 0, "FID");
    import::ContactFriction friction{.name = fmt::format("*DEFINE_FRICTION {}", id)};
    if (first == 1) friction.title = radioss::shortened(cards.text(0, 0, 80), 80);
    const Coefficients all = read_coefficients(cards, first, 1);
    bool limited = all.vc > 0.0;
    for (std::size_t card = first + 1; card < cards.count(); ++card) {
      limited = limited || cards.number(card, 5, "VC") > 0.0;
    }
    friction.sees_pressure = limited;
    friction.otherwise = record(all, limited);
    std::set<int> met;
    for (std::size_t card = first + 1; card < cards.count(); ++card) {
      if (cards.is_blank(card)) continue;
      const Coefficients set = read_coefficients(cards, card, 2);
      import::ContactRecord& pair = friction.pairs.emplace_back(record(set, limited));
      for (std::size_t side = 0; side < 2 && cards.sound(); ++side) {
        const int number = cards.id(card, side, "PID");
        if (number <= 0) cards.refuse(card, side, "wanted the id of a part or of a set of parts");
        const std::string_view type = cards.text(card, 6 + side);
        const bool is_set = type == "PSET" || type == "pset" || type == "Pset";
        if (!is_set && !type.empty() && type != "0")
          cards.refuse(card, 6 + side, "wanted PSET or nothing");
        pair.sides[side] = (is_set ? "S" : "") + std::to_string(number);
        if (is_set && met.insert(number).second) {
          const auto group = groups_.find(number);
          friction.groups.push_back(group != groups_.end()
                                        ? group->second
                                        : std::make_shared<import::ContactGroup>(
                                              import::ContactGroup{pair.sides[side], {}, {}}));
        }
      }
      const std::string_view line = block.cards[card];
      pair.remark = fmt::format("line {} of the deck", deck_.texts.position(line).line);
    }
    if (!cards.sound()) return;
    tell_traps(all, friction);
    if (!friction.pairs.empty()) {
      friction.losses.push_back(
          {Kind::kApproximated,
           "of records that join the same two parts the last one holds here; *DEFINE_FRICTION "
           "does not say which one does"});
    }
    keep(definitions_, id, std::move(friction), cards, first);
  }

  void read_contact(const Block& block) {
    constexpr std::array<std::string_view, 5> kWithoutFriction{
        "CONTACT_INTERIOR", "CONTACT_COUPLING", "CONTACT_ADD_WEAR", "CONTACT_AUTO_M",
        "CONTACT_EXCLUDE"};
    constexpr std::array<std::string_view, 4> kOther{"CONTACT_1D", "CONTACT_2D", "CONTACT_ENTITY",
                                                     "CONTACT_GEBOD"};
    const auto begins = [&](std::string_view one) { return block.keyword.starts_with(one); };
    if (std::ranges::any_of(kWithoutFriction, begins) ||
        is_option(block.keyword, "FORCE_TRANSDUCER")) {
      return;
    }
    CardReader cards(deck_, block, out_);
    std::size_t first = 0;
    Found found;
    // Where a contact has no id, the program counts.
    do {
      found.id = ++count_;
    } while (ids_.count(found.id) > 0);
    found.friction.name = "*" + block.keyword;
    if (block.keyword.ends_with("_ID") || is_option(block.keyword, "ID_") ||
        is_option(block.keyword, "TITLE")) {
      found.id = cards.id(0, 0, "CID");
      const std::string_view card = cards.count() > 0 ? block.cards[0] : std::string_view();
      found.friction.title =
          radioss::shortened(card.substr(std::min<std::size_t>(10, card.size())), 70);
      const std::size_t begin = found.friction.title.find_first_not_of(' ');
      found.friction.title.erase(0, std::min(begin, found.friction.title.size()));
      first = 1;
    }
    ids_.insert(found.id);
    found.friction.name += fmt::format(" {}", found.id);
    if (std::ranges::any_of(kOther, begins)) {
      found.passed_over = "contacts of its kind are not read";
      found_.push_back(std::move(found));
      return;
    }
    if (is_option(block.keyword, "MPP")) {
      ++first;
      if (first < block.cards.size() && is_second_of_mpp(block.cards[first])) ++first;
    }
    if (is_option(block.keyword, "TIED") || is_option(block.keyword, "SPOTWELD")) {
      found.passed_over = "is tied: no friction";
      found_.push_back(std::move(found));
      return;
    }
    if (cards.count() < first + 2) {
      found.passed_over = fmt::format("its card with FS is missing: it has {} card{} of {}",
                                      cards.count(), cards.count() == 1 ? "" : "s", first + 3);
      found_.push_back(std::move(found));
      return;
    }
    if (is_option(block.keyword, "ORTHO_FRICTION")) {
      found.passed_over = "its coefficients of two directions, of _ORTHO_FRICTION, are not read";
      found_.push_back(std::move(found));
      return;
    }
    const Coefficients set = read_coefficients(cards, first + 1, 0);
    const auto factor = [&](std::size_t field, std::string_view name) {
      const double value = cards.number(first + 2, field, name);
      return value == 0.0 ? 1.0 : value;
    };
    const double fsf = factor(6, "FSF");
    const double vsf = factor(7, "VSF");
    if (!cards.sound()) return;
    if (fsf < 0.0 || vsf < 0.0) {
      found.passed_over = fmt::format("{} has no meaning known here",
                                      fsf < 0.0 ? "FSF " + number(fsf) : "VSF " + number(vsf));
      found_.push_back(std::move(found));
      return;
    }
    take(set, fsf, vsf, found);
    if (is_option(block.keyword, "THERMAL_FRICTION")) {
      found.friction.losses.push_back(
          {Kind::kDropped, "the curves over temperature of _THERMAL_FRICTION"});
    }
    found_.push_back(std::move(found));
  }

  /// Gives a contact its friction, by what FS says.
  void take(const Coefficients& set, double fsf, double vsf, Found& found) {
    import::ContactFriction& friction = found.friction;
    of_others_ = records_;
    if (set.fs == -1.0) {
      found.passed_over =
          "FS -1 takes the coefficients of its parts (*PART_CONTACT), which are joined by a rule "
          "of the program: write those of each pair into *DEFINE_FRICTION";
      return;
    }
    if (set.fs == -2.0) {
      take_definition(set, fsf, vsf, found);
      return;
    }
    if (set.fs == 2.0) {
      take_table(set, fsf, vsf, found);
      return;
    }
    if (set.fs < 0.0) {
      found.passed_over = fmt::format("FS {} has no meaning known here", number(set.fs));
      return;
    }
    if (set.fs == 0.0 && set.fd == 0.0) {
      found.passed_over = "no friction";
      return;
    }
    friction.otherwise = record(set, set.vc > 0.0, fsf, vsf);
    friction.sees_pressure = set.vc > 0.0;
    tell_traps(set, friction);
    tell_factors(fsf, vsf, friction);
  }

  /// Tells whether a contact takes so many records; once there are too many, that is an error.
  bool takes(std::size_t records, const Found& found) {
    if (contact_ && found.id != *contact_) return false;
    const bool had_room = records_ <= import::kMostRecords;
    records_ += records;
    if (records_ <= import::kMostRecords) return true;
    if (had_room) {
      out_.error(
          deck_.texts[0].name(), {}, found.friction.name,
          fmt::format("has more than {} records of part pairs and rows of tables, with those "
                      "of the contacts before it",
                      import::kMostRecords),
          contact_ || of_others_ == 0 ? "" : "--interface takes one contact alone");
    }
    return false;
  }

  void take_definition(const Coefficients& set, double fsf, double vsf, Found& found) {
    const int wanted = id_of(set.fd);
    const auto definition =
        wanted == 0 && definitions_.size() == 1 ? definitions_.begin() : definitions_.find(wanted);
    if (definition == definitions_.end()) {
      found.passed_over = wanted == 0
                              ? fmt::format(
                                    "FS -2 names no *DEFINE_FRICTION, and there "
                                    "are {}",
                                    definitions_.size())
                              : fmt::format("*DEFINE_FRICTION {} is not there", number(set.fd));
      return;
    }
    if (fsf != 1.0 || vsf != 1.0) {
      found.passed_over = "its FSF or VSF scales a table of part pairs: write the products there";
      return;
    }
    named_.insert(definition->first);
    std::size_t records = definition->second.pairs.size();
    for (const auto& group : definition->second.groups) records += group->parts.size();
    if (!takes(records, found)) return;
    std::string name = found.friction.name;
    std::string title = std::move(found.friction.title);
    found.friction = definition->second;
    found.friction.notes.push_back(fmt::format("{} names it by FS -2", name));
    if (!title.empty()) found.friction.title = std::move(title);
  }

  void take_table(const Coefficients& set, double fsf, double vsf, Found& found) {
    const int id = id_of(set.fd);
    const auto table = tables_.find(id);
    if (table == tables_.end() || table->second.values.empty()) {
      found.passed_over =
          fmt::format("FS 2 names *DEFINE_TABLE {}, which is not there", number(set.fd));
      return;
    }
    std::string rows;
    auto next = curve_of_block_.upper_bound(table->second.block);
    for (const auto& [pressure, curve_id] : table->second.values) {
      const Curve* curve = nullptr;
      if (curve_id != 0) {
        const auto named = curves_.find(curve_id);
        if (named != curves_.end()) curve = &named->second;
      } else if (next != curve_of_block_.end()) {
        curve = &next->second;
        ++next;
      }
      if (curve == nullptr || curve->empty()) {
        found.passed_over = fmt::format("a curve of *DEFINE_TABLE {} is not there", id);
        return;
      }
      if (!takes(curve->size(), found)) return;
      for (const auto& [velocity, mu] : *curve) {
        rows += fmt::format("{}[{}, {}, = {}*area]", rows.empty() ? "" : ",\n        ",
                            number(fsf * mu), number(velocity), number(pressure));
      }
    }
    found.friction.otherwise.coefficient =
        "\n      columns: [mu, slip_rate, contact_force]\n      rows: [" + rows + "]";
    found.friction.sees_pressure = true;
    if (set.vc > 0.0) found.friction.otherwise.shear_limit = vsf * set.vc;
    found.friction.losses.push_back(
        {Kind::kApproximated, fmt::format("*DEFINE_TABLE {} is over the pressure of a segment, the "
                                          "case's table over force/area; outside of it both keep "
                                          "its end values",
                                          id)});
    tell_factors(fsf, vsf, found.friction);
  }

  static void tell_factors(double fsf, double vsf, import::ContactFriction& friction) {
    if (fsf != 1.0) friction.notes.push_back(fmt::format("FSF {} is in the numbers", number(fsf)));
    if (vsf != 1.0) friction.notes.push_back(fmt::format("VSF {} is in the limit", number(vsf)));
  }

  static void tell_traps(const Coefficients& set, import::ContactFriction& friction) {
    if (set.dc > 0.0 && set.fd == 0.0 && set.fs > 0.0) {
      friction.notes.emplace_back(
          "FD is 0 with a decay: the friction vanishes at high velocity, as it does in the "
          "program");
    }
    if (set.dc == 0.0 && set.fd != set.fs) {
      friction.notes.emplace_back("without DC the coefficient is FS at every velocity; FD is idle");
    }
    if (friction.sees_pressure) {
      friction.losses.push_back(
          {Kind::kApproximated,
           "VC limits the force to VC times the area of a segment; the case has one area"});
    }
  }

  const KeywordDeck& deck_;
  base::Diagnostics& out_;
  std::optional<int> contact_;
  std::size_t records_ = 0;
  std::size_t of_others_ = 0;  ///< of the contacts before the one that is read
  std::map<int, std::shared_ptr<import::ContactGroup>> groups_;
  std::map<int, Curve> curves_;
  std::map<std::size_t, Curve> curve_of_block_;
  std::map<int, Table> tables_;
  std::map<int, import::ContactFriction> definitions_;
  std::set<int> named_, ids_;
  std::vector<Found> found_;
  int count_ = 0;
};

}  // namespace slipbench::driver::lsdyna

std::vector<Found> read_frictions(const KeywordDeck& deck, base::Diagnostics& out,
                                  std::optional<int> contact) {
  return FrictionReader(deck, out, contact).read();
}

}  // namespace slipbench::driver::lsdyna
