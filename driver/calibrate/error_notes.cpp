// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/error_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "driver/calibrate/outliers.hpp"
#include "driver/calibrate/residuals.hpp"

namespace slipbench::driver::calibrate {
namespace {

bool has_residuals(const Calibration& calibration) {
  const std::size_t data = calibration.problem.data_rows;
  return data > 0 && calibration.fit.residuals.size() >= data;
}

bool has_freedom(const Calibration& calibration) {
  return std::isfinite(calibration.statistics.deviation);
}

std::string_view what_was_asked(const Fit& fit) {
  if (fit.bootstrap > 0 && fit.profile) return "the bootstrap and the profiles";
  return fit.bootstrap > 0 ? "the bootstrap" : "the profiles";
}

void note_freedom(const Fit& fit, const Calibration& calibration, std::vector<std::string>& notes) {
  const bool asked = fit.bootstrap > 0 || fit.profile;
  if (!calibration.fit.converged) {
    if (!asked) return;
    notes.push_back(fmt::format(
        "{} left out: the fit did not converge; mend that first",
        std::string(what_was_asked(fit)) + (fit.bootstrap > 0 && !fit.profile ? " was" : " were")));
    return;
  }
  const std::size_t unknowns = calibration.statistics.unknowns;
  if (has_freedom(calibration) || !has_residuals(calibration) || unknowns == 0) return;
  notes.push_back(fmt::format(
      "{} compared points for {} unknowns: they can be met whatever the noise, and nothing can be "
      "told of the errors{}; compare more points, or vary less",
      calibration.statistics.data, unknowns,
      asked ? fmt::format(" ({} left out)", what_was_asked(fit)) : std::string()));
}

/// Residual of a response, as a typical size.
struct Left {
  std::string name;
  std::string unit;
  double size = 0.0;      ///< in the response's unit
  double residual = 0.0;  ///< as it enters the cost
};

/// \param robust what is left has outliers, which say nothing of its noise
std::optional<Left> left_of(const ExperimentFit& experiment, const ResponseFit& asked,
                            const FittedResponse& response, bool robust) {
  constexpr std::size_t kFewest = 10;
  // What is left of data without noise is rounding.
  const bool rounding = !(response.rmse_after > 1e-9 * response.range);
  const std::size_t count = response.measured.size();
  if (asked.sigma || rounding || count < kFewest || response.after.size() != count) return {};
  Left left{experiment.name + ", " + response.quantity, response.unit, response.rmse_after, 0.0};
  if (robust || !response.outliers.points.empty()) left.size = response.outliers.scale;
  left.residual = residual_factor(experiment, asked) * left.size;
  if (!(left.residual > 0.0)) return {};
  return left;
}

void note_noises(const Fit& fit, const Calibration& calibration, std::vector<std::string>& notes) {
  constexpr double kAlike = 3.0;
  const bool robust = fit.loss.kind != fit::Loss::Kind::kSquares;
  std::vector<Left> all;
  for (const FittedExperiment& fitted : calibration.experiments) {
    const ExperimentFit& experiment = fit.experiments[fitted.index];
    if (experiment.held_out) continue;
    for (std::size_t k = 0; k < std::min(fitted.responses.size(), experiment.responses.size());
         ++k) {
      auto left = left_of(experiment, experiment.responses[k], fitted.responses[k], robust);
      if (left) all.push_back(std::move(*left));
    }
  }
  if (all.empty()) return;
  const auto [least, most] = std::minmax_element(
      all.begin(), all.end(), [](const Left& a, const Left& b) { return a.residual < b.residual; });
  if (!(most->residual > kAlike * least->residual)) return;
  const auto size = [](const Left& left) {
    return fmt::format("{:.2g}{}{}", left.size, left.unit.empty() ? "" : " ", left.unit);
  };
  notes.push_back(fmt::format(
      "{} is met to {}, {} to {}, and neither has a sigma: all points count as if of one noise, "
      "and errors of unknowns that only one of them tells are wrong; give every response its "
      "sigma (about {} and {}, if that is noise)",
      least->name, size(*least), most->name, size(*most), size(*least), size(*most)));
}

void note_threshold(const Fit& fit, const Calibration& calibration,
                    std::vector<std::string>& notes) {
  constexpr double kFewest = 0.2;  // of the points within the threshold
  if (fit.loss.kind == fit::Loss::Kind::kSquares || !has_residuals(calibration)) return;
  std::vector<double> sizes(calibration.problem.data_rows);
  std::transform(calibration.fit.residuals.begin(),
                 calibration.fit.residuals.begin() + static_cast<std::ptrdiff_t>(sizes.size()),
                 sizes.begin(), [](double r) { return std::abs(r); });
  const double threshold = fit.loss.threshold;
  const auto within =
      std::count_if(sizes.begin(), sizes.end(), [&](double size) { return size <= threshold; });
  if (static_cast<double>(within) >= kFewest * static_cast<double>(sizes.size())) return;
  const std::size_t count = sizes.size();
  const double typical = median(std::move(sizes));
  notes.push_back(fmt::format(
      "the threshold {:.3g} of the robust loss is far below the noise (half of the residuals "
      "exceed {:.3g}; {} of {} are within it): errors are not to be trusted; raise it to about "
      "{:.2g}, or give sigma",
      threshold, typical, within, count, kUsualThreshold * kNormalOverMedian * typical));
}

void note_bootstrap(const Calibration& calibration, std::vector<std::string>& notes) {
  constexpr double kEnough = 0.9;
  const fit::Bootstrap& bootstrap = calibration.bootstrap;
  if (bootstrap.wanted <= 0 || !has_freedom(calibration)) return;
  if (bootstrap.done < kEnough * bootstrap.wanted) {
    notes.push_back(fmt::format(
        "bootstrap: {} of {} refits did not converge and are left out: its errors are those of "
        "the others, and likely too small",
        bootstrap.wanted - bootstrap.done, bootstrap.wanted));
  }
  if (bootstrap.few_blocks) {
    notes.push_back(fmt::format(
        "bootstrap: what is left hangs together over many points, so that few blocks (of {}) can "
        "be drawn: its errors are likely too small; mend the trend, or measure longer",
        bootstrap.block));
  }
}

void note_profiles(const Calibration& calibration, std::vector<std::string>& notes) {
  for (const fit::LikelihoodProfile& profile : calibration.profiles) {
    if (profile.unconverged == 0) continue;
    notes.push_back(fmt::format(
        "profile of {}: {} of {} refits of the other unknowns did not converge: its interval may "
        "be too narrow",
        calibration.unknowns[profile.unknown].name, profile.unconverged, profile.refits));
  }
}

}  // namespace

std::vector<std::string> error_notes(const Fit& fit, const Calibration& calibration) {
  std::vector<std::string> notes;
  note_freedom(fit, calibration, notes);
  note_noises(fit, calibration, notes);
  note_threshold(fit, calibration, notes);
  note_bootstrap(calibration, notes);
  note_profiles(calibration, notes);
  return notes;
}

}  // namespace slipbench::driver::calibrate
