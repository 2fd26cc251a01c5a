// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "driver/read/read_case.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/check_case.hpp"
#include "driver/suite/outcome.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::suite {

/// Up to so many cases are all read before the first one is run, so that it is known how many
/// checks there are, and which files must not be overwritten. More are read as their turn comes,
/// which takes no memory.
inline constexpr std::size_t kReadAhead = 1000;

struct SuiteOptions {
  read::ReadOptions read = {};
  unsigned threads = 1;
  bool fail_fast = false;     ///< end with the first case that does not pass
  bool keep_passing = false;  ///< the verdicts of checks that passed, too
  bool strict = false;        ///< a warning fails its case
  /// Takes what a page needs of the case of that index, if there is one; called by any thread, in
  /// any order, and with `fail_fast` also for cases that are not told.
  std::function<void(std::size_t, report::CaseReport&&)> report = {};
};

/// Listener to a suite, called by one thread at a time.
struct SuiteListener {
  /// A case, in the order of the candidates, as soon as all before it are done.
  std::function<void(const Candidate&, CaseOutcome&&)> tell;
  /// Every now and then, how far the work is.
  std::function<void(const terminal::WorkDone&)> progress;
};

/// Reads all cases, by several threads; a bar shows how far they are.
std::vector<Reading> read_suite(std::span<const Candidate> cases, const SuiteOptions& options);

/// Runs cases and judges their checks, by several threads; what is told does not depend on how
/// many. `readings` are those of `read_suite`, or empty: then each case is read as its turn comes,
/// and a long suite needs little memory. With `fail_fast` nothing is told after the first case that
/// does not pass. What `tell` throws ends the suite and is thrown on.
void run_suite(std::span<const Candidate> cases, std::vector<Reading> readings,
               const SuiteOptions& options, const SuiteListener& listener);

}  // namespace slipbench::driver::suite
