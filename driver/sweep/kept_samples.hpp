// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Every n-th sample, with the least n (a power of two) that keeps at most kMost of them: a picture
/// shows no more, and which they are depends on nothing but the ids.
class KeptSamples {
 public:
  static constexpr std::size_t kMost = 1500;

  explicit KeptSamples(const Sweep& sweep) : width_(sweep.varied.size()) {}

  /// Takes a sample, in any order; those that failed have no numbers, and are kept as nan.
  void add(const SampleOutcome& outcome);
  /// Takes all samples of another one.
  void add(const KeptSamples& other);

  /// n.
  std::size_t stride() const { return stride_; }
  std::size_t size() const { return rows_.size(); }
  /// Of a sample, in the order of their ids.
  double value(std::size_t sample, std::size_t parameter) const {
    return rows_[sample].table[parameter];
  }
  double number(std::size_t sample, std::size_t number) const {
    return rows_[sample].table[width_ + number];
  }

  void fields(auto& archive) { archive(stride_, rows_); }

 private:
  struct Row {
    std::size_t id = 0;
    std::vector<double> table;  ///< values, numbers

    void fields(auto& archive) { archive(id, table); }
  };

  void insert(Row row);
  void thin();

  std::size_t width_;
  std::size_t stride_ = 1;
  std::vector<Row> rows_;
};

}  // namespace slipbench::driver::sweep
