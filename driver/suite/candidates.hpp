// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace slipbench::driver::suite {

/// A case of a suite: where it is, and what it is called in tables.
struct Candidate {
  std::string path;
  std::string label;  ///< the path without .yaml; below the folder if only one was named

  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// The cases of a suite, each once, and in sentences what could not be searched.
struct Candidates {
  std::vector<Candidate> cases;
  std::vector<std::string> faults;
};

/// The cases that `paths` name: files as they are, readable or not, and all *.yaml files below
/// folders in the order of their labels, but for those in folders named `bad`, hidden ones, those
/// in hidden folders, and fit files. Links to folders are not followed; a link to a case is a case,
/// if that lies below the folder, too.
/// What cannot be searched is a fault and does not hide the rest.
Candidates find_candidates(std::span<const std::string> paths);

}  // namespace slipbench::driver::suite
