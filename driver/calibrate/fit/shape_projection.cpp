// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/shape_projection.hpp"

#include <cstddef>

namespace slipbench::driver::fit {

std::vector<double> nearest_ascending(std::span<const double> values) {
  struct Pool {
    double mean;
    std::size_t count;
  };
  std::vector<Pool> pools;
  for (const double value : values) {
    pools.push_back({value, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean > pools.back().mean) {
      const Pool last = pools.back();
      pools.pop_back();
      Pool& pool = pools.back();
      const double sum =
          pool.mean * static_cast<double>(pool.count) + last.mean * static_cast<double>(last.count);
      pool.count += last.count;
      pool.mean = sum / static_cast<double>(pool.count);
    }
  }
  std::vector<double> ascending;
  ascending.reserve(values.size());
  for (const Pool& pool : pools) ascending.insert(ascending.end(), pool.count, pool.mean);
  return ascending;
}

std::vector<double> nearby_convex(std::span<const double> abscissa,
                                  std::span<const double> values) {
  const std::size_t n = values.size();
  std::vector<std::size_t> hull;
  const auto slope = [&](std::size_t a, std::size_t b) {
    return (values[b] - values[a]) / (abscissa[b] - abscissa[a]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    while (hull.size() > 1 && slope(hull[hull.size() - 2], hull.back()) > slope(hull.back(), i)) {
      hull.pop_back();
    }
    hull.push_back(i);
  }
  std::vector<double> convex(values.begin(), values.end());
  double difference = 0.0;
  for (std::size_t h = 0; h + 1 < hull.size(); ++h) {
    for (std::size_t i = hull[h] + 1; i < hull[h + 1]; ++i) {
      convex[i] = values[hull[h]] + slope(hull[h], hull[h + 1]) * (abscissa[i] - abscissa[hull[h]]);
      difference += values[i] - convex[i];
    }
  }
  for (double& value : convex) value += difference / static_cast<double>(n);
  return convex;
}

}  // namespace slipbench::driver::fit
