// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// A sweep that takes some seconds of one core.
void write_sweep(const TemporaryFolder& folder, int samples, int increments) {
  folder.write(
      "slot.yaml",
      "slipbench: 1\nunits: {length: mm, force: N, time: s}\nparameters: {mu: 0.2, k: 1000, way: "
      "0.1}\n"
      "connector: {type: SLOT}\n"
      "friction: [{predefined: {}, coefficient: = mu, stick: {stiffness: = k}}]\n"
      "history: [{step: go, increments: " +
          std::to_string(increments) + ", motion: {CP1: {to: = way}}, force: {f2: 100}}]\n");
  folder.write("s.yaml",
               "slipbench: 1\nsweep:\n  case: slot.yaml\n  samples: " + std::to_string(samples) +
                   "\n  vary: {mu: {uniform: [0.1, 0.3]}, k: {uniform: [100, 1000]}}\n"
                   "  collect: {end: {last: CSF1}, most: {max: '= 2*CSF1'}}\n");
}

TEST_CASE("An interrupted sweep says how to go on, and goes on to the same bytes") {
  const TemporaryFolder folder;
  write_sweep(folder, 400, 20'000);
  // The journal has some records when the interruption comes.
  const Ended cut = shell(
      folder,
      "mkdir out; : > out/s.journal; '" + kProgram +
          "' sweep s.yaml -o out -j 1 --set way=0.2 & "
          "until [ $(stat -c %s out/s.journal) -gt 1500 ]; do :; done; kill -INT $!; wait $!; "
          "echo code $?");
  INFO(cut.output);
  REQUIRE(cut.output.find("code 130\n") != std::string::npos);
  CHECK(cut.output.find("slipbench: interrupted; what was run is kept in out/s.journal, and this "
                        "goes on:\n  slipbench sweep s.yaml -o out --set way=0.2 -j 1\n") !=
        std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "out/s.csv"));
  // With another value it is no journal of this sweep.
  const Ended other = slipbench(folder, "sweep s.yaml -o out --set way=0.3");
  CHECK(other.code == 4);
  CHECK(other.output ==
        "slipbench: error: out/s.journal: is of another state of this sweep: an input, a setting "
        "or the program has changed since; --force begins anew\n");
  fs::resize_file(folder.path() / "out/s.journal",
                  fs::file_size(folder.path() / "out/s.journal") - 1);
  const Ended rest = slipbench(folder, "sweep s.yaml -o out --set way=0.2");
  INFO(rest.output);
  CHECK(rest.code == 0);
  CHECK(rest.output.find(" of the samples from the run before") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "out/s.journal"));
  CHECK(slipbench(folder, "sweep s.yaml -o whole --set way=0.2 -j 2").code == 0);
  CHECK(shell(folder, "cmp out/s.csv whole/s.csv").code == 0);
}

TEST_CASE("merge joins the parts of a folder, or says what is missing") {
  const TemporaryFolder folder;
  write_sweep(folder, 300, 100);
  const Ended whole = slipbench(folder, "sweep s.yaml -o whole");
  REQUIRE(whole.code == 0);
  for (const char* part : {"1/3", "3/3"}) {
    REQUIRE(slipbench(folder, std::string("sweep s.yaml -o out --part ") + part).code == 0);
  }
  Ended merged = slipbench(folder, "merge s.yaml -o out");
  CHECK(merged.code == 2);
  CHECK(merged.output ==
        "slipbench: error: s.yaml: the parts are not all: missing are samples 100 to 199: part "
        "2/3\n");
  REQUIRE(slipbench(folder, "sweep s.yaml -o out --part 2/3").code == 0);
  merged = slipbench(folder, "merge s.yaml -o out");
  INFO(merged.output);
  CHECK(merged.code == 0);
  CHECK(shell(folder, "cmp out/s.csv whole/s.csv").code == 0);
  // The same is told, too, but for how the samples came.
  CHECK(merged.output.find("s: 300 samples of slot.yaml, joined from 3 parts\n") == 0);
  const auto lines = [](const std::string& text) {
    return text.substr(text.find('\n'), text.find("s.csv\n") - text.find('\n'));
  };
  const auto told = [&](const Ended& ended, const std::string& at) {
    const std::string text = lines(ended.output);
    return text.substr(0, text.rfind(at));
  };
  CHECK(told(merged, "out/") == told(whole, "whole/"));
  CHECK(told(merged, "out/").find("correlation with") != std::string::npos);
  CHECK(shell(folder, "cmp out/s.json whole/s.json").code == 0);
  CHECK(slipbench(folder, "merge s.yaml -o out --set way=0.3").output ==
        "slipbench: error: out/s.1of3.csv: is of another state of this sweep: an input, a setting "
        "or the program has changed since\n");
  CHECK(slipbench(folder, "merge s.yaml -o whole").code == 2);
}

}  // namespace
}  // namespace slipbench::driver::commands
