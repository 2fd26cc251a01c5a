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

TEST_CASE("A fit or sweep file is known by a line of its own, without being sound") {
  const TemporaryFolder folder;
  const auto looks = [&](const std::string& text) {
    return looks_like_no_case(folder.write("f.yaml", text));
  };
  CHECK(looks("calibrate:\n  vary: [\n"));
  CHECK(looks("slipbench: 1\r\ncalibrate : {}\r\n"));
  CHECK_FALSE(looks("title: calibrate: it\n# calibrate:\n  calibrate: 1\n"));
  CHECK(looks("slipbench: 1\nsweep:\n  case: a.yaml\n"));
  CHECK_FALSE(looks("calibrated: true\n"));
  CHECK_FALSE(looks("calibrate"));
  CHECK_FALSE(looks(""));
  CHECK_FALSE(looks_like_no_case(folder.path() / "missing.yaml"));
  CHECK_FALSE(looks_like_no_case(folder.path()));
}

}  // namespace
}  // namespace slipbench::driver::read
