// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace slipbench::driver::results {

/// Time spent in one regime without a break, as far as a picture can tell.
struct RegimeSpan {
  double from = 0.0;
  double to = 0.0;
  int status = 1;  ///< 0 open, 1 stick, 2 slip
  /// There were other regimes in between, each too short to be drawn.
  bool merged = false;
};

/// Collects the spans of slip and of no contact; the rest is stick. Where they get too many, spans
/// of one regime that are nearer to each other than a picture resolves become one, marked as
/// merged, so that memory does not grow with a run that chatters. A merged span says nothing about
/// the regime at one of its instants, nor how long it lasted in all.
class RegimeSpans {
 public:
  /// \param resolved parts of the time so far that a picture can tell apart
  explicit RegimeSpans(std::size_t resolved = 400) : resolved_(resolved) {}

  /// The regime from one time to another, in the order of the times.
  void add(int status, double from, double to);
  const std::vector<RegimeSpan>& spans() const { return spans_; }

 private:
  void lengthen_or_begin(const RegimeSpan& span);

  std::size_t resolved_;
  double start_ = 0.0;
  bool started_ = false;
  double gap_ = 0.0;  ///< what is not told apart
  std::vector<RegimeSpan> spans_;
};

}  // namespace slipbench::driver::results
