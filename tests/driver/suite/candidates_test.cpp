// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/candidates.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::suite {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> labels(const std::vector<Candidate>& found) {
  std::vector<std::string> all;
  all.reserve(found.size());
  for (const Candidate& candidate : found) all.push_back(candidate.label);
  return all;
}

TEST_CASE(
    "a folder's cases come in the order of their labels, without bad folders and what is hidden") {
  const TemporaryFolder folder;
  for (const char* sub : {"b", "b/deep", "a", "bad", ".hidden", "a/bad"}) {
    fs::create_directory(folder.path() / sub);
  }
  for (const char* name :
       {"b/deep/two.yaml", "b/one.yaml", "a/z.yaml", "bad/x.yaml", ".hidden/x.yaml", "a/bad/x.yaml",
        "a/notes.txt", "top.yaml", "._top.yaml", "top.yml", "only.yml"}) {
    folder.write(name, "");
  }
  // The lock of an editor, beside the case that is being edited.
  fs::create_symlink("user@machine.1234", folder.path() / ".#top.yaml");
  const std::vector<Candidate> found = find_candidates(std::vector{folder.path().string()});
  CHECK(labels(found) ==
        std::vector<std::string>{"a/z", "b/deep/two", "b/one", "only.yml", "top", "top.yml"});
  CHECK(found[0].path == (folder.path() / "a/z.yaml").string());
  for (const Candidate& one : found) CHECK(one.fault.empty());
}

TEST_CASE("a link out of the folder has a fault; one within it is a case, or searched anyway") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "suite/b");
  fs::create_directories(folder.path() / "shared");
  folder.write("private.yaml", "");
  folder.write("shared/other.yaml", "");
  folder.write("suite/b/one.yaml", "");
  fs::create_symlink("../private.yaml", folder.path() / "suite/out.yaml");
  fs::create_symlink("b/one.yaml", folder.path() / "suite/in.yaml");
  fs::create_directory_symlink("../shared", folder.path() / "suite/shared");
  fs::create_directory_symlink("b", folder.path() / "suite/same");
  const std::string suite = (folder.path() / "suite").string();
  const std::vector<Candidate> found = find_candidates(std::vector{suite});
  CHECK(labels(found) == std::vector<std::string>{"b/one", "in", "out", "shared"});
  CHECK(found[1].fault.empty());
  CHECK(found[2].fault == "is a link out of the folder; name the file itself to have it run");
  CHECK(found[3].path == suite + "/shared");
  CHECK(found[3].fault ==
        "is a link out of the folder and not searched; name it to have its cases run, or give "
        "--allow-outside if it holds their data");
  const std::vector<Candidate> all = find_candidates(std::vector{suite}, true);
  CHECK(labels(all) == std::vector<std::string>{"b/one", "in", "out"});
  CHECK(all[2].fault.empty());
}

TEST_CASE("a link to a folder that is not searched has a fault, unless that folder is named") {
  const TemporaryFolder folder;
  for (const char* sub : {".shared", "bad", "ok"}) {
    fs::create_directory(folder.path() / sub);
    folder.write(std::string(sub) + "/one.yaml", "");
  }
  fs::create_directory(folder.path() / ".shared/deep");
  fs::create_directory_symlink(".shared/deep", folder.path() / "deep");
  fs::create_directory_symlink("bad", folder.path() / "worse");
  fs::create_directory_symlink("ok", folder.path() / "same");
  fs::create_directory_symlink(".", folder.path() / "self");
  const std::string top = folder.path().string();
  const std::vector<Candidate> found = find_candidates(std::vector{top});
  CHECK(labels(found) == std::vector<std::string>{"deep", "ok/one", "worse"});
  CHECK(found[0].fault.starts_with("is a link to a folder that is not searched"));
  CHECK(found[2].fault == found[0].fault);
  CHECK(labels(find_candidates(std::vector{top, top + "/bad"})) ==
        std::vector<std::string>{top + "/deep", top + "/ok/one", top + "/bad/one"});
}

TEST_CASE("fit files of a folder are not cases, whatever else speaks of calibration is") {
  const TemporaryFolder folder;
  folder.write("case.yaml", "# calibrate:\ntitle: calibrate: me\nfriction: []\n");
  folder.write("fit.yaml", "slipbench: 1\ncalibrate:\n  vary: {mu: {}}\n");
  folder.write("flat.yaml", "calibrate : {vary: {}}\n");
  const std::vector<Candidate> found = find_candidates(std::vector{folder.path().string()});
  CHECK(labels(found) == std::vector<std::string>{"case"});
  // One that is named is asked for: the reader says which command is meant.
  const std::string fit = (folder.path() / "fit.yaml").string();
  CHECK(find_candidates(std::vector{fit}).size() == 1);
}

TEST_CASE("a file is a case whatever its name and whether it is there or not") {
  const TemporaryFolder folder;
  const std::string missing = (folder.path() / "missing.yml").string();
  const std::vector<Candidate> found = find_candidates(std::vector{missing});
  REQUIRE(found.size() == 1);
  CHECK(found[0].path == missing);
}

TEST_CASE("with several paths the labels keep them, and no case comes twice") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "a");
  folder.write("a/one.yaml", "");
  folder.write("a/two.yaml", "");
  const std::string a = (folder.path() / "a").string();
  const std::vector<Candidate> found =
      find_candidates(std::vector{a + "/two.yaml", a, a + "/../a/one.yaml"});
  CHECK(labels(found) == std::vector{a + "/two", a + "/one"});
}

TEST_CASE("a link to a case is a case, whether one path is named or several") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "d");
  fs::create_directory(folder.path() / "o");
  fs::create_directory_symlink("d", folder.path() / "same");
  folder.write("d/a.yaml", "");
  fs::create_symlink("a.yaml", folder.path() / "d/link.yaml");
  const std::string d = (folder.path() / "d").string();
  const std::string o = (folder.path() / "o").string();
  CHECK(labels(find_candidates(std::vector{d})) == std::vector<std::string>{"a", "link"});
  // A folder without a case is told where it is one of several.
  const std::vector<Candidate> two = find_candidates(std::vector{d, o});
  CHECK(labels(two) == std::vector{d + "/a", d + "/link", o});
  CHECK(two.back().fault == "has no case (*.yaml, *.yml)");
  CHECK(find_candidates(std::vector{o}).empty());
  const std::string same = (folder.path() / "same").string();
  CHECK(labels(find_candidates(std::vector{d, same})) == std::vector{d + "/a", d + "/link"});
}

TEST_CASE("two files that differ in their endings have two labels") {
  const std::vector<std::string> paths = {"x/../block.yaml", "block.txt"};
  CHECK(labels(find_candidates(paths)) == std::vector<std::string>{"block", "block.txt"});
}

TEST_CASE("a link to nowhere is a case that cannot be read, not one that is overlooked") {
  const TemporaryFolder folder;
  fs::create_symlink("nowhere", folder.path() / "gone.yaml");
  CHECK(labels(find_candidates(std::vector{folder.path().string()})) ==
        std::vector<std::string>{"gone"});
}

TEST_CASE("links between folders do not lead in circles") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "a");
  folder.write("a/one.yaml", "");
  fs::create_directory_symlink(folder.path(), folder.path() / "a/up");
  CHECK(labels(find_candidates(std::vector{folder.path().string()})) ==
        std::vector<std::string>{"a/one"});
}

TEST_CASE("a folder that cannot be searched has a fault and does not hide the others") {
  if (geteuid() == 0) {
    WARN("a superuser may read everything; nothing was tested");
    return;
  }
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "closed");
  folder.write("open.yaml", "");
  fs::permissions(folder.path() / "closed", fs::perms::none);
  const std::vector<Candidate> found = find_candidates(std::vector{folder.path().string()});
  fs::permissions(folder.path() / "closed", fs::perms::owner_all);
  CHECK(labels(found) == std::vector<std::string>{"closed", "open"});
  CHECK(found[0].fault == "cannot be searched: Permission denied");
}

}  // namespace
}  // namespace slipbench::driver::suite
