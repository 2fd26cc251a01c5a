// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/diagnostic.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/text/source_text.hpp"

namespace slipbench::driver::base {
namespace {

Diagnostic at(SourcePosition where) {
  return {Severity::kError, "shock.yaml", where, "mu", "wrong", ""};
}

TEST_CASE("An error is shown as a compiler shows it") {
  const SourceText source("shock.yaml", std::string(8, '\n') + "    coeficient: 0.15\n");
  const Diagnostic error{Severity::kError,         "shock.yaml",  {9, 5, 10},
                         "friction[0].coeficient", "unknown key", "did you mean 'coefficient'?"};
  CHECK(render(error, &source) ==
        "shock.yaml:9:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?\n"
        "    9 |     coeficient: 0.15\n"
        "      |     ^~~~~~~~~~\n");
  CHECK(
      render(error) ==
      "shock.yaml:9:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?\n");
}

TEST_CASE("A message without place, file or path leaves them out") {
  CHECK(render({Severity::kError, "a.yaml", {}, "", "is a directory, not a file", ""}) ==
        "a.yaml: error: is a directory, not a file\n");
  CHECK(render({Severity::kWarning, "", {}, "", "nothing to do", ""}) ==
        "warning: nothing to do\n");
  CHECK(render({Severity::kNote, "", {}, "output", "unused", ""}) == "note: output: unused\n");
}

TEST_CASE("The caret stands under the character, not under the byte") {
  const SourceText source("shock.yaml",
                          "gr\xC3\xB6\xC3\x9F"
                          "e: 1,5\n");
  CHECK(render(at(source.position(9, 3)), &source) ==
        "shock.yaml:1:8: error: mu: wrong\n"
        "    1 | gr\xC3\xB6\xC3\x9F"
        "e: 1,5\n"
        "      |        ^~~\n");
}

TEST_CASE("A caret past the end or a length beyond the line is cut") {
  const SourceText source("shock.yaml", "mu: 1\n");
  CHECK(render(at({1, 4, 99}), &source) ==
        "shock.yaml:1:4: error: mu: wrong\n    1 | mu: 1\n      |    ^~\n");
  CHECK(render(at({1, 99, 5}), &source) ==
        "shock.yaml:1:99: error: mu: wrong\n    1 | mu: 1\n      |      ^\n");
  CHECK(render(at({7, 1, 1}), &source) == "shock.yaml:7:1: error: mu: wrong\n");
}

TEST_CASE("No cell of a CSV file begins like a formula, and the text comes back") {
  for (const auto& [text, cells] : {std::pair{"=a,=b;+c,-d, -e,@f=g", "=a,'=b;'+c,'-d, -e,'@f=g"},
                                    {"a,\"=b\",\"\"-c", "a,\"'=b\",\"\"'-c"},
                                    {"plain, as most", "plain, as most"}}) {
    CHECK(in_cells(text) == cells);
    CHECK(out_of_cells(cells) == text);
  }
  for (const char* const name : {"=a", "+1", "-CSF2", "@x"}) {
    CHECK(in_cell(name) == "'" + std::string(name));
    CHECK(out_of_cell(in_cell(name)) == name);
  }
  for (const char* const name : {"", "'", "CSF2", "max(CSF1,-2)", "'CSF2"}) {
    CHECK(in_cell(name) == name);
    CHECK(out_of_cell(name) == name);
  }
}

TEST_CASE("Control characters and broken bytes never reach the terminal") {
  const std::string_view dot = "\xEF\xBF\xBD";
  CHECK(printable("a\x1B[31mb") == "a" + std::string(dot) + "[31mb");
  CHECK(printable("\x7F") == dot);
  CHECK(printable("\xC2\x9B") == dot);
  CHECK(printable("\xE2\x80\xAE") == dot);  // NOLINT(misc-misleading-bidirectional)
  CHECK(printable("\xFF") == dot);
  CHECK(printable("a\tb") == "a b");
  const SourceText source("shock.yaml", "\tmu: \x1B[2J5\n");
  CHECK(render(at({1, 2, 2}), &source) == "shock.yaml:1:2: error: mu: wrong\n    1 |  mu: " +
                                              std::string(dot) + "[2J5\n      |  ^~\n");
}

TEST_CASE("A very long line is cut around the caret") {
  const SourceText source("shock.yaml", std::string(5000, 'x') + "HERE" + std::string(5000, 'y'));
  const std::string text = render(at({1, 5001, 4}), &source);
  CHECK(text == "shock.yaml:1:5001: error: mu: wrong\n    1 | ..." + std::string(50, 'x') + "HERE" +
                    std::string(46, 'y') + "...\n      | " + std::string(53, ' ') + "^~~~\n");
}

TEST_CASE("Messages are listed by file and place, equal places as they came") {
  Diagnostics list;
  list.error("a.yaml", {9, 1}, "", "third");
  list.warning("b.yaml", {1, 1}, "", "fourth");
  list.error("a.yaml", {2, 5}, "", "first");
  list.note("a.yaml", {2, 5}, "", "second");
  std::vector<std::string> order;
  for (const Diagnostic& diagnostic : list.sorted()) order.push_back(diagnostic.message);
  CHECK(order == std::vector<std::string>{"first", "second", "third", "fourth"});
  CHECK(list.has_errors());
  CHECK(list.count(Severity::kError) == 2);
  CHECK(summary(list) == "2 errors, 1 warning");
}

TEST_CASE("Warnings and notes alone are no errors") {
  Diagnostics list;
  CHECK(list.empty());
  list.warning("a", {}, "", "w");
  list.note("a", {}, "", "n");
  CHECK_FALSE(list.has_errors());
  CHECK_FALSE(list.empty());
  CHECK(summary(list) == "1 warning");
}

TEST_CASE("A flood of messages ends with their number") {
  Diagnostics list;
  for (int i = 0; i < 100000; ++i) list.error("a.yaml", {i + 1, 1}, "", "bad");
  list.warning("a.yaml", {3, 1}, "", "odd");
  CHECK(list.sorted().size() == Diagnostics::kMaxKept + 1);
  const std::string text = render(list);
  CHECK(text.find("a.yaml:20:1: error: bad\n... and 99980 more errors\n") != std::string::npos);
  CHECK(text.find("a.yaml:3:1: warning: odd\n") != std::string::npos);
  Diagnostics both = list;
  both.append(list);
  CHECK(both.count(Severity::kError) == 200000);
  CHECK(both.count(Severity::kWarning) == 2);
}

TEST_CASE("Lines are quoted from the text of their own file") {
  const std::vector<SourceText> sources = {SourceText("a.yaml", "one\n"),
                                           SourceText("b.yaml", "two\n")};
  Diagnostics list;
  list.error("b.yaml", {1, 1, 3}, "", "bad");
  CHECK(render(list, sources) == "b.yaml:1:1: error: bad\n    1 | two\n      | ^~~\n");
}

TEST_CASE("The nearest known name forgives slips of the finger but does not guess wildly") {
  const std::array<std::string_view, 5> names = {"coefficient", "contact_force", "component", "mu",
                                                 "CP1"};
  CHECK(nearest_name("coeficient", names) == "coefficient");
  CHECK(nearest_name("Coefficient", names) == "coefficient");
  CHECK(nearest_name("contact-force", names) == "contact_force");
  CHECK(nearest_name("componetn", names) == "component");
  CHECK(nearest_name("MU", names) == "mu");
  CHECK(nearest_name("cp1", names) == "CP1");
  CHECK(nearest_name("CPR", names) == "CP1");
  CHECK_FALSE(nearest_name("m", names).has_value());
  CHECK_FALSE(nearest_name("stiffness", names).has_value());
  CHECK_FALSE(nearest_name("", names).has_value());
  CHECK_FALSE(nearest_name(std::string(100000, 'c'), names).has_value());
  CHECK_FALSE(nearest_name("mu", {}).has_value());
}

TEST_CASE("Names are listed in words") {
  const std::array<std::string_view, 3> names = {"CP1", "CPR1", "CP2"};
  CHECK(in_words(names) == "CP1, CPR1 or CP2");
  CHECK(in_words(std::span(names).first(2), "and") == "CP1 and CPR1");
  CHECK(in_words(std::span(names).first(1)) == "CP1");
  CHECK(in_words({}).empty());
}

}  // namespace
}  // namespace slipbench::driver::base
