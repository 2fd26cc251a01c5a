// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace slipbench::driver::yaml {

/// A formula met while a text was read.
struct Formula {
  std::string path;
  std::string text;        ///< with its '='
  bool is_number = false;  ///< over parameters only
};

}  // namespace slipbench::driver::yaml
