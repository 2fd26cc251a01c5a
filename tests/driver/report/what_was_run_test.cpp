// SPDX-License-Identifier: Apache-2.0
#include "driver/report/what_was_run.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/report/case_for_test.hpp"

namespace slipbench::driver::report {
namespace {

TEST_CASE("a page says what was run: connection, law, stick and the steps of the history") {
  const WhatWasRun run = what_was_run(read_slider("0.2"));
  const auto words = [&](const std::string& name) {
    for (const auto& [fact, text] : run.facts) {
      if (fact == name) return text;
    }
    return std::string("nothing");
  };
  CHECK(words("connection") == "SLOT, free: CP1");
  CHECK(words("sleeve: acts along") == "CP1");
  CHECK(words("sleeve: coefficient") == "constant, 0.2");
  CHECK(words("sleeve: stick") == "stiffness 1000");
  REQUIRE(run.tables.size() == 1);
  const TextTable& history = run.tables[0];
  CHECK(history.head == std::vector<std::string>{"Step", "Duration", "Increments", "Prescribed"});
  REQUIRE(history.rows.size() == 2);
  CHECK(history.rows[0][0] == "out");
  CHECK(history.rows[0][3].find("CP1 to 0.1") != std::string::npos);
  CHECK(history.rows[1] == std::vector<std::string>{"back", "1", "10", "CP1 to 0"});
}

}  // namespace
}  // namespace slipbench::driver::report
