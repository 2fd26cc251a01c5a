// SPDX-License-Identifier: Apache-2.0
// More increments than memory, disk or patience.
#include <string>

#include "driver/commands/outlook.hpp"
#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A block that is driven to and fro in 1e9 increments.
std::string endless(const std::string& more = "") {
  return "slipbench: 1\ntitle: t\nunits: {length: mm, force: N, time: s}\n"
         "connector: {type: SLOT}\nfriction:\n"
         "  - {component: 1, internal_contact_force: 100, coefficient: 0.2, stick: {stiffness: "
         "1000}}\nhistory:\n"
         "  - {step: a, duration: 100, increments: 1000000000, motion: {CP1: {sine: {amplitude: 1, "
         "period: 1}}}}\n" +
         more;
}

std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {}));
}

TEST_CASE("the line of a long run tells the part that is done and the time left") {
  CHECK(run_progress_text(65536, 0.25, 3.0) == "25 %, 65536 increments, 9 s left");
  CHECK(run_progress_text(65536, 0.01, 100.0) == "1 %, 65536 increments, 2.8 h left");
  CHECK(run_progress_text(65536, 0.0, 3.0) == "0 %, 65536 increments");
}

TEST_CASE("a run of 1e9 increments says what it takes, and ends on Ctrl-C without a trace") {
  const TemporaryFolder folder;
  folder.write("c.yaml", endless());
  // Ctrl-C as soon as it has said so, or after 20 s without.
  const Ended ended =
      shell(folder, "'" + kProgram +
                        "' run c.yaml --every 1000000 > told.txt 2>&1 & n=0; "
                        "until grep -q behind told.txt || [ $n = 400 ]; "
                        "do sleep 0.05; n=$((n + 1)); done; "
                        "kill -INT $!; wait $!; code=$?; cat told.txt; rm told.txt; exit $code");
  CHECK(ended.code == 130);
  CHECK(contains(ended.output, "c: 1e+09 increments take some "));
  CHECK(contains(ended.output,
                 "('output: {every: N}' writes fewer rows, Ctrl-C leaves nothing behind)\n"));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("rows that the disk has no room for are not begun in earnest") {
  const TemporaryFolder folder;
  // Some 250 bytes a row: 1e9 passes make 2.5e20 bytes.
  folder.write("c.yaml", endless());
  std::string text = file_text(folder.path() / "c.yaml");
  text.replace(text.find("duration"), 0, "repeat: 1000000000, ");
  folder.write("c.yaml", text);
  const Ended ended = slipbench(folder, "run c.yaml");
  CHECK(ended.code == 4);
  CHECK(contains(ended.output, "c.yaml: error: the rows of c would take some "));
  CHECK(contains(ended.output,
                 " are free in .; write fewer rows ('output: {every: N}' or '--every N'), fewer "
                 "columns ('output: {columns: [..]}') or '--no-output'\n"));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("checks that keep more rows than there is memory for are refused before the run") {
  const TemporaryFolder folder;
  folder.write("c.yaml", endless("checks:\n  - {name: loop, quantity: CSF1, criterion: peak, "
                                 "against: {expression: \"= 20\"}, tolerance: {relative: 0.1, why: "
                                 "w}}\n"));
  const std::string told =
      "check 'loop' keeps the rows it compares: 1e+09 rows need at least 33 GB of memory, and 1 GB "
      "are free; compare fewer ('step: ..' or 'over: {from: .., to: ..}') or take fewer "
      "increments\n";
  const std::string limited = "ulimit -v 1000000 && '" + kProgram + "' ";
  // Under the address sanitizer, which reserves terabytes of addresses, nothing starts.
  if (shell(folder, limited + "--version").code != 0) return;
  for (const char* command : {"run --no-output", "check", "plot --as residuals -o c.svg"}) {
    const Ended ended = shell(folder, limited + command + " c.yaml");
    INFO(command << ": " << ended.output);
    CHECK(ended.code == 4);
    CHECK(contains(ended.output, told));
  }
}

}  // namespace
}  // namespace slipbench::driver::commands
