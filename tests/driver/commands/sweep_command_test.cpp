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

TEST_CASE("merge says of samples without a number what the whole run says") {
  const TemporaryFolder folder;
  write_sweep(folder, 40, 20);
  folder.write("s.yaml",
               "slipbench: 1\nsweep:\n  case: slot.yaml\n  samples: 40\n"
               "  vary: {mu: {normal: [0.1, 0.2]}}\n"
               "  collect: {fp: {first_passage: {of: CSF1, above: 18}}}\n");
  const Ended whole = slipbench(folder, "sweep s.yaml -o whole");
  CHECK(whole.code == 3);
  for (const char* part : {"1/2", "2/2"}) {
    slipbench(folder, std::string("sweep s.yaml -o out --part ") + part);
  }
  const Ended merged = slipbench(folder, "merge s.yaml -o out");
  CHECK(merged.code == 3);
  CHECK(merged.output.find("no value in") != std::string::npos);
  CHECK(shell(folder, "cmp out/s.csv whole/s.csv && cmp out/s.json whole/s.json").output.empty());
}

TEST_CASE("what was set for a whole sweep is told, and part of the commands on its page") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "sub");
  write_sweep(folder, 8, 10);
  fs::rename(folder.path() / "slot.yaml", folder.path() / "sub/my slot.yaml");
  folder.write("s.yaml",
               "slipbench: 1\nsweep:\n  case: sub/my slot.yaml\n  samples: 8\n"
               "  vary: {mu: {uniform: [0.1, 0.3]}}\n  collect: {end: {last: CSF1}}\n");
  CHECK(slipbench(folder, "sweep s.yaml -o plain").code == 0);
  CHECK(file_text(folder.path() / "plain/s.csv").find("# set:") == std::string::npos);
  CHECK(slipbench(folder, "sweep s.yaml -o out --set way=0.05 --set k=500 --report p.html").code ==
        0);
  CHECK(file_text(folder.path() / "out/s.csv").find("\n# set: way=0.05, k=500\n") !=
        std::string::npos);
  CHECK(file_text(folder.path() / "out/s.json").find("\"set\": \"way=0.05, k=500\"") !=
        std::string::npos);
  const std::string page = file_text(folder.path() / "p.html");
  CHECK(page.find("8 samples of my slot.yaml with way=0.05, k=500") != std::string::npos);
  // The command of an extreme runs, with what was set.
  const std::string begin = "<code>slipbench ";
  const std::size_t at = page.find(begin);
  REQUIRE(at != std::string::npos);
  std::string command = page.substr(at + begin.size(), page.find('<', at + 1) - at - begin.size());
  for (const std::string quote : {"&#39;", "&#x27;", "&apos;"}) {
    for (std::size_t q = 0; (q = command.find(quote)) != std::string::npos;) {
      command.replace(q, quote.size(), "'");
    }
  }
  INFO(command);
  CHECK(command.starts_with("run 'sub/my slot.yaml' --set way=0.05 --set k=500 --set mu="));
  CHECK(slipbench(folder, command + " -o one").code == 0);
  CHECK(file_text(folder.path() / "one/my slot.csv").find("way = 0.05") != std::string::npos);
}

TEST_CASE("a file of samples that states other units is refused, and rows left out are told") {
  const TemporaryFolder folder;
  write_sweep(folder, 8, 10);
  const std::string begin =
      "slipbench: 1\nsweep:\n  case: slot.yaml\n  collect: {end: {last: CSF1}}\n  csv: ";
  folder.write("s.yaml", begin + "{file: d.csv, units_row: true}\n");
  folder.write("d.csv", "mu,k\n-,kN/mm\n0.15,1\n0.2,2\n");
  const Ended refused = slipbench(folder, "sweep s.yaml -o out");
  CHECK(refused.code == 2);
  CHECK(refused.output.find("d.csv states column 'k' in kN/mm, and a sample is read in the case's "
                            "units; convert the column, and leave its unit out of the file") !=
        std::string::npos);
  folder.write("d.csv", "mu,k\n-,-\n0.15,100\n0.2,\n0.25,300\n");
  folder.write("s.yaml", begin + "{file: d.csv, units_row: true, missing: skip}\n");
  const Ended skipped = slipbench(folder, "sweep s.yaml -o out");
  CHECK(skipped.code == 0);
  CHECK(skipped.output.find("note: sweep.csv: d.csv: 1 row was left out") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::commands
