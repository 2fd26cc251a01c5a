// SPDX-License-Identifier: Apache-2.0
// The program as its users meet it: what is typed, what is written, how it ends.
#include <signal.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/driver/commands/program_for_test.hpp"
#include "tests/driver/support/environment_for_test.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSlider = R"(slipbench: 1
title: Slider
units: {length: mm, force: N, time: s}
parameters: {mu: 0.2}
connector: {type: SLOT}
friction:
  - predefined: {}
    coefficient: = mu
    stick: {stiffness: 1000}
history:
  - {step: slide, duration: 1, increments: 10, motion: {CP1: {to: 0.1}}, force: {f2: 100}}
checks:
  - name: force
    quantity: CSF1
    against: {closed_form: coulomb_slider, with: {mu: 0.2, normal_force: 100, stick_stiffness: 1000}, inputs: {motion: CU1}, output: force}
    tolerance: {relative: 1.0e-12, why: rounding}
)";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("run --explain tells why and writes nothing") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  const Ended ended = slipbench(folder, "run slider.yaml --explain 0.55");
  INFO(ended.output);
  CHECK(ended.code == 0);
  CHECK(contains(ended.output, "the first increment that ends at or after t = 0.55 s\n"));
  CHECK(contains(ended.output, "  limit 20.0 = mu 0.2 x F_N 100.0\n"));
  CHECK(contains(ended.output, "  slipping since t = 0.2 s\n"));
  CHECK(file_count(folder.path()) == 1);
  const Ended outside = slipbench(folder, "run slider.yaml --explain 1.5");
  CHECK(outside.code == 2);
  CHECK(contains(outside.output, "--explain 1.5: slider runs from t = 0 to t = 1\n"));
}

TEST_CASE("run --solver-report judges the tangents and writes them") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  const Ended ended = slipbench(folder, "run slider.yaml --solver-report");
  INFO(ended.output);
  CHECK(ended.code == 0);
  CHECK(contains(ended.output,
                 "an implicit solver will want its unsymmetric scheme: the contact "
                 "force follows the constraint forces 0.2\n"));
  const std::string rows = file_text(folder.path() / "slider.solver.csv");
  CHECK(contains(rows,
                 "\nt,duration,asymmetry,by_position,by_rate,force_coupling,snap_back,"
                 "unique_increment,smooth_increment,several_solutions\n0.1,0.1,0,0,0,0,0,0,"
                 "0,0\n"));
  CHECK(contains(rows, "\n1,0.09999999999999998,0,0,0,0.2,0,0,0,0\n"));
  const Ended silent = slipbench(folder, "run slider.yaml --solver-report --no-output -o .");
  CHECK(contains(silent.output, "  solver: tangent to the motion symmetric"));
}

TEST_CASE("run writes three files and tells what happened") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  const Ended ended = slipbench(folder, "run slider.yaml");
  INFO(ended.output);
  CHECK(ended.code == 0);
  CHECK(contains(ended.output, "slider: 10 increments, "));
  CHECK(contains(ended.output, "first slip at t = 0.2 s (CP1 = 0.02 mm) at 20.0 N"));
  CHECK(contains(ended.output, "  PASS  check 'force': worst "));
  CHECK(contains(ended.output, "  slider.csv  slider.events.csv  slider.json\n"));
  CHECK(file_count(folder.path()) == 4);
  const std::string rows = file_text(folder.path() / "slider.csv");
  CHECK(contains(rows, "\n1,0.1,0.1,0.1,"));
  CHECK(contains(file_text(folder.path() / "slider.json"), "\"stick_slip_events\": 1,"));

  slipbench(folder, "run slider.yaml");
  CHECK(file_text(folder.path() / "slider.csv") == rows);
}

TEST_CASE("a parameter can be set, and a failed check is exit code 1") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  const Ended ended = slipbench(folder, "run slider.yaml --set mu=0.25 --no-output");
  INFO(ended.output);
  CHECK(ended.code == 1);
  CHECK(contains(ended.output, "FAIL  check 'force': CSF1 off by 5 N (limit 2e-11) at t = 0.3"));
  CHECK(file_count(folder.path()) == 1);
}

TEST_CASE("The option --every keeps the first and the last row") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  CHECK(slipbench(folder, "run slider.yaml --every 4").code == 0);
  std::string rows = file_text(folder.path() / "slider.csv");
  rows.erase(0, rows.find("\nt,"));
  CHECK(std::count(rows.begin(), rows.end(), '\n') == 6);
  CHECK(contains(rows, "\n0.8,"));
  CHECK(contains(rows, "\n1,"));
}

TEST_CASE("bad input is exit code 2 and nothing is run") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("coefficient"), 11, "coeficient_");
  folder.write("slider.yaml", kSlider);
  folder.write("bad.yaml", text);
  const Ended ended = slipbench(folder, "run slider.yaml bad.yaml");
  INFO(ended.output);
  CHECK(ended.code == 2);
  CHECK(contains(ended.output, "bad.yaml:8:5: error: "));
  CHECK(contains(ended.output, "nothing was run"));
  CHECK(file_count(folder.path()) == 2);
}

TEST_CASE("a wrong command line is exit code 2, help and version are 0") {
  const TemporaryFolder folder;
  CHECK(slipbench(folder, "").code == 2);
  CHECK(slipbench(folder, "run").code == 2);
  CHECK(slipbench(folder, "run x.yaml --evry 3").code == 2);
  CHECK(slipbench(folder, "run x.yaml --every 0").code == 2);
  CHECK(slipbench(folder, "run x.yaml --set mu").code == 2);
  const Ended unknown = slipbench(folder, "chek");
  CHECK(unknown.code == 2);
  CHECK(unknown.output == "slipbench: error: no command 'chek'; did you mean 'check'?\n");
  CHECK(slipbench(folder, "--version").output.find("slipbench ") == 0);
  const Ended told = slipbench(folder, "--version --verbose");
  CHECK(told.code == 0);
  for (const char* const fact :
       {"slipbench ", "\ncommit: ", "\ncompiler: ", "\nlibraries: Eigen 3.", ", GSL ",
        ", yaml-cpp ", ", fmt ", ", muParser ", ", CLI11 ", ", tl-expected ", ", UDUNITS-2",
        ", libmd", ", minizip"}) {
    CAPTURE(fact, told.output);
    CHECK(told.output.find(fact) != std::string::npos);
  }
  CHECK(slipbench(folder, "--verbose list").code == 2);
  CHECK(slipbench(folder, "--help").code == 0);
  CHECK(contains(slipbench(folder, "run --help").output, "--set"));
}

TEST_CASE("what the machine refuses is exit code 4") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  CHECK(slipbench(folder, "run missing.yaml").code == 4);
  CHECK(slipbench(folder, "run slider.yaml -o /proc/missing").code == 4);
  CHECK(slipbench(folder, "run slider.yaml -o slider.yaml").code == 2);
  CHECK(slipbench(folder, "check slider.yaml >/dev/full").code == 4);
  CHECK(slipbench(folder, "check slider.yaml >&-").code == 4);
  CHECK(slipbench(folder, "plot slider.yaml -o /proc/missing/a.svg").code == 4);
  CHECK(shell(folder, "PATH=/nowhere '" + kProgram + "' plot slider.yaml -o a.svg").code == 4);
  CHECK(file_count(folder.path()) == 1);
  CHECK(file_text(folder.path() / "slider.yaml") == kSlider);
}

TEST_CASE("a numerical failure is exit code 3, names the place and leaves no result") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("f2: 100"), 7, "f2: {to: 1.0e300}, f3: 0");
  folder.write("slider.yaml", text);
  const Ended ended = slipbench(folder, "run slider.yaml");
  INFO(ended.output);
  CHECK(ended.code == 3);
  CHECK(contains(ended.output, "slider.yaml: numerical failure: step 'slide', t = 0.1"));
  CHECK(contains(ended.output, "a case that fails the same way: slider.failed.yaml"));
  CHECK(file_count(folder.path()) == 2);
}

TEST_CASE("a load that nothing holds is exit code 3, and the case left behind fails the same way") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("motion: {CP1: {to: 0.1}}, force: {f2: 100}"), 42,
               "force: {f1: {to: 50}, f2: 100}}\n  - {step: later, increments: 3");
  folder.write("slider.yaml", text);
  const Ended ended = slipbench(folder, "run slider.yaml --set mu=0.3");
  INFO(ended.output);
  CHECK(ended.code == 3);
  const std::string message =
      "numerical failure: step 'slide', t = 0.6 (total time 0.6): no static solution: component 1 "
      "is loaded with f1 = 30.0";
  CHECK(contains(ended.output, "slider.yaml: " + message));
  CHECK(contains(ended.output, "but only 30 can hold against it"));
  REQUIRE(file_count(folder.path()) == 2);
  const std::string left = file_text(folder.path() / "slider.failed.yaml");
  CHECK(contains(left, "parameters: {mu: 0.3}\n"));
  CHECK_FALSE(contains(left, "checks"));
  CHECK_FALSE(contains(left, "later"));
  const Ended again = slipbench(folder, "run slider.failed.yaml --no-output");
  CHECK(again.code == 3);
  CHECK(contains(again.output, "slider.failed.yaml: " + message));
  CHECK(file_count(folder.path()) == 2);
}

TEST_CASE("check searches folders, skips bad ones, and does not depend on the threads") {
  const TemporaryFolder folder;
  const TemporaryFolder memory;
  const Environment cache("XDG_CACHE_HOME", memory.path().string());
  for (const char* sub : {"a", "b", "bad"}) fs::create_directory(folder.path() / sub);
  folder.write("a/two.yaml", kSlider);
  folder.write("a/one.yaml", kSlider);
  folder.write("bad/never.yaml", "no case\n");
  std::string text = kSlider;
  folder.write("b/unchecked.yaml", text.substr(0, text.find("checks:")));
  const Ended one = slipbench(folder, "check . -j 1");
  INFO(one.output);
  CHECK(one.code == 0);
  const auto lines = [](const std::string& table) {
    return table.substr(table.find('\n'), table.rfind("passed") - table.find('\n'));
  };
  CHECK(lines(one.output).find("\n  PASS  a/one         ") == 0);
  CHECK(contains(one.output, "  ----  b/unchecked   no checks\n"));
  CHECK(contains(one.output, "2 cases passed, 0 failed, 1 without checks"));
  CHECK(lines(slipbench(folder, "check . -j 4").output) == lines(one.output));

  CHECK(slipbench(folder, "check . --set mu=0.3").code == 1);
  folder.write("b/broken.yaml", "slipbench: 1\n");
  CHECK(slipbench(folder, "check .").code == 2);
  fs::create_directory(folder.path() / "empty");
  CHECK(slipbench(folder, "check empty").code == 2);
}

TEST_CASE("a case is named as the table shows it, and told why nothing can be told") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  CHECK(slipbench(folder, "check slider").code == 0);
  CHECK(slipbench(folder, "run slider").code == 0);
  CHECK(slipbench(folder, "report slider -o page.html").code == 0);
  CHECK(contains(slipbench(folder, "bless slider --reason x").output,
                 "slider.yaml: no check is against a curve"));
  const Ended full = slipbench(folder, "check slider >/dev/full");
  CHECK(full.code == 4);
  CHECK(contains(full.output, "standard output cannot be written: No space left on device"));
}

TEST_CASE("plot draws a case and a result") {
  const TemporaryFolder folder;
  if (shell(folder, "command -v gnuplot").code != 0) {
    WARN("gnuplot is not installed; nothing was drawn");
    return;
  }
  folder.write("slider.yaml", kSlider);
  const Ended ended = slipbench(folder, "plot slider.yaml");
  INFO(ended.output);
  CHECK(ended.code == 0);
  const std::string picture = file_text(folder.path() / "slider.svg");
  CHECK(contains(picture, "Slider"));
  CHECK(contains(picture, "time t [s]"));
  CHECK(contains(picture, "friction force CSF1 [N]"));
  CHECK(contains(picture, "position CP1 [mm]"));
  CHECK(contains(picture, "slip"));
  CHECK(file_count(folder.path()) == 2);
  REQUIRE(slipbench(folder, "run slider.yaml").code == 0);
  CHECK(slipbench(folder, "plot slider.csv -o result.svg").code == 0);
  CHECK(contains(file_text(folder.path() / "result.svg"), "Slider"));
  CHECK(slipbench(folder, "plot slider.csv -o result.jpg").code == 2);
  CHECK(slipbench(folder, "plot slider.csv -o slider.csv").code == 2);
}

TEST_CASE("plot --law draws the coefficients of a case that depend on something") {
  const TemporaryFolder folder;
  if (shell(folder, "command -v gnuplot").code != 0) {
    WARN("gnuplot is not installed; nothing was drawn");
    return;
  }
  std::string text = kSlider;
  text.erase(text.find("checks:"));
  folder.write("slider.yaml", text);
  const Ended constant = slipbench(folder, "plot --law slider.yaml");
  CHECK(constant.code == 2);
  CHECK(contains(constant.output, "nothing to draw"));
  CHECK(file_count(folder.path()) == 1);
  const std::string law =
      "coefficient: {generalized_viscous: {Fric: 0.1, C1: 0.001, C2: 1, area: 2}}";
  text.replace(text.find("coefficient: = mu"), 17, law);
  folder.write("slider.yaml", text);
  const Ended ended = slipbench(folder, "plot --law slider.yaml");
  INFO(ended.output);
  CHECK(ended.code == 0);
  const std::string picture = file_text(folder.path() / "slider.law.svg");
  CHECK(contains(picture, "Generalised viscous"));
  CHECK(contains(picture, "slip rate V [mm/s]"));
  CHECK(contains(picture, "pressure p [N/mm^2]"));
  CHECK(contains(picture, "visited in slip"));
  CHECK_FALSE(contains(picture, "visited below the limit"));
  CHECK(file_count(folder.path()) == 2);
  CHECK(slipbench(folder, "plot --law slider.csv -o a.svg").code == 2);
  CHECK(slipbench(folder, "plot --law slider.yaml -o a.jpg").code == 2);
}

TEST_CASE("describe tells a law's formula, symbols, rules and shape") {
  const TemporaryFolder folder;
  const Ended renard = slipbench(folder, "describe renard");
  CHECK(renard.code == 0);
  CHECK(contains(renard.output, "V <= C5       mu = C1 + (C3 - C1) x (2 - x), x = V/C5\n"));
  CHECK(contains(renard.output, "C5         a speed [L T^-1]"));
  CHECK(contains(renard.output, "C1 <= C3 must hold"));
  CHECK(contains(renard.output, "unit of speed"));
  CHECK(contains(renard.output, "mu |"));
  const Ended darmstad = slipbench(folder, "describe modified_darmstad");
  CHECK(contains(darmstad.output, "1/pressure^2 [F^-2 L^4]"));
  CHECK(contains(darmstad.output, "* p = 0    o p = "));
  CHECK_FALSE(contains(slipbench(folder, "describe constant").output, "mu |"));
  CHECK(slipbench(folder, "describe reynard").code == 2);
}

TEST_CASE("the picture of a coefficient calls stick only what stuck") {
  const TemporaryFolder folder;
  const auto picture_of = [&](const std::string& formulation, const std::string& motion) {
    folder.write("c.yaml",
                 "slipbench: 1\nunits: {length: mm, force: N, time: s}\n"
                 "connector: {type: CONTACT, dimension: 2}\nfriction:\n  - {predefined: {}, "
                 "coefficient: {exponential_decay: {static: 0.3, kinetic: 0.2, decay: 0.1}}, "
                 "formulation: " +
                     formulation +
                     "}\nhistory:\n  - {step: go, increments: 10, force: {f1: 100}, motion: {CP2: "
                     "{to: " +
                     motion + "}}}\n");
    const Ended ended = slipbench(folder, "plot --law c.yaml");
    INFO(ended.output);
    CHECK(ended.code == 0);
    return file_text(folder.path() / "c.law.svg");
  };
  const std::string slips = picture_of("{penalty: stiffness, K_t: 1000}", "10");
  CHECK(contains(slips, "visited in slip"));
  CHECK_FALSE(contains(slips, "visited in stick"));
  CHECK(contains(picture_of("{penalty: stiffness, K_t: 1000}", "0.02"), "visited in stick"));
  const std::string creeps = picture_of("{penalty: viscous, C: 1}", "10");
  CHECK(contains(creeps, "visited below the limit"));
  CHECK_FALSE(contains(creeps, "visited in stick"));
}

TEST_CASE("describe leads from the options of a Radioss block to what says them here") {
  const TemporaryFolder folder;
  const auto described = [&](const std::string& name) {
    const Ended ended = slipbench(folder, "describe " + name);
    INFO(name << ": " << ended.output);
    CHECK(ended.code == 0);
    return ended.output;
  };
  CHECK(contains(described("Ifric"), "    3   renard "));
  CHECK(contains(described("Ifric"), "    4   exponential_decay "));
  CHECK(contains(described("Ifiltr"), "filter (key of a case)"));
  CHECK(contains(described("Xfreq"), "filter (key of a case)"));
  CHECK(contains(described("Iform"), "formulation (key of a case)"));
  CHECK(contains(described("VISF"), "formulation (key of a case)"));
  const std::string two = described("Idir");
  CHECK(contains(two, "friction[].coefficient.orthotropic"));
  CHECK_FALSE(contains(two, "change_friction"));  // where it is refused
  CHECK(two.find("direction1 ") == two.rfind("direction1 "));
  const std::string pairs = described("friction_pairs");
  CHECK_FALSE(contains(pairs, "C1"));
  CHECK_FALSE(contains(pairs, "default: \n"));
  CHECK(contains(pairs, "slipbench list laws"));
  const std::string use = described("UTILISATION");
  CHECK(contains(use, "Of a belt abs(ln(f_bc/f_ab))"));
  CHECK(contains(use, "Of a formulation abs(F)/(mu N)"));
  const Ended keys = slipbench(folder, "list keys");
  CHECK(keys.code == 0);
  for (const char* key : {"filter", "formulation", "orthotropic", "friction_pairs"}) {
    CHECK(contains(keys.output, std::string("  ") + key + " "));
  }
  CHECK(contains(slipbench(folder, "describe formulations").output, "did you mean 'formulation'?"));
}

/// Counts the files of a folder that a process holds open, those without a name among them.
int open_files(pid_t process, const fs::path& folder) {
  int count = 0;
  std::error_code error;
  for (const auto& entry :
       fs::directory_iterator(fs::path("/proc") / std::to_string(process) / "fd", error)) {
    const fs::path target = fs::read_symlink(entry.path(), error);
    if (!error && target.parent_path() == folder) ++count;
  }
  return count;
}

/// Starts a run of many seconds, sends it a signal once its files are there, and says how it ended.
int interrupted(const TemporaryFolder& folder, int signal_number) {
  std::string text = kSlider;
  text.replace(text.find("increments: 10"), 14, "increments: 100000000");
  folder.write("long.yaml", text);
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.path().c_str()) == 0) {
      execl(kProgram.c_str(), "slipbench", "run", "long.yaml", static_cast<char*>(nullptr));
    }
    _exit(127);
  }
  constexpr int kFiles = 3;
  for (int i = 0; i < 500 && open_files(child, folder.path()) < kFiles; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  CHECK(open_files(child, folder.path()) == kFiles);
  kill(child, signal_number);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_CASE("an interrupted run ends with its code and leaves nothing behind") {
  const TemporaryFolder folder;
  CHECK(interrupted(folder, SIGINT) == 130);
  CHECK(file_count(folder.path()) == 1);
  CHECK(interrupted(folder, SIGTERM) == 143);
  CHECK(file_count(folder.path()) == 1);
  CHECK(interrupted(folder, SIGHUP) == 129);
  CHECK(file_count(folder.path()) == 1);
}

}  // namespace
}  // namespace slipbench::driver::commands
