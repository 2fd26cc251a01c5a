// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/floors.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string>

#include "tests/architecture/include_rules.hpp"

namespace slipbench::architecture {
namespace {

// A room knows the rooms before it. So a circle of rooms cannot be. Beside it its namespace: the
// law is one, and so are rooms of one folder but for those that know nothing of the rest; `case` is
// no name in C++.
// clang-format off
constexpr std::array kFloors{
    Room{"law/base",                 "law"},               // names, components, conventions, small numerics
    Room{"law/table",                "law"},               // tables over up to several arguments
    Room{"law/friction",             "law"},               // the friction laws, a header each, and their list
    Room{"law/contact",              "law"},               // forces that press: contact, derived and internal ones
    Room{"law/definition",           "law"},               // what a friction definition is: limit, potential, formulation, state
    Room{"law/component",            "law"},               // elasticity and damping beside friction
    Room{"law/connection",           "law"},               // the connection types, a header each, and their list
    Room{"law/update",               "law"},               // the update over an increment, and its tangent
    Room{"law/batch",                "law"},               // the update of many definitions at once
    Room{"law/exact",                "law"},               // the same, integrated within the increment
    Room{"law/sensitivity",          "law"},               // its derivatives by the numbers of a definition

    Room{"driver/base/text",         "driver::base"},      // diagnostics, source texts, numbers, JSON, suggestions
    Room{"driver/base/files",        "driver::base"},      // output files, paths, threads, exit codes
    Room{"driver/base/units",        "driver::base"},      // units, expressions, parameters
    Room{"driver/base/csv",          "driver::base"},      // CSV data of any program
    Room{"driver/table",             "driver::table"},     // tables of results in files: CSV, npy, HDF5
    Room{"driver/hdf5",              "driver::table"},     // the plug-in for HDF5
    Room{"driver/terminal",          "driver::terminal"},  // what is printed, and progress
    Room{"driver/calibrate/fit",     "driver::fit"},       // least squares and their statistics; knows nothing of friction
    Room{"driver/calibrate/cleaning","driver::cleaning"},  // measured rows, before they are compared
    Room{"driver/import",            "driver::import"},    // whose deck a file is, and its texts
    Room{"driver/import/contact",    "driver::import"},    // the text of a case of a contact, whatever program its friction is of
    Room{"driver/import/radioss",    "driver::radioss"},   // friction of a Radioss deck
    Room{"driver/import/lsdyna",     "driver::lsdyna"},    // friction of an LS-DYNA deck
    Room{"driver/import/opensees",   "driver::opensees"},  // friction models of an OpenSees script
    Room{"driver/yaml",              "driver::yaml"},      // nodes, and binding of declared keys; knows no key itself
    Room{"driver/history",           "driver::history"},   // profiles, measured histories, the grid of a step
    Room{"driver/case",              "driver::cases"},     // what a case is, without its text
    Room{"driver/bench",             "driver::bench"},     // runs it
    Room{"driver/results",           "driver::results"},   // columns, files and figures of a run
    Room{"driver/check/curves",      "driver::check"},     // curves to compare with, and where they overlap
    Room{"driver/check/criteria",    "driver::check"},     // a criterion each
    Room{"driver/check",             "driver::check"},     // the checks of a case, and their verdicts
    Room{"driver/read/keys",         "driver::read"},      // the declared keys, and what is said of them
    Room{"driver/read/resolve",      "driver::read"},      // from keys to a case, a part of it each
    Room{"driver/read",              "driver::read"},      // from a text to a case
    Room{"driver/import/abaqus",     "driver::abaqus"},    // connectors of an Abaqus deck, as the text of a case
    Room{"driver/export",            "driver::exports"},   // what a deck cannot hold, and its numbers
    Room{"driver/export/abaqus",     "driver::exports"},   // a case as an Abaqus deck
    Room{"driver/export/contact",    "driver::exports"},   // its friction as programs state that of a contact
    Room{"driver/report",            "driver::report"},    // the page of a run
    Room{"driver/export/fmu",        "driver::exports"},   // a case as a functional mock-up unit, and the numbers of its law
    Room{"driver/plot",              "driver::plot"},      // pictures
    Room{"driver/suite",             "driver::suite"},     // many cases, and what became of them
    Room{"driver/analysis",          "driver::analysis"},  // explanations, convergence, comparisons of integration
    Room{"driver/sweep",             "driver::sweep"},     // runs of one case with other parameters
    Room{"driver/sweep/report",      "driver::sweep"},     // the page of a sweep
    Room{"driver/farm",              "driver::farm"},      // sweeps shared out to many programs
    Room{"driver/calibrate",         "driver::calibrate"}, // fits of cases to measurements
    Room{"driver/calibrate/report",  "driver::calibrate"}, // the page and the pictures of a fit
    Room{"driver/commands",          "driver::commands"},  // what each command does
    Room{"driver/cli",               "driver::cli"},       // its options, and main
    Room{"driver/mpi",               "driver::mpi"},       // the farm of MPI ranks, a program of its own
};
// clang-format on

std::string_view folder_of(std::string_view path) { return path.substr(0, path.rfind('/')); }

auto floor_of(std::string_view path) {
  return std::find_if(kFloors.begin(), kFloors.end(),
                      [&](const Room& room) { return room.folder == folder_of(path); });
}

bool has_floors(std::string_view path) {
  return path.starts_with("law/") || path.starts_with("driver/");
}

}  // namespace

std::span<const Room> floors() { return kFloors; }

std::vector<Violation> floor_violations(const SourceFile& file) {
  if (!is_cpp(file.path) || !has_floors(file.path)) return {};
  const auto floor = floor_of(file.path);
  if (floor == kFloors.end()) {
    return {{file.path, 0, "stands in no room of tests/architecture/floors.cpp"}};
  }
  std::vector<Violation> violations;
  for (const Include& include : includes(file)) {
    if (!include.quoted || !has_floors(include.name) || floor_of(include.name) <= floor) continue;
    violations.push_back({file.path, include.line,
                          include.name + ": stands above " + std::string(floor->folder) +
                              ", which knows the rooms below it only"});
  }
  return violations;
}

std::vector<Violation> namespace_violations(const SourceFile& file) {
  if (!is_cpp(file.path) || !has_floors(file.path)) return {};
  const auto floor = floor_of(file.path);
  if (floor == kFloors.end()) return {};  // floor_violations tells
  static const std::regex kOpened("namespace slipbench::([a-z_:]+) \\{.*");
  std::vector<Violation> violations;
  std::istringstream text(file.text);
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    std::smatch opened;
    if (!std::regex_match(line, opened, kOpened)) continue;
    const auto is_opened = [&](const Room& room) {
      return opened[1].str() == room.name ||
             opened[1].str().starts_with(std::string(room.name) + "::");
    };
    if (std::none_of(kFloors.begin(), floor + 1, is_opened)) {
      violations.push_back({file.path, number,
                            "namespace slipbench::" + opened[1].str() +
                                " is neither that of the room, slipbench::" +
                                std::string(floor->name) + ", nor of one below it"});
    }
  }
  return violations;
}

}  // namespace slipbench::architecture
