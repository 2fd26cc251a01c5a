// SPDX-License-Identifier: Apache-2.0
// Checks against curves, as a case file writes them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "driver/case/curve_file.hpp"
#include "tests/driver/read/read_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::read {
namespace {

using Names = std::vector<std::string>;

/// The sound case with this under `against:`, and more lines of the check.
std::string against(const std::string& text, const std::string& more = "",
                    const std::string& quantity = "FLIM") {
  return changed({{"{expression: \"= mu*FN\"}", text},
                  {"quantity: FLIM", "quantity: " + quantity},
                  {"    tolerance", more + "    tolerance"}});
}

/// A folder with a curve in it.
struct Folder {
  TemporaryFolder folder;
  std::string path = folder.path().string();
  Folder() { folder.write("a.csv", "time,FLIM\n0,1\n1,2\n"); }
};

const cases::CurveReference& curve_of(const cases::Case& problem, std::size_t check = 0) {
  return std::get<cases::CurveReference>(problem.checks.at(check).against);
}

TEST_CASE("A curve is met over time by the columns of the same names, unless it is said else") {
  const Folder at;
  const cases::Case plain = sound(against("{curve: a.csv}"), {}, at.path);
  CHECK_FALSE(plain.checks[0].abscissa);
  CHECK(curve_of(plain).shown_name == "a.csv");
  CHECK(curve_of(plain).file == at.folder.path() / "a.csv");
  CHECK(curve_of(plain).abscissa.names == Names{"time", "t", "T"});
  CHECK(curve_of(plain).column.names == Names{"FLIM"});
  CHECK_FALSE(curve_of(plain).shipped);

  const cases::Case named =
      sound(against("{curve: a.csv, abscissa: Time (s), column: F}"), {}, at.path);
  CHECK_FALSE(named.checks[0].abscissa);
  CHECK(curve_of(named).abscissa.names == Names{"Time (s)"});
  CHECK(curve_of(named).column.names == Names{"F"});
}

TEST_CASE("The abscissa of a check is a column, accumulated slip or an expression") {
  const Folder at;
  const auto check = [&](const std::string& curve, const std::string& more) {
    return sound(against(curve, more), {}, at.path).checks[0];
  };
  const cases::Check column = check("{curve: a.csv}", "    abscissa: CU1\n");
  CHECK(column.abscissa->variables == Names{"CU1"});
  CHECK(column.abscissa_text == "CU1");
  CHECK(std::get<cases::CurveReference>(column.against).abscissa.names == Names{"CU1"});

  const cases::Check slip = check("{curve: a.csv}", "    abscissa: accumulated_slip\n");
  CHECK(slip.abscissa->variables == Names{"CASUC"});
  CHECK(slip.abscissa_text == "accumulated_slip");
  CHECK(std::get<cases::CurveReference>(slip.against).abscissa.names ==
        Names{"accumulated_slip", "CASUC"});

  const cases::Check formula =
      check("{curve: a.csv, abscissa: s}", "    abscissa: = CU1 + 0.24*CUR1\n");
  CHECK(formula.abscissa->variables == Names{"CU1", "CUR1"});
  CHECK(std::get<cases::CurveReference>(formula.against).abscissa.names == Names{"s"});

  const cases::Check implied = check("{curve: a.csv, abscissa: CU1}", "");
  CHECK(implied.abscissa->variables == Names{"CU1"});
  CHECK_FALSE(check("{curve: a.csv, abscissa: CU1}", "    abscissa: t\n").abscissa);
}

TEST_CASE("Numbers of a curve are turned into the case's units") {
  const Folder at;
  const cases::Case problem =
      sound(against("{curve: a.csv, abscissa: {column: ms, unit: ms}, column: {column: load, "
                    "unit: kN}}"),
            {}, at.path);
  // A column of times is known by its unit.
  CHECK_FALSE(problem.checks[0].abscissa);
  CHECK(curve_of(problem).abscissa.conversion.scale == Approx(1e-3).epsilon(1e-12));
  CHECK(curve_of(problem).column.conversion.scale == Approx(1e3).epsilon(1e-12));
  const auto told = messages(
      against("{curve: a.csv, column: {column: load, unit: kN}}", "", "= 2*FLIM"), {}, at.path);
  REQUIRE(told.size() == 1);
  CHECK(told[0] ==
        "26:58: error: checks[0].against.column.unit: the unit of an expression is not known, so "
        "nothing can be converted to it; leave out 'unit', and convert in the expression of the "
        "quantity");
}

TEST_CASE("Checks that name one file share what is read of it") {
  const Folder at;
  const cases::Case problem =
      sound(against("{curve: a.csv}") +
                "  - {name: again, quantity: FN, against: {curve: a.csv}, tolerance: {absolute: "
                "1, why: x}}\n",
            {}, at.path);
  REQUIRE(problem.checks.size() == 2);
  CHECK(curve_of(problem, 0).data == curve_of(problem, 1).data);
}

TEST_CASE("A curve that is missing is the machine's fault, with a hint at how to make it") {
  const TemporaryFolder folder;
  const std::string text = against("{curve: golden.csv}");
  const ReadCase read = read_text(text, {}, folder.path().string());
  CHECK_FALSE(read.value);
  CHECK(read.environment_failure);
  CHECK(messages(text, {}, folder.path().string()) ==
        std::vector<std::string>{
            "26:22: error: checks[0].against.curve: golden.csv: cannot be opened: No such file or "
            "directory; 'slipbench bless' makes it of today's result, if it is to be a golden "
            "curve"});
  const ReadCase excused = read_text(text, {.curves_may_be_missing = true}, folder.path().string());
  CHECK(excused.value);
}

TEST_CASE("A folder in a curve's place is refused, also where the curve may be missing") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "a.csv");
  const ReadCase read =
      read_text(against("{curve: a.csv}"), {.curves_may_be_missing = true}, folder.path().string());
  CHECK_FALSE(read.value);
  CHECK(read.environment_failure);
}

TEST_CASE("What is wrong in a curve is left to the check, which then fails") {
  const TemporaryFolder folder;
  folder.write("a.csv", "");
  CHECK(read_text(against("{curve: a.csv}"), {}, folder.path().string()).value);
}

TEST_CASE("A name without ending is that of a curve that comes with the program") {
  const cases::Case problem =
      sound(against("{curve: dahl_loop, abscissa: x, column: F_N}", "    abscissa: CU1\n"));
  CHECK(curve_of(problem).shipped);
  CHECK(curve_of(problem).file.filename() == "dahl_loop.csv");
}

TEST_CASE("A file that checks read in ever other formats, spellings and columns is refused") {
  const Folder at;
  // 100,000 bytes, of which some 70 more copies, or 560 countings, are allowed.
  std::string wide = "time";
  for (int i = 0; i < 999; ++i) wide += ",F" + std::to_string(i);
  wide += "\n";
  while (wide.size() < 100'000) wide += std::string(999, ',') + "\n";
  at.folder.write("wide.csv", wide);
  const auto refused = [&](const std::function<std::string(int)>& curve, int checks) {
    std::string text = kSoundCase;
    for (int i = 0; i < checks; ++i) {
      text += "  - {name: c" + std::to_string(i) +
              ", quantity: FLIM, against: {curve: " + curve(i) +
              "}, tolerance: {relative: 1, why: x}}\n";
    }
    const std::vector<std::string> found = messages(text, {}, at.path);
    return std::count_if(found.begin(), found.end(), [](const std::string& message) {
      return message.ends_with(
          "files of numbers are read again and again: too often for a case; compare with a file in "
          "one format, and with few columns of one that lacks samples");
    });
  };
  const auto skipping = [](int i) { return "{file: wide.csv, skip: " + std::to_string(i) + "}"; };
  CHECK(refused(skipping, 60) == 0);
  CHECK(refused(skipping, 200) > 10);
  const auto spelt = [](int i) {
    std::string path = "wide.csv";
    for (int k = 0; k < i; ++k) path.insert(0, "./");
    return path + ", column: F1";
  };
  CHECK(refused(spelt, 60) == 0);
  CHECK(refused(spelt, 200) > 10);
  const auto held = [](int i) {
    return "{file: wide.csv, missing: hold}, column: F" + std::to_string(i);
  };
  CHECK(refused(held, 500) == 0);
  CHECK(refused(held, 990) > 10);
  // One format of one file.
  CHECK(refused([](int i) { return "wide.csv, column: F" + std::to_string(i); }, 990) == 0);
}

TEST_CASE("A tolerance of positions is enough where positions are compared") {
  const std::string text =
      changed({{"{relative: 1.0e-2, why: rounding}", "{abscissa: 0.1, why: x}"},
               {"    tolerance", "    criterion: reversals\n    abscissa: CU1\n    tolerance"}});
  const cases::Case problem = sound(text);
  CHECK(problem.checks[0].tolerance.abscissa == 0.1);
  CHECK(problem.checks[0].criterion == cases::Criterion::kReversals);
}

TEST_CASE("A tolerance that no curve can miss is refused") {
  const auto told = [](const std::string& tolerance, const std::string& criterion) {
    return messages(
        changed({{"{relative: 1.0e-2, why: rounding}", tolerance},
                 {"    tolerance", "    criterion: " + criterion + "\n    tolerance"}}));
  };
  CHECK(told("{absolute: 0.5, relative: 1, why: x}", "iso18571") ==
        std::vector<std::string>{
            "28:42: error: checks[0].tolerance.relative: wanted less than 1, found 1: iso18571 "
            "compares one minus the rating, which no curve can exceed"});
  CHECK(told("{absolute: 20, why: x}", "iso18571").size() == 1);
  CHECK(told("{absolute: 0.99, why: x}", "iso18571").empty());
  CHECK(told("{absolute: 20, why: x}", "sprague_geers").empty());
}

TEST_CASE("A check has a name") {
  for (const char* name : {"\"\"", "\"  \""}) {
    const auto told = messages(changed({{"name: limit", std::string("name: ") + name}}));
    REQUIRE(told.size() == 1);
    CHECK(told[0].find("error: checks[0].name: the name of a check must not be empty") !=
          std::string::npos);
  }
}

}  // namespace
}  // namespace slipbench::driver::read
