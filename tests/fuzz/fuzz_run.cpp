// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/fuzz_run.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

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
constexpr int kMostStepsOfMass = 1000;

/// Returns how many more steps of time a mass may take.
int& steps_left() {
  static int left = 0;
  return left;
}

/// Returns the method of the steps that a mass takes, as GSL has it.
const gsl_odeiv2_step_type& method_of_mass() {
  static const gsl_odeiv2_step_type kMethod = *gsl_odeiv2_step_rk8pd;
  return kMethod;
}

/// Takes a step while any are left; then it fails, and the increment with it.
int step_if_left(void* state, std::size_t dimension, double time, double size, double* y,
                 double* error, const double* slope_before, double* slope_after,
                 const gsl_odeiv2_system* system) {
  if (steps_left() == 0) return GSL_EBADFUNC;
  --steps_left();
  return method_of_mass().apply(state, dimension, time, size, y, error, slope_before, slope_after,
                                system);
}

/// Lets a mass take so many steps of time from now on, whatever its increments: in a single one it
/// may take 150,000 before it gives up, which is a second and no hang. How many it needs depends on
/// stiffness, friction and stick-slip, so they are counted where GSL is asked for them.
void bound_steps_of_mass(int most) {
  static const gsl_odeiv2_step_type kCounted = [] {
    gsl_odeiv2_step_type counted = method_of_mass();
    counted.apply = step_if_left;
    return counted;
  }();
  gsl_odeiv2_step_rk8pd = &kCounted;
  steps_left() = most;
}

}  // namespace

void run_briefly(const driver::cases::Case& problem) {
  using driver::bench::Simulation;
  bound_steps_of_mass(kMostStepsOfMass);
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
