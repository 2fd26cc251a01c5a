// SPDX-License-Identifier: Apache-2.0
// `slipbench bless` as its users meet it.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "tests/driver/commands/program_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBelt = R"(slipbench: 1
title: Guide
units: {length: mm, force: N, time: s}
parameters: {mu: 0.2}
connector: {type: SLOT}
friction:
  - component: 1
    internal_contact_force: 100
    coefficient: = mu
    stick: {stiffness: 1000}
history:
  - {step: cycle, duration: 1, increments: 40, repeat: 2, motion: {CP1: {sine: {amplitude: 0.1, period: 1}}}}
checks:
  - name: pull
    quantity: CSF1
    against: {curve: golden/belt.csv}
    tolerance: {absolute: 0.5, why: the liner's scatter}
  - name: loop
    quantity: CSF1
    against: {curve: golden/belt.csv, abscissa: CU1}
    criterion: loop_energy
    tolerance: {relative: 1.0e-3, why: the liner's scatter}
)";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST_CASE("a blessed case passes, a changed one fails, and passes once it is blessed again") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  const Ended before = slipbench(folder, "check belt.yaml");
  CHECK(before.code == 4);
  CHECK(
      contains(before.output, "belt.yaml:16:22: error: checks[0].against.curve: golden/belt.csv"));

  const Ended first = slipbench(folder, "bless belt.yaml --reason 'as measured in May'");
  INFO(first.output);
  CHECK(first.code == 0);
  CHECK(contains(first.output, "  golden/belt.csv: new, 81 rows, 3 columns\n"));
  CHECK(contains(first.output, "  check 'pull': no curve before, now 0\n"));
  const std::string blessed = file_text(folder.path() / "golden/belt.csv");
  CHECK(blessed.find("# slipbench golden curve\n# slipbench ") == 0);
  CHECK(contains(blessed, "# case: belt.yaml\n"));
  CHECK(contains(blessed, "# parameters: mu = 0.2\n"));
  CHECK(contains(blessed, "# columns: time [s], CSF1 [N], CU1 [mm]\n"));
  CHECK(contains(blessed, "# blessed: as measured in May\ntime,CSF1,CU1\n0,0,0\n"));
  CHECK(slipbench(folder, "check belt.yaml").code == 0);
  // Lines above the first, as a licence, leave it a golden curve: half of it does not pass.
  const std::string half = blessed.substr(0, blessed.find('\n', blessed.size() / 2) + 1);
  for (const char* above : {"", "\n", "  \n# SPDX-License-Identifier: Apache-2.0\n"}) {
    CAPTURE(above);
    folder.write("golden/belt.csv", above + blessed);
    CHECK(slipbench(folder, "check belt.yaml").code == 0);
    folder.write("golden/belt.csv", above + half);
    const Ended cut = slipbench(folder, "check belt.yaml");
    CHECK(cut.code == 1);
    CHECK(contains(cut.output, "were blessed"));
  }
  folder.write("golden/belt.csv", blessed);
  // No row number is compared with another: other increments, the same energy of a loop.
  CHECK(slipbench(folder, "check belt.yaml --set mu=0.2").code == 0);

  const Ended changed = slipbench(folder, "check belt.yaml --set mu=0.214");
  CHECK(changed.code == 1);
  CHECK(contains(changed.output, "check 'pull': CSF1 off by 1.4 N (limit 0.5) at t = 0.05"));
  CHECK(contains(changed.output, "check 'loop': energy of loop 1: "));

  const Ended again = slipbench(folder, "bless belt.yaml --set mu=0.214 --reason 'new liner'");
  INFO(again.output);
  CHECK(again.code == 0);
  CHECK(contains(again.output,
                 "  golden/belt.csv: replaced, 81 rows, 3 columns\n"
                 "    parameters were mu = 0.2\n"
                 "    parameters are  mu = 0.214\n"));
  CHECK(contains(again.output, "  check 'pull': was 2.8 of its tolerance (CSF1 off by 1.4 N"));
  CHECK(contains(file_text(folder.path() / "golden/belt.csv"),
                 "# blessed: new liner\n# blessed: as measured in May\ntime,"));
  CHECK(slipbench(folder, "check belt.yaml --set mu=0.214").code == 0);
  CHECK(files_in(folder.path() / "golden") == 1);
}

TEST_CASE("a curve that would not change is left alone, byte for byte") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  REQUIRE(slipbench(folder, "bless belt.yaml --reason one").code == 0);
  const std::string once = file_text(folder.path() / "golden/belt.csv");
  const Ended again = slipbench(folder, "bless belt.yaml --reason two");
  CHECK(again.code == 0);
  CHECK(contains(again.output, "golden/belt.csv: as it was, left alone"));
  CHECK(file_text(folder.path() / "golden/belt.csv") == once);
}

TEST_CASE("somebody else's reference is never overwritten") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  fs::create_directory(folder.path() / "golden");
  const std::string rig = "time,CSF1,CU1\n0,0,0\n1,1,1\n";
  folder.write("golden/belt.csv", rig);
  const Ended ended = slipbench(folder, "bless belt.yaml --reason x");
  CHECK(ended.code == 2);
  CHECK(contains(ended.output, "golden/belt.csv is no golden curve but somebody's reference"));
  CHECK(file_text(folder.path() / "golden/belt.csv") == rig);
}

TEST_CASE("a blessing needs a reason, a curve to bless and a case that runs") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  CHECK(slipbench(folder, "bless belt.yaml").code == 2);
  CHECK(slipbench(folder, "bless belt.yaml --reason ' '").code == 2);
  CHECK(slipbench(folder, "bless belt.yaml --reason x --set mu=-1").code == 2);
  CHECK(slipbench(folder, "bless none.yaml --reason x").code == 4);
  CHECK_FALSE(fs::exists(folder.path() / "golden"));
  std::string text = kBelt;
  text.resize(text.find("checks:"));
  folder.write("bare.yaml", text);
  const Ended bare = slipbench(folder, "bless bare.yaml --reason x");
  CHECK(bare.code == 2);
  CHECK(contains(bare.output, "no check is against a curve"));
}

TEST_CASE("a curve that would not pass against itself is not blessed") {
  const TemporaryFolder folder;
  std::string text = kBelt;
  // A curve that never leaves its initial slope has no breakaway.
  text.replace(text.find("criterion: loop_energy"), 22, "criterion: breakaway");
  text.replace(text.find("internal_contact_force: 100"), 27, "internal_contact_force: 1.0e9");
  folder.write("belt.yaml", text);
  const Ended ended = slipbench(folder, "bless belt.yaml --reason x");
  INFO(ended.output);
  CHECK(ended.code == 1);
  CHECK(contains(ended.output, "check 'loop' would not pass against today's own curve"));
  CHECK_FALSE(fs::exists(folder.path() / "golden/belt.csv"));
}

TEST_CASE("a full disk leaves the old curve as it was") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  REQUIRE(slipbench(folder, "bless belt.yaml --reason one").code == 0);
  const std::string once = file_text(folder.path() / "golden/belt.csv");
  // No file may grow: the system's message for what happens on a full disk.
  const Ended ended =
      slipbench(folder, "--version > /dev/null; trap '' XFSZ; ulimit -f 0; GCOV_PREFIX=counters '" +
                            kProgram + "' bless belt.yaml --set mu=0.3 --reason two");
  CHECK(ended.code == 4);
  CHECK(file_text(folder.path() / "golden/belt.csv") == once);
  CHECK(files_in(folder.path() / "golden") == 1);
}

TEST_CASE("a golden curve that was cut off behind its header is made anew") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  REQUIRE(slipbench(folder, "bless belt.yaml --reason one").code == 0);
  const std::string whole = file_text(folder.path() / "golden/belt.csv");
  folder.write("golden/belt.csv", whole.substr(0, whole.find("\ntime,")));
  const Ended ended = shell(folder, "timeout 60 '" + kProgram + "' bless belt.yaml --reason one");
  INFO(ended.output);
  CHECK(ended.code == 0);
  CHECK(file_text(folder.path() / "golden/belt.csv") == whole);
}

TEST_CASE("a golden curve that is a link stays one, and its file is replaced") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  REQUIRE(slipbench(folder, "bless belt.yaml --reason one").code == 0);
  fs::create_directory(folder.path() / "store");
  fs::rename(folder.path() / "golden/belt.csv", folder.path() / "store/belt.csv");
  fs::create_symlink("../store/belt.csv", folder.path() / "golden/belt.csv");
  // A link that leads out of golden/ stays inside the case's folder.
  REQUIRE(slipbench(folder, "bless belt.yaml --set mu=0.3 --reason two").code == 0);
  CHECK(fs::is_symlink(folder.path() / "golden/belt.csv"));
  CHECK(contains(file_text(folder.path() / "store/belt.csv"), "# blessed: two\n# blessed: one\n"));
}

TEST_CASE("blessings at the same time lose none of their reasons") {
  const TemporaryFolder folder;
  folder.write("belt.yaml", kBelt);
  const Ended ended =
      shell(folder, "for i in 1 2 3 4 5 6 7 8; do '" + kProgram +
                        "' bless belt.yaml --set mu=0.2$i --reason r$i & "
                        "done; wait; grep -c '^# blessed: r[1-8]$' golden/belt.csv");
  INFO(ended.output);
  CHECK(ended.output.ends_with("\n8\n"));
  CHECK(files_in(folder.path() / "golden") == 1);
}

TEST_CASE("a blessing that changes nothing leaves no folder behind") {
  const TemporaryFolder folder;
  std::string text = kBelt;
  for (std::size_t at = 0; (at = text.find("golden/belt.csv", at)) != std::string::npos; at += 20) {
    text.replace(at, 15, "deep/er/belt.csv");
  }
  text.replace(text.find("criterion: loop_energy"), 22, "criterion: breakaway");
  text.replace(text.find("internal_contact_force: 100"), 27, "internal_contact_force: 1.0e9");
  folder.write("belt.yaml", text);
  CHECK(slipbench(folder, "bless belt.yaml --reason x").code == 1);
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("a curve that does not fit into memory is the machine's fault, not a bug") {
  const TemporaryFolder folder;
  std::string text = kBelt;
  text.replace(text.find("increments: 40"), 14, "increments: 1000000000");
  folder.write("belt.yaml", text);
  const std::string limited = "ulimit -v 200000; '" + kProgram + "' ";
  if (shell(folder, limited + "--version").code != 0) return;  // a sanitizer needs more for itself
  const Ended ended = shell(folder, limited + "bless belt.yaml --reason x");
  CHECK(ended.code == 4);
  CHECK(ended.output == "slipbench: error: this needs more memory than there is\n");
  CHECK(files_in(folder.path()) == 1);
}

/// Returns what a command draws on a terminal before it is ended, up to a first bar or line of
/// progress.
std::string drawn(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) return "no terminal";
  const std::string name = ptsname(master);
  const pid_t child = fork();
  if (child == 0) {
    const int terminal = open(name.c_str(), O_RDWR | O_NOCTTY);
    const bool ready = terminal >= 0 && dup2(terminal, STDERR_FILENO) >= 0 &&
                       setenv("TERM", "xterm", 1) == 0 && chdir(folder.path().c_str()) == 0;
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (ready) execv(kProgram.c_str(), words.data());
    _exit(127);
  }
  std::string text;
  std::array<char, 256> piece{};
  constexpr int kPatience = 20000;  // milliseconds
  pollfd waiting{master, POLLIN, 0};
  while (!contains(text, "\033[K") && poll(&waiting, 1, kPatience) > 0) {
    const ssize_t n = ::read(master, piece.data(), piece.size());
    if (n <= 0) break;
    text.append(piece.data(), static_cast<std::size_t>(n));
  }
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
  close(master);
  return text;
}

TEST_CASE("long work shows how far it is, on a terminal") {
  const TemporaryFolder folder;
  std::string text = kBelt;
  text.replace(text.find("increments: 40"), 14, "increments: 1000000000");
  folder.write("belt.yaml", text);
  const std::string blessing = drawn(folder, {"slipbench", "bless", "belt.yaml", "--reason", "x"});
  if (blessing == "no terminal") return;
  CHECK(contains(blessing, "\rbelt: "));
  folder.write("long.yaml", text.substr(0, text.find("checks:")));
  const std::string report = drawn(folder, {"slipbench", "report", "long.yaml", "-o", "page.html"});
  CHECK(contains(report, "] 0 of 1 cases"));
  CHECK(contains(drawn(folder, {"slipbench", "run", "long.yaml", "--no-output"}), "\rlong: "));
  // Samples enough for some seconds.
  text = kBelt;
  folder.write("short.yaml", text.substr(0, text.find("checks:")));
  folder.write("sweep.yaml",
               "slipbench: 1\nsweep:\n  case: short.yaml\n  samples: 1000000\n"
               "  vary: {mu: {uniform: [0.1, 0.3]}}\n  collect: {work: {last: DISS}}\n");
  CHECK(contains(drawn(folder, {"slipbench", "sweep", "sweep.yaml"}), " of 1000000 samples"));
}

TEST_CASE("curves and criteria are listed and described") {
  const TemporaryFolder folder;
  const Ended curves = slipbench(folder, "list curves");
  CHECK(curves.code == 0);
  CHECK(contains(curves.output, "\n  dahl_loop "));
  const Ended criteria = slipbench(folder, "list criteria");
  CHECK(contains(criteria.output, "\n  loop_energy "));
  CHECK(contains(slipbench(folder, "describe loop_energy").output, "(criterion of a check)"));
  CHECK(contains(slipbench(folder, "describe dahl_loop").output, "Licence"));
  const Ended unknown = slipbench(folder, "describe dahl_lop");
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.output, "did you mean 'dahl_loop'?"));
}

}  // namespace
}  // namespace slipbench::driver::commands
