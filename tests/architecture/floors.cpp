// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/floors.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "tests/architecture/include_rules.hpp"

namespace slipbench::architecture {
namespace {

// A room knows the rooms before it. So a circle of rooms cannot be.
constexpr std::array<std::string_view, 37> kFloors{
    "law/base",         // names, components, conventions, small numerics
    "law/table",        // tables over up to several arguments
    "law/friction",     // the friction laws, a header each, and their list
    "law/contact",      // forces that press: contact, derived and internal ones
    "law/definition",   // what a friction definition is: limit, potential, formulation, state
    "law/component",    // elasticity and damping beside friction
    "law/connection",   // the connection types, a header each, and their list
    "law/update",       // the update over an increment, and its tangent
    "law/exact",        // the same, integrated within the increment
    "law/sensitivity",  // its derivatives by the numbers of a definition

    "driver/base/text",           // diagnostics, source texts, numbers, JSON, suggestions
    "driver/base/files",          // output files, paths, threads, exit codes
    "driver/base/units",          // units, expressions, parameters
    "driver/base/csv",            // CSV data of any program
    "driver/terminal",            // what is printed, and progress
    "driver/calibrate/fit",       // least squares and their statistics; knows nothing of friction
    "driver/calibrate/cleaning",  // measured rows, before they are compared
    "driver/import/radioss",      // /FRICTION blocks of a deck, as the text of a case
    "driver/yaml",                // nodes, and binding of declared keys; knows no key itself
    "driver/history",             // profiles, measured histories, the grid of a step
    "driver/case",                // what a case is, without its text
    "driver/bench",               // runs it
    "driver/results",             // columns, files and figures of a run
    "driver/check/curves",        // curves to compare with, and where they overlap
    "driver/check/criteria",      // a criterion each
    "driver/check",               // the checks of a case, and their verdicts
    "driver/read/keys",           // the declared keys, and what is said of them
    "driver/read/resolve",        // from keys to a case, a part of it each
    "driver/read",                // from a text to a case
    "driver/report",              // the page of a run
    "driver/plot",                // pictures
    "driver/suite",               // many cases, and what became of them
    "driver/analysis",            // explanations, convergence, comparisons of integration
    "driver/calibrate",           // fits of cases to measurements
    "driver/calibrate/report",    // the page and the pictures of a fit
    "driver/commands",            // what each command does
    "driver/cli",                 // its options, and main
};

std::string_view folder_of(std::string_view path) { return path.substr(0, path.rfind('/')); }

auto floor_of(std::string_view path) {
  return std::find(kFloors.begin(), kFloors.end(), folder_of(path));
}

bool has_floors(std::string_view path) {
  return path.starts_with("law/") || path.starts_with("driver/");
}

}  // namespace

std::span<const std::string_view> floors() { return kFloors; }

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
                          include.name + ": stands above " + std::string(*floor) +
                              ", which knows the rooms below it only"});
  }
  return violations;
}

}  // namespace slipbench::architecture
