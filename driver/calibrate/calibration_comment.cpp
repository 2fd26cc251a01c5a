// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/calibration_comment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/calibrate/estimate_text.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::calibrate {
namespace {

std::string with_unit(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

std::string estimate(const Calibration& calibration, std::size_t u, double confidence) {
  const FittedUnknown& unknown = calibration.unknowns[u];
  const fit::FitStatistics& statistics = calibration.statistics;
  const double error =
      u < statistics.standard_error.size() ? statistics.standard_error[u] : std::nan("");
  std::string text =
      unknown.name + " = " + base::format_number(unknown.value) + with_unit(unknown.unit);
  if (unknown.identifiability == Identifiability::kNeverVisited) {
    return text + ": " + unknown.why;
  }
  if (std::isfinite(error)) {
    text += " +- " + value_and_error(unknown.value, error).error;
    text += fmt::format(" ({:.6g} % within {})", 100.0 * confidence,
                        interval_text(statistics.lower[u], statistics.upper[u], error));
  } else {
    text += " (no standard error)";
  }
  if (u < calibration.fit.at_lower.size() && calibration.fit.at_lower[u] != 0) {
    text += ", at its lower bound";
  }
  if (u < calibration.fit.at_upper.size() && calibration.fit.at_upper[u] != 0) {
    text += ", at its upper bound";
  }
  if (!unknown.held_by.empty()) text += ", held by " + unknown.held_by;
  text += ", start " + base::format_number(unknown.range.start);
  if (unknown.identifiability == Identifiability::kWeak) text += "; " + unknown.why;
  return text;
}

std::vector<std::string> lines_of(const Fit& fit, const FittedExperiment& fitted, bool own) {
  const ExperimentFit& experiment = fit.experiments[fitted.index];
  std::vector<std::string> lines;
  lines.push_back(fmt::format("  {}{}: {}, {} of {} rows, SHA-256 {}", experiment.name,
                              experiment.held_out ? " (hold-out)"
                              : own               ? ""
                                                  : " (another calibrated case of this fit)",
                              experiment.data_file, fitted.rows_used, fitted.rows_read,
                              fitted.data_hash));
  for (const FittedResponse& response : fitted.responses) {
    lines.push_back(fmt::format("    {}: RMSE {}{}, before {}; the data range over {}",
                                response.quantity, short_number(response.rmse_after),
                                with_unit(response.unit), short_number(response.rmse_before),
                                short_number(response.range)));
  }
  return lines;
}

}  // namespace

std::string calibration_comment(const Fit& fit, const Calibration& calibration,
                                std::span<const std::size_t> experiments,
                                std::span<const std::size_t> unknowns) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format("Calibrated by slipbench {}{}", results::program_version(),
                              fit.date ? ", " + *fit.date : std::string()));
  lines.push_back(
      fmt::format("fit: {}{}", fit.file_name(), fit.title.empty() ? "" : ", " + fit.title));
  const fit::LeastSquaresFit& found = calibration.fit;
  lines.push_back(fmt::format("{}: {}", found.converged ? "converged" : "NOT CONVERGED",
                              stop_reason_text(found)));
  lines.push_back(fmt::format(
      "cost {:.6g}, at the start {:.6g}; {} iterations; residual standard "
      "deviation {:.4g}",
      found.cost, found.start_cost, found.iterations, calibration.statistics.deviation));
  lines.push_back("measurements:");
  for (const FittedExperiment& fitted : calibration.experiments) {
    const bool own =
        std::find(experiments.begin(), experiments.end(), fitted.index) != experiments.end();
    for (std::string& line : lines_of(fit, fitted, own)) {
      lines.push_back(std::move(line));
    }
  }
  lines.push_back("estimates (+- standard error):");
  for (const std::size_t u : unknowns) {
    lines.push_back("  " + estimate(calibration, u, fit.confidence));
  }
  std::string text;
  for (const std::string& line : lines) text += "# " + base::printable(line) + "\n";
  return text;
}

}  // namespace slipbench::driver::calibrate
