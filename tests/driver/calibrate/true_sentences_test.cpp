// SPDX-License-Identifier: Apache-2.0
// Each sentence on an unknown, held against numbers that are found anew: by moving the unknown and
// asking the model.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "driver/calibrate/calibration_comment.hpp"
#include "driver/calibrate/calibration_json.hpp"
#include "driver/calibrate/estimate_text.hpp"
#include "driver/calibrate/fit/loss.hpp"
#include "driver/calibrate/fit_summary.hpp"
#include "driver/calibrate/report/fit_report.hpp"
#include "tests/driver/calibrate/fit_for_test.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::calibrate {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<double> residuals_at(const Calibration& calibration, const std::vector<double>& x) {
  std::vector<double> residuals(calibration.problem.rows);
  REQUIRE(calibration.problem.residuals(x, residuals));
  return residuals;
}

/// Returns whether some compared value changes when one unknown moves a little either way.
bool data_depend_on(const Calibration& calibration, std::size_t u) {
  const std::vector<double> here = residuals_at(calibration, calibration.fit.x);
  for (const double part : {-1e-3, 1e-3}) {
    std::vector<double> x = calibration.fit.x;
    x[u] += part * (x[u] == 0.0 ? 1.0 : x[u]);
    const std::vector<double> there = residuals_at(calibration, x);
    for (std::size_t i = 0; i < calibration.problem.data_rows; ++i) {
      if (std::abs(there[i] - here[i]) > 1e-9 * std::abs(here[i])) return true;
    }
  }
  return false;
}

/// The neighbour that an ordinate is equal to, in its block.
bool equals_a_neighbour(const Calibration& calibration, std::size_t u) {
  const double value = calibration.unknowns[u].value;
  const auto equal = [&](std::size_t v) {
    return std::abs(calibration.unknowns[v].value - value) <= 1e-9 * std::abs(value);
  };
  return (u > 0 && equal(u - 1)) || (u + 1 < calibration.unknowns.size() && equal(u + 1));
}

void check_unknown(const Fit& fit, const Calibration& calibration, std::size_t u) {
  const FittedUnknown& unknown = calibration.unknowns[u];
  const EstimateText row = estimate_text(calibration, u);
  const std::size_t all[] = {u};
  const std::string comment = calibration_comment(fit, calibration, {}, all);
  const std::string words = row.remark + " | " + unknown.why + " | " + comment;
  INFO(unknown.name << ": " << words);
  const double start = unknown.range.start;
  const bool never = has(row.remark, "never visited");
  CHECK(never == (unknown.identifiability == Identifiability::kNeverVisited));
  if (never) CHECK_FALSE(data_depend_on(calibration, u));
  if (row.remark.empty()) CHECK(data_depend_on(calibration, u));
  CHECK(has(row.remark, "kept") == (never && unknown.value == start));
  CHECK(has(comment, "kept at its start") == has(row.remark, "kept"));
  CHECK((has(row.remark, "moved by") && never) == (never && unknown.value != start));
  if (has(unknown.why, "moved from")) {
    const std::string move = fmt::format("moved from {:.6g} to {:.6g}", start, unknown.value);
    CHECK(has(unknown.why, move));
    CHECK(has(comment, move));
    CHECK(unknown.value != start);
  }
  if (has(words, "moved by `monotone") || has(words, "held by `monotone: ")) {
    CHECK(equals_a_neighbour(calibration, u));
  }
  const auto equals = [&](double bound) { return unknown.value == bound; };
  CHECK(has(words, "at its lower bound") == (!never && equals(unknown.range.lower)));
  CHECK(has(words, "at its upper bound") == (!never && equals(unknown.range.upper)));
}

/// A least cost is one that no unknown alone can lower, moved by a hundredth of its error.
void check_convergence(const Calibration& calibration) {
  // A shape that holds some keeps others from moving alone.
  const bool held = std::any_of(calibration.unknowns.begin(), calibration.unknowns.end(),
                                [](const FittedUnknown& one) { return !one.held_by.empty(); });
  if (!calibration.fit.converged || held) return;
  for (std::size_t u = 0; u < calibration.unknowns.size(); ++u) {
    const double error = calibration.statistics.standard_error[u];
    const FittedUnknown& unknown = calibration.unknowns[u];
    if (!std::isfinite(error)) continue;
    for (const double part : {-0.01, 0.01}) {
      std::vector<double> x = calibration.fit.x;
      x[u] += part * error;
      if (x[u] < unknown.range.lower || x[u] > unknown.range.upper) continue;
      INFO(unknown.name << " moved by " << part << " errors");
      const double cost = fit::total_cost(calibration.problem, residuals_at(calibration, x));
      CHECK(cost >= calibration.fit.cost * (1.0 - 1e-5) - 1e-20 * calibration.fit.start_cost);
    }
  }
}

Calibration check_sentences(const Fit& fit) {
  Calibration found = calibrated(fit);
  CAPTURE(fit.file);
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) check_unknown(fit, found, u);
  check_convergence(found);
  // Summary, JSON and page have the words of the unknowns and all notes.
  const std::string json = calibration_json(fit, found).dump();
  const std::string document = fit_document(fit, found);
  for (const std::string& note : found.notes) {
    CHECK(has(json, note));
    CHECK(has(document, note));
  }
  for (const FittedUnknown& unknown : found.unknowns) {
    CHECK(has(json, unknown.why));
    CHECK(has(document, unknown.why));
  }
  return found;
}

/// A pad whose coefficient falls with the slip rate to 20 mm/s; nothing is faster than 26 mm/s.
class Pad : public TemporaryFolder {
 public:
  Pad() {
    write("pad.yaml",
          "slipbench: 1\n"
          "units: {length: mm, force: N, time: s}\n"
          "connector: {type: SLOT}\n"
          "friction:\n"
          "  - name: pad\n"
          "    component: 1\n"
          "    internal_contact_force: 100\n"
          "    coefficient: {columns: [mu, slip_rate],\n"
          "                  rows: [[0.2, 0], [0.2, 10], [0.2, 20], [0.2, 40], [0.2, 80]]}\n"
          "    stick: {elastic_slip: 1.0e-3}\n"
          "history:\n"
          "  - {step: go, duration: 1, increments: 200,\n"
          "     motion: {CP1: {sine: {amplitude: 4, period: 1}}}}\n");
    std::string data = "t,F\n";
    double before = 0.0;
    for (int row = 1; row <= 200; ++row) {
      const double position = 4.0 * std::sin(2.0 * std::numbers::pi * row / 200.0);
      const double rate = 200.0 * std::abs(position - before);
      const double mu = rate < 10.0 ? 0.25 - 0.003 * rate : 0.22 - 0.005 * (rate - 10.0);
      const double force = 100.0 * std::max(mu, 0.17) * (position > before ? 1.0 : -1.0);
      data += fmt::format("{},{:.17g}\n", row / 200.0, force + 0.2 * (row % 3 - 1));
      before = position;
    }
    write("rig.csv", data);
  }

  Calibration checked(const std::string& how) const {
    return check_sentences(
        sound_fit(*this,
                  "slipbench: 1\ncalibrate:\n"
                  "  experiments: [{case: pad.yaml, data: rig.csv, time: t, compare: {CSF1: F}}]\n"
                  "  tables: {pad.coefficient: {" +
                      how + "}}\n"));
  }
};

}  // namespace

TEST_CASE("what the fits that are shipped say of their unknowns is so") {
  int fits = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_dir() + "/cases/calibration")) {
    if (!entry.path().stem().string().ends_with("_fit")) continue;
    ++fits;
    const ReadFit read = read_fit(entry.path().string());
    REQUIRE(read.value);
    const Calibration found = check_sentences(*read.value);
    CHECK(found.fit.converged);
    for (const std::string& note : found.notes) CHECK_FALSE(has(note, "outlier"));
  }
  CHECK(fits == 5);
}

TEST_CASE("an ordinate without data that a shape or smoothness moves is told so, everywhere") {
  const Pad pad;
  const std::string unseen = "its cells were never visited: ";
  const auto last = [](const Calibration& found) { return found.unknowns[4]; };
  CHECK(last(pad.checked("bounds: [0, 1]")).why == unseen + "kept at its start");
  const Calibration falling = pad.checked("monotone: decreasing");
  CHECK(last(falling).moved_by == "`monotone: decreasing`");
  CHECK(last(falling).why.starts_with(unseen + "moved from 0.2 to 0.1"));
  CHECK(estimate_text(falling, 4).remark == "never visited, moved by `monotone: decreasing`");
  CHECK(has(falling.notes.back(), "1 of 5 ordinates moved by `monotone: decreasing`"));
  CHECK(last(pad.checked("smoothness: 1.0e-3")).moved_by == "`smoothness`");
  CHECK(last(pad.checked("monotone: decreasing, smoothness: 1.0e-3")).moved_by ==
        "`smoothness` within `monotone: decreasing`");
  pad.checked("shape: convex");
}

TEST_CASE("ordinates that the data would have of another shape are told as held by it") {
  const Pad pad;
  const Calibration found = pad.checked("monotone: increasing");
  CHECK(estimate_text(found, 1).remark == "held by `monotone: increasing`");
  CHECK(has(found.notes.back(),
            "table 'pad.coefficient': `monotone: increasing` leaves 4 of 5 "
            "ordinates no room"));
  const Calibration bent = pad.checked("shape: convex");
  CHECK(estimate_text(bent, 1).remark == "held by `shape: convex`");
  // Nothing is held where the data have the shape.
  for (const std::string& note : pad.checked("bounds: [0, 1]").notes) {
    CHECK_FALSE(has(note, "no room"));
  }
}

TEST_CASE("bounds, silent and lost unknowns are told as they are") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", SliderRig::case_text());
  folder.write("rig.csv", SliderRig{.noise = 0.1}.data());
  const auto fit = [](const std::string& vary) {
    return "slipbench: 1\ncalibrate:\n"
           "  experiments: [{case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: F}}]\n"
           "  vary: {" +
           vary + "}\n";
  };
  for (const char* vary :
       {"mu: {bounds: [0, 0.2]}", "mu: {bounds: [0.35, 2], start: 0.4}", "mu: {bounds: [0, 2]}",
        "mu: {bounds: [0, 2]}, N: {bounds: [1, 1000]}", "k: {bounds: [1, 100], start: 50}",
        "mu: {bounds: [0, 2]}, amplitude: {bounds: [0.5, 2]}"}) {
    CAPTURE(vary);
    check_sentences(sound_fit(folder, fit(vary)));
  }
  // Nothing slips in what is compared: mu is in no point.
  folder.write("rig.csv", "t,F\n0.05,6\n0.1,12\n0.15,18\n");
  const Calibration stuck = check_sentences(
      sound_fit(folder, fit("mu: {bounds: [0, 9], start: 5}, k: {bounds: [1, 1.0e+5]}")));
  CHECK(stuck.unknowns[1].value == Approx(120.0));
}

}  // namespace slipbench::driver::calibrate
