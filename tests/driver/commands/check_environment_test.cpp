// SPDX-License-Identifier: Apache-2.0
// What `check` does for terminals and for jobs of a continuous integration.
#include <catch2/catch.hpp>
#include <string>

#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

TEST_CASE("colour is where it is demanded, and nowhere where it is forbidden") {
  const TemporaryFolder folder;
  folder.write("a.yml", "slipbench: 2\n");
  const auto coloured = [&](const std::string& environment) {
    const Ended ended =
        shell(folder, "env -u NO_COLOR " + environment + " '" + kProgram + "' check a.yml");
    CHECK(ended.output.find("FAIL") != std::string::npos);
    return ended.output.find("\x1b[31m") != std::string::npos;
  };
  CHECK_FALSE(coloured(""));
  CHECK(coloured("FORCE_COLOR=1"));
  CHECK(coloured("FORCE_COLOR=3 CLICOLOR=0 TERM=dumb"));
  CHECK(coloured("CLICOLOR_FORCE=1"));
  CHECK_FALSE(coloured("FORCE_COLOR=0 CLICOLOR_FORCE="));
  CHECK_FALSE(coloured("NO_COLOR=1 FORCE_COLOR=1 CLICOLOR_FORCE=1"));
}

TEST_CASE("a case is found and named with .yml as with .yaml, and two of one name are told") {
  const TemporaryFolder folder;
  folder.write("a.yml", "slipbench: 2\n");
  CHECK(slipbench(folder, "check a").output.find("a.yml:1:12: error: ") != std::string::npos);
  CHECK(slipbench(folder, "check .").output.find("1 case, ") != std::string::npos);
  folder.write("a.yaml", "slipbench: 3\n");
  const Ended both = slipbench(folder, "check a");
  CHECK(both.output.find("slipbench: warning: there are a.yaml and a.yml; a.yaml is taken\n") == 0);
  CHECK(both.output.find("a.yaml:1:12: error: ") != std::string::npos);
  CHECK(slipbench(folder, "check .").output.find("2 cases, ") != std::string::npos);
}

TEST_CASE("check tells the slowest cases, and a job's summary that fails is only a warning") {
  const TemporaryFolder folder;
  folder.write("a.yaml", "slipbench: 2\n");
  const Ended ended =
      shell(folder, "env GITHUB_STEP_SUMMARY=no/x.md '" + kProgram + "' check . --durations 3");
  CHECK(ended.code == 2);
  CHECK(ended.output.find("  slowest:\n") != std::string::npos);
  CHECK(ended.output.find("slipbench: warning: the summary of the job is not written to no/x.md: "
                          "No such file or directory\n") != std::string::npos);
  shell(folder, "env GITHUB_STEP_SUMMARY=x.md '" + kProgram + "' check .");
  CHECK(file_text(folder.path() / "x.md").find("| a.yaml&#58;1 | not run | ") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::commands
