// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/export/coefficient_grid.hpp"
#include "driver/export/contact/contact_block.hpp"
#include "driver/export/deck_text.hpp"
#include "driver/export/number_writer.hpp"

namespace slipbench::driver::exports {
namespace {

class LsDynaText {
 public:
  /// \param width of a field: 10 columns, or 20 in long format
  LsDynaText(const FrictionStatement& statement, const ExportOptions& options, int width)
      : statement_(statement),
        behavior_only_(options.behavior_only),
        width_(width),
        number_(static_cast<std::size_t>(width) - 1, options.digits),
        point_(19, options.digits) {}

  std::string write() {
    if (!behavior_only_) text_ = "*KEYWORD\n";
    const base::UnitSystem& units = statement_.units;
    text_ += "$ " + base::printable(statement_.title) +
             (units.length.empty()
                  ? std::string()
                  : fmt::format(" ({}, {}, {})", units.length, units.force, units.time)) +
             "\n";
    if (!statement_.pairs.empty()) {
      pairs();
    } else if (const auto transition = transition_of(statement_.otherwise.law)) {
      contact(numbers(statement_.otherwise, *transition));
      note(Loss::Kind::kKept, "coefficient: FS, FD and DC of the contact");
    } else {
      table();
    }
    if (!behavior_only_) text_ += "*END\n";
    tell();
    tell_rounding(number_.rounded() + point_.rounded(), std::max(number_.worst(), point_.worst()),
                  losses_);
    return std::move(text_);
  }

  bool is_short_of_room() const { return number_.rounded() > 0; }
  std::vector<Loss>& losses() { return losses_; }

 private:
  void note(Loss::Kind kind, std::string what) { losses_.push_back({kind, std::move(what)}); }

  void keyword(std::string_view name) {
    text_ += fmt::format("*{}{}\n", name, width_ > 10 ? " +" : "");
  }
  void card(const std::vector<std::string>& fields) {
    for (const std::string& field : fields) text_ += fmt::format("{:>{}}", field, width_);
    text_ += "\n";
  }

  /// FS, FD, DC and VC.
  std::vector<std::string> numbers(const StatedFriction& friction, const Transition& transition) {
    double vc = 0.0;
    if (friction.force_limit < law::kNoForceLimit) {
      limited_ = true;
      vc = friction.force_limit / (statement_.area > 0.0 ? statement_.area : 1.0);
    }
    return {number_(transition.at_rest), number_(transition.fast), number_(transition.decay),
            number_(vc)};
  }

  void contact(const std::vector<std::string>& friction) {
    text_ += "$ give it the two surfaces, or take its second card over into your contact\n";
    keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID");
    text_ += fmt::format("{:>{}}{}\n", 1, width_, "slipbench");
    text_ += "$ surfa, surfb and their types\n";
    card({"0", "0", "0", "0"});
    text_ += "$ FS, FD, DC, VC\n";
    card(friction);
    card({"0"});
  }

  void pairs() {
    keyword("DEFINE_FRICTION");
    const auto set = [&](const StatedFriction& one) {
      const auto transition = transition_of(one.law);
      if (!transition || one.second) {
        throw NotExported{
            "*DEFINE_FRICTION has constant coefficients and exponential decays for its pairs, in "
            "one direction"};
      }
      return numbers(one, *transition);
    };
    std::vector<std::string> fields{"1"};
    for (std::string& one : set(statement_.otherwise)) fields.push_back(std::move(one));
    card(fields);
    for (const StatedPair& pair : statement_.pairs) {
      fields.clear();
      for (const auto& side : pair.sides) {
        fields.push_back(std::to_string(statement_.id_of(side)));
      }
      for (std::string& one : set(pair.friction)) fields.push_back(std::move(one));
      for (const auto& side : pair.sides) {
        fields.emplace_back(std::holds_alternative<int>(side.value) ? "" : "PSET");
      }
      card(fields);
    }
    for (const StatedGroup& group : statement_.groups) {
      keyword("SET_PART_LIST_TITLE");
      text_ += title_line(group.name) + "\n";
      card({std::to_string(group.id)});
      constexpr std::size_t kInLine = 8;
      for (std::size_t i = 0; i < group.parts.size(); i += kInLine) {
        std::vector<std::string> ids;
        for (std::size_t k = i; k < std::min(i + kInLine, group.parts.size()); ++k) {
          ids.push_back(std::to_string(group.parts[k]));
        }
        card(ids);
      }
    }
    contact({"-2", "1"});
    note(Loss::Kind::kKept, "coefficients: FS, FD and DC of *DEFINE_FRICTION, which FS -2 names");
  }

  void table() {
    const CoefficientGrid grid = tabulate(statement_.otherwise.law, statement_.run);
    const double area = statement_.area > 0.0 ? statement_.area : 1.0;
    std::vector<double> pressures;
    for (const double force : grid.forces) pressures.push_back(force / area);
    std::size_t curves = pressures.size();
    // A table has two pressures at least.
    if (curves == 1) pressures.push_back(pressures[0] > 0.0 ? 2.0 * pressures[0] : 1.0);
    text_ += "*DEFINE_TABLE\n         1\n";
    for (const double pressure : pressures) text_ += fmt::format("{:>20}\n", point_(pressure));
    for (std::size_t j = 0; j < pressures.size(); ++j) {
      text_ += fmt::format("*DEFINE_CURVE\n{:>10}\n", 1001 + j);
      const std::vector<double>& mu = grid.mu[std::min(j, curves - 1)];
      for (std::size_t i = 0; i < grid.rates.size(); ++i) {
        text_ += fmt::format("{:>20}{:>20}\n", point_(grid.rates[i]), point_(mu[i]));
      }
      // One point is no curve.
      if (grid.rates.size() == 1) text_ += fmt::format("{:>20}{:>20}\n", "1", point_(mu[0]));
    }
    std::vector<std::string> second{"2", "1", "0"};
    second.push_back(numbers(statement_.otherwise, {}).back());
    contact(second);
    note(Loss::Kind::kApproximated,
         fmt::format("coefficient: a table over pressure and velocity (FS 2) of {} points, off by "
                     "at most {:.1e}",
                     grid.rates.size() * grid.forces.size(), grid.error));
    if (law::depends_on_contact_force(statement_.otherwise.law) && statement_.area <= 0.0) {
      note(Loss::Kind::kApproximated,
           "pressures: the case has no area, and 1 is taken: divide those of the table by it");
    }
  }

  void tell() {
    if (limited_) {
      note(Loss::Kind::kApproximated,
           statement_.area > 0.0
               ? "force_limit: VC times the area of each segment, in place of the whole area"
               : "force_limit: the case has no area, and 1 is taken: divide VC by it");
      note(Loss::Kind::kKept,
           "VC; OpenRadioss's converter of such decks makes VISF of it, which Iform 2 ignores");
    }
    note(Loss::Kind::kApproximated, "stick: the penalty stiffness of the contact");
    if (statement_.formulation) {
      if (std::holds_alternative<law::ViscousPenalty>(statement_.formulation->penalty)) {
        note(Loss::Kind::kDropped, "viscous penalty: LS-DYNA sticks");
      }
      if (statement_.formulation->filter.kind != law::Filter::Kind::kNone) {
        note(Loss::Kind::kDropped, "filter: LS-DYNA has none");
      }
    }
  }

  const FrictionStatement& statement_;
  bool behavior_only_;
  int width_;
  NumberWriter number_, point_;
  std::vector<Loss> losses_;
  std::string text_;
  bool limited_ = false;
};

}  // namespace

std::string to_lsdyna(const FrictionStatement& statement, const ExportOptions& options,
                      ExportedDeck& deck) {
  LsDynaText narrow(statement, options, 10);
  LsDynaText wide(statement, options, 20);
  std::string text = narrow.write();
  const bool long_format = options.digits == 0 && narrow.is_short_of_room();
  if (long_format) text = wide.write();
  for (Loss& one : (long_format ? wide : narrow).losses()) deck.losses.push_back(std::move(one));
  return text;
}

}  // namespace slipbench::driver::exports
