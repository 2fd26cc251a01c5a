// SPDX-License-Identifier: Apache-2.0
#include "driver/read/foreign_file.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "driver/read/read_case.hpp"

namespace slipbench::driver::read {
namespace {

/// Returns what is said of a text that is given as a case, without the lines that are quoted.
std::string said_of(const std::string& name, const std::string& text) {
  const base::SourceText source(name, text);
  const ReadCase read = read_case_text(source, ".");
  CHECK_FALSE(read.value);
  return base::render(read.diagnostics);
}

TEST_CASE("a file of another program is named as what it is, with what to do") {
  CHECK(
      said_of("a.rad", "#RADIOSS STARTER\n/BEGIN\nx\n  2022  0\n") ==
      "a.rad:2:1: error: this is a Radioss deck, not a case; 'slipbench import a.rad' makes cases "
      "of its friction\n");
  CHECK(said_of("a.inp", "** a comment\n*CONNECTOR FRICTION\n0.2\n") ==
        "a.inp:1:1: error: this is an Abaqus input file, not a case; a case is YAML; 'slipbench "
        "describe SLOT' tells the keys of a connection\n");
  const std::string columns =
      ":1:1: error: these are numbers in columns, not a case; a case names such a file as 'csv:' "
      "or "
      "'curve:'; 'slipbench plot' draws a result\n";
  CHECK(said_of("r.csv", "t,CP1,CSF1\n0,0,0\n") == "r.csv" + columns);
  CHECK(said_of("r.txt", "0;1,5;2\n0;1,5;2\n") == "r.txt" + columns);
  CHECK(said_of("c.yaml", "\n# nothing yet\n") ==
        "c.yaml:1:1: error: the file is empty; a case begins with 'slipbench: 1'; 'slipbench "
        "describe SLOT' tells the keys of a connection\n");
}

TEST_CASE("a fault of a case is not taken for another kind of file") {
  for (const char* text :
       {"slipbench: 1\ntitle: \"open\n", "title: a: b\n", "# deck\nslipbench 1\n", "- a\n- b\n",
        "friction:\n\t- a\n", "word\n", "/friction: a: b\n"}) {
    CAPTURE(text);
    CHECK_FALSE(foreign_file(base::SourceText("c.yaml", text)).has_value());
  }
}

}  // namespace
}  // namespace slipbench::driver::read
