// SPDX-License-Identifier: Apache-2.0
#include "driver/radioss/deck_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "driver/radioss/deck_line.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {
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
  return printable(line);
}

/// Walks through the lines of a block; the first fault ends it.
class BlockReader {
 public:
  BlockReader(const DeckBlock& block, const SourceText& source, Diagnostics& out)
      : block_(block), source_(source), out_(out), path_(block.keyword) {
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
    auto read = read_numbers(line, fields, least_free);
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
  /// Where field i of the line read last stands.
  [[nodiscard]] std::string_view text(std::size_t i) const { return texts_[i]; }

  void error(std::string_view piece, std::string message, std::string hint = {}) {
    sound_ = false;
    out_.error(source_.name(), position_of(source_, piece), path_, std::move(message),
               std::move(hint));
  }
  void warning(std::string_view piece, std::string message, std::string hint = {}) {
    out_.warning(source_.name(), position_of(source_, piece), path_, std::move(message),
                 std::move(hint));
  }
  [[nodiscard]] int line_of(std::string_view piece) const {
    return position_of(source_, piece).line;
  }

 private:
  const DeckBlock& block_;
  const SourceText& source_;
  Diagnostics& out_;
  std::string path_;
  std::size_t next_ = 0;
  std::vector<std::string_view> texts_;
  bool sound_ = true;
};

DeckCoefficients read_set(BlockReader& reader, std::string_view which) {
  DeckCoefficients set;
  set.where = reader.upcoming();
  const auto first = reader.numbers(kFirstFive, "C1 .. C5" + std::string(which));
  const auto last = reader.numbers(kLastThree, "C6, Fric, VISF" + std::string(which));
  std::copy(first.begin(), first.end(), set.c.begin());
  set.c[5] = last[0];
  set.fric = last[1];
  set.visf = last[2];
  if (set.visf < 0.0) {
    reader.error(reader.text(2),
                 "FRIC007: VISF must not be negative, found " + format_number(set.visf));
  }
  return set;
}

DeckPair read_pair(BlockReader& reader) {
  DeckPair pair;
  const std::string_view line = reader.upcoming();
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
                                             friction.filter, rule, format_number(x)));
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

std::optional<DeckFriction> read_friction(const DeckBlock& block, const SourceText& source,
                                          Diagnostics& out) {
  BlockReader reader(block, source, out);
  DeckFriction friction;
  friction.where = block.keyword;
  friction.id = id_of(block, 1);
  friction.unit_id = id_of(block, 2);
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
  return friction;
}

std::vector<DeckOrientation> read_orientation(const DeckBlock& block, const SourceText& source,
                                              Diagnostics& out) {
  BlockReader reader(block, source, out);
  std::vector<DeckOrientation> entries;
  reader.skip_title();
  while (reader.sound() && !reader.at_end()) {
    DeckOrientation entry;
    entry.line = reader.line_of(reader.upcoming());
    const auto of = reader.numbers(kOriented, "grpart_ID, part_ID");
    const auto direction = reader.numbers(kDirection, "Vx, Vy, Vz, skew_ID, phi, Iorth");
    entry.of = {static_cast<int>(of[0]), static_cast<int>(of[1])};
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
std::optional<DeckGroup> read_group(const DeckBlock& block, const SourceText& source,
                                    Diagnostics& out) {
  DeckGroup group{id_of(block, 2), title_of(block), {}};
  if (group.id == 0) return std::nullopt;
  if (block.words[1] != "PART") return group;
  for (std::size_t i = 1; i < block.lines.size(); ++i) {
    auto read = read_numbers(block.lines[i], kTenParts, 0);
    if (!read) {
      out.warning(source.name(), position_of(source, block.lines[i]), std::string(block.keyword),
                  "its parts cannot be read: " + read.error().message);
      group.parts.clear();
      return group;
    }
    for (const double part : read->values) {
      const int id = static_cast<int>(part);
      // A negative id takes a part out of a set that other lines have put in.
      if (id < 0) std::erase(group.parts, -id);
      if (id > 0) group.parts.push_back(id);
    }
  }
  std::sort(group.parts.begin(), group.parts.end());
  group.parts.erase(std::unique(group.parts.begin(), group.parts.end()), group.parts.end());
  return group;
}

std::string common_unit(std::string_view unit) {
  // The program's own spelling of two units.
  if (unit == "mus") return "us";
  if (unit == "ton" || unit == "t") return "Mg";
  return std::string(unit);
}

/// What a unit is in SI, as far as decks of practice go; 0: not known.
double in_si(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 13> kKnown{{{"kg", 1.0},
                                                                        {"g", 1e-3},
                                                                        {"mg", 1e-6},
                                                                        {"Mg", 1e3},
                                                                        {"m", 1.0},
                                                                        {"cm", 1e-2},
                                                                        {"mm", 1e-3},
                                                                        {"um", 1e-6},
                                                                        {"km", 1e3},
                                                                        {"s", 1.0},
                                                                        {"ms", 1e-3},
                                                                        {"us", 1e-6},
                                                                        {"ns", 1e-9}}};
  for (const auto& [name, factor] : kKnown) {
    if (name == unit) return factor;
  }
  return 0.0;
}

/// The system of units of /BEGIN: run name, version, units of the input (mass, length, time), units
/// of the work. The force is the one consistent with them.
std::optional<UnitSystem> units_of(const DeckBlock& block) {
  if (block.lines.size() < 3) return std::nullopt;
  std::array<std::string, 3> words;
  std::string_view line = block.lines[2];
  for (std::string& word : words) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const std::size_t end = std::min(line.find(' '), line.size());
    word = common_unit(line.substr(0, end));
    line.remove_prefix(end);
  }
  const double mass = in_si(words[0]);
  const double length = in_si(words[1]);
  const double time = in_si(words[2]);
  if (mass == 0.0 || length == 0.0 || time == 0.0) return std::nullopt;
  const double newtons = mass * length / (time * time);
  constexpr std::array<std::pair<std::string_view, double>, 6> kForces{
      {{"N", 1.0}, {"kN", 1e3}, {"MN", 1e6}, {"GN", 1e9}, {"mN", 1e-3}, {"uN", 1e-6}}};
  for (const auto& [name, factor] : kForces) {
    if (std::abs(newtons / factor - 1.0) < 1e-9) {
      return UnitSystem{words[1], std::string(name), words[2], {}};
    }
  }
  return std::nullopt;
}

void sort_unique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

DeckContents read_contents(const StarterDeck& deck, Diagnostics& out) {
  DeckContents contents;
  contents.has_includes = deck.has_includes;
  for (const DeckBlock& block : deck.blocks) {
    const std::string& word = block.words.front();
    if (word == "FRICTION") {
      auto friction = read_friction(block, deck.source, out);
      if (!friction) continue;
      const auto same = std::find_if(contents.frictions.begin(), contents.frictions.end(),
                                     [&](const DeckFriction& f) { return f.id == friction->id; });
      if (same != contents.frictions.end()) {
        out.error(deck.source.name(), position_of(deck.source, block.keyword),
                  std::string(block.keyword),
                  fmt::format("stands twice, first in line {}",
                              position_of(deck.source, same->where).line));
      }
      contents.frictions.push_back(std::move(*friction));
    } else if (word == "FRIC_ORIENT") {
      for (DeckOrientation& entry : read_orientation(block, deck.source, out)) {
        contents.orientations.push_back(entry);
      }
    } else if (word == "GRPART" && block.words.size() > 2) {
      if (auto group = read_group(block, deck.source, out)) {
        contents.groups.push_back(std::move(*group));
      }
    } else if (word == "PART") {
      if (const int id = id_of(block, 1); id > 0) contents.parts.push_back(id);
    } else if (word == "INTER" && block.words.size() > 1 && block.words[1].starts_with("TYPE")) {
      const DeckBlock type{{block.words[1].substr(4)}, {}, {}, {}};
      if (const int number = id_of(type, 0); number > 0) {
        contents.interface_types.push_back(number);
      }
    } else if (word == "BEGIN") {
      contents.units = units_of(block);
    }
  }
  sort_unique(contents.parts);
  sort_unique(contents.interface_types);
  return contents;
}

const DeckGroup* find_group(const DeckContents& deck, int id) {
  const auto found = std::find_if(deck.groups.begin(), deck.groups.end(),
                                  [id](const DeckGroup& group) { return group.id == id; });
  return found == deck.groups.end() ? nullptr : &*found;
}

bool is_empty(const DeckCoefficients& set) {
  return set.fric == 0.0 &&
         std::all_of(set.c.begin(), set.c.end(), [](double c) { return c == 0.0; });
}

bool is_orthotropic(const DeckFriction& friction) {
  return std::any_of(friction.pairs.begin(), friction.pairs.end(),
                     [](const DeckPair& pair) { return pair.second.has_value(); });
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
  const auto& [c1, c2, c3, c4, c5, c6] = set.c;
  if (!(c5 > 0.0)) faults.fatal.emplace_back("C5 > 0");
  if (!(c5 < c6)) faults.fatal.emplace_back("C5 < C6");
  if (!(c4 <= c2)) faults.fatal.emplace_back("C4 <= C2");
  if (!(c1 <= c3)) faults.lenient.emplace_back("C1 <= C3");
  if (!(c2 <= c3)) faults.lenient.emplace_back("C2 <= C3");
  if (!(c4 <= c1)) faults.lenient.emplace_back("C4 <= C1");
  for (std::size_t i = 0; i < 4; ++i) {
    if (set.c[i] < 0.0) faults.lenient.push_back("C" + std::to_string(i + 1) + " >= 0");
  }
  return faults;
}

namespace {

/// The rules of one friction; messages name the line they are about.
class Judge {
 public:
  Judge(const DeckContents& deck, const DeckFriction& friction, const SourceText& source,
        Diagnostics& out)
      : deck_(deck), friction_(friction), source_(source), out_(out) {}

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
  void tell(Severity severity, std::string_view piece, std::string message, std::string hint = {}) {
    out_.add({severity, source_.name(), position_of(source_, piece), std::string(friction_.where),
              std::move(message), std::move(hint)});
  }

  void set(const DeckCoefficients& s) {
    if (is_empty(s)) return;
    switch (friction_.law) {
      case 0:
        if (s.fric < 0.0) {
          tell(Severity::kError, s.where,
               "FRIC007: Fric must not be negative, found " + format_number(s.fric));
        }
        break;
      case 1:
        if (s.c[5] != 0.0) {
          tell(Severity::kWarning, s.where,
               "C6 is not used by Ifric 1, found " + format_number(s.c[5]));
        }
        break;
      case 2:
        for (const std::size_t i : {1U, 3U, 5U}) {
          if (s.c[i] > 0.0 && s.c[i - 1] != 0.0) {
            tell(Severity::kWarning, s.where,
                 fmt::format("FRIC008: C{} is positive: exp(C{} V) grows with the speed and "
                             "overflows beyond V = {}",
                             i + 1, i + 1, format_number(700.0 / s.c[i])));
          }
        }
        break;
      case 3: {
        const RenardFaults faults = renard_faults(s);
        for (const std::string& rule : faults.fatal) {
          tell(Severity::kError, s.where, "FRIC004: Renard wants " + rule + renard(s));
        }
        for (const std::string& rule : faults.lenient) {
          tell(Severity::kWarning, s.where, "FRIC004: Renard wants " + rule + renard(s),
               "imported with 'rules: lenient'");
        }
        break;
      }
      default:
        break;
    }
    if (sees_pressure(friction_, s) && !area_told_) {
      area_told_ = true;
      tell(Severity::kWarning, s.where,
           "FRIC005: the coefficients see the pressure, and the area is missing: the solver "
           "divides by that of a contact segment",
           "give the parameter 'area' of the case");
    }
  }

  static std::string renard(const DeckCoefficients& s) {
    std::string text;
    for (std::size_t i = 0; i < s.c.size(); ++i) {
      text += fmt::format("{}C{} {}", i == 0 ? " (found " : ", ", i + 1, format_number(s.c[i]));
    }
    return text + ")";
  }

  void known(const DeckSide& side, const DeckPair& pair) {
    const std::string_view line = source_.line(pair.line);
    if (side.group > 0) {
      const DeckGroup* group = find_group(deck_, side.group);
      if (group != nullptr && !group->parts.empty()) return;
      if (std::find(told_groups_.begin(), told_groups_.end(), side.group) != told_groups_.end()) {
        return;
      }
      told_groups_.push_back(side.group);
      tell(Severity::kWarning, line,
           fmt::format("the deck does not list the parts of group {}", side.group),
           fmt::format("list them under 'G{}' of the case", side.group));
      return;
    }
    const bool judged = !deck_.parts.empty() && !deck_.has_includes;
    if (judged && !std::binary_search(deck_.parts.begin(), deck_.parts.end(), side.part)) {
      tell(Severity::kError, line, fmt::format("FRIC003: the deck has no part {}", side.part));
    }
  }

  void mixed(const DeckPair& pair) {
    if ((pair.sides[0].group > 0) != (pair.sides[1].group > 0)) {
      tell(Severity::kWarning, source_.line(pair.line),
           "the record joins a part and a group: OpenRadioss may use other coefficients");
    }
    if (pair.second && friction_.law > 0) {
      tell(
          Severity::kWarning, source_.line(pair.line),
          fmt::format("an orthotropic record with Ifric {}: OpenRadioss may use other coefficients",
                      friction_.law));
    }
  }

  /// What interfaces make of a friction that they refer to.
  void remarks() {
    const bool orthotropic = is_orthotropic(friction_);
    for (const int type : deck_.interface_types) {
      const bool incremental = type == 21 || type == 24 || type == 25;
      if (incremental && friction_.formulation == 1) {
        tell(Severity::kNote, friction_.where,
             fmt::format("an interface of TYPE{} always uses the stiffness penalty (Iform 2)",
                         type));
      }
      if (type == 11) {
        tell(Severity::kNote, friction_.where, "an interface of TYPE11 uses only Fric");
      }
      if (orthotropic && type != 7 && type != 24 && type != 25) {
        tell(Severity::kNote, friction_.where,
             fmt::format("an interface of TYPE{} has no orthotropic friction", type));
      }
    }
  }

  const DeckContents& deck_;
  const DeckFriction& friction_;
  const SourceText& source_;
  Diagnostics& out_;
  std::vector<int> told_groups_;
  bool area_told_ = false;
};

}  // namespace

void judge(const DeckContents& deck, const DeckFriction& friction, const SourceText& source,
           Diagnostics& out) {
  Judge(deck, friction, source, out).all();
}

}  // namespace slipbench::driver
