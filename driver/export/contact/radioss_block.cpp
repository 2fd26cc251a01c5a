// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/export/contact/contact_block.hpp"
#include "driver/export/deck_text.hpp"
#include "driver/export/number_writer.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::exports {
namespace {

/// Fric and C1 .. C6 of an Ifric.
struct Constants {
  int law = 0;
  double fric = 0.0;
  std::array<double, 6> c{};
};

Constants constants_of(const law::FrictionLaw& law) {
  if (const auto* const one = law::get_law_if<law::GeneralizedViscous>(law)) {
    return {1, one->fric, {one->c1, one->c2, one->c3, one->c4, one->c5, one->c6}};
  }
  if (const auto* const one = law::get_law_if<law::ModifiedDarmstad>(law)) {
    return {2, one->fric, {one->c1, one->c2, one->c3, one->c4, one->c5, one->c6}};
  }
  if (const auto* const one = law::get_law_if<law::Renard>(law)) {
    if (one->speed_factor != 1.0) {
      throw NotExported{"its Renard constants are of another unit of speed than the case"};
    }
    return {3, 0.0, {one->c1, one->c2, one->c3, one->c4, one->c5, one->c6}};
  }
  const auto transition = transition_of(law);
  if (!transition) {
    throw NotExported{fmt::format(
        "Radioss has no coefficient {}: calibrate one of its laws to it, or write a table of it "
        "with --to table",
        law::name_of(law))};
  }
  if (transition->at_rest == transition->fast) return {0, transition->fast, {}};
  return {4, transition->at_rest, {transition->fast, transition->decay}};
}

/// Writes a constant or a decay as a special case of the Ifric of a table.
Constants as(int law, Constants constants) {
  if (constants.law == law) return constants;
  const double mu = constants.fric;
  if (constants.law == 0) {
    if (law == 3) return {3, 0.0, {mu, mu, mu, mu, 1.0, 2.0}};
    if (law == 4) return {4, mu, {mu}};
    return {law, mu, {}};
  }
  if (constants.law == 4 && law == 2) {
    return {2, constants.c[0], {0.0, 0.0, 0.0, 0.0, mu - constants.c[0], -constants.c[1]}};
  }
  throw NotExported{"its table of part pairs has several laws, and Radioss one Ifric for all"};
}

class RadiossText {
 public:
  RadiossText(const FrictionStatement& statement, const ExportOptions& options, ExportedDeck& deck)
      : statement_(statement), options_(options), deck_(deck), number_(20, options.digits) {}

  std::string write() {
    find_law();
    std::string text;
    if (!options_.behavior_only) begin(text);
    const base::UnitSystem& units = statement_.units;
    if (!units.length.empty()) {
      line(text, fmt::format("# in {}, {}, {}", units.length, units.force, units.time));
    }
    line(text, "/FRICTION/1");
    line(text, base::printable(title_line(statement_.title).substr(0, 100)));
    line(text, "#    Ifric   Ifiltr               Xfreq     Iform");
    const auto [kind, xfreq] = filter();
    line(text,
         fmt::format("{:>10}{:>10}{:>20}{:>10}", law_, kind, number_(xfreq), viscous() ? 1 : 2));
    set(text, statement_.otherwise, statement_.otherwise.law);
    for (const StatedPair& pair : statement_.pairs) record(text, pair);
    for (const StatedGroup& group : statement_.groups) parts(text, group);
    if (!options_.behavior_only) line(text, "/END");
    tell();
    tell_rounding(number_.rounded(), number_.worst(), deck_.losses);
    return text;
  }

 private:
  static void line(std::string& text, const std::string& content) { text += content + "\n"; }
  void note(Loss::Kind kind, std::string what) { deck_.losses.push_back({kind, std::move(what)}); }
  bool viscous() const {
    return statement_.formulation &&
           std::holds_alternative<law::ViscousPenalty>(statement_.formulation->penalty);
  }

  template <class Visit>
  void each(Visit visit) const {
    visit(statement_.otherwise);
    for (const StatedPair& pair : statement_.pairs) visit(pair.friction);
  }

  void find_law() {
    each([&](const StatedFriction& one) {
      for (const law::FrictionLaw* const law : {&one.law, one.second ? &*one.second : nullptr}) {
        if (law == nullptr) continue;
        const int own = constants_of(*law).law;
        const bool wins = own == 4 ? law_ == 0 : own > 0;
        if (wins) law_ = own;
      }
    });
  }

  void begin(std::string& text) {
    line(text, "#RADIOSS STARTER");
    line(text, "/BEGIN");
    line(text, "slipbench");
    line(text, fmt::format("{:>10}{:>10}", 2022, 0));
    const base::UnitSystem& units = statement_.units;
    // The mass of which the force is made, with the length and the time.
    constexpr std::array<std::array<std::string_view, 4>, 6> kMasses{{{"m", "N", "s", "kg"},
                                                                      {"mm", "N", "s", "Mg"},
                                                                      {"mm", "kN", "ms", "kg"},
                                                                      {"mm", "N", "ms", "g"},
                                                                      {"m", "kN", "s", "Mg"},
                                                                      {"mm", "mN", "s", "kg"}}};
    for (const auto& [length, force, time, mass] : kMasses) {
      if (units.length != length || units.force != force || units.time != time) continue;
      for (int i = 0; i < 2; ++i) {
        line(text, fmt::format("{:>20}{:>20}{:>20}", mass, length, time));
      }
    }
  }

  std::pair<int, double> filter() {
    if (!statement_.formulation) return {0, 0.0};
    const law::Filter& filter = statement_.formulation->filter;
    switch (filter.kind) {
      case law::Filter::Kind::kSimple:
        return {1, filter.value};
      case law::Filter::Kind::kPeriod:
        if (statement_.run.duration == 0.0) return {0, 0.0};
        note(Loss::Kind::kApproximated,
             fmt::format("filter: Xfreq counts increments, of {} as the first one of the case",
                         base::format_number(statement_.run.duration)));
        return {2, filter.value / statement_.run.duration};
      case law::Filter::Kind::kFrequency:
        return {3, filter.value};
      default:
        return {0, 0.0};
    }
  }

  double visf(const StatedFriction& one) const {
    if (!viscous()) return 0.0;
    return one.visf != 0.0 ? one.visf
                           : std::get<law::ViscousPenalty>(statement_.formulation->penalty).visf;
  }

  void set(std::string& text, const StatedFriction& friction, const law::FrictionLaw& law) {
    const Constants one = as(law_, constants_of(law));
    line(text,
         "#                 C1                  C2                  C3                  C4"
         "                  C5");
    std::string first;
    for (std::size_t i = 0; i < 5; ++i) first += fmt::format("{:>20}", number_(one.c[i]));
    line(text, first);
    line(text, "#                 C6                Fric                VISF");
    line(text, fmt::format("{:>20}{:>20}{:>20}", number_(one.c[5]), number_(one.fric),
                           number_(visf(friction))));
  }

  void record(std::string& text, const StatedPair& pair) {
    line(text, "#  grpart1   grpart2     part1     part2                Idir");
    std::array<std::string, 4> columns{"0", "0", "0", "0"};
    for (std::size_t side = 0; side < 2; ++side) {
      const bool part = std::holds_alternative<int>(pair.sides[side].value);
      columns[side + (part ? 2U : 0U)] = std::to_string(statement_.id_of(pair.sides[side]));
    }
    line(text, fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}", columns[0], columns[1],
                           columns[2], columns[3], "", pair.friction.second ? 1 : 0));
    set(text, pair.friction, pair.friction.law);
    if (pair.friction.second) set(text, pair.friction, *pair.friction.second);
  }

  static void parts(std::string& text, const StatedGroup& group) {
    constexpr std::size_t kInLine = 10;
    line(text, fmt::format("/GRPART/PART/{}", group.id));
    line(text, title_line(group.name));
    for (std::size_t i = 0; i < group.parts.size(); i += kInLine) {
      std::string ids;
      for (std::size_t k = i; k < std::min(i + kInLine, group.parts.size()); ++k) {
        ids += fmt::format("{:>10}", group.parts[k]);
      }
      line(text, ids);
    }
  }

  void tell() {
    constexpr std::array kNames{"constant", "generalised viscous", "modified Darmstad", "Renard",
                                "exponential decay"};
    note(Loss::Kind::kKept,
         fmt::format("coefficient: {} (Ifric {})", kNames[static_cast<std::size_t>(law_)], law_));
    if (statement_.otherwise.second) {
      throw NotExported{"a /FRICTION has two coefficients in records of part pairs only"};
    }
    bool limited = false;
    each([&](const StatedFriction& one) {
      limited = limited || one.force_limit < law::kNoForceLimit;
    });
    if (limited) note(Loss::Kind::kDropped, "force_limit: /FRICTION has none");
    if (!statement_.formulation) {
      note(Loss::Kind::kApproximated,
           "stick: the interface's own stiffness, with Iform 2, in place of the stick stiffness");
    } else if (!viscous()) {
      note(Loss::Kind::kApproximated, "K_t: the interface finds it from its own stiffness");
    } else {
      note(Loss::Kind::kApproximated, "K and m: the interface finds them from the mesh");
      tell_damping();
    }
    if (law_ == 4) {
      note(Loss::Kind::kKept,
           "Ifric 4 is OpenRadioss's; the same decay as Ifric 2 is Fric = kinetic, C5 = static - "
           "kinetic, C6 = -decay");
    }
    if (law_ == 3) {
      note(Loss::Kind::kKept, "the constants of Renard hide the unit of speed of the case");
    }
  }

  /// Tells where the program takes another damping from VISF than its page says.
  void tell_damping() {
    double other = 1.0;
    each([&](const StatedFriction& one) { other = visf(one) != 1.0 ? visf(one) : other; });
    if (other == 1.0) return;
    const std::string number = base::format_number(other);
    if (statement_.formulation->convention == law::Convention::kAsCoded) {
      note(Loss::Kind::kKept,
           fmt::format("VISF {}: C = sqrt(VISF) sqrt(2 K m), as the program computes it; it is the "
                       "square of an interface's own",
                       number));
    } else {
      note(Loss::Kind::kApproximated,
           fmt::format("VISF {}: C = VISF sqrt(2 K m) as its page has it; the program takes "
                       "sqrt(VISF), and has this damping with VISF {}",
                       number, base::format_number(other * other)));
    }
  }

  const FrictionStatement& statement_;
  const ExportOptions& options_;
  ExportedDeck& deck_;
  NumberWriter number_;
  int law_ = 0;
};

}  // namespace

std::string to_radioss(const FrictionStatement& statement, const ExportOptions& options,
                       ExportedDeck& deck) {
  return RadiossText(statement, options, deck).write();
}

}  // namespace slipbench::driver::exports
