// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/estimate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace slipbench::driver {
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
  return {rounded(value, decimals),
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

std::string stop_reason_text(const LeastSquaresFit& fit) {
  const std::string_view verdict = fit.converged ? "converged: " : "not converged: ";
  const std::string& sentence = fit.stop_sentence;
  return sentence.starts_with(verdict) ? sentence.substr(verdict.size()) : sentence;
}

EstimateText estimate_text(const Calibration& calibration, std::size_t u) {
  const FittedUnknown& unknown = calibration.unknowns[u];
  const FitStatistics& statistics = calibration.statistics;
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
    text.remark = holds(calibration.fit.frozen) || calibration.fit.frozen.empty()
                      ? "never visited, kept"
                      : "never visited, smoothed";
  } else if (unknown.identifiability == Identifiability::kWeak) {
    text.remark += text.remark.empty() ? "weak" : ", weak";
  }
  return text;
}

}  // namespace slipbench::driver
