// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/simplex_polish.hpp"

#include <gsl/gsl_multimin.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace slipbench::driver::fit {
namespace {

struct FreeSimplex {
  void operator()(gsl_multimin_fminimizer* simplex) const { gsl_multimin_fminimizer_free(simplex); }
};

struct Context {
  Objective* objective;
  std::vector<double> z;
  SearchPoint trial;
  void set(const gsl_vector* free) {
    for (std::size_t c = 0; c < free->size; ++c) {
      z[objective->free()[c]] = gsl_vector_get(free, c);
    }
  }
};

double cost(const gsl_vector* free, void* context) {
  constexpr double kHuge = 1e300;
  auto& self = *static_cast<Context*>(context);
  self.set(free);
  return self.objective->cost(self.z, self.trial) ? self.trial.cost : kHuge;
}

}  // namespace

bool simplex_polish(Objective& objective, SearchPoint& point) {
  constexpr std::size_t kMostUnknowns = 8;
  const std::size_t n = objective.free().size();
  if (n == 0 || n > kMostUnknowns) return false;
  std::vector<double> start(n);
  std::vector<double> edge(n);
  const Linearisation linear = objective.linearise(point);
  for (std::size_t c = 0; c < n; ++c) {
    const double z = point.z[objective.free()[c]];
    start[c] = z;
    const double size = std::max(std::abs(z), 1e-3);
    edge[c] =
        std::clamp(std::abs(linear.step(static_cast<Eigen::Index>(c))), 1e-4 * size, 1e-1 * size);
  }
  Context context{&objective, point.z, {}};
  gsl_multimin_function function{cost, n, &context};
  const gsl_vector_const_view from = gsl_vector_const_view_array(start.data(), n);
  const gsl_vector_const_view edges = gsl_vector_const_view_array(edge.data(), n);
  const std::unique_ptr<gsl_multimin_fminimizer, FreeSimplex> simplex(
      gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n));
  if (!simplex || gsl_multimin_fminimizer_set(simplex.get(), &function, &from.vector,
                                              &edges.vector) != GSL_SUCCESS) {
    return false;
  }
  const double first_size = gsl_multimin_fminimizer_size(simplex.get());
  for (std::size_t i = 0; i < 50 * n; ++i) {
    if (gsl_multimin_fminimizer_iterate(simplex.get()) != GSL_SUCCESS) break;
    if (gsl_multimin_fminimizer_size(simplex.get()) < 1e-7 * first_size) break;
  }
  if (!(gsl_multimin_fminimizer_minimum(simplex.get()) < point.cost * (1.0 - kCostNoise)))
    return false;
  context.set(gsl_multimin_fminimizer_x(simplex.get()));
  SearchPoint lower;
  if (!objective.derivatives(context.z, lower, false) || lower.cost >= point.cost) return false;
  point = std::move(lower);
  return true;
}

}  // namespace slipbench::driver::fit
