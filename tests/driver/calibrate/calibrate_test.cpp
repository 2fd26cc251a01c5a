// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/calibrate/calibration_json.hpp"
#include "reference/exponential_decay.hpp"
#include "tests/driver/calibrate/fit_for_test.hpp"

namespace slipbench::driver::calibrate {
namespace {

std::string with(std::string text, std::string_view what, std::string_view by) {
  const std::size_t place = text.find(what);
  REQUIRE(place != std::string::npos);
  return text.replace(place, what.size(), by);
}

void write_rig(const TemporaryFolder& folder, const SliderRig& rig = {}) {
  folder.write("slider.yaml", SliderRig::case_text());
  folder.write("rig.csv", rig.data());
}

bool says(const std::vector<std::string>& notes, std::string_view words) {
  return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("a clean loop gives back what it was made with") {
  const TemporaryFolder folder;
  write_rig(folder);
  const Calibration found = calibrated(folder, kSliderFit);
  CHECK(found.fit.converged);
  // The data are exact but for rounding: what is left is that of the solution, some 1e-12.
  CHECK(estimate(found, "mu") == Approx(0.3).epsilon(1e-10));
  CHECK(estimate(found, "k") == Approx(120.0).epsilon(1e-10));
  CHECK(found.derivatives == "exact derivatives of all 2 unknowns");
  REQUIRE(found.experiments.size() == 1);
  const FittedResponse& response = found.experiments[0].responses.at(0);
  CHECK(response.measured.size() == 160);
  CHECK(response.unit == "N");
  CHECK(response.rmse_before > 5.0);
  CHECK(response.rmse_after < 1e-8);
  CHECK(response.range == Approx(60.0));
  CHECK(response.position == "CP1");
  CHECK(response.positions.at(9) == Approx(0.5));
}

TEST_CASE("a case that fails at the start values is told with its reason") {
  const TemporaryFolder folder;
  folder.write(
      "sheet.yaml",
      "slipbench: 1\n"
      "parameters: {c: 8, N: 100}\n"
      "connector: {type: SLOT}\n"
      "friction:\n"
      "  - name: sheet\n"
      "    predefined: {}\n"
      "    coefficient:\n"
      "      modified_darmstad: {Fric: 0.1, C1: 0, C2: 0, C3: 0, C4: 0, C5: 0.1, C6: = c,\n"
      "                          area: 2}\n"
      "    stick: {stiffness: 1000}\n"
      "integration: {slip_rate: relative_motion}\n"
      "history:\n"
      "  - {step: draw, duration: 1, increments: 10, force: {f2: = N},\n"
      "     motion: {CP1: {to: 100}}}\n");
  folder.write("sheet.csv", "t,F\n0.1,10\n0.5,20\n1,30\n");
  const std::string experiment =
      "    - {case: sheet.yaml, data: sheet.csv, time: t, compare: {CSF1: F}}\n";
  // Fitted, or only scored.
  const bool held_out = GENERATE(false, true);
  if (held_out) write_rig(folder);
  const Fit fit = sound_fit(
      folder,
      held_out ? with(std::string(kSliderFit), "  vary:", "  holdout:\n" + experiment + "  vary:")
               : "slipbench: 1\ncalibrate:\n  experiments:\n" + experiment +
                     "  vary: {c: {bounds: [0, 20]}}\n");
  const auto found = calibrate(fit);
  REQUIRE_FALSE(found);
  CHECK(found.error().code == base::kExitNumerical);
  CHECK(found.error().message.find("sheet.yaml: at the start values: ") != std::string::npos);
  CHECK(found.error().message.find("the exponent C6 V of the coefficient passes 700 at V = 100") !=
        std::string::npos);
}

TEST_CASE("every case that fails at the start values is told, also by what is not compared") {
  const TemporaryFolder folder;
  for (const char* const name : {"first", "second"}) {
    folder.write(
        fmt::format("{}.yaml", name),
        "slipbench: 1\n"
        "parameters: {mu: 0.3}\n"
        "connector: {type: CYLINDRICAL}\n"
        "friction:\n"
        "  - {name: axial, component: 1, contact_force: 2, coefficient: = mu,\n"
        "     stick: {stiffness: 1000}}\n"
        "  - name: around\n"
        "    component: 4\n"
        "    contact_force: 2\n"
        "    coefficient:\n"
        "      modified_darmstad: {Fric: 0.1, C1: 0, C2: 0, C3: 0, C4: 0, C5: 0.1, C6: 8,\n"
        "                          area: 2}\n"
        "    stick: {stiffness: 1000}\n"
        "integration: {slip_rate: relative_motion}\n"
        "history:\n"
        "  - {step: draw, duration: 1, increments: 10, force: {f2: 100},\n"
        "     motion: {CP1: {to: 1}, CPR1: {to: 100}}}\n");
  }
  folder.write("axial.csv", "t,F\n0.1,10\n0.5,20\n1,30\n");
  const Fit fit =
      sound_fit(folder,
                "slipbench: 1\n"
                "calibrate:\n"
                "  experiments:\n"
                "    - {name: A, case: first.yaml, data: axial.csv, time: t, compare: {CSF1: F}}\n"
                "    - {name: B, case: second.yaml, data: axial.csv, time: t, compare: {CSF1: F}}\n"
                "  vary: {mu: {bounds: [0, 1]}}\n");
  const auto found = calibrate(fit);
  REQUIRE_FALSE(found);
  CHECK(found.error().code == base::kExitNumerical);
  for (const char* const name : {"first", "second"}) {
    CHECK(found.error().message.find(fmt::format("{}.yaml: at the start values: ", name)) !=
          std::string::npos);
  }
  CHECK(found.error().message.find("definition 'around'") != std::string::npos);
}

TEST_CASE("the numbers of an exponential decay follow from its closed form") {
  // Steady sliding at eight speeds, read at the end of each: mu(v) N.
  const reference::exponential_decay::Decay truth{0.30, 0.18, 0.5};
  constexpr double kNormalForce = 200.0;
  std::string steps;
  std::string data = "t,F\n";
  double position = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double speed = 0.05 * std::pow(2.0, i);
    position += speed;
    steps += fmt::format(
        "  - {{step: s{}, duration: 1, increments: 20, motion: {{CP1: {{to: {:.17g}}}}}{}}}\n", i,
        position, i == 0 ? ", force: {f2: 200}" : "");
    data += fmt::format("{},{:.17g}\n", i + 1,
                        kNormalForce * reference::exponential_decay::coefficient(truth, speed));
  }
  const TemporaryFolder folder;
  folder.write(
      "pad.yaml",
      "slipbench: 1\n"
      "parameters: {mu_s: 0.9, mu_k: 0.06, d: 1.5}\n"
      "connector: {type: SLOT}\n"
      "friction:\n"
      "  - predefined: {}\n"
      "    coefficient: {exponential_decay: {static: = mu_s, kinetic: = mu_k, decay: = d}}\n"
      "    stick: {elastic_slip: 1.0e-4}\n"
      "history:\n" +
          steps);
  folder.write("pad.csv", data);
  const Calibration found = calibrated(
      folder,
      "slipbench: 1\n"
      "calibrate:\n"
      "  experiments: [{case: pad.yaml, data: pad.csv, time: t, compare: {CSF1: F}}]\n"
      "  vary: {mu_s: {bounds: [0, 3]}, mu_k: {bounds: [0, 3]}, d: {bounds: [1.0e-3, 100]}}\n");
  CHECK(found.fit.converged);
  // The end of a step is slip at the speed of the motion but for rounding of the positions, 1e-13.
  CHECK(estimate(found, "mu_s") == Approx(truth.static_coefficient).epsilon(1e-9));
  CHECK(estimate(found, "mu_k") == Approx(truth.kinetic_coefficient).epsilon(1e-9));
  CHECK(estimate(found, "d") == Approx(truth.decay_coefficient).epsilon(1e-9));
}

TEST_CASE("of a noisy loop the truth lies within three standard errors, for every seed") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const TemporaryFolder folder;
    write_rig(folder, {.noise = 0.3, .seed = seed});
    const Calibration found = calibrated(folder, kSliderFit);
    CHECK(found.fit.converged);
    const std::vector<double>& error = found.statistics.standard_error;
    CHECK(std::abs(estimate(found, "mu") - 0.3) < 3.0 * error.at(0));
    CHECK(std::abs(estimate(found, "k") - 120.0) < 3.0 * error.at(1));
    CHECK(found.statistics.deviation == Approx(0.3).epsilon(0.2));  // 160 points: 6 % scatter
    CHECK(std::abs(found.experiments[0].responses[0].autocorrelation) < 0.3);
    CHECK_FALSE(says(found.notes, "trend"));
  }
}

TEST_CASE("several experiments share an unknown, and each has its own") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("rig2.csv", SliderRig{.stiffness = 200.0, .normal_force = 50.0}.data());
  folder.write("other.yaml", with(with(SliderRig::case_text(), "k: 360", "k2: 90"), "= k", "= k2"));
  const Calibration found = calibrated(
      folder,
      "slipbench: 1\n"
      "calibrate:\n"
      "  experiments:\n"
      "    - {case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: F}}\n"
      "    - {case: other.yaml, set: {N: 50}, data: rig2.csv, time: t, compare: {CSF1: F}}\n"
      "  vary: {mu: {bounds: [0, 2]}, k: {}, k2: {}}\n");
  CHECK(found.fit.converged);
  CHECK(estimate(found, "mu") == Approx(0.3).epsilon(1e-9));
  CHECK(estimate(found, "k") == Approx(120.0).epsilon(1e-9));
  CHECK(estimate(found, "k2") == Approx(200.0).epsilon(1e-9));
  // The other case does not have k: its rows do not depend on it.
  CHECK(found.unknowns.at(1).visits > 0);
  CHECK(found.unknowns.at(1).visits <= 160);
}

TEST_CASE("what is held out has no say in the estimates, bit by bit") {
  const std::string fit = with(kSliderFit, "  vary:",
                               "  holdout:\n"
                               "    - {case: slider.yaml, data: other.csv, time: t, compare: "
                               "{CSF1: F}}\n"
                               "  vary:");
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  folder.write("other.csv", SliderRig{.noise = 0.3, .seed = 7}.data());
  const Calibration one = calibrated(folder, fit);
  folder.write("other.csv", SliderRig{.mu = 0.6, .stiffness = 20.0}.data());
  const Calibration other = calibrated(folder, fit);
  CHECK(one.fit.x == other.fit.x);
  CHECK(one.fit.residuals == other.fit.residuals);
  CHECK(one.statistics.standard_error == other.statistics.standard_error);
  CHECK(one.problem.rows == 160);
  CHECK(one.experiments.at(1).share_of_cost == 0.0);
  CHECK(one.experiments.at(0).share_of_cost == Approx(1.0));
  CHECK(one.experiments.at(1).responses.at(0).rmse_after ==
        Approx(one.experiments.at(0).responses.at(0).rmse_after).epsilon(0.3));
  CHECK_FALSE(says(one.notes, "hold-out"));
  CHECK(says(other.notes, "hold-out"));
}

TEST_CASE("over the position a clean loop gives the same as over time") {
  const TemporaryFolder folder;
  write_rig(folder, {.rows = 144});  // between the rows of the run, but for some
  const Calibration over_time = calibrated(folder, kSliderFit);
  const Calibration over_position = calibrated(
      folder, with(kSliderFit, "CSF1: F}", "CSF1: {column: F, over: {quantity: CP1, column: u}}}"));
  CHECK(over_position.fit.converged);
  const FittedResponse& response = over_position.experiments[0].responses[0];
  CHECK(response.over == "CP1");
  CHECK(response.abscissa.size() == response.measured.size());
  CHECK(response.measured.size() == 144);
  // Positions and times are linear in one another: only rounding is different.
  CHECK(estimate(over_position, "mu") == Approx(estimate(over_time, "mu")).epsilon(1e-9));
  CHECK(estimate(over_position, "k") == Approx(estimate(over_time, "k")).epsilon(1e-9));
}

TEST_CASE("over the position a loop without noise gives back the truth, soft or stiff") {
  // Rows so dense that some lie within 1e-3 of the range behind each turn.
  constexpr int kRows = 8000;
  std::vector<double> position;
  for (int i = 1; i <= kRows; ++i) position.push_back(triangle(8.0 * i / kRows));
  std::string text = SliderRig::case_text();
  for (const auto& [few, many] : {std::pair{": 20,", ": 1000,"}, {": 40,", ": 2000,"}}) {
    for (std::size_t at = 0; (at = text.find(few, at)) != std::string::npos;) {
      text.replace(at, std::string(few).size(), many);
    }
  }
  const TemporaryFolder folder;
  folder.write("slider.yaml", text);
  for (const double stiffness : {60.0, 2000.0, 20000.0}) {
    const std::vector<double> forces = slider_forces(position, stiffness, 30.0);
    // On the rows of the run, and between them: then no row lies where it turns.
    for (const double shift : {0.0, 0.3, 0.8}) {
      CAPTURE(stiffness, shift);
      std::string data = "t,u,F\n";
      for (std::size_t i = 100; i + 100 < forces.size(); ++i) {
        const auto at = [&](const std::vector<double>& column) {
          return column[i] + shift * (column[i + 1] - column[i]);
        };
        data += fmt::format("{:.17g},{:.17g},{:.17g}\n",
                            8.0 * (static_cast<double>(i + 1) + shift) / kRows, at(position),
                            at(forces));
      }
      folder.write("rig.csv", data);
      const Calibration found = calibrated(
          folder,
          with(with(kSliderFit, "CSF1: F}", "CSF1: {column: F, over: {quantity: CP1, column: u}}}"),
               "k: {", fmt::format("k: {{start: {}, ", 0.8 * stiffness)));
      // Rounding of positions times the stiffness.
      CHECK(estimate(found, "mu") == Approx(0.3).epsilon(1e-8));
      CHECK(estimate(found, "k") == Approx(stiffness).epsilon(1e-8));
      CHECK(found.experiments[0].responses[0].measured.size() >= forces.size() - 200 - 8);
    }
  }
}

TEST_CASE("what has no weight is scored and has no say, not even in the errors") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  folder.write("other.csv", SliderRig{.mu = 0.6, .noise = 0.3, .seed = 7}.data());
  const Calibration alone =
      calibrated(folder, with(kSliderFit, "  vary:", "  bootstrap: 5\n  vary:"));
  const auto check = [&](const Calibration& found, double rounding) {
    CHECK(found.problem.data_rows == 160);
    CHECK(found.statistics.data == 160);
    CHECK(found.fit.residuals.size() == 160);
    CHECK(found.experiments.at(0).share_of_cost == Approx(1.0));
    CHECK(found.statistics.deviation == Approx(alone.statistics.deviation).epsilon(rounding));
    for (std::size_t u = 0; u < 2; ++u) {
      CHECK(found.fit.x.at(u) == Approx(alone.fit.x[u]).epsilon(rounding));
      CHECK(found.statistics.standard_error.at(u) ==
            Approx(alone.statistics.standard_error[u]).epsilon(rounding));
      // Those fits end at 1e-5 of a standard error.
      CHECK(found.bootstrap.standard_error.at(u) ==
            Approx(alone.bootstrap.standard_error[u]).epsilon(std::max(rounding, 1e-3)));
    }
  };
  // It stands first, and is told last, like a hold-out.
  const Calibration off = calibrated(
      folder, with(kSliderFit, "  experiments:\n",
                   "  bootstrap: 5\n"
                   "  experiments:\n"
                   "    - {name: off, weight: 0, case: slider.yaml, data: other.csv, time: t,\n"
                   "       compare: {CSF1: F}}\n"));
  check(off, 1e-12);
  REQUIRE(off.experiments.size() == 2);
  CHECK(off.experiments[1].responses.at(0).rmse_after > 10.0);
  CHECK(says(off.notes, "off has the weight 0: it is scored like a hold-out, not fitted"));
  // Beside a response that counts, before and behind it.
  for (const char* compare :
       {"{DISS: {column: t, weight: 0}, CSF1: F}", "{CSF1: F, DISS: {column: t, weight: 0}}"}) {
    const Calibration beside = calibrated(
        folder, with(with(kSliderFit, "{CSF1: F}", compare), "  vary:", "  bootstrap: 5\n  vary:"));
    // The other quantity takes whole runs and differences.
    check(beside, 1e-5);
    CHECK(says(beside.notes, "slider, DISS has the weight 0: it is scored, not fitted"));
    CHECK(beside.experiments.at(0).responses.size() == 2);
    for (const FittedResponse& response : beside.experiments[0].responses) {
      CHECK(response.measured.size() == 160);
      CHECK(std::isfinite(response.rmse_after));
    }
  }
}

TEST_CASE("a hold-out is judged for its size") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  const auto notes = [&](std::string_view noise, const SliderRig& rig) {
    folder.write("heavy.csv", rig.data());
    std::string fit =
        with(kSliderFit, "  vary:",
             "  holdout:\n"
             "    - {case: slider.yaml, set: {N: 300, amplitude: 3}, data: heavy.csv, time: t,\n"
             "       compare: {CSF1: {column: F" +
                 std::string(noise) +
                 "}}}\n"
                 "  vary:");
    if (!noise.empty()) fit = with(fit, "CSF1: F}", "CSF1: {column: F, sigma: 0.3}}");
    return calibrated(folder, fit).notes;
  };
  // Three times the load and three times the noise.
  const SliderRig heavy{.normal_force = 300.0, .amplitude = 3.0, .noise = 0.9, .seed = 7};
  CHECK_FALSE(says(notes("", heavy), "carry over"));
  CHECK_FALSE(says(notes(", sigma: 0.9", heavy), "carry over"));
  CHECK(says(notes(", sigma: 0.3", heavy), " sigma) against"));
  SliderRig other = heavy;
  other.stiffness = 90.0;
  CHECK(says(notes("", other), "% of its range) against"));
}

TEST_CASE("a resampling that would fill the memory is refused") {
  const TemporaryFolder folder;
  write_rig(folder);
  const auto found = calibrate(
      sound_fit(folder, with(kSliderFit, "time: t,", "time: t, resample: {every: 1.0e-12},")));
  REQUIRE_FALSE(found);
  CHECK(found.error().code == base::kExitBadInput);
  CHECK(found.error().message.find("resample: one row every 1e-12 s makes 8e+12 of 7.95 s, more "
                                   "than 1e+06: write a longer 'every'") != std::string::npos);
}

TEST_CASE("positions whose branches are not those of the run are refused with a reason") {
  const TemporaryFolder folder;
  write_rig(folder);
  std::string data = "t,u,F\n";
  for (int i = 0; i <= 80; ++i) {
    data += fmt::format("{},{:.17g},1\n", 0.1 * i, std::sin(3.0 * 0.1 * i));
  }
  folder.write("rig.csv", data);
  const Fit fit = sound_fit(
      folder, with(kSliderFit, "CSF1: F}", "CSF1: {column: F, over: {quantity: CP1, column: u}}}"));
  const auto found = calibrate(fit);
  REQUIRE_FALSE(found);
  CHECK(found.error().code == base::kExitBadInput);
  CHECK(found.error().message.find("branches") != std::string::npos);
  CHECK(found.error().message.find("over time") != std::string::npos);
}

TEST_CASE("weights decide between experiments that contradict each other") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", SliderRig::case_text());
  // Only in slip: F = mu N.
  folder.write("low.csv", "t,F\n0.9,20\n0.95,20\n1,20\n");
  folder.write("high.csv", "t,F\n0.9,40\n0.95,40\n1,40\n");
  const auto mu = [&](std::string_view low, std::string_view high) {
    return estimate(
        calibrated(folder, fmt::format("slipbench: 1\n"
                                       "calibrate:\n"
                                       "  experiments:\n"
                                       "    - {{case: slider.yaml, data: low.csv, time: t, {}}}\n"
                                       "    - {{case: slider.yaml, data: high.csv, time: t, {}}}\n"
                                       "  vary: {{mu: {{bounds: [0, 2]}}}}\n",
                                       low, high)),
        "mu");
  };
  // The weighted mean of 0.2 and 0.4: rounding only.
  CHECK(mu("compare: {CSF1: F}", "compare: {CSF1: F}") == Approx(0.3).epsilon(1e-9));
  CHECK(mu("weight: 3, compare: {CSF1: F}", "compare: {CSF1: F}") == Approx(0.25).epsilon(1e-9));
  CHECK(mu("compare: {CSF1: F}", "compare: {CSF1: {column: F, weight: 3}}") ==
        Approx(0.35).epsilon(1e-9));
  // Weights are those of squares: half the deviation counts four times.
  CHECK(mu("compare: {CSF1: {column: F, sigma: 0.5}}", "compare: {CSF1: {column: F, sigma: 1}}") ==
        Approx(0.24).epsilon(1e-9));
}

TEST_CASE("estimates do not depend on the units") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  const Calibration newtons = calibrated(folder, kSliderFit);
  // kN and m: forces by 1e3, lengths by 1e3, and the data still state theirs.
  std::string text = with(SliderRig::case_text(), "length: mm, force: N", "length: m, force: kN");
  text = with(text, "N: 100, amplitude: 1", "N: 0.1, amplitude: 0.001");
  folder.write("slider.yaml", text);
  const Calibration kilonewtons =
      calibrated(folder, with(with(kSliderFit, "CSF1: F}", "CSF1: {column: F, unit: N}}"),
                              "[1, 1.0e+5]", "[1, 1.0e+5]"));
  // k in kN/m is k in N/mm. Both are the same problem but for rounding.
  CHECK(estimate(kilonewtons, "mu") == Approx(estimate(newtons, "mu")).epsilon(1e-9));
  CHECK(estimate(kilonewtons, "k") == Approx(estimate(newtons, "k")).epsilon(1e-9));
  CHECK(kilonewtons.statistics.standard_error.at(0) ==
        Approx(newtons.statistics.standard_error.at(0)).epsilon(1e-6));
}

TEST_CASE("a fit gives the same bits again, whatever the number of threads") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  folder.write("rig2.csv", SliderRig{.noise = 0.3, .seed = 9}.data());
  const Fit fit = sound_fit(
      folder, with(kSliderFit, "  vary:",
                   "    - {case: slider.yaml, data: rig2.csv, time: t, compare: {= abs(CSF1): F}}\n"
                   "  bootstrap: 5\n"
                   "  multistart: 3\n"
                   "  vary:"));
  const auto bytes = [&](unsigned threads) {
    Calibration found = calibrated(fit, threads);
    found.seconds = 0.0;
    return calibration_json(fit, found).dump(0);
  };
  const std::string first = bytes(1);
  CHECK(bytes(1) == first);
  CHECK(bytes(2) == first);
  CHECK(bytes(7) == first);
}

TEST_CASE("a fit in which nothing changes anything is refused") {
  const TemporaryFolder folder;
  write_rig(folder);
  // It sticks as long as the data last, with a tenth of mu as well.
  folder.write("rig.csv", "t,F\n0.05,6\n0.1,12\n0.15,18\n");
  folder.write("slider.yaml", with(SliderRig::case_text(), "mu: 0.1", "mu: 500"));
  const Calibration found = calibrated(
      folder,
      with(kSliderFit, "{mu: {bounds: [0, 2]}, k: {bounds: [1, 1.0e+5], scale: log}}", "{mu: {}}"));
  CHECK_FALSE(found.fit.converged);
  CHECK(found.fit.stop == fit::StopReason::kZeroGradient);
  CHECK(found.unknowns.at(0).identifiability == Identifiability::kNeverVisited);
  CHECK(estimate(found, "mu") == 500.0);
}

TEST_CASE("what only one of two unknowns is seen of is told") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("rig.csv", "t,F\n0.05,6\n0.1,12\n0.15,18\n");
  folder.write("slider.yaml", with(SliderRig::case_text(), "mu: 0.1", "mu: 500"));
  const Calibration found =
      calibrated(folder, with(kSliderFit, "mu: {bounds: [0, 2]}", "mu: {bounds: [0, 900]}"));
  CHECK(found.fit.converged);
  CHECK(estimate(found, "k") == Approx(120.0).epsilon(1e-9));
  CHECK(estimate(found, "mu") == 500.0);
  CHECK(found.unknowns.at(0).identifiability == Identifiability::kNeverVisited);
  CHECK(found.unknowns.at(1).identifiability == Identifiability::kGood);
}

TEST_CASE("a limit that the data never reach is no convergence if it is seen elsewhere") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("rig.csv", "t,F\n0.05,6\n0.1,12\n0.15,18\n");
  folder.write("slider.yaml", with(SliderRig::case_text(), "mu: 0.1", "mu: 5"));
  const Calibration found =
      calibrated(folder, with(kSliderFit, "mu: {bounds: [0, 2]}", "mu: {bounds: [0, 9]}"));
  CHECK(found.fit.stop == fit::StopReason::kSilent);
  CHECK_FALSE(found.fit.converged);
  CHECK(estimate(found, "k") == Approx(120.0).epsilon(1e-9));
  CHECK(found.unknowns.at(0).identifiability == Identifiability::kWeak);
  CHECK(found.unknowns.at(0).why.find("multistart: 8") != std::string::npos);
}

namespace {

/// mu over the slip rate; the run slips at 0.5, 1 and 2 mm/s only.
const std::string kTablePad =
    "slipbench: 1\n"
    "units: {length: mm, force: N, time: s}\n"
    "connector: {type: SLOT}\n"
    "friction:\n"
    "  - name: pad\n"
    "    predefined: {}\n"
    "    coefficient:\n"
    "      columns: [mu, slip_rate]\n"
    "      rows: [[0.2, 0], [0.2, 1], [0.2, 2.5], [0.2, 4], [0.2, 5]]\n"
    "    stick: {stiffness: 1.0e+4}\n"
    "history:\n"
    "  - {step: a, duration: 1, increments: 10, force: {f2: 100}, motion: {CP1: {to: 0.5}}}\n"
    "  - {step: b, duration: 1, increments: 10, motion: {CP1: {to: 1.5}}}\n"
    "  - {step: c, duration: 1, increments: 10, motion: {CP1: {to: 3.5}}}\n";
const std::string kTableFit =
    "slipbench: 1\n"
    "calibrate:\n"
    "  experiments: [{case: pad.yaml, data: pad.csv, time: t, compare: {CSF1: F}}]\n"
    "  tables: {pad.coefficient: {free: mu}}\n";
/// 0.34 - 0.04 v.
const std::string kTableData = "t,F\n0.7,32\n1,32\n1.7,30\n2,30\n2.7,26\n3,26\n";

}  // namespace

TEST_CASE("ordinates that no point visits keep their start and are named") {
  const TemporaryFolder folder;
  folder.write("pad.yaml", kTablePad);
  folder.write("pad.csv", kTableData);
  const Calibration found = calibrated(folder, kTableFit);
  CHECK(found.fit.converged);
  REQUIRE(found.unknowns.size() == 5);
  CHECK(found.unknowns[1].name == "pad.coefficient[1].mu");
  // Steady slip: the force is mu N but for rounding of the rate.
  CHECK(found.fit.x[0] == Approx(0.34).epsilon(1e-9));
  CHECK(found.fit.x[1] == Approx(0.30).epsilon(1e-9));
  CHECK(found.fit.x[2] == Approx(0.24).epsilon(1e-9));
  for (const std::size_t never : {std::size_t{3}, std::size_t{4}}) {
    CAPTURE(never);
    CHECK(found.fit.x[never] == 0.2);
    CHECK(found.unknowns[never].identifiability == Identifiability::kNeverVisited);
  }
  REQUIRE(found.tables.size() == 1);
  const FittedTable& table = found.tables[0];
  CHECK(table.columns == std::vector<std::string>{"slip_rate"});
  CHECK(table.points.at(4) == std::vector<double>{5.0});
  REQUIRE(table.cells.size() == 4);
  CHECK(table.cells[0].visits > 0);
  CHECK(table.cells[3].visits == 0);
  CHECK(says(found.notes, "never visited"));
}

TEST_CASE("smoothness carries a straight line on to where nothing was measured") {
  const TemporaryFolder folder;
  folder.write("pad.yaml", kTablePad);
  folder.write("pad.csv", kTableData);
  const Calibration found =
      calibrated(folder, with(kTableFit, "free: mu", "free: mu, smoothness: 1.0e-6"));
  CHECK(found.fit.converged);
  CHECK(found.problem.rows == found.problem.data_rows + 3);
  // All second differences vanish on the line that the measured ordinates lie on.
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(found.fit.x[i] == Approx(0.34 - 0.04 * found.tables[0].points[i][0]).epsilon(1e-6));
  }
  CHECK(found.unknowns[3].why.find("smoothness") != std::string::npos);
}

TEST_CASE("what changes the history is fitted by whole runs and differences") {
  const TemporaryFolder folder;
  write_rig(folder, {.amplitude = 0.8});
  folder.write("slider.yaml", with(SliderRig::case_text(), "k: 360", "k: 120"));
  const Calibration found = calibrated(
      folder,
      with(kSliderFit, "k: {bounds: [1, 1.0e+5], scale: log}", "amplitude: {bounds: [0.3, 3]}"));
  CHECK(found.fit.converged);
  CHECK(found.derivatives.find("central differences for all 2 unknowns") != std::string::npos);
  CHECK(found.derivatives.find("the history depends on amplitude") != std::string::npos);
  // Differences of whole runs: the search ends where the cost is rounding.
  CHECK(estimate(found, "amplitude") == Approx(0.8).epsilon(1e-6));
  CHECK(estimate(found, "mu") == Approx(0.3).epsilon(1e-6));
}

TEST_CASE("replays and whole runs find the same") {
  const TemporaryFolder folder;
  write_rig(folder, {.noise = 0.3});
  const Calibration replayed = calibrated(folder, kSliderFit);
  // The same number, in words that are no friction force alone.
  const Calibration run = calibrated(folder, with(kSliderFit, "CSF1: F", "= CSF1 + 0*T: F"));
  CHECK(run.derivatives.find("central differences") != std::string::npos);
  // Both stop where another step is below 1e-10 of the unknowns; differences add their own 1e-9.
  CHECK(estimate(run, "mu") == Approx(estimate(replayed, "mu")).epsilon(1e-7));
  CHECK(estimate(run, "k") == Approx(estimate(replayed, "k")).epsilon(1e-7));
  CHECK(run.experiments[0].responses[0].before == replayed.experiments[0].responses[0].before);
}

TEST_CASE("a parameter of the quantity itself is fitted, too, exactly") {
  const TemporaryFolder folder;
  write_rig(folder);
  std::string data = "t,F\n";
  for (int i = 1; i <= 160; ++i) {
    const std::vector<double> position = [&] {
      std::vector<double> all;
      for (int j = 1; j <= i; ++j) all.push_back(triangle(0.05 * j));
      return all;
    }();
    data += fmt::format("{:.17g},{:.17g}\n", 0.05 * i,
                        -1.7 * slider_forces(position, 120.0, 30.0).back() + 12.5);
  }
  folder.write("rig.csv", data);
  folder.write("slider.yaml", with(SliderRig::case_text(), "N: 100", "N: 100, gain: -1, zero: 0"));
  const Calibration found = calibrated(
      folder, with(with(kSliderFit, "CSF1: F", "= gain*CSF1 + zero: F"), "mu: {bounds: [0, 2]}",
                   "gain: {bounds: [-5, 0]}, zero: {bounds: [-100, 100]}"));
  CHECK(found.derivatives == "exact derivatives of all 3 unknowns");
  CHECK(found.fit.converged);
  // mu is 0.1 of the case: the gain makes up for it, as k does.
  CHECK(estimate(found, "gain") == Approx(-5.1 + 0.0).margin(0.2));
  CHECK(estimate(found, "zero") == Approx(12.5).margin(0.5));
}

TEST_CASE("points before and behind the run are left out and told") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("rig.csv", SliderRig{}.data() + "8.5,1,1\n9,1,1\n");
  const Calibration found = calibrated(folder, kSliderFit);
  CHECK(found.experiments[0].responses[0].measured.size() == 160);
  CHECK(says(found.experiments[0].cleaning, "2 of 162 measured points lie outside of the run"));
  CHECK(found.experiments[0].rows_read == 162);
  CHECK(found.experiments[0].rows_used == 160);
  CHECK(estimate(found, "mu") == Approx(0.3).epsilon(1e-9));
}

TEST_CASE("data that have nothing in common with the run are refused with a reason") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("rig.csv", "t,F\n20,1\n21,2\n");
  const auto found = calibrate(sound_fit(folder, kSliderFit));
  REQUIRE_FALSE(found);
  CHECK(found.error().code == base::kExitBadInput);
  CHECK(found.error().message.find("nothing in common") != std::string::npos);
}

TEST_CASE("an unknown at its bound and a residual that is a trend are told") {
  const TemporaryFolder folder;
  write_rig(folder);
  const Calibration found = calibrated(folder, with(kSliderFit, "[0, 2]", "[0, 0.2]"));
  CHECK(says(found.notes, "mu ended at its upper bound 0.2"));
  CHECK(says(found.notes, "trend"));
  CHECK(estimate(found, "mu") == Approx(0.2).epsilon(1e-6));
  CHECK(found.unknowns.at(0).distance_to_upper < 1e-6);
}

}  // namespace slipbench::driver::calibrate
