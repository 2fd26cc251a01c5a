// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace slipbench::law {

/// Where the published page of the Radioss friction options and the program differ, one of the two
/// holds throughout.
enum class Convention : std::uint8_t {
  kDocumented,  ///< what the page promises
  kAsCoded      ///< what OpenRadioss was measured to do
};

}  // namespace slipbench::law
