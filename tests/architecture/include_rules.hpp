// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_file.hpp"

namespace slipbench::architecture {

/// An #include line; `line` is 1-based.
struct Include {
  int line = 0;
  bool quoted = false;
  std::string name;
};

/// The #include lines of a C++ text, those in comments left out.
std::vector<Include> includes(const SourceFile& file);

/// Checks who may know whom, read off the #include lines of a C++ file:
/// - law/ knows law/, Eigen and the standard library; reference/ knows reference/ and the standard
///   library; driver/ knows law/, reference/, driver/ and its third parties;
/// - a third party is known at one place: yaml-cpp in driver/yaml/*.cpp, CLI11 in driver/cli/*.cpp,
///   muParser in an expression .cpp, UDUNITS-2 in a units .cpp, GSL in a .cpp of driver/;
/// - the tests of law/ see law/ and reference/, those of reference/ see reference/ only;
/// - project headers are written in quotes and from the root.
/// Files that are not C++ have no violations.
std::vector<Violation> include_violations(const SourceFile& file);

}  // namespace slipbench::architecture
