// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/sweep/packed_numbers.hpp"
#include "driver/sweep/quick_resolve.hpp"
#include "driver/sweep/sweep.hpp"
#include "law/batch/pack.hpp"

namespace slipbench::driver::sweep {

/// Tells whether samples of a sweep may go through a history together, as far as that is seen
/// without an attempt: friction of one definition with law::batch_form is all that there is (no
/// masses, springs, stops or belts), and packed_number knows what is collected.
bool may_pack(const Sweep& sweep);

/// Samples of a sweep that go through one history together (docs/theory, section 11.11), in the
/// bits of a run of each. May be used by several threads at a time.
class PackedRun {
 public:
  /// As many samples go together.
  static constexpr std::size_t kMost = law::kLanes;

  /// Returns null where they cannot: besides may_pack, where the varied parameters change more than
  /// QuickResolve knows, or the history is too long to be kept.
  /// \param sweep must outlive it
  static std::unique_ptr<PackedRun> make(const Sweep& sweep);
  ~PackedRun();

  /// Runs at most kMost samples.
  /// \param values of the varied parameters, sample by sample
  /// \param[out] numbers what is collected, likewise
  /// \param[out] done whether a sample has its numbers; where not, it needs a run of its own
  void run(std::span<const double> values, std::span<double> numbers, std::span<char> done) const;

 private:
  struct Place;

  PackedRun(const Sweep& sweep, QuickResolve quick, std::vector<PackedNumber> numbers);
  bool walk_history();
  std::unique_ptr<Place> take_place() const;

  const Sweep* sweep_;
  QuickResolve quick_;
  std::vector<PackedNumber> numbers_;
  std::vector<law::ConnectorIncrement> increments_;
  std::vector<std::vector<double>> fields_;  ///< of the increments, each once while it lasts
  /// Increments of one step that follow one another, and the varied forces that act in them.
  struct Stretch {
    std::size_t count = 0;
    std::vector<std::size_t> forces;  ///< in QuickResolve::forces
  };
  std::vector<Stretch> stretches_;
  mutable std::mutex guard_;
  mutable std::vector<std::unique_ptr<Place>> free_;
};

}  // namespace slipbench::driver::sweep
