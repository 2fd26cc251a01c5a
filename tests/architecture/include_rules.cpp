// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/include_rules.hpp"

#include <algorithm>
#include <regex>
#include <string>

namespace slipbench::architecture {
namespace {

/// Files whose path matches `files` may include what matches `allowed` and the standard library;
/// the first room that matches a file counts.
struct Room {
  std::regex files;
  std::regex allowed;
  std::string knows;
};

const std::vector<Room>& rooms() {
  static const std::vector<Room> kRooms{
      {std::regex("law/.*"), std::regex("(law|Eigen)/.*"), "law/ and Eigen"},
      {std::regex("reference/.*"), std::regex("reference/.*"), "reference/"},
      {std::regex("driver/.*"),
       std::regex("(law|reference|driver|Eigen|fmt|tl|yaml-cpp|CLI|gsl|minizip|sys)/"
                  ".*|muParser.*\\.h|udunits2\\.h|sha256\\.h|mpi\\.h|hdf5\\.h"
                  "|(unistd|fcntl|spawn|signal|poll|locale|malloc|dlfcn)\\.h"),
       "law/, reference/, driver/, its third parties and the system"},
      // Only the law stands behind slip_law.h; a text of a case is another library's.
      {std::regex("c/(slip_law|handle|fmu)\\..*"), std::regex("(c|law|Eigen)/.*"),
       "c/, law/ and Eigen"},
      {std::regex("c/.*"), std::regex("(c|law|driver)/.*"), "c/, law/ and driver/"},
      {std::regex("python/.*"), std::regex("(python|c|law|reference|driver|pybind11)/.*"),
       "python/, c/, law/, reference/, driver/ and pybind11"},
      {std::regex("live/.*"),
       std::regex("(live|law|reference|driver|fmt|tl)/.*|udunits2\\.h|units_table\\.inc"),
       "live/, law/, reference/, driver/, fmt, tl::expected and UDUNITS-2's header"},
      {std::regex("tests/law/.*"),
       std::regex("(law|reference|Eigen|catch2|tests/law|tests/support)/.*"),
       "law/, reference/, tests/law/, tests/support/, Eigen and Catch2"},
      {std::regex("tests/reference/.*"),
       std::regex("(reference|catch2|tests/reference|tests/support)/.*"),
       "reference/, tests/reference/, tests/support/ and Catch2"},
  };
  return kRooms;
}

/// A library that is known in one place of the rooms and the tests; the benchmarks may measure it.
struct ThirdParty {
  std::regex header;
  std::regex files;
  std::string place;
};

const std::vector<ThirdParty>& third_parties() {
  static const std::vector<ThirdParty> kThirdParties{
      {std::regex("yaml-cpp/.*"), std::regex("driver/yaml/.*\\.cpp"), "driver/yaml/*.cpp"},
      {std::regex("CLI/.*"), std::regex("driver/(cli|mpi)/.*\\.cpp"),
       "driver/cli/*.cpp, driver/mpi/*.cpp"},
      {std::regex("hdf5\\.h"), std::regex("driver/hdf5/.*"), "driver/hdf5/"},
      {std::regex("mpi\\.h"), std::regex("driver/mpi/.*"), "driver/mpi/"},
      {std::regex("muParser.*\\.h"), std::regex("driver/.*expression[^/]*\\.cpp"),
       "an expression .cpp of driver/"},
      {std::regex("udunits2\\.h"), std::regex("driver/.*units[^/]*\\.cpp|(tests/)?live/units/.*"),
       "a units .cpp of driver/, live/units/"},
      {std::regex("gsl/.*"), std::regex("driver/.*\\.cpp|tests/fuzz/fuzz_run\\.cpp"),
       "a .cpp of driver/, tests/fuzz/fuzz_run.cpp"},
      {std::regex("minizip/.*"), std::regex("driver/export/fmu/fmu_archive\\.cpp"),
       "driver/export/fmu/fmu_archive.cpp"},
      {std::regex("sha256\\.h"), std::regex("driver/base/files/sha256\\.cpp"),
       "driver/base/files/sha256.cpp"},
  };
  return kThirdParties;
}

/// The C++ standard headers are the ones without folder and extension.
bool is_standard(const Include& include) {
  static const std::regex kStandard("[a-z0-9_]+");
  return !include.quoted && std::regex_match(include.name, kStandard);
}

bool is_project(const std::string& name) {
  static const std::regex kProject("(law|reference|driver|c|live|python|tests|bench)/.*");
  return std::regex_match(name, kProject);
}

}  // namespace

std::vector<Include> includes(const SourceFile& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
  std::vector<Include> found;
  int number = 0;
  for (const std::string& line : lines(without_comments(file.text, Strings::kKeep))) {
    ++number;
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) {
      found.push_back({number, match[1] == "\"", match[2]});
    }
  }
  return found;
}

std::vector<Violation> include_violations(const SourceFile& file) {
  std::vector<Violation> violations;
  if (!is_cpp(file.path)) return violations;
  const auto room = std::find_if(rooms().begin(), rooms().end(), [&](const Room& candidate) {
    return std::regex_match(file.path, candidate.files);
  });
  for (const Include& include : includes(file)) {
    const auto report = [&](const std::string& message) {
      violations.push_back({file.path, include.line, include.name + ": " + message});
    };
    if (is_standard(include)) continue;
    if (include.quoted != is_project(include.name)) {
      report("project headers are included in quotes and from the root, all others in <>");
      continue;
    }
    if (room != rooms().end() && !std::regex_match(include.name, room->allowed)) {
      report("this room knows the standard library, " + room->knows + " only");
      continue;
    }
    if (file.path.starts_with("bench/")) continue;
    for (const ThirdParty& party : third_parties()) {
      if (std::regex_match(include.name, party.header) &&
          !std::regex_match(file.path, party.files)) {
        report("belongs to " + party.place + " only");
      }
    }
  }
  return violations;
}

}  // namespace slipbench::architecture
