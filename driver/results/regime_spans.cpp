// SPDX-License-Identifier: Apache-2.0
#include "driver/results/regime_spans.hpp"

#include <algorithm>
#include <utility>

namespace slipbench::driver::results {

void RegimeSpans::lengthen_or_begin(const RegimeSpan& span) {
  for (auto before = spans_.rbegin(); before != spans_.rend() && before->to >= span.from - gap_;
       ++before) {
    if (before->status == span.status) {
      before->merged = before->merged || span.merged || span.from > before->to;
      before->to = std::max(before->to, span.to);
      return;
    }
  }
  spans_.push_back(span);
}

void RegimeSpans::add(int status, double from, double to) {
  if (!started_) start_ = from;
  started_ = true;
  if (status == 1 || !(to > from)) return;
  lengthen_or_begin({from, to, status, false});
  // With gaps of the new width there are at most `resolved_` of each regime, half of the bound.
  if (spans_.size() <= 4 * resolved_) return;
  gap_ = (to - start_) / static_cast<double>(resolved_);
  const std::vector<RegimeSpan> all = std::exchange(spans_, {});
  for (const RegimeSpan& span : all) lengthen_or_begin(span);
}

}  // namespace slipbench::driver::results
