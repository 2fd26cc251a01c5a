// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/read_fit.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "driver/read/read_case.hpp"
#include "tests/driver/calibrate/fit_files_for_test.hpp"

namespace slipbench::driver::calibrate {
namespace {

namespace fs = std::filesystem;

TEST_CASE("A short fit file has the defaults that its reference promises") {
  const FitFolder folder;
  const Fit fit = folder.sound(kSoundFit);
  CHECK(fit.title == "fit");
  CHECK(fit.folder == folder.path());
  REQUIRE(fit.experiments.size() == 1);
  const ExperimentFit& experiment = fit.experiments[0];
  CHECK(experiment.name == "slider");
  CHECK(experiment.case_file == "slider.yaml");
  CHECK(experiment.case_path == folder.path() / "slider.yaml");
  CHECK(experiment.data_path == folder.path() / "rig.csv");
  CHECK(experiment.time.name == "t");
  CHECK(experiment.weight == 1.0);
  CHECK_FALSE(experiment.from.has_value());
  CHECK_FALSE(experiment.resample.has_value());
  CHECK_FALSE(experiment.held_out);
  CHECK(experiment.where.line == 4);
  REQUIRE(experiment.responses.size() == 1);
  const ResponseFit& response = experiment.responses[0];
  CHECK(response.quantity_text == "CSF1");
  CHECK(response.variables == std::vector<std::string>{"CSF1"});
  CHECK(response.dimension == base::kForce);
  CHECK(response.column.name == "load");
  CHECK(response.column.conversion == base::UnitConversion{});
  CHECK_FALSE(response.sigma.has_value());
  CHECK_FALSE(response.over.has_value());
  // The case at the start values.
  CHECK(experiment.base.parameters.at("mu") == 0.2);
  REQUIRE(fit.vary.size() == 1);
  CHECK(fit.vary[0].range.start == 0.2);
  CHECK(fit.vary[0].range.lower == 0.0);
  CHECK(fit.vary[0].range.upper == 1.0);
  CHECK(fit.vary[0].range.scale == fit::Scale::kLinear);
  CHECK(fit.vary[0].where == base::SourcePosition{5, 10, 2});
  CHECK(fit.loss.kind == fit::Loss::Kind::kSquares);
  CHECK(fit.solver.starts == fit::SolverOptions{}.starts);
  CHECK(fit.solver.seed == fit::SolverOptions{}.seed);
  CHECK(fit.solver.most_iterations == fit::SolverOptions{}.most_iterations);
  CHECK(fit.solver.step_tolerance == fit::SolverOptions{}.step_tolerance);
  CHECK(fit.solver.gradient_tolerance == fit::SolverOptions{}.gradient_tolerance);
  CHECK(fit.solver.polish == fit::SolverOptions{}.polish);
  CHECK(fit.confidence == Fit{}.confidence);
  CHECK(fit.bootstrap == 0);
  CHECK_FALSE(fit.profile);
  CHECK_FALSE(fit.date.has_value());
}

TEST_CASE("The numbers of a fit carry units, converted to the system of its cases") {
  const FitFolder folder;
  const std::string fit_of_k =
      "slipbench: 1\n"
      "calibrate:\n"
      "  experiments:\n"
      "    - {case: slider.yaml, set: {mu: 0.2}, data: rig.csv, time: t, compare: {CSF1: load}, "
      "from: 500 ms}\n"
      "  vary: {k: {start: 5 kN/mm, bounds: [200 N/mm, 0.1 MN/mm]}}\n";
  const Fit fit = folder.sound(fit_of_k);
  CHECK(fit.vary[0].range.start == Approx(5000.0));
  CHECK(fit.vary[0].range.lower == Approx(200.0));
  CHECK(fit.vary[0].range.upper == Approx(100000.0));
  CHECK(fit.experiments[0].from == Approx(0.5));
  // Cases of two systems leave a number with a unit without a meaning.
  std::string other = kSliderCase;
  other.replace(other.find("length: mm"), 10, "length: cm");
  folder.write("other.yaml", other);
  std::string two = fit_of_k;
  two.replace(two.find("  vary"), 0,
              "    - {case: other.yaml, data: rig.csv, time: t, compare: {CSF1: load}}\n");
  const ReadFit read = folder.read(two);
  CHECK_FALSE(read.value.has_value());
  CHECK(base::render(read.diagnostics)
            .find("calibrate.vary.k.start: '5 kN/mm': the cases of this file "
                  "have different units; write the number without a unit") != std::string::npos);
}

TEST_CASE("Every key of a fit file arrives") {
  const FitFolder folder;
  const Fit fit = folder.sound(
      "slipbench: 1\n"
      "title: The rig\n"
      "calibrate:\n"
      "  experiments:\n"
      "    - name: slow\n"
      "      case: slider.yaml\n"
      "      set: {k: 2000}\n"
      "      data: rig.csv\n"
      "      time: {column: t, unit: ms, factor: 2, offset: 0.5}\n"
      "      compare:\n"
      "        CSF1: {column: load, unit: kN, factor: -1, offset: 3, weight: 4, sigma: 0.5, from: "
      "1,"
      " to: 2, over: {quantity: CP1, column: stroke, unit: in, factor: -1, offset: 0.1}}\n"
      "        \"= -2*CSF1 + T\": load\n"
      "      weight: 9\n"
      "      from: 0.25\n"
      "      to: 8\n"
      "      resample: {every: 0.125}\n"
      "      average_cycles: {period: 2, points: 50}\n"
      "      dead_band: {column: speed, unit: m/s, below: 0.5}\n"
      "  holdout:\n"
      "    - {case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: load},"
      " resample: {points: 9}, dead_band: {position: stroke, below: 1}}\n"
      "  vary:\n"
      "    mu: {start: 0.3, bounds: [0.1, none], scale: log}\n"
      "  loss: {soft_l1: 1.5}\n"
      "  multistart: 8\n"
      "  seed: 7\n"
      "  stop: {iterations: 50, step: 1e-8, gradient: 1e-7}\n"
      "  polish: false\n"
      "  confidence: 0.9\n"
      "  bootstrap: 100\n"
      "  profile: true\n"
      "  date: 2026-03-01\n");
  CHECK(fit.title == "The rig");
  REQUIRE(fit.experiments.size() == 2);
  const ExperimentFit& slow = fit.experiments[0];
  CHECK(slow.name == "slow");
  REQUIRE(slow.settings.size() == 1);
  CHECK(slow.settings[0].name == "k");
  CHECK(slow.base.parameters.at("k") == 2000.0);
  CHECK(slow.base.parameters.at("stiffer") == 4000.0);
  CHECK(slow.time.conversion.scale == Approx(0.001).epsilon(1e-15));
  CHECK(slow.time.factor == 2.0);
  CHECK(slow.time.offset == 0.5);
  REQUIRE(slow.responses.size() == 2);
  const ResponseFit& loop = slow.responses[0];
  CHECK(loop.column.conversion.scale == Approx(1000.0).epsilon(1e-15));
  CHECK(loop.column.factor == -1.0);
  CHECK(loop.column.offset == 3.0);
  CHECK(loop.weight == 4.0);
  CHECK(loop.sigma == 0.5);
  CHECK(loop.from == 1.0);
  CHECK(loop.to == 2.0);
  CHECK(loop.over == "CP1");
  CHECK(loop.over_dimension == base::kLength);
  CHECK(loop.over_column.name == "stroke");
  CHECK(loop.over_column.conversion.scale == Approx(25.4).epsilon(1e-15));
  CHECK(loop.over_column.factor == -1.0);
  CHECK(loop.over_column.offset == 0.1);
  const ResponseFit& expression = slow.responses[1];
  CHECK(expression.variables == std::vector<std::string>{"CSF1", "T"});
  CHECK_FALSE(expression.dimension.has_value());
  const std::vector<double> values = {3.0, 10.0};
  CHECK(expression.quantity(values).value() == 4.0);
  CHECK(slow.weight == 9.0);
  CHECK(slow.from == 0.25);
  CHECK(slow.to == 8.0);
  CHECK(slow.resample->every == 0.125);
  CHECK_FALSE(slow.resample->points.has_value());
  CHECK(slow.average_cycles->period == 2.0);
  CHECK(slow.average_cycles->points == 50);
  CHECK(slow.dead_band->column.name == "speed");
  CHECK(slow.dead_band->column.conversion.scale == Approx(1000.0).epsilon(1e-15));
  CHECK_FALSE(slow.dead_band->of_position);
  CHECK(slow.dead_band->below == 0.5);
  const ExperimentFit& held = fit.experiments[1];
  CHECK(held.held_out);
  CHECK(held.resample->points == 9);
  CHECK(held.dead_band->of_position);
  CHECK(held.dead_band->column.name == "stroke");
  CHECK(fit.vary[0].range.lower == 0.1);
  CHECK(std::isinf(fit.vary[0].range.upper));
  CHECK(fit.vary[0].range.scale == fit::Scale::kLog);
  CHECK(fit.loss.kind == fit::Loss::Kind::kSoftL1);
  CHECK(fit.loss.threshold == 1.5);
  CHECK(fit.solver.starts == 8);
  CHECK(fit.solver.seed == 7);
  CHECK(fit.solver.most_iterations == 50);
  CHECK(fit.solver.step_tolerance == 1e-8);
  CHECK(fit.solver.gradient_tolerance == 1e-7);
  CHECK_FALSE(fit.solver.polish);
  CHECK(fit.confidence == 0.9);
  CHECK(fit.bootstrap == 100);
  CHECK(fit.profile);
  CHECK(fit.date == "2026-03-01");
}

TEST_CASE("A position over which loops are compared may have the data's name for it") {
  const FitFolder folder;
  folder.write("rig.csv", "t,CP1,load\n0,0,0\n1,1,3\n");
  const Fit fit = folder.sound(changed_fit({{"CSF1: load", "CSF1: {column: load, over: CP1}"}}));
  CHECK(fit.experiments[0].responses[0].over == "CP1");
  CHECK(fit.experiments[0].responses[0].over_column.name == "CP1");
}

TEST_CASE("A parameter without a start begins at the case's value, also at an expression's") {
  const FitFolder folder;
  const Fit fit = folder.sound(changed_fit(
      {{"vary: {mu: {start: 0.2, bounds: [0, 1]}}", "vary: {mu: {}, stiffer: {scale: log}}"}}));
  CHECK(fit.vary[0].range.start == 0.15);
  CHECK(std::isinf(fit.vary[0].range.lower));
  CHECK(fit.vary[1].range.start == 2000.0);
  CHECK(fit.vary[1].range.lower == 0.0);  // a logarithm has no other
}

TEST_CASE("A parameter that waits for a value takes the start") {
  const FitFolder folder;
  std::string text = kSliderCase;
  text.replace(text.find("mu: 0.15"), 8, "mu: ");
  folder.write("slider.yaml", text);
  CHECK(folder.sound(kSoundFit).experiments[0].base.parameters.at("mu") == 0.2);
  CHECK(contains(folder.complaint(changed_fit({{"start: 0.2, ", ""}})),
                 "parameters.mu: wanted a number, found nothing"));
}

TEST_CASE("One parameter of two cases is one unknown; each case takes the settings it has") {
  const FitFolder folder;
  const std::string text = changed_fit(
      {{"  vary:",
        "    - {case: table.yaml, data: rig.csv, time: t, compare: {CSF1: load}}\n  vary:"}});
  const Fit fit = folder.sound(text, {.overrides = {{"k", 3000.0}, {"stiffer", "= 1 + k"}}});
  REQUIRE(fit.experiments.size() == 2);
  CHECK(fit.experiments[0].base.parameters.at("mu") == 0.2);
  CHECK(fit.experiments[1].base.parameters.at("mu") == 0.2);
  CHECK(fit.experiments[0].base.parameters.at("k") == 3000.0);
  CHECK(fit.experiments[1].base.parameters.at("k") == 3000.0);
  CHECK(fit.experiments[0].base.parameters.at("stiffer") == 3001.0);
  CHECK(fit.experiments[0].settings.size() == 2);
  CHECK(fit.experiments[1].settings.size() == 1);
}

TEST_CASE("The command line is stronger than an experiment's own setting") {
  const FitFolder folder;
  const std::string text = changed_fit({{"time: t", "time: t, set: {k: 5}"}});
  CHECK(folder.sound(text).experiments[0].base.parameters.at("k") == 5.0);
  const Fit fit = folder.sound(text, {.overrides = {{"k", 6.0}}});
  CHECK(fit.experiments[0].base.parameters.at("k") == 6.0);
}

TEST_CASE("A setting of the command line that nobody takes is an error") {
  const FitFolder folder;
  CHECK(
      contains(folder.complaint(kSoundFit, {.overrides = {{"kk", 6.0}}}),
               "--set kk: no case has a parameter 'kk'; parameters there are: mu, k and stiffer"));
  CHECK(contains(folder.complaint(kSoundFit, {.overrides = {{"mu", 0.1}}}),
                 "--set mu: 'mu' is varied"));
}

TEST_CASE("A quantity may use parameters of the case, varied or not") {
  const FitFolder folder;
  const Fit fit = folder.sound(changed_fit({{"CSF1: load", "\"= CSF1/mu + k\": load"}}));
  CHECK(fit.experiments[0].responses[0].variables == std::vector<std::string>{"CSF1", "mu", "k"});
}

TEST_CASE("Tables are named with their definition, or without where it is the only one") {
  const FitFolder folder;
  const std::string text = changed_fit({{"slider", "table"},
                                        {"  vary: {mu: {start: 0.2, bounds: "
                                         "[0, 1]}}\n",
                                         ""}});
  Fit fit =
      folder.sound(text +
                   "  tables:\n"
                   "    friction1.coefficient: {free: mu, monotone: decreasing, shape: convex,"
                   " smoothness: 1e-3, bounds: [0.05, 1], scale: log}\n"
                   "    internal_contact_force: {}\n");
  REQUIRE(fit.tables.size() == 2);
  const VariedTable& mu = fit.tables[0];
  CHECK(mu.name == "friction1.coefficient");
  CHECK(mu.use == VariedTable::Use::kCoefficient);
  CHECK(mu.definition == "friction1");
  CHECK(mu.free == "mu");
  CHECK(mu.shape.monotone == fit::Shape::Monotone::kDecreasing);
  CHECK(mu.shape.curvature == fit::Shape::Curvature::kConvex);
  CHECK(mu.smoothness == 1e-3);
  CHECK(mu.lower == 0.05);
  CHECK(mu.upper == 1.0);
  CHECK(mu.scale == fit::Scale::kLog);
  const VariedTable& force = fit.tables[1];
  CHECK(force.use == VariedTable::Use::kInternalContactForce);
  CHECK(force.definition == "friction1");
  CHECK(force.free == "press");
  CHECK_FALSE(force.shape.any());
  CHECK(force.lower == 0.0);
  CHECK(std::isinf(force.upper));
  CHECK(
      contains(folder.complaint(text + "  tables: {coefficient: {}, friction1.coefficient: {}}\n"),
               "is the same table as 'coefficient'"));
  CHECK(contains(folder.complaint(text + "  tables: {internal_contact_force: {free: force}}\n"),
                 "the table has no column 'force'; what can be varied is its dependent column, "
                 "'press'"));
}

TEST_CASE("The tables of predefined friction are found by the name of what slips") {
  const FitFolder folder;
  folder.write("plane.yaml",
               "slipbench: 1\n"
               "connector: {type: PLANAR}\n"
               "friction:\n"
               "  - predefined:\n"
               "      R: 2\n"
               "      internal_contact_force: {columns: [press, CP2], rows: [[5, 0], [6, 1]]}\n"
               "      internal_contact_moment: {columns: [twist, CPR1], rows: [[5, 0], [6, 1]]}\n"
               "    coefficient: {columns: [mu, temperature], rows: [[0.3, 0], [0.2, 10]]}\n"
               "    stick: {elastic_slip: 0.001}\n"
               "history:\n"
               "  - {step: go, increments: 2, force: {f1: 100}, motion: {CP2: {to: 1}}}\n");
  const std::string text =
      "slipbench: 1\n"
      "calibrate:\n"
      "  experiments:\n"
      "    - {case: plane.yaml, data: rig.csv, time: t, compare: {CSF2: load}}\n";
  const Fit fit = folder.sound(text +
                               "  tables: {coefficient: {}, sliding.internal_contact_force: {},"
                               " spinning.internal_contact_force: {free: twist}}\n");
  CHECK(fit.tables[0].definition.empty());  // both
  CHECK(fit.tables[1].definition == "sliding");
  CHECK(fit.tables[1].free == "press");
  CHECK(fit.tables[2].definition == "spinning");
  CHECK(contains(folder.complaint(text + "  tables: {internal_contact_force: {}}\n"),
                 "plane.yaml has 2 internal contact forces: which of them?; write "
                 "'sliding.internal_contact_force' or 'spinning.internal_contact_force'"));
}

TEST_CASE("Tables of two cases are one only if they begin alike") {
  const FitFolder folder;
  std::string other = kTableCase;
  other.replace(other.find("[0.2, 10]"), 9, "[0.25, 10]");
  folder.write("other.yaml", other);
  std::string finer = kTableCase;
  finer.replace(finer.find("[0.2, 10]"), 9, "[0.2, 20]");
  folder.write("finer.yaml", finer);
  const auto with = [&](const std::string& second) {
    return "slipbench: 1\n"
           "calibrate:\n"
           "  experiments:\n"
           "    - {case: table.yaml, data: rig.csv, time: t, compare: {CSF1: load}}\n"
           "    - {case: " +
           second +
           ", data: rig.csv, time: t, compare: {CSF1: load}}\n"
           "  tables: {coefficient: {}}\n";
  };
  CHECK(folder.sound(with("table.yaml")).tables.size() == 1);
  CHECK(contains(folder.complaint(with("other.yaml")),
                 "row 2 of the tables of table.yaml and other.yaml begins at 0.2 and 0.25"));
  CHECK(contains(folder.complaint(with("finer.yaml")),
                 "the tables of table.yaml and finer.yaml have different points"));
  // A case with a number in the table's place just has no such unknown.
  CHECK(folder.sound(with("slider.yaml")).tables[0].definition == "friction1");
}

TEST_CASE("A table that does not begin with the wanted shape is worth a note") {
  const FitFolder folder;
  const std::string text =
      changed_fit({{"slider", "table"}, {"mu: {start: 0.2, bounds: [0, 1]}", "k: {}"}});
  CHECK(folder.complaint(text +
                         "  tables: {coefficient: {monotone: decreasing, shape: convex}}\n") == "");
  CHECK(contains(folder.complaint(text + "  tables: {coefficient: {monotone: increasing}}\n"),
                 "note: calibrate.tables.coefficient: the numbers of the case do not have the "
                 "wanted shape"));
  CHECK(contains(folder.complaint(text + "  tables: {coefficient: {shape: concave}}\n"), "note:"));
  CHECK(folder.complaint(text + "  tables: {internal_contact_force: {shape: convex}}\n") == "");
}

TEST_CASE("Experiments without a name are called by their case, or by their data") {
  const FitFolder folder;
  folder.write("rig2.csv", kRigData);
  const Fit fit = folder.sound(changed_fit(
      {{"  vary:",
        "    - {case: slider.yaml, data: rig2.csv, time: t, compare: {CSF1: load}}\n"
        "    - {case: slider.yaml, data: rig2.csv, time: t, compare: {CSF1: load}}\n"
        "    - {case: table.yaml, data: rig.csv, time: t, compare: {CSF1: load}}\n"
        "    - {name: rig2_3, case: table.yaml, data: rig.csv, time: t, compare: {CSF1: load}}\n"
        "  vary:"}}));
  std::vector<std::string> names;
  for (const ExperimentFit& experiment : fit.experiments) names.push_back(experiment.name);
  CHECK(names == std::vector<std::string>{"rig", "rig2", "rig2_2", "rig_2", "rig2_3"});
}

TEST_CASE("What is said of a case is said once, under its own name") {
  const FitFolder folder;
  std::string text = kSliderCase;
  text.replace(text.find("stick: {stiffness: = k}"), 23, "force_limit: 0");
  folder.write("slider.yaml", text);
  const std::string shown = folder.complaint(
      changed_fit({{"  vary:",
                    "    - {case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: load},"
                    " set: {k: 7}}\n  vary:"}}));
  const std::string note = "characteristic length not given";
  const std::size_t first = shown.find(note);
  REQUIRE(first != std::string::npos);
  CHECK(contains(shown, "slider.yaml:6:5: note: friction[0]"));
  CHECK(shown.find(note, first + 1) == std::string::npos);
}

TEST_CASE("The faults of a case and of the fit come in one run") {
  const FitFolder folder;
  std::string text = kSliderCase;
  text.replace(text.find("coefficient"), 11, "coeficient");
  folder.write("slider.yaml", text);
  const std::string shown =
      folder.complaint(changed_fit({{"time: t", "time: t, wieght: 2"}, {"load", "laod"}}));
  CHECK(contains(shown, "slider.yaml:8:5: error: friction[0].coeficient: unknown key"));
  CHECK(contains(shown, "error: calibrate.experiments[0].wieght: unknown key"));
  CHECK(contains(shown, "rig.csv has no column 'laod'; did you mean 'load'?"));
}

TEST_CASE("Files that are missing are the machine's fault, and named where they are wanted") {
  const FitFolder folder;
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"slider.yaml", "gone.yaml"}, {"rig.csv", "gone.csv"}}) {
    const ReadFit read = folder.read(changed_fit({{from, to}}));
    CHECK_FALSE(read.value.has_value());
    CHECK(read.environment_failure);
    const std::vector<base::Diagnostic> all = read.diagnostics.sorted();
    REQUIRE(all.size() == 1);
    CHECK(all[0].where.line == 4);
    CHECK(contains(all[0].message, to + ": "));
  }
  const ReadFit read = read_fit((folder.path() / "nothing.yaml").string());
  CHECK(read.environment_failure);
}

TEST_CASE("All files that are read are known, so that none is overwritten") {
  const FitFolder folder;
  std::string text = kSliderCase;
  text.replace(text.find("coefficient: = mu"), 17,
               "coefficient: {columns: [mu, slip_rate], csv: mu.csv}");
  folder.write("slider.yaml", text);
  folder.write("mu.csv", "mu,slip_rate\n0.2,0\n0.1,10\n");
  const ReadFit read = folder.read(changed_fit({{"{mu: {", "{k: {"}, {", bounds: [0, 1]", ""}}));
  INFO(base::render(read.diagnostics, read.sources));
  REQUIRE(read.value.has_value());
  for (const char* name : {"slider.yaml", "rig.csv", "mu.csv"}) {
    const std::string wanted = (folder.path() / name).string();
    CHECK(std::find(read.data_files.begin(), read.data_files.end(), wanted) !=
          read.data_files.end());
  }
}

TEST_CASE("Files of other folders are read only if the user allows it") {
  const FitFolder folder;
  fs::create_directory(folder.path() / "fits");
  const std::string text =
      changed_fit({{"slider.yaml", "../slider.yaml"}, {"rig.csv", "../rig.csv"}});
  const std::string file = folder.write("fits/fit.yaml", text).string();
  const ReadFit refused = read_fit(file);
  CHECK(refused.diagnostics.count(base::Severity::kError) == 2);
  ReadFit read = read_fit(file, {.allow_outside = true});
  REQUIRE(read.value.has_value());
  CHECK(read.value->experiments[0].case_path == folder.path() / "slider.yaml");
}

TEST_CASE("A fit file without a folder in its name finds its neighbours") {
  const FitFolder folder;
  folder.write("fit.yaml", kSoundFit);
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const ReadFit read = read_fit("fit.yaml");
  fs::current_path(before);
  REQUIRE(read.value.has_value());
  CHECK(read.value->folder == ".");
  CHECK(read.value->experiments[0].case_path == "slider.yaml");
  CHECK(read.value->experiments[0].base.file == "slider.yaml");
}

TEST_CASE("A fit file where a case is wanted is sent to the command that reads it") {
  const FitFolder folder;
  const std::string file = folder.write("fit.yaml", kSoundFit).string();
  const read::ReadCase read = read::read_case(file);
  CHECK_FALSE(read.value.has_value());
  const std::vector<base::Diagnostic> all = read.diagnostics.sorted();
  REQUIRE(all.size() == 1);
  CHECK(all[0].where == base::SourcePosition{2, 1, 9});
  CHECK(all[0].message ==
        "this is a fit file, not a case: 'slipbench calibrate " + file + "' works on it");
}

}  // namespace
TEST_CASE("A date is a day of the calendar") {
  const FitFolder folder;
  CHECK(folder.sound(kSoundFit + "  date: 2028-02-29\n").date == "2028-02-29");
  for (const char* date : {"2026-02-31", "2026-02-29", "1.3.2026", "2026-3-1", "yesterday",
                           "\"2026-03-01\\n- more\""}) {
    CAPTURE(date);
    CHECK(contains(folder.complaint(kSoundFit + "  date: " + date + "\n"),
                   "a date is wanted, YYYY-MM-DD, such as 2026-03-01; found '"));
  }
}

}  // namespace slipbench::driver::calibrate
