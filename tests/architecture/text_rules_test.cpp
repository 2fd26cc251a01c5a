// SPDX-License-Identifier: Apache-2.0
#include "tests/architecture/text_rules.hpp"

#include <catch2/catch.hpp>

namespace slipbench::architecture {
namespace {

TEST_CASE("comments and strings are blanked and lines stay where they are") {
  const std::string text =
      "int a = 1'000;  // it's\n/* b\n c */ char d = '\"';\nauto e = \"// no\";\n"
      "auto f = R\"(x \" /* y)\";\nint g;\n";
  CHECK(without_comments(text, Strings::kKeep) ==
        "int a = 1'000;         \n    \n      char d = '\"';\nauto e = \"// no\";\n"
        "auto f = R\"(x \" /* y)\";\nint g;\n");
  CHECK(without_comments(text, Strings::kBlank) ==
        "int a = 1'000;         \n    \n      char d = ' ';\nauto e = \"     \";\n"
        "auto f = R\"          \";\nint g;\n");
}

TEST_CASE("a law that throws, writes or builds strings is found") {
  const auto found = [](const std::string& line) {
    return law_violations({"law/a.hpp", "int a;\n" + line + "\n"}).size();
  };
  CHECK(found("throw 1;") == 1);
  CHECK(found("std::string name;") == 1);
  CHECK(found("#include <string>") == 1);
  CHECK(found("#include <iostream>") == 1);
  CHECK(found("void print(std::ostream& out);") == 1);
  CHECK(found("auto s = std::to_string(1);") == 1);
  CHECK(found("std::printf(text);") == 1);

  CHECK(found("std::string_view name;") == 0);
  CHECK(found("#include <string_view>") == 0);
  CHECK(found("// throws nothing: no throw, no std::string") == 0);
  CHECK(found("constexpr const char* kText = \"throw\";") == 0);
  CHECK(found("int thrown = rethrow_count;") == 0);
  CHECK(law_violations({"driver/a.hpp", "throw 1;\n"}).empty());
}

TEST_CASE("a look at the clock on the wall is found") {
  const auto found = [](const std::string& line) {
    return clock_violations({"driver/a.cpp", line + "\n"}).size();
  };
  CHECK(found("auto now = std::chrono::system_clock::now();") == 1);
  CHECK(found("const auto now = std::time(nullptr);") == 1);
  CHECK(found("fs::last_write_time(file)") == 1);
  CHECK(found("auto now = std::chrono::steady_clock::now();") == 0);
  CHECK(found("const double t = grid.time();") == 0);
}

TEST_CASE("a plot template that reads a case or runs a program is found") {
  const auto found = [](const std::string& line) {
    return plot_violations({"plots/a.gp", line + "\n"}).size();
  };
  CHECK(found("plot result using 1:2 with lines") == 0);
  CHECK(found("title = 'examples/shock.yaml'") == 1);
  CHECK(found("x = system('ls')") == 1);
  CHECK(found("plot \"< cat a.csv\"") == 1);
}

TEST_CASE("a test case that ctest would not run is found") {
  const std::string text = "\nTEST_CASE(\"a\") {}\n  TEMPLATE_TEST_CASE(\"b\", \"\", int) {}\n";
  CHECK(test_case_violations({"tests/law/a.cpp", text}).size() == 2);
  CHECK(test_case_violations({"tests/law/a.hpp", "SCENARIO(\"a\") {}\n"}).size() == 1);
  CHECK(test_case_violations({"tests/law/a_test.cpp", text}).empty());
  CHECK(test_case_violations({"tests/law/a.cpp", "// no TEST_CASE(here)\n"}).empty());
}

TEST_CASE("a comment that begins with a question is found, one that goes on with it is none") {
  const std::vector<Violation> found = comment_violations(
      {"law/a.hpp",
       "/// Tells\n/// Whether it grips.\nbool a();\n  /// What is left.\nint b();\n"});
  REQUIRE(found.size() == 1);
  CHECK(found[0].line == 4);
  CHECK(comment_violations({"law/a.hpp", "// What is left is rounding.\n"}).empty());
}

TEST_CASE("a source without its licence line is found") {
  const std::string licence = std::string("SPDX-License-") + "Identifier: Apache-2.0\n";
  const auto ok = [](const std::string& path, const std::string& text) {
    return licence_violations({path, text}).empty();
  };
  CHECK(ok("law/a.hpp", "// " + licence + "#pragma once\n"));
  CHECK_FALSE(ok("law/a.hpp", "#pragma once\n// " + licence));
  CHECK_FALSE(ok("law/a.hpp", ""));
  CHECK(ok("law/CMakeLists.txt", "# " + licence));
  CHECK_FALSE(ok("law/CMakeLists.txt", "add_library(a)\n"));
  CHECK(ok("scripts/a.sh", "#!/usr/bin/env bash\n# " + licence));
  CHECK_FALSE(ok("scripts/a.sh", "#!/usr/bin/env bash\n"));
  CHECK_FALSE(ok(".ci/run", "#!/usr/bin/env bash\n"));
  CHECK_FALSE(ok("tests/schema/a.py", "import json\n"));
  CHECK(ok("docs/a.md", "# A\n"));
}

TEST_CASE("a place outside of the repository is found") {
  const auto found = [](const std::string& path, const std::string& line) {
    return outside_violations({path, line + "\n"}, "/srv/checkouts/slipbench").size();
  };
  const std::string home = "/ho";
  const std::string users = "/Use";
  CHECK(found("docs/a.md", "see " + home + "me/ada/notes.txt") == 1);
  CHECK(found("docs/a.md", "see " + users + "rs/ada/notes.txt") == 1);
  CHECK(found("docs/a.md", "see /ro" + std::string("ot/notes.txt")) == 1);
  CHECK(found("driver/a.cpp", "// /srv/checkouts/slipbench/driver") == 1);
  CHECK(found("README.md", "[more](../elsewhere/a.md)") == 1);
  CHECK(found("docs/a.md", "[more](../../elsewhere/a.md)") == 1);
  CHECK(found("scripts/a.sh", "cd \"$here\"/../../elsewhere") == 1);

  CHECK(found("docs/a.md", "[more](../law/table/table.hpp), /usr/share, /tmp/a") == 0);
  CHECK(found("docs/a.md", "https://example.org/home/page") == 0);
  CHECK(found("scripts/a.sh", "cd \"$here\"/..") == 0);
  CHECK(found("driver/a.cpp", "const char* kHostile = \"../../../etc/passwd\";") == 0);
}

}  // namespace
}  // namespace slipbench::architecture
