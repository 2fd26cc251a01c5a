// SPDX-License-Identifier: Apache-2.0
// Increments that go together must give the rows of increments one by one.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/read/read_case.hpp"
#include "driver/results/columns.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostIncrements = 600;

/// The numbers of all columns of a row, in text that tells every bit apart.
std::vector<std::string> numbers(const cases::Case& problem,
                                 const std::vector<results::Column>& columns, const Row& row) {
  std::vector<std::string> all{std::to_string(row.index), std::to_string(row.step),
                               std::to_string(row.pass)};
  const auto add = [&](double x) { all.push_back(base::format_number(x)); };
  for (const results::Column& column : columns) add(results::column_value(column, problem, row));
  for (const DefinitionRow& here : row.definitions) {
    for (const double x : {double{here.dissipation}, double{here.work}, here.lost,
                           here.update.onset, here.update.stored_energy, here.update.phi,
                           here.thresholds.unique, here.thresholds.smooth}) {
      add(x);
    }
    all.push_back(std::to_string(here.jumps) + (here.update.multiple_roots ? "several" : "one"));
  }
  return all;
}

/// Runs a case in both ways at once. Returns how many rows came together at most.
std::size_t compare(const cases::Case& problem) {
  auto one_by_one = Simulation::start(problem);
  auto together = Simulation::start(problem);
  REQUIRE(one_by_one.has_value() == together.has_value());
  if (!together) return 0;
  const std::vector<results::Column> columns = results::result_columns(problem);
  std::size_t most = 0;
  std::size_t done = 0;
  while (done < kMostIncrements) {
    const auto rows = together->advance_rows();
    for (const Row& row : rows ? *rows : std::span<const Row>()) {
      const auto advanced = one_by_one->advance();
      REQUIRE(advanced.has_value());
      REQUIRE(*advanced);
      REQUIRE(numbers(problem, columns, row) == numbers(problem, columns, one_by_one->row()));
    }
    if (rows && !rows->empty()) {
      most = std::max(most, rows->size());
      done += rows->size();
      CHECK(together->row().index == one_by_one->row().index);
      continue;
    }
    // The end, or the same failure.
    const auto advanced = one_by_one->advance();
    REQUIRE(advanced.has_value() == rows.has_value());
    if (rows) {
      CHECK_FALSE(*advanced);
    } else {
      CHECK(rows.error().message == advanced.error().message);
      CHECK(rows.error().step == advanced.error().step);
      CHECK(rows.error().kind == advanced.error().kind);
      // A failed run stays where it is.
      CHECK_FALSE(together->advance_rows());
    }
    break;
  }
  return most;
}

TEST_CASE("rows that come together are those of increments one by one, in all cases") {
  std::size_t compared = 0;
  std::size_t in_blocks = 0;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(fs::path(test::source_dir()) / "cases")) {
    if (entry.path().extension() != ".yaml") continue;
    if (entry.path().string().find("/bad/") != std::string::npos) continue;
    INFO(entry.path().string());
    const read::ReadCase read = read::read_case(entry.path().string(), {});
    if (!read.value || read.diagnostics.has_errors()) continue;
    ++compared;
    if (compare(*read.value) > 1) ++in_blocks;
  }
  CHECK(compared > 200);
  CHECK(in_blocks > 100);
}

}  // namespace
}  // namespace slipbench::driver::bench
