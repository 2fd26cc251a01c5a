// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/error_notes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/driver/calibrate/fit_for_test.hpp"

namespace slipbench::driver::calibrate {
namespace {

bool says(const std::vector<std::string>& notes, std::string_view words) {
  return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

void write_rig(const TemporaryFolder& folder, const SliderRig& rig) {
  folder.write("slider.yaml", SliderRig::case_text());
  folder.write("rig.csv", rig.data());
}

/// The fit of the slider with more lines under `calibrate`.
std::string fit_with(const std::string& lines) { return kSliderFit + lines; }

}  // namespace

TEST_CASE("a sound fit has no notes on its errors") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  const Fit fit = sound_fit(folder, fit_with("  bootstrap: 20\n  profile: true\n"));
  const Calibration found = calibrated(fit);
  CHECK(found.profiles.size() == 2);
  CHECK(found.bootstrap.done == 20);
  CHECK(error_notes(fit, found).empty());
}

TEST_CASE("as many points as unknowns: no errors, no bootstrap, no profiles, and that is said") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", SliderRig::case_text());
  folder.write("rig.csv", "t,F\n0.1,12\n1,30.5\n");
  const Calibration found = calibrated(folder, fit_with("  bootstrap: 20\n  profile: true\n"));
  CHECK(found.fit.converged);
  CHECK(found.profiles.empty());
  CHECK(says(found.notes,
             "2 compared points for 2 unknowns: they can be met whatever the noise, and nothing "
             "can be told of the errors (the bootstrap and the profiles left out)"));
}

TEST_CASE("a bootstrap that is left out is told") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  const Calibration found =
      calibrated(folder, fit_with("  stop: {iterations: 1}\n  bootstrap: 20\n"));
  CHECK_FALSE(found.fit.converged);
  CHECK(says(found.notes, "the bootstrap was left out: the fit did not converge"));
}

TEST_CASE("responses of different noise without sigma are told, with a sigma they are not") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.1});
  folder.write("loud.csv", SliderRig{.noise = 2.0, .seed = 2}.data());
  const auto fit = [](const std::string& sigma) {
    return "slipbench: 1\n"
           "calibrate:\n"
           "  experiments:\n"
           "    - {name: quiet, case: slider.yaml, data: rig.csv, time: t,\n"
           "       compare: {CSF1: {column: F}}}\n"
           "    - {name: loud, case: slider.yaml, data: loud.csv, time: t,\n"
           "       compare: {CSF1: {column: F" +
           sigma +
           "}}}\n"
           "  vary: {mu: {bounds: [0, 2]}, k: {bounds: [1, 1.0e+5], scale: log}}\n";
  };
  const Calibration found = calibrated(folder, fit(""));
  CHECK(says(found.notes, "loud, CSF1 to 2"));
  CHECK(says(found.notes, "give every response its sigma"));
  // Rows of one response follow each other.
  CHECK(found.problem.groups == std::vector<std::size_t>{0, 160});
  CHECK_FALSE(says(calibrated(folder, fit(", sigma: 2")).notes, "its sigma"));
}

TEST_CASE("a robust threshold far below the noise is told, a usual one is not") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  CHECK(says(calibrated(folder, fit_with("  loss: {huber: 0.01}\n")).notes,
             "errors are not to be trusted; raise it to about 0."));
  CHECK_FALSE(says(calibrated(folder, fit_with("  loss: {huber: 0.4}\n")).notes, "threshold"));
}

}  // namespace slipbench::driver::calibrate
