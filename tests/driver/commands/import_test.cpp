// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "driver/case/read_case.hpp"
#include "driver/exit_code.hpp"
#include "tests/driver/history/temporary_folder.hpp"
#include "tests/driver/radioss/deck_for_test.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

const std::string kBrake = "/FRICTION/7\nbrake\n" + options(0, 0, "", 2) + coulomb(".1");
const std::string kSeal = "/FRICTION/8\nseal\n" + options(0, 0, "", 2) + coulomb(".9");

/// A deck in a folder of its own, and where its case goes.
struct Import {
  explicit Import(const std::string& text) {
    options.deck = folder.write("d.rad", text).string();
    options.output = (folder.path() / "c.yaml").string();
  }
  TemporaryFolder folder;
  ImportOptions options;
};

TEST_CASE("An import writes a case that wants the values a deck does not have") {
  Import one(kBrake);
  one.options.units = "mm N s";
  REQUIRE(import_command(one.options) == kExitOk);
  const ReadCase read = read_case(
      one.options.output,
      {{{"K_t", 1e4}, {"normal_force", 100.0}, {"speed", 10.0}, {"time_step", 1e-4}}, false});
  INFO(render(read.diagnostics));
  REQUIRE(read.value);
  CHECK(read.value->units.force == "N");
  CHECK_FALSE(read_case(one.options.output).value);
}

TEST_CASE("Of several frictions one is chosen by its id") {
  Import two(kBrake + kSeal);
  CHECK(import_command(two.options) == kExitBadInput);
  CHECK_FALSE(fs::exists(two.options.output));
  two.options.id = 9;
  CHECK(import_command(two.options) == kExitBadInput);
  two.options.id = 8;
  CHECK(import_command(two.options) == kExitOk);
  CHECK(fs::exists(two.options.output));
}

TEST_CASE("A faulty deck leaves nothing behind") {
  for (const std::string& text : {std::string(), std::string("/BEGIN\nrun\n"),
                                  kBrake.substr(0, kBrake.size() / 2), std::string("\0\1", 2)}) {
    Import faulty(text);
    CHECK(import_command(faulty.options) == kExitBadInput);
    CHECK_FALSE(fs::exists(faulty.options.output));
  }
}

TEST_CASE("A deck that is not there, or would be overwritten, is the machine's fault") {
  Import missing(kBrake);
  const std::string deck = missing.options.deck;
  missing.options.deck = (missing.folder.path() / "other.rad").string();
  CHECK(import_command(missing.options) == kExitEnvironment);
  missing.options.deck = deck;
  missing.options.output = deck;
  CHECK(import_command(missing.options) == kExitEnvironment);
  CHECK(fs::file_size(deck) == kBrake.size());
}

TEST_CASE("Options of an import that mean nothing are refused") {
  Import one(kBrake);
  one.options.units = "mm N";
  CHECK(import_command(one.options) == kExitBadInput);
  one.options.units = "mm s N";
  CHECK(import_command(one.options) == kExitBadInput);
  one.options.units = "mm N s";
  one.options.normal = "0 0 0";
  CHECK(import_command(one.options) == kExitBadInput);
  CHECK_FALSE(fs::exists(one.options.output));
}

TEST_CASE("A direction along the contact's normal is FRIC009") {
  Import woven(kBrake + sides(0, 0, 1, 2, 1) + coulomb(".3") + coulomb(".2") +
               "/FRIC_ORIENT/1\nweave\n" + integers({0, 1}) + reals({"0", "0", "2"}));
  woven.options.normal = "0 0 1";
  CHECK(import_command(woven.options) == kExitBadInput);
  woven.options.normal = "0 1 1";
  CHECK(import_command(woven.options) == kExitOk);
}

}  // namespace
}  // namespace slipbench::driver
