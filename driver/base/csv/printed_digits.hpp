// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace slipbench::driver::base {

/// Fineness of the printed numbers of a column.
///
/// Programs print either a fixed number of decimals or a fixed number of significant digits, and
/// some drop the zeros at the end ("20" beside "19.99818"). Both are met by taking the most
/// significant digits that any number of the column has as those of its largest number:
///   u = 10^(e - d + 1)/2,
/// with d these digits and e the decimal exponent of the largest magnitude. That is the coarsest
/// rounding in the column where all have the same number of digits, and coarser than any where
/// round numbers have dropped theirs: 1e5 beside 0.12 gives 5000. Taken for the error of the
/// numbers has to ask them first (has_all_digits).
class PrintedDigits {
 public:
  /// \param text a number as it stands in the file: digits, a point, an exponent
  void add(std::string_view text);

  /// Half a unit of the last printed digit; nothing while all numbers are 0, or if they have the
  /// digits of a double (15 or more), where rounding is not the file's.
  std::optional<double> resolution() const;

  /// Tells that no further number can change that there is no resolution.
  bool exact() const { return digits_ >= kDigitsOfADouble; }

 private:
  static constexpr int kDigitsOfADouble = 15;

  int digits_ = 0;
  std::optional<int> exponent_;
};

}  // namespace slipbench::driver::base
