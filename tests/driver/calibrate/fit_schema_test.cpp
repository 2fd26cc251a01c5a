// SPDX-License-Identifier: Apache-2.0
// The schema and the reference of fit files say what the reader does.
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "driver/calibrate/fit_reference.hpp"

namespace slipbench::driver::calibrate {
namespace {

TEST_CASE("Every key of a fit file is in its schema and once in the reference") {
  const std::string schema = fit_schema().dump();
  const std::string markdown = fit_reference_markdown();
  std::set<std::string> seen;
  for (const yaml::KeyRow& row : fit_rows()) {
    INFO(row.path);
    std::string last = row.path.substr(row.path.rfind('.') + 1);
    CHECK(schema.find("\"" + last + "\":") != std::string::npos);
    CHECK_FALSE(row.info.text.empty());
    CHECK_FALSE(row.wanted.empty());
    CHECK(row.info.required != !row.info.default_text.empty());
    CHECK(markdown.find("| `" + row.path + "` |") != std::string::npos);
    CHECK(seen.insert(row.path).second);
  }
  CHECK(seen.size() > 60);
  CHECK(seen.count("calibrate.experiments[].compare.NAME.over.quantity") == 1);
}

TEST_CASE("The schema knows what has to be there and what words there are") {
  const std::string schema = fit_schema().dump();
  CHECK(schema.find("\"required\": [\"slipbench\", \"calibrate\"]") != std::string::npos);
  CHECK(schema.find("\"required\": [\"case\", \"data\", \"time\", \"compare\"]") !=
        std::string::npos);
  CHECK(schema.find("[\"free\", \"increasing\", \"decreasing\"]") != std::string::npos);
  CHECK(schema.find("[\"linear\", \"log\"]") != std::string::npos);
  CHECK(schema.find("\"huber\"") != std::string::npos);
}

TEST_CASE("Keys of a fit file know where they belong") {
  CHECK(kFitWords.places_of_key("below") == "calibrate.experiments[].dead_band");
  CHECK(kFitWords.places_of_key("vary") == "calibrate");
  CHECK(kFitWords.places_of_key("coefficient").empty());
}

}  // namespace
}  // namespace slipbench::driver::calibrate
