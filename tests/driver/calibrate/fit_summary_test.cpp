// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit_summary.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <sstream>
#include <string>

#include "driver/calibrate/calibration_json.hpp"
#include "tests/driver/calibrate/calibration_for_test.hpp"

using namespace slipbench::driver;
using namespace slipbench::driver::calibrate;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

FittedExperiment fitted(std::size_t index, double before, double after) {
  FittedExperiment experiment;
  experiment.index = index;
  experiment.data_hash = "abc";
  calibrate::FittedResponse response;
  response.quantity = "CSF1";
  response.unit = "N";
  response.measured.assign(400, 1.0);
  response.rmse_before = before;
  response.rmse_after = after;
  response.range = 6200.0;
  response.outliers.scale = 1.01 * after;
  experiment.responses.push_back(response);
  return experiment;
}

struct Rig {
  Fit fit = fit_of({"mu", "k"});
  calibrate::Calibration calibration =
      calibration_of({{"mu", 0.23104}, {"k", 4212.8}}, {1, 2, 3, 4, 5, 7});

  Rig() {
    for (const char* name : {"loop", "slow", "rig2"}) {
      fit.experiments.emplace_back();
      fit.experiments.back().name = name;
      fit.experiments.back().data_file = std::string(name) + ".csv";
    }
    fit.experiments[2].held_out = true;
    calibration.experiments = {fitted(0, 812, 70), fitted(1, 790, 72), fitted(2, 801, 74.1)};
    calibration.unknowns[1].unit = "N/mm";
    calibration.statistics.standard_error = {0.002, 50};
    calibration.statistics.lower = {0.227, 4113};
    calibration.statistics.upper = {0.235, 4313};
    calibration.statistics.correlation = {1.0, 0.31, 0.31, 1.0};
    calibration.seconds = 0.21;
  }
};

}  // namespace

TEST_CASE("a summary tells verdict, errors and estimates with the digits that are known") {
  const Rig rig;
  CHECK(calibrate::fit_summary(rig.fit, rig.calibration) ==
        "rig: 2 unknowns, 800 points of 2 experiments, 1 held out, 0.21 s\n"
        "  converged after 7 iterations: the steps have become negligible\n"
        "  RMSE of CSF1 71.01 N of 6200 N (hold-out 74.1 N)\n"
        "\n"
        "  parameter  estimate  +-      95 % interval     start\n"
        "  mu         0.2310    0.0020  0.2270 .. 0.2350  1\n"
        "  k [N/mm]   4213      50      4113 .. 4313      1\n"
        "  strongest correlation: mu and k 0.31\n"
        "\n"
        "  experiment            quantity  points  before  RMSE  robust  range\n"
        "  loop                  CSF1 [N]  400     812     70    70.7    6200   1.1 %\n"
        "  slow                  CSF1 [N]  400     790     72    72.72   6200   1.2 %\n"
        "  rig2        hold-out  CSF1 [N]  400     801     74.1  74.84   6200   1.2 %\n");
}

TEST_CASE("a search that did not converge says so first") {
  Rig rig;
  rig.calibration.fit.converged = false;
  rig.calibration.fit.stop_sentence = "nothing that is varied changes any residual at the start";
  rig.calibration.fit.iterations = 0;
  const std::string text = calibrate::fit_summary(rig.fit, rig.calibration);
  INFO(text);
  CHECK(contains(text,
                 "\n  NOT CONVERGED after 0 iterations: nothing that is varied changes any "
                 "residual\n    at the start\n"));
}

TEST_CASE("bounds, weak and unseen unknowns, starts, profiles and notes are told in 80 columns") {
  Rig rig;
  calibrate::Calibration& c = rig.calibration;
  c.fit.at_upper[0] = 1;
  c.fit.frozen[1] = 1;
  c.unknowns[0].identifiability = Identifiability::kWeak;
  c.unknowns[1].identifiability = Identifiability::kNeverVisited;
  c.statistics.standard_error[1] = std::numeric_limits<double>::quiet_NaN();
  c.fit.cost = 2.0;
  c.fit.searches.resize(4);
  c.fit.searches[0].cost = c.fit.searches[1].cost = 2.0;
  c.fit.searches[2].cost = 6.8;
  c.fit.searches[3].stop = fit::StopReason::kModelFailure;
  fit::LikelihoodProfile profile;
  profile.lower = 0.22;
  profile.upper = std::numeric_limits<double>::infinity();
  profile.open_above = true;
  c.profiles.push_back(profile);
  c.bootstrap.wanted = c.bootstrap.done = 200;
  c.bootstrap.block = 5;
  c.bootstrap.standard_error = {0.003, 0.0};
  c.bootstrap.lower = {0.226, 1.0};
  c.bootstrap.upper = {0.237, 1.0};
  c.notes = {
      "a sentence that is longer than a line of a terminal with eighty columns can ever hold, so "
      "that it goes on"};
  const std::string text = calibrate::fit_summary(rig.fit, c);
  for (const char* part :
       {"  2 of 4 starts found this minimum, the next best has 3.4 times its cost, 1 had\n"
        "    no value\n",
        "  1      at its upper bound, weak\n", "  never visited, kept\n",
        "0.2200 .. inf  open above: the data do not bound it there\n", "0.0030  0.2260 .. 0.2370\n",
        "  (200 of 200 resamplings, in blocks of 5 points)\n",
        "  note: a sentence that is longer than a line of a terminal with eighty columns\n"
        "    can ever hold, so that it goes on\n"}) {
    INFO(part << " in\n" << text);
    CHECK(contains(text, part));
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(line.size() <= 80);
  }
}

TEST_CASE("names cannot harm the terminal") {
  Rig rig;
  rig.fit.experiments[0].name = "a\033[31mb";
  rig.calibration.unknowns[0].name = "x\ny";
  rig.calibration.notes = {"z\033[0m"};
  const std::string text = calibrate::fit_summary(rig.fit, rig.calibration);
  CHECK_FALSE(contains(text, "\033"));
  CHECK_FALSE(contains(text, "x\ny"));
}

TEST_CASE("a fitted table is told row by row, with what was never visited") {
  Rig rig;
  rig.fit.tables.emplace_back();
  rig.fit.tables[0].name = "sleeve.coefficient";
  rig.fit.tables[0].free = "mu";
  calibrate::Calibration c =
      calibration_of({{"r0", 0.3}, {"r1", 0.2}, {"r2", 0.25}, {"r3", 1.0}}, {1, 2, 3, 4});
  rig.fit.vary.clear();
  c.tables.push_back(calibrate::grid_table({0, 10}, {20, 80}, 0));
  c.fit.frozen[3] = 1;
  c.unknowns[3].identifiability = Identifiability::kNeverVisited;
  c.statistics.standard_error[3] = std::numeric_limits<double>::quiet_NaN();
  const std::string text = calibrate::fit_summary(rig.fit, c);
  INFO(text);
  CHECK(contains(
      text,
      "\n  table sleeve.coefficient\n"
      "  slip_rate [mm/s]  temperature [degC]  mu      +-      start\n"
      "  0                 20                  0.3000  0.0030  1\n"
      "  10                20                  0.2000  0.0020  1\n"
      "  0                 80                  0.2500  0.0025  1\n"
      "  10                80                  1       -       1      never visited, kept\n"));
}

TEST_CASE("the JSON document of a calibration has stable keys and null for what is not known") {
  Rig rig;
  rig.calibration.unknowns[1].distance_to_upper = std::numeric_limits<double>::infinity();
  rig.calibration.fit.at_lower[1] = 1;
  rig.calibration.unknowns[0].identifiability = Identifiability::kWeak;
  const std::string text = calibrate::calibration_json(rig.fit, rig.calibration).dump();
  for (const char* part :
       {R"({"provenance": {"program": "slipbench")",
        R"("fit": "rig.yaml", "title": "rig", "date": null)",
        R"({"name": "loop", "case": "", "data": "loop.csv", "sha256": "abc"})",
        R"("result": {"converged": true, "stop": "step")",
        R"({"name": "mu", "unit": "", "value": 0.23104, "standard_error": 0.002)",
        R"("interval": [0.227, 0.235], "start": 1)",
        R"("bounds": [0, null], "scale": "linear", "at_bound": "lower")",
        R"("distance_to_upper": null, "identifiability": "good")", R"("identifiability": "weak")",
        R"("correlation": [[1, 0.31], [0.31, 1]])", R"("tables": [])",
        R"("name": "rig2", "held_out": true)",
        R"("rmse_before": 801, "rmse_after": 74.1, "range": 6200)",
        R"("profiles": [], "notes": []})", R"("points": 400)"}) {
    INFO(part << " in\n" << text);
    CHECK(contains(text, part));
  }
}

TEST_CASE("a start without a value has no cost and found no minimum in the JSON document") {
  Rig rig;
  rig.calibration.fit.cost = 2.0;
  rig.calibration.fit.searches.resize(2);
  rig.calibration.fit.searches[0].cost = 2.0;
  rig.calibration.fit.searches[1].stop = fit::StopReason::kModelFailure;
  const std::string text = calibrate::calibration_json(rig.fit, rig.calibration).dump();
  CAPTURE(text);
  CHECK(contains(text, R"("start_cost": null, "cost": null, "iterations": 0, )"
                       R"("stop": "model_failure", "same_minimum": false)"));
  CHECK(contains(text, R"("cost": 2, "iterations": 0, "stop": "no_iteration", )"
                       R"("same_minimum": true)"));
}

TEST_CASE("of very many points the JSON document has some, and says how many") {
  Rig rig;
  rig.calibration.experiments.resize(1);
  calibrate::FittedResponse& response = rig.calibration.experiments[0].responses[0];
  response.measured.clear();
  for (int i = 0; i < 25001; ++i) response.measured.push_back(i);
  response.time = response.before = response.after = response.measured;
  const std::string text = calibrate::calibration_json(rig.fit, rig.calibration).dump();
  CHECK(contains(text, R"("points": 25001)"));
  CHECK(contains(text, R"("points_told": 8335)"));
  CHECK(contains(text, "24996, 24999, 25000]"));
  CHECK(contains(text, "[0, 3, 6"));
}
