// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/deck_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <numbers>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/import/radioss/deck_line.hpp"
#include "law/friction/renard.hpp"

namespace slipbench::driver::radioss {
namespace {

constexpr DeckField integer(std::size_t begin, std::string_view name) {
  return {begin, 10, name, true};
}
constexpr DeckField real(std::size_t begin, std::string_view name) {
  return {begin, 20, name, false};
}
constexpr DeckField blank(std::size_t begin) { return {begin, 10, {}, false}; }

constexpr std::array kOptions{integer(0, "Ifric"), integer(10, "Ifiltr"), real(20, "Xfreq"),
                              integer(40, "Iform")};
constexpr std::array kFirstFive{real(0, "C1"), real(20, "C2"), real(40, "C3"), real(60, "C4"),
                                real(80, "C5")};
constexpr std::array kLastThree{real(0, "C6"), real(20, "Fric"), real(40, "VISF")};
constexpr std::array kSides{integer(0, "grpart_ID1"),
                            integer(10, "grpart_ID2"),
                            integer(20, "part_ID1"),
                            integer(30, "part_ID2"),
                            blank(40),
                            integer(50, "Idir")};
constexpr std::array kOriented{integer(0, "grpart_ID"), integer(10, "part_ID")};
constexpr std::array kDirection{real(0, "Vx"),          real(20, "Vy"),  real(40, "Vz"),
                                integer(60, "skew_ID"), real(70, "phi"), integer(90, "Iorth")};
constexpr std::array kTenParts{integer(0, "item_ID1"),  integer(10, "item_ID2"),
                               integer(20, "item_ID3"), integer(30, "item_ID4"),
                               integer(40, "item_ID5"), integer(50, "item_ID6"),
                               integer(60, "item_ID7"), integer(70, "item_ID8"),
                               integer(80, "item_ID9"), integer(90, "item_ID10")};

std::string title_of(const DeckBlock& block) {
  if (block.lines.empty()) return {};
  std::string_view line = block.lines.front();
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  return shortened(line, 100);
}

/// Walks through the lines of a block; the first fault ends it.
class BlockReader {
 public:
  BlockReader(const DeckBlock& block, const StarterDeck& deck, base::Diagnostics& out)
      : block_(block), deck_(deck), out_(out), path_(shortened(block.keyword, 40)) {
    if (block.gap) {
      warning(*block.gap, "a blank line is passed over: a line without values is written as zeros");
    }
  }

  [[nodiscard]] bool at_end() const { return next_ >= block_.lines.size(); }
  [[nodiscard]] bool sound() const { return sound_; }
  [[nodiscard]] std::string_view upcoming() const {
    return at_end() ? block_.lines.empty() ? block_.keyword : block_.lines.back()
                    : block_.lines[next_];
  }
  void skip_title() { next_ = std::min<std::size_t>(1, block_.lines.size()); }

  /// The next line's numbers; zeros after a fault.
  template <std::size_t Count>
  std::vector<double> numbers(const std::array<DeckField, Count>& fields, std::string_view what,
                              std::size_t least_free = 0) {
    const auto named = static_cast<std::size_t>(std::count_if(
        fields.begin(), fields.end(), [](const DeckField& field) { return !field.name.empty(); }));
    std::vector<double> zeros(named, 0.0);
    texts_.assign(named, upcoming());
    if (!sound_) return zeros;
    if (at_end()) {
      error(upcoming(), "FRIC006: incomplete block: the line of " + std::string(what) +
                            " is missing behind this one");
      return zeros;
    }
    const std::string_view line = block_.lines[next_++];
    auto read = read_numbers(line, fields, least_free, deck_.parameters);
    if (!read) {
      error(read.error().text.empty() ? line : read.error().text,
            std::string(what) + ": " + read.error().message);
      return zeros;
    }
    if (read->free_format) {
      warning(line, "read in free format: the numbers of " + std::string(what) +
                        " do not stand in their columns");
    }
    texts_ = std::move(read->texts);
    for (std::string_view& text : texts_) {
      if (text.empty()) text = line;
    }
    return std::move(read->values);
  }
  /// Returns where field i of the line read last stands.
  [[nodiscard]] std::string_view text(std::size_t i) const { return texts_[i]; }

  void error(std::string_view piece, std::string message, std::string hint = {}) {
    sound_ = false;
    out_.error(deck_.texts.name(piece), deck_.texts.position(piece), path_, std::move(message),
               std::move(hint));
  }
  void warning(std::string_view piece, std::string message, std::string hint = {}) {
    out_.warning(deck_.texts.name(piece), deck_.texts.position(piece), path_, std::move(message),
                 std::move(hint));
  }
  [[nodiscard]] int line_of(std::string_view piece) const {
    return deck_.texts.position(piece).line;
  }

 private:
  const DeckBlock& block_;
  const StarterDeck& deck_;
  base::Diagnostics& out_;
  std::string path_;
  std::size_t next_ = 0;
  std::vector<std::string_view> texts_;
  bool sound_ = true;
};

DeckCoefficients read_set(BlockReader& reader, std::string_view which) {
  DeckCoefficients set;
  set.where = reader.upcoming();
  const auto first = reader.numbers(kFirstFive, "C1 .. C5" + std::string(which));
  set.rest = reader.upcoming();
  const auto last = reader.numbers(kLastThree, "C6, Fric, VISF" + std::string(which));
  std::copy(first.begin(), first.end(), set.c.begin());
  set.c[5] = last[0];
  set.fric = last[1];
  set.visf = last[2];
  if (set.visf < 0.0) {
    reader.error(reader.text(2),
                 "FRIC007: VISF must not be negative, found " + base::format_number(set.visf));
  }
  return set;
}

DeckPair read_pair(BlockReader& reader) {
  DeckPair pair;
  const std::string_view line = reader.upcoming();
  pair.where = line;
  pair.line = reader.line_of(line);
  const auto ids = reader.numbers(kSides, "grpart_ID1, grpart_ID2, part_ID1, part_ID2, Idir", 4);
  for (std::size_t side = 0; side < 2; ++side) {
    DeckSide& one = pair.sides[side];
    one.group = static_cast<int>(ids[side]);
    one.part = static_cast<int>(ids[side + 2]);
    const std::string name = "side " + std::to_string(side + 1);
    if (!reader.sound()) continue;
    if (one.group < 0 || one.part < 0) {
      reader.error(one.group < 0 ? reader.text(side) : reader.text(side + 2),
                   "FRIC003: " + name + " of the record has a negative id");
    } else if (one.group == 0 && one.part == 0) {
      reader.error(line, "FRIC003: " + name + " of the record names no group and no part",
                   "OpenRadioss passes over such a record in silence");
    } else if (one.group > 0 && one.part > 0) {
      reader.warning(reader.text(side + 2),
                     fmt::format("{} of the record names group {} and part {}: the group counts",
                                 name, one.group, one.part));
      one.part = 0;
    }
  }
  const int direction = static_cast<int>(ids[4]);
  if (reader.sound() && direction != 0 && direction != 1) {
    reader.error(reader.text(4),
                 "Idir is 0 (isotropic) or 1 (orthotropic), found " + std::to_string(direction));
  }
  pair.first = read_set(reader, direction == 1 ? " along direction 1" : "");
  if (direction == 1) pair.second = read_set(reader, " along direction 2");
  return pair;
}

/// An option that is one of a few integers.
int choice(BlockReader& reader, std::size_t field, double value, int most,
           std::string_view message) {
  const int number = static_cast<int>(value);
  if (reader.sound() && (number < 0 || number > most)) {
    reader.error(reader.text(field), fmt::format(fmt::runtime(message), number));
  }
  return number;
}

/// Ifiltr and Xfreq make the filter coefficient alpha, which must be in (0, 1].
void check_filter(BlockReader& reader, const DeckFriction& friction) {
  const double x = friction.xfreq;
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  const auto refuse = [&](const std::string& rule) {
    reader.error(reader.text(2), fmt::format("FRIC002: Ifiltr {} wants {}, found Xfreq {}",
                                             friction.filter, rule, base::format_number(x)));
  };
  if (!reader.sound() || friction.filter == 0) return;
  if (x < 0.0) return refuse("an Xfreq that is not negative");
  if (x == 0.0) {
    reader.warning(reader.text(2),
                   fmt::format("Ifiltr {} with Xfreq 0 filters nothing", friction.filter));
  } else if (friction.filter == 1 && x > 1.0) {
    refuse("alpha = Xfreq between 0 and 1");
  } else if (friction.filter == 2 && x < kTwoPi) {
    refuse("at least 2 pi = 6.2832 time steps a period");
  }
}

/// Counts a side as the whole deck does.
void shift(DeckSide& side, const Submodel& submodel) {
  side.group = with_offset(side.group, submodel.offset);
  side.part = with_offset(side.part, submodel.part_offset);
}

std::optional<DeckFriction> read_friction(const DeckBlock& block, const StarterDeck& deck,
                                          base::Diagnostics& out) {
  BlockReader reader(block, deck, out);
  DeckFriction friction;
  friction.where = block.keyword;
  friction.id = with_offset(id_of(block, 1), block.submodel.offset);
  friction.unit_id = id_of(block, 2) > 0 ? id_of(block, 2) : block.submodel.unit_id;
  if (friction.id == 0) reader.error(block.keyword, "wanted /FRICTION/id with an id of at least 1");
  friction.title = title_of(block);
  reader.skip_title();
  const auto options = reader.numbers(kOptions, "Ifric, Ifiltr, Xfreq, Iform", 3);
  friction.law = choice(reader, 0, options[0], 4,
                        "FRIC001: unknown Ifric {}; 0 Coulomb, 1 generalised viscous, 2 modified "
                        "Darmstad, 3 Renard, 4 exponential decay");
  friction.filter = choice(reader, 1, options[1], 3, "FRIC002: unknown Ifiltr {}; 0 none, 1 to 3");
  friction.xfreq = options[2];
  friction.formulation =
      std::max(1, choice(reader, 3, options[3], 2, "unknown Iform {}; 1 viscous, 2 stiffness"));
  check_filter(reader, friction);
  friction.otherwise = read_set(reader, " of the default");
  while (reader.sound() && !reader.at_end()) friction.pairs.push_back(read_pair(reader));
  if (!reader.sound()) return std::nullopt;
  for (DeckPair& pair : friction.pairs) {
    for (DeckSide& side : pair.sides) shift(side, block.submodel);
  }
  return friction;
}

std::vector<DeckOrientation> read_orientation(const DeckBlock& block, const StarterDeck& deck,
                                              base::Diagnostics& out) {
  BlockReader reader(block, deck, out);
  std::vector<DeckOrientation> entries;
  reader.skip_title();
  while (reader.sound() && !reader.at_end()) {
    DeckOrientation entry;
    entry.where = reader.upcoming();
    entry.line = reader.line_of(entry.where);
    const auto of = reader.numbers(kOriented, "grpart_ID, part_ID");
    const auto direction = reader.numbers(kDirection, "Vx, Vy, Vz, skew_ID, phi, Iorth");
    entry.of = {static_cast<int>(of[0]), static_cast<int>(of[1])};
    shift(entry.of, block.submodel);
    // The program takes the global x axis for a vector that was left empty.
    if (direction[0] != 0.0 || direction[1] != 0.0 || direction[2] != 0.0) {
      entry.vector = {direction[0], direction[1], direction[2]};
    }
    entry.skew = static_cast<int>(direction[3]);
    entry.phi = direction[4];
    entries.push_back(entry);
  }
  if (!reader.sound()) entries.clear();
  return entries;
}

/// The parts of /GRPART/PART, ten a line; other kinds of group say them in other ways.
std::optional<DeckGroup> read_group(const DeckBlock& block, const StarterDeck& deck,
                                    base::Diagnostics& out) {
  DeckGroup group{with_offset(id_of(block, 2), block.submodel.offset), title_of(block), {}, {}};
  if (group.id == 0) return std::nullopt;
  if (block.words[1] != "PART") return group;
  std::set<int> parts;
  for (std::size_t i = 1; i < block.lines.size(); ++i) {
    auto read = read_numbers(block.lines[i], kTenParts, 0, deck.parameters);
    if (!read) {
      out.warning(deck.texts.name(block.lines[i]), deck.texts.position(block.lines[i]),
                  shortened(block.keyword, 40),
                  "its parts cannot be read: " + read.error().message);
      return group;
    }
    for (const double part : read->values) {
      const int sign = part < 0.0 ? -1 : 1;
      const int id =
          sign * with_offset(static_cast<int>(std::abs(part)), block.submodel.part_offset);
      // A negative id takes a part out of a set that other lines have put in.
      if (id < 0) parts.erase(-id);
      if (id > 0) parts.insert(id);
    }
  }
  group.parts.assign(parts.begin(), parts.end());
  return group;
}

/// A unit of one dimension, by the names decks have for it.
struct DeckUnit {
  std::string_view in_deck;
  std::string_view common;
  double in_si;
};
constexpr std::array kMasses{DeckUnit{"kg", "kg", 1.0},  DeckUnit{"g", "g", 1e-3},
                             DeckUnit{"mg", "mg", 1e-6}, DeckUnit{"Mg", "Mg", 1e3},
                             DeckUnit{"ton", "Mg", 1e3}, DeckUnit{"t", "Mg", 1e3}};
constexpr std::array kLengths{DeckUnit{"m", "m", 1.0},    DeckUnit{"dm", "dm", 1e-1},
                              DeckUnit{"cm", "cm", 1e-2}, DeckUnit{"mm", "mm", 1e-3},
                              DeckUnit{"um", "um", 1e-6}, DeckUnit{"km", "km", 1e3}};
constexpr std::array kTimes{DeckUnit{"s", "s", 1.0}, DeckUnit{"ms", "ms", 1e-3},
                            DeckUnit{"us", "us", 1e-6}, DeckUnit{"mus", "us", 1e-6},
                            DeckUnit{"ns", "ns", 1e-9}};
struct UnitSlot {
  std::string_view name;
  std::span<const DeckUnit> known;
};
constexpr std::array kUnitSlots{UnitSlot{"mass", kMasses}, UnitSlot{"length", kLengths},
                                UnitSlot{"time", kTimes}};

/// Reads a line of units: of mass, length and time. The force is the one consistent with them. What
/// is no unit of its dimension is a fault.
std::optional<base::UnitSystem> units_in(std::string_view line, std::vector<DeckFault>& faults) {
  std::string_view rest = line;
  std::array<const DeckUnit*, 3> units{};
  for (std::size_t i = 0; i < units.size(); ++i) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(word.size());
    const UnitSlot& slot = kUnitSlots[i];
    const auto found = std::find_if(slot.known.begin(), slot.known.end(),
                                    [&](const DeckUnit& unit) { return unit.in_deck == word; });
    if (found != slot.known.end()) {
      units[i] = &*found;
    } else if (word.empty()) {
      faults.push_back({fmt::format("the unit of {} is missing", slot.name), line});
    } else {
      faults.push_back(
          {fmt::format("wanted a unit of {}, found '{}'", slot.name, shortened(word, 40)), word});
    }
  }
  if (!faults.empty()) return std::nullopt;
  const auto [mass, length, time] = units;
  const double newtons = mass->in_si * length->in_si / (time->in_si * time->in_si);
  constexpr std::array<std::pair<std::string_view, double>, 6> kForces{
      {{"N", 1.0}, {"kN", 1e3}, {"MN", 1e6}, {"GN", 1e9}, {"mN", 1e-3}, {"uN", 1e-6}}};
  for (const auto& [name, factor] : kForces) {
    if (std::abs(newtons / factor - 1.0) < 1e-9) {
      return base::UnitSystem{
          std::string(length->common), std::string(name), std::string(time->common), {}};
    }
  }
  faults.push_back(
      {fmt::format("no unit of force has a name that goes with {}, {} and {}: it is {:g} N",
                   mass->common, length->common, time->common, newtons),
       line});
  return std::nullopt;
}

/// Takes the system of units from /BEGIN: run name, version, units of the input, units of the work.
/// A block that ends before it states none.
void take_units(const DeckBlock& block, DeckContents& contents) {
  if (block.submodel.unit_id < 0) {
    std::vector<DeckFault> faults;
    auto units = block.lines.size() > 2 ? units_in(block.lines[2], faults) : std::nullopt;
    if (units) contents.local_units[block.submodel.unit_id] = std::move(*units);
    return;
  }
  contents.units.reset();
  contents.unit_faults.clear();
  if (block.lines.size() > 2) contents.units = units_in(block.lines[2], contents.unit_faults);
}

/// Takes a local system from /UNIT/id: a title, then the units.
void take_local_units(const DeckBlock& block, DeckContents& contents) {
  std::vector<DeckFault> faults;
  if (block.lines.size() < 2) return;
  if (auto units = units_in(block.lines[1], faults)) {
    contents.local_units[id_of(block, 1)] = std::move(*units);
  }
}

void sort_unique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Passes messages on, errors as warnings.
void warn(const base::Diagnostics& messages, base::Diagnostics& out) {
  for (base::Diagnostic one : messages.sorted()) {
    if (one.severity == base::Severity::kError) {
      one.severity = base::Severity::kWarning;
      one.hint += (one.hint.empty() ? "" : "; ") + std::string("the block is passed over");
    }
    out.add(std::move(one));
  }
}

/// Reads a /FRICTION block into the contents.
void add_friction(const DeckBlock& block, const StarterDeck& deck, DeckContents& contents,
                  base::Diagnostics& out) {
  auto friction = read_friction(block, deck, out);
  if (!friction) return;
  const auto same = std::find_if(contents.frictions.begin(), contents.frictions.end(),
                                 [&](const DeckFriction& f) { return f.id == friction->id; });
  if (same != contents.frictions.end()) {
    out.error(deck.texts.name(block.keyword), deck.texts.position(block.keyword),
              shortened(block.keyword, 40),
              fmt::format("stands twice, first in line {}", deck.texts.position(same->where).line));
    return;
  }
  contents.frictions.push_back(std::move(*friction));
}

/// Reports a version of the input that is no number: the cards of interfaces are counted by it.
void judge_version(const DeckBlock& block, const StarterDeck& deck, base::Diagnostics& out) {
  if (block.lines.size() < 2) return;
  const auto version = read_field(block.lines[1], {0, 10, "version", true}, {});
  if (version) return;
  out.warning(deck.texts.name(block.lines[1]), deck.texts.position(version.error().text), "/BEGIN",
              version.error().message, "read as one of the latest version");
}

/// Sorts what is looked up, and takes the parts that are not there out of the groups.
void complete(DeckContents& contents) {
  sort_unique(contents.parts);
  sort_unique(contents.interface_types);
  std::stable_sort(contents.groups.begin(), contents.groups.end(),
                   [](const DeckGroup& a, const DeckGroup& b) { return a.id < b.id; });
  if (!has_all_parts(contents)) return;
  for (DeckGroup& group : contents.groups) {
    std::vector<int> there;
    std::set_intersection(group.parts.begin(), group.parts.end(), contents.parts.begin(),
                          contents.parts.end(), std::back_inserter(there));
    std::set_difference(group.parts.begin(), group.parts.end(), there.begin(), there.end(),
                        std::back_inserter(group.not_there));
    group.parts = std::move(there);
  }
}

}  // namespace

std::string name_of(const DeckFriction& friction) {
  return friction.interface_type == 0
             ? fmt::format("/FRICTION/{}", friction.id)
             : fmt::format("/INTER/TYPE{}/{}", friction.interface_type, friction.id);
}

bool has_all_parts(const DeckContents& deck) { return !deck.parts.empty() && !deck.has_includes; }

DeckContents read_contents(const StarterDeck& deck, std::optional<int> chosen,
                           base::Diagnostics& out) {
  DeckContents contents;
  contents.has_includes = deck.has_includes;
  base::Diagnostics of_directions;
  std::set<int> groups;
  for (const DeckBlock& block : deck.blocks) {
    const std::string& word = block.words.front();
    if (word == "FRICTION") {
      base::Diagnostics messages;
      add_friction(block, deck, contents, messages);
      if (chosen && with_offset(id_of(block, 1), block.submodel.offset) != *chosen) {
        warn(messages, out);
      } else {
        out.append(messages);
      }
    } else if (word == "FRIC_ORIENT") {
      for (DeckOrientation& entry : read_orientation(block, deck, of_directions)) {
        contents.orientations.push_back(entry);
      }
    } else if (word == "GRPART" && block.words.size() > 2) {
      if (auto group = read_group(block, deck, out)) {
        if (!groups.insert(group->id).second) {
          out.error(deck.texts.name(block.keyword), deck.texts.position(block.keyword),
                    shortened(block.keyword, 40), "stands twice");
        }
        contents.groups.push_back(std::move(*group));
      }
    } else if (word == "PART") {
      if (const int id = id_of(block, 1); id > 0) {
        contents.parts.push_back(with_offset(id, block.submodel.part_offset));
      }
    } else if (word == "INTER" && block.words.size() > 1 && block.words[1].starts_with("TYPE")) {
      const DeckBlock type{{block.words[1].substr(4)}, {}, {}, {}, {}};
      if (const int number = id_of(type, 0); number > 0) {
        contents.interface_types.push_back(number);
      }
    } else if (word == "BEGIN") {
      judge_version(block, deck, out);
      take_units(block, contents);
    } else if (word == "UNIT") {
      take_local_units(block, contents);
    }
  }
  const bool directions_count = std::any_of(
      contents.frictions.begin(), contents.frictions.end(),
      [&](const DeckFriction& f) { return (!chosen || f.id == *chosen) && is_orthotropic(f); });
  if (directions_count) {
    out.append(of_directions);
  } else {
    warn(of_directions, out);
  }
  complete(contents);
  return contents;
}

const DeckGroup* find_group(const DeckContents& deck, int id) {
  const auto found =
      std::lower_bound(deck.groups.begin(), deck.groups.end(), id,
                       [](const DeckGroup& group, int wanted) { return group.id < wanted; });
  return found == deck.groups.end() || found->id != id ? nullptr : &*found;
}

bool is_empty(int law, const DeckCoefficients& set) {
  const auto& c = set.c;
  const auto none = [&](std::initializer_list<std::size_t> constants) {
    return std::all_of(constants.begin(), constants.end(),
                       [&](std::size_t i) { return c[i] == 0.0; });
  };
  switch (law) {
    case 1:
      return set.fric == 0.0 && none({0, 1, 2, 3, 4});
    case 2:
      return set.fric == 0.0 && none({0, 2, 4});
    case 3:
      return none({0, 1, 2, 3, 4, 5});
    case 4:
      return set.fric == 0.0 && none({0});
    default:
      return set.fric == 0.0;
  }
}

bool falls(const DeckCoefficients& set) {
  return set.fric >= set.c[0] && set.c[0] >= 0.0 && set.c[1] >= 0.0;
}

bool is_orthotropic(const DeckFriction& friction) {
  return std::any_of(friction.pairs.begin(), friction.pairs.end(),
                     [](const DeckPair& pair) { return pair.second.has_value(); });
}

std::vector<DeckOrientation> used_orientations(const DeckContents& deck,
                                               const DeckFriction& friction) {
  // What the orthotropic records join; `open` if that is more than the deck says.
  std::set<int> parts;
  std::set<int> groups;
  bool open = false;
  const auto listed = [&](int group) -> const std::vector<int>* {
    const DeckGroup* found = find_group(deck, group);
    return found == nullptr || found->parts.empty() ? nullptr : &found->parts;
  };
  for (const DeckPair& pair : friction.pairs) {
    if (!pair.second) continue;
    for (const DeckSide& side : pair.sides) {
      if (side.group == 0) {
        parts.insert(side.part);
      } else if (groups.insert(side.group).second) {
        const std::vector<int>* of_group = listed(side.group);
        open = open || of_group == nullptr;
        if (of_group != nullptr) parts.insert(of_group->begin(), of_group->end());
      }
    }
  }
  const auto joined = [&](int part) { return parts.count(part) > 0; };
  std::vector<DeckOrientation> used;
  std::copy_if(deck.orientations.begin(), deck.orientations.end(), std::back_inserter(used),
               [&](const DeckOrientation& entry) {
                 if (parts.empty() && groups.empty()) return false;
                 if (open) return true;
                 if (entry.of.group == 0) return joined(entry.of.part);
                 const std::vector<int>* of_group = listed(entry.of.group);
                 return of_group == nullptr ||
                        std::any_of(of_group->begin(), of_group->end(), joined);
               });
  return used;
}

std::optional<std::array<double, 3>> direction_in_plane(const DeckOrientation& entry,
                                                        const std::array<double, 3>& normal) {
  const auto dot = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const double along = dot(entry.vector, normal) / dot(normal, normal);
  std::array<double, 3> in_plane{};
  for (std::size_t i = 0; i < 3; ++i) in_plane[i] = entry.vector[i] - along * normal[i];
  const double length = std::sqrt(dot(in_plane, in_plane));
  // Nothing but the rounding of the projection is left of a parallel vector.
  if (!(length > 1e-10 * std::sqrt(dot(entry.vector, entry.vector)))) return std::nullopt;
  for (double& one : in_plane) one /= length;
  return in_plane;
}

bool sees_pressure(const DeckFriction& friction, const DeckCoefficients& set) {
  const auto& c = set.c;
  if (friction.law == 1) return c[0] != 0.0 || c[2] != 0.0 || c[3] != 0.0;
  return friction.law == 2 && (c[0] != 0.0 || c[2] != 0.0);
}

RenardFaults renard_faults(const DeckCoefficients& set) {
  RenardFaults faults;
  law::Renard law;
  std::tie(law.c1, law.c2, law.c3, law.c4, law.c5, law.c6) = std::tuple_cat(set.c);
  const auto held = law.rules_held();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const std::string_view rule = law::Renard::kRules[i];
    if (held[i]) continue;
    (i < law::Renard::kNeeded ? faults.fatal : faults.lenient)
        .emplace_back(rule.substr(0, rule.find(" must hold")));
  }
  return faults;
}

namespace {

/// The rules of one friction; messages name the line they are about.
class Judge {
 public:
  Judge(const DeckContents& deck, const DeckFriction& friction, const import::DeckTexts& texts,
        base::Diagnostics& out)
      : deck_(deck), friction_(friction), texts_(texts), out_(out) {}

  void all() {
    set(friction_.otherwise);
    for (const DeckPair& pair : friction_.pairs) {
      for (const DeckSide& side : pair.sides) known(side, pair);
      set(pair.first);
      if (pair.second) set(*pair.second);
      mixed(pair);
    }
    remarks();
  }

 private:
  void tell(base::Severity severity, std::string_view piece, std::string message,
            std::string hint = {}) {
    out_.add({severity, texts_.name(piece), texts_.position(piece), shortened(friction_.where, 40),
              std::move(message), std::move(hint)});
  }

  void set(const DeckCoefficients& s) {
    unused(s);
    if (is_empty(friction_.law, s)) return;
    switch (friction_.law) {
      case 0:
        if (s.fric < 0.0) {
          tell(base::Severity::kError, s.rest,
               "FRIC007: Fric must not be negative, found " + base::format_number(s.fric));
        }
        break;
      case 2:
        for (const std::size_t i : {1U, 3U, 5U}) {
          if (s.c[i] > 0.0 && s.c[i - 1] != 0.0) {
            tell(base::Severity::kWarning, i == 5 ? s.rest : s.where,
                 fmt::format("FRIC008: C{} is positive: exp(C{} V) grows with the speed and "
                             "overflows beyond V = {}",
                             i + 1, i + 1, base::format_number(700.0 / s.c[i])));
          }
        }
        break;
      case 3: {
        const RenardFaults faults = renard_faults(s);
        for (const std::string& rule : faults.fatal) {
          tell(base::Severity::kError, s.where, "FRIC004: Renard wants " + rule + renard(s));
        }
        for (const std::string& rule : faults.lenient) {
          tell(base::Severity::kWarning, s.where, "FRIC004: Renard wants " + rule + renard(s),
               "imported with 'rules: lenient'");
        }
        break;
      }
      default:
        break;
    }
    if (sees_pressure(friction_, s) && !area_told_) {
      area_told_ = true;
      tell(base::Severity::kWarning, s.where,
           "FRIC005: the coefficients see the pressure, and the area is missing: the solver "
           "divides by that of a contact segment",
           "give the parameter 'area' of the case");
    }
  }

  /// Constants of the second line that the law has no use for.
  void unused(const DeckCoefficients& s) {
    if (friction_.law == 1 && s.c[5] != 0.0) {
      tell(base::Severity::kWarning, s.rest,
           "C6 is not used by Ifric 1, found " + base::format_number(s.c[5]));
    }
    if (friction_.law == 3 && s.fric != 0.0) {
      tell(base::Severity::kWarning, s.rest,
           "Fric is not used by Ifric 3, found " + base::format_number(s.fric));
    }
  }

  static std::string renard(const DeckCoefficients& s) {
    std::string text;
    for (std::size_t i = 0; i < s.c.size(); ++i) {
      text +=
          fmt::format("{}C{} {}", i == 0 ? " (found " : ", ", i + 1, base::format_number(s.c[i]));
    }
    return text + ")";
  }

  void known(const DeckSide& side, const DeckPair& pair) {
    const std::string_view line = pair.where;
    if (side.group > 0) {
      if (!told_groups_.insert(side.group).second) return;
      const DeckGroup* group = find_group(deck_, side.group);
      if (group != nullptr && !group->not_there.empty()) {
        tell(base::Severity::kWarning, line,
             fmt::format("FRIC003: the deck has no part {}, which group {} lists",
                         some(group->not_there), side.group),
             "it is left out of the group");
      }
      if (group != nullptr && !group->parts.empty()) return;
      tell(base::Severity::kWarning, line,
           fmt::format("the deck does not list the parts of group {}", side.group),
           fmt::format("list them under 'G{}' of the case", side.group));
      return;
    }
    if (has_all_parts(deck_) &&
        !std::binary_search(deck_.parts.begin(), deck_.parts.end(), side.part)) {
      tell(base::Severity::kError, line,
           fmt::format("FRIC003: the deck has no part {}", side.part));
    }
  }

  /// The first few of some ids.
  static std::string some(const std::vector<int>& ids) {
    constexpr std::size_t kMost = 10;
    std::string text;
    for (std::size_t i = 0; i < std::min(ids.size(), kMost); ++i) {
      text += (i == 0 ? "" : ", ") + std::to_string(ids[i]);
    }
    if (ids.size() > kMost) text += fmt::format(" and {} more", ids.size() - kMost);
    return text;
  }

  void mixed(const DeckPair& pair) {
    if ((pair.sides[0].group > 0) != (pair.sides[1].group > 0)) {
      tell(base::Severity::kWarning, pair.where,
           "the record joins a part and a group: OpenRadioss may use other coefficients");
    }
    if (pair.second && friction_.law > 0) {
      tell(
          base::Severity::kWarning, pair.where,
          fmt::format("an orthotropic record with Ifric {}: OpenRadioss may use other coefficients",
                      friction_.law));
    }
  }

  /// Adds remarks on what interfaces make of a friction that they refer to.
  void remarks() {
    const bool orthotropic = is_orthotropic(friction_);
    for (const int type : deck_.interface_types) {
      const bool incremental = type == 21 || type == 24 || type == 25;
      if (incremental && friction_.formulation == 1) {
        tell(base::Severity::kNote, friction_.where,
             fmt::format("an interface of TYPE{} always uses the stiffness penalty (Iform 2)",
                         type));
      }
      if (type == 11) {
        tell(base::Severity::kNote, friction_.where, "an interface of TYPE11 uses only Fric");
      }
      if (orthotropic && type != 7 && type != 24 && type != 25) {
        tell(base::Severity::kNote, friction_.where,
             fmt::format("an interface of TYPE{} has no orthotropic friction", type));
      }
    }
  }

  const DeckContents& deck_;
  const DeckFriction& friction_;
  const import::DeckTexts& texts_;
  base::Diagnostics& out_;
  std::set<int> told_groups_;
  bool area_told_ = false;
};

}  // namespace

void judge(const DeckContents& deck, const DeckFriction& friction, const import::DeckTexts& texts,
           base::Diagnostics& out) {
  Judge(deck, friction, texts, out).all();
}

}  // namespace slipbench::driver::radioss
