// SPDX-License-Identifier: Apache-2.0
#include "driver/report/drawn_coverage.hpp"

#include <algorithm>
#include <cstddef>

namespace slipbench::driver::report {
namespace {

/// Intervals of an axis that a picture can show: of a table of one independent, of two or more.
constexpr std::size_t kMostAlone = 240;
constexpr std::size_t kMostOfTwo = 48;

}  // namespace

ReportTable drawn_coverage(const results::TableCoverage& table, const std::string& definition) {
  ReportTable drawn;
  drawn.name = "friction '" + definition + "': " + table.what;
  drawn.increments = table.increments;
  drawn.outside = table.outside;
  const std::size_t most = table.axes.size() == 1 ? kMostAlone : kMostOfTwo;
  std::vector<std::size_t> together;  // neighbouring intervals that become one, for each axis
  for (const results::TableCoverage::Axis& axis : table.axes) {
    const std::size_t step = (axis.intervals() + most - 1) / most;
    together.push_back(step);
    drawn.coarser = drawn.coarser || step > 1;
    ReportTable::Axis one;
    one.name = axis.name;
    one.below = axis.below;
    one.above = axis.above;
    for (std::size_t k = 0; k + 1 < axis.knots.size(); k += step)
      one.knots.push_back(axis.knots[k]);
    one.knots.push_back(axis.knots.back());
    if (!table.visits.empty()) one.visits.resize((axis.intervals() + step - 1) / step);
    drawn.axes.push_back(std::move(one));
  }
  const bool flat = table.axes.size() <= 2 && !table.visits.empty();
  const std::size_t across = flat ? drawn.axes[0].visits.size() : 0;
  if (flat) {
    drawn.visits.resize(across * (table.axes.size() == 2 ? drawn.axes[1].visits.size() : 1));
  }
  for (std::size_t cell = 0; cell < table.visits.size(); ++cell) {
    std::size_t place = 0;
    for (std::size_t k = 0; k < table.axes.size(); ++k) {
      const results::TableCoverage::Axis& axis = table.axes[k];
      const std::size_t i = cell / axis.stride % axis.intervals() / together[k];
      drawn.axes[k].visits[i] += table.visits[cell];
      place += k == 0 ? i : i * across;
    }
    if (flat) drawn.visits[place] += table.visits[cell];
  }
  return drawn;
}

}  // namespace slipbench::driver::report
