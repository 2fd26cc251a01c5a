// SPDX-License-Identifier: Apache-2.0
// Outliers of a measurement, from the data file to what is told of them and whether that helps.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "driver/calibrate/calibration_json.hpp"
#include "driver/calibrate/fit_summary.hpp"
#include "driver/calibrate/report/residual_view.hpp"
#include "tests/driver/calibrate/fit_for_test.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// The slider in steps so short that between rows of the run nothing is cut off at its corners.
std::string fine_case() {
  return std::regex_replace(SliderRig::case_text(), std::regex("increments: (\\d+)"),
                            "increments: $010");
}

/// The rig's data with a point more, at rest, and spikes that enlarge the force: lines and height.
std::string with_spikes(std::string data, const std::vector<int>& lines, double height) {
  data.insert(data.find('\n') + 1, "0,0,0\n");
  std::istringstream in(data);
  std::string text;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (std::find(lines.begin(), lines.end(), number) != lines.end()) {
      const std::size_t comma = line.rfind(',');
      const double force = std::stod(line.substr(comma + 1));
      line = fmt::format("{},{:.17g}", line.substr(0, comma),
                         force + (force > 0.0 ? height : -height));
    }
    text += line + "\n";
  }
  return text;
}

std::string outlier_note(const Calibration& calibration) {
  for (const std::string& note : calibration.notes) {
    if (note.find("outlier") != std::string::npos) return note;
  }
  return {};
}

/// Distance of an estimate from the truth in its standard errors.
double off(const Calibration& calibration, std::size_t unknown, double truth) {
  return std::abs(calibration.unknowns[unknown].value - truth) /
         calibration.statistics.standard_error[unknown];
}

}  // namespace

TEST_CASE("five outliers of 2001 points are named, and the loss that is advised gives the truth") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", fine_case());
  const SliderRig rig{.noise = 0.5, .seed = 4, .rows = 2000};
  // In a row of the file behind the header, on both flanks of the loop.
  const std::vector<int> lines{302, 800, 1100, 1500, 1998};
  folder.write("rig.csv", with_spikes(rig.data(), lines, 20.0));
  const Fit squares = sound_fit(folder, kSliderFit);
  const Calibration found = calibrated(squares);
  const FittedResponse& response = found.experiments[0].responses[0];
  REQUIRE(response.outliers.points.size() == 5);
  CHECK(response.lines == std::vector<std::size_t>(lines.begin(), lines.end()));
  CHECK(response.outliers.scale == Approx(0.5).epsilon(0.1));
  CHECK(response.rmse_after > 2.0 * response.outliers.scale);

  const std::string note = outlier_note(found);
  INFO(note);
  CHECK(
      note ==
      "slider, CSF1: 5 of 2001 points are outliers, more than 4.6 robust sigma (of 0.4761 N) from "
      "the rest and from their neighbours (noise has such a point in fewer than 1 of 100 series): "
      "t = 1.2 s (line 302): 26.04 N, 42 sigma above the model; t = 3.192 s (line 800): -26.72 N, "
      "41 sigma below the model; t = 4.392 s (line 1100): 51.06 N, 44 sigma above the model; "
      "t = 5.992 s (line 1500): -50.22 N, 42 sigma below the model; t = 7.984 s (line 1998): "
      "50.67 N, 43 sigma above the model; if they are faults of the measurement, "
      "`loss: {huber: 0.64}` under `calibrate:` lets them count little; mu is then 0.3 instead of "
      "0.3004");
  CHECK(residual_view(response, response.after).words.starts_with("5 of 2001 points are outliers"));
  CHECK(fit_summary(squares, found).find("  note: slider, CSF1: 5 of 2001 points are outliers") !=
        std::string::npos);
  const std::string json = calibration_json(squares, found).dump();
  CHECK(json.find("\"outlier_limit\": 4.5") != std::string::npos);
  CHECK(json.find("\"line\": 1998, \"measured\": ") != std::string::npos);

  std::smatch advice;
  REQUIRE(std::regex_search(note, advice, std::regex("`(loss: [^`]*)` under `calibrate:`")));
  const Fit advised = sound_fit(folder, kSliderFit + "  " + advice[1].str() + "\n");
  const Calibration mended = calibrated(advised);
  CHECK(off(mended, 0, rig.mu) < 3.0);
  CHECK(off(mended, 1, rig.stiffness) < 3.0);
  CHECK(mended.statistics.standard_error[0] < 0.7 * found.statistics.standard_error[0]);
  CHECK(std::abs(found.unknowns[0].value - rig.mu) > 3.0 * mended.statistics.standard_error[0]);
  // Advice that was followed is not given again.
  CHECK(outlier_note(mended).find("5 of 2001") != std::string::npos);
  CHECK(outlier_note(mended).find("loss:") == std::string::npos);
}

TEST_CASE("the loss that is advised helps whatever the noise and the outliers happen to be") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", fine_case());
  int inside = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const SliderRig rig{.noise = 0.5, .seed = seed, .rows = 2000};
    const int at = static_cast<int>(40 * seed);
    const double height = seed % 2 == 0 ? 10.0 : 300.0;
    folder.write("rig.csv",
                 with_spikes(rig.data(), {at, at + 50, at + 130, at + 190, at + 300}, height));
    const std::string note = outlier_note(calibrated(folder, kSliderFit));
    std::smatch advice;
    REQUIRE(std::regex_search(note, advice, std::regex("`(loss: [^`]*)`")));
    const Calibration mended = calibrated(folder, kSliderFit + "  " + advice[1].str() + "\n");
    inside += off(mended, 0, rig.mu) < 2.0 ? 1 : 0;
    CHECK(off(mended, 0, rig.mu) < 4.0);
    CHECK(off(mended, 1, rig.stiffness) < 4.0);
  }
  CHECK(inside >= 35);
}

TEST_CASE("clean data and data that the model does not have are told of no outliers") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", fine_case());
  int alarms = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    folder.write("rig.csv", SliderRig{.noise = 0.5, .seed = seed, .rows = 320}.data());
    alarms += outlier_note(calibrated(folder, kSliderFit)).empty() ? 0 : 1;
  }
  CHECK(alarms <= 3);
  // Stiffness alone cannot meet a rig of another coefficient: a trend.
  folder.write("rig.csv", SliderRig{.mu = 0.2, .noise = 0.5, .rows = 2000}.data());
  const Calibration found =
      calibrated(folder,
                 "slipbench: 1\ncalibrate:\n"
                 "  experiments: [{case: slider.yaml, set: {mu: 0.3}, data: rig.csv, time: t,\n"
                 "                 compare: {CSF1: F}}]\n"
                 "  vary: {k: {bounds: [1, 1.0e+5], scale: log}}\n");
  CHECK(outlier_note(found).empty());
  CHECK(found.notes.at(0).find("is a trend, not noise") != std::string::npos);
}

TEST_CASE("outliers of quantities of another noise ask for their sigma") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", fine_case());
  const SliderRig quiet{.noise = 0.05, .seed = 8, .rows = 500};
  const SliderRig loud{.noise = 2.0, .seed = 9, .rows = 500};
  folder.write("rig.csv", quiet.data());
  folder.write("loud.csv", with_spikes(loud.data(), {100, 300}, 60.0));
  const std::string both =
      "slipbench: 1\ncalibrate:\n  experiments:\n"
      "    - {case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: {column: F}}}\n"
      "    - {name: loud, case: slider.yaml, data: loud.csv, time: t, compare: {CSF1: {column: "
      "F}}}\n"
      "  vary: {mu: {bounds: [0, 2]}, k: {bounds: [1, 1.0e+5], scale: log}}\n";
  const std::string note = outlier_note(calibrated(folder, both));
  INFO(note);
  CHECK(note.starts_with("loud, CSF1: 2 of 501 points are outliers"));
  CHECK(note.find("the sigma of each response and `loss: {huber: 1.345}`") != std::string::npos);
}

}  // namespace slipbench::driver::calibrate
