// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/last_failed.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/driver/history/temporary_folder.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

/// An environment variable with another value, for one test.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (before_) {
      ::setenv(name_, before_->c_str(), 1);
    } else {
      ::unsetenv(name_);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

const std::vector<std::string> kSuite = {"suite"};
const std::vector<Candidate> kCases = {
    {"suite/a.yaml", "a"}, {"suite/b.yaml", "b"}, {"suite/c.yaml", "c"}, {"suite/d.yaml", "d"}};

std::string order_of(const LastFailed& memory) {
  std::vector<Candidate> cases = kCases;
  memory.order(cases);
  std::string text;
  for (const Candidate& candidate : cases) text += candidate.label;
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
}  // namespace slipbench::driver
