// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/base/files/file_mark.hpp"
#include "driver/base/text/json.hpp"
#include "driver/calibrate/calibration.hpp"
#include "driver/calibrate/fit.hpp"

namespace slipbench::driver::calibrate {

/// Everything a calibration found, for other programs; the same fit gives the same bytes (no time
/// taken, no machine). Values are in the units of the cases, which stand beside them; what is not
/// known, or infinite, is null. The keys are stable:
///   provenance   program, version, fit, title, date; experiments: name, case, data, sha256
///   result       converged, stop (a word), sentence, loss, start_cost, cost, iterations,
///                residual_evaluations, derivative_evaluations, gradient, polished, derivatives (a
///                sentence); searches: start, end, start_cost, cost, iterations, stop,
///                same_minimum; costs are null of a start without a value
///   statistics   points, unknowns (that are known), deviation, confidence, condition, bootstrap
///   unknowns     name, unit, value, standard_error, interval, start, bounds, scale, at_bound,
///                distance_to_lower, distance_to_upper (parts of the bounds' range),
///                identifiability (good, weak, never_visited), why, points (that depend on it),
///                frozen, bootstrap
///   correlation, covariance   rows in the order of `unknowns`
///   tables       name, free, independents, units, smoothness; rows: unknown (index), at, value,
///                standard_error; cells: cell, increments, visited (false, too, where increments
///                only ran along its edge, at exactly a knot)
///   experiments  name, held_out, rows_read, rows_used, cleaning, weight, share_of_cost; responses:
///                quantity, unit, over, points, rmse_before, rmse_after, range, mean_error,
///                autocorrelation, points_told, and that many values of time, abscissa, measured,
///                before, after: all, or of more than 10000 every n-th and the last
///   profiles     unknown, value, cost, threshold, interval, open_below, open_above
///   notes        sentences
base::json::Value calibration_json(const Fit& fit, const Calibration& calibration);

/// The mark of the file of calibration_json.
base::FileMark calibration_mark(const Fit& fit);

}  // namespace slipbench::driver::calibrate
