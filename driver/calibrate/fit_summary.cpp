// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/calibrate/estimate_text.hpp"
#include "driver/calibrate/identifiability.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::calibrate {
namespace {

constexpr std::size_t kWidth = 80;

/// Columns under each other; the last one is not padded.
class TextTable {
 public:
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  [[nodiscard]] std::string text(std::size_t indent) const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()), 0);
      for (std::size_t c = 0; c < row.size(); ++c) {
        widths[c] = std::max(widths[c], base::count_code_points(row[c]));
      }
    }
    std::string text;
    for (const auto& row : rows_) {
      std::string line(indent, ' ');
      for (std::size_t c = 0; c < row.size(); ++c) {
        line += row[c] + std::string(widths[c] - base::count_code_points(row[c]), ' ');
        // An empty column takes no room.
        if (widths[c] > 0) line += "  ";
      }
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + "\n";
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// A sentence over as many lines as it needs, the later ones indented by two more.
std::string wrapped(const std::string& sentence, std::size_t indent) {
  std::string text;
  std::string line(indent, ' ');
  bool empty = true;
  std::string_view rest = sentence;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!empty && base::count_code_points(line) + 1 + base::count_code_points(word) > kWidth) {
      text += line + "\n";
      line.assign(indent + 2, ' ');
      empty = true;
    }
    if (!empty) line += ' ';
    line += word;
    empty = false;
  }
  return text + line + "\n";
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return base::printable(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
}

/// Root mean square over all compared points of one quantity.
struct Error {
  std::string quantity;
  std::string unit;
  double squares = 0.0;
  std::size_t points = 0;
  double held_out_squares = 0.0;
  std::size_t held_out_points = 0;
  double range = 0.0;
};

std::vector<Error> errors_of(const Fit& fit, const Calibration& calibration) {
  std::vector<Error> errors;
  for (const FittedExperiment& fitted : calibration.experiments) {
    const bool held_out = fit.experiments[fitted.index].held_out;
    for (const FittedResponse& response : fitted.responses) {
      auto found = std::find_if(errors.begin(), errors.end(), [&](const Error& error) {
        return error.quantity == response.quantity && error.unit == response.unit;
      });
      if (found == errors.end()) {
        found = errors.insert(errors.end(), Error{response.quantity, response.unit});
      }
      const std::size_t points = response.measured.size();
      const double squares =
          static_cast<double>(points) * response.rmse_after * response.rmse_after;
      (held_out ? found->held_out_squares : found->squares) += squares;
      (held_out ? found->held_out_points : found->points) += points;
      if (!held_out) found->range = std::max(found->range, response.range);
    }
  }
  return errors;
}

double root_mean(double squares, std::size_t points) {
  return std::sqrt(squares / static_cast<double>(points));
}

/// "RMSE of CSF1 71 N of 6.2e+03 N (hold-out 74 N)".
std::string error_line(const Error& error) {
  const std::string unit = error.unit.empty() ? "" : " " + error.unit;
  std::string text = "RMSE of " + error.quantity;
  if (error.points > 0) {
    text += fmt::format(" {}{} of {}{}", short_number(root_mean(error.squares, error.points)), unit,
                        short_number(error.range), unit);
  }
  if (error.held_out_points > 0) {
    text +=
        fmt::format(" (hold-out {}{})",
                    short_number(root_mean(error.held_out_squares, error.held_out_points)), unit);
  }
  return base::printable(text);
}

std::string head(const Fit& fit, const Calibration& calibration) {
  std::size_t held_out = 0;
  for (const ExperimentFit& experiment : fit.experiments) held_out += experiment.held_out ? 1 : 0;
  const std::size_t fitted = fit.experiments.size() - held_out;
  std::size_t points = 0;
  for (const FittedExperiment& experiment : calibration.experiments) {
    const ExperimentFit& asked = fit.experiments[experiment.index];
    if (asked.held_out) continue;
    for (std::size_t r = 0; r < experiment.responses.size(); ++r) {
      // Those without a weight are scored only.
      const bool counts = r >= asked.responses.size() || asked.responses[r].weight > 0.0;
      if (counts) points += experiment.responses[r].measured.size();
    }
  }
  std::string text = fmt::format(
      "{}: {}, {} of {}{}, {}\n", base::printable(std::filesystem::path(fit.file).stem().string()),
      counted(calibration.unknowns.size(), "unknown"), counted(points, "point"),
      counted(fitted, "experiment"),
      held_out > 0 ? fmt::format(", {} held out", held_out) : std::string(),
      terminal::elapsed_text(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
          std::chrono::duration<double>(calibration.seconds))));
  const fit::LeastSquaresFit& found = calibration.fit;
  const std::string after =
      counted(static_cast<std::size_t>(std::max(0, found.iterations)), "iteration");
  text += wrapped(fmt::format("{} after {}: {}", found.converged ? "converged" : "NOT CONVERGED",
                              after, stop_reason_text(found)),
                  2);
  for (const Error& error : errors_of(fit, calibration)) text += wrapped(error_line(error), 2);
  return text;
}

/// Returns how the searches from several starts ended; empty for one start.
std::string starts_line(const Calibration& calibration) {
  const std::string text = starts_text(calibration.fit);
  return text.empty() ? text : wrapped(text, 2);
}

std::string parameters_table(const Fit& fit, const Calibration& calibration) {
  const std::size_t count = std::min(fit.vary.size(), calibration.unknowns.size());
  if (count == 0) return {};
  TextTable table;
  table.add({"parameter", "estimate", "+-",
             fmt::format("{:.6g} % interval", 100.0 * fit.confidence), "start", ""});
  for (std::size_t u = 0; u < count; ++u) {
    const EstimateText estimate = estimate_text(calibration, u);
    const FittedUnknown& unknown = calibration.unknowns[u];
    table.add({with_unit(unknown.name, unknown.unit), estimate.value, estimate.error,
               estimate.interval, short_number(unknown.range.start), estimate.remark});
  }
  return "\n" + table.text(2);
}

std::string bootstrap_lines(const Fit& fit, const Calibration& calibration) {
  const fit::Bootstrap& bootstrap = calibration.bootstrap;
  if (bootstrap.done == 0) return {};
  TextTable table;
  table.add({"bootstrap", "+-", fmt::format("{:.6g} % interval", 100.0 * fit.confidence)});
  for (std::size_t u = 0; u < bootstrap.standard_error.size(); ++u) {
    const double error = bootstrap.standard_error[u];
    if (calibration.unknowns[u].identifiability == Identifiability::kNeverVisited) continue;
    table.add({base::printable(told_name(calibration, u)),
               value_and_error(calibration.unknowns[u].value, error).error,
               interval_text(bootstrap.lower[u], bootstrap.upper[u], error)});
  }
  return "\n" + table.text(2) +
         wrapped(fmt::format("({} of {} resamplings, in blocks of {})", bootstrap.done,
                             bootstrap.wanted, counted(bootstrap.block, "point")),
                 2);
}

std::string profile_lines(const Calibration& calibration) {
  if (calibration.profiles.empty()) return {};
  TextTable table;
  table.add({"profile likelihood", "interval", ""});
  for (const fit::LikelihoodProfile& profile : calibration.profiles) {
    const double error = profile.unknown < calibration.statistics.standard_error.size()
                             ? calibration.statistics.standard_error[profile.unknown]
                             : std::nan("");
    std::string open;
    if (profile.open_below && profile.open_above) {
      open = "open at both ends: the data do not bound it";
    } else if (profile.open_below) {
      open = "open below: the data do not bound it there";
    } else if (profile.open_above) {
      open = "open above: the data do not bound it there";
    }
    table.add({base::printable(calibration.unknowns[profile.unknown].name),
               interval_text(profile.lower, profile.upper, error), open});
  }
  return "\n" + table.text(2);
}

/// The strongest correlation, where none is so strong that a note tells it.
std::string correlation_line(const Calibration& calibration) {
  const std::size_t n = calibration.unknowns.size();
  const std::vector<double>& correlation = calibration.statistics.correlation;
  if (n < 2 || correlation.size() != n * n) return {};
  std::pair<std::size_t, std::size_t> pair{0, 0};
  double largest = 0.0;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      const double rho = correlation[a * n + b];
      if (!(std::abs(rho) > std::abs(largest))) continue;
      largest = rho;
      pair = {a, b};
    }
  }
  if (largest == 0.0 || std::abs(largest) >= kStrongCorrelation) return {};
  return wrapped(fmt::format("strongest correlation: {} and {} {:.2f}",
                             base::printable(told_name(calibration, pair.first)),
                             base::printable(told_name(calibration, pair.second)), largest),
                 2);
}

std::string ordinates_table(const Fit& fit, const Calibration& calibration,
                            const FittedTable& fitted) {
  constexpr std::size_t kMostRows = 40;
  const VariedTable& varied = fit.tables[fitted.index];
  TextTable table;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < fitted.columns.size(); ++k) {
    names.push_back(
        with_unit(fitted.columns[k], k < fitted.units.size() ? fitted.units[k] : std::string()));
  }
  const std::string unit =
      fitted.count > 0 ? calibration.unknowns[fitted.first_unknown].unit : std::string();
  names.push_back(with_unit(varied.free, unit));
  names.insert(names.end(), {"+-", "start", ""});
  table.add(std::move(names));
  for (std::size_t r = 0; r < std::min(fitted.count, kMostRows); ++r) {
    const std::size_t u = fitted.first_unknown + r;
    const EstimateText estimate = estimate_text(calibration, u);
    std::vector<std::string> cells;
    for (const double x : fitted.points[r]) cells.push_back(short_number(x));
    cells.insert(cells.end(), {estimate.value, estimate.error,
                               short_number(calibration.unknowns[u].range.start), estimate.remark});
    table.add(std::move(cells));
  }
  std::string text = "\n  table " + base::printable(varied.name) + "\n" + table.text(2);
  if (fitted.count > kMostRows) {
    text += fmt::format("  {} more rows in the JSON file and the page\n", fitted.count - kMostRows);
  }
  return text;
}

/// The size of what is left without regard to outliers; blank if it is not known.
std::string robust_text(const FittedResponse& response) {
  const double scale = response.outliers.scale;
  return std::isfinite(scale) ? short_number(scale) : std::string();
}

std::string experiments_table(const Fit& fit, const Calibration& calibration) {
  if (calibration.experiments.empty()) return {};
  TextTable table;
  table.add({"experiment", "", "quantity", "points", "before", "RMSE", "robust", "range", ""});
  for (const FittedExperiment& fitted : calibration.experiments) {
    const ExperimentFit& experiment = fit.experiments[fitted.index];
    for (std::size_t r = 0; r < fitted.responses.size(); ++r) {
      const FittedResponse& response = fitted.responses[r];
      const double part = response.range > 0.0 ? response.rmse_after / response.range : 0.0;
      table.add({r == 0 ? base::printable(experiment.name) : "",
                 r == 0 && experiment.held_out ? "hold-out" : "",
                 with_unit(response.quantity, response.unit),
                 fmt::format("{}", response.measured.size()), short_number(response.rmse_before),
                 short_number(response.rmse_after), robust_text(response),
                 short_number(response.range),
                 response.range > 0.0 ? fmt::format("{:.2g} %", 100.0 * part) : ""});
    }
  }
  std::string text = "\n" + table.text(2);
  for (const FittedExperiment& fitted : calibration.experiments) {
    for (const std::string& sentence : fitted.cleaning) {
      text += wrapped(base::printable(fit.experiments[fitted.index].name + ": " + sentence), 2);
    }
  }
  return text;
}

}  // namespace

std::string fit_summary(const Fit& fit, const Calibration& calibration) {
  std::string text = head(fit, calibration);
  text += starts_line(calibration);
  text += parameters_table(fit, calibration);
  for (const FittedTable& table : calibration.tables) {
    text += ordinates_table(fit, calibration, table);
  }
  text += correlation_line(calibration);
  text += bootstrap_lines(fit, calibration);
  text += profile_lines(calibration);
  text += experiments_table(fit, calibration);
  if (!calibration.derivatives.empty()) {
    text += wrapped("derivatives: " + base::printable(calibration.derivatives), 2);
  }
  for (const std::string& note : calibration.notes)
    text += wrapped("note: " + base::printable(note), 2);
  return text;
}

}  // namespace slipbench::driver::calibrate
