// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/architecture/floors.hpp"
#include "tests/architecture/include_rules.hpp"
#include "tests/architecture/source_file.hpp"
#include "tests/architecture/text_rules.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::architecture {
namespace {

const std::vector<SourceFile>& repository() {
  static const std::vector<SourceFile> kFiles = read_repository(test::source_dir());
  return kFiles;
}

template <class Rule>
std::string broken(const Rule& rule) {
  std::vector<Violation> all;
  for (const SourceFile& file : repository()) {
    const std::vector<Violation> found = rule(file);
    all.insert(all.end(), found.begin(), found.end());
  }
  return to_string(all);
}

TEST_CASE("the rooms are read, all of them") {
  for (const char* room :
       {"law/", "reference/", "driver/", "c/", "python/", "tests/", "scripts/", "cmake/"}) {
    INFO(room);
    CHECK(std::any_of(repository().begin(), repository().end(),
                      [&](const SourceFile& file) { return file.path.starts_with(room); }));
  }
}

TEST_CASE("a broken rule in a folder on disk is found, build folders and binaries are not read") {
  const std::filesystem::path root =
      std::filesystem::path(test::binary_dir()) / "architecture-test";
  std::filesystem::remove_all(root);
  const auto write = [&](const std::string& path, const std::string& text) {
    std::filesystem::create_directories((root / path).parent_path());
    std::ofstream(root / path, std::ios::binary) << text;
  };
  write("law/bad.hpp", "#include <fmt/format.h>\n");
  write("law/friction/bad.cpp", "#include \"driver/a.hpp\"\n");
  write("build/law/bad.hpp", "#include <fmt/format.h>\n");
  write("tests/support/picture.png", std::string("\0\1", 2));
  write("README.md", "text\n");

  const std::vector<SourceFile> files = read_repository(root);
  REQUIRE(files.size() == 3);
  CHECK(files[0].path == "README.md");
  CHECK(files[1].path == "law/bad.hpp");
  CHECK(include_violations(files[1]).size() == 1);
  CHECK(files[2].path == "law/friction/bad.cpp");
  CHECK(include_violations(files[2]).size() == 1);
  std::filesystem::remove_all(root);
}

TEST_CASE("every room includes only what it may know") { CHECK(broken(include_violations) == ""); }

TEST_CASE("no room includes one above it, and every file stands in a room") {
  CHECK(broken(floor_violations) == "");
}

TEST_CASE("namespaces follow the rooms") { CHECK(broken(namespace_violations) == ""); }

TEST_CASE("every room has files") {
  for (const auto& [room, name] : floors()) {
    INFO(room);
    CHECK(std::any_of(repository().begin(), repository().end(),
                      [&, folder = room](const SourceFile& file) {
                        return file.path.substr(0, file.path.rfind('/')) == folder;
                      }));
  }
}

TEST_CASE("the law builds no strings, writes nothing and throws nothing") {
  CHECK(broken(law_violations) == "");
}

TEST_CASE("nothing reads the clock on the wall") { CHECK(broken(clock_violations) == ""); }

TEST_CASE("plot templates read result files only") { CHECK(broken(plot_violations) == ""); }

TEST_CASE("every test case is one that ctest runs") { CHECK(broken(test_case_violations) == ""); }

TEST_CASE("comments begin with a verb or a noun") { CHECK(broken(comment_violations) == ""); }

TEST_CASE("every source states its licence") { CHECK(broken(licence_violations) == ""); }

TEST_CASE("no file names a place outside of the repository") {
  CHECK(broken([](const SourceFile& file) {
          return outside_violations(file, test::source_dir());
        }) == "");
}

}  // namespace
}  // namespace slipbench::architecture
