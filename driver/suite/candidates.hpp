// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace slipbench::driver::suite {

/// A case of a suite: where it is, and what it is called in tables.
struct Candidate {
  std::string path;
  std::string label = {};    ///< the path without .yaml; below the folder if only one was named
  std::string fault = {};    ///< why it must not be read or searched, in a sentence; mostly empty
  bool is_searched = false;  ///< it was found in a folder

  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// The cases that `paths` name, each once: files as they are, readable or not, and all *.yaml files
/// below folders in the order of their labels, but for those in folders named `bad`, hidden ones,
/// those in hidden folders, fit and sweep files. A link to a case is a case. A link out of the
/// folder, unless its target is named too, a folder that cannot be read, and one of several that
/// has no case, are cases with a fault.
/// A link to a folder inside is passed by: that is searched anyway, or the link has a fault.
///
/// \param allow_outside takes a link to a file out of the folder as a case, and passes by one to a
///   folder, which holds what the cases need
std::vector<Candidate> find_candidates(std::span<const std::string> paths,
                                       bool allow_outside = false);

}  // namespace slipbench::driver::suite
