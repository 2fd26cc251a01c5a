// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "driver/base/files/file_mark.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

/// The verdicts of a suite as JUnit XML, the form that Jenkins and GitLab read: one `testsuite` for
/// each folder, in the order of their first case in the suite; one `testcase` for each check, with
/// the case's label as class name, its file from the current folder and the line of the check. A
/// check that failed is a `failure`, a case that was not run an `error`, one without checks or that
/// was not reached is `skipped`; doubts about a check stand in its `system-out`. A case's time is
/// divided equally among its checks. But for the times, the same verdicts give the same text: no
/// date and no machine.
class JunitReport {
 public:
  /// The outcome must hold the verdicts of all its checks.
  /// \param place of the case in the suite, whatever the order in which the cases were run
  void add(std::size_t place, const Candidate& candidate, const CaseOutcome& outcome);

  std::string text() const;

  /// The mark of every such file.
  static base::FileMark mark();

 private:
  struct Counts {
    std::size_t tests = 0;
    std::size_t failures = 0;
    std::size_t errors = 0;
    std::size_t skipped = 0;
    double seconds = 0.0;
  };
  struct Suite {
    Counts counts;
    std::map<std::size_t, std::string> cases;  ///< their elements, by their places
  };

  static std::string attributes(const Counts& counts);

  std::map<std::string, Suite> suites_;  ///< by folder
};

}  // namespace slipbench::driver::suite
