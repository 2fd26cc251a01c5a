// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <thread>

#include "driver/case/case.hpp"

namespace slipbench::driver::check {

/// Reads the curves that the checks of a case compare with, in a thread of its own while the case
/// runs. Whoever needs a curve earlier waits for it; what is wrong in one is told to him.
class ReadAhead {
 public:
  explicit ReadAhead(const cases::Case& problem);

 private:
  std::jthread thread_;  ///< none if the system gives no more
};

}  // namespace slipbench::driver::check
