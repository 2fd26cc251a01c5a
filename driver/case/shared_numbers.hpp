// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace slipbench::driver::cases {

/// A column of numbers whose copies share them until one of the copies is changed: the columns of a
/// file go into many comparisons.
class SharedNumbers {
 public:
  SharedNumbers() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): they are the same numbers
  SharedNumbers(std::vector<double> values)
      : values_(std::make_shared<std::vector<double>>(std::move(values))) {}
  SharedNumbers(std::initializer_list<double> values)
      : SharedNumbers(std::vector<double>(values)) {}

  // NOLINTNEXTLINE(google-explicit-constructor): likewise
  operator const std::vector<double>&() const { return get(); }
  const std::vector<double>& get() const {
    static const std::vector<double> kNone;
    return values_ ? *values_ : kNone;
  }
  /// The numbers of this column alone.
  std::vector<double>& change() {
    if (!values_ || values_.use_count() > 1) {
      values_ = std::make_shared<std::vector<double>>(get());
    }
    return *values_;
  }
  void push_back(double value) { change().push_back(value); }

  std::size_t size() const { return get().size(); }
  bool empty() const { return get().empty(); }
  const double* data() const { return get().data(); }
  auto begin() const { return get().begin(); }
  auto end() const { return get().end(); }
  double front() const { return get().front(); }
  double back() const { return get().back(); }
  double operator[](std::size_t i) const { return get()[i]; }
  bool operator==(const SharedNumbers& other) const { return get() == other.get(); }

 private:
  std::shared_ptr<std::vector<double>> values_;
};

}  // namespace slipbench::driver::cases
