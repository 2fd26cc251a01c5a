// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/bench/belt_motion.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/results/coverage.hpp"
#include "driver/results/events.hpp"
#include "driver/results/friction_force.hpp"
#include "driver/results/normal_shares.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/summary.hpp"
#include "law/update/capstan_update.hpp"
#include "law/update/penalty_predictor.hpp"
#include "law/update/penalty_update.hpp"

namespace slipbench::driver::analysis {
namespace {

/// Events told on either side of the instant.
constexpr std::size_t kEventsTold = 2;

std::string digits(double value) { return base::rounded(value == 0.0 ? 0.0 : value, 6); }

/// The instant and what is around it.
struct Instant {
  bench::Row row;
  std::vector<law::FrictionDefinition> in_force;
  std::vector<std::deque<results::Event>> before;  ///< of each definition, the last ones
  std::vector<std::vector<results::Event>> after;
  double end_time = 0.0;  ///< of the history, as far as it was followed
  bool to_the_end = false;
};

/// "3.2 in 0 .. 10 (32 %)", "12.0 above 10: held" and the like, for each independent.
std::string cell_text(const law::TableFunction& function, const law::Ambient& ambient,
                      const law::SlipArguments& slip) {
  using Place = law::TableInterval::Place;
  const law::TableCell cell = function.cell(ambient, slip);
  const auto x = function.arguments(ambient, slip);
  const bool held = function.table().extrapolation() == law::Extrapolation::kConstant;
  std::string text;
  for (std::size_t k = 0; k < function.independents().size(); ++k) {
    const law::TableInterval& at = cell.along[k];
    text += (text.empty() ? "" : ", ") + results::independent_name(function.independents()[k]) +
            " " + digits(x[k]);
    if (at.place != Place::kInside) {
      const bool below = at.place == Place::kBelow;
      // The end of the block, whichever segment is prolonged.
      text += fmt::format(
          " {} {}: {}", below ? "below" : "above", base::format_number(below ? at.lower : at.upper),
          held || at.lower == at.upper ? "clamped to the end value" : "extrapolated");
    } else if (at.lower == at.upper) {
      text += " at the only point";
    } else {
      text += fmt::format(" in {} .. {} ({:.4g} %)", base::format_number(at.lower),
                          base::format_number(at.upper), 100.0 * at.fraction);
    }
  }
  if (cell.ragged) text += ", between blocks with other grid points";
  return text.empty() ? "its only value" : text;
}

std::string term_text(const law::DerivedTerm& term, const law::ConnectorForce& force,
                      const law::Ambient& ambient) {
  std::string inside;
  for (int j = 0; j < term.count; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const double weight =
        term.weight_table ? term.weight_table->value(ambient, {}, j) : term.weight[k];
    const std::string component =
        cases::force_name(term.component[k]) + " " + digits(force[term.component[k]]);
    const std::string entry = weight == 1.0 ? component : digits(weight) + " x " + component;
    switch (term.combine) {
      case law::TermOperator::kNorm:
        inside += fmt::format("{}({})^2", inside.empty() ? "" : " + ", entry);
        break;
      case law::TermOperator::kSum:
        inside += fmt::format("{}({})", inside.empty() ? "" : " + ", entry);
        break;
      case law::TermOperator::kMacauleySum:
        inside += fmt::format("{}max({}, 0)", inside.empty() ? "" : " + ", entry);
        break;
    }
  }
  std::string text = fmt::format(
      "{} = {}{}{}{}", digits(results::term_value(term, force, ambient)),
      term.sign < 0.0 ? "-" : "", term.combine == law::TermOperator::kNorm ? "sqrt" : "",
      "(" + inside + ")", std::string("   ") + results::term_words(term));
  if (term.weight_table) {
    text += "; weights from their table, " + cell_text(*term.weight_table, ambient, {});
  }
  return text;
}

/// Returns a line for each free component that a contact force names: the sum its force is.
std::vector<std::string> kinetic_lines(const cases::Case& problem, const bench::Row& row,
                                       const law::ContactForce& contact) {
  std::vector<std::string> lines;
  const law::ComponentSet named = law::components_of(contact) & problem.kinetic.pressing;
  for (int c = 0; c < law::kComponents; ++c) {
    if (!named.contains(c)) continue;
    const bench::ComponentForces& f = row.forces.component[static_cast<std::size_t>(c)];
    std::string sum;
    const auto add = [&](const char* sign, const char* prefix, double force, bool there) {
      if (!there) return;
      if (!sum.empty() || *sign == '-') sum += fmt::format("{}{} ", sum.empty() ? "" : " ", sign);
      sum += fmt::format("{} {}", cases::force_column(prefix, c), digits(force));
    };
    add("+", "CEF", f.elastic, problem.kinetic.is_elastic(c));
    add("+", "CVF", f.viscous, problem.kinetic.is_damped(c));
    add("+", "CRF", f.reaction, problem.stop[static_cast<std::size_t>(c)].has_value());
    const bool mass = problem.dynamics && problem.dynamics->component == c;
    add("-", "CCF", f.applied, mass || problem.force_driven.contains(c));
    lines.push_back(fmt::format("{} {} = {}   component {} is free{}", cases::force_name(c),
                                digits(row.forces.pressing[c]), sum.empty() ? "0" : sum, c + 1,
                                sum.empty() ? ", and nothing acts along it" : ""));
  }
  return lines;
}

/// The contact force: its value, and a line for each of its terms.
std::vector<std::string> contact_lines(const law::ContactForce& contact,
                                       const law::ConnectorIncrement& increment) {
  const law::ConnectorForce& force = increment.force;
  std::vector<std::string> lines;
  if (const auto* component = std::get_if<law::ComponentContactForce>(&contact)) {
    lines.push_back(fmt::format("{} = {}   component with its sign",
                                digits(force[component->component]),
                                cases::force_name(component->component)));
  } else if (const auto* derived = std::get_if<law::DerivedComponent>(&contact)) {
    for (const law::DerivedTerm& term : *derived) {
      lines.push_back(term_text(term, force, increment.end));
    }
  } else if (const auto* joint = std::get_if<law::UniversalJointContact>(&contact)) {
    const law::UniversalJointTerms t = law::terms(*joint, force, increment.end.position);
    lines.push_back(fmt::format(
        "{} = 2 x (face {} + R_p {} x (radial {} + bending {}))   two hinges on axis {}",
        digits(law::evaluate(*joint, force, increment.end.position)), digits(t.face),
        digits(joint->R_p), digits(t.radial), digits(t.bending), joint->axis));
  }
  return lines;
}

std::string force_unit(const law::FrictionDefinition& definition, const cases::Case& problem) {
  return base::unit_text(results::is_rotational(definition) ? base::kMoment : base::kForce,
                         problem.units);
}

/// Tells whether the play of a dead zone lies between its ends and nothing slips: no force,
/// whatever the limit is.
bool is_in_gap(const cases::CaseDefinition& definition, const bench::DefinitionRow& row) {
  return definition.dead_zone && row.update.state.regime == law::Regime::kStick &&
         std::abs(row.play) < 0.5 * definition.dead_zone->width;
}

std::string dead_zone_text(const cases::DeadZone& zone, double play, const std::string& unit) {
  const double half = 0.5 * zone.width;
  const char* where = play >= half    ? "at its upper end"
                      : play <= -half ? "at its lower end"
                                      : "between its ends: no force";
  return fmt::format("  play {} of a dead zone of {}, {}\n", base::with_unit(digits(play), unit),
                     base::with_unit(digits(zone.width), unit), where);
}

/// "CSF1 74.2 N, CSM1 17.8 N mm".
std::string forces_text(const cases::Case& problem, const law::FrictionDefinition& definition,
                        const law::FrictionState& state, double limit) {
  law::ConnectorForce force = law::friction_force(definition, state);
  std::string text;
  for (int k = 0; k < definition.slip.dimension; ++k) {
    const int c = definition.slip.component[static_cast<std::size_t>(k)];
    const std::string unit =
        base::unit_text(law::is_rotation(c) ? base::kMoment : base::kForce, problem.units);
    // Rounding of a force that went through zero.
    if (std::abs(force[c]) <= 1e-12 * definition.slip.scale[static_cast<std::size_t>(k)] * limit) {
      force[c] = 0.0;
    }
    text += (text.empty() ? "" : ", ") + cases::force_column("CSF", c) + " " +
            base::with_unit(fmt::format("{}{}", force[c] > 0.0 ? "+" : "", digits(force[c])), unit);
  }
  return text;
}

/// P of the state, and how it is made up.
std::pair<double, std::string> magnitude(const law::FrictionDefinition& definition,
                                         const law::FrictionState& state) {
  const law::SlipSpace& slip = definition.slip;
  if (const auto* potential = std::get_if<law::Potential>(&definition.criterion)) {
    const auto parts = law::contributions(*potential, state.force);
    std::string text;
    for (int i = 0; i < potential->parts; ++i) {
      const auto part = static_cast<std::size_t>(i);
      std::string members;
      for (int g = 0; g < potential->leaves; ++g) {
        const law::PotentialLeaf& leaf = potential->leaf[static_cast<std::size_t>(g)];
        if (leaf.part != i) continue;
        for (int k = 0; k < slip.dimension; ++k) {
          const auto entry = static_cast<std::size_t>(k);
          if (leaf.direction[entry] == 0.0) continue;
          members +=
              (members.empty() ? "" : " ") + cases::force_column("CSF", slip.component[entry]);
        }
      }
      text += fmt::format("{}{} [{}]", i == 0 ? "" : ", ", digits(parts[part]), members);
    }
    const std::string how = potential->combine == law::PotentialOperator::kMax
                                ? "the largest of the contributions "
                                : fmt::format("the sum of powers {} of the contributions ",
                                              base::format_number(potential->exponent));
    return {law::value(*potential, state.force), how + text};
  }
  if (slip.dimension == 1 && slip.scale[0] == 1.0) {
    return {std::abs(state.force[0]), "abs(" + cases::force_column("CSF", slip.component[0]) + ")"};
  }
  double square = 0.0;
  std::string text;
  for (int k = 0; k < slip.dimension; ++k) {
    const auto i = static_cast<std::size_t>(k);
    square += state.force[i] * state.force[i];
    const std::string name = cases::force_column("CSF", slip.component[i]);
    text += fmt::format("{}({}{})^2", text.empty() ? "" : " + ", name,
                        slip.scale[i] == 1.0 ? "" : "/" + digits(slip.scale[i]));
  }
  return {std::sqrt(square), "sqrt(" + text + ")"};
}

/// Returns what a law with a floor saw and what it gave before it.
std::string floored_text(const law::FrictionLaw& law, double speed, double normal_force,
                         double raw) {
  std::string text = fmt::format("{} at speed {}", law::name_of(law), digits(speed));
  if (const double area = law::area_of(law); area > 0.0) {
    text += fmt::format(" and pressure {} = F_N {} / area {}", digits(normal_force / area),
                        digits(normal_force), digits(area));
  }
  if (law::has_floor(law) && raw < 0.0) {
    text += fmt::format("; it gives {}, kept at 1e-30", digits(raw));
  }
  return text;
}

/// Both coefficients of an orthotropic one.
std::string directions_text(const law::FrictionDefinition& definition,
                            const bench::DefinitionRow& row) {
  const law::Orthotropy& two = *definition.formulation->orthotropy;
  const double normal_force = row.update.normal_force;
  const auto one = [&](const law::FrictionLaw& law, std::size_t i) {
    return fmt::format("\n     mu{} {}   {}", i + 1, digits(row.penalty.mu[i]),
                       floored_text(law, row.penalty.speeds[i], normal_force, row.raw_mu[i]));
  };
  return fmt::format("mu {} along the force, direction 1 is ({}, {})", digits(row.update.mu),
                     digits(two.first[0]), digits(two.first[1])) +
         one(definition.law, 0) + one(two.second, 1);
}

/// Returns how the coefficient comes about.
std::string coefficient_text(const law::FrictionDefinition& definition,
                             const bench::DefinitionRow& row, const law::Ambient& end) {
  const law::FrictionUpdate& update = row.update;
  if (definition.formulation && definition.formulation->orthotropy) {
    return directions_text(definition, row);
  }
  const law::SlipArguments slip{.slip_rate = update.slip_rate,
                                .contact_force = update.normal_force};
  const double of_law = law::evaluate(definition.law, end, slip).mu;
  std::string text = "mu " + digits(update.mu);
  if (definition.blend.weight != 1.0) {
    text += fmt::format(" = {} + {} x ({} - {})   the friction is changing; the new mu {}",
                        digits(definition.blend.start), digits(definition.blend.weight),
                        digits(of_law), digits(definition.blend.start), digits(of_law));
  }
  if (const auto* table = std::get_if<law::TabularCoefficient>(&definition.law)) {
    text += "   from its table: " + cell_text(table->table, end, slip);
    if (table->table.value(end, slip) < 0.0) text += "; negative there, 0 is taken";
  } else if (const auto decay = law::exponential_decay(definition.law)) {
    text += fmt::format(" = kinetic {} + (static {} - kinetic {}) x exp(-{} x slip rate {})",
                        digits(decay->kinetic), digits(decay->mu_static), digits(decay->kinetic),
                        digits(decay->decay), digits(update.slip_rate));
  } else if (law::has_floor(definition.law)) {
    text +=
        "   " + floored_text(definition.law, update.slip_rate, update.normal_force, row.raw_mu[0]);
  } else {
    text += "   a constant";
  }
  return text;
}

/// A vector of the slip space: "(3.1, -2.4)", of one entry without brackets.
std::string vector_text(const law::SlipSpace& slip,
                        const std::array<double, law::kComponents>& vector) {
  std::string text;
  for (int k = 0; k < slip.dimension; ++k) {
    text += (text.empty() ? "" : ", ") + digits(vector[static_cast<std::size_t>(k)]);
  }
  return slip.dimension == 1 ? text : "(" + text + ")";
}

/// The way of the force through penalty, limit and filter.
std::string formulation_text(const law::FrictionDefinition& definition,
                             const bench::DefinitionRow& row) {
  const law::Formulation& formulation = *definition.formulation;
  const law::PenaltyDetail& detail = row.penalty;
  const bool as_coded = formulation.convention == law::Convention::kAsCoded;
  const bool smooths = law::smooths(formulation);
  if (row.update.state.regime == law::Regime::kOpen) {
    const bool remembers = std::holds_alternative<law::StiffnessPenalty>(formulation.penalty);
    if (!smooths && !remembers) return {};
    return fmt::format("  open: {} again from 0\n", !remembers ? "the filter starts"
                                                    : smooths  ? "filter and memory start"
                                                               : "the memory starts");
  }
  std::string text = "  formulation ";
  if (const auto* viscous = std::get_if<law::ViscousPenalty>(&formulation.penalty)) {
    const double c = detail.viscous_coefficient;
    text +=
        fmt::format("viscous: trial {} = C {} x v, V = {}",
                    vector_text(definition.slip, detail.trial), digits(c), digits(detail.speed));
    if (!viscous->coefficient) {
      const double visf = as_coded ? std::sqrt(viscous->visf) : viscous->visf;
      const double normal = c > 0.0 ? c * c / (2.0 * visf * visf * viscous->mass)
                                    : (std::holds_alternative<double>(viscous->stiffness)
                                           ? std::get<double>(viscous->stiffness)
                                           : 0.0);
      text += fmt::format("\n     C = {} x sqrt(2 x K {} x m {})",
                          as_coded ? fmt::format("sqrt(VISF {})", digits(viscous->visf))
                                   : fmt::format("VISF {}", digits(viscous->visf)),
                          digits(normal), digits(viscous->mass));
    }
  } else {
    const double k = std::get<law::StiffnessPenalty>(formulation.penalty).stiffness;
    const bool scaled = as_coded && formulation.filter.kind != law::Filter::Kind::kNone;
    text += fmt::format("stiffness: trial {} = {}force before + {}K_t {} x ds",
                        vector_text(definition.slip, detail.trial), smooths ? "unfiltered " : "",
                        scaled ? "alpha " + digits(detail.alpha) + " x " : "", digits(k));
  }
  text += fmt::format("\n     within the limit {}", vector_text(definition.slip, detail.raw));
  if (std::holds_alternative<law::ViscousPenalty>(formulation.penalty) &&
      row.update.state.regime == law::Regime::kStick) {
    text += ": it creeps, a viscous penalty has no stick";
  }
  text += "\n";
  if (!smooths) return text;
  text +=
      fmt::format("  filter alpha {}: {} = {} x {} + {} x the force before", digits(detail.alpha),
                  vector_text(definition.slip, row.update.state.force), digits(detail.alpha),
                  vector_text(definition.slip, detail.raw), digits(1.0 - detail.alpha));
  if (formulation.filter.clip) text += ", taken back to the limit";
  text += "\n";
  const double use = law::limit_use(definition, row.update, row.penalty);
  if (use < results::kUseWithoutLimit) {
    text += fmt::format("     given out at {:.4g} % of the limit{}\n", 100.0 * use,
                        use > 1.0 + 1e-9 ? ": overshoot" : "");
  } else {
    text += fmt::format("     given out although {} limit is 0: overshoot\n",
                        formulation.orthotropy ? "a direction's" : "the");
  }
  return text;
}

std::string limit_text(const law::FrictionDefinition& definition,
                       const law::FrictionUpdate& update) {
  const std::string limit = "limit " + digits(update.limit);
  std::string product;
  double value = update.mu * update.normal_force;
  if (const auto* belt = std::get_if<law::Capstan>(&definition.criterion)) {
    const bool forward = !(update.direction[0] < 0.0);
    const double mu_alpha = update.mu * belt->wrap_angle;
    value = update.normal_force * law::capstan_limit(mu_alpha, forward ? law::FlowSense::kForward
                                                                       : law::FlowSense::kBackward);
    const std::string exponent =
        fmt::format("mu {} x alpha {}", digits(update.mu), digits(belt->wrap_angle));
    product = "T " + digits(update.normal_force) +
              (forward ? " x (exp(" + exponent + ") - 1)" : " x (1 - exp(-" + exponent + "))");
  } else {
    product = fmt::format("mu {} x F_N {}", digits(update.mu), digits(update.normal_force));
  }
  if (update.limit >= definition.force_limit) {
    return fmt::format("{} = force_limit   {} = {} is not less", limit, product, digits(value));
  }
  return limit + " = " + product;
}

void append_events(std::string& text, const Instant& instant, std::size_t d, bool in_gap,
                   const std::string& unit, const std::string& time_unit) {
  const auto one = [&](const results::Event& event) {
    return fmt::format("t = {} {} -> {}{} (force {}, accumulated slip {})",
                       base::with_unit(digits(event.time), time_unit),
                       results::regime_name(event.from), results::goal_name(event),
                       event.reversal ? ", reversed" : "",
                       base::with_unit(digits(event.force), unit), digits(event.accumulated_slip));
  };
  const std::string now = results::regime_name(instant.row.definitions[d].update.state.regime);
  const std::string doing = now == "open"   ? "open"
                            : now == "slip" ? "slipping"
                            : in_gap        ? "without slip"
                                            : "sticking";
  const std::deque<results::Event>& before = instant.before[d];
  text += before.empty() ? "  " + doing + " since the start\n"
                         : fmt::format("  {} since t = {}\n", doing,
                                       base::with_unit(digits(before.back().time), time_unit));
  for (const results::Event& event : before) text += "    before: " + one(event) + "\n";
  for (const results::Event& event : instant.after[d]) text += "    next:   " + one(event) + "\n";
  if (instant.after[d].empty()) text += "    next:   none until the end of the history\n";
}

std::string definition_text(const cases::Case& problem, const Instant& instant, std::size_t d,
                            const law::ConnectorIncrement& increment) {
  const law::FrictionDefinition& definition = instant.in_force[d];
  const law::FrictionUpdate& update = instant.row.definitions[d].update;
  const law::Regime regime = update.state.regime;
  const std::string unit = force_unit(definition, problem);
  const bool belt = std::holds_alternative<law::Capstan>(definition.criterion);
  const bool in_gap = is_in_gap(problem.definitions[d], instant.row.definitions[d]);
  std::string text = fmt::format(
      "{}{}   {}\n", problem.definitions.size() > 1 ? "'" + problem.definitions[d].name + "' " : "",
      in_gap ? "in the gap of the dead zone" : results::regime_name(regime),
      forces_text(problem, definition, update.state, update.limit));
  // The limit bounds the force before a filter.
  const bool filtered = definition.formulation && law::smooths(*definition.formulation);
  auto [p, how] =
      magnitude(definition, results::limited_state(definition, instant.row.definitions[d]));
  if (p <= 1e-12 * update.limit) p = 0.0;
  text += fmt::format("  P {}{} = {}{}\n", base::with_unit(digits(p), unit),
                      filtered ? " before the filter" : "", how,
                      filtered ? " of the force within the limit" : "");
  // Rounding of a force that was put on its limit is no distance.
  const double phi = std::abs(update.phi) <= 1e-12 * update.limit ? 0.0 : update.phi;
  text += fmt::format("  Phi {} = P - limit", base::with_unit(digits(phi), unit));
  if (regime == law::Regime::kStick && !in_gap && update.limit > 0.0) {
    text += fmt::format("   at {:.4g} % of the limit", 100.0 * p / update.limit);
  }
  text += "\n  " + limit_text(definition, update);
  if (regime == law::Regime::kOpen) text += "   nothing to hold on to";
  text += "\n  " + coefficient_text(definition, instant.row.definitions[d], increment.end);
  if (problem.definitions[d].backward) {
    text +=
        instant.row.definitions[d].backward ? ", that of backward slip" : ", that of forward slip";
  }
  text += "\n";
  if (const auto& zone = problem.definitions[d].dead_zone) {
    const std::string length = base::unit_text(
        results::is_rotational(definition) ? base::kAngle : base::kLength, problem.units);
    text += dead_zone_text(*zone, instant.row.definitions[d].play, length);
  }
  if (definition.formulation && instant.row.index > 0) {
    text += formulation_text(definition, instant.row.definitions[d]);
  }

  const double contact = law::evaluate(definition.contact_force, increment.force, increment.end);
  if (belt) {
    text += fmt::format("  F_N {} = tension T before the ring{}\n",
                        base::with_unit(digits(update.normal_force), unit),
                        contact > 0.0 ? "" : ", which is slack");
    text += fmt::format("     behind the ring f_bc {}\n",
                        base::with_unit(digits(law::tension_behind(update)), unit));
  } else {
    const double slip = results::slip_of_internal_force(definition, update);
    const double internal =
        law::evaluate(definition.internal_contact_force, increment.end, slip).value;
    text += fmt::format("  F_N {} = abs(contact {} + internal {})\n",
                        base::with_unit(digits(update.normal_force), unit), digits(contact),
                        digits(internal));
    const auto lines = contact_lines(definition.contact_force, increment);
    for (const std::string& line : lines) text += "     contact:  " + line + "\n";
    for (const std::string& line : kinetic_lines(problem, instant.row, definition.contact_force)) {
      text += "               " + line + "\n";
    }
    if (lines.empty()) text += "     contact:  none, only the internal contact force acts\n";
    if (const auto* table = std::get_if<law::TableFunction>(&definition.internal_contact_force)) {
      const law::SlipArguments arguments{.accumulated_slip = slip};
      text += fmt::format("     internal: {} from its table: {}\n", digits(internal),
                          cell_text(*table, increment.end, arguments));
      if (table->value(increment.end, arguments) < 0.0) {
        text += "               negative there, 0 is taken\n";
      }
    } else {
      text += fmt::format("     internal: {}   a constant\n", digits(internal));
    }
  }
  if (regime == law::Regime::kSlip) {
    double length = 0.0;
    std::string numbers;
    std::string names;
    for (const double n : update.direction) length += n * n;
    length = std::sqrt(length);
    for (int k = 0; k < definition.slip.dimension; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double n = length > 0.0 ? update.direction[i] / length : 0.0;
      const double scale = definition.slip.scale[i];
      numbers += (numbers.empty() ? "" : ", ") + digits(n);
      const bool own_flow = d > 0 && problem.belt && !problem.belt->lengths.empty();
      names += fmt::format("{}{}{}{}", names.empty() ? "" : ", ",
                           scale == 1.0 ? "" : digits(scale) + " ",
                           cases::motion_name(definition.slip.component[i]),
                           own_flow ? "." + problem.definitions[d].name : "");
    }
    text += fmt::format("  slip direction ({}) in ({}); slip rate {}\n", numbers, names,
                        digits(update.slip_rate));
  }
  append_events(text, instant, d, in_gap, unit, problem.units.time);
  return text;
}

/// Follows the run to the instant and on to the events behind it.
tl::expected<Instant, ExplainFailure> find(const cases::Case& problem, double time) {
  const std::size_t count = problem.definitions.size();
  Instant instant;
  instant.before.resize(count);
  instant.after.resize(count);
  results::EventDetector detector(problem);
  bool found = false;
  bool enough = false;
  double start_time = 0.0;
  const auto ended =
      bench::follow_cases({&problem, 1}, [&](std::span<const bench::Simulation> runs) {
        const bench::Row& row = runs.front().row();
        if (row.index == 0) start_time = row.time;
        instant.end_time = row.time;
        const auto events = detector.take(row);
        constexpr double kSame = 1e-9;
        if (!found && time >= start_time && time <= row.time + kSame * row.duration) {
          found = true;
          instant.row = row;
          for (std::size_t d = 0; d < count; ++d)
            instant.in_force.push_back(runs.front().definition(d));
        }
        for (const results::Event& event : events) {
          // Those of the increment itself have led to what it ends with.
          if (!found || row.index == instant.row.index) {
            auto& before = instant.before[event.definition];
            before.push_back(event);
            if (before.size() > kEventsTold) before.pop_front();
          } else if (instant.after[event.definition].size() < kEventsTold) {
            instant.after[event.definition].push_back(event);
          }
        }
        enough =
            found && std::all_of(instant.after.begin(), instant.after.end(),
                                 [](const auto& after) { return after.size() == kEventsTold; });
        return !enough;
      });
  // A failure behind the instant does not matter for it.
  if (enough || (!ended && found)) return instant;
  if (!ended) {
    return tl::unexpected(ExplainFailure{bench::exit_code(ended.error()),
                                         bench::failure_text(problem, ended.error())});
  }
  instant.to_the_end = true;
  if (found) return instant;
  return tl::unexpected(ExplainFailure{
      base::kExitBadInput,
      fmt::format("slipbench: error: --explain {}: {} runs from t = {} to t = {}\n",
                  base::format_number(time), results::case_stem(problem),
                  base::format_number(start_time), base::format_number(instant.end_time))});
}

}  // namespace

tl::expected<std::string, ExplainFailure> explain(const cases::Case& problem, double time) {
  auto instant = find(problem, time);
  if (!instant) return tl::unexpected(std::move(instant.error()));
  const bench::Row& row = instant->row;
  const std::string& unit = problem.units.time;
  std::string where =
      row.index == 0
          ? "the start"
          : fmt::format("increment {}, from t = {}", row.index,
                        base::with_unit(base::format_number(row.time - row.duration), unit));
  if (!problem.steps.empty()) {
    const cases::Step& step = problem.steps[static_cast<std::size_t>(row.step)];
    where += fmt::format(", step '{}'", step.name);
    if (step.repeat > 1) where += fmt::format(", pass {} of {}", row.pass + 1, step.repeat);
  }
  std::string text = fmt::format("{}: t = {}   {}\n", results::case_stem(problem),
                                 base::with_unit(base::format_number(row.time), unit), where);
  if (std::abs(row.time - time) > 1e-9 * row.duration) {
    text += fmt::format("  the first increment that ends at or after t = {}\n",
                        base::with_unit(base::format_number(time), unit));
  }
  if (problem.pair) {
    text += fmt::format("  parts {} and {} take the friction of {}\n", problem.pair->parts[0],
                        problem.pair->parts[1], problem.pair->record());
  }
  law::ConnectorIncrement increment = bench::connector_increment(problem, row);
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    text += definition_text(problem, *instant, d, increment);
    if (problem.belt) bench::meet_next_ring(problem, d, row, increment);
  }
  if (problem.definitions.empty()) text += "  no friction\n";
  return text;
}

}  // namespace slipbench::driver::analysis
