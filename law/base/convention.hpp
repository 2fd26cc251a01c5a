// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace slipbench::law {

/// Choice where the published page of the Radioss friction options and the program differ, one of
/// both holds throughout.
enum class Convention : std::uint8_t {
  kDocumented,  ///< what the page promises
  kAsCoded      ///< what OpenRadioss was measured to do
};

}  // namespace slipbench::law
