// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

namespace slipbench::driver::sweep {

/// Quantiles of values that are taken one by one: counts in bins whose ends are 1 % apart (as
/// DDSketch's: Masson, Rim and Lee 2019), each with its least and most value. A quantile is off by
/// less than 1 % of itself, and exact where the values of its bin are the same; it does not depend
/// on the order of the values, nor on how they were divided. Memory grows with the decades they
/// span, not with their number.
class RunningQuantiles {
 public:
  /// Takes a value, which must not be nan.
  void add(double value);
  /// Takes all values of another one.
  void add(const RunningQuantiles& other);

  /// Returns the value at or below which a part of all values lie; nan of none.
  double at(double part) const;

  void fields(auto& archive) { archive(count_, bins_); }

 private:
  struct Bin {
    std::uint64_t count = 0;
    double least = 0.0;
    double most = 0.0;

    void fields(auto& archive) { archive(count, least, most); }
  };
  std::uint64_t count_ = 0;
  std::map<std::int32_t, Bin> bins_;  ///< in the order of their values
};

}  // namespace slipbench::driver::sweep
