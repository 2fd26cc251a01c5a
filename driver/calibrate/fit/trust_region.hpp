// SPDX-License-Identifier: Apache-2.0
// GSL's trust region (Levenberg-Marquardt) on the weighted residuals over the free coordinates.
#pragma once

#include <cstdint>

#include "driver/calibrate/fit/objective.hpp"

namespace slipbench::driver::fit {

/// By what the trust region measures the lengths of coordinates.
enum class TrustScaling : std::uint8_t {
  kMore,        ///< the longest column so far: invariant to units
  kLevenberg,   ///< the coordinates as they are
  kMarquardt,   ///< the present column
  kAccelerated  ///< as kMore, with geodesic acceleration (small problems; else as kMore)
};

struct TrustRegionOptions {
  TrustScaling scaling = TrustScaling::kMore;
  int most_iterations = 100;
  double least_gain = 1e-6;  ///< of an iteration, as a part of the cost
  int most_idle = 2;         ///< iterations in a row that gain less; then it ends
};

/// Runs from `point`, which has its derivatives, to where nothing more is gained; the weights of
/// the rows stay those of the start, so that the cost of a robust loss falls as well (the weighted
/// squares lie above it and touch it there).
///
/// Small problems go to gsl_multifit_nlinear, which factorises the Jacobian; those with many
/// entries to gsl_multilarge_nlinear, which gets J^T J accumulated here.
/// \param scratch memory for points that are tried
/// \return iterations that lowered the cost; `point` is the last one, with its derivatives
int trust_region(Objective& objective, SearchPoint& point, SearchPoint& scratch,
                 const TrustRegionOptions& options);

}  // namespace slipbench::driver::fit
