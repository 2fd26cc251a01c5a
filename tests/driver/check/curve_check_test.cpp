// SPDX-License-Identifier: Apache-2.0
// Checks against curves, over time and over other abscissas.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/check/check.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::check {
namespace {

base::Expression compiled(const std::string& text, const std::vector<std::string>& variables) {
  auto expression = base::Expression::compile(text, variables);
  REQUIRE(expression);
  return std::move(*expression);
}

/// A check of CSF1 against columns of a file.
cases::Check curve_check(const std::filesystem::path& file, cases::Tolerance tolerance,
                         const std::string& abscissa = "time", const std::string& column = "F") {
  cases::Check check{.name = "test",
                     .quantity = compiled("CSF1", {"CSF1"}),
                     .quantity_text = "CSF1",
                     .variables = {"CSF1"},
                     .against = cases::CurveReference{.file = file,
                                                      .shown_name = file.filename().string(),
                                                      .abscissa = {{abscissa}, {}},
                                                      .column = {{column}, {}},
                                                      .data = {}},
                     .step = {},
                     .from = {},
                     .to = {},
                     .tolerance = std::move(tolerance),
                     .where = {}};
  if (abscissa != "time") {
    check.abscissa = cases::ExpressionReference{compiled("CU1", {"CU1"}), {"CU1"}};
    check.abscissa_text = "CU1";
  }
  return check;
}

Verdict verdict_of(const cases::Case& problem, const cases::Check& check, Trace keep = Trace::kNone,
                   CheckTrace* trace = nullptr) {
  CheckProgress progress(problem, check, keep);
  for (const bench::Row& row : bench::rows_of(problem)) progress.add(row);
  if (trace != nullptr) *trace = progress.trace();
  return progress.verdict();
}

/// Out to 0.1 mm in 1 s and back to -0.1 mm: 20 N at 0.02 mm; from 20 N back to -20 N over 0.04 mm.
cases::Case loop(int increments = 10) {
  return bench::slider_case({bench::step("out", increments, 0, history::LinearTo{0.1}),
                             bench::step("back", 2 * increments, 0, history::LinearTo{-0.1}, 2.0)});
}

/// The exact force of `loop` at these times, times `factor`.
std::string exact_curve(const std::vector<double>& times, double factor = 1.0) {
  std::string text = "time,u,F\n";
  for (const double time : times) {
    const double u = time <= 1.0 ? 0.1 * time : 0.1 - 0.1 * (time - 1.0);
    const double force =
        time <= 1.0 ? std::min(20.0, 1000.0 * u) : std::max(-20.0, 20.0 - 1000.0 * (0.1 - u));
    text += base::format_number(time) + "," + base::format_number(u) + "," +
            base::format_number(factor * force) + "\n";
  }
  return text;
}

/// With all the corners of the exact force.
const std::vector<double> kTimes{0.0, 0.1, 0.2, 0.5, 1.0, 1.1, 1.4, 2.0, 3.0};

TEST_CASE("a curve over time is met between the rows of the result") {
  const TemporaryFolder folder;
  const cases::Check check =
      curve_check(folder.write("a.csv", exact_curve(kTimes)), {1e-9, {}, ""});
  // Rounding only: the corners are rows of the result, too.
  const Verdict verdict = verdict_of(loop(), check);
  INFO(verdict.message);
  CHECK(verdict.passed);
  CHECK(verdict.compared == 9);
  CHECK(verdict.abscissa == "t [s]");
  CHECK(verdict.unit == "N");
  // So they are with 37 times as many increments.
  CHECK(verdict_of(loop(370), check).passed);
}

TEST_CASE("a failure over time is told in times, with what it looks like") {
  const TemporaryFolder folder;
  const cases::Check check =
      curve_check(folder.write("a.csv", exact_curve(kTimes, 1.1)), {1.5, {}, ""});
  const Verdict verdict = verdict_of(loop(), check);
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.failing == 6);
  CHECK(verdict.message.find("CSF1 off by 2 N (limit 1.5) at t = ") == 0);
  CHECK(verdict.message.find(", first at 0.2, last at 3, 6 of 9 points") != std::string::npos);
  CHECK(verdict.first_failing.value() == Approx(0.2));
  CHECK(verdict.last_failing.value() == Approx(3.0));
  CHECK(verdict.worst_fraction() == Approx(2.0 / 1.5));
  CHECK(verdict.scale == Approx(44.0));
}

TEST_CASE("a curve may have fewer rows than the run, more, or others") {
  const TemporaryFolder folder;
  const auto judged = [&](const std::vector<double>& times, double factor = 1.0) {
    return verdict_of(
        loop(), curve_check(folder.write("a.csv", exact_curve(times, factor)), {1e-9, {}, ""}));
  };
  std::vector<double> rows;
  for (int i = 0; i <= 30; ++i) rows.push_back(i <= 10 ? 0.1 * i : 1.0 + 0.1 * (i - 10));
  CHECK(judged(rows).passed);
  CHECK(judged(rows).compared == 31);
  CHECK(judged(rows).warnings.empty());
  // The last row is not wrong, the run does not reach it.
  std::vector<double> more = rows;
  more.push_back(3.1);
  CHECK(judged(more).passed);
  CHECK(judged(more).compared == 31);
  CHECK(judged({rows.begin(), rows.end() - 1}).passed);
  CHECK(judged({rows.begin(), rows.end() - 1}).compared == 30);
  // A row that is missing, and one between two rows of the run.
  std::vector<double> others = rows;
  others.erase(others.begin() + 7);
  others[20] += 0.05;
  CHECK(judged(others).passed);
  CHECK(judged(others).compared == 30);
  const Verdict wrong = judged(rows, 1.5);
  CHECK(wrong.failing == judged(more, 1.5).failing);
  CHECK(wrong.message == judged(rows, 1.5).message);
  CHECK(wrong.first_failing.value() == Approx(0.1));
}

TEST_CASE("a loop over a position is compared branch by branch") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", exact_curve(kTimes));
  CHECK(verdict_of(loop(), curve_check(file, {1e-9, {}, ""}, "u")).passed);
  const auto wrong = folder.write("b.csv", exact_curve(kTimes, 1.1));
  const Verdict verdict = verdict_of(loop(), curve_check(wrong, {1.5, {}, ""}, "u"));
  INFO(verdict.message);
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.abscissa == "CU1 [mm]");
  CHECK(verdict.message.find("CSF1 off by 2 N (limit 1.5) at CU1 = ") == 0);
  CHECK(verdict.message.find(" mm (t = ") != std::string::npos);
  CHECK(verdict.message.find(", first at t = 0.2, last at 3, 6 of 9 points") != std::string::npos);
}

TEST_CASE("a check against a curve that cannot be compared fails and says why") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& bytes, const std::string& column = "F") {
    const Verdict verdict = verdict_of(
        loop(), curve_check(folder.write("a.csv", bytes), {1e9, {}, ""}, "time", column));
    CHECK_FALSE(verdict.passed);
    return verdict.message;
  };
  CHECK(message(exact_curve(kTimes), "G") == "a.csv: no column 'G'; the columns are time, u and F");
  CHECK(message("time,F\n0,1\n1,nan\n").find("a.csv:3:3: column 'F' holds 'nan'") == 0);
  CHECK(message("time,F\n").find("a.csv:1:1: no rows follow the header") == 0);
  CHECK(message("").find("a.csv:1:1: the file is empty") == 0);
  CHECK_FALSE(message("time,F\n7,1\n8,1\n").empty());
  CHECK_FALSE(message("time,F\n1,1\n0,1\n").empty());
}

TEST_CASE("a number that the change of unit makes infinite fails") {
  const TemporaryFolder folder;
  cases::Check check = curve_check(folder.write("a.csv", "time,F\n0,1e308\n1,1\n"), {1e9, {}, ""});
  std::get<cases::CurveReference>(check.against).column.conversion.scale = 1e3;
  CHECK(verdict_of(loop(), check).message ==
        "a.csv: a number exceeds the range of a double in the case's unit");
}

TEST_CASE("units of the curve are converted to those of the case") {
  const TemporaryFolder folder;
  cases::Check check =
      curve_check(folder.write("a.csv", exact_curve(kTimes, 1e-3)), {1e-9, {}, ""});
  CHECK_FALSE(verdict_of(loop(), check).passed);
  std::get<cases::CurveReference>(check.against).column.conversion.scale = 1e3;
  CHECK(verdict_of(loop(), check).passed);
}

TEST_CASE("a span of time selects the rows of a curve over time as it does those of the result") {
  const TemporaryFolder folder;
  cases::Check check = curve_check(folder.write("a.csv", exact_curve(kTimes)), {1e-9, {}, ""});
  check.from = 0.5;
  check.to = 1.1;
  // 0.5, 1.0 and 1.1: the borders belong to it.
  CHECK(verdict_of(loop(), check).compared == 3);
  check.from = 4.0;
  check.to = 5.0;
  CHECK(verdict_of(loop(), check).message == "no row was compared");
}

TEST_CASE("of a golden curve over a position, only the rows at the times of the step count") {
  const TemporaryFolder folder;
  const std::string curve = exact_curve(kTimes);
  cases::Check check =
      curve_check(folder.write("a.csv", "# slipbench golden curve\n" + curve), {1e-9, {}, ""}, "u");
  check.step = "back";
  const Verdict golden = verdict_of(loop(), check);
  INFO(golden.message);
  CHECK(golden.passed);
  // Of a foreign one nobody knows which rows belong to the step.
  cases::Check foreign = curve_check(folder.write("b.csv", curve), {1e-9, {}, ""}, "u");
  foreign.step = "back";
  CHECK_FALSE(verdict_of(loop(), foreign).passed);
}

TEST_CASE("a criterion other than pointwise judges measures") {
  const TemporaryFolder folder;
  cases::Check check = curve_check(folder.write("a.csv", exact_curve(kTimes, 1.1)), {1.0, {}, ""});
  check.criterion = cases::Criterion::kPeak;
  const Verdict verdict = verdict_of(loop(), check);
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.failing == 2);
  REQUIRE(verdict.measures.size() == 2);
  CHECK(verdict.worst_deviation() == Approx(2.0));
  CHECK(verdict.worst_fraction() == Approx(2.0));
  CHECK(verdict.message.find("20 N instead of 22 (limit 1)") != std::string::npos);
  check.tolerance = {2.5, {}, ""};
  CHECK(verdict_of(loop(), check).passed);
  CHECK(verdict_of(loop(), check).worst_fraction() == Approx(0.8));
}

TEST_CASE("an expression is compared over any abscissa and by any criterion") {
  cases::Check check = curve_check("", {1e-9, {}, ""}, "u");
  check.against = cases::ExpressionReference{compiled("CSF1*1.1", {"CSF1"}), {"CSF1"}};
  const Verdict points = verdict_of(loop(), check);
  CHECK_FALSE(points.passed);
  CHECK(points.compared == 31);
  CHECK(points.message.find("at CU1 = 0.02 mm (t = 0.2)") != std::string::npos);
  check.criterion = cases::Criterion::kArea;
  const Verdict area = verdict_of(loop(), check);
  REQUIRE(area.measures.size() == 1);
  // 20 N over 0.1 mm out, less the triangle of 0.02 mm; back, 20 to -20 N over 0.04 mm, then -20 N
  // over 0.16 mm: 1.8 + 3.2 mJ for a signed integral over the position.
  CHECK(area.measures[0].value == Approx(5.0).epsilon(1e-9));
  CHECK(area.measures[0].reference == Approx(5.5).epsilon(1e-9));
  CHECK(unit_of(area.measures[0], area) == "mJ");
}

TEST_CASE("a kept trace holds what was compared, over the abscissa of the check") {
  const TemporaryFolder folder;
  CheckTrace trace;
  const cases::Check check =
      curve_check(folder.write("a.csv", exact_curve(kTimes)), {0.5, {}, ""}, "u");
  verdict_of(loop(), check, Trace::kKeep, &trace);
  CHECK(trace.abscissa_label == "CU1");
  CHECK(trace.abscissa_unit == "mm");
  CHECK(trace.tube == 0.5);
  CHECK(trace.value.size() == 31);
  CHECK(trace.value.time.size() == 31);
  CHECK(trace.value.abscissa.back() == Approx(-0.1));
  CHECK(trace.reference.size() == kTimes.size());
  CHECK(trace.reference.value[2] == Approx(20.0));
}

TEST_CASE("a check judged row by row keeps a trace only if it is told to") {
  cases::Check check = curve_check("", {0.25, {}, ""});
  check.against = cases::ExpressionReference{compiled("CSF1 + 0.1", {"CSF1"}), {"CSF1"}};
  CheckTrace trace;
  verdict_of(loop(), check, Trace::kNone, &trace);
  CHECK(trace.value.size() == 0);
  verdict_of(loop(), check, Trace::kKeep, &trace);
  CHECK(trace.abscissa_label == "t");
  REQUIRE(trace.value.size() == 31);
  REQUIRE(trace.reference.size() == 31);
  CHECK(trace.reference.value[10] - trace.value.value[10] == Approx(0.1));
  CHECK(trace.tube == 0.25);
}

TEST_CASE("digits that a curve does not have are doubted, whether the check fails by them or not") {
  const TemporaryFolder folder;
  const auto verdict = [&](const std::string& bytes, double tolerance) {
    cases::Check check = curve_check(folder.write("a.csv", bytes), {tolerance, {}, ""});
    check.to = 1.0;
    return verdict_of(loop(), check);
  };
  // 6.99961 N at that time, printed with four decimals: half a unit is 5e-5 N.
  const std::string rounded = "time,F\n0,0\n0.0699961,6.9996\n1,20.0000\n";
  const Verdict failed = verdict(rounded, 1e-6);
  CHECK_FALSE(failed.passed);
  REQUIRE(failed.warnings.size() == 1);
  CHECK(failed.warnings[0].find("5e-05 N") != std::string::npos);
  const Verdict passed = verdict(rounded, 2e-5);
  INFO(passed.message);
  CHECK(passed.passed);
  CHECK(passed.warnings.size() == 1);
  CHECK(verdict(rounded, 1e-4).warnings.empty());
  // A golden curve has all digits, and so have round numbers that agree to the last.
  CHECK(verdict("# slipbench golden curve\n" + rounded, 1e-6).warnings.empty());
  CHECK(verdict("time,F\n0,0.000\n0.1,10.000\n1,20.000\n", 1e-7).warnings.empty());
}

TEST_CASE("the span of a check cuts the line of a curve over time between its rows") {
  const TemporaryFolder folder;
  // The force of `loop` is 20 N from 0.2 s on; at 0.9 s the line of this one is at 90 N.
  const auto verdict = [&](const std::string& rows, cases::Criterion criterion, double from,
                           double to) {
    cases::Check check = curve_check(folder.write("a.csv", "time,F\n" + rows), {{}, 0.2, ""});
    check.criterion = criterion;
    check.from = from;
    check.to = to;
    return verdict_of(loop(), check);
  };
  const std::string ramp = "0,0\n1,100\n5,100\n";
  const Verdict peak = verdict(ramp, cases::Criterion::kPeak, 0.0, 0.9);
  CHECK_FALSE(peak.passed);
  REQUIRE_FALSE(peak.measures.empty());
  CHECK(peak.measures[0].reference == Approx(90.0));
  const std::string knee = "0,0\n0.4,20\n0.45,20\n1,100\n5,100\n";
  const Verdict plateau = verdict(knee, cases::Criterion::kPlateau, 0.4, 0.9);
  CHECK_FALSE(plateau.passed);
  REQUIRE_FALSE(plateau.measures.empty());
  // 20 N for 0.05 s, and up to 85.45 N in 0.45 s.
  CHECK(plateau.measures[0].reference == Approx((20 * 0.05 + 52.727272727 * 0.45) / 0.5));
  // Points are those of its rows, and one is not enough.
  const Verdict points = verdict(ramp, cases::Criterion::kPointwise, 0.0, 0.9);
  CHECK_FALSE(points.passed);
  CHECK(points.message ==
        "a.csv: only 1 of its 3 rows, at 0, is selected by the check, and a curve needs two");
  // A single instant of the run is compared with the line there.
  CHECK(verdict(ramp, cases::Criterion::kPeak, 0.5, 0.5).measures[0].reference == Approx(50.0));
  CHECK(verdict("0,0\n0.5,20\n1,20\n", cases::Criterion::kPointwise, 0.5, 0.5).passed);
}

TEST_CASE("of a golden curve over a position, the line is cut at the times of the step") {
  const TemporaryFolder folder;
  const auto file =
      folder.write("a.csv", "# slipbench golden curve\n" + exact_curve({0.0, 0.2, 0.9, 1.4, 3.0}));
  cases::Check check = curve_check(file, {1e9, {}, ""}, "u");
  check.criterion = cases::Criterion::kArea;
  check.step = "back";
  const Verdict verdict = verdict_of(loop(), check);
  REQUIRE(verdict.measures.size() == 1);
  // The first row of the step is at 1.1 s; the line from 20 N at 0.9 s to -20 N at 1.4 s is at 4 N
  // and 0.078 mm there. 8 N over 0.018 mm, and 20 N over 0.16 mm.
  CHECK(verdict.compared == 3);
  CHECK(verdict.measures[0].reference == Approx(8 * 0.018 + 20 * 0.16));
}

TEST_CASE("a check passes on no fragment of its reference without saying so") {
  const TemporaryFolder folder;
  // Times in ms taken for s.
  const Verdict units = verdict_of(
      loop(), curve_check(folder.write("a.csv", "time,F\n0,0\n200,20\n3000,-20\n"), {1, {}, ""}));
  CHECK(units.message ==
        "only 1 of the reference's 3 rows, at 0, lies in the common range, 0 to 3");
  const std::string longer = exact_curve(kTimes) + "6,-0.1,-20\n7,-0.1,-20\n20,0,0\n";
  const auto file = folder.write("b.csv", longer);
  const Verdict part = verdict_of(loop(), curve_check(file, {1e-9, {}, ""}));
  CHECK(part.passed);
  REQUIRE(part.warnings.size() == 1);
  CHECK(part.warnings[0] ==
        "only 9 of the reference's 12 rows were compared, from 0 to 3, while it goes from 0 to 20; "
        "select with 'over' what is meant");
  // What the check selects is meant.
  cases::Check selected = curve_check(file, {1e-9, {}, ""});
  selected.to = 3.0;
  CHECK(verdict_of(loop(), selected).warnings.empty());
  cases::Check plateau = curve_check(file, {1e-6, {}, ""});
  plateau.criterion = cases::Criterion::kPlateau;
  CHECK(verdict_of(loop(), plateau).warnings.size() == 1);
}

TEST_CASE("the coefficient is guessed of friction forces only") {
  const TemporaryFolder folder;
  const auto cause = [&](const std::string& quantity, const std::vector<std::string>& variables,
                         const std::string& reference) {
    cases::Check check = curve_check("", {1e-6, {}, ""});
    check.quantity = compiled(quantity, variables);
    check.quantity_text = quantity;
    check.variables = variables;
    check.against = cases::ExpressionReference{compiled(reference, variables), variables};
    return verdict_of(loop(100), check).likely_cause;
  };
  CHECK(cause("CU1", {"CU1"}, "CU1/1.1") == "looks like a factor: ratio 1.1 everywhere");
  CHECK(cause("DISS", {"DISS"}, "DISS/1.1") == "looks like a factor: ratio 1.1 everywhere");
  CHECK(cause("FN", {"FN"}, "FN/1.1").empty());
  CHECK(cause("STATUS", {"STATUS"}, "STATUS*0 + 1").empty());
  const std::string clipped = "max(-18, min(18, CSF1))";
  CHECK(cause("CSF1", {"CSF1"}, clipped).empty() == false);
  CHECK(cause("CSF1*2 + 0*CU1", {"CSF1", "CU1"}, "2*" + clipped).empty());
}

TEST_CASE("a row that fails beside exact numbers is not blamed on their digits") {
  const TemporaryFolder folder;
  std::string rows = "time,F\n";
  for (int i = 0; i <= 10; ++i) rows += fmt::format("{:.2g},{}\n", 0.02 * i, i == 7 ? 15 : 2 * i);
  cases::Check check = curve_check(folder.write("a.csv", rows), {1e-9, {}, ""});
  check.to = 0.2;
  const Verdict verdict = verdict_of(loop(), check);
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.failing == 1);
  CHECK(verdict.warnings.empty());
}

TEST_CASE(
    "a golden curve that is met but for rounding leaves its tolerance alone, one nearly met does "
    "not") {
  const TemporaryFolder folder;
  const auto warnings = [&](double factor) {
    const std::string limit = base::format_number(20.0 * factor);
    const auto file = folder.write(
        "a.csv", "# slipbench golden curve\ntime,F\n0," + limit + "\n3," + limit + "\n");
    cases::Check check = curve_check(file, {{}, 0.9, ""});
    check.quantity = compiled("FLIM", {"FLIM"});
    check.variables = {"FLIM"};
    check.criterion = cases::Criterion::kPeak;
    return verdict_of(loop(), check).warnings;
  };
  CHECK(warnings(1.0).empty());
  CHECK(warnings(1.0 + 1e-13).empty());
  REQUIRE(warnings(1.00001).size() == 1);
  CHECK_THAT(warnings(1.00001).front(), Catch::Contains("times the largest deviation"));
}

TEST_CASE("the number of reversals has no tolerance that could be too wide") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", exact_curve({0.0, 1.0, 3.0}));
  cases::Check check = curve_check(file, {{}, 0.05, ""}, "u");
  check.criterion = cases::Criterion::kReversals;
  const Verdict verdict = verdict_of(loop(), check);
  CHECK(verdict.passed);
  for (const std::string& warning : verdict.warnings) {
    CHECK_THAT(warning, !Catch::Contains("0.05 is") && !Catch::Contains("tolerance of 0.1 is"));
  }
}

TEST_CASE("a dimensionless tolerance beyond 1 is doubted, and nothing else beside it") {
  const TemporaryFolder folder;
  cases::Check check = curve_check(folder.write("a.csv", exact_curve(kTimes)), {2.0, {}, ""});
  check.criterion = cases::Criterion::kSpragueGeers;
  REQUIRE(verdict_of(loop(), check).warnings.size() == 1);
  CHECK(verdict_of(loop(), check).warnings[0] ==
        "the tolerance of 2 has no unit, and 1 is already the error of the opposite curve");
  check.tolerance = {1e-7, {}, ""};
  CHECK(verdict_of(loop(), check).warnings.empty());
}

TEST_CASE("numbers near the largest double fail with the reason, by every criterion") {
  cases::Check check = curve_check("", {{}, 0.05, ""});
  check.against = cases::ExpressionReference{compiled("8.5e306*CSF1", {"CSF1"}), {"CSF1"}};
  const Verdict points = verdict_of(loop(), check);
  CHECK_FALSE(points.passed);
  CHECK(points.message == "the range of the reference exceeds that of a double");
  check.criterion = cases::Criterion::kIso18571;
  CHECK(verdict_of(loop(), check).message == "the range of the reference exceeds that of a double");
  check.criterion = cases::Criterion::kArea;
  check.against = cases::ExpressionReference{compiled("4e306*(CSF1+20)", {"CSF1"}), {"CSF1"}};
  check.quantity = compiled("CSF1*4e306", {"CSF1"});
  CHECK_FALSE(verdict_of(loop(), check).passed);
}

TEST_CASE("messages name times by which a row can be found") {
  const cases::Case far =
      bench::slider_case({bench::step("wait", 10, 0, history::LinearTo{0.0}, 1000.0),
                          bench::step("out", 200, 0, history::LinearTo{0.1}, 0.01)});
  cases::Check check = curve_check("", {0.5, {}, ""});
  check.against = cases::ExpressionReference{
      compiled("CSF1*(1 - 0.5*(T > 1000.00412)*(T < 1000.00423))", {"CSF1", "T"}), {"CSF1", "T"}};
  const std::string message = verdict_of(far, check).message;
  INFO(message);
  CHECK(
      message.find("at t = 1000.00415, first at 1000.00415, last at 1000.0042, 2 of 211 points") !=
      std::string::npos);
  check.criterion = cases::Criterion::kPeak;
  check.against = cases::ExpressionReference{compiled("0.5*CSF1", {"CSF1"}), {"CSF1"}};
  CHECK_THAT(verdict_of(far, check).message, Catch::Contains("at t = 1000.002"));
}

}  // namespace
}  // namespace slipbench::driver::check
