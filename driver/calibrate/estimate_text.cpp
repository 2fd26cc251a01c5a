// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/estimate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace slipbench::driver::calibrate {
namespace {

constexpr int kMostDigits = 10;

/// Power of ten of the first digit once `value` is rounded to `digits` of them.
int exponent_of(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", std::abs(value), digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

bool is_known(double error) { return std::isfinite(error) && error > 0.0; }

/// \param decimals that are known; negative: the last known digit stands before the point
std::string rounded(double value, int decimals) {
  if (!std::isfinite(value)) return value > 0.0 ? "inf" : value < 0.0 ? "-inf" : "-";
  const double power = std::pow(10.0, -decimals);
  const int first = value == 0.0 ? 0 : exponent_of(value, kMostDigits);
  const bool plain = value == 0.0 || (first < 7 && (first >= -4 || decimals <= 6));
  if (plain) {
    const int most = kMostDigits - 1 - std::max(first, 0);
    if (decimals >= 0) return fmt::format("{:.{}f}", value, std::min(decimals, most));
    return fmt::format("{:.0f}", std::round(value / power) * power);
  }
  return fmt::format("{:.{}e}", value, std::clamp(first + decimals, 1, kMostDigits - 1));
}

int decimals_of(double error) { return 1 - exponent_of(error, 2); }

}  // namespace

ValueAndError value_and_error(double value, double error) {
  if (!is_known(error)) return {fmt::format("{:.6g}", value), "-"};
  const int decimals = decimals_of(error);
  const int first = value == 0.0 ? 0 : exponent_of(value, kMostDigits);
  const bool plain = decimals <= 8 && decimals >= -6 && first < 7;
  // A value far below its error is not 0 for that.
  const bool is_lost = value != 0.0 && std::abs(value) < std::pow(10.0, -decimals);
  return {rounded(value, is_lost ? decimals_of(value) : decimals),
          plain ? rounded(error, decimals) : fmt::format("{:.1e}", error)};
}

std::string interval_text(double lower, double upper, double error) {
  if (std::isnan(lower) || std::isnan(upper)) return "-";
  if (!is_known(error)) return fmt::format("{:.6g} .. {:.6g}", lower, upper);
  const int decimals = decimals_of(error);
  return rounded(lower, decimals) + " .. " + rounded(upper, decimals);
}

std::string short_number(double value) {
  const double size = std::abs(value);
  if (size < 1e4 || size >= 1e6) return fmt::format("{:.4g}", value);
  const double unit = size < 1e5 ? 10.0 : 100.0;
  return fmt::format("{:.0f}", std::round(value / unit) * unit);
}

std::string stop_reason_text(const fit::LeastSquaresFit& fit) {
  const std::string_view verdict = fit.converged ? "converged: " : "not converged: ";
  const std::string& sentence = fit.stop_sentence;
  return sentence.starts_with(verdict) ? sentence.substr(verdict.size()) : sentence;
}

EstimateText estimate_text(const Calibration& calibration, std::size_t u) {
  const FittedUnknown& unknown = calibration.unknowns[u];
  const fit::FitStatistics& statistics = calibration.statistics;
  const auto at = [&](const std::vector<double>& values) {
    return u < values.size() ? values[u] : std::nan("");
  };
  const auto holds = [&](const std::vector<char>& flags) {
    return u < flags.size() && flags[u] != 0;
  };
  const double error = at(statistics.standard_error);
  const ValueAndError digits = value_and_error(unknown.value, error);
  EstimateText text{digits.value, digits.error,
                    interval_text(at(statistics.lower), at(statistics.upper), error), ""};
  if (holds(calibration.fit.at_lower)) text.remark = "at its lower bound";
  if (holds(calibration.fit.at_upper)) text.remark = "at its upper bound";
  if (unknown.identifiability == Identifiability::kNeverVisited) {
    text.interval = "-";
    text.remark = "never visited, " +
                  (unknown.moved_by.empty() ? std::string("kept") : "moved by " + unknown.moved_by);
  } else if (unknown.identifiability == Identifiability::kWeak) {
    text.remark += text.remark.empty() ? "weak" : ", weak";
  }
  if (!unknown.held_by.empty()) {
    text.remark += (text.remark.empty() ? "held by " : ", held by ") + unknown.held_by;
  }
  return text;
}

bool has_value(const fit::SearchTrace& search) {
  return search.stop != fit::StopReason::kModelFailure && std::isfinite(search.cost);
}

bool found_the_minimum(const fit::LeastSquaresFit& fit, const fit::SearchTrace& search) {
  const double slack = kSameMinimum * std::abs(fit.cost) + 1e-15 * std::abs(fit.start_cost);
  return has_value(search) && search.cost <= fit.cost + slack;
}

std::string starts_text(const fit::LeastSquaresFit& fit) {
  if (fit.searches.size() < 2) return {};
  std::size_t same = 0;
  std::size_t failed = 0;
  std::optional<double> next;
  for (const fit::SearchTrace& search : fit.searches) {
    if (!has_value(search)) {
      ++failed;
    } else if (found_the_minimum(fit, search)) {
      ++same;
    } else {
      next = next ? std::min(*next, search.cost) : search.cost;
    }
  }
  std::string text = fmt::format("{} of {} starts found this minimum", same, fit.searches.size());
  if (next && fit.cost > 0.0) {
    text += fmt::format(", the next best has {} times its cost", short_number(*next / fit.cost));
  }
  if (failed > 0) text += fmt::format(", {} had no value", failed);
  return text;
}

std::string told_name(const Calibration& calibration, std::size_t u) {
  const std::string& name = calibration.unknowns[u].name;
  for (const FittedTable& table : calibration.tables) {
    if (u < table.first_unknown || u - table.first_unknown >= table.points.size()) continue;
    // "sleeve.coefficient[7].mu"
    const std::size_t bracket = name.rfind('[');
    const std::size_t end = name.rfind("].");
    if (bracket == std::string::npos || end == std::string::npos) return name;
    std::string text = name.substr(end + 2);
    // One of several tables is named.
    if (calibration.tables.size() > 1) text = name.substr(0, bracket) + "." + text;
    const std::vector<double>& point = table.points[u - table.first_unknown];
    for (std::size_t k = 0; k < std::min(point.size(), table.columns.size()); ++k) {
      const bool stated = k < table.units.size() && !table.units[k].empty();
      text += fmt::format("{}{} {:.6g}{}", k == 0 ? " at " : ", ", table.columns[k], point[k],
                          stated ? " " + table.units[k] : "");
    }
    return text;
  }
  return name;
}

std::string_view word_of(Identifiability identifiability) {
  switch (identifiability) {
    case Identifiability::kGood:
      return "good";
    case Identifiability::kWeak:
      return "weak";
    case Identifiability::kNeverVisited:
      break;
  }
  return "never_visited";
}

}  // namespace slipbench::driver::calibrate
