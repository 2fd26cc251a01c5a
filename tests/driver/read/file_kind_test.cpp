// SPDX-License-Identifier: Apache-2.0
#include "driver/read/file_kind.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "driver/yaml/parse.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::read {
namespace {

TEST_CASE("A case and a fit file are told by their keys") {
  const auto tree_of = [](const std::string& text) {
    auto tree = yaml::parse_yaml(base::SourceText("f.yaml", text));
    REQUIRE(tree.has_value());
    return std::move(*tree);
  };
  const yaml::Tree fit = tree_of("slipbench: 1\ncalibrate: {}\n");
  REQUIRE(key_of(fit.root(), FileKind::kFit).has_value());
  CHECK(key_of(fit.root(), FileKind::kFit)->where() == base::SourcePosition{2, 1, 9});
  CHECK_FALSE(key_of(fit.root(), FileKind::kCase).has_value());
  const yaml::Tree problem = tree_of("slipbench: 1\nhistory: []\n");
  REQUIRE(key_of(problem.root(), FileKind::kCase).has_value());
  CHECK(key_of(problem.root(), FileKind::kCase)->text() == "history");
  CHECK_FALSE(key_of(problem.root(), FileKind::kFit).has_value());
  const yaml::Tree sweep = tree_of("sweep: {}\n");
  CHECK(key_of(sweep.root(), FileKind::kSweep).has_value());
  CHECK(other_kind(sweep.root(), FileKind::kCase)->sentence ==
        "this is a sweep file, not a case: 'slipbench sweep f.yaml' works on it");
  CHECK(other_kind(problem.root(), FileKind::kSweep)->sentence ==
        "this is a case, not a sweep file: 'slipbench run f.yaml' runs it");
  CHECK_FALSE(other_kind(sweep.root(), FileKind::kSweep).has_value());
  // Both at once is neither: the key that does not belong is reported.
  const yaml::Tree both = tree_of("calibrate: {}\nfriction: []\n");
  CHECK_FALSE(key_of(both.root(), FileKind::kFit).has_value());
  CHECK_FALSE(key_of(both.root(), FileKind::kCase).has_value());
}

TEST_CASE("A fit or sweep file is no case if nothing of a case is in it, and if it can be parsed") {
  const TemporaryFolder folder;
  const auto no_case = [&](const std::string& text) {
    return is_no_case(folder.write("f.yaml", text));
  };
  CHECK(no_case("slipbench: 1\r\ncalibrate : {vary: {}}\r\n"));
  CHECK(no_case("slipbench: 1\nsweep:\n  case: a.yaml\n"));
  CHECK_FALSE(no_case("title: calibrate: it\n# calibrate:\n  calibrate: 1\n"));
  CHECK_FALSE(no_case("calibrated: true\n"));
  CHECK_FALSE(no_case("calibrate"));
  CHECK_FALSE(no_case(""));
  // A case that would fail must not be passed by for a line of something else in it.
  CHECK_FALSE(no_case("history: []\nsweep: {}\n"));
  CHECK_FALSE(no_case("calibrate:\n  vary: [\n"));
  CHECK_FALSE(no_case("history: []\n...\nsweep: {}\n"));
  CHECK_FALSE(no_case("history: []\ntitle: \"\nsweep: {}\n"));
  CHECK_FALSE(is_no_case(folder.path() / "missing.yaml"));
  CHECK_FALSE(is_no_case(folder.path()));
}

}  // namespace
}  // namespace slipbench::driver::read
