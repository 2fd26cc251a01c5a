// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/converge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "driver/bench/run_case.hpp"
#include "driver/check/verdict_text.hpp"
#include "driver/results/provenance.hpp"
#include "driver/terminal/progress.hpp"
#include "law/update/penalty_predictor.hpp"

namespace slipbench::driver::analysis {
namespace {

constexpr std::array kRefinement{1, 2, 4};

cases::Case refined(const cases::Case& problem, int factor) {
  cases::Case finer = problem;
  for (cases::Step& step : finer.steps) step.increments *= factor;
  finer.measured_pieces *= factor;
  return finer;
}

/// Rows that the three runs share, of one definition.
struct Comparison {
  ForceDistance first;
  ForceDistance second;
  double smooth = 0.0;  ///< largest IncrementThresholds::smooth of the first run [T]
  double smooth_time = 0.0;
  double smooth_increment = 0.0;  ///< the increment there [T]
  std::array<double, kRefinement.size()> dissipation{};
};

std::string order_text(const Convergence& convergence) {
  if (convergence.settled()) return "no change";
  const double order = convergence.order();
  return std::isfinite(order) ? fmt::format("order {:.2f}", order) : std::string("no order");
}

std::string verdict_text(const Comparison& of, const Convergence& force,
                         const Convergence& energy) {
  // What changes most decides; a force that is right to rounding may have an energy that is not.
  const ConvergenceVerdict by_force = judge(force);
  const ConvergenceVerdict by_energy = judge(energy);
  const ConvergenceVerdict verdict = std::max(by_force, by_energy);
  const auto errors = [&] {
    std::string text;
    if (const double e = force.error();
        std::isfinite(e) && by_force != ConvergenceVerdict::kSettled) {
      text += fmt::format("; the force is off by about {} on average",
                          percent_text(e / std::max(force.scale, 1e-300)));
    }
    if (const double e = energy.error();
        std::isfinite(e) && by_energy != ConvergenceVerdict::kSettled && energy.scale > 0.0) {
      text +=
          fmt::format("{} by about {}",
                      text.empty() ? "; the dissipated energy is off" : ", the dissipated energy",
                      percent_text(e / energy.scale));
    }
    return text;
  };
  switch (verdict) {
    case ConvergenceVerdict::kSettled:
      return "converged: smaller increments change nothing";
    case ConvergenceVerdict::kSettles:
      return "converged at half the increment: a quarter changes nothing more" + errors();
    case ConvergenceVerdict::kSecondOrder:
      return "second order: half the increment, a quarter of the error" + errors();
    case ConvergenceVerdict::kFirstOrder:
      return "first order: half the increment, half the error" + errors();
    case ConvergenceVerdict::kSlow:
      return "slow: half the increment does not halve the error" + errors();
    case ConvergenceVerdict::kNone:
      break;
  }
  std::string text = "not converging: smaller increments give another answer";
  if (of.smooth > 0.0) {
    text += fmt::format(
        "; the coefficient falls with the slip rate, and increments below {:.4g} turn its smooth "
        "answer into a saw-tooth (yours is {:.4g} at T = {:.6g})",
        of.smooth, of.smooth_increment, of.smooth_time);
  }
  return text;
}

}  // namespace

double Convergence::order() const {
  if (second == 0.0) {
    return first == 0.0 ? std::numeric_limits<double>::quiet_NaN()
                        : std::numeric_limits<double>::infinity();
  }
  return std::log2(first / second);
}

double Convergence::error() const {
  const double p = order();
  if (!(p > 0.25)) return std::numeric_limits<double>::quiet_NaN();
  return first / (1.0 - std::exp2(-p));
}

ConvergenceVerdict judge(const Convergence& convergence) {
  if (convergence.settled()) return ConvergenceVerdict::kSettled;
  const double order = convergence.order();
  // A second difference that is nothing has converged whatever the first was.
  if (convergence.second <= Convergence::kNothing * convergence.scale) {
    return ConvergenceVerdict::kSettles;
  }
  if (order >= 1.5) return ConvergenceVerdict::kSecondOrder;
  if (order >= 0.7) return ConvergenceVerdict::kFirstOrder;
  return order >= 0.3 ? ConvergenceVerdict::kSlow : ConvergenceVerdict::kNone;
}

tl::expected<std::string, CommandFailure> converge(const cases::Case& problem) {
  const std::array cases{refined(problem, kRefinement[0]), refined(problem, kRefinement[1]),
                         refined(problem, kRefinement[2])};
  std::vector<Comparison> definitions(problem.definitions.size());
  terminal::Progress progress(results::case_stem(problem));
  const auto ended = bench::follow_cases(cases, [&](std::span<const bench::Simulation> runs) {
    const bench::Row& row = runs[0].row();
    for (std::size_t d = 0; d < definitions.size(); ++d) {
      Comparison& of = definitions[d];
      const law::FrictionState& second = runs[1].row().definitions[d].update.state;
      of.first.add(row, d, second);
      of.second.add(runs[1].row(), d, runs[2].row().definitions[d].update.state);
      const double smooth = row.definitions[d].thresholds.smooth;
      if (smooth > of.smooth) {
        of.smooth = smooth;
        of.smooth_time = row.time;
        of.smooth_increment = row.duration;
      }
    }
    progress.step(row.index, row.time);
    return true;
  });
  if (!ended) {
    return tl::unexpected(CommandFailure{bench::exit_code(ended.error()),
                                         bench::failure_text(problem, ended.error())});
  }
  const std::vector<bench::Simulation>& runs = *ended;
  std::string text = fmt::format("{}: {}, {} and {} increments\n", results::case_stem(problem),
                                 runs[0].row().index, runs[0].row().index * kRefinement[1],
                                 runs[0].row().index * kRefinement[2]);
  for (std::size_t d = 0; d < definitions.size(); ++d) {
    Comparison& of = definitions[d];
    for (std::size_t i = 0; i < runs.size(); ++i) {
      of.dissipation[i] = runs[i].row().definitions[d].dissipation;
    }
    const Convergence force{of.first.mean(), of.second.mean(), of.first.largest};
    const auto& energy_of = of.dissipation;
    const Convergence energy{std::abs(energy_of[0] - energy_of[1]),
                             std::abs(energy_of[1] - energy_of[2]), std::abs(energy_of[2])};
    text += fmt::format("  {}\n", problem.definitions[d].name);
    text += fmt::format(
        "    force       dt to dt/2 {:.2g} apart at most ({}), {:.2g} on average; dt/2 to dt/4 "
        "{:.2g} "
        "and {:.2g}; {}\n",
        of.first.most, percent_text(of.first.relative(of.first.most)), of.first.mean(),
        of.second.most, of.second.mean(), order_text(force));
    text += fmt::format("    dissipated  {:.7g}, {:.7g}, {:.7g}; {}\n", energy_of[0], energy_of[1],
                        energy_of[2], order_text(energy));
    text += "    " + verdict_text(of, force, energy) + "\n";
    const auto& formulation = problem.definitions[d].law.formulation;
    if (formulation && formulation->filter.kind == law::Filter::Kind::kSimple &&
        law::smooths(*formulation)) {
      text +=
          "    its filter counts increments (simple, Xfreq): with others it is another filter, "
          "with another answer; 'period' keeps it\n";
    }
  }
  return text;
}

}  // namespace slipbench::driver::analysis
