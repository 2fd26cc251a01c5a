// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/compare_integration.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/bench/exact_integration.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/row_writer.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::analysis {
namespace {

/// "0.0663 by backward Euler, 0.0662 exactly: 0.02 % more"
std::string pair_text(double euler, double exact) {
  std::string text = fmt::format("{:.7g} by backward_euler, {:.7g} exactly", euler, exact);
  if (euler == exact) return text;
  if (exact == 0.0) return text;
  const double part = (euler - exact) / std::abs(exact);
  return text + fmt::format(": {} {}", percent_text(std::abs(part)), part > 0.0 ? "more" : "less");
}

}  // namespace

tl::expected<std::string, CommandFailure> compare_integration(const cases::Case& problem) {
  std::array both{problem, problem};
  both[0].integration.method = cases::IntegrationMethod::kBackwardEuler;
  both[1].integration.method = cases::IntegrationMethod::kExact;
  if (const auto refusal = bench::refuse_exact(both[1])) {
    return tl::unexpected(CommandFailure{
        base::kExitBadInput, fmt::format("{}: error: integration cannot be compared: {}\n",
                                         problem.file, refusal->message)});
  }
  std::vector<ForceDistance> distances(problem.definitions.size());
  terminal::Progress progress(results::case_stem(problem));
  const auto ended = bench::follow_cases(both, [&](std::span<const bench::Simulation> runs) {
    const bench::Row& row = runs[1].row();
    for (std::size_t d = 0; d < distances.size(); ++d) {
      distances[d].add(row, d, runs[0].row().definitions[d].update.state);
    }
    progress.step(row.index, row.time);
    return true;
  });
  if (!ended) {
    return tl::unexpected(CommandFailure{bench::exit_code(ended.error()),
                                         bench::failure_text(problem, ended.error())});
  }
  const bench::Row& euler = (*ended)[0].row();
  const bench::Row& exact = (*ended)[1].row();

  std::string text = fmt::format("{}: backward_euler against exact, {} increments\n",
                                 results::case_stem(problem), exact.index);
  for (std::size_t d = 0; d < distances.size(); ++d) {
    const ForceDistance& distance = distances[d];
    const bench::DefinitionRow& a = euler.definitions[d];
    const bench::DefinitionRow& b = exact.definitions[d];
    text += fmt::format("  {}\n", problem.definitions[d].name);
    // Below that the two differ by the rounding of their sums.
    constexpr double kRounding = 1e-12;
    if (distance.most <= kRounding * distance.largest) {
      text += fmt::format("    force       the same to rounding; the largest is {:.7g}\n",
                          distance.largest);
    } else {
      text += fmt::format(
          "    force       {:.3g} apart at most, {} of the largest ({:.7g}), at T = {}{}\n",
          distance.most, percent_text(distance.relative(distance.most)), distance.largest,
          fmt::format("{:.6g}", distance.time), step_text(problem, distance.step));
    }
    text += fmt::format("    slip        {}\n", pair_text(a.update.state.accumulated_slip,
                                                          b.update.state.accumulated_slip));
    text += fmt::format("    dissipated  {}\n", pair_text(a.dissipation, b.dissipation));
  }
  return text;
}

}  // namespace slipbench::driver::analysis
