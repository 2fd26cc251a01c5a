// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "driver/results/regime_spans.hpp"

namespace slipbench::driver::results {

/// Returns the regime that a number of a column STATUS tells, 0 open, 1 stick, 2 slip; nothing if
/// it tells none.
std::optional<int> regime_of(double status);
/// Says of a number that tells none, and the time of its row, what is wrong.
std::string no_regime(double status, double time);

/// An instant at which a regime begins.
struct RegimeMark {
  double time = 0.0;
  int to = 1;          ///< 0 open, 1 stick, 2 slip
  bool turns = false;  ///< slip that goes on in the opposite sense
};

/// Returns whether a part of the time of a run is more than the rounding of the instants that bound
/// it: exact integration locates an instant to 1e-12 of its increment.
inline bool lasts(double part, double whole) { return part > 1e-9 * whole; }

/// Times at which one friction definition stuck, slipped and was open.
struct RegimeHistory {
  std::vector<RegimeSpan> spans;  ///< of slip and of no contact; the rest is stick
  std::vector<RegimeMark> marks;  ///< in their order; of very many, some
  bool all_marked = true;
  double slip_time = 0.0;                 ///< [T]
  double open_time = 0.0;                 ///< [T]
  std::int64_t slip_begins = 0;           ///< how often stick (or no contact) turned into slip
  std::optional<std::int64_t> reversals;  ///< slips against the sense of the slip before, if known
};

/// Collects a RegimeHistory, instant by instant; the memory does not grow with the run.
class RegimeRecorder {
 public:
  void begin(int status, double time);
  /// Another regime, or slip that turns (from slip to slip). Times do not decrease.
  void change(int to, double time);
  /// Stick between two times of slip, of which no event tells: slip that turns within an increment.
  void pause(double from, double to);
  /// Returns what there was until the end of the run. The sums are of unmerged spans.
  RegimeHistory end(double time);

 private:
  void close(double time);
  void mark(const RegimeMark& one);

  RegimeHistory history_;
  RegimeSpans spans_;
  int status_ = 1;
  double start_ = 0.0;
  double since_ = 0.0;
};

}  // namespace slipbench::driver::results
