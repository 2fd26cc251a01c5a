// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/annotations.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <utility>

#include "tests/driver/suite/outcomes_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::suite {
namespace {

std::ptrdiff_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST_CASE("an annotation has its place, title and message") {
  CHECK(annotation("error", "a/b.yaml", {7, 5, 1}, "a/b: pull", "off by 3 N") ==
        "::error file=a/b.yaml,line=7,col=5,title=a/b%3A pull::off by 3 N\n");
  CHECK(annotation("warning", "a.yaml", {}, "t", "m") == "::warning file=a.yaml,title=t::m\n");
}

TEST_CASE("no name or message can end an annotation or begin a command of its own") {
  const std::string text = annotation("error", "a,line=1::x\n::set-env name=P::1", {},
                                      "t\r\n::stop", "100%\n::add-mask::secret");
  CHECK(text ==
        "::error file=a%2Cline=1%3A%3Ax%0A%3A%3Aset-env name=P%3A%3A1,title=t%0D%0A%3A%3Astop::"
        "100%25%0A::add-mask::secret\n");
  CHECK(lines(text) == 1);
}

TEST_CASE("what a log cannot show is replaced in an annotation") {
  const std::string bad = "\xEF\xBF\xBD";
  CHECK(annotation("error", "a\xFF.yaml", {}, "t\x1B[31m", "m\x01\tn\x7F") ==
        "::error file=a" + bad + ".yaml,title=t" + bad + "[31m::m" + bad + " n" + bad + "\n");
}

TEST_CASE("no name in a log is taken for a command of the old form") {
  CHECK(without_commands("FAIL  ##[error]x ###[") == "FAIL  # #[error]x ## #[");
  CHECK(without_commands("# [1] ## 3") == "# [1] ## 3");
}

TEST_CASE("failed checks and cases not run are errors, doubts are warnings") {
  Annotations all("");
  CheckOutcome doubtful = passed_check("limit");
  doubtful.verdict.warnings = {"loose"};
  all.add({"a/c.yaml", "a/c"}, outcome_of(doubtful, failed_check("pull", "off")));
  all.add({"a/broken.yaml", "a/broken"}, outcome_not_run(base::kExitBadInput, "unknown key"));
  all.add({"fine.yaml", "fine"}, outcome_of(passed_check("x")));
  CHECK(all.text() ==
        "::warning file=a/c.yaml,line=7,col=5,title=a/c%3A limit::loose\n"
        "::error file=a/c.yaml,line=7,col=5,title=a/c%3A pull::check 'pull': off\n"
        "::error file=a/broken.yaml,line=3,col=9,title=a/broken::unknown key\n");
}

TEST_CASE("files are named from the root of the repository, if they are below it") {
  Annotations below("/repo");
  below.add({"/repo/cases/c.yaml", "c"}, outcome_of(failed_check("pull", "off")));
  CHECK(below.text().find("::error file=cases/c.yaml,") == 0);
  Annotations outside("/repo");
  outside.add({"/other/c.yaml", "c"}, outcome_of(failed_check("pull", "off")));
  CHECK(outside.text().find("::error file=/other/c.yaml,") == 0);
}

TEST_CASE("a repository that is reached through a link has the same files") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "repo/cases");
  std::filesystem::create_directory_symlink("repo", folder.path() / "link");
  const std::string base = folder.path().string();
  for (const auto& [root, file] : {std::pair(base + "/link", base + "/repo/cases/c.yaml"),
                                   std::pair(base + "/repo/", base + "/link/cases/c.yaml")}) {
    Annotations all(root);
    all.add({file, "c"}, outcome_of(failed_check("pull", "off")));
    CHECK(all.text().find("::error file=cases/c.yaml,") == 0);
  }
}

TEST_CASE("no more annotations are written than are shown") {
  Annotations all("");
  for (int i = 0; i < 30; ++i) {
    CheckOutcome failed = failed_check("pull", "off");
    failed.verdict.warnings = {"loose"};
    all.add({"c.yaml", "c"}, outcome_of(failed));
  }
  CHECK(lines(all.text()) == 20);
}

}  // namespace
}  // namespace slipbench::driver::suite
