// SPDX-License-Identifier: Apache-2.0
#include "driver/results/regime_history.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace slipbench::driver::results {
namespace {

constexpr std::size_t kMostMarks = 4000;
/// Of too many marks those stay that are further apart than this part of the time so far.
constexpr double kNearestMarks = 2e-3;

}  // namespace

std::optional<int> regime_of(double status) {
  for (const int regime : {0, 1, 2}) {
    if (std::abs(status - regime) < 0.5) return regime;
  }
  return std::nullopt;
}

std::string no_regime(double status, double time) {
  return fmt::format("STATUS is {} at t = {}; it is 0 (open), 1 (stick) or 2 (slip)", status, time);
}

void RegimeRecorder::begin(int status, double time) {
  status_ = status;
  start_ = since_ = time;
}

void RegimeRecorder::close(double time) {
  spans_.add(status_, since_, time);
  if (status_ == 2) history_.slip_time += time - since_;
  if (status_ == 0) history_.open_time += time - since_;
  since_ = time;
}

void RegimeRecorder::change(int to, double time) {
  const bool turns = status_ == 2 && to == 2;
  if (!turns) close(time);
  if (to == 2 && !turns) ++history_.slip_begins;
  status_ = to;
  mark({time, to, turns});
}

void RegimeRecorder::pause(double from, double to) {
  close(from);
  spans_.add(1, from, to);
  since_ = to;
}

void RegimeRecorder::mark(const RegimeMark& one) {
  std::vector<RegimeMark>& marks = history_.marks;
  marks.push_back(one);
  if (marks.size() <= kMostMarks) return;
  history_.all_marked = false;
  const double gap = kNearestMarks * (one.time - start_);
  std::array<double, 3> last;
  last.fill(-std::numeric_limits<double>::infinity());
  std::vector<RegimeMark> fewer;
  for (const RegimeMark& candidate : marks) {
    double& before = last[static_cast<std::size_t>(candidate.to)];
    if (candidate.time - before < gap) continue;
    before = candidate.time;
    fewer.push_back(candidate);
  }
  // Fewer than half stay, unless times of a file that somebody made do not rise.
  if (2 * fewer.size() > marks.size()) {
    fewer.clear();
    for (std::size_t i = 0; i < marks.size(); i += 2) fewer.push_back(marks[i]);
  }
  marks = std::move(fewer);
}

RegimeHistory RegimeRecorder::end(double time) {
  close(time);
  history_.spans = spans_.spans();
  return std::move(history_);
}

}  // namespace slipbench::driver::results
