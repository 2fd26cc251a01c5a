// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/export.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "driver/analysis/response.hpp"
#include "driver/base/files/exit_code.hpp"
#include "driver/commands/import.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// A sleeve with a table of two independents in another order than Abaqus has, wear and a spring.
const std::string kSleeve =
    "slipbench: 1\ntitle: sleeve\nparameters: {third: = 1/3}\nconnector: {type: CYLINDRICAL}\n"
    "friction:\n"
    "  - name: lining\n"
    "    predefined: {R: 0.24, L: 0.55, internal_contact_force: {columns: [F, accumulated_slip], "
    "rows: [[100, 0], [= 280*third, 2]]}}\n"
    "    coefficient: {columns: [mu, temperature, slip_rate], rows: [[0.3, 0, 0], [0.2, 100, 0], "
    "[0.1, 0, 50], [0.05, 100, 50]]}\n"
    "    force_limit: 33\n"
    "    stick: {stiffness: 1000}\n"
    "elasticity: [{component: 1, columns: [force, displacement], rows: [[-3, -1], [0, 0], [7, "
    "2]]}]\n"
    "history:\n"
    "  - {step: press, duration: 2, increments: 20, motion: {CP1: {to: 0.4}}, force: {f2: {to: "
    "30}, "
    "m3: 2}, temperature: 20}\n"
    "  - {step: turn, increments: 40, repeat: 2, motion: {CPR1: {sine: {amplitude: 0.3, period: "
    "1}}}}\n";

struct Export {
  TemporaryFolder folder;
  ExportCommandOptions options;

  explicit Export(const std::string& text = kSleeve) {
    options.file = folder.write("c.yaml", text).string();
    options.deck.to = "abaqus";
    options.deck.output = (folder.path() / "c.inp").string();
  }
  std::string deck() const { return file_text(options.deck.output); }
  cases::Case read(const std::string& file) const {
    read::ReadCase read = read::read_case(file);
    INFO(base::render(read.diagnostics, read.sources));
    REQUIRE(read.value);
    return std::move(*read.value);
  }
  /// The case that is made of the deck.
  cases::Case back() const {
    ImportOptions import;
    import.deck = options.deck.output;
    import.output = (folder.path() / "back.yaml").string();
    import.force = true;
    REQUIRE(import_command(import) == base::kExitOk);
    return read(import.output);
  }
};

TEST_CASE("A case comes back from its deck with its response") {
  Export one;
  REQUIRE(export_command(one.options) == base::kExitOk);
  CHECK_THAT(one.deck(), Catch::Contains("** Name: lining\n*CONNECTOR FRICTION, CONTACT FORCE=") &&
                             Catch::Contains("TAUMAX=33") &&
                             Catch::Contains("0.3, 0, , 0\n0.1, 50, , 0\n0.2, 0, , 100\n"));
  const auto difference = analysis::compare_responses(one.read(one.options.file), one.back());
  REQUIRE(difference.has_value());
  CHECK(difference->unmatched == 0);
  CHECK(difference->force.largest == Approx(33.0));
  CHECK(difference->force.most < 1e-10);
}

TEST_CASE("Digits of the behaviour are rounded for people, and the history keeps its own") {
  Export one;
  one.options.deck.digits = 2;
  REQUIRE(export_command(one.options) == base::kExitOk);
  CHECK_THAT(one.deck(), Catch::Contains("\n93, 2\n"));
  const auto difference = analysis::compare_responses(one.read(one.options.file), one.back());
  REQUIRE(difference.has_value());
  CHECK(difference->unmatched == 0);
  CHECK(difference->force.most > 1e-4);
  CHECK(difference->force.most < 0.3);
  CHECK_THAT(analysis::difference_text(*difference),
             Catch::Contains("friction force off by at most 0."));
}

TEST_CASE("A part of a deck is the behaviour alone") {
  Export one;
  one.options.deck.part = "behaviour";
  REQUIRE(export_command(one.options) == base::kExitOk);
  CHECK(one.deck().starts_with("*CONNECTOR BEHAVIOR, NAME=JOINT\n"));
  CHECK(one.deck().find("*STEP") == std::string::npos);
}

TEST_CASE("A case that Abaqus has no word for leaves no deck") {
  std::string text = kSleeve;
  text += "dead_zone: [{component: 1, width: 0.1}]\n";
  Export one(text);
  CHECK(export_command(one.options) == base::kExitBadInput);
  CHECK_FALSE(fs::exists(one.options.deck.output));
  Export there;
  there.folder.write("c.inp", "somebody's deck\n");
  CHECK(export_command(there.options) == base::kExitEnvironment);
  CHECK(there.deck() == "somebody's deck\n");
}

TEST_CASE("Lines of a deck have eight items and numbers twenty characters") {
  Export one;
  REQUIRE(export_command(one.options) == base::kExitOk);
  std::istringstream lines(one.deck());
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("*") || line.find_first_of("0123456789") == std::string::npos) continue;
    std::istringstream items(line);
    int count = 0;
    for (std::string item; std::getline(items, item, ',');) {
      CHECK(item.find_last_not_of(' ') - item.find_first_not_of(' ') < 20);
      ++count;
    }
    CHECK(count <= 8);
  }
}

}  // namespace
}  // namespace slipbench::driver::commands
