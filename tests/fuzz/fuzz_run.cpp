// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/fuzz_run.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "driver/bench/run_case.hpp"
#include "driver/check/check.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {
namespace {

constexpr std::size_t kMostChecks = 8;
constexpr int kMostIncrements = 200;

}  // namespace

void run_briefly(const driver::cases::Case& problem) {
  using driver::bench::Simulation;
  // A mass may take ten million steps of time in one increment before it gives up: seconds, no
  // hang.
  if (problem.dynamics) return;
  std::vector<driver::check::CheckProgress> checks;
  for (const driver::cases::Check& check : problem.checks) {
    if (checks.size() < kMostChecks) checks.emplace_back(problem, check);
  }
  int increments = 0;
  const auto ended =
      driver::bench::follow_cases({&problem, 1}, [&](std::span<const Simulation> all) {
        const driver::bench::Row& row = all.front().row();
        want(std::isfinite(row.time), "the time of a row is a number");
        for (const driver::bench::DefinitionRow& definition : row.definitions) {
          want(std::isfinite(definition.update.limit), "the limit of a row is a number");
          want(std::isfinite(definition.dissipation), "the dissipation of a row is a number");
        }
        for (driver::check::CheckProgress& check : checks) check.add(row);
        return ++increments < kMostIncrements;
      });
  if (!ended) {
    want(!driver::bench::failure_text(problem, ended.error()).empty(), "a failure has a text");
  }
  for (const driver::check::CheckProgress& check : checks) {
    const driver::check::Verdict verdict = check.verdict();
    want(verdict.passed || !verdict.message.empty(), "a check that fails says why");
  }
}

}  // namespace slipbench::fuzz
