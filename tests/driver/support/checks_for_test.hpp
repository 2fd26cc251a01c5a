// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "driver/bench/run_case.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/check/check.hpp"

namespace slipbench::driver {

/// Runs a case to its end. \return the names of the checks that fail
inline std::vector<std::string> failed_checks(const cases::Case& problem) {
  std::vector<check::CheckProgress> checks;
  for (const cases::Check& check : problem.checks) checks.emplace_back(problem, check);
  const auto ended = bench::run_case(problem, [&](const bench::Row& row) {
    for (check::CheckProgress& check : checks) check.add(row);
  });
  REQUIRE(ended);
  std::vector<std::string> failed;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    if (!checks[i].verdict().passed) failed.push_back(problem.checks[i].name);
  }
  return failed;
}

}  // namespace slipbench::driver
