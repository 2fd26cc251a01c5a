// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace slipbench::driver::suite {

/// A case of a suite: where it is, and what it is called in tables.
struct Candidate {
  std::string path;
  std::string label;       ///< the path without .yaml; below the folder if only one was named
  std::string fault = {};  ///< why it must not be read or searched, in a sentence; mostly empty

  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// The cases that `paths` name, each once: files as they are, readable or not, and all *.yaml files
/// below folders in the order of their labels, but for those in folders named `bad`, hidden ones,
/// those in hidden folders, fit and sweep files. A link to a case is a case. What leads out of the
/// folder, and a folder that cannot be read, are cases with a fault: neither is passed by in
/// silence. Links to folders inside are, they are searched anyway. \param allow_outside takes a
/// link to a case out of the folder as a case, and one to a folder as
///        what its cases need
std::vector<Candidate> find_candidates(std::span<const std::string> paths,
                                       bool allow_outside = false);

/// Tells whether one of these paths is a folder, which is searched.
bool names_folder(std::span<const std::string> paths);

}  // namespace slipbench::driver::suite
