// SPDX-License-Identifier: Apache-2.0
// Every connection type has a minimal case that runs, a drawing and a formula.
#include <algorithm>
#include <catch2/catch.hpp>

#include "driver/commands/minimal_case.hpp"
#include "law/connection/connection_type.hpp"
#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

std::vector<std::string> all_types() {
  std::vector<std::string> names;
  law::for_each_connection_type(
      [&]<class Type>(std::type_identity<Type>) { names.emplace_back(Type::kInfo.name); });
  return names;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("the minimal case of every connection type runs, rubs and passes its check") {
  const TemporaryFolder folder;
  REQUIRE(all_types().size() == 25);
  for (const std::string& type : all_types()) {
    INFO(type);
    const std::string word = "'" + type + "'";
    const Ended written = slipbench(folder, "new " + word + " -o " + word + ".yaml");
    CHECK(written.code == 0);
    CHECK(file_text(folder.path() / (type + ".yaml")) == slipbench(folder, "new " + word).output);
    const Ended run = slipbench(folder, "run " + word + ".yaml --no-output");
    INFO(run.output);
    CHECK(run.code == 0);
    CHECK(contains(run.output, " slips "));
    // Of its two checks, one slides and one spins, and both have the same number for it.
    CHECK(contains(run.output, "warning") == (type == "PLANAR"));
    CHECK_FALSE(contains(run.output, "note"));
  }
  const Ended check = slipbench(folder, "check .");
  INFO(check.output);
  CHECK(check.code == 0);
  CHECK(contains(check.output, "25 cases passed, 0 failed"));
}

TEST_CASE("new replaces nothing, and a type that it does not know is answered by the nearest") {
  const TemporaryFolder folder;
  folder.write("a.yaml", "mine");
  const Ended there = slipbench(folder, "new SLOT -o a.yaml");
  CHECK(there.code == 4);
  CHECK(there.output ==
        "slipbench: error: a.yaml: is there already and is not replaced; choose another name or "
        "remove it\n");
  CHECK(file_text(folder.path() / "a.yaml") == "mine");
  const Ended nowhere = slipbench(folder, "new SLOT -o no/a.yaml");
  CHECK(nowhere.code == 4);
  CHECK(nowhere.output == "slipbench: error: no/a.yaml: No such file or directory\n");
  const Ended unknown = slipbench(folder, "new HNGE");
  CHECK(unknown.code == 2);
  CHECK(unknown.output == "slipbench: error: no connection type 'HNGE'; did you mean 'HINGE'?\n");
  CHECK(slipbench(folder, "new nothing").output ==
        "slipbench: error: no connection type 'nothing'; 'slipbench list connections' shows all\n");
}

TEST_CASE("describe draws every connection type, tells its contact force and its minimal case") {
  const TemporaryFolder folder;
  for (const std::string& type : all_types()) {
    INFO(type);
    const std::string sketch(connection_sketch(type));
    CHECK(std::count(sketch.begin(), sketch.end(), '\n') >= 1);
    CHECK(sketch.ends_with('\n'));
    CHECK(std::all_of(sketch.begin(), sketch.end(),
                      [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
    const std::string text = slipbench(folder, "describe '" + type + "'").output;
    CHECK(contains(text, "  contact force; the limit is mu times it\n    "));
    CHECK(contains(text, "_N = ") == (type != "UJOINT"));
    CHECK(contains(text, "\n\n" + minimal_case(type)));
  }
  CHECK(contains(slipbench(folder, "describe HINGE").output,
                 "    M_N = R_a |f1| + R_p sqrt(f2^2 + f3^2) + (2 R_p/L_s) sqrt(m2^2 + m3^2) + "
                 "M_int\n"));
}

}  // namespace
}  // namespace slipbench::driver::commands
