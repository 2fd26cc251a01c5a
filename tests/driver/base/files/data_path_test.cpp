// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/data_path.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::base {
namespace {

namespace fs = std::filesystem;

TEST_CASE("a file of the case's folder or below is found relative to the case") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t\n0\n");
  fs::create_directory(folder.path() / "data");
  CHECK(resolve_data_path(folder.path(), "rig.csv").value() == folder.path() / "rig.csv");
  CHECK(resolve_data_path(folder.path(), "data/new.csv").value() == folder.path() / "data/new.csv");
  CHECK(resolve_data_path(folder.path() / "", "./rig.csv"));
  CHECK(resolve_data_path(folder.path(), "a..b.csv"));
  CHECK(resolve_data_path("", "rig.csv").value() == fs::path("./rig.csv"));
}

TEST_CASE("a path out of the case's folder is refused unless that is allowed") {
  const TemporaryFolder folder;
  for (const char* text : {"../rig.csv", "data/../../rig.csv", "data/..", "..", "data/../rig.csv",
                           "/etc/passwd", "//etc/passwd"}) {
    const auto refused = resolve_data_path(folder.path(), text);
    INFO(text);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().kind == HistoryError::Kind::kInput);
    CHECK(refused.error().message.find("--allow-outside") != std::string::npos);
    CHECK(resolve_data_path(folder.path(), text, true));
  }
  CHECK(resolve_data_path(folder.path(), "/etc/passwd", true).value() == fs::path("/etc/passwd"));
}

TEST_CASE("what would need expanding is refused in any case") {
  for (const char* text : {"~/rig.csv", "~", "~other/rig.csv", "file:///etc/passwd",
                           "file://rig.csv", "https://example.org/rig.csv", ""}) {
    for (const bool allow_outside : {false, true}) {
      const auto refused = resolve_data_path("case", text, allow_outside);
      INFO(text);
      REQUIRE_FALSE(refused);
      CHECK(refused.error().kind == HistoryError::Kind::kInput);
    }
  }
  CHECK_FALSE(resolve_data_path("case", std::string_view("a\0b", 3)));
}

TEST_CASE("a link is followed within the case's folder and refused out of it") {
  const TemporaryFolder folder;
  const fs::path cases = folder.path() / "cases";
  fs::create_directory(cases);
  folder.write("secret.csv", "t\n0\n");
  folder.write("cases/rig.csv", "t\n0\n");
  fs::create_symlink("rig.csv", cases / "inside.csv");
  fs::create_symlink("../secret.csv", cases / "outside.csv");
  fs::create_directory_symlink("..", cases / "up");
  CHECK(resolve_data_path(cases, "inside.csv"));
  for (const char* text : {"outside.csv", "up/secret.csv", "up/new.csv"}) {
    const auto refused = resolve_data_path(cases, text);
    INFO(text);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().kind == HistoryError::Kind::kInput);
    CHECK(refused.error().message.find("link out of the folder") != std::string::npos);
    CHECK(resolve_data_path(cases, text, true));
  }
}

TEST_CASE("a case folder that is itself reached through a link is no obstacle") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "cases");
  folder.write("cases/rig.csv", "t\n0\n");
  fs::create_directory_symlink("cases", folder.path() / "alias");
  CHECK(resolve_data_path(folder.path() / "alias", "rig.csv"));
}

TEST_CASE("a folder whose name merely begins like the case's is outside") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "case");
  fs::create_directory(folder.path() / "case2");
  folder.write("case2/rig.csv", "t\n0\n");
  fs::create_symlink("../case2/rig.csv", folder.path() / "case" / "rig.csv");
  CHECK_FALSE(resolve_data_path(folder.path() / "case", "rig.csv"));
}

TEST_CASE("a circle of links is an error, not a hang") {
  const TemporaryFolder folder;
  fs::create_symlink("b.csv", folder.path() / "a.csv");
  fs::create_symlink("a.csv", folder.path() / "b.csv");
  const auto refused = resolve_data_path(folder.path(), "a.csv");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == HistoryError::Kind::kEnvironment);
}

}  // namespace
}  // namespace slipbench::driver::base
