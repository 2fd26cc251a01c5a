// SPDX-License-Identifier: Apache-2.0
// What the reader says of tables whose arguments may surprise.
#include <catch2/catch.hpp>
#include <string>

#include "driver/read/read_case.hpp"

namespace slipbench::driver::read {
namespace {

/// A slot whose press fit is a table; `reference` and `drives` vary.
ReadCase slot(const std::string& independents, const std::string& reference,
              const std::string& drives) {
  const std::string text =
      "slipbench: 1\n"
      "connector: {type: SLOT, initial: {CP1: 5}" +
      reference +
      "}\n"
      "friction:\n"
      "  - component: 1\n"
      "    coefficient: 0.2\n"
      "    stick: {elastic_slip: 0.01}\n"
      "    internal_contact_force: {columns: [force, " +
      independents +
      "], rows: [[100, 0], [90, 10]]}\n"
      "history:\n"
      "  - {step: go, increments: 1, motion: {CP1: {to: 6}}" +
      drives + "}\n";
  return read_case_text(base::SourceText("c.yaml", text), ".");
}

std::string said(const ReadCase& read) {
  REQUIRE(read.value);
  return base::render(read.diagnostics, read.sources);
}

TEST_CASE("A table over a temperature or field that nobody gives is warned of") {
  CHECK(
      said(slot("temperature", "", "")).find("warning: friction: a table depends on temperature") !=
      std::string::npos);
  CHECK(said(slot("temperature", "", ", temperature: 20")).empty());
  CHECK(said(slot("field2", "", "")).find("depends on field2, which the history never gives") !=
        std::string::npos);
  CHECK(said(slot("field2", "", ", fields: {field2: 1}")).empty());
}

TEST_CASE("A table over CU is explained where it is not the displacement") {
  CHECK(said(slot("CU1", "", "")).empty());
  CHECK(said(slot("CU1", ", reference: {CP1: 2}", ""))
            .find("note: friction: a table over CU1 sees the constitutive motion CP1 - 2") !=
        std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::read
