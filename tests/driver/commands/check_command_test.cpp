// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/bless.hpp"
#include "driver/commands/check.hpp"
#include "driver/commands/run.hpp"
#include "tests/driver/report/case_for_test.hpp"
#include "tests/driver/support/environment_for_test.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// The slider of case_for_test.hpp with another text in place of one that stands in it.
std::string slider_with(const std::string& there, const std::string& instead) {
  std::string text = report::slider_text("0.2");
  text.replace(text.find(there), there.size(), instead);
  return text;
}

/// A folder with a case that follows `rig.csv` and one that is checked against `golden.csv`.
struct Inputs {
  TemporaryFolder folder;
  std::vector<std::string> names = {"rig.csv", "golden.csv", "driven.yaml", "blessed.yaml"};

  Inputs() {
    folder.write("rig.csv", "t,x\n0,0\n2,0.1\n");
    folder.write("driven.yaml",
                 slider_with("CP1: {to: 0.1}", "CP1: {csv: rig.csv, time: t, value: x}"));
    const std::string limit = "expression: \"= 100*0.2\"";
    folder.write("blessed.yaml", slider_with(limit, "curve: golden.csv"));
    BlessOptions options;
    options.file = path("blessed.yaml");
    options.reason = "a test";
    REQUIRE(bless_command(options) == base::kExitOk);
  }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
};

TEST_CASE("no file of verdicts takes the place of anything that a case is read from") {
  const Inputs inputs;
  const Environment cache("XDG_CACHE_HOME", inputs.path("cache"));
  for (const std::string& name : inputs.names) {
    const std::string before = file_text(inputs.path(name));
    for (std::string CheckOptions::*target :
         {&CheckOptions::junit, &CheckOptions::json, &CheckOptions::report}) {
      CheckOptions options;
      options.paths = {inputs.folder.path().string()};
      options.*target = inputs.path(name);
      INFO(name);
      CHECK(check_command(options) == base::kExitEnvironment);
      CHECK(file_text(inputs.path(name)) == before);
    }
  }
  CHECK(file_count(inputs.folder.path()) == 4);
}

TEST_CASE("a suite too long to be read ahead replaces none of its inputs either") {
  const Inputs inputs;
  const Environment cache("XDG_CACHE_HOME", inputs.path("cache"));
  fs::create_directory(inputs.folder.path() / "more");
  for (int i = 0; i < 1000; ++i) {
    inputs.folder.write("more/" + std::to_string(i) + ".yaml", "slipbench: 1\n");
  }
  const std::string before = file_text(inputs.path("golden.csv"));
  CheckOptions options;
  options.paths = {inputs.folder.path().string()};
  options.json = inputs.path("golden.csv");
  CHECK(check_command(options) == base::kExitEnvironment);
  CHECK(file_text(inputs.path("golden.csv")) == before);
}

TEST_CASE("run replaces no input of another of its cases, and runs none of them") {
  const Inputs inputs;
  inputs.folder.write("rig.yaml", report::slider_text("0.2"));
  const std::string before = file_text(inputs.path("rig.csv"));
  RunOptions options;
  options.cases = {inputs.path("rig.yaml"), inputs.path("driven.yaml")};
  options.folder = inputs.folder.path().string();
  CHECK(run_command(options) == base::kExitEnvironment);
  CHECK(file_text(inputs.path("rig.csv")) == before);
  CHECK(file_count(inputs.folder.path()) == 5);
  options.no_output = true;
  CHECK(run_command(options) == base::kExitOk);
}

TEST_CASE("a table and the data of a case with errors are inputs, too") {
  const TemporaryFolder folder;
  const std::string table = "mu,slip_rate\n0.2,0\n0.1,1\n";
  folder.write("a.csv", table);
  folder.write("a.yaml", slider_with("= mu", "{columns: [mu, slip_rate], csv: a.csv}"));
  RunOptions run;
  run.cases = {(folder.path() / "a.yaml").string()};
  run.folder = folder.path().string();
  CHECK(run_command(run) == base::kExitEnvironment);
  CHECK(file_text(folder.path() / "a.csv") == table);
  const std::string faulty = "t,x\n0,zero\n";
  folder.write("rig.csv", faulty);
  folder.write("driven.yaml",
               slider_with("CP1: {to: 0.1}", "CP1: {csv: rig.csv, time: t, value: x}"));
  CheckOptions check;
  check.paths = {(folder.path() / "driven.yaml").string()};
  check.json = (folder.path() / "rig.csv").string();
  CHECK(check_command(check) == base::kExitEnvironment);
  CHECK(file_text(folder.path() / "rig.csv") == faulty);
}

TEST_CASE("a file of verdicts needs a name") {
  const TemporaryFolder folder;
  CheckOptions options;
  options.paths = {folder.write("a.yaml", report::slider_text("0.2")).string()};
  options.json = "-";
  CHECK(check_command(options) == base::kExitBadInput);
  CHECK_FALSE(fs::exists("-"));
}

TEST_CASE("what failed is remembered without being asked, and the JSON keeps its order") {
  const TemporaryFolder folder;
  const Environment cache("XDG_CACHE_HOME", (folder.path() / "cache").string());
  fs::create_directory(folder.path() / "suite");
  for (const char* name : {"a", "b", "c", "d"}) {
    folder.write(std::string("suite/") + name + ".yaml",
                 report::slider_text(*name == 'b' || *name == 'd' ? "0.3" : "0.2"));
  }
  const auto run = [&](bool failed_first, bool fail_fast, std::vector<std::string> filters = {}) {
    CheckOptions options;
    options.paths = {(folder.path() / "suite/").string()};
    options.failed_first = failed_first;
    options.fail_fast = fail_fast;
    options.filters = std::move(filters);
    options.jobs = 2;
    options.json = (folder.path() / "verdicts.json").string();
    options.junit = (folder.path() / "verdicts.xml").string();
    CHECK(check_command(options) == base::kExitCheckFailed);
    return file_text(options.json);
  };
  // One that was not reached is told, too.
  const auto was_run = [](const std::string& text, const std::string& label) {
    const std::size_t at = text.find("\"case\": \"" + label + "\"");
    REQUIRE(at != std::string::npos);
    const std::string line = text.substr(at, text.find('\n', at) - at);
    const bool unreached = line.find("not run: an earlier case did not pass") != std::string::npos;
    CHECK(unreached == (line.find("\"status\": \"not_run\"") != std::string::npos));
    return !unreached;
  };
  const std::string first = run(false, false);
  CHECK(run(true, false) == first);
  CHECK(file_text(folder.path() / "verdicts.xml").find("<skipped") == std::string::npos);
  // The first that is run is one that failed.
  const std::string begin = run(true, true);
  CHECK(was_run(begin, "b"));
  CHECK_FALSE(was_run(begin, "a"));
  // A part of the suite says nothing about the rest of it: with b mended, d is still known.
  folder.write("suite/b.yaml", report::slider_text("0.2"));
  folder.write("suite/c.yaml", report::slider_text("0.3"));
  run(false, false, {"b", "c"});
  const std::string rest = run(true, true);
  CHECK(was_run(rest, "c"));
  CHECK_FALSE(was_run(rest, "b"));
  folder.write("suite/c.yaml", report::slider_text("0.2"));
  const std::string last = run(true, true);
  CHECK(was_run(last, "d"));
  CHECK_FALSE(was_run(last, "a"));
}

TEST_CASE("a case alone leaves no memory behind") {
  const TemporaryFolder folder;
  const Environment cache("XDG_CACHE_HOME", (folder.path() / "cache").string());
  CheckOptions options;
  options.paths = {folder.write("a.yaml", report::slider_text("0.3")).string()};
  CHECK(check_command(options) == base::kExitCheckFailed);
  CHECK_FALSE(fs::exists(folder.path() / "cache"));
}

TEST_CASE("a case may be named as tables show it, without its ending") {
  const TemporaryFolder folder;
  const std::string base = folder.path().string();
  folder.write("guard.yaml", "");
  fs::create_directory(folder.path() / "joint");
  folder.write("joint.yaml", "");
  CHECK(named_case(base + "/guard") == base + "/guard.yaml");
  CHECK(named_case(base + "/guard.yaml") == base + "/guard.yaml");
  CHECK(named_case(base + "/joint") == base + "/joint");
  CHECK(named_case(base + "/missing") == base + "/missing");
}

}  // namespace
}  // namespace slipbench::driver::commands
