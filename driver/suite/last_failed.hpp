// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "driver/base/files/real_files.hpp"
#include "driver/suite/candidates.hpp"

namespace slipbench::driver::suite {

/// Cases of a suite that did not pass last time. They are kept in a file of the user's cache
/// ($XDG_CACHE_HOME/slipbench, or ~/.cache/slipbench), one for each set of paths that are checked,
/// however they are written. A cache that is missing or cannot be read or written means a suite
/// without memory, never an error.
class LastFailed {
 public:
  /// Remembers what there is about the suite of these paths.
  explicit LastFailed(std::span<const std::string> paths);

  /// The order in which to run the cases, by their indices: those that did not pass last time come
  /// first; otherwise the order stays.
  std::vector<std::size_t> order(std::span<const Candidate> cases);

  /// Notes how a case went this time.
  void note(const Candidate& candidate, bool well);

  /// Keeps what was noted, and what was known about cases of the suite (`cases`) that were not run
  /// this time.
  void write(std::span<const Candidate> cases);

 private:
  std::string head_;  ///< of the file: whose failures they are
  std::optional<std::filesystem::path> file_;
  std::string kept_;              ///< what the file held
  std::set<std::string> failed_;  ///< see RealFiles
  base::RealFiles real_files_;
};

}  // namespace slipbench::driver::suite
