// SPDX-License-Identifier: Apache-2.0
// The JSON Schema and the case reference say what the reader does.
#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "driver/calibrate/fit_reference.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/sweep/sweep_reference.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::read {
namespace {

TEST_CASE("Every key of a case is in the schema and in the case reference") {
  const std::string schema = case_schema().dump();
  const std::string markdown = case_reference_markdown();
  std::size_t keys = 0;
  for (const yaml::KeyRow& row : case_rows()) {
    INFO(row.path);
    std::string last = row.path.substr(row.path.rfind('.') + 1);
    if (last.find('|') == std::string::npos) {
      if (const std::size_t list = last.find("[]"); list != std::string::npos) last.resize(list);
      CHECK(schema.find("\"" + last + "\":") != std::string::npos);
      ++keys;
    }
    CHECK_FALSE(row.info.text.empty());
    CHECK_FALSE(row.wanted.empty());
    std::string cell = "| `";
    for (const char c : row.path) {
      if (c == '|') cell += '\\';
      cell += c;
    }
    CHECK(markdown.find(cell + "` |") != std::string::npos);
  }
  CHECK(keys > 60);
}

TEST_CASE("The case reference lists every key once") {
  std::set<std::string> seen;
  for (const yaml::KeyRow& row : case_rows()) {
    INFO(row.path);
    CHECK(seen.insert(row.path).second);
  }
}

TEST_CASE("A required key is required by the schema, with the same words for its values") {
  const std::string schema = case_schema().dump();
  CHECK(schema.find("\"required\": [\"slipbench\", \"connector\", \"friction\", \"history\"]") !=
        std::string::npos);
  CHECK(schema.find("[\"constant\", \"linear\"]") != std::string::npos);
  CHECK(schema.find("[\"norm\", \"sum\", \"macauley_sum\"]") != std::string::npos);
  CHECK(schema.find("\"additionalProperties\": false") != std::string::npos);
}

TEST_CASE("docs/case-reference.md is what the declarations say today") {
  std::ifstream file(test::source_dir() + "/docs/case-reference.md", std::ios::binary);
  REQUIRE(file.good());
  std::ostringstream text;
  text << file.rdbuf();
  INFO("write it anew with: slipbench schema --markdown > docs/case-reference.md");
  CHECK(text.str() == case_reference_markdown() + calibrate::fit_reference_markdown() +
                          sweep::sweep_reference_markdown());
}

TEST_CASE("Keys know where they belong") {
  CHECK(places_of_key("elastic_slip") ==
        "friction[].stick or history[].change_friction.NAME.stick");
  CHECK(places_of_key("step") == "history[] or checks[]");
  CHECK(places_of_key("smooth_to") == "a profile");
  CHECK(places_of_key("checks") == "the top level");
  CHECK(places_of_key("nonsense").empty());
  CHECK(place_of_quantity("CPR3") == "history[].motion");
  CHECK(place_of_quantity("m1") == "history[].force");
  CHECK(place_of_quantity("field16") == "history[].fields");
  CHECK(place_of_quantity("field17").empty());
  REQUIRE(later_key("adaptive").has_value());
  CHECK(later_key("adaptive")->in_place_of == "increments");
  CHECK_FALSE(later_key("increments").has_value());
}

}  // namespace
}  // namespace slipbench::driver::read
