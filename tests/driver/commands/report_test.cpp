// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/report.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "driver/base/files/exit_code.hpp"
#include "driver/commands/run.hpp"
#include "tests/driver/report/case_for_test.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

int report(const TemporaryFolder& folder, std::vector<std::string> names,
           const std::string& page = "page.html") {
  ReportOptions options;
  for (const std::string& name : names) options.inputs.push_back((folder.path() / name).string());
  options.output = (folder.path() / page).string();
  return report_command(options);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("a failed check and a faulty case are on the page, and no failure of the command") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "cases");
  folder.write("cases/a.yaml", report::slider_text("0.2"));
  folder.write("cases/b.yaml", report::slider_text("0.3"));
  folder.write("cases/c.yaml", "slipbench: 1\n");
  CHECK(report(folder, {"cases"}) == base::kExitOk);
  const std::string page = file_text(folder.path() / "page.html");
  CHECK(has(page, "\"passed\":1,\"failed\":1,\"not_run\":1"));
  CHECK(has(page, "\"id\":\"a\""));
  CHECK(has(page, "\"id\":\"b\""));
  CHECK(has(page, "c.yaml:1:"));
  CHECK(has(page, "\"title\":\"cases\""));
  // Same input, same bytes.
  CHECK(report(folder, {"cases"}, "again.html") == base::kExitOk);
  CHECK(file_text(folder.path() / "again.html") == page);
}

TEST_CASE("results are drawn beside cases, and compared with each other") {
  const TemporaryFolder folder;
  folder.write("a.yaml", report::slider_text("0.2"));
  for (const char* name : {"old", "new"}) {
    fs::create_directory(folder.path() / name);
    RunOptions options;
    options.cases = {(folder.path() / "a.yaml").string()};
    options.folder = (folder.path() / name).string();
    REQUIRE(run_command(options) == base::kExitOk);
  }
  CHECK(report(folder, {"old/a.csv", "new/a.csv", "a.yaml"}) == base::kExitOk);
  const std::string page = file_text(folder.path() / "page.html");
  // Named by whole paths, they keep the folders that tell them apart, and no other.
  CHECK(has(page, "\"compare\":[[\"old/a\",\"new/a\"]]"));
  CHECK_FALSE(has(page, folder.path().generic_string()));
  CHECK(has(page, "\"kind\":\"case\""));
}

TEST_CASE("with nothing to look at the page is written and the reason is the exit code") {
  const TemporaryFolder folder;
  folder.write("a.yaml", "slipbench: 1\n");
  CHECK(report(folder, {"a.yaml"}) == base::kExitBadInput);
  CHECK(fs::exists(folder.path() / "page.html"));
  CHECK(report(folder, {"missing.csv"}) == base::kExitEnvironment);
}

TEST_CASE("a page never takes the place of what it is made of, or of a folder") {
  const TemporaryFolder folder;
  folder.write("a.yaml", report::slider_text("0.2"));
  fs::create_directory(folder.path() / "empty");
  CHECK(report(folder, {"a.yaml"}, "a.yaml") == base::kExitEnvironment);
  CHECK(file_text(folder.path() / "a.yaml") == report::slider_text("0.2"));
  CHECK(report(folder, {"a.yaml"}, "empty") == base::kExitEnvironment);
  CHECK(report(folder, {"a.yaml"}, "a.yaml/page.html") == base::kExitEnvironment);
  CHECK(report(folder, {"a.yaml"}, "made/for/page.html") == base::kExitOk);
  CHECK(fs::exists(folder.path() / "made/for/page.html"));
  CHECK(report(folder, {"empty"}) == base::kExitBadInput);
}

TEST_CASE("a page takes the place of no file that its cases and results are read from") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,x\n0,0\n2,0.1\n");
  std::string text = report::slider_text("0.2");
  text.replace(text.find("{to: 0.1}"), 9, "{csv: rig.csv, time: t, value: x}");
  folder.write("a.yaml", text);
  RunOptions options;
  options.cases = {(folder.path() / "a.yaml").string()};
  options.folder = folder.path().string();
  REQUIRE(run_command(options) == base::kExitOk);
  for (const char* name : {"a.csv", "a.json", "a.events.csv"}) {
    const std::string before = file_text(folder.path() / name);
    CHECK(report(folder, {"a.csv"}, name) == base::kExitEnvironment);
    CHECK(file_text(folder.path() / name) == before);
  }
  const std::string rig = file_text(folder.path() / "rig.csv");
  CHECK(report(folder, {"a.yaml"}, "rig.csv") == base::kExitEnvironment);
  CHECK(file_text(folder.path() / "rig.csv") == rig);
}

TEST_CASE("what the reader of a case remarks stands on its page once") {
  const TemporaryFolder folder;
  std::string text = report::slider_text("0.2");
  text.replace(text.find("{stiffness: 1000}"), 17, "{slip_tolerance: 1.0e-4}");
  folder.write("a.yaml", text);
  REQUIRE(report(folder, {"a.yaml"}) == base::kExitOk);
  const std::string page = file_text(folder.path() / "page.html");
  const std::string remark = "characteristic length";
  const std::size_t first = page.find(remark);
  REQUIRE(first != std::string::npos);
  CHECK(page.find(remark, first + 1) == std::string::npos);
}

TEST_CASE("a result that is named twice is drawn once") {
  const TemporaryFolder folder;
  folder.write("a.yaml", report::slider_text("0.2"));
  RunOptions options;
  options.cases = {(folder.path() / "a.yaml").string()};
  options.folder = folder.path().string();
  REQUIRE(run_command(options) == base::kExitOk);
  REQUIRE(report(folder, {"a.csv", "./a.csv"}) == base::kExitOk);
  CHECK(has(file_text(folder.path() / "page.html"), "\"cases\":1,"));
}

}  // namespace
}  // namespace slipbench::driver::commands
