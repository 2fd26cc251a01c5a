// SPDX-License-Identifier: Apache-2.0
// Warnings, and what '--strict' makes of them.
#include <string>

#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A block on a rail, pressed by what `force` says.
std::string block(const std::string& force, const std::string& friction = "coefficient: 0.2, ",
                  const std::string& more = "") {
  return "slipbench: 1\ntitle: t\nunits: {length: mm, force: N, time: s}\n"
         "connector: {type: SLOT}\nfriction:\n  - {component: 1, contact_force: 3, " +
         friction +
         "stick: {stiffness: 100}}\n"
         "history:\n  - {step: a, increments: 3, motion: {CP1: {to: 6}}, force: {" +
         force + "}}\n" + more;
}

const std::string kNothingPresses =
    "friction 'friction1': nothing ever presses: its contact force is 0 all along, and so is its "
    "friction; look at the size and the sign of f3 in the history";

TEST_CASE("a warning after the run is told everywhere, and fails it under --strict") {
  const TemporaryFolder folder;
  folder.write("c.yaml", block("f3: 0"));
  const Ended plain = slipbench(folder, "run c.yaml");
  CHECK(plain.code == 0);
  CHECK(contains(plain.output, "  warning: " + kNothingPresses + "\n"));
  CHECK(contains(file_text(folder.path() / "c.json"), kNothingPresses));
  const Ended strict = slipbench(folder, "run c.yaml --strict");
  CHECK(strict.code == 1);
  CHECK(contains(strict.output, "  FAIL  1 warning under --strict\n"));
  CHECK(slipbench(folder, "report c.yaml -o c.html").code == 0);
  CHECK(contains(file_text(folder.path() / "c.html"), "nothing ever presses"));
  // What the warning says helps.
  folder.write("c.yaml", block("f3: 100"));
  CHECK(slipbench(folder, "run c.yaml --strict").code == 0);
}

TEST_CASE("under --strict a warning of reading a case stops it before anything is written") {
  const TemporaryFolder folder;
  folder.write("c.yaml", block("f3: 100", ""));
  const Ended plain = slipbench(folder, "run c.yaml");
  CHECK(plain.code == 0);
  CHECK(contains(file_text(folder.path() / "c.json"),
                 "friction[0]: no coefficient: this definition has no effect"));
  fs::remove(folder.path() / "c.json");
  fs::remove(folder.path() / "c.csv");
  const Ended strict = slipbench(folder, "run c.yaml --strict");
  CHECK(strict.code == 2);
  CHECK(contains(strict.output, "1 warning under --strict, nothing was run\n"));
  CHECK_FALSE(fs::exists(folder.path() / "c.json"));
  CHECK_FALSE(fs::exists(folder.path() / "c.csv"));
}

TEST_CASE("check tells what no passing check has settled") {
  const TemporaryFolder folder;
  folder.write("c.yaml", block("f3: 0"));
  const Ended none = slipbench(folder, "check c.yaml --json c.json");
  CHECK(none.code == 0);
  CHECK(contains(none.output, "  warning: c  " + kNothingPresses + "\n"));
  CHECK(
      contains(file_text(folder.path() / "c.json"), "\"warnings\": [\"" + kNothingPresses + "\"]"));
  const std::string check = "checks:\n  - {name: free, quantity: CSF1, against: {expression: \"= ";
  const std::string tolerance = "\"}, tolerance: {absolute: 1.0e-9, why: nothing presses}}\n";
  folder.write("c.yaml", block("f3: 0", "coefficient: 0.2, ", check + "0" + tolerance));
  CHECK_FALSE(contains(slipbench(folder, "check c.yaml").output, "nothing ever presses"));
  folder.write("c.yaml", block("f3: 0", "coefficient: 0.2, ", check + "20" + tolerance));
  CHECK(contains(slipbench(folder, "check c.yaml").output, kNothingPresses));
}

TEST_CASE("check --strict fails a case for each of its warnings, its checks or not") {
  const TemporaryFolder folder;
  folder.write("c.yaml", block("f3: 0"));
  const Ended strict = slipbench(folder, "check c.yaml --strict --junit c.xml");
  CHECK(strict.code == 1);
  CHECK(contains(strict.output, "  FAIL  c   warning: " + kNothingPresses + "\n"));
  CHECK(contains(strict.output, "0 cases passed, 1 failed"));
  CHECK(contains(file_text(folder.path() / "c.xml"), "failures=\"1\""));
  CHECK(slipbench(folder, "check c.yaml --strict --report c.html").code == 1);
  const std::string page = file_text(folder.path() / "c.html");
  CHECK(contains(page, "\"status\":\"failed\""));
  CHECK(contains(page, "\"failed\":1"));
}

TEST_CASE("check --strict of cases without a check fails in every file of verdicts") {
  const TemporaryFolder folder;
  folder.write("c.yaml", block("f3: 20"));
  CHECK(slipbench(folder, "check c.yaml --junit c.xml").code == 0);
  CHECK(contains(file_text(folder.path() / "c.xml"), "errors=\"0\""));
  const Ended strict =
      shell(folder, "GITHUB_ACTIONS=true GITHUB_STEP_SUMMARY=summary.md '" + kProgram +
                        "' check c.yaml --strict --junit c.xml --force");
  CHECK(strict.code == 1);
  constexpr const char* kNothing = "no case has a check; nothing was judged";
  CHECK(contains(strict.output, "::error file=c.yaml,title=c.yaml::" + std::string(kNothing)));
  CHECK(contains(file_text(folder.path() / "c.xml"), "errors=\"1\""));
  CHECK(contains(file_text(folder.path() / "c.xml"), kNothing));
  CHECK(contains(file_text(folder.path() / "summary.md"), "| not run | " + std::string(kNothing)));
}

}  // namespace
}  // namespace slipbench::driver::commands
