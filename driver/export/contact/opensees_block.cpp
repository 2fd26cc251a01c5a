// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/export/coefficient_grid.hpp"
#include "driver/export/contact/contact_block.hpp"
#include "driver/export/number_writer.hpp"

namespace slipbench::driver::exports {
namespace {

/// The spring of stick, as kInit: a stiffness as it is, an elastic slip at the largest limit met.
double stick_stiffness(const FrictionStatement& statement) {
  if (statement.formulation) {
    const auto* const spring = std::get_if<law::StiffnessPenalty>(&statement.formulation->penalty);
    if (spring != nullptr) return spring->stiffness;
  }
  if (statement.stick.mode == law::StickStiffness::Mode::kStiffness) return statement.stick.value;
  law::SlipArguments slip;
  slip.contact_force = statement.run.contact_force;
  const double limit = law::evaluate(statement.otherwise.law, statement.run.ambient(), slip).mu *
                       statement.run.contact_force;
  return limit > 0.0 ? limit / statement.stick.value : 1.0;
}

}  // namespace

std::string to_opensees(const FrictionStatement& statement, const ExportOptions& options,
                        ExportedDeck& deck) {
  const auto note = [&](Loss::Kind kind, std::string what) {
    deck.losses.push_back({kind, std::move(what)});
  };
  if (!statement.pairs.empty()) {
    throw NotExported{
        "OpenSees has no table of part pairs: take 'friction_pairs' out, or give each pair a case"};
  }
  if (statement.otherwise.second)
    throw NotExported{"OpenSees has one coefficient for all directions"};
  NumberWriter number(25, options.digits);
  std::string text = "# " + base::printable(statement.title);
  const base::UnitSystem& units = statement.units;
  if (!units.length.empty()) {
    text += fmt::format(" ({}, {}, {})", units.length, units.force, units.time);
  }
  text += "\n";
  if (!options.behavior_only) text += "model basic -ndm 3 -ndf 6\n";
  if (const auto one = transition_of(statement.otherwise.law)) {
    if (one->at_rest == one->fast) {
      text += fmt::format("frictionModel Coulomb 1 {}\n", number(one->fast));
    } else {
      text += fmt::format("frictionModel VelDependent 1 {} {} {}\n", number(one->at_rest),
                          number(one->fast), number(one->decay));
    }
    note(Loss::Kind::kKept, "coefficient");
  } else {
    const law::FrictionLaw& law = statement.otherwise.law;
    const CoefficientGrid grid = tabulate(law, statement.run);
    if (grid.forces.size() > 1) {
      throw NotExported{
          "its coefficient depends on the contact force in a way that no model of OpenSees has"};
    }
    std::string rates;
    std::string values;
    for (std::size_t i = 0; i < grid.rates.size(); ++i) {
      rates += " " + number(grid.rates[i]);
      values += " " + number(grid.mu[0][i]);
    }
    // Beyond its last point the model goes on with the slope of the last piece.
    rates += " " + number(2.0 * grid.rates.back() + 1.0);
    values += " " + number(grid.mu[0].back());
    text += fmt::format("frictionModel VelDepMultiLinear 1 -vel{} -frn{}\n", rates, values);
    note(Loss::Kind::kApproximated,
         fmt::format("coefficient: {} points over the velocity, off by at most {:.1e}",
                     grid.rates.size(), grid.error));
  }
  const bool exact = (statement.formulation && std::holds_alternative<law::StiffnessPenalty>(
                                                   statement.formulation->penalty)) ||
                     statement.stick.mode == law::StickStiffness::Mode::kStiffness;
  text += fmt::format(
      "# nodes 1 and 2 and material 1 are those of your model\n"
      "element flatSliderBearing 1 1 2 1 {} -P 1 -T 1 -My 1 -Mz 1\n",
      number(stick_stiffness(statement)));
  note(exact ? Loss::Kind::kKept : Loss::Kind::kApproximated,
       exact ? "stick stiffness: kInit of the bearing"
             : "stick: kInit of the bearing, from the elastic slip at the largest limit of the "
               "history");
  if (statement.otherwise.force_limit < law::kNoForceLimit) {
    note(Loss::Kind::kDropped, "force_limit: OpenSees has none");
  }
  if (statement.formulation) {
    if (std::holds_alternative<law::ViscousPenalty>(statement.formulation->penalty)) {
      note(Loss::Kind::kDropped, "viscous penalty: the bearing sticks");
    }
    if (statement.formulation->filter.kind != law::Filter::Kind::kNone) {
      note(Loss::Kind::kDropped, "filter: OpenSees has none");
    }
  }
  note(Loss::Kind::kApproximated,
       "OpenSees takes the velocity of the nodes: in a static analysis the coefficient is that at "
       "rest");
  tell_rounding(number.rounded(), number.worst(), deck.losses);
  return text;
}

}  // namespace slipbench::driver::exports
