// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "driver/base/files/real_files.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

/// Tells whether this is a job of GitHub Actions.
bool in_github_actions();

/// A workflow command of GitHub Actions: "::error file=a.yaml,line=7,col=5,title=T::message", with
/// a line feed; escaped so that neither names nor messages can end it or begin another, and without
/// what no log can show. `level` is
/// "error" or "warning". Line 0 leaves the place out.
std::string annotation(std::string_view level, const std::string& file,
                       const base::SourcePosition& where, std::string_view title,
                       std::string_view message);

/// A text for the log of a job, in which nothing is taken for a command of the old form, as
/// "##[error]" anywhere in a line is.
std::string without_commands(std::string text);

/// The annotations of a suite: failed checks and cases that were not run as errors, doubtful checks
/// as warnings. GitHub shows ten of each for a step, so no more are written.
class Annotations {
 public:
  /// \param root the folder of the checked-out repository, which files are named from, links or
  /// not;
  ///     empty: the names stay as they are
  explicit Annotations(const std::string& root);

  void add(const Candidate& candidate, const CaseOutcome& outcome);

  const std::string& text() const { return text_; }

 private:
  static constexpr std::size_t kMost = 10;

  std::string from_root(const std::string& file);

  std::string root_;
  base::RealFiles real_files_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  std::string text_;
};

}  // namespace slipbench::driver::suite
