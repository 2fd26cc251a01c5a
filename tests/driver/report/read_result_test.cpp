// SPDX-License-Identifier: Apache-2.0
#include "driver/report/read_result.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "driver/commands/run.hpp"
#include "tests/driver/report/case_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::report {
namespace {

namespace fs = std::filesystem;

/// Runs the slider into the folder; its check expects `mu`.
std::string run_slider(const TemporaryFolder& folder, const std::string& mu, int increments = 10) {
  commands::RunOptions options;
  options.cases = {folder.write("slider.yaml", slider_text(mu, increments)).string()};
  options.folder = folder.path().string();
  commands::run_command(options);
  return (folder.path() / "slider.csv").string();
}

TEST_CASE("a result tells the same as its case, but for the checks' curves") {
  const TemporaryFolder folder;
  const std::string file = run_slider(folder, "0.3");
  const ReadResult result = read_result(file, "out/slider");
  const CaseReport of_case = report_of(read_slider("0.3"));
  const CaseReport& report = result.report;
  CHECK(result.code == base::kExitOk);
  CHECK(report.is_result);
  CHECK(report.name == "out/slider");
  CHECK(report.title == "Slider");
  CHECK(report.status == ReportStatus::kFailed);
  CHECK(report.increments == 20);
  CHECK(report.drawn.rows.numbers == of_case.drawn.rows.numbers);
  CHECK(report.units == of_case.units);
  CHECK(report.parameters == of_case.parameters);
  CHECK(report.energies == of_case.energies);
  REQUIRE(report.columns.size() == of_case.columns.size());
  for (std::size_t c = 0; c < report.columns.size(); ++c) {
    CHECK(report.columns[c].name == of_case.columns[c].name);
    CHECK(report.columns[c].unit == of_case.columns[c].unit);
  }
  REQUIRE(report.definitions.size() == 1);
  CHECK(report.definitions[0].limit == "FLIM");
  CHECK(report.definitions[0].slip_share == of_case.definitions[0].slip_share);
  // Of spans a result knows the rows: the increment in which slip begins counts as slip.
  REQUIRE(report.definitions[0].spans.size() == 2);
  CHECK(report.definitions[0].spans[1].to == of_case.definitions[0].spans[1].to);
  REQUIRE(report.events.size() == of_case.events.size());
  CHECK(report.events[1].time == of_case.events[1].time);
  CHECK(report.events[1].force == of_case.events[1].force);
  CHECK(report.events[1].positions == of_case.events[1].positions);
  REQUIRE(report.checks.size() == 1);
  const check::Verdict& verdict = report.checks[0].verdict;
  CHECK(verdict.name == "limit");
  CHECK_FALSE(verdict.passed);
  CHECK(verdict.message == of_case.checks[0].verdict.message);
  CHECK(verdict.worst.reference == of_case.checks[0].verdict.worst.reference);
  CHECK(verdict.failing == of_case.checks[0].verdict.failing);
  CHECK(verdict.worst_fraction() == of_case.checks[0].verdict.worst_fraction());
  CHECK(report.checks[0].value.x.empty());
  CHECK(report.summary.front().starts_with("slips 70 % of the time, 2 stick-slip events"));
}

TEST_CASE("a result alone, without the files beside it, is drawn without verdicts") {
  const TemporaryFolder folder;
  const std::string file = run_slider(folder, "0.2");
  fs::remove(folder.path() / "slider.json");
  fs::remove(folder.path() / "slider.events.csv");
  const ReadResult result = read_result(file, "slider");
  CHECK(result.code == base::kExitOk);
  CHECK(result.report.status == ReportStatus::kNoChecks);
  CHECK(result.report.events.empty());
  CHECK(result.report.checks.empty());
  CHECK(result.report.row_count() == 21);
  CHECK(result.report.warnings.empty());
}

TEST_CASE("broken files beside a result do not keep it from being drawn") {
  const TemporaryFolder folder;
  const std::string file = run_slider(folder, "0.2");
  folder.write("slider.json", "{\"checks\": [{\"name\": 1, \"passed\"");
  folder.write("slider.events.csv", "a,b\n1,2\n");
  const ReadResult broken = read_result(file, "slider");
  CHECK(broken.report.status == ReportStatus::kNoChecks);
  CHECK(broken.report.events_total == 0);
  // A failed result must not look unchecked: what is there and cannot be read is told.
  REQUIRE(broken.report.warnings.size() == 2);
  CHECK(broken.report.warnings[0].starts_with("slider.json is not shown ("));
  CHECK(broken.report.warnings[0].ends_with("): the verdicts of the checks are unknown"));
  CHECK(broken.report.warnings[1].starts_with("slider.events.csv is not shown ("));
  folder.write("slider.json",
               "{\"checks\": 5, \"summary\": [], \"warnings\": {\"a\": [1]}, \"more\": null}");
  folder.write("slider.events.csv",
               "t,definition,from,to,force,limit,accumulated_slip,CP1\n1,a,stick,slip\n"
               "1,a,stick,slip,x,2,3,4\n");
  const ReadResult odd = read_result(file, "slider");
  CHECK(odd.report.row_count() == 21);
  CHECK(odd.report.checks.empty());
  REQUIRE(odd.report.events.size() == 1);
  CHECK(odd.report.events[0].limit == 2.0);
}

TEST_CASE("events and verdicts of another run are not shown beside the rows") {
  const TemporaryFolder folder;
  const std::string file = run_slider(folder, "0.2");
  const fs::path kept = folder.path() / "kept.csv";
  fs::rename(file, kept);
  commands::RunOptions options;
  options.cases = {(folder.path() / "slider.yaml").string()};
  options.folder = folder.path().string();
  options.settings = {"mu=0.1"};
  commands::run_command(options);
  fs::rename(kept, file);
  const ReadResult mixed = read_result(file, "slider");
  CHECK(mixed.report.row_count() == 21);
  CHECK(mixed.report.checks.empty());
  CHECK(mixed.report.events_total == 0);
  REQUIRE(mixed.report.warnings.size() == 2);
  CHECK(mixed.report.warnings[0] ==
        "slider.json is not shown (it is of another run than the rows): the verdicts of the checks "
        "are unknown");
  CHECK(mixed.report.warnings[1].starts_with("slider.events.csv is not shown (it is of another"));
}

TEST_CASE("a long result is thinned as its case is") {
  const TemporaryFolder folder;
  const ReadResult result = read_result(run_slider(folder, "0.2", 20000), "slider", 2500);
  CHECK(result.report.drawn.thinned);
  CHECK(result.report.row_count() <= 2500);
  CHECK(number_at(result.report, result.report.row_count() - 1, "t") == Approx(2.0).epsilon(1e-12));
}

TEST_CASE("the row where a check of a result is worst stays") {
  const TemporaryFolder folder;
  commands::RunOptions options;
  options.cases = {folder.write("cycles.yaml", cycles_text(100, 100)).string()};
  options.folder = folder.path().string();
  commands::run_command(options);
  const ReadResult result = read_result((folder.path() / "cycles.csv").string(), "cycles", 2500);
  const CaseReport& report = result.report;
  REQUIRE(report.drawn.thinned);
  REQUIRE(report.checks.size() == 1);
  const double worst = report.checks[0].verdict.worst.time;
  bool there = false;
  for (std::size_t i = 0; i < report.row_count(); ++i) {
    there = there || number_at(report, i, "t") == worst;
  }
  CHECK(there);
  CHECK(report.drawn.cycles_total == 100);
  REQUIRE(report.events.size() == 200);
  CHECK(report.events.back().time > 99.5);
}

TEST_CASE("what is no result says why, with its place") {
  const TemporaryFolder folder;
  const ReadResult missing = read_result((folder.path() / "no.csv").string(), "no");
  CHECK(missing.code == base::kExitEnvironment);
  CHECK(missing.report.status == ReportStatus::kNotRun);
  CHECK(missing.report.is_result);
  const ReadResult foreign = read_result(folder.write("a.csv", "t,x\n0,1\n").string(), "a");
  CHECK(foreign.code == base::kExitBadInput);
  CHECK(foreign.report.message.find("has no friction force to draw") != std::string::npos);
  const ReadResult faulty = read_result(
      folder.write("b.csv", "# friction: a = CSF1\nt,CSF1\n0,1\n1,one\n").string(), "b");
  CHECK(faulty.code == base::kExitBadInput);
  CHECK(faulty.report.message.find("b.csv:4: error: ") != std::string::npos);
  const ReadResult twice = read_result(
      folder.write("c.csv", "# friction: a = CSF1, a = CSF1\nt,CSF1\n0,1\n1,1\n").string(), "c");
  CHECK(twice.code == base::kExitBadInput);
  CHECK(twice.report.message.find("names 'a' twice") != std::string::npos);
}

TEST_CASE("a JSON of very many parameters is compared in time") {
  const TemporaryFolder folder;
  std::string in_rows;
  std::string in_json;
  for (int i = 0; i < 60000; ++i) {
    const std::string name = "a" + std::to_string(i);
    in_rows += (i > 0 ? ", " : "") + name + " = 1";
    in_json += (i > 0 ? ", \"" : "\"") + name + "\": 1";
  }
  const std::string result = folder
                                 .write("r.csv", "# case: c.yaml\n# parameters: " + in_rows +
                                                     "\n# friction: s = CSF1\nt,CSF1\n0,1\n1,1\n")
                                 .string();
  const auto with_last = [&](const std::string& last) {
    folder.write("r.json", R"({"provenance": {"case": "c.yaml", "parameters": {)" + in_json + last +
                               R"(}}, "warnings": ["of this run"]})");
    return read_result(result, "r").report.warnings;
  };
  CHECK(with_last("") == std::vector<std::string>{"of this run"});
  CHECK(with_last(R"(, "b": 2)") == std::vector<std::string>{"of this run"});
  in_json.back() = '2';
  CHECK(with_last("").front().find("it is of another run than the rows") != std::string::npos);
}

TEST_CASE("a JSON of very many definitions is gone through in time") {
  const TemporaryFolder folder;
  constexpr int kDefinitions = 9990;
  std::string names;
  std::string summary;
  for (int i = 0; i < kDefinitions; ++i) {
    const std::string name = "d" + std::to_string(i);
    names += (i > 0 ? ", " : "") + name + " = CSF1";
    summary += (i > 0 ? R"(, {"name": ")" : R"({"name": ")") + name + R"("})";
  }
  const std::string result =
      folder.write("r.csv", "# friction: " + names + "\nt,CSF1\n0,1\n1,1\n").string();
  folder.write("r.json", R"({"summary": {"end_time": 1, "definitions": [)" + summary + "]}}");
  const ReadResult read = read_result(result, "r");
  REQUIRE(read.report.summary.size() == kDefinitions);
  CHECK(read.report.summary.back().starts_with("d9989: slips 0 % of the time"));
}

}  // namespace
}  // namespace slipbench::driver::report
