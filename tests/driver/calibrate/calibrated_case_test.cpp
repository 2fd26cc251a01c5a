// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/calibrated_case.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "driver/base/text/source_text.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/calibrate/varied_case.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/calibrate/calibration_for_test.hpp"
#include "tests/support/project_paths.hpp"

using namespace slipbench::driver;
using namespace slipbench::driver::calibrate;
namespace law = slipbench::law;
namespace fs = std::filesystem;

namespace {

/// A number that the shortest text of few digits does not hit.
double changed(double value) { return value * (1.0 + 1.0 / 1073741824.0); }

/// A fit that varies parameters and tables of cases.
class Made {
 public:
  Made() {
    fit.file = "fits/rig.yaml";
    fit.title = "rig";
    calibration.fit.converged = true;
    calibration.fit.stop_sentence = "the steps have become negligible";
  }

  void add_experiment(const std::string& name, const fs::path& path, const cases::Case& base,
                      std::vector<base::ParameterText> settings = {}) {
    calibrate::ExperimentFit experiment;
    experiment.name = name;
    experiment.case_path = path;
    experiment.case_file = path.filename().string();
    experiment.data_file = "rig.csv";
    experiment.base = base;
    experiment.settings = std::move(settings);
    calibrate::FittedExperiment fitted;
    fitted.index = fit.experiments.size();
    fitted.data_hash = "0123456789abcdef";
    fitted.rows_read = fitted.rows_used = 200;
    calibrate::FittedResponse response;
    response.quantity = "CSF1";
    response.unit = "N";
    response.rmse_before = 812.0;
    response.rmse_after = 71.0;
    response.range = 6200.0;
    fitted.responses.push_back(response);
    fit.experiments.push_back(std::move(experiment));
    calibration.experiments.push_back(std::move(fitted));
  }

  void vary(const std::string& name, double value) {
    fit.vary.push_back({name, {}, {}});
    add_unknown(name, value);
  }

  /// All ordinates of a table, each changed a little.
  void vary_table(const std::string& definition, calibrate::VariedTable::Use use,
                  const law::Table& table) {
    calibrate::VariedTable varied;
    varied.definition = definition;
    varied.use = use;
    varied.name =
        definition + (use == calibrate::VariedTable::Use::kCoefficient ? ".coefficient"
                                                                       : ".internal_contact_force");
    varied.free = "mu";
    calibrate::FittedTable fitted;
    fitted.index = fit.tables.size();
    fitted.first_unknown = calibration.unknowns.size();
    fitted.count = table.rows();
    fitted.columns.assign(static_cast<std::size_t>(table.independents()), "x");
    for (std::size_t r = 0; r < table.rows(); ++r) {
      fitted.points.push_back(table.point(r));
      add_unknown(varied.name + "[" + std::to_string(r) + "].mu", changed(table.ordinate(r)));
    }
    fit.tables.push_back(varied);
    calibration.tables.push_back(fitted);
  }

  Fit fit;
  Calibration calibration;

 private:
  void add_unknown(const std::string& name, double value) {
    calibrate::FittedUnknown unknown;
    unknown.name = name;
    unknown.value = value;
    calibration.unknowns.push_back(unknown);
    calibration.statistics.standard_error.push_back(0.002);
    calibration.statistics.lower.push_back(value - 0.004);
    calibration.statistics.upper.push_back(value + 0.004);
  }
};

read::ReadCase read_text(const std::string& text, const fs::path& folder) {
  return read::read_case_text(base::SourceText("calibrated.yaml", text), folder.string());
}

/// A case in a folder of its own, which is gone with the object.
class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() / ("slipbench-calibrated-" + std::to_string(getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path write(const fs::path& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

constexpr const char* kSlider = R"(# A rig.
slipbench: 1
parameters:
  mu: 0.3          # to be found
  mu_k: = 0.8*mu   # of slip
  T0: 20
connector: {type: SLOT}
friction:
  - name: sleeve
    component: 1
    internal_contact_force: 100
    coefficient: {columns: [mu, temperature], rows: [[= mu, 0], [= mu_k, 50]]}
    stick: {elastic_slip: 1e-3}
history:
  - {step: pull, duration: 1, increments: 10, motion: {CP1: {to: 5}}, temperature: = T0}
)";

std::string only_text(const calibrate::CalibratedCases& cases) {
  for (const std::string& fault : cases.faults) FAIL_CHECK(fault);
  REQUIRE(cases.cases.size() == 1);
  return cases.cases[0].text;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a calibrated case is the user's text with other numbers") {
  const Folder folder;
  const fs::path path = folder.write("loop.yaml", kSlider);
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("cold", path, *read.value, {{"T0", 5.5}});
  made.vary("mu", 0.1 + 0.2);
  made.fit.date = "2026-03-01";
  const calibrate::CalibratedCases cases =
      calibrate::calibrated_cases(made.fit, made.calibration, folder.path());
  const std::string text = only_text(cases);
  CHECK(cases.cases[0].file_name == "loop.calibrated.yaml");
  CHECK(cases.cases[0].notes.empty());

  // Comments and layout are the user's, and expressions follow by themselves.
  std::string expected = kSlider;
  expected.replace(expected.find("0.3 "), 3, "0.30000000000000004");
  expected.replace(expected.find("T0: 20") + 4, 2, "5.5");
  REQUIRE(contains(text, "# A rig.\n"));
  CHECK(text.substr(text.find("# A rig.")) == expected);

  for (const char* part :
       {"# Calibrated by slipbench ", ", 2026-03-01\n", "# fit: rig.yaml, rig\n",
        "# converged: the steps have become negligible\n",
        "#   cold: rig.csv, 200 of 200 rows, SHA-256 0123456789abcdef\n",
        "#     CSF1: RMSE 71 N, before 812; the data range over 6200\n",
        "#   mu = 0.30000000000000004 +- 0.0020 (95 % within 0.2960 .. 0.3040), start 0\n",
        "# set for experiment 'cold': T0 = 5.5\n"}) {
    INFO(part << " in\n" << text);
    CHECK(contains(text, part));
  }
  const read::ReadCase again = read_text(text, folder.path());
  REQUIRE(again.value);
  CHECK(again.value->parameters ==
        base::NamedNumbers{{"mu", 0.1 + 0.2}, {"mu_k", 0.8 * (0.1 + 0.2)}, {"T0", 5.5}});
}

TEST_CASE("expressions that are replaced are kept in the comments") {
  const Folder folder;
  const fs::path path = folder.write("loop.yaml", kSlider);
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("cold", path, *read.value);
  made.vary("mu_k", 0.25);
  const auto& law = std::get<law::TabularCoefficient>(read.value->definitions[0].law.law);
  made.vary_table("sleeve", calibrate::VariedTable::Use::kCoefficient, law.table.table());
  const std::string text =
      only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder.path()));
  CHECK(contains(text, "# parameters.mu_k was the expression '= 0.8*mu'\n"));
  CHECK(contains(text, "# friction[0].coefficient.rows[1][0] was the expression '= mu_k'\n"));
  CHECK(contains(text, "  mu_k: 0.25   # of slip\n"));
  CHECK_FALSE(contains(text, "rows: [[="));
}

TEST_CASE("a number with its unit gives way to a bare one of the case's system") {
  const Folder folder;
  std::string with_units = kSlider;
  const auto put = [&](const std::string& from, const std::string& to) {
    with_units.replace(with_units.find(from), from.size(), to);
  };
  put("parameters:\n", "units: {length: mm, force: N, time: s, temperature: K}\nparameters:\n");
  put("T0: 20\n", "T0: 20 degC\n  k: 5 kN/mm\n  press: 100\n");
  const fs::path path = folder.write("loop.yaml", with_units);
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  CHECK(read.value->parameters.at("k") == Approx(5000.0));
  Made made;
  made.add_experiment("cold", path, *read.value,
                      {{"T0", std::string("30 degC")}, {"press", std::string("0.2 kN")}});
  made.vary("k", 4321.0);
  const std::string text =
      only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder.path()));
  CHECK(contains(text, "  k: 4321\n"));
  CHECK(contains(text, "# parameters.k was '5 kN/mm'\n"));
  CHECK(contains(text, "30 degC"));
  const read::ReadCase back = read_text(text, folder.path());
  REQUIRE(back.value);
  CHECK(back.value->parameters.at("k") == 4321.0);
  CHECK(back.value->parameters.at("T0") == Approx(303.15));
  CHECK(back.value->parameters.at("press") == Approx(200.0));
}

TEST_CASE("a search that did not converge is told in the calibrated case") {
  const Folder folder;
  const fs::path path = folder.write("loop.yaml", kSlider);
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("cold", path, *read.value);
  made.vary("mu", 0.25);
  made.calibration.fit.converged = false;
  made.calibration.fit.stop_sentence = "nothing\nchanged";
  const std::string text =
      only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder.path()));
  // What is told cannot break the file.
  CHECK(contains(text,
                 "# NOT CONVERGED: nothing\xEF\xBF\xBD"
                 "changed\n"));
  CHECK(read_text(text, folder.path()).value);
}

TEST_CASE("experiments of one case with the same settings share a calibrated case") {
  const Folder folder;
  const fs::path path = folder.write("loop.yaml", kSlider);
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("a", path, *read.value, {{"T0", 5.0}});
  made.add_experiment("b", path, *read.value, {{"T0", 5.0}});
  made.add_experiment("c", path, *read.value, {{"T0", 5.0}});
  made.fit.experiments[2].held_out = true;
  made.vary("mu", 0.25);
  calibrate::CalibratedCases cases =
      calibrate::calibrated_cases(made.fit, made.calibration, folder.path());
  REQUIRE(cases.cases.size() == 1);
  CHECK(cases.cases[0].experiments == std::vector<std::size_t>{0, 1});

  // Others are named by their experiment.
  made.add_experiment("hot / 2", path, *read.value, {{"T0", std::string("= 4*mu")}});
  cases = calibrate::calibrated_cases(made.fit, made.calibration, folder.path());
  REQUIRE(cases.cases.size() == 2);
  CHECK(cases.cases[0].file_name == "loop.a.calibrated.yaml");
  CHECK(cases.cases[1].file_name == "loop.hot---2.calibrated.yaml");
  CHECK(calibrate::calibrated_case_names(made.fit) ==
        std::vector<std::string>{cases.cases[0].file_name, cases.cases[1].file_name});
  CHECK(contains(cases.cases[0].text, "hot / 2 (another calibrated case of this fit)"));
  CHECK(contains(cases.cases[1].text, "  T0: \"= 4*mu\"\n"));
}

TEST_CASE("a calibrated case keeps the line ends of a case from Windows") {
  const Folder folder;
  std::string windows;
  for (const char c : std::string(kSlider)) windows += c == '\n' ? "\r\n" : std::string(1, c);
  const fs::path path = folder.write("loop.yaml", windows);
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("a", path, *read.value, {});
  made.vary("mu", 0.25);
  const calibrate::CalibratedCases cases =
      calibrate::calibrated_cases(made.fit, made.calibration, folder.path());
  REQUIRE(cases.cases.size() == 1);
  const std::string& text = cases.cases[0].text;
  CHECK(std::count(text.begin(), text.end(), '\n') == std::count(text.begin(), text.end(), '\r'));
  CHECK(contains(text, "\r\n"));
  CHECK(read_text(text, folder.path()).value);
}

TEST_CASE("data files are found from where the calibrated case stands") {
  const Folder folder;
  const std::string table =
      "slipbench: 1\nconnector: {type: SLOT}\nfriction:\n  - component: 1\n"
      "    internal_contact_force: 100\n    coefficient:\n      columns: [mu, temperature]\n"
      "      csv: 'mu table.csv'   # measured\n    stick: {elastic_slip: 1e-3}\nhistory:\n"
      "  - {step: a, duration: 1, increments: 2, motion: {CP1: {csv: move.csv, time: time, value: "
      "x}}}\n";
  const fs::path path = folder.write("in/loop.yaml", table);
  folder.write("in/mu table.csv", "note,temperature,mu\n1,0,0.3\n2,50,0.1\n3,90,0.05\n");
  folder.write("in/move.csv", "time,x\n0,0\n1,5\n");
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("a", path, *read.value);
  made.calibration.unknowns.resize(0);

  SECTION("in the same folder they keep their names") {
    const auto text =
        only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder.path() / "in"));
    CHECK(text.substr(text.find("slipbench: 1")) == table);
  }
  SECTION("in a folder above they get a path") {
    const auto text =
        only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder.path()));
    CHECK(contains(text, "csv: \"in/mu table.csv\"   # measured\n"));
    CHECK(contains(text, "{csv: in/move.csv, time: time, value: x}"));
    CHECK(read_text(text, folder.path()).value);
  }
  SECTION("elsewhere the case needs leave to read them, which it says") {
    fs::create_directories(folder.path() / "out");
    const auto cases =
        calibrate::calibrated_cases(made.fit, made.calibration, folder.path() / "out");
    const auto text = only_text(cases);
    CHECK(contains(text, "csv: \"../in/mu table.csv\""));
    CHECK(contains(text, "--allow-outside\n"));
    REQUIRE(cases.cases[0].notes.size() == 1);
    CHECK_FALSE(read_text(text, folder.path() / "out").value);
    CHECK(read::read_case_text(base::SourceText("c.yaml", text), (folder.path() / "out").string(),
                               {{}, true, false})
              .value);
  }
  SECTION("a fitted table from a file becomes rows") {
    const auto& law = std::get<law::TabularCoefficient>(read.value->definitions[0].law.law);
    made.vary_table("friction1", calibrate::VariedTable::Use::kCoefficient, law.table.table());
    const auto text =
        only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder.path() / "in"));
    CHECK(contains(text, "      rows: [[0.3"));
    CHECK(contains(text, ", 90]]   # measured\n"));
    CHECK(contains(text, "# friction[0].coefficient.csv was the file 'mu table.csv'\n"));
    const read::ReadCase again = read_text(text, folder.path() / "in");
    REQUIRE(again.value);
    const auto& fitted = std::get<law::TabularCoefficient>(again.value->definitions[0].law.law);
    CHECK(fitted.table.table().ordinate(1) == changed(0.1));
  }
}

TEST_CASE("a case that cannot be written is told, and the others are written") {
  const Folder folder;
  std::string text = kSlider;
  text.replace(text.find("= 0.8*mu "), 8, "\"= 0.8 *\n    mu\"");
  const fs::path path = folder.write("long.yaml", text);
  const fs::path good = folder.write("loop.yaml", kSlider);
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("a", path, *read.value);
  made.add_experiment("b", good, *read.value);
  made.vary("mu_k", 0.25);
  const calibrate::CalibratedCases cases =
      calibrate::calibrated_cases(made.fit, made.calibration, folder.path());
  REQUIRE(cases.cases.size() == 1);
  CHECK(cases.cases[0].file_name == "loop.calibrated.yaml");
  REQUIRE(cases.faults.size() == 1);
  CHECK(cases.faults[0] ==
        "long.yaml: no calibrated case: line 5: a value over several lines cannot be replaced; "
        "write it in one line");
}

TEST_CASE("of two internal contact forces only the varied one has new numbers") {
  const Folder folder;
  const fs::path path = folder.write("puck.yaml", R"(slipbench: 1
connector: {type: PLANAR}
friction:
  - predefined:
      R: 20
      internal_contact_force: {columns: [force, temperature], rows: [[100, 0], [90, 50]]}
      internal_contact_moment: {columns: [force, temperature], rows: [[300, 0], [200, 50]]}
    coefficient: 0.2
    stick: {elastic_slip: 1e-3}
history:
  - {step: slide, duration: 1, increments: 10, motion: {CP2: {to: 5}}}
)");
  const read::ReadCase read = read::read_case(path.string());
  REQUIRE(read.value);
  Made made;
  made.add_experiment("a", path, *read.value);
  constexpr auto kUse = calibrate::VariedTable::Use::kInternalContactForce;
  made.vary_table("spinning", kUse,
                  calibrate::varied_table(read.value->definitions.at(1).law, kUse)->table());
  const std::string text =
      only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder.path()));
  CHECK(contains(text, "rows: [[100, 0], [90, 50]]"));
  CHECK_FALSE(contains(text, "[300, 0]"));
}

TEST_CASE("every shipped case reads back with the numbers that were put into it") {
  int with_parameters = 0;
  int with_tables = 0;
  for (const char* room : {"examples", "verification", "validation", "calibration"}) {
    for (const auto& entry :
         fs::directory_iterator(fs::path(slipbench::test::source_dir()) / "cases" / room)) {
      if (entry.path().extension() != ".yaml") continue;
      INFO(entry.path());
      const read::ReadCase read = read::read_case(entry.path().string());
      if (!read.value) continue;  // a fit file, or one that needs a parameter
      Made made;
      made.add_experiment("a", entry.path(), *read.value);
      std::vector<base::ParameterText> all;
      for (const auto& [name, value] : read.value->parameters)
        all.push_back({name, changed(value)});
      read::ReadCase expected = read::read_case(entry.path().string(), {all});
      if (!expected.value) {
        // Parameters that only take certain values, as a number of increments, keep theirs.
        for (base::ParameterText& one : all) {
          if (read::read_case(entry.path().string(), {{one}}).value) continue;
          one.value = read.value->parameters.at(one.name);
        }
        expected = read::read_case(entry.path().string(), {all});
      }
      for (const base::ParameterText& one : all) made.vary(one.name, std::get<double>(one.value));
      if (!expected.value) continue;
      with_parameters += all.empty() ? 0 : 1;
      for (const cases::CaseDefinition& definition : expected.value->definitions) {
        for (const auto use : {calibrate::VariedTable::Use::kCoefficient,
                               calibrate::VariedTable::Use::kInternalContactForce}) {
          const law::TableFunction* function = calibrate::varied_table(definition.law, use);
          const bool orthotropic =
              definition.law.formulation && definition.law.formulation->orthotropy;
          if (function == nullptr || orthotropic) continue;
          made.vary_table(definition.name, use, function->table());
          ++with_tables;
        }
      }
      const fs::path folder = entry.path().parent_path();
      const std::string text =
          only_text(calibrate::calibrated_cases(made.fit, made.calibration, folder));
      const read::ReadCase again = read_text(text, folder);
      REQUIRE(again.value);
      CHECK(again.value->parameters == expected.value->parameters);
      for (const calibrate::FittedTable& table : made.calibration.tables) {
        const calibrate::VariedTable& varied = made.fit.tables[table.index];
        for (const cases::CaseDefinition& definition : again.value->definitions) {
          if (definition.name != varied.definition) continue;
          const law::TableFunction* function = calibrate::varied_table(definition.law, varied.use);
          REQUIRE(function != nullptr);
          REQUIRE(function->table().rows() == table.count);
          for (std::size_t r = 0; r < table.count; ++r) {
            CHECK(function->table().ordinate(r) ==
                  made.calibration.unknowns[table.first_unknown + r].value);
            CHECK(function->table().point(r) == table.points[r]);
          }
        }
      }
      CHECK(again.value->checks.size() == expected.value->checks.size());
      CHECK(again.value->steps.size() == expected.value->steps.size());
      CHECK(bench::Simulation::start(*again.value).has_value());
    }
  }
  CHECK(with_parameters > 50);
  CHECK(with_tables >= 8);
}
