// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/solver_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/bench/belt_motion.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/summary.hpp"
#include "law/update/capstan_update.hpp"
#include "law/update/connector_tangent.hpp"
#include "law/update/snap_back.hpp"
#include "law/update/uniqueness.hpp"

namespace slipbench::driver::analysis {
namespace {

using Square = Eigen::Matrix<double, law::kComponents, law::kComponents>;

/// Below this an asymmetry is rounding.
constexpr double kNoise = 1e-9;
/// From this share on, an equation solver that symmetrises the tangent converges slowly or not at
/// all: the coefficient from which implicit solvers choose their unsymmetric scheme for friction.
constexpr double kWanted = 0.2;

double asymmetry(const Square& part, double size) {
  return size > 0.0 ? (part - part.transpose()).norm() / size : 0.0;
}

constexpr std::string_view kColumns[] = {"asymmetry",        "by_position",      "by_rate",
                                         "force_coupling",   "snap_back",        "unique_increment",
                                         "smooth_increment", "several_solutions"};

}  // namespace

SolverDemand solver_demand(const law::FrictionDefinition& definition,
                           const law::ConnectorIncrement& increment,
                           const law::FrictionUpdate& update, const law::KineticBehavior& kinetic) {
  SolverDemand demand;
  if (update.state.regime == law::Regime::kOpen) return demand;
  const law::SlipSpace& slip = definition.slip;
  const law::SlipTangent& t = update.tangent;

  // f = R y and s = R u: to slip space by 1/R on both sides.
  const law::ConnectorTangent whole = law::connector_tangent(definition, increment, update);
  const Square springs = law::kinetic_slopes(kinetic, increment);
  const Square through_springs = whole.to_force * springs;
  Square tangent = whole.to_motion + through_springs;
  Square rate = Square::Zero();
  const bool potential = std::holds_alternative<law::Potential>(definition.criterion);
  for (int i = 0; i < slip.dimension; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const int ci = slip.component[a];
    tangent.row(ci) /= slip.scale[a];
    tangent.col(ci) /= slip.scale[a];
    for (int j = 0; j < slip.dimension && !potential; ++j) {
      const auto b = static_cast<std::size_t>(j);
      rate(ci, slip.component[b]) = t.rate * update.direction[a] * update.motion_direction[b];
    }
  }
  demand.asymmetry = asymmetry(tangent, tangent.norm());
  // Where next to nothing presses the stick stiffness vanishes, and the springs that press do not.
  const double stick =
      std::max(law::stick_stiffness(definition, update.limit) * std::sqrt(double(slip.dimension)),
               springs.norm());

  law::ConnectorForce to_force;
  law::RelativePosition to_position;
  law::add_gradient(definition.contact_force, increment.force, increment.end, &to_force,
                    &to_position);
  bool follows = false;
  for (int c = 0; c < law::kComponents; ++c) {
    follows = follows || (to_force[c] != 0.0 && !kinetic.pressing.contains(c));
  }
  if (follows) demand.force_coupling = std::abs(t.contact);

  // What is left of the asymmetry comes with the position. A potential mixes the two; it has the
  // position in it or not.
  const auto* internal = std::get_if<law::TableFunction>(&definition.internal_contact_force);
  const bool moves = (internal != nullptr && internal->depends_on_motion()) ||
                     !through_springs.isZero(0.0) ||
                     std::any_of(to_position.values.begin(), to_position.values.end(),
                                 [](double slope) { return slope != 0.0; });
  demand.by_rate = asymmetry(potential && !moves ? tangent : rate, stick);
  demand.by_position = moves ? asymmetry(tangent - rate, stick) : 0.0;

  const auto* wear = std::get_if<law::TableFunction>(&definition.internal_contact_force);
  if (wear != nullptr && law::may_snap_back(definition)) {
    const double slope =
        law::evaluate(*wear, increment.end, update.state.accumulated_slip).to_accumulated_slip;
    const double side = update.contact_force < 0.0 ? -1.0 : 1.0;
    // d(mu F_N)/dF_N of the coefficient itself: the tangent has the snap-back in it already.
    const double growth =
        update.limit < definition.force_limit
            ? update.mu + update.normal_force *
                              law::blended(definition.blend,
                                           law::evaluate(definition.law, increment.end,
                                                         {.slip_rate = update.slip_rate,
                                                          .contact_force = update.normal_force}))
                                  .to_contact_force
            : 0.0;
    // A potential's direction is m/|m|^2: along m the spring has the stiffness |m|^2 k.
    double softer = 0.0;
    for (const double n : update.direction) softer += n * n;
    if (!potential || softer == 0.0) softer = 1.0;
    demand.snap_back = std::max(-side * slope * growth * softer / definition.stick.value, 0.0);
  }
  return demand;
}

SolverReport::SolverReport(const cases::Case& problem, base::OutputFile* file)
    : case_(&problem), file_(file), worst_(problem.definitions.size()) {
  if (file_ == nullptr) return;
  std::string text = base::in_cells(results::provenance_lines(problem)) + "t,duration";
  for (const cases::CaseDefinition& definition : problem.definitions) {
    for (const std::string_view column : kColumns) {
      text += "," + std::string(column);
      if (problem.definitions.size() > 1) text += "." + definition.name;
    }
  }
  file_->append(text + "\n");
}

void SolverReport::add(const bench::Simulation& simulation) {
  const bench::Row& row = simulation.row();
  if (row.index == 0) return;
  ++increments_;
  law::ConnectorIncrement increment = bench::connector_increment(*case_, row);
  std::string* text = file_ == nullptr ? nullptr : &file_->buffer();
  if (text != nullptr) {
    base::append_number(*text, row.time);
    *text += ',';
    base::append_number(*text, row.duration);
  }
  for (std::size_t d = 0; d < worst_.size(); ++d) {
    const bench::DefinitionRow& here = row.definitions[d];
    const law::FrictionDefinition& definition = simulation.definition(d);
    const SolverDemand demand = solver_demand(definition, increment, here.update, case_->kinetic);
    Worst& worst = worst_[d];
    const auto raise = [&](double value, double& largest, double* time) {
      if (!(value > largest)) return;
      largest = value;
      if (time != nullptr) *time = row.time;
    };
    raise(demand.asymmetry, worst.demand.asymmetry, &worst.asymmetry_time);
    raise(demand.by_position, worst.demand.by_position, nullptr);
    raise(demand.by_rate, worst.demand.by_rate, nullptr);
    raise(demand.force_coupling, worst.demand.force_coupling, &worst.coupling_time);
    raise(demand.snap_back, worst.demand.snap_back, &worst.snap_back_time);
    raise(here.thresholds.unique, worst.unique, nullptr);
    if (here.thresholds.unique > row.duration) ++worst.below;
    if (here.update.multiple_roots) ++worst.several;
    if (worst.shortest == 0.0 || row.duration < worst.shortest) worst.shortest = row.duration;
    if (text != nullptr) {
      for (const double number : {demand.asymmetry, demand.by_position, demand.by_rate,
                                  demand.force_coupling, demand.snap_back, here.thresholds.unique,
                                  here.thresholds.smooth, here.update.multiple_roots ? 1.0 : 0.0}) {
        *text += ',';
        base::append_number(*text, number);
      }
    }
    if (case_->belt) bench::meet_next_ring(*case_, d, row, increment);
  }
  if (text != nullptr) {
    *text += '\n';
    file_->flush_if_full();
  }
}

std::string SolverReport::definition_text(const Worst& worst, std::size_t index) const {
  const SolverDemand& demand = worst.demand;
  const std::string& unit = case_->units.time;
  const auto at = [&](double time) {
    return " (t = " + base::with_unit(base::rounded(time), unit) + ")";
  };
  std::string text = case_->definitions.size() > 1
                         ? "  solver, '" + case_->definitions[index].name + "': "
                         : "  solver: ";
  text += demand.asymmetry > kNoise ? fmt::format("tangent unsymmetric by up to {:.3g}{}",
                                                  demand.asymmetry, at(worst.asymmetry_time))
                                    : std::string("tangent to the motion symmetric");
  if (demand.force_coupling > kNoise) {
    text += fmt::format(", limit follows the contact force by up to {:.3g}{}",
                        demand.force_coupling, at(worst.coupling_time));
  }
  text += "\n    ";
  text += worst.several == 0 && worst.unique == 0.0 ? std::string("one answer for any increment")
          : worst.unique > 0.0
              ? fmt::format(
                    "increments longer than {} have one answer; the shortest is {}, {} of "
                    "{} are below their bound",
                    base::with_unit(base::rounded(worst.unique), unit),
                    base::with_unit(base::rounded(worst.shortest), unit), worst.below, increments_)
              : fmt::format("no bound that makes the answer unique");
  if (worst.several > 0) text += fmt::format(", {} may have several", worst.several);
  if (demand.snap_back > 0.0) {
    text += fmt::format("; snap-back number mu|F'|/k up to {:.3g}{}{}", demand.snap_back,
                        at(worst.snap_back_time),
                        demand.snap_back >= 1.0 ? ": slip lets the force jump there" : "");
  }
  text += "\n    ";

  std::string reasons;
  const auto because = [&](double size, const char* what) {
    if (size > kNoise)
      reasons += (reasons.empty() ? "" : ", ") + fmt::format("{} {:.2g}", what, size);
  };
  because(demand.force_coupling, "the contact force follows the constraint forces");
  because(demand.by_position, "the contact force follows the position");
  because(demand.by_rate, "the coefficient follows the rate of the motion");
  const double most = std::max({demand.force_coupling, demand.by_position, demand.by_rate});
  if (most <= kNoise) {
    text += "an implicit solver needs no unsymmetric scheme";
  } else if (most < kWanted * (1.0 - kNoise)) {
    text +=
        "an implicit solver can do without its unsymmetric scheme, at the price of some "
        "iterations: " +
        reasons;
  } else {
    text += "an implicit solver will want its unsymmetric scheme: " + reasons;
  }
  return text + "\n";
}

std::string SolverReport::text() const {
  if (case_->dynamics) {
    return "  solver: not judged, a motion that the friction itself drives has no tangent\n";
  }
  std::string text;
  for (std::size_t d = 0; d < worst_.size(); ++d) text += definition_text(worst_[d], d);
  return text;
}

}  // namespace slipbench::driver::analysis
