// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/run_suite.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

#include "driver/base/files/work_crew.hpp"

namespace slipbench::driver::suite {
namespace {

/// Puts the outcomes of a suite, which come in any order, back into that of the cases.
class InOrder {
 public:
  InOrder(std::span<const Candidate> cases, const SuiteOptions& options,
          const SuiteListener& listener)
      : cases_(cases), options_(&options), listener_(&listener), end_(cases.size()) {}

  /// Tells whether the case of that index will not be told any more.
  bool is_past_end(std::size_t index) const {
    return index >= end_.load(std::memory_order_relaxed);
  }

  void take(std::size_t index, CaseOutcome outcome) {
    const std::lock_guard lock(mutex_);
    ++work_.done;
    if (!outcome.well()) {
      ++work_.failed;
      // The cases before it go on: one of them may turn out to be the first.
      if (options_->fail_fast && index + 1 < end_) end_ = index + 1;
    }
    guarded([&] {
      waiting_.emplace(index, std::move(outcome));
      for (auto it = waiting_.begin(); it != waiting_.end() && it->first == next_ && next_ < end_;
           it = waiting_.erase(it), ++next_) {
        listener_->tell(cases_[next_], std::move(it->second));
      }
      show();
    });
  }

  /// A sign of life in the middle of a case. It is left out while another thread is printing.
  void tick() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) guarded([&] { show(); });
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void show() {
    work_.total = end_;
    if (listener_->progress) listener_->progress(work_);
  }

  template <class Talk>
  void guarded(const Talk& talk) {
    if (error_) return;
    try {
      talk();
    } catch (...) {
      error_ = std::current_exception();
      end_ = 0;
    }
  }

  std::span<const Candidate> cases_;
  const SuiteOptions* options_;
  const SuiteListener* listener_;
  std::mutex mutex_;
  std::atomic<std::size_t> end_;  ///< cases from here on are not told
  std::size_t next_ = 0;          ///< to be told
  std::map<std::size_t, CaseOutcome> waiting_;
  terminal::WorkDone work_;
  std::exception_ptr error_;
};

}  // namespace

std::vector<Reading> read_suite(std::span<const Candidate> cases, const SuiteOptions& options) {
  std::vector<Reading> readings(cases.size());
  terminal::SharedProgress progress("cases read", cases.size());
  base::for_each_index(cases.size(), options.threads, [&](std::size_t i) {
    readings[i] = read_candidate(cases[i], options.read);
    progress.done();
  });
  return readings;
}

void run_suite(std::span<const Candidate> cases, std::vector<Reading> readings,
               const SuiteOptions& options, const SuiteListener& listener) {
  InOrder order(cases, options, listener);
  base::for_each_index(cases.size(), options.threads, [&](std::size_t i) {
    if (order.is_past_end(i)) return;
    constexpr std::size_t kRowsPerTick = 1U << 14U;
    std::size_t rows = 0;
    const auto stopped = [&](std::size_t more) {
      if ((rows += more) >= kRowsPerTick) {
        order.tick();
        rows = 0;
      }
      return order.is_past_end(i);
    };
    // A reading is dropped as soon as its case is done.
    const Reading reading = readings.empty() ? read_candidate(cases[i], options.read)
                                             : std::exchange(readings[i], Reading{});
    CheckCaseOptions one{options.keep_passing, stopped, {}};
    one.strict = options.strict;
    one.threads = options.threads /
                  static_cast<unsigned>(std::min<std::size_t>(cases.size(), options.threads));
    if (options.report) {
      one.report_rows = report::most_rows(cases.size());
      one.report = [&, i](report::CaseReport&& report) { options.report(i, std::move(report)); };
    }
    auto outcome = check_case(cases[i], reading, one);
    if (outcome) order.take(i, std::move(*outcome));
  });
  order.rethrow();
}

}  // namespace slipbench::driver::suite
