// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "driver/export/loss.hpp"

namespace slipbench::driver::exports {

/// Numbers as text of a limited width, and the memory of what was rounded off for it.
class NumberWriter {
 public:
  /// \param width in characters, at least 12
  /// \param digits to which people want numbers rounded; 0: as many as they have
  NumberWriter(std::size_t width, int digits) : width_(width), digits_(digits) {}

  /// Returns the shortest text that reads back to the number, or where that is wider, one with as
  /// many digits as there is room for.
  std::string operator()(double number);

  std::size_t rounded() const { return rounded_; }
  /// The largest relative change of a number.
  double worst() const { return worst_; }

 private:
  std::size_t width_;
  int digits_;
  std::size_t rounded_ = 0;
  double worst_ = 0.0;
};

/// Notes how many numbers were rounded, and by how much; nothing if none was.
void tell_rounding(std::size_t rounded, double worst, std::vector<Loss>& losses);

}  // namespace slipbench::driver::exports
