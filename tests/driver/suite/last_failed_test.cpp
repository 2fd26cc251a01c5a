// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/last_failed.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/driver/support/environment_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::suite {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kSuite = {"suite"};
const std::vector<Candidate> kCases = {
    {"suite/a.yaml", "a"}, {"suite/b.yaml", "b"}, {"suite/c.yaml", "c"}, {"suite/d.yaml", "d"}};

std::string order_of(LastFailed memory) {
  std::string text;
  for (const std::size_t i : memory.order(kCases)) text += kCases[i].label;
  return text;
}

TEST_CASE("the cases that did not pass last time come first, both kinds in their order") {
  const TemporaryFolder cache;
  const Environment environment("XDG_CACHE_HOME", cache.path().string());
  LastFailed first(kSuite);
  CHECK(order_of(first) == "abcd");
  first.note(kCases[3], false);
  first.note(kCases[1], false);
  first.note(kCases[0], true);
  first.write(kCases);
  LastFailed second(kSuite);
  CHECK(order_of(second) == "bdac");

  SECTION("what was not run this time keeps its mark") {
    second.note(kCases[3], true);
    second.write(kCases);
    CHECK(order_of(LastFailed(kSuite)) == "bacd");
  }
  SECTION("what is no longer in the suite is forgotten") {
    second.write(std::vector<Candidate>(kCases.begin(), kCases.begin() + 2));
    CHECK(order_of(LastFailed(kSuite)) == "bacd");
  }
  SECTION("another suite has a memory of its own, however its folders are written") {
    CHECK(order_of(LastFailed(std::vector<std::string>{"suite", "other"})) == "abcd");
    CHECK(order_of(LastFailed(std::vector<std::string>{"./other/../suite"})) == "bdac");
  }
}

TEST_CASE("a suite is the same however its folder is written") {
  const TemporaryFolder folder;
  const Environment environment("XDG_CACHE_HOME", (folder.path() / "cache").string());
  fs::create_directories(folder.path() / "suite");
  fs::create_directory_symlink("suite", folder.path() / "link");
  const std::string suite = (folder.path() / "suite").string();
  LastFailed memory(std::vector{suite});
  memory.note({suite + "/b.yaml", "b"}, false);
  memory.write(std::vector<Candidate>{{suite + "/a.yaml", "a"}, {suite + "/b.yaml", "b"}});
  for (const std::string& name :
       {suite + "/", suite + "/.", suite + "//", suite + "/../suite", suite + "/../link/"}) {
    INFO(name);
    LastFailed again(std::vector{name});
    const std::vector<Candidate> cases = {{name + "/a.yaml", "a"}, {name + "/b.yaml", "b"}};
    CHECK(again.order(cases) == std::vector<std::size_t>{1, 0});
  }
}

TEST_CASE("a suite that never failed leaves no trace, and one that passes again is forgotten") {
  const TemporaryFolder cache;
  const Environment environment("XDG_CACHE_HOME", cache.path().string());
  LastFailed memory(kSuite);
  memory.note(kCases[0], true);
  memory.write(kCases);
  CHECK(fs::is_empty(cache.path()));
  memory.note(kCases[1], false);
  memory.write(kCases);
  LastFailed second(kSuite);
  second.note(kCases[1], true);
  second.write(kCases);
  CHECK(order_of(LastFailed(kSuite)) == "abcd");
}

TEST_CASE("a cache that cannot be used is a suite without memory") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "");
  const Environment cache("XDG_CACHE_HOME", file.string());
  LastFailed memory(kSuite);
  memory.note(kCases[1], false);
  memory.write(kCases);
  CHECK(order_of(LastFailed(kSuite)) == "abcd");
  CHECK(fs::is_empty(file));
}

TEST_CASE("a relative cache folder does not count, and the home's is taken") {
  const TemporaryFolder home;
  const Environment cache("XDG_CACHE_HOME", "relative");
  const Environment environment("HOME", home.path().string());
  LastFailed memory(kSuite);
  memory.note(kCases[2], false);
  memory.write(kCases);
  CHECK(fs::exists(home.path() / ".cache/slipbench"));
  CHECK_FALSE(fs::exists("relative"));
  CHECK(order_of(LastFailed(kSuite)) == "cabd");
}

TEST_CASE("a memory that is not ours is not believed") {
  const TemporaryFolder cache;
  const Environment environment("XDG_CACHE_HOME", cache.path().string());
  LastFailed memory(kSuite);
  memory.note(kCases[1], false);
  memory.write(kCases);
  for (const auto& entry : fs::directory_iterator(cache.path() / "slipbench")) {
    cache.write("slipbench/" + entry.path().filename().string(), "something else\nsuite/c.yaml\n");
  }
  CHECK(order_of(LastFailed(kSuite)) == "abcd");
}

}  // namespace
}  // namespace slipbench::driver::suite
